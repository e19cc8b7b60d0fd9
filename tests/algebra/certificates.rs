//! What a reduction says is shown by multiplying out, and a certificate that was tampered with is refused.

use num_traits::{One, Zero};
use polhode::algebra::{Budget, Certificate, Monomial, Polynomial, Rational, Reduction, reduce};
use proptest::prelude::*;

fn variables<const N: usize>() -> [Polynomial; N] {
    std::array::from_fn(|v| Polynomial::variable(v as u32))
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    let monomial =
        prop::collection::btree_map(0u32..5, 1u32..3, 0..3).prop_map(Monomial::from_powers);
    let term = (monomial, (-4i64..5).prop_map(Rational::from));
    prop::collection::vec(term, 0..4).prop_map(Polynomial::from_terms)
}

const SMALL: Budget = Budget {
    terms: 2_000,
    reductions: 60,
};

proptest! {
    /// Whatever is a sum of multiples of the premises reduces to zero, or the budget says that it did not suffice.
    #[test]
    fn members_of_the_ideal_are_found(premises in prop::collection::vec(polynomial(), 1..4), factors in prop::collection::vec(polynomial(), 3)) {
        let target = premises.iter().zip(&factors).fold(Polynomial::zero(), |sum, (p, f)| sum + p.clone() * f.clone());
        match reduce(&target, &premises, SMALL) {
            Reduction::Zero(certificate) => prop_assert!(certificate.holds(&target, &premises)),
            Reduction::Contradiction(certificate) => prop_assert!(certificate.holds(&Polynomial::one(), &premises)),
            Reduction::Residue(residue) => prop_assert!(false, "left {residue:?}"),
            Reduction::OutOfBudget => {}
        }
    }

    /// What does not vanish at a common zero of the premises is never found to vanish.
    #[test]
    fn nothing_else_is_found(target in polynomial(), premises in prop::collection::vec(polynomial(), 1..4), at in prop::collection::vec(-3i64..4, 5)) {
        let value = |p: &Polynomial| p.evaluate(|v| Rational::from(at[v as usize]), Rational::clone);
        // Premises shifted by their values have the point as a common zero.
        let premises: Vec<_> = premises.iter().map(|p| p.clone() - Polynomial::constant(value(p))).collect();
        match reduce(&target, &premises, SMALL) {
            Reduction::Zero(certificate) => {
                prop_assert!(certificate.holds(&target, &premises));
                prop_assert!(value(&target).is_zero() || value(&certificate.multiplier).is_zero());
            }
            Reduction::Contradiction(_) => prop_assert!(false, "the premises have a common zero"),
            _ => {}
        }
    }

    #[test]
    fn a_tampered_certificate_is_refused(p in polynomial(), q in polynomial(), wrong in polynomial()) {
        prop_assume!(!p.is_zero() && !wrong.is_zero());
        let target = p.clone() * q.clone();
        let premises = [p];
        prop_assert!(Certificate::new(vec![q.clone()]).holds(&target, &premises));
        prop_assert!(!Certificate::new(vec![q.clone() + wrong]).holds(&target, &premises));
        let nothing = Certificate { multiplier: Polynomial::zero(), cofactors: vec![Polynomial::zero()] };
        prop_assert!(!nothing.holds(&target, &premises), "a multiplier of zero proves nothing");
        prop_assert!(!Certificate::new(vec![q, Polynomial::one()]).holds(&target, &premises));
    }

    /// dᵏ p = q (d v − n) + r with v gone from r.
    #[test]
    fn pseudo_division_multiplies_back(p in polynomial(), n in polynomial(), d in polynomial()) {
        let (n, d) = (n.coefficient_of(0, 0), d.coefficient_of(0, 0));
        let division = p.pseudo_division(0, &n, &d);
        let divisor = d.clone() * Polynomial::variable(0) - n.clone();
        prop_assert_eq!(division.multiplier * p.clone(), division.quotient * divisor + division.remainder.clone());
        prop_assert_eq!(division.remainder.degree_in(0), 0);
        prop_assert_eq!(p.substitute_fraction(0, &n, &d).0, division.remainder);
    }
}

#[test]
fn a_division_is_a_side_condition() {
    let [x, y, z] = variables();
    // From z x = z y follows x = y where z is not zero.
    let premises = [z.clone() * x.clone() - z.clone() * y.clone()];
    let target = x - y;
    let Reduction::Zero(certificate) = reduce(&target, &premises, Budget::default()) else {
        panic!("it follows where z is not zero");
    };
    assert!(certificate.holds(&target, &premises));
    assert_eq!(
        certificate.multiplier.variables(),
        [2],
        "the multiplier names z"
    );
}

#[test]
fn a_division_by_what_the_premises_make_zero_proves_nothing() {
    let [x, y, z, w] = variables();
    // z = w and z + w = 0 make z zero, so z x = z y says nothing of x and y.
    let premises = [
        z.clone() * x.clone() - z.clone() * y.clone(),
        z.clone() - w.clone(),
        z + w,
    ];
    assert!(matches!(
        reduce(&(x - y), &premises, Budget::default()),
        Reduction::Residue(_)
    ));
}

#[test]
fn a_contradiction_is_told_and_proves_nothing_else() {
    let [x, y] = variables();
    let premises = [x.clone() * y.clone() - Polynomial::one(), x.clone()];
    let Reduction::Contradiction(certificate) = reduce(&y, &premises, Budget::default()) else {
        panic!("x y = 1 and x = 0 contradict");
    };
    assert!(certificate.holds(&Polynomial::one(), &premises));
}

#[test]
fn the_circle_needs_a_basis() {
    let [s, c] = variables();
    let square = |p: &Polynomial| p.clone() * p.clone();
    let premises = [square(&s) + square(&c) - Polynomial::one()];
    // s⁴ − c⁴ = s² − c² on the circle.
    let target = square(&square(&s)) - square(&square(&c)) - square(&s) + square(&c);
    assert!(
        matches!(reduce(&target, &premises, Budget::default()), Reduction::Zero(c) if c.holds(&target, &premises))
    );
}

#[test]
fn a_small_budget_is_an_answer() {
    let [x, y, z] = variables();
    let square = |p: Polynomial| p.clone() * p;
    let premises = [
        square(x.clone()) + y.clone() * z.clone(),
        square(y.clone()) + z.clone() * x.clone(),
    ];
    let budget = Budget {
        terms: 100,
        reductions: 1,
    };
    assert_eq!(
        reduce(&square(square(x)), &premises, budget),
        Reduction::OutOfBudget
    );
}
