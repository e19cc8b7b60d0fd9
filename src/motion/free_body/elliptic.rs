//! Elliptic integrals of the first kind from the complementary modulus, which is what is known well.

use std::f64::consts::PI;

/// Past this relative difference one more step of the mean squares it below rounding.
const NEAR: f64 = 1e-8;

/// Steps of the mean. Its convergence is quadratic: a ratio of 1e-300 takes 15.
const CAP: usize = 32;

/// The complete integral K(k) = π / (2 AGM(1, k')) for k' in 0 ..= 1; infinite at k' = 0.
pub(super) fn complete(complementary: f64) -> f64 {
    let (mut a, mut g) = (1.0, complementary);
    if g == 0.0 {
        return f64::INFINITY;
    }
    for _ in 0..CAP {
        if (a - g).abs() <= NEAR * a {
            break;
        }
        (a, g) = (0.5 * (a + g), (a * g).sqrt());
    }
    PI / (a + g)
}

/// The integral F(φ, k) for tan φ = `tangent` ≥ 0, φ in the first quadrant.
///
/// Bulirsch's `el1` (Numerische Mathematik 7, 1965): Landen's transformation on the cotangent. Past the
/// middle of the quarter period the integral is K less that of the mirrored amplitude, so that a distance
/// to the end of the quarter comes out to its own relative accuracy.
pub(super) fn incomplete(tangent: f64, complementary: f64, complete: f64) -> f64 {
    if complementary == 0.0 {
        return tangent.asinh();
    }
    let mirrored = 1.0 / (complementary * tangent);
    if tangent > mirrored {
        complete - by_landen(mirrored, complementary)
    } else {
        by_landen(tangent, complementary)
    }
}

/// F for amplitudes up to the middle of the quarter period.
fn by_landen(tangent: f64, complementary: f64) -> f64 {
    if tangent == 0.0 {
        return 0.0;
    }
    let (mut cotangent, mut geometric, mut sum, mut turns) = (1.0 / tangent, complementary, 1.0, 0);
    for _ in 0..CAP {
        let (product, before) = (sum * geometric, sum);
        sum += geometric;
        cotangent -= product / cotangent;
        if cotangent == 0.0 {
            // A quarter turn exactly: the next step divides by it.
            cotangent = product.sqrt() * f64::EPSILON;
        }
        if (before - geometric).abs() <= NEAR * before {
            break;
        }
        geometric = 2.0 * product.sqrt();
        turns = 2 * turns + i64::from(cotangent < 0.0);
    }
    if cotangent < 0.0 {
        turns += 1;
    }
    ((sum / cotangent).atan() + PI * turns as f64) / sum
}
