//! Radii of gyration: the mass times the square of one is the moment of inertia.

use super::heads::{CONSTANT, MASS, MOMENT_OF_INERTIA};
use super::reader::rows;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;

/// "`$k$` is the radius of gyration of the body of mass `$m$` about the axis": `$m k^2$` is its moment of inertia about that.
pub(crate) fn tell_gyration(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let mut told = vec![];
    for declaration in declarations.iter() {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let ([Term::Formula(radius)], Some(body), "radius of gyration") =
            (subjects.as_slice(), what.slot(Slot::Of), what.head)
        else {
            continue;
        };
        let mass = declarations
            .iter()
            .find_map(|d| mass_of(body, &d.statement));
        let Some(said) = mass.and_then(|mass| moment(radius, mass, what, macros)) else {
            continue;
        };
        told.push((declaration.clone(), said));
    }
    for (said, moment) in told {
        for declaration in declarations.iter_mut().filter(|d| **d == said) {
            if let Statement::Is { what, .. } = &mut declaration.statement {
                *what = NounPhrase::new(CONSTANT, vec![]);
            }
        }
        declarations.extend(moment.map(|statement| said.saying(statement)));
    }
}

/// A letter of its own is the moment of inertia, and the mass times the square of the radius.
fn moment(
    radius: &Formula,
    mass: &Formula,
    what: &NounPhrase,
    macros: &Macros,
) -> Option<[Statement; 2]> {
    let read = |source: String| {
        let row = rows(&source, false, macros).into_iter().next()?;
        Some(Formula { source, row })
    };
    let letter = format!("J_{{gyration,{}}}", radius.source);
    let square = format!("{letter}={{{}}}{{{}}}^2", mass.source, radius.source);
    let what = NounPhrase {
        head: MOMENT_OF_INERTIA,
        ..what.clone()
    };
    let is = Statement::one_is(Term::Formula(read(letter)?), what);
    Some([is, Statement::Holds(read(square)?)])
}

/// The letter that a sentence tells for the mass of a body.
fn mass_of<'d>(body: &Term, statement: &'d Statement) -> Option<&'d Formula> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let letter = match what.head {
        MASS if what.slot(Slot::Of) == Some(body) => subjects.first(),
        _ if subjects.contains(body) => what.all(Slot::Of).find_map(|of| match of {
            Term::Phrase(size) if size.head == MASS => size.slot(Slot::Which),
            _ => None,
        }),
        _ => None,
    };
    match letter {
        Some(Term::Formula(letter)) => Some(letter),
        _ => None,
    }
}
