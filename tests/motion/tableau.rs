//! The coefficients of DOP853 against the conditions of their orders.

#[path = "../../src/motion/dop853/tableau.rs"]
mod coefficients;

use coefficients::{DENSE, DENSE_STAGES, END, OVER_FIFTH, Row, STAGES, THIRD, TIMES};

fn times(row: Row, power: i32) -> f64 {
    row.iter().map(|(j, a)| a * TIMES[*j].powi(power)).sum()
}

/// A stage of order s has Σ aᵢⱼ cⱼᵏ = cᵢᵏ⁺¹ / (k + 1) for k < s.
#[test]
fn each_stage_is_a_quadrature_of_its_own_order() {
    for (i, row) in (1..).zip(STAGES).chain((13..).zip(DENSE_STAGES)) {
        let order = match i {
            1 => 1,
            2 => 2,
            3..=4 => 3,
            5..=6 => 4,
            _ => 5,
        };
        for k in 0..order {
            let exact = TIMES[i].powi(k + 1) / f64::from(k + 1);
            assert!(
                (times(row, k) - exact).abs() < 1e-14,
                "stage {i}, power {k}"
            );
        }
    }
}

#[test]
fn the_step_is_a_quadrature_of_order_eight_and_simplifies_the_rest() {
    for k in 0..8 {
        assert!((times(END, k) - 1.0 / f64::from(k + 1)).abs() < 1e-14);
    }
    // Σᵢ bᵢ aᵢⱼ = bⱼ (1 − cⱼ).
    for (j, time) in TIMES.iter().take(12).enumerate() {
        let weight = |row: Row, j: usize| {
            row.iter()
                .find(|(stage, _)| *stage == j)
                .map_or(0.0, |(_, b)| *b)
        };
        let sum: f64 = (1..)
            .zip(STAGES)
            .map(|(i, row)| weight(END, i) * weight(row, j))
            .sum();
        assert!((sum - weight(END, j) * (1.0 - time)).abs() < 1e-14);
    }
    for k in 0..5 {
        assert!(times(OVER_FIFTH, k).abs() < 1e-15);
    }
    for k in 0..3 {
        assert!((times(THIRD, k) - 1.0 / f64::from(k + 1)).abs() < 1e-15);
    }
}

/// On a motion tᵏ⁺¹ the output is exact up to the seventh power.
#[test]
fn the_dense_output_is_exact_on_powers() {
    for power in 1..=7 {
        let slope = |t: f64| f64::from(power) * t.powi(power - 1);
        let bend = slope(0.0) - 1.0;
        let twist = 1.0 - slope(1.0) - bend;
        let high = DENSE.map(|row| row.iter().map(|(j, d)| d * slope(TIMES[*j])).sum::<f64>());
        let nested = [0.0, 1.0, bend, twist, high[0], high[1], high[2], high[3]];
        for s in [0.1, 0.4, 0.77] {
            let value = nested.iter().enumerate().rev().fold(0.0, |v, (n, c)| {
                c + v * if n % 2 == 0 { s } else { 1.0 - s }
            });
            assert!((value - f64::powi(s, power)).abs() < 1e-12, "power {power}");
        }
    }
}
