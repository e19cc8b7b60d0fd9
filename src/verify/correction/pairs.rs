//! Pairs of values whose products are compared.

use crate::algebra::{Fraction, Monomial, Polynomial, Rational};
use crate::verify::standing::judge::Judge;
use num_traits::{One, Zero};

/// Whether the products of two pairs are the same.
pub(super) fn are_same(
    judge: &mut Judge<'_>,
    one: [&Fraction; 2],
    other: [&Fraction; 2],
) -> Option<bool> {
    let mut all = one.into_iter().chain(other);
    if all.all(|value| value.denominator().is_one()) && judge.knows_no_square() {
        let [one, other] = [one, other].map(|pair| pair.map(Fraction::numerator));
        let count = |[a, b]: [&Polynomial; 2]| match (a.len(), b.len()) {
            (1, terms) | (terms, 1) => Some(terms),
            _ => None,
        };
        let counts = count(one).zip(count(other));
        let product = |[a, b]: [&Polynomial; 2]| Polynomial::sum_of_products(&[(a, b)]);
        let may_be = counts.is_none_or(|(one, other)| one == other) && ends(one) == ends(other);
        return Some(may_be && product(one) == product(other));
    }
    let [one, other] = [one, other].map(|[a, b]| a.clone() * b.clone());
    Some(judge.normal(&(one - other))?.is_zero())
}

/// The highest and the lowest term of a product: those of its factors, multiplied. None of zero.
fn ends([a, b]: [&Polynomial; 2]) -> Option<[(Monomial, Rational); 2]> {
    let of = |polynomial: &Polynomial| {
        let terms = polynomial.terms();
        Some([terms.first()?.clone(), terms.last()?.clone()])
    };
    let [[high, low], [higher, lower]] = [of(a)?, of(b)?];
    let times = |one: (Monomial, Rational), other: (Monomial, Rational)| {
        (one.0.times(&other.0), one.1 * other.1)
    };
    Some([times(high, higher), times(low, lower)])
}
