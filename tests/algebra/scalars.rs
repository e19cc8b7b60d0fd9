//! Every scalar keeps the same laws; a new one joins by one line.

use nalgebra::{Matrix3, Vector3};
use num_dual::{Derivative, Dual64, DualSVec64};
use polhode::mechanics::{
    adjugate, angular_acceleration, apply, cross, determinant, moment, product, skew,
};
use polhode::scalar::{Field, Jet, Prime, Real, Ring};
#[cfg(feature = "verify")]
use {
    num_rational::BigRational,
    polhode::algebra::{Fraction, Polynomial, Rational},
};

/// A scalar under test. Small integers only, so that floating point is exact and no law needs a tolerance.
trait Specimen: Ring {
    /// The number `value`, with `slope` as derivative (or as the coefficient of an unknown) where there is one.
    fn of(value: i32, slope: i32) -> Self;
    /// Equality that also sees the derivatives, which num-dual's `==` does not.
    fn same(&self, other: &Self) -> bool;
}

fn samples<T: Specimen>() -> Vec<T> {
    [(-7, 3), (-1, 0), (0, 5), (0, 0), (1, 0), (2, -1), (12, 4)]
        .map(|(value, slope)| T::of(value, slope))
        .into()
}

#[track_caller]
fn assert_same<T: Specimen>(left: T, right: T) {
    assert!(left.same(&right), "{left:?} is not {right:?}");
}

#[track_caller]
fn assert_same_vector<T: Specimen>(left: Vector3<T>, right: Vector3<T>) {
    for (l, r) in left.iter().zip(right.iter()) {
        assert!(l.same(r), "{left:?} is not {right:?}");
    }
}

fn ring_laws<T: Specimen>() {
    for a in &samples::<T>() {
        for b in &samples::<T>() {
            for c in &samples::<T>() {
                let (a, b, c) = (|| a.clone(), || b.clone(), || c.clone());
                assert_same::<T>((a() + b()) + c(), a() + (b() + c()));
                assert_same::<T>((a() * b()) * c(), a() * (b() * c()));
                assert_same::<T>(a() * (b() + c()), a() * b() + a() * c());
                assert_same::<T>(a() - b(), a() + -b());
                assert_same::<T>(a() * b(), b() * a());
            }
        }
        let mut assigned = a.clone();
        assigned += a.clone();
        assigned *= a.clone();
        assigned -= a.clone();
        let twice = T::int(2) * a.clone();
        assert_same(assigned, twice * a.clone() - a.clone());
        assert_same(a.clone() + T::zero(), a.clone());
        assert_same(a.clone() * T::one(), a.clone());
        assert!((a.clone() - a.clone()).is_zero());
    }
    assert_same(T::int(-13), -(T::int(6) + T::int(7)));
    assert_same(T::int(0), T::zero());
}

fn field_laws<T: Specimen + Field>() {
    for a in &samples::<T>() {
        // Powers of two, so that doubles divide exactly.
        for b in [(1, 2), (2, 0), (-4, 8), (8, -4)] {
            let (a, b) = (|| a.clone(), || T::of(b.0, b.1));
            assert_same(a() * b() / b(), a());
            assert_same(a() / b() * b(), a());
            let mut assigned = a();
            assigned /= b();
            assert_same(assigned, a() * (T::one() / b()));
        }
    }
    assert_same(T::ratio(6, -4), -T::ratio(3, 2));
}

fn real_laws<T: Specimen + Real>() {
    for root in [1, 2, 5, 12] {
        assert_same(T::of(root * root, 6 * root).sqrt(), T::of(root, 3));
    }
    let (sine, cosine) = T::of(0, 7).sin_cos();
    assert_same(sine, T::of(0, 7));
    assert_same(cosine, T::one());
}

fn matrix_laws<T: Specimen>() {
    let at = |i: i32| T::of([2, -3, 1, 4, 0, -5, 7, 6, 8][i as usize], i - 4);
    let m = Matrix3::from_fn(|r, c| at((3 * r + c) as i32));
    let v = Vector3::new(at(0), at(4), at(5));
    let w = Vector3::new(at(7), at(1), at(3));
    assert_same_vector(apply(&skew(&v), &w), cross(&v, &w));
    assert_same_vector(
        apply(&product(&m, &adjugate(&m)), &v),
        v.map(|x| x * determinant(&m)),
    );
}

/// The equation itself: linear in α, and α comes back from the moment.
fn moment_laws<T: Specimen>() {
    let (inertia, omega, alpha) = motion::<T>();
    let scaled = moment(&inertia, &omega, &alpha.map(|a| a * T::int(3)));
    let steady = moment(&inertia, &omega, &Vector3::zeros());
    let once = moment(&inertia, &omega, &alpha);
    assert_same_vector(scaled - &steady, (once - steady).map(|m| m * T::int(3)));
}

fn acceleration_laws<T: Specimen + Field>() {
    let (inertia, omega, alpha) = motion::<T>();
    let under = moment(&inertia, &omega, &alpha);
    assert_same_vector(angular_acceleration(&inertia, &omega, &under), alpha);
}

/// A body whose determinant is a power of two: 8·(4·4 − 0) − … = 64.
fn motion<T: Specimen>() -> (Matrix3<T>, Vector3<T>, Vector3<T>) {
    let n = |value| T::of(value, value - 2);
    let zero = || T::of(0, 0);
    let inertia = Matrix3::new(n(8), zero(), n(4), zero(), n(4), zero(), n(4), zero(), n(4));
    let omega = Vector3::new(n(1), n(-3), n(5));
    (inertia, omega, Vector3::new(n(-2), n(7), n(3)))
}

