//! For which of its variables an equation is solved.

use crate::algebra::{Polynomial, Variable};
use crate::verify::facts::squares::is_kernel;
use crate::verify::model::atoms::Atoms;
use num_traits::Zero;

/// The variable that an equation is best solved for: alone rather than with a factor, the highest rate, none that is small,
/// the youngest. What is a number, such as π, no equation tells.
pub(super) fn best(
    atoms: &Atoms,
    value: &Polynomial,
    plainly: bool,
) -> Option<(Variable, Polynomial, Polynomial)> {
    let candidates = value.variables().into_iter().filter_map(|v| {
        if value.degree_in(v) != 1 || is_kernel(atoms, v) || atoms.known_pi() == Some(v) {
            return None;
        }
        let slope = value.coefficient_of(v, 1);
        let atom = atoms.atom(v);
        let alone = slope.is_constant().is_some();
        if plainly && !alone {
            return None;
        }
        // What may vanish is divided by only where nothing else is left.
        let sure = atom.key.order == 0 && atoms.has_sign(&slope);
        let rank = (
            (alone, !atom.positive, atom.key.order),
            (sure, !atoms.is_small(v)),
            v,
        );
        Some((rank, slope))
    });
    let ((.., variable), slope) = candidates.max_by_key(|(rank, _)| *rank)?;
    let rest = value.coefficient_of(variable, 0);
    // A product that vanishes does not say which of its factors does, unless only one can.
    let may_vanish = slope.is_constant().is_none() && !atoms.has_sign(&slope);
    if rest.is_zero() && may_vanish && !is_of_constant_square(atoms, variable, &slope) {
        return None;
    }
    Some((variable, slope, rest))
}

/// Whether what stands beside a rate that it makes vanish, v in v·v̇ = 0, is what has the rate: v² is constant, and so is v.
fn is_of_constant_square(atoms: &Atoms, rate: Variable, slope: &Polynomial) -> bool {
    atoms.atom(rate).rate_of.is_some_and(|own| {
        let beside = slope.coefficient_of(own, 1);
        slope.degree_in(own) == 1
            && slope.coefficient_of(own, 0).is_zero()
            && atoms.has_sign(&beside)
    })
}
