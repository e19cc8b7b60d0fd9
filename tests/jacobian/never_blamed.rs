//! A right Jacobian is never called wrong, whatever the scales of its entries.

use super::steps::{at, right, step};
use nalgebra::{SMatrix, SVector};
use polhode::jacobian::{Verdict, check, check_black_box};
use polhode::motion::Number;
use proptest::prelude::*;

/// A power of ten between 1e-12 and 1e12, and a digit before it.
fn scales() -> impl Strategy<Value = f64> {
    (1.0_f64..10.0, -12_i32..12).prop_map(|(digit, power)| digit * 10.0_f64.powi(power))
}

fn four<S: Strategy>(strategy: impl Fn() -> S) -> impl Strategy<Value = [S::Value; 4]> {
    [strategy(), strategy(), strategy(), strategy()]
}

/// Sums and products with sines of inputs of any scale, into outputs of any scale.
#[derive(Clone, Copy, Debug)]
struct Mixed {
    inputs: [f64; 4],
    outputs: [f64; 4],
    weights: [[f64; 4]; 4],
}

impl Mixed {
    fn value<T: Number>(&self, x: &SVector<T, 4>) -> SVector<T, 4> {
        let u = SVector::<T, 4>::from_fn(|i, _| x[i] * T::of(1.0 / self.inputs[i]));
        SVector::from_fn(|r, _| {
            let w = self.weights[r].map(T::of);
            let (sine, _) = (u[1] * w[1]).sin_cos();
            (u[0] * u[0] * w[0] + sine + u[2] * u[3] * w[2] + u[3] * w[3]) * T::of(self.outputs[r])
        })
    }

    fn jacobian(&self, x: &SVector<f64, 4>) -> SMatrix<f64, 4, 4> {
        let u = SVector::<f64, 4>::from_fn(|i, _| x[i] / self.inputs[i]);
        SMatrix::from_fn(|r, c| {
            let w = self.weights[r];
            let slope = match c {
                0 => 2.0 * w[0] * u[0],
                1 => w[1] * (w[1] * u[1]).cos(),
                2 => w[2] * u[3],
                _ => w[2] * u[2] + w[3],
            };
            slope * self.outputs[r] / self.inputs[c]
        })
    }
}

fn mixed() -> impl Strategy<Value = (Mixed, SVector<f64, 4>)> {
    let weights = four(|| four(|| -2.0_f64..2.0));
    (four(scales), four(scales), weights, four(|| -3.0_f64..3.0)).prop_map(
        |(inputs, outputs, weights, u)| {
            let x = SVector::from_fn(|i, _| u[i] * inputs[i]);
            let mixed = Mixed {
                inputs,
                outputs,
                weights,
            };
            (mixed, x)
        },
    )
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(1000) })]

    #[test]
    fn against_dual_numbers((f, x) in mixed()) {
        let report = check(|x| f.value(x), |x| f.jacobian(x), &x);
        prop_assert!(report.is_right(), "{}", report);
    }

    #[test]
    fn against_differences((f, x) in mixed()) {
        let report = check_black_box(|x| f.value(x), |x| f.jacobian(x), &x);
        prop_assert_ne!(report.verdict(), Verdict::Wrong, "{}", report);
    }

    /// Entries of any scale side by side, from 1e-12 to 1e12.
    #[test]
    fn linear_with_entries_of_any_scale(entries in four(|| four(scales)), x in four(|| -1.0_f64..1.0)) {
        let matrix = SMatrix::<f64, 4, 4>::from_fn(|r, c| entries[r][c]);
        let f = |x: &SVector<num_dual::Dual64, 4>| matrix.map(num_dual::Dual64::from_re) * x;
        let report = check(f, |_| matrix, &SVector::from(x));
        prop_assert!(report.is_right(), "{}", report);
        let report = check_black_box(|x: &SVector<f64, 4>| matrix * x, |_| matrix, &SVector::from(x));
        prop_assert_ne!(report.verdict(), Verdict::Wrong, "{}", report);
    }

    /// And one that is off by a part in a thousand is seen.
    #[test]
    fn a_slip_is_seen_at_any_scale((f, x) in mixed(), row in 0_usize..4, column in 0_usize..4) {
        let mut matrix = f.jacobian(&x);
        let natural = f.outputs[row] / f.inputs[column];
        prop_assume!(matrix[(row, column)].abs() > 1e-2 * natural);
        matrix[(row, column)] *= 1.001;
        let report = check(|x| f.value(x), |_| matrix, &x);
        prop_assert_eq!(report.verdict(), Verdict::Wrong, "{}", report);
        prop_assert_eq!((report.entries()[0].row, report.entries()[0].column), (row, column));
        let wrong = report.entries().iter().filter(|e| e.verdict == Verdict::Wrong).count();
        prop_assert_eq!(wrong, 1);
    }

    #[test]
    fn values_with_noise((f, x) in mixed(), digits in 4_i32..12) {
        // The digits behind some place are noise: a function of single precision, or of an iteration cut short.
        let grain = f.outputs.map(|scale| scale * 10.0_f64.powi(-digits));
        let noisy = |x: &SVector<f64, 4>| {
            let y = f.value(x);
            SVector::<f64, 4>::from_fn(|r, _| (y[r] / grain[r]).round() * grain[r])
        };
        let report = check_black_box(noisy, |x| f.jacobian(x), &x);
        prop_assert_ne!(report.verdict(), Verdict::Wrong, "{}", report);
    }

    #[test]
    fn values_in_single_precision((f, x) in mixed()) {
        let single = |x: &SVector<f64, 4>| f.value(x).map(|y| f64::from(y as f32));
        let report = check_black_box(single, |x| f.jacobian(x), &x);
        prop_assert_ne!(report.verdict(), Verdict::Wrong, "{}", report);
    }
}

#[test]
fn a_step_of_a_body_against_both() {
    assert!(check(step, |_| right(), &at()).is_right());
    let report = check_black_box(step, |_| right(), &at());
    assert!(report.is_right(), "{report}");
}
