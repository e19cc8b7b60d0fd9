//! One equation on all scalars: what two of them both know, they must agree on.

use nalgebra::{Matrix3, Vector3};
use num_dual::{Derivative, Dual64, DualSVec64};
use num_rational::BigRational;
use num_traits::{One, ToPrimitive};
use polhode::algebra::{Fraction, Polynomial, Rational};
use polhode::mechanics::{Products, angular_acceleration, inertia, moment, moment_in_axes};
use polhode::scalar::{Field, Jet, Prime, Ring};
use proptest::prelude::*;

/// Six inertia numbers, ω, α or moment, Ω: fifteen small integers, with moments that dominate so that the tensor is regular.
fn numbers() -> impl Strategy<Value = [i32; 15]> {
    let moments = [60i32..100, 60i32..100, 60i32..100];
    let rest: [_; 12] = std::array::from_fn(|_| -9i32..10);
    (moments, rest).prop_map(|(m, r)| std::array::from_fn(|i| if i < 3 { m[i] } else { r[i - 3] }))
}

struct Motion<T> {
    inertia: Matrix3<T>,
    omega: Vector3<T>,
    other: Vector3<T>,
    frame: Vector3<T>,
}

fn motion<T: Ring>(value: impl Fn(usize) -> T) -> Motion<T> {
    let three = |at: usize| [value(at), value(at + 1), value(at + 2)];
    Motion {
        inertia: inertia(three(0), three(3), Products::Integrals),
        omega: three(6).into(),
        other: three(9).into(),
        frame: three(12).into(),
    }
}

/// Nine numbers out of the equation: the moment in body axes, in axes that turn, and the acceleration back.
fn sums<T: Ring>(m: &Motion<T>) -> Vec<T> {
    let still = moment(&m.inertia, &m.omega, &m.other);
    let rate = polhode::mechanics::inertia_rate(&m.inertia, &m.omega, &m.frame);
    let turning = moment_in_axes(&m.inertia, &rate, &m.omega, &m.other, &m.frame);
    still.iter().chain(turning.iter()).cloned().collect()
}

fn quotients<T: Field>(m: &Motion<T>) -> Vec<T> {
    angular_acceleration(&m.inertia, &m.omega, &m.other)
        .iter()
        .cloned()
        .collect()
}

fn all<T: Field>(m: &Motion<T>) -> Vec<T> {
    let mut all = sums(m);
    all.extend(quotients(m));
    all
}

fn big(n: i32) -> BigRational {
    BigRational::from_integer(n.into())
}

/// Doubles beside the exact value: the sums are exact small integers, the quotients carry a few dozen roundings.
fn assert_near(double: f64, exact: &BigRational) -> Result<(), TestCaseError> {
    let exact = exact.to_f64().expect("a small number");
    prop_assert!(
        (double - exact).abs() <= 1e-13 * (1.0 + exact.abs()),
        "{double} {exact}"
    );
    Ok(())
}

proptest! {
    // Fifteen derivatives over big rationals take time; the laws are polynomial, so few points decide.
    #![proptest_config(ProptestConfig::with_cases(32))]

    #[test]
    fn doubles_primes_and_rationals_agree(n in numbers()) {
        let exact = all(&motion(|i| big(n[i])));
        for (double, exact) in all(&motion(|i| f64::from(n[i]))).iter().zip(&exact) {
            assert_near(*double, exact)?;
        }
        for (quick, exact) in all(&motion(|i| Rational::from(i64::from(n[i])))).iter().zip(&exact) {
            prop_assert_eq!(&quick.to_big(), exact);
        }
        for (residue, exact) in all(&motion(|i| Prime::int(n[i]))).iter().zip(&exact) {
            prop_assert_eq!(Some(*residue), Rational::from(exact.clone()).to_prime());
        }
    }

    #[test]
    fn polynomials_and_fractions_evaluated_agree_with_numbers(n in numbers()) {
        let at = |v: u32| big(n[v as usize]);
        let exact = all(&motion(|i| big(n[i])));
        let symbols = |i: usize| Polynomial::variable(i as u32);
        for (symbolic, exact) in sums(&motion(symbols)).iter().zip(&exact) {
            prop_assert_eq!(&symbolic.evaluate(at, Rational::to_big), exact);
        }
        let symbolic = quotients(&motion(|i| Fraction::from(symbols(i))));
        for (symbolic, exact) in symbolic.iter().zip(&exact[6..]) {
            let [top, bottom] = [symbolic.numerator(), symbolic.denominator()]
                .map(|p| p.evaluate(at, Rational::to_big));
            prop_assert_eq!(&(top / bottom), exact);
        }
    }

    /// All fifteen directions at once by jets over rationals, one by one by num-dual over doubles, and the polynomials' own partials.
    #[test]
    fn derivatives_agree(n in numbers(), direction in 0usize..15) {
        let exact = all(&motion(|i| Jet::<_, 15>::variable(big(n[i]), i)));
        let jets = all(&motion(|i| Jet::<_, 15>::variable(f64::from(n[i]), i)));
        let duals = all(&motion(|i| {
            Dual64::new(n[i].into(), if i == direction { 1.0 } else { 0.0 })
        }));
        for ((exact, jet), dual) in exact.iter().zip(&jets).zip(&duals) {
            assert_near(jet.value, &exact.value)?;
            assert_near(jet.partials[direction], &exact.partials[direction])?;
            assert_near(dual.eps, &exact.partials[direction])?;
        }
        let symbolic = sums(&motion(|i| Polynomial::variable(i as u32)));
        for (symbolic, exact) in symbolic.iter().zip(&exact) {
            let slope = symbolic.partial(direction as u32);
            let value = slope.evaluate(|v| big(n[v as usize]), Rational::to_big);
            prop_assert_eq!(&value, &exact.partials[direction]);
        }
    }

    #[test]
    fn vectors_of_duals_agree_with_jets(n in numbers()) {
        let duals = all(&motion(|i| {
            let unit = nalgebra::SVector::from_fn(|k, _| if k == i { 1.0 } else { 0.0 });
            DualSVec64::<15>::new(n[i].into(), Derivative::some(unit))
        }));
        let exact = all(&motion(|i| Jet::<_, 15>::variable(big(n[i]), i)));
        for (dual, exact) in duals.iter().zip(&exact) {
            let eps = dual.eps.0.expect("seeded");
            for (slope, exact) in eps.iter().zip(&exact.partials) {
                assert_near(*slope, exact)?;
            }
        }
    }
}

/// What comes after the derivative: d²/dω_x² of the moment by jets of jets is the polynomial's second partial.
#[test]
fn nested_jets_have_the_second_derivative() {
    let once = |i: usize| {
        Jet::<_, 1>::moving(
            big(i as i32 + 3),
            if i == 6 { BigRational::one() } else { big(0) },
        )
    };
    let nested = sums(&motion(|i| {
        Jet::<_, 1>::moving(
            once(i),
            if i == 6 {
                Jet::one()
            } else {
                Jet::constant(big(0))
            },
        )
    }));
    let symbolic = sums(&motion(|i| Polynomial::variable(i as u32)));
    for (jet, polynomial) in nested.iter().zip(&symbolic) {
        let second = polynomial.partial(6).partial(6);
        let value = second.evaluate(|v| big(v as i32 + 3), Rational::to_big);
        assert_eq!(jet.rate().rate(), value);
    }
}
