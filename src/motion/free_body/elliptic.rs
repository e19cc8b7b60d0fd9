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

#[cfg(test)]
mod tests {
    use super::*;
    use std::f64::consts::FRAC_PI_2;

    /// The integrand ∫ dφ / √(cos²φ + k'² sin²φ) by Gauss–Legendre panels.
    fn by_quadrature(angle: f64, complementary: f64) -> f64 {
        let nodes = [
            (0.0, 0.568_888_888_888_888_9),
            (0.538_469_310_105_683_1, 0.478_628_670_499_366_47),
            (0.906_179_845_938_664, 0.236_926_885_056_189_08),
        ];
        let panels = 4000;
        let half = angle / f64::from(panels) / 2.0;
        let value = |phi: f64| 1.0 / phi.cos().hypot(complementary * phi.sin());
        (0..panels)
            .map(|i| {
                let middle = half * f64::from(2 * i + 1);
                let sides = nodes[1..]
                    .iter()
                    .map(|(x, w)| w * (value(middle - x * half) + value(middle + x * half)));
                half * (nodes[0].1 * value(middle) + sides.sum::<f64>())
            })
            .sum()
    }

    #[test]
    fn the_integrals_match_quadrature() {
        for complementary in [1.0, 0.99, 0.5, 0.1, 0.01] {
            let k = complete(complementary);
            // Four thousand panels of order ten: what is left is the rounding of a sum of that many.
            assert!((k / by_quadrature(FRAC_PI_2, complementary) - 1.0).abs() < 1e-13);
            for tangent in [1e-9, 0.1, 0.7, 1.0, 3.0, 40.0, 1e6] {
                let exact = by_quadrature(f64::atan(tangent), complementary);
                let found = incomplete(tangent, complementary, k);
                assert!(
                    (found / exact - 1.0).abs() < 1e-13,
                    "{tangent} {complementary}"
                );
            }
        }
    }

    #[test]
    fn the_ends_of_the_range_are_finite_or_known() {
        assert!(complete(0.0).is_infinite());
        assert!((complete(1e-300) - (4e300_f64).ln()).abs() < 1e-12);
        assert!(incomplete(0.0, 0.5, complete(0.5)).abs() < f64::MIN_POSITIVE);
        assert!((incomplete(f64::INFINITY, 0.5, complete(0.5)) - complete(0.5)).abs() < 1e-15);
        assert!((incomplete(2.0, 0.0, f64::INFINITY) - 2.0_f64.asinh()).abs() < 1e-15);
        assert!((incomplete(10.0, 1e-9, complete(1e-9)) - 10.0_f64.asinh()).abs() < 1e-14);
    }
}
