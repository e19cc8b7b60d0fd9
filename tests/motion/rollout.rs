//! A trajectory with a torque for each step: its gradient against that of the chained Jacobians and against differences.

use super::cases::{Case, cases, tamed};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};
use polhode::jacobian::{Check, Slot};
use polhode::mechanics::InertiaParameters;
use polhode::motion::{Frame, Quaternion, Rk4, Rollout, Scheme, State, System, Torque};
use proptest::prelude::*;

const STEPS: usize = 7;

fn torques() -> Vec<Vector3<f64>> {
    let wave = |k: usize, i: usize| (1.3 * (3 * k + i) as f64).sin() * 0.1;
    (0..STEPS)
        .map(|k| Vector3::from_fn(|i, _| wave(k, i)))
        .collect()
}

fn costs() -> Vec<Vector6<f64>> {
    (0..=STEPS)
        .map(|k| Vector6::from_fn(|i, _| (0.7 * (6 * k + i) as f64).cos()))
        .collect()
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(60) })]

    #[test]
    fn the_gradient_is_that_of_the_chained_steps(case in cases()) {
        let case = tamed(&case);
        let torques = torques();
        let rollout = Rollout::new(Rk4, case.system(), case.state, case.step, &torques);
        let rollout = rollout.expect("finite");
        let (costs, steps) = (costs(), rollout.jacobians::<16>().collect::<Vec<_>>());
        let gradient = rollout.gradient(&costs);
        let mut so_far = steps[0];
        let mut sum = costs[0].transpose() * SMatrix::<f64, 6, 6>::identity();
        sum += costs[1].transpose() * so_far.by_state();
        for (k, step) in steps.iter().enumerate().skip(1) {
            so_far = so_far.then(step);
            sum += costs[k + 1].transpose() * so_far.by_state();
        }
        let scale = 1e-10 * (1.0 + sum.amax());
        prop_assert!((gradient.start - sum.transpose()).amax() < scale);
        // The last torque acts in the last step alone.
        let last = steps[STEPS - 1].by_torque().tr_mul(&costs[STEPS]);
        prop_assert!((gradient.torques[STEPS - 1] - last).amax() < 1e-10 * (1.0 + last.amax()));
        // Costs of the end alone, in what all steps share.
        let mut end = vec![Vector6::zeros(); STEPS + 1];
        end[STEPS] = costs[STEPS];
        let gradient = rollout.gradient(&end);
        let inertia = so_far.by_inertia().tr_mul(&costs[STEPS]);
        prop_assert!((gradient.inertia - inertia).amax() < 1e-9 * (1.0 + inertia.amax()));
        let length = so_far.by_dt().dot(&costs[STEPS]);
        prop_assert!((gradient.step - length).abs() < 1e-9 * (1.0 + length.abs()));
    }
}

/// The end of the rollout as a black box of the start's tangent, the middle torque and the tensor.
#[test]
fn the_gradient_is_that_of_the_values() {
    let case = tamed(&Case {
        inertia: Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0),
        torque: Torque::Gravity {
            weight: 9.81,
            arm: Vector3::new(0.05, -0.1, 0.3),
        },
        state: State {
            attitude: Quaternion::exp(&Vector3::new(0.4, -1.1, 0.7)),
            angular_velocity: Vector3::new(3.0, 0.5, -0.9),
        },
        time: 0.0,
        step: 0.05,
    });
    let end = |x: &SVector<f64, 15>| {
        let tangent = x.fixed_rows::<6>(0).into_owned();
        let mut torques = torques();
        torques[3] += x.fixed_rows::<3>(6);
        let entries = SVector::<f64, 6>::from(x.fixed_rows::<6>(9));
        let tensor = case.inertia + InertiaParameters::MuJoCo.tensor(entries.into());
        let system = System::over(tensor, case.torque, Vector3::zeros());
        let start = case.state.perturbed(&tangent);
        let rollout = Rollout::new(Rk4, system, start, case.step, &torques).expect("finite");
        *rollout.states().last().expect("an end")
    };
    let base = end(&SVector::zeros());
    let cost = costs()[STEPS];
    let value = |x: &SVector<f64, 15>| SVector::from([base.difference(&end(x)).dot(&cost)]);
    let gradient = |_: &SVector<f64, 15>| {
        let torques = torques();
        let rollout = Rollout::new(Rk4, case.system(), case.state, case.step, &torques);
        let mut costs = vec![Vector6::zeros(); STEPS + 1];
        costs[STEPS] = cost;
        let found = rollout.expect("finite").gradient(&costs);
        let mut row = SMatrix::<f64, 1, 15>::zeros();
        row.fixed_columns_mut::<6>(0)
            .copy_from(&found.start.transpose());
        row.fixed_columns_mut::<3>(6)
            .copy_from(&found.torques[3].transpose());
        row.fixed_columns_mut::<6>(9)
            .copy_from(&found.inertia.transpose());
        row
    };
    let attitude = &case.state.attitude;
    let columns = [
        Slot::turn("θ", attitude),
        Slot::vector_in_body("ω", attitude),
        Slot::vector_in_body("τ", attitude),
        Slot::inertia("I", InertiaParameters::MuJoCo),
    ];
    let check = Check::default()
        .rows([Slot::scalar("cost")])
        .columns(columns);
    let report = check.of_black_box(value, gradient, &SVector::zeros());
    assert!(report.is_right(), "{report}");
}

#[test]
fn a_torque_costs_no_knowledge_of_the_axes() {
    let state = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
    let diagonal = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
    let torque = Vector3::new(0.1, 0.2, -0.3);
    let plain = System::new(diagonal, Torque::None).expect("a body");
    let pushed = plain.with_torque(torque);
    let law = Torque::Constant {
        frame: Frame::Body,
        value: torque,
    };
    let constant = System::new(diagonal, law).expect("a body");
    let apart = Rk4
        .step(&pushed, 0.0, &state, 0.01)
        .difference(&Rk4.step(&constant, 0.0, &state, 0.01));
    assert!(apart.norm() < 1e-15);
}
