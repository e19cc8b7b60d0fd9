//! What rolls inside or outside of something round: how far its centre is from the one of that, where sentences speak of the line
//! between them and none tells it.

use super::heads::MASS_CENTRE;
use super::planar_axes::tells_distance;
use super::reader::formula;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::told_sizes::told_size;
use crate::notation::Macros;

/// What a surface is called on which something is inside, or outside.
const INNER: [&str; 3] = ["internal", "inner", "inside"];
const OUTER: [&str; 3] = ["external", "outer", "outside"];

/// Something round that rolls on something round.
struct Roller<'d> {
    body: &'d Term,
    on: &'d Term,
    inside: bool,
    declaration: &'d Declaration,
}

/// Tells the distance of the centres: the difference of the radii inside, their sum outside.
pub(super) fn tell_distances_of_rollers(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let told: Vec<Declaration> = declarations
        .iter()
        .filter_map(roller)
        .filter_map(|roller| {
            let distance = distance(&roller, declarations, macros)?;
            Some(roller.declaration.saying(distance))
        })
        .collect();
    declarations.extend(told);
}

fn roller(declaration: &Declaration) -> Option<Roller<'_>> {
    let (body, on, inside) = roller_on(&declaration.statement)?;
    let (_, slots) = declaration.statement.does("roll")?;
    let side = slots.iter().any(|(slot, on)| match on {
        Term::Phrase(side) => side.head == "surface",
        _ => *slot == Slot::In,
    });
    (side && declaration.extent == Extent::Document).then_some(Roller {
        body,
        on,
        inside,
        declaration,
    })
}

/// What rolls, on what, and whether inside of that.
pub(super) fn roller_on(statement: &Statement) -> Option<(&Term, &Term, bool)> {
    let ([body], slots) = statement.does("roll")? else {
        return None;
    };
    let on = slots
        .iter()
        .find(|(slot, _)| matches!(slot, Slot::On | Slot::In))?;
    let (on, inside) = match on {
        (Slot::In, on @ Term::Name(_)) => (on, true),
        (_, Term::Phrase(side)) if side.head == "surface" => {
            let inside = INNER.iter().any(|said| side.is(said));
            let outside = OUTER.iter().any(|said| side.is(said));
            (side.slot(Slot::Of).filter(|_| inside != outside)?, inside)
        }
        (Slot::On, on @ Term::Name(_)) => (on, false),
        _ => return None,
    };
    Some((body, on, inside))
}

fn distance(
    roller: &Roller<'_>,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<Statement> {
    let centre = centre(roller.body, declarations)?;
    let middle = middle(roller.on, declarations)?;
    let ends = [centre, middle];
    let told = declarations.iter().any(|d| {
        let told = tells_distance(&d.statement);
        told.is_some_and(|(one, other, _)| ends.contains(&one) && ends.contains(&other))
    });
    let mut terms = declarations.iter().flat_map(|d| d.statement.terms());
    if told || !terms.any(|term| speaks_of_line(term, &ends)) {
        return None;
    }
    let (own, other) = (
        told_size("radius", roller.body, declarations)?,
        told_size("radius", roller.on, declarations)?,
    );
    let sign = if roller.inside { "-" } else { "+" };
    let written = format!("{}{sign}{}", other.source, own.source);
    let letter = Term::Formula(formula(&written, false, macros)?);
    let slots = vec![
        (Slot::Of, centre.clone()),
        (Slot::RelativeTo, middle.clone()),
    ];
    Some(Statement::one_is(
        letter,
        NounPhrase::new("distance", slots),
    ))
}

/// "the line from A to C", in either direction.
fn speaks_of_line(term: &Term, ends: &[&Term; 2]) -> bool {
    let Term::Phrase(phrase) = term else {
        return false;
    };
    let [from, to] = [Slot::From, Slot::To].map(|slot| phrase.slot(slot));
    let line = from
        .zip(to)
        .is_some_and(|(from, to)| from != to && ends.contains(&from) && ends.contains(&to));
    line || phrase
        .slots
        .iter()
        .any(|(_, inner)| speaks_of_line(inner, ends))
}

/// The centre of what rolls.
fn centre<'d>(body: &Term, declarations: &'d [Declaration]) -> Option<&'d Term> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if matches!(what.head, "centre" | MASS_CENTRE) => {
            let own = what.slot(Slot::Of) == Some(body) && what.slots.len() == 1;
            own.then(|| subjects.first()).flatten()
        }
        _ => None,
    })
}

/// The centre of what it rolls on, or the point of its axis in the plane.
fn middle<'d>(surface: &Term, declarations: &'d [Declaration]) -> Option<&'d Term> {
    let axis = |term: &Term| match term {
        Term::Phrase(axis) => axis.head == "axis" && axis.slot(Slot::Of) == Some(surface),
        _ => false,
    };
    let through = declarations.iter().find_map(|d| match &d.statement {
        Statement::Does {
            subjects,
            verb: "pass",
            slots,
        } if subjects.iter().all(axis) => slot(slots, Slot::Through),
        _ => None,
    });
    through.or_else(|| centre(surface, declarations))
}
