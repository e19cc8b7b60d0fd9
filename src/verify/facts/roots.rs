//! Lengths that are told by their squares, where these are the squares of what is not negative.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::facts::proof::{Prover, Reduced};
use crate::verify::facts::squares::square_in;
use crate::verify::model::atoms::Atoms;
use num_traits::Zero;

impl Facts {
    /// The length that an equation tells: ℓ² = q, where q is the square of what is not negative.
    pub(super) fn length_in(atoms: &Atoms, value: &Polynomial) -> Option<(Variable, Fraction)> {
        let mut lengths = value.variables().into_iter();
        lengths.find_map(|length| {
            let square = square_in(value, length).filter(|_| atoms.is_length(length))?;
            let root = atoms.known_root(&square)?;
            // The sine of an angle that changes has either sign.
            if !atoms.has_steady_sines(&root) {
                return None;
            }
            let own = root.variables().contains(&length);
            (!own).then_some((length, root))
        })
    }
}

impl Prover<'_> {
    /// The factor of an equation d²·ℓ² − n² beside d·ℓ − n, where squares of what stands in n are written otherwise.
    pub(super) fn other_root(
        &mut self,
        reduced: &mut Reduced,
        solved: &Polynomial,
        before: usize,
    ) -> Option<Polynomial> {
        let length = solved.variables().into_iter().find(|&v| {
            self.atoms.is_length(v) && solved.degree_in(v) == 1 && reduced.value.degree_in(v) == 2
        })?;
        let slope = solved.coefficient_of(length, 1);
        let other = solved.clone() - solved.coefficient_of(length, 0).scaled(&Rational::from(2));
        let square = reduced.value.coefficient_of(length, 2);
        let both = slope.clone() * slope;
        reduced.scale(&both);
        let factor = other * square;
        let product = factor.clone() * solved.clone();
        let mut rest = Reduced::of(reduced.value.clone() * both - product.clone());
        self.lower_squares(&mut rest, before)?;
        if !rest.value.is_zero() {
            return None;
        }
        for (fact, cofactor) in rest.cofactors {
            reduced.add(fact, cofactor);
        }
        reduced.value = product;
        Some(factor)
    }
}
