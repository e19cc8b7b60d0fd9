//! One Runge–Kutta step and its Jacobian, against the same by dual numbers and by central differences.

#[path = "reference/step.rs"]
mod reference_step;

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix3, SVector, Vector6};
use polhode::motion::{Rk4, Scheme, System, Torque, jacobian};
use reference_step::{STEP, central_differences, full, principal, start};
use std::hint::black_box;

fn step(c: &mut Criterion) {
    for (name, inertia) in [("step", full()), ("step along principal axes", principal())] {
        steps(c, name, inertia);
    }
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

criterion_group!(benches, step);
criterion_main!(benches);
