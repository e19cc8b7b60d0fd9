//! Derivatives of a step under laws of one's own, against the whole step on dual numbers.

use super::cases::cases;
use nalgebra::{Matrix3, SVector, Vector3, Vector6};
use num_dual::DualSVec64;
use polhode::motion::{
    Frame, Later, LinearTorque, Number, Quaternion, Rk4, Scheme, SmoothLaw, SpaceLoad, State,
    StepJacobian, System, Torque, TorqueLaw, jacobian,
};
use proptest::prelude::*;

/// A law that is linear in nothing: a drag in a wind that blows in gusts.
#[derive(Clone, Copy, Debug)]
struct Gust {
    wind: Vector3<f64>,
    added_in: Frame,
}

impl<T: Number> TorqueLaw<T> for Gust {
    fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        let (gust, _) = (time * T::of(3.0)).sin_cos();
        let omega = &state.angular_velocity;
        let seen = state.attitude.to_body(&self.wind.map(T::of)) * (gust + T::of(2.0)) - omega;
        seen.component_mul(&seen) * T::of(0.1)
    }

    fn added_in(&self) -> Frame {
        self.added_in
    }
}

/// A magnet in a field that turns, with a drag: linear in ω and in the field.
#[derive(Clone, Copy, Debug)]
struct Magnet {
    moment: Option<Vector3<f64>>,
    added_in: Frame,
}

impl Magnet {
    fn field<T: Number>(time: T) -> Vector3<T> {
        let (sine, cosine) = (time * T::of(2.0)).sin_cos();
        Vector3::new(sine, cosine, T::of(0.3))
    }
}

impl<T: Number> TorqueLaw<T> for Magnet {
    const LINEAR: bool = true;

    fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        let seen = state.attitude.to_body(&Self::field(time));
        let torque = match self.moment {
            Some(moment) => moment.map(T::of).cross(&seen),
            None => seen,
        };
        torque - state.angular_velocity * T::of(0.2)
    }

    fn added_in(&self) -> Frame {
        self.added_in
    }

    fn linear(&self, time: f64) -> Option<LinearTorque> {
        let value = Self::field(time);
        Some(LinearTorque {
            by_angular_velocity: Some(Matrix3::from_diagonal_element(-0.2)),
            load: Some(SpaceLoad {
                value,
                by_time: Vector3::new(2.0 * value.y, -2.0 * value.x, 0.0),
                arm: self.moment,
            }),
            ..LinearTorque::default()
        })
    }
}

/// A step, its Jacobian and the products of it are those of the step on dual numbers.
fn assert_derivatives<L: SmoothLaw>(
    system: &System<f64, L>,
    state: &State<f64>,
    (time, step): (f64, f64),
    direction: &SVector<f64, 16>,
    covector: &Vector6<f64>,
) {
    let dual = jacobian::by_dual_numbers::<16, _, _>(&Rk4, system, time, state, step);
    let least = system.inertia().symmetric_eigenvalues().min();
    // Rounding times the condition of the tensor, once for the moment and once for its derivative.
    let loss = (system.inertia().trace() / least).powi(2) * (1.0 + dual.matrix.amax());
    let loss = 1e-14 * loss * (1.0 + direction.amax());
    let near = |end: &State<f64>| assert!(dual.state.difference(end).amax() < loss);
    let found = Rk4.step_with_jacobian::<16>(system, time, state, step);
    near(&found.state);
    let apart = (found.matrix - dual.matrix).amax();
    assert!(
        apart < loss,
        "{apart:e} of {loss:e}: {} {}",
        found.matrix,
        dual.matrix
    );
    let (end, along) = Rk4.jvp(system, time, state, step, direction);
    near(&end);
    assert!((dual.matrix * direction - along).amax() < loss);
    let (end, back) = Rk4.vjp::<16>(system, time, state, step, covector);
    near(&end);
    assert!((dual.matrix.tr_mul(covector) - back).amax() < loss);
    let some = Rk4.step_with_jacobian::<6>(system, time, state, step);
    assert_eq!(some.matrix, found.matrix.fixed_columns::<6>(0));
}

fn vectors() -> impl Strategy<Value = Vector3<f64>> {
    prop::array::uniform3(-1.0_f64..1.0).prop_map(Vector3::from)
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(100) })]

    #[test]
    fn every_law_has_the_derivatives_of_its_step(
        case in cases(),
        (wind, added, moment) in (vectors(), vectors(), prop::option::of(vectors())),
        (in_space, principal) in (any::<bool>(), any::<bool>()),
        direction in prop::array::uniform16(-1.0_f64..1.0),
        covector in prop::array::uniform6(-1.0_f64..1.0),
    ) {
        let added_in = if in_space { Frame::Space } else { Frame::Body };
        let tensor = match principal {
            true => Matrix3::from_diagonal(&case.inertia.symmetric_eigenvalues()),
            false => case.inertia,
        };
        let (direction, covector) = (direction.into(), covector.into());
        let times = (case.time, 0.3 * case.step);
        let gust = System::new(tensor, Gust { wind, added_in }).expect("a body");
        let gust = gust.with_torque(added * 0.1);
        assert_derivatives(&gust, &case.state, times, &direction, &covector);
        let magnet = System::new(tensor, Magnet { moment, added_in }).expect("a body");
        let magnet = magnet.with_torque(added * 0.1);
        assert_derivatives(&magnet, &case.state, times, &direction, &covector);
    }
}