macro_rules! scalars {
    ($($(#[$gate:meta])* $name:ident: $scalar:ty = $of:expr, $same:expr, [$($law:ident)*];)*) => {$(
        $(#[$gate])*
        impl Specimen for $scalar {
            fn of(value: i32, slope: i32) -> Self {
                let of: fn(i32, i32) -> Self = $of;
                of(value, slope)
            }
            fn same(&self, other: &Self) -> bool {
                let same: fn(&Self, &Self) -> bool = $same;
                same(self, other)
            }
        }
        $(#[$gate])*
        mod $name {
            #[allow(unused_imports, reason = "a primitive type needs no name from outside")]
            use super::*;
            $(#[test] fn $law() { super::$law::<$scalar>(); })*
        }
    )*};
}

/// `==` on bits of value: these scalars hold exact small integers.
#[expect(clippy::float_cmp, reason = "all values are exact")]
fn exact(a: f64, b: f64) -> bool {
    a == b
}

fn parts<const N: usize>(dual: &DualSVec64<N>) -> [f64; N] {
    std::array::from_fn(|i| dual.eps.0.map_or(0.0, |eps| eps[i]))
}

fn jet<T: Ring>(value: i32, slope: i32) -> Jet<T, 3> {
    Jet {
        value: T::int(value),
        partials: [T::int(slope), T::zero(), T::int(1 - slope)],
    }
}

#[cfg(feature = "verify")]
fn line(value: i32, slope: i32) -> Polynomial {
    Polynomial::int(value) + Polynomial::int(slope) * Polynomial::variable(3)
}

scalars! {
    double: f64 = |v, _| f64::from(v), |a, b| exact(*a, *b),
        [ring_laws field_laws real_laws matrix_laws moment_laws acceleration_laws];
    single: f32 = |v, _| v as f32, |a, b| exact(f64::from(*a), f64::from(*b)),
        [ring_laws field_laws real_laws matrix_laws moment_laws acceleration_laws];
    dual: Dual64 = |v, s| Dual64::new(v.into(), s.into()), |a, b| exact(a.re, b.re) && exact(a.eps, b.eps),
        [ring_laws field_laws real_laws matrix_laws moment_laws acceleration_laws];
    dual_vector: DualSVec64<6> = |v, s| {
            let eps = nalgebra::SVector::from_fn(|i, _| f64::from(s * i as i32));
            DualSVec64::new(v.into(), Derivative::some(eps))
        }, |a, b| exact(a.re, b.re) && parts(a).into_iter().zip(parts(b)).all(|(a, b)| exact(a, b)),
        [ring_laws field_laws real_laws matrix_laws moment_laws acceleration_laws];
    prime_field: Prime = |v, _| Prime::int(v), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    jet_of_double: Jet<f64, 3> = |v, s| jet(v, s), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    jet_of_prime: Jet<Prime, 3> = |v, s| jet(v, s), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    jet_of_jet: Jet<Jet<Prime, 3>, 1> = |v, s| Jet { value: jet(v, s), partials: [jet(s, v)] }, |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    #[cfg(feature = "verify")]
    big_rational: BigRational = |v, _| BigRational::int(v), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    #[cfg(feature = "verify")]
    jet_of_big_rational: Jet<BigRational, 3> = |v, s| jet(v, s), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    #[cfg(feature = "verify")]
    rational: Rational = |v, _| Rational::int(v), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
    #[cfg(feature = "verify")]
    polynomial: Polynomial = line, |a, b| a == b,
        [ring_laws matrix_laws moment_laws];
    #[cfg(feature = "verify")]
    jet_of_polynomial: Jet<Polynomial, 1> = |v, s| Jet::moving(line(v, s), line(s, v)), |a, b| a == b,
        [ring_laws matrix_laws moment_laws];
    #[cfg(feature = "verify")]
    fraction: Fraction = |v, s| Fraction::from(line(v, s)), |a, b| a == b,
        [ring_laws field_laws matrix_laws moment_laws acceleration_laws];
}

/// A jet over doubles carries the derivatives of roots and sines as num-dual does.
#[test]
fn jets_know_the_derivatives_of_roots_and_sines() {
    for x in [0.3, 1.0, 2.5, 7.0] {
        let (moving, dual) = (Jet::<f64, 1>::moving(x, 1.5), Dual64::new(x, 1.5));
        // Both form the same products in an order of their own: a few roundings.
        let near = |jet: Jet<f64, 1>, dual: Dual64| {
            (jet.value - dual.re).abs() + (jet.rate() - dual.eps).abs() < 1e-15 * (1.0 + x)
        };
        assert!(near(Real::sqrt(&moving), Real::sqrt(&dual)));
        let ((sine, cosine), (s, c)) = (Real::sin_cos(&moving), Real::sin_cos(&dual));
        assert!(near(sine, s) && near(cosine, c));
    }
}

#[test]
fn the_inverse_in_a_prime_field_undoes_the_product_at_the_edges() {
    for n in [1, 2, 3, Prime::MODULUS - 1, Prime::MODULUS - 2, 1 << 60] {
        let a = Prime::new(n);
        let inverse = a.inverse().expect("n is not zero");
        assert_eq!(a * inverse, Prime::new(1), "{n}");
    }
    assert_eq!(Prime::new(Prime::MODULUS).inverse(), None);
}
