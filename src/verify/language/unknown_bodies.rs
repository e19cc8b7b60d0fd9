//! Quantities of bodies of which nothing else is known.

use super::heads::{ANGULAR_MOMENTUM, MOMENTUM};
use super::statement::{Declaration, Slot, Statement, Term};
use super::terms::leave_out;

/// What a body has that may be any vector as long as nothing is said of the body.
const ANY_VECTOR: [&str; 2] = [MOMENTUM, ANGULAR_MOMENTUM];

/// "`$h$` is a vector fixed in A, the angular momentum of the rotor relative to A", where no other sentence speaks of the
/// rotor: any vector may be that, and the sentence says nothing more of h.
pub(crate) fn leave_unknown_bodies(declarations: &mut Vec<Declaration>) {
    let said = 0..declarations.len();
    let idle: Vec<usize> = said.filter(|at| says_nothing(*at, declarations)).collect();
    leave_out(declarations, &idle);
}

fn says_nothing(at: usize, declarations: &[Declaration]) -> bool {
    let Statement::Is { subjects, what } = &declarations[at].statement else {
        return false;
    };
    let ([Term::Formula(letter)], true) = (subjects.as_slice(), ANY_VECTOR.contains(&what.head))
    else {
        return false;
    };
    let bodies: Vec<&Term> = what.all(Slot::Of).collect();
    let ([body @ Term::Name(_)], None) = (bodies.as_slice(), what.slot(Slot::Along)) else {
        return false;
    };
    let mut others = declarations.iter().enumerate().filter(|(n, _)| *n != at);
    let vector = others.clone().any(|(_, d)| match &d.statement {
        Statement::Is { subjects, what } => {
            let own = |s: &Term| matches!(s, Term::Formula(own) if own.source == letter.source);
            what.head == "vector" && d.extent == declarations[at].extent && subjects.iter().any(own)
        }
        _ => false,
    });
    vector && others.all(|(_, d)| !d.statement.terms().contains(body))
}
