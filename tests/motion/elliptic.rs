//! Elliptic integrals against quadrature, and at the ends of their range.

#[path = "../../src/motion/free_body/elliptic.rs"]
mod integrals;

use integrals::{complete, incomplete};
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
