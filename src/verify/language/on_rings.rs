//! What moves along a ring that stands upright: it stays at the radius from the centre of the ring, in its plane.

use super::heads::CONSTANT;
use super::on_lines::{has_other_loads, leave_manner, no_force_along, slides_smoothly, sliding};
use super::planar_axes::{TOWARDS, axis};
use super::planar_lines::way_name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// The noun of a ring, and the name of one that has no other.
const RING: &str = "ring";

/// A ring that nothing is said of but where it is.
struct Ring {
    name: Term,
    radius: Term,
    centre: Term,
    /// The frame with which it turns.
    base: Option<Term>,
    bead: Term,
}

/// "The bead moves along the hoop": where it is is told by the angle of the line from the centre.
pub(crate) fn place_on_rings(declarations: &mut Vec<Declaration>) {
    let Some((at, ring)) = ring(declarations) else {
        return;
    };
    let said = declarations[at].clone();
    let smooth =
        slides_smoothly(&ring.bead, declarations) && !has_other_loads(&ring.name, declarations);
    leave_manner(&ring.bead, declarations);
    declarations.retain(|d| !tells_of_ring(&d.statement, &ring));
    for term in declarations
        .iter_mut()
        .flat_map(|d| d.statement.terms_mut())
    {
        name_centre(term, &ring);
    }
    let mut told = statements(&ring);
    // "A particle of mass `$m$` slides on a hoop"
    if let Some(([Term::Phrase(thing)], _)) = said.statement.does("slide") {
        told.push(Statement::one_is(ring.bead.clone(), (**thing).clone()));
    }
    if let Some(way) = way_name(&ring.centre, &ring.bead)
        && smooth
    {
        told.push(no_force_along(&ring.bead, axis(TOWARDS, Some(&way))));
    }
    declarations.extend(told.into_iter().map(|statement| said.saying(statement)));
}

/// The ring along which something moves, and which sentence says so.
fn ring(declarations: &[Declaration]) -> Option<(usize, Ring)> {
    let mut all = declarations.iter().enumerate();
    let (at, (bead, ring)) = all.find_map(|(at, d)| {
        let round = |slot, name: &str| matches!(slot, Slot::Along | Slot::On) && name == RING;
        Some((at, sliding(&d.statement, round)?))
    })?;
    let what = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == RING && subjects.contains(&ring) => {
            Some(what)
        }
        _ => None,
    })?;
    let radius = what.size("radius")?;
    let turns = declarations.iter().any(|d| {
        let turn = d.statement.does("turn");
        turn.is_some_and(|(subjects, _)| subjects.contains(&ring))
    });
    if !(is_upright(&ring, declarations) || turns || what.is("vertical")) {
        return None;
    }
    let base = what.slot(Slot::FixedIn).cloned();
    let base = base.or_else(|| turns.then(|| ring.clone()));
    let unnamed = || Term::Name("centre of the ring".to_owned());
    Some((
        at,
        Ring {
            radius: radius.clone(),
            centre: centre(declarations).unwrap_or_else(unnamed),
            name: ring,
            base,
            bead: match bead {
                Term::Phrase(thing) => Term::Name(thing.head.to_owned()),
                bead => bead,
            },
        },
    ))
}

/// The centre of the ring, if it has a name.
fn centre(declarations: &[Declaration]) -> Option<Term> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Premise(centre) if centre.head == "centre" => centre.slot(Slot::Which).cloned(),
        Statement::Is { subjects, what } if what.head == "centre" => subjects.first().cloned(),
        _ => None,
    })
}

/// "The plane of the hoop is vertical."
fn is_upright(ring: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is {
            subjects,
            what: said,
        } => match subjects.as_slice() {
            [Term::Phrase(plane)] => said.head == "vertical" && plane.slot(Slot::Of) == Some(ring),
            _ => false,
        },
        _ => false,
    })
}

/// Whether a statement says only what the ring is, and that something moves along it.
fn tells_of_ring(statement: &Statement, ring: &Ring) -> bool {
    let of_ring = |what: &NounPhrase| what.slot(Slot::Of) == Some(&ring.name);
    match statement {
        Statement::Is { subjects, what } => match subjects.as_slice() {
            [Term::Phrase(plane)] => plane.head == "plane" && of_ring(plane),
            [subject] if *subject == ring.name => what.head == RING || of_ring(what),
            _ => what.head == "centre" && of_ring(what),
        },
        Statement::Premise(centre) => centre.head == "centre" && of_ring(centre),
        Statement::Does {
            verb: "slide" | "move",
            slots,
            ..
        } => slots.iter().any(|(_, term)| *term == ring.name),
        _ => false,
    }
}

/// "the centre of the hoop"
fn name_centre(term: &mut Term, ring: &Ring) {
    let Term::Phrase(phrase) = term else { return };
    if phrase.head == "centre" && phrase.slot(Slot::Of) == Some(&ring.name) {
        term.clone_from(&ring.centre);
        return;
    }
    for (_, inner) in &mut phrase.slots {
        name_centre(inner, ring);
    }
}

/// Where the ring is, and what moves along it.
fn statements(ring: &Ring) -> Vec<Statement> {
    let mut fixed = NounPhrase::new("point", vec![]);
    fixed.adjectives.push("fixed");
    if let Some(base) = &ring.base {
        fixed.slots.push((Slot::FixedIn, base.clone()));
    }
    let apart = vec![
        (Slot::Of, ring.bead.clone()),
        (Slot::RelativeTo, ring.centre.clone()),
    ];
    let base = ring.base.iter().map(|base| (Slot::FixedIn, base.clone()));
    let mut plane = NounPhrase::new("plane", base.collect());
    plane.adjectives.push("vertical");
    let mut said = vec![
        Statement::one_is(ring.centre.clone(), fixed),
        Statement::one_is(ring.radius.clone(), NounPhrase::new("distance", apart)),
        Statement::one_is(ring.radius.clone(), NounPhrase::new(CONSTANT, vec![])),
        Statement::Does {
            subjects: vec![ring.bead.clone()],
            verb: "move",
            slots: vec![(Slot::In, Term::Phrase(Box::new(plane)))],
        },
    ];
    if ring.base.as_ref() == Some(&ring.name) {
        let frame = NounPhrase::new("frame", vec![]);
        said.push(Statement::one_is(ring.name.clone(), frame));
    }
    said
}
