//! A proof that anyone can re-check.

/// Premises and cofactors: multiplier · (left − right) = Σ cofactor · premise, for each component.
#[derive(Clone, Debug)]
pub struct Proof {
    components: Vec<String>,
}
