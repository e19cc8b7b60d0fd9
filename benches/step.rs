//! One Runge–Kutta step and its Jacobian, against the same by dual numbers and by central differences.

#[path = "reference/step.rs"]
mod reference_step;

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix3, SVector, Vector3, Vector6};
use num_dual::{Dual64, DualSVec64};
use polhode::motion::{Frame, Number, Rk4, Scheme, State, System, Torque, TorqueLaw, jacobian};
use reference_step::{STEP, central_differences, full, principal, start};
use std::hint::black_box;

fn step(c: &mut Criterion) {
    for (name, inertia) in [("step", full()), ("step along principal axes", principal())] {
        steps(c, name, inertia);
    }
}

/// A drag that grows with the square of the spin, in a wind from the side: a law that the library does not know.
#[derive(Clone, Copy)]
struct Own;

impl<T: Number> TorqueLaw<T> for Own {
    fn torque(&self, _time: T, state: &State<T>) -> Vector3<T> {
        let wind = Vector3::new(T::of(0.3), T::of(0.0), T::of(-0.1));
        let spin = state.angular_velocity.z;
        let seen = state.attitude.to_body(&wind);
        Vector3::new(seen.x, seen.y, seen.z - spin * spin * T::of(0.02))
    }
}

/// Every law beside the free body: what the law adds to a step and its derivatives.
fn laws(c: &mut Criterion) {
    let (value, arm) = (Vector3::new(0.1, -0.2, 0.3), Vector3::new(0.05, -0.1, 0.3));
    let space = Frame::Space;
    of_law(c, "law: free", Torque::None);
    of_law(c, "law: gravity", Torque::Gravity { weight: 9.81, arm });
    of_law(
        c,
        "law: torque in space",
        Torque::Constant {
            frame: space,
            value,
        },
    );
    of_law(c, "law: damping", Torque::Damping { coefficient: 0.02 });
    let wave = Torque::Sinusoid {
        frame: space,
        amplitude: value,
        angular_frequency: 2.0,
        phase: 0.3,
    };
    of_law(c, "law: sinusoid in space", wave);
    of_law(c, "law: one's own", Own);
}

fn of_law<L>(c: &mut Criterion, name: &str, law: L)
where
    L: Copy + TorqueLaw<f64> + TorqueLaw<Dual64>,
    L: TorqueLaw<DualSVec64<6>> + TorqueLaw<DualSVec64<9>> + TorqueLaw<DualSVec64<15>>,
{
    let (system, state) = (System::new(full(), law).expect("a body"), start());
    let direction = SVector::<f64, 15>::from_fn(|i, _| 0.1 * i as f64 - 0.7);
    let covector = Vector6::from_fn(|i, _| 0.3 * i as f64 - 0.7);
    let mut group = c.benchmark_group(name);
    group.bench_function("plain", |b| {
        b.iter(|| Rk4.step(black_box(&system), 0.0, black_box(&state), STEP))
    });
    group.bench_function("6 columns", |b| {
        b.iter(|| Rk4.step_with_jacobian::<6>(black_box(&system), 0.0, black_box(&state), STEP));
    });
    group.bench_function("9 columns", |b| {
        b.iter(|| Rk4.step_with_jacobian::<9>(black_box(&system), 0.0, black_box(&state), STEP));
    });
    group.bench_function("15 columns", |b| {
        b.iter(|| Rk4.step_with_jacobian::<15>(black_box(&system), 0.0, black_box(&state), STEP));
    });
    group.bench_function("jacobian times a direction", |b| {
        let direction = black_box(&direction);
        b.iter(|| Rk4.jvp(black_box(&system), 0.0, black_box(&state), STEP, direction));
    });
    group.bench_function("a covector times the jacobian", |b| {
        let covector = black_box(&covector);
        b.iter(|| Rk4.vjp::<15>(black_box(&system), 0.0, black_box(&state), STEP, covector));
    });
    group.bench_function("15 columns by dual numbers", |b| {
        b.iter(|| {
            let system = black_box(&system);
            jacobian::by_dual_numbers::<15, _, _>(&Rk4, system, 0.0, black_box(&state), STEP)
        });
    });
    group.finish();
}

fn steps(c: &mut Criterion, name: &str, inertia: Matrix3<f64>) {
    let (system, state) = (System::new(inertia, Torque::None).expect("a body"), start());
    let direction = SVector::<f64, 15>::from_fn(|i, _| 0.1 * i as f64 - 0.7);
    let covector = Vector6::from_fn(|i, _| 0.3 * i as f64 - 0.7);
    let mut group = c.benchmark_group(name);
    group.bench_function("plain", |b| {
        b.iter(|| Rk4.step(black_box(&system), 0.0, black_box(&state), STEP))
    });
    group.bench_function("jacobian times a direction", |b| {
        b.iter(|| {
            let direction = black_box(&direction);
            Rk4.jvp(black_box(&system), 0.0, black_box(&state), STEP, direction)
        });
    });
    group.bench_function("a covector times the jacobian", |b| {
        b.iter(|| {
            let covector = black_box(&covector);
            Rk4.vjp::<15>(black_box(&system), 0.0, black_box(&state), STEP, covector)
        });
    });
    group.bench_function("jacobian of state", |b| {
        b.iter(|| Rk4.step_with_jacobian::<6>(black_box(&system), 0.0, black_box(&state), STEP));
    });
    group.bench_function("jacobian of state and torque", |b| {
        b.iter(|| Rk4.step_with_jacobian::<9>(black_box(&system), 0.0, black_box(&state), STEP));
    });
    group.bench_function("jacobian of state, torque and inertia", |b| {
        b.iter(|| Rk4.step_with_jacobian::<15>(black_box(&system), 0.0, black_box(&state), STEP));
    });
    group.bench_function("the same by dual numbers", |b| {
        b.iter(|| {
            jacobian::by_dual_numbers::<15, _, _>(
                &Rk4,
                black_box(&system),
                0.0,
                black_box(&state),
                STEP,
            )
        });
    });
    group.bench_function("the same by central differences", |b| {
        b.iter(|| central_differences(black_box(&system), black_box(&state)));
    });
    group.finish();
}

criterion_group!(benches, step, laws);
criterion_main!(benches);
