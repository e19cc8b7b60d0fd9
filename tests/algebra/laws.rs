//! Polynomials, fractions and their coefficients keep the laws of arithmetic, also past the edges of their packed forms.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::{One, Zero};
use polhode::algebra::{Fraction, Monomial, Polynomial, Rational};
use proptest::prelude::*;

/// Small and large variables, so that packed and sparse monomials meet.
fn monomial() -> impl Strategy<Value = Monomial> {
    let power = (
        prop_oneof![0u32..4, 13u32..18],
        prop_oneof![1u32..3, 60u32..70],
    );
    prop::collection::btree_map(
        power.clone().prop_map(|p| p.0),
        power.prop_map(|p| p.1),
        0..4,
    )
    .prop_map(Monomial::from_powers)
}

fn rational() -> impl Strategy<Value = Rational> {
    let near = -9i64..10;
    let far = prop_oneof![Just(i64::MAX), Just(i64::MIN), Just(i64::MAX - 1)];
    (prop_oneof![near, far], 1i64..7).prop_map(Rational::from)
}

fn polynomial() -> impl Strategy<Value = Polynomial> {
    prop::collection::vec((monomial(), rational()), 0..5).prop_map(Polynomial::from_terms)
}

proptest! {
    #[test]
    fn rationals_agree_with_big_ones(a in rational(), b in rational()) {
        prop_assert_eq!((a.clone() + b.clone()).to_big(), a.to_big() + b.to_big());
        prop_assert_eq!((a.clone() * b.clone()).to_big(), a.to_big() * b.to_big());
        prop_assert_eq!((a.clone() - b.clone()).to_big(), a.to_big() - b.to_big());
        prop_assert_eq!(a.cmp(&b), a.to_big().cmp(&b.to_big()));
        if !b.is_zero() {
            prop_assert_eq!((a.clone() / b.clone()).to_big(), a.to_big() / b.to_big());
        }
    }

    #[test]
    fn monomials_multiply_divide_and_keep_their_order(a in monomial(), b in monomial(), c in monomial()) {
        let product = a.times(&b);
        prop_assert_eq!(product.quotient(&b), Some(a.clone()));
        prop_assert_eq!(product.degree(), a.degree() + b.degree());
        prop_assert_eq!(a.cmp(&b), a.times(&c).cmp(&b.times(&c)));
        prop_assert_eq!(a.gcd(&b).times(&a.lcm(&b)), product);
    }

    #[test]
    fn polynomials_are_a_ring(p in polynomial(), q in polynomial(), r in polynomial()) {
        let (p, q, r) = (|| p.clone(), || q.clone(), || r.clone());
        prop_assert_eq!((p() + q()) * r(), p() * r() + q() * r());
        prop_assert_eq!((p() * q()) * r(), p() * (q() * r()));
        prop_assert_eq!(p() * q(), q() * p());
        prop_assert!((p() - p()).is_zero());
        prop_assert_eq!(p() * Polynomial::one(), p());
    }

    #[test]
    fn a_product_divided_by_a_factor_is_the_other(p in polynomial(), q in polynomial()) {
        prop_assume!(!q.is_zero());
        prop_assert_eq!((p.clone() * q.clone()).exact_quotient(&q), Some(p));
    }

    #[test]
    fn the_value_of_a_product_is_the_product_of_the_values(p in polynomial(), q in polynomial(), x in -5i64..6, y in -5i64..6) {
        let at = |v: u32| BigRational::from(BigInt::from(if v.is_multiple_of(2) { x } else { y }));
        let value = |p: &Polynomial| p.evaluate(at, Rational::to_big);
        prop_assert_eq!(value(&(p.clone() * q.clone())), value(&p) * value(&q));
    }

    #[test]
    fn fractions_are_a_field(p in polynomial(), q in polynomial(), r in polynomial()) {
        prop_assume!(!q.is_zero() && !r.is_zero());
        let (a, b) = (Fraction::new(p, q.clone()).expect("q is not zero"), Fraction::new(q, r).expect("r is not zero"));
        prop_assert_eq!((a.clone() / b.clone()) * b.clone(), a.clone());
        prop_assert_eq!((a.clone() + b.clone()) - b, a);
    }
}

#[test]
fn a_division_by_zero_is_marked() {
    let x = Fraction::from(Polynomial::variable(0));
    assert!(
        !(x.clone() / (x.clone() - x)).is_valid(),
        "x / 0 is no fraction"
    );
}
