//! Derivatives of a trajectory in what its system is made of, against values alone.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};
use num_dual::Dual64;
use polhode::jacobian::{Check, Slot, Verdict};
use polhode::mechanics::InertiaParameters;
use polhode::motion::{
    Frame, ImplicitMidpoint, Law, Number, Quaternion, Rk4, Rollout, Scheme, SmoothLaw, State,
    System, Torque, TorqueLaw,
};
use polhode::scalar::Jet;

fn inertia() -> Matrix3<f64> {
    Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0)
}

fn start() -> State<f64> {
    State {
        attitude: Quaternion::exp(&Vector3::new(0.4, -1.1, 0.7)),
        angular_velocity: Vector3::new(1.0, 0.5, -0.9),
    }
}

/// The derivatives of a system of parameters, given over doubles and over variables.
fn assert_derivatives<const P: usize, L: SmoothLaw, K: Copy + TorqueLaw<Jet<f64, P>>>(
    constant: impl Fn([f64; P]) -> System<f64, L>,
    variable: impl Fn([Jet<f64, P>; P]) -> System<Jet<f64, P>, K> + Copy,
    at: [f64; P],
    names: [&str; P],
) {
    let torques = [Vector3::new(0.1, -0.2, 0.3); 8];
    let rollout = |values: &SVector<f64, P>| {
        let system = constant((*values).into());
        Rollout::new(Rk4, system, start(), 0.05, &torques).expect("finite")
    };
    let point = SVector::from(at);
    let base = rollout(&point);
    let found: SMatrix<f64, 6, P> = base.by_parameters(variable, at).last().expect("a step");
    let end = |values: &SVector<f64, P>| base.end().difference(&rollout(values).end());
    let report = Check::default()
        .columns(names.map(Slot::scalar))
        .of_black_box(end, |_| found, &point);
    assert_ne!(report.verdict(), Verdict::Wrong, "{report}");
    assert!(
        found.column_iter().all(|column| column.amax() > 1e-6),
        "{found}"
    );
    let costs: Vec<_> = (0..=torques.len())
        .map(|k| Vector6::from_fn(|i, _| (0.7 * (6 * k + i) as f64).cos()))
        .collect();
    let gradient = base.gradient_by_parameters(&costs, variable, at);
    let chained: SVector<f64, P> = base
        .by_parameters(variable, at)
        .zip(&costs[1..])
        .map(|(state, cost)| state.tr_mul(cost))
        .sum();
    assert!((gradient.parameters - chained).amax() < 1e-13 * (1.0 + chained.amax()));
    let plain = base.gradient(&costs);
    assert_eq!(
        (gradient.start, gradient.inertia),
        (plain.start, plain.inertia)
    );
    let cost = |values: SVector<f64, P>| -> f64 {
        let moved = rollout(&values);
        let apart = base.states().iter().zip(moved.states());
        apart
            .zip(&costs)
            .map(|((a, b), cost)| a.difference(b).dot(cost))
            .sum()
    };
    assert_limit(&gradient.parameters, cost, &point);
}

/// Central differences come nearer to the gradient by the square of their step.
fn assert_limit<const P: usize>(
    gradient: &SVector<f64, P>,
    cost: impl Fn(SVector<f64, P>) -> f64,
    point: &SVector<f64, P>,
) {
    let off = |step: f64| {
        let along = |i: usize, step: f64| {
            let mut moved = *point;
            moved[i] += step;
            cost(moved)
        };
        let quotient = SVector::from_fn(|i, _| (along(i, step) - along(i, -step)) / (2.0 * step));
        (quotient - gradient).amax()
    };
    let (coarse, fine) = (off(2e-2), off(1e-2));
    assert!((3.8..4.2).contains(&(coarse / fine)), "{coarse} {fine}");
}

fn of_tensor<T: Number, L: TorqueLaw<T>>(law: L) -> System<T, L> {
    System::over(inertia().map(T::of), law, Vector3::from_element(T::of(0.0)))
}

#[test]
fn damping() {
    fn system<T: Number>([coefficient]: [T; 1]) -> System<T, Law<T>>
    where
        Law<T>: TorqueLaw<T>,
    {
        of_tensor(Law::Damping { coefficient })
    }
    assert_derivatives(system::<f64>, system, [0.3], ["c"]);
}

#[test]
fn weight_and_arm() {
    fn system<T: Number>([weight, x, y, z]: [T; 4]) -> System<T, Law<T>>
    where
        Law<T>: TorqueLaw<T>,
    {
        let arm = Vector3::new(x, y, z);
        of_tensor(Law::Gravity { weight, arm })
    }
    assert_derivatives(
        system::<f64>,
        system,
        [9.81, 0.05, -0.1, 0.3],
        ["w", "x", "y", "z"],
    );
}