/// Dual numbers of another crate through the same step, in all inputs at once.
fn by_num_dual<L>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> StepJacobian<16>
where
    L: Copy + TorqueLaw<f64> + TorqueLaw<DualSVec64<16>>,
{
    let variable = |value: f64, column| DualSVec64::<16>::from_re(value).derivative(column);
    let tensor = system.inertia();
    let column = [[9, 12, 13], [12, 10, 14], [13, 14, 11]];
    let inertia = Matrix3::from_fn(|r, c| variable(tensor[(r, c)], column[r][c]));
    let half = Vector3::from_fn(|i, _| variable(0.0, i) * 0.5);
    let turn = Quaternion {
        w: Number::of(1.0),
        v: half,
    };
    let start = State {
        attitude: Quaternion::new(state.attitude.components().map(Number::of)) * turn,
        angular_velocity: Vector3::from_fn(|i, _| variable(state.angular_velocity[i], 3 + i)),
    };
    let added = Vector3::from_fn(|i, _| variable(0.0, 6 + i));
    let system = System::over(inertia, *system.law(), added);
    let end = Rk4.step(&system, Number::of(time), &start, variable(step, 15));
    let attitude = Quaternion::new(end.attitude.components().map(|c| c.re));
    let part = |c: &DualSVec64<16>, k: usize| c.eps.0.map_or(0.0, |eps| eps[k]);
    let mut matrix = nalgebra::SMatrix::<f64, 6, 16>::zeros();
    for k in 0..16 {
        let rate = Quaternion::new(end.attitude.components().map(|c| part(&c, k)));
        let theta = (attitude.conjugate() * rate).v * 2.0;
        for i in 0..3 {
            matrix[(i, k)] = theta[i];
            matrix[(3 + i, k)] = part(&end.angular_velocity[i], k);
        }
    }
    let state = State {
        attitude,
        angular_velocity: end.angular_velocity.map(|c| c.re),
    };
    StepJacobian { state, matrix }
}

proptest! {
    #![proptest_config(ProptestConfig { failure_persistence: None, ..ProptestConfig::with_cases(50) })]

    #[test]
    fn two_kinds_of_dual_numbers_agree(case in cases()) {
        let system = case.system();
        let ours = jacobian::by_dual_numbers::<16, _, _>(&Rk4, &system, case.time, &case.state, case.step);
        let other = by_num_dual(&system, case.time, &case.state, case.step);
        let least = case.inertia.symmetric_eigenvalues().min();
        let loss = 1e-14 * (case.inertia.trace() / least).powi(2) * (1.0 + other.matrix.amax());
        prop_assert!((ours.matrix - other.matrix).amax() < loss);
        prop_assert!(ours.state.difference(&other.state).amax() < loss);
    }
}

/// What a law gives for a step at once is what it gives at each time, with what is added in its axes.
#[test]
fn the_clock_of_a_law_changes_no_torque() {
    let (value, phase) = (Vector3::new(0.1, -0.2, 0.3), 0.3);
    let mut laws = vec![
        Torque::None,
        Torque::Gravity {
            weight: 9.81,
            arm: value,
        },
        Torque::Damping { coefficient: 0.2 },
    ];
    for frame in [Frame::Body, Frame::Space] {
        laws.push(Torque::Constant { frame, value });
        laws.push(Torque::Sinusoid {
            frame,
            amplitude: value,
            angular_frequency: 2.0,
            phase,
        });
    }
    let state = State {
        attitude: Quaternion::exp(&Vector3::new(0.4, -1.1, 0.7)),
        angular_velocity: Vector3::new(1.0, 0.5, -0.9),
    };
    let added = Vector3::new(-0.3, 0.1, 0.2);
    for law in laws {
        let (times, later) = ([1.0, 1.05, 1.1], Later { law, from: 40.0 });
        let after = times.map(|time| time + 40.0);
        let readings = later.clock(times);
        assert!((Vector3::from(readings) - Vector3::from(law.clock(after))).amax() < 1e-15);
        for (reading, time) in readings.into_iter().zip(after) {
            let found = later.torque_by(reading, &state, &added);
            let known = System::over(Matrix3::identity(), law, added).torque(time, &state);
            assert!((found - known).amax() < 1e-15, "{law:?}");
        }
        let apart: Option<Vec<_>> = after.iter().map(|time| linear(&law, *time)).collect();
        let together = TorqueLaw::<f64>::linear_at(&later, times).map(Vec::from);
        assert_eq!(apart, together, "{law:?}");
    }
}

fn linear(law: &Torque, time: f64) -> Option<LinearTorque> {
    TorqueLaw::<f64>::linear(law, time)
}
