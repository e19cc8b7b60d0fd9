//! Things of which a quantity is told together: "the kinetic energy of the rod and the disc" is that of a body of which both
//! are parts.

use super::heads::{
    ANGULAR_MOMENTUM, INERTIA_TENSOR, KINETIC_ENERGY, MASS, MOMENT_OF_INERTIA, MOMENTUM,
    POTENTIAL_ENERGY, TOTAL_ENERGY,
};
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Quantities of a whole that are the sums of those of its parts, and its mass centre.
const OF_WHOLES: [&str; 10] = [
    ANGULAR_MOMENTUM,
    INERTIA_TENSOR,
    KINETIC_ENERGY,
    MASS,
    MOMENT_OF_INERTIA,
    MOMENTUM,
    POTENTIAL_ENERGY,
    TOTAL_ENERGY,
    "Lagrangian",
    "mass centre",
];

/// Names the bodies of which sentences speak together.
pub(crate) fn join_together(declarations: &mut Vec<Declaration>) {
    let mut joined: Vec<Declaration> = vec![];
    for declaration in declarations.iter_mut() {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        // "the mass of P and of Q" may be that of each.
        let of_each = what.head == MASS && !what.is("total");
        if subjects.len() != 1 || !OF_WHOLES.contains(&what.head) || of_each {
            continue;
        }
        let Some((whole, parts)) = told_together(what) else {
            continue;
        };
        let consists = Statement::Does {
            subjects: vec![whole],
            verb: "consist",
            slots: parts,
        };
        if joined.iter().all(|known| known.statement != consists) {
            joined.push(declaration.saying(consists));
        }
    }
    declarations.extend(joined);
}

/// Puts the whole in the place of its parts, and gives both.
fn told_together(what: &mut NounPhrase) -> Option<(Term, Vec<(Slot, Term)>)> {
    let parts: Vec<(Slot, Term)> = what
        .slots
        .iter()
        .filter(|(slot, _)| *slot == Slot::Of)
        .cloned()
        .collect();
    let names: Option<Vec<String>> = parts.iter().map(|(_, part)| part_name(part)).collect();
    let names = names.filter(|names| names.len() > 1)?;
    let whole = Term::Name(names.join(" and "));
    what.slots.retain(|(slot, _)| *slot != Slot::Of);
    what.slots.insert(0, (Slot::Of, whole.clone()));
    Some((whole, parts))
}

/// A thing, and no letter for a quantity.
fn part_name(part: &Term) -> Option<String> {
    match part {
        Term::Name(_) => name(part),
        Term::Phrase(phrase) if super::is_body(phrase.head) && phrase.slots.is_empty() => {
            Some(phrase.head.to_owned())
        }
        _ => None,
    }
}