#[test]
fn amplitude_frequency_and_phase() {
    fn system<T: Number>([x, y, z, angular_frequency, phase]: [T; 5]) -> System<T, Law<T>>
    where
        Law<T>: TorqueLaw<T>,
    {
        of_tensor(Law::Sinusoid {
            frame: Frame::Space,
            amplitude: Vector3::new(x, y, z),
            angular_frequency,
            phase,
        })
    }
    let names = ["x", "y", "z", "w", "φ"];
    assert_derivatives(system::<f64>, system, [0.1, -0.2, 0.3, 2.0, 0.3], names);
}

#[test]
fn a_constant_torque_and_the_tensor() {
    fn system<T: Number>([x, y, z, entries @ ..]: [T; 9]) -> System<T, Law<T>>
    where
        Law<T>: TorqueLaw<T>,
    {
        let law = Law::Constant {
            frame: Frame::Space,
            value: Vector3::new(x, y, z),
        };
        let tensor = InertiaParameters::MuJoCo.tensor(entries);
        System::over(tensor, law, Vector3::from_element(T::of(0.0)))
    }
    let names = ["x", "y", "z", "xx", "yy", "zz", "xy", "xz", "yz"];
    let at = [0.1, -0.2, 0.3, 0.6, 0.8, 1.0, 0.02, -0.03, 0.05];
    assert_derivatives(system::<f64>, system, at, names);
}

/// A method that knows no better takes the whole step on dual numbers, and the gradient is that of the chained Jacobians as well.
#[test]
fn by_any_method() {
    fn system<T: Number>([coefficient]: [T; 1]) -> System<T, Law<T>>
    where
        Law<T>: TorqueLaw<T>,
    {
        of_tensor(Law::Damping { coefficient })
    }
    let torques = [Vector3::new(0.1, -0.2, 0.3); 8];
    let rollout = Rollout::new(ImplicitMidpoint, system([0.3]), start(), 0.05, &torques);
    let rollout = rollout.expect("finite");
    let mut costs = [Vector6::zeros(); 9];
    costs[8] = Vector6::new(0.3, -0.2, 0.5, 1.0, -0.7, 0.4);
    let gradient = rollout.gradient_by_parameters(&costs, system, [0.3]);
    let end = rollout.by_parameters(system, [0.3]).last();
    let chained = end.expect("a step").tr_mul(&costs[8]);
    assert!((gradient.parameters - chained).amax() < 1e-13);
    assert!(chained.amax() > 1e-3);
}

/// What is a variable has the same value as what is a constant, and its derivatives besides.
#[test]
fn variables_change_no_value() {
    let laws: [(Torque, Law<Dual64>); 2] = [
        (
            Law::Gravity {
                weight: 9.81,
                arm: Vector3::new(0.05, -0.1, 0.3),
            },
            Law::Gravity {
                weight: Dual64::new(9.81, 1.0),
                arm: Vector3::new(0.05, -0.1, 0.3).map(Dual64::from),
            },
        ),
        (
            Law::Damping { coefficient: 0.3 },
            Law::Damping {
                coefficient: Dual64::new(0.3, 1.0),
            },
        ),
    ];
    for (constant, variable) in laws {
        let plain = Rk4.step(&of_tensor(constant), 0.0, &start(), 0.05);
        let lifted = State {
            attitude: Quaternion::new(start().attitude.components().map(Dual64::from)),
            angular_velocity: start().angular_velocity.map(Dual64::from),
        };
        let end = Rk4.step(&of_tensor(variable), 0.0.into(), &lifted, 0.05.into());
        let off = end.angular_velocity.map(|c| c.re) - plain.angular_velocity;
        assert!(off.amax() < 1e-14);
        assert!(end.angular_velocity.iter().all(|c| c.eps.abs() > 1e-6));
    }
}

/// The tensor's columns are those of the Jacobian of each step.
#[test]
fn the_tensor_by_either_way() {
    let torques = [Vector3::new(0.1, -0.2, 0.3); 8];
    let rollout = Rollout::new(Rk4, of_tensor(Torque::None), start(), 0.05, &torques);
    let rollout = rollout.expect("finite");
    let entries = InertiaParameters::MuJoCo.of_tensor(&inertia());
    let system = |entries: [Jet<f64, 6>; 6]| {
        let tensor = InertiaParameters::MuJoCo.tensor(entries);
        System::over(tensor, Torque::None, Vector3::zeros())
    };
    let by_parameters: Vec<SMatrix<f64, 6, 6>> = rollout.by_parameters(system, entries).collect();
    let steps = polhode::optimise::from_start(rollout.jacobians::<15>());
    let by_inertia = rollout.by_inertia().zip(by_parameters);
    for (step, (by_inertia, by_parameters)) in steps.zip(by_inertia) {
        assert!((step.by_inertia() - by_inertia).amax() < 1e-14);
        assert!((by_inertia - by_parameters).amax() < 1e-13);
    }
}
