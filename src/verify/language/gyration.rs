//! Radii of gyration: the mass times the square of one is the moment of inertia.

use super::clause::as_formula;
use super::every_axis::tell_round_moments;
use super::heads::{CONSTANT, MASS, MOMENT_OF_INERTIA};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use crate::notation::Macros;

/// "`$k$` is the radius of gyration of the body of mass `$m$` about the axis": `$m k^2$` is its moment of inertia about that.
pub(crate) fn tell_gyration(declarations: &mut Vec<Declaration>, macros: &Macros) {
    tell_round_moments(declarations);
    let masses: Vec<(Term, Formula)> = declarations.iter().flat_map(masses).collect();
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let ([Term::Formula(radius)], Some(body), "radius of gyration") =
            (subjects.as_slice(), what.slot(Slot::Of), what.head)
        else {
            return vec![];
        };
        let mass = masses.iter().find(|(of, _)| of == body);
        let Some(told) = mass.and_then(|(_, mass)| moment(radius, mass, what, macros)) else {
            return vec![];
        };
        *what = NounPhrase::new(CONSTANT, vec![]);
        told.into()
    });
}

/// A letter of its own is the moment of inertia, and the mass times the square of the radius.
fn moment(
    radius: &Formula,
    mass: &Formula,
    what: &NounPhrase,
    macros: &Macros,
) -> Option<[Statement; 2]> {
    let letter = format!("J_{{gyration,{}}}", radius.source);
    let square = format!("{letter}={{{}}}{{{}}}^2", mass.source, radius.source);
    let what = NounPhrase {
        head: MOMENT_OF_INERTIA,
        ..what.clone()
    };
    let is = Statement::one_is(Term::Formula(formula(&letter, false, macros)?), what);
    Some([is, Statement::Holds(formula(&square, false, macros)?)])
}

/// The bodies of which a sentence tells the letter of their mass.
fn masses(declaration: &Declaration) -> Vec<(Term, Formula)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return vec![];
    };
    let (bodies, letter): (Vec<&Term>, _) = match what.head {
        MASS => (what.all(Slot::Of).take(1).collect(), subjects.first()),
        _ => (subjects.iter().collect(), what.size(MASS)),
    };
    let letter = letter.and_then(as_formula);
    let own = |body: &Term| Some((body.clone(), letter.clone()?));
    bodies.into_iter().filter_map(own).collect()
}
