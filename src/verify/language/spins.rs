//! Bodies that turn about their axes of symmetry, where a sentence says in what the axis is fixed and none how the body turns.

use super::heads::{EULER_ANGLES, UNIT_VECTOR};
use super::kinds::name;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};

/// The noun of where the mass of a thing is in the mean.
const MASS_CENTRE: &str = "mass centre";

/// "The axis of the disc passes through O", where n is the unit vector from there to its mass centre: the disc is symmetric
/// about n.
fn tell_axes_through_points(declarations: &mut [Declaration]) {
    let told: Vec<Option<Statement>> = declarations
        .iter()
        .map(|declaration| axis_through(declaration, declarations))
        .collect();
    for (declaration, statement) in declarations.iter_mut().zip(told) {
        if let Some(statement) = statement {
            declaration.statement = statement;
        }
    }
}

fn axis_through(declaration: &Declaration, all: &[Declaration]) -> Option<Statement> {
    let (subjects, slots) = declaration.statement.does("pass")?;
    let ([Term::Phrase(axis)], [(Slot::Through, point)]) = (subjects, slots) else {
        return None;
    };
    let ([(Slot::Of, body)], "axis" | "symmetry axis") = (axis.slots.as_slice(), axis.head) else {
        return None;
    };
    let is = |d: &Declaration, holds: &dyn Fn(&[Term], &NounPhrase) -> bool| match &d.statement {
        Statement::Is { subjects, what } => d.extent == Extent::Document && holds(subjects, what),
        _ => false,
    };
    let centres = all.iter().filter(|d| {
        is(d, &|_, what| {
            what.head == MASS_CENTRE && what.slot(Slot::Of) == Some(body)
        })
    });
    let centres: Vec<&Term> = centres.flat_map(|d| d.statement.subjects()).collect();
    let between = |what: &NounPhrase| match (what.slot(Slot::From), what.slot(Slot::To)) {
        (Some(from), Some(to)) => {
            from == point && centres.contains(&to) || to == point && centres.contains(&from)
        }
        _ => false,
    };
    let way = |d: &&Declaration| is(d, &|_, what| what.head == UNIT_VECTOR && between(what));
    let unit = all.iter().find(way)?.statement.subjects().first()?;
    let about = vec![(Slot::About, unit.clone())];
    Some(Statement::one_is(
        body.clone(),
        NounPhrase::new("symmetric", about),
    ))
}

/// "`$n$` is fixed in A. The disc is symmetric about `$n$`": the disc turns relative to A about n.
pub(crate) fn turn_about_axes_of_symmetry(declarations: &mut Vec<Declaration>) {
    tell_axes_through_points(declarations);
    let spins: Vec<Declaration> = declarations
        .iter()
        .filter_map(|declaration| spin(declaration, declarations))
        .collect();
    declarations.extend(spins);
}

fn spin(declaration: &Declaration, all: &[Declaration]) -> Option<Declaration> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let ([body], "symmetric", Extent::Document) =
        (subjects.as_slice(), what.head, &declaration.extent)
    else {
        return None;
    };
    let axis = what.slot(Slot::About)?;
    let own: Vec<&Term> = all.iter().flat_map(|d| frames_of(body, d)).collect();
    let of_body = |term: &Term| term == body || own.contains(&term);
    let carrier = all.iter().find_map(|d| fixed_in(axis, d))?;
    let turned = |d: &Declaration| tells_turn(d, &of_body);
    if of_body(carrier) || name(carrier).is_none() || all.iter().any(turned) {
        return None;
    }
    Some(declaration.saying(Statement::Does {
        subjects: vec![body.clone()],
        verb: "turn",
        slots: vec![
            (Slot::RelativeTo, carrier.clone()),
            (Slot::About, axis.clone()),
        ],
    }))
}

/// "B is a frame fixed in the body"
fn frames_of<'d>(body: &Term, declaration: &'d Declaration) -> Vec<&'d Term> {
    match &declaration.statement {
        Statement::Is { subjects, what }
            if what.head == "frame" && what.all(Slot::FixedIn).any(|of| of == body) =>
        {
            subjects.iter().collect()
        }
        _ => vec![],
    }
}

/// In what a sentence says that a unit vector is fixed.
fn fixed_in<'d>(axis: &Term, declaration: &'d Declaration) -> Option<&'d Term> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let vector = matches!(what.head, "unit vector" | "fixed");
    let own = vector && declaration.extent == Extent::Document && subjects.contains(axis);
    what.slot(Slot::FixedIn).filter(|_| own)
}

/// Whether a sentence tells how something turns.
fn tells_turn(declaration: &Declaration, own: &impl Fn(&Term) -> bool) -> bool {
    let turns = |what: &NounPhrase| {
        what.head == "frame" && what.slot(Slot::RelativeTo).is_some()
            || what.head == "fixed" && what.slot(Slot::FixedIn).is_some()
    };
    match &declaration.statement {
        Statement::Does {
            subjects,
            verb: "turn" | "take",
            ..
        } => subjects.iter().any(own),
        Statement::Is { subjects, what } => {
            let angles = what.head == EULER_ANGLES && what.all(Slot::Of).any(own);
            angles || turns(what) && subjects.iter().any(own)
        }
        _ => false,
    }
}
