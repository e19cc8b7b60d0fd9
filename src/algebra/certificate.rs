//! The checker of proofs: it multiplies out, and does nothing else.

use crate::algebra::Polynomial;
use num_traits::Zero;

/// The proof that a difference vanishes wherever its premises do:
/// multiplier · difference = Σ cofactorᵢ · premiseᵢ.
///
/// The multiplier stands for what was divided by; where it vanishes nothing is proved, so it is a side condition.
///
/// ```
/// use polhode::algebra::{Certificate, Polynomial};
/// let [x, y] = [0, 1].map(Polynomial::variable);
/// // x² − y² vanishes wherever x − y does.
/// let difference = x.clone() * x.clone() - y.clone() * y.clone();
/// let proof = Certificate::new(vec![x.clone() + y.clone()]);
/// assert!(proof.holds(&difference, &[x.clone() - y.clone()]));
/// assert!(!proof.holds(&difference, &[x]));
/// ```
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Certificate {
    /// What the difference is multiplied by; not zero.
    pub multiplier: Polynomial,
    /// One cofactor for each premise, in the order of the premises.
    pub cofactors: Vec<Polynomial>,
}

impl Certificate {
    /// A certificate without divisions.
    pub fn new(cofactors: Vec<Polynomial>) -> Self {
        let multiplier = num_traits::One::one();
        Self {
            multiplier,
            cofactors,
        }
    }

    /// Whether the two sides are the same polynomial.
    pub fn holds(&self, difference: &Polynomial, premises: &[Polynomial]) -> bool {
        if self.multiplier.is_zero() || self.cofactors.len() != premises.len() {
            return false;
        }
        let mut left = self.multiplier.clone() * difference.clone();
        for (cofactor, premise) in self.cofactors.iter().zip(premises) {
            left -= cofactor.clone() * premise.clone();
        }
        left.is_zero()
    }
}
