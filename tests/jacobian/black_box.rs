//! A function of which only values can be had: wrong derivatives and noisy differences are told apart.

use super::steps::{at, columns, right, rows, step};
use nalgebra::{SMatrix, SVector};
use polhode::jacobian::{Check, Kind, Verdict, check_black_box};

type One = SMatrix<f64, 1, 1>;

fn verdict(f: impl Fn(f64) -> f64, slope: f64, at: f64) -> Verdict {
    let f = |x: &SVector<f64, 1>| SVector::from([f(x[0])]);
    check_black_box(f, |_| One::new(slope), &SVector::from([at])).verdict()
}

#[test]
fn the_cause_of_a_wrong_step_is_named_without_dual_numbers() {
    let mut matrix = right();
    matrix.fixed_view_mut::<3, 3>(3, 0).neg_mut();
    let check = Check::default().rows(rows()).columns(columns());
    let report = check.of_black_box(step, |_| matrix, &at());
    assert_eq!(report.causes().len(), 1, "{report}");
    assert_eq!(report.causes()[0].kind, Kind::Sign, "{report}");
    let slopes = report
        .entries()
        .iter()
        .filter(|e| e.verdict == Verdict::Wrong)
        .map(|e| e.slope);
    assert!(
        slopes.flatten().all(|slope| (slope - 1.0).abs() < 0.1),
        "{report}"
    );
}

#[test]
fn the_remainder_of_a_right_derivative_falls_as_the_square() {
    let f = |x: &SVector<f64, 1>| x.map(f64::exp);
    let report = check_black_box(f, |x| One::new(x[0].exp()), &SVector::from([0.3]));
    let slope = report.entries()[0].slope.expect("more than rounding");
    assert!((slope - 2.0).abs() < 0.1, "{report}");
}

#[test]
fn noise_is_called_noise() {
    // A granularity as coarse as the value: no step shows the derivative.
    let coarse = |x: f64| (x * 3.0).round() / 3.0;
    assert_eq!(verdict(coarse, 2.0, 0.2), Verdict::Unsure);
    // Lost in a large constant, a thousandth of it.
    let swamped = |x: f64| (1e12 + x) - 1e12;
    assert_ne!(verdict(swamped, 1.0, 0.3), Verdict::Wrong);
    assert_eq!(verdict(swamped, -1.0, 0.3), Verdict::Wrong);
}

#[test]
fn a_kink_has_no_derivative_to_be_wrong() {
    for slope in [-1.0, 0.0, 1.0] {
        assert_eq!(verdict(f64::abs, slope, 0.0), Verdict::Unsure);
    }
}

#[test]
fn a_function_that_is_not_finite_further_out_is_still_judged() {
    assert_eq!(verdict(f64::ln, 1e6, 1e-6), Verdict::Right);
    assert_eq!(verdict(f64::ln, 2e6, 1e-6), Verdict::Wrong);
    assert_eq!(
        verdict(f64::asin, 1.0 / 0.19_f64.sqrt(), 0.9),
        Verdict::Right
    );
    assert_eq!(verdict(|_| f64::NAN, 1.0, 0.0), Verdict::Unsure);
}

#[test]
fn waves_far_shorter_than_the_input() {
    let wave = |x: f64| (1e9 * x).sin();
    assert_eq!(
        verdict(wave, 1e9 * 1e-9_f64.mul_add(1e9, 0.0).cos(), 1e-9),
        Verdict::Right
    );
    assert_eq!(verdict(wave, 1.0, 1e-9), Verdict::Wrong);
}

#[test]
fn a_constant_has_the_derivative_zero() {
    assert_eq!(verdict(|_| 3.0, 0.0, 0.7), Verdict::Right);
    assert_eq!(verdict(|_| 3.0, 1e-3, 0.7), Verdict::Wrong);
    assert_eq!(verdict(|x| x * x, 0.0, 0.0), Verdict::Right);
}
