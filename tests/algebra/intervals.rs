//! Intervals against the standard library, published digits, and the rounding of their ends.

use num_bigint::BigInt;
use num_rational::BigRational;
use num_traits::ToPrimitive;
use polhode::algebra::{Interval, Rational};

fn of(n: i64, d: i64) -> Interval {
    Interval::from(&Rational::from((n, d)))
}

/// The printed decimals and the interval agree, and the interval is narrow.
fn is(interval: &Interval, expected: f64) {
    // A double holds some 15.9 decimals.
    let error = (interval.middle() - expected).abs();
    assert!(
        error <= 4e-15 * expected.abs().max(1.0),
        "{} {expected}",
        interval.middle()
    );
    let (low, high) = interval.ends();
    let width = (high - low).to_big().to_f64().expect("finite");
    assert!((0.0..1e-60).contains(&width), "{width}");
}

#[test]
fn functions_agree_with_those_of_the_standard_library() {
    is(&Interval::pi(), std::f64::consts::PI);
    for (n, d) in [(1, 7), (-3, 2), (22, 7), (100, 3), (-355, 113), (0, 1)] {
        let x = n as f64 / d as f64;
        let (sine, cosine) = of(n, d).sine_cosine().expect("moderate");
        is(&sine, x.sin());
        is(&cosine, x.cos());
    }
    for (n, d) in [(1, 7), (-3, 2), (2, 1), (0, 1)] {
        is(
            &of(n, d).exponential().expect("moderate"),
            (n as f64 / d as f64).exp(),
        );
    }
    for (n, d) in [(1, 7), (3, 2), (1000, 1), (1, 1)] {
        let x = n as f64 / d as f64;
        is(&of(n, d).square_root().expect("positive"), x.sqrt());
        is(&of(n, d).logarithm().expect("positive"), x.ln());
    }
}

#[test]
fn known_digits_of_pi_lie_inside() {
    // From the tables: 3.14159265358979323846264338327950288…
    let digits: BigInt = "314159265358979323846264338327950288"
        .parse()
        .expect("digits");
    let unit = BigInt::from(10).pow(35);
    let end = |n: BigInt| Rational::from(BigRational::new(n, unit.clone()));
    assert!(Interval::pi().within(&end(digits.clone()), &end(digits + 1)));
}

#[test]
fn what_has_no_value_has_none() {
    let around = of(-1, 1).joined(&of(1, 1));
    assert_eq!(around.inverse(), None);
    assert_eq!(around.square_root(), None);
    assert_eq!(around.logarithm(), None);
    assert_eq!(of(1_000_000, 1).exponential(), None);
    assert_eq!(of(1_000_000, 1).sine_cosine(), None);
}

#[test]
fn ends_are_rounded_outwards() {
    let third = of(1, 3);
    let (low, high) = third.ends();
    assert!(low < high);
    assert!(third.times(&of(3, 1)).plus(&of(-1, 1)).within(
        &Rational::from((-1, 1_000_000)),
        &Rational::from((1, 1_000_000))
    ));
    let (low, high) = third.negated().times(&third).ends();
    assert!(low <= Rational::from((-1, 9)) && Rational::from((-1, 9)) <= high);
}
