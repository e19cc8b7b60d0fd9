//! Numbers that are drawn: their distributions, and that each member has its own.

use polhode::scene::{Draw, Quantity};

/// Mean and deviation over many members.
fn moments(quantity: Quantity) -> (f64, f64) {
    let count = 40_000;
    let values: Vec<f64> = (0..count)
        .map(|member| quantity.draw(&mut Draw::new(7, member)))
        .collect();
    let mean = values.iter().sum::<f64>() / count as f64;
    let square = values.iter().map(|v| (v - mean).powi(2)).sum::<f64>() / count as f64;
    (mean, square.sqrt())
}

#[test]
fn draws_have_the_moments_of_their_distributions() {
    // Five deviations of a mean of 40 000 draws.
    let near = 5.0 / 200.0;
    let (mean, deviation) = moments(Quantity::Normal {
        mean: 3.0,
        deviation: 2.0,
    });
    assert!((mean - 3.0).abs() < 2.0 * near && (deviation - 2.0).abs() < 2.0 * near);
    let (mean, deviation) = moments(Quantity::Uniform {
        from: -1.0,
        to: 1.0,
    });
    assert!(mean.abs() < near && (deviation - 1.0 / 3f64.sqrt()).abs() < near);
}

#[test]
fn a_member_is_the_same_whoever_else_is_drawn() {
    let quantity = Quantity::Uniform {
        from: f64::MIN,
        to: f64::MAX,
    };
    let [a, b] = [0, 0].map(|_| quantity.draw(&mut Draw::new(1, 5)).to_bits());
    let c = quantity.draw(&mut Draw::new(2, 5));
    assert_eq!(a, b);
    assert!(a != c.to_bits() && c.is_finite());
}
