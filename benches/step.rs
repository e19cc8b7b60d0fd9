//! One Runge–Kutta step and its Jacobian, against the same by dual numbers and by central differences.

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};
use polhode::motion::{Rk4, Scheme, State, System, Torque, jacobian};
use std::hint::black_box;

const STEP: f64 = 0.01;

fn full() -> Matrix3<f64> {
    Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0)
}

fn state() -> State<f64> {
    State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9))
}

/// Fifteen columns by thirty steps.
fn central_differences(system: &System<f64, Torque>, state: &State<f64>) -> SMatrix<f64, 6, 15> {
    let width = 6e-6;
    let base = Rk4.step(system, 0.0, state, STEP);
    let end = |column: usize, amount: f64| {
        let (mut inertia, mut added, mut tangent) =
            (*system.inertia(), Vector3::zeros(), Vector6::zeros());
        match column {
            0..6 => tangent[column] = amount,
            6..9 => added[column - 6] = amount,
            9..12 => inertia[(column - 9, column - 9)] += amount,
            _ => {
                let (r, c) = [(0, 1), (0, 2), (1, 2)][column - 12];
                inertia[(r, c)] += amount;
                inertia[(c, r)] += amount;
            }
        }
        let moved = System::over(inertia, Torque::None, added);
        base.difference(&Rk4.step(&moved, 0.0, &state.perturbed(&tangent), STEP))
    };
    SMatrix::from_columns(&std::array::from_fn::<_, 15, _>(|c| {
        (end(c, width) - end(c, -width)) / (2.0 * width)
    }))
}

fn step(c: &mut Criterion) {
    let principal = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
    for (name, inertia) in [("step", full()), ("step along principal axes", principal)] {
        steps(c, name, inertia);
    }
}

fn steps(c: &mut Criterion, name: &str, inertia: Matrix3<f64>) {
    let (system, state) = (System::new(inertia, Torque::None).expect("a body"), state());
    let direction = SVector::from_fn(|i, _| 0.1 * i as f64 - 0.7);
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
            Rk4.vjp(black_box(&system), 0.0, black_box(&state), STEP, covector)
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
