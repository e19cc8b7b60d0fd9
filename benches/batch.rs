//! Bodies side by side against bodies one by one, and against moving their bytes.

use criterion::{Criterion, Throughput, criterion_group, criterion_main};
use nalgebra::{Matrix3, Vector3};
use polhode::motion::{Batch, Jacobians, Rk4, Scheme, State, StepJacobian, System, Torque};
use std::hint::black_box;

const STEP: f64 = 0.01;

fn tensor() -> Matrix3<f64> {
    Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0)
}

fn states(count: usize) -> Vec<State<f64>> {
    (0..count)
        .map(|i| {
            let x = 1e-3 * (i % 1000) as f64;
            State::at_rest().turning(Vector3::new(3.0, 0.5 + x, -0.9))
        })
        .collect()
}

fn steps(c: &mut Criterion) {
    for (name, count) in [
        ("in cache", 256),
        ("30 000 bodies", 30_000),
        ("a million bodies", 1_000_000),
    ] {
        let mut group = c.benchmark_group(format!("a step of each body, {name}"));
        group.sample_size(20);
        group.throughput(Throughput::Elements(count as u64));
        let states = states(count);
        let system = System::new(tensor(), Torque::None).expect("a body");
        let mut alone = states.clone();
        group.bench_function("one by one", |b| {
            b.iter(|| {
                for state in &mut alone {
                    *state = Rk4.step(black_box(&system), 0.0, state, STEP);
                }
            });
        });
        let mut advance = |name: &str, mut batch: Batch| {
            group.bench_function(name, |b| {
                b.iter(|| batch.advance(&Rk4, Torque::None, STEP, 1).expect("finite"));
            });
        };
        let shared = |inertia| Batch::sharing(inertia, states.iter().copied()).expect("a body");
        advance("side by side", shared(tensor()));
        let principal = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
        advance("side by side, principal axes", shared(principal));
        let own = Batch::of_bodies(states.iter().map(|s| (tensor(), *s))).expect("bodies");
        advance("side by side, own tensors", own);
        let (from, mut to) = (states.clone(), states.clone());
        // In place, as the step is: every byte is read and written once.
        let mut bytes: Vec<f64> = vec![1.0; 7 * count];
        group.bench_function("the states read and written in place", |b| {
            b.iter(|| {
                for value in black_box(&mut bytes) {
                    *value += 1.0;
                }
            });
        });
        group.bench_function("copy of the states", |b| {
            b.iter(|| black_box(&mut to).copy_from_slice(black_box(&from)));
        });
        group.finish();
    }
}

fn jacobians(c: &mut Criterion) {
    for (name, count) in [("in cache", 256), ("in memory", 100_000)] {
        let mut group = c.benchmark_group(format!("a step of each body with 15 columns, {name}"));
        group.sample_size(20);
        group.throughput(Throughput::Elements(count as u64));
        let states = states(count);
        let system = System::new(tensor(), Torque::None).expect("a body");
        let mut found: Vec<StepJacobian<15>> = states
            .iter()
            .map(|s| Rk4.step_with_jacobian(&system, 0.0, s, STEP))
            .collect();
        group.bench_function("one by one", |b| {
            b.iter(|| {
                for (state, out) in states.iter().zip(&mut found) {
                    *out = Rk4.step_with_jacobian(black_box(&system), 0.0, state, STEP);
                }
            });
        });
        let mut batch = Batch::sharing(tensor(), states.iter().copied()).expect("a body");
        let mut all = Jacobians::<15>::new();
        group.bench_function("side by side", |b| {
            b.iter(|| {
                batch
                    .step_with_jacobian(&Rk4, Torque::None, STEP, &mut all)
                    .expect("finite");
            });
        });
        let (from, mut to) = (found.clone(), found.clone());
        group.bench_function("copy of the Jacobians", |b| {
            b.iter(|| black_box(&mut to).copy_from_slice(black_box(&from)));
        });
        group.finish();
    }
}

/// The same steps on one thread and on as many as the machine has.
#[cfg(feature = "parallel")]
fn threads(c: &mut Criterion) {
    const COUNT: usize = 100_000;
    let mut group = c.benchmark_group("twenty steps of 100 000 bodies");
    group.sample_size(20);
    group.throughput(Throughput::Elements(20 * COUNT as u64));
    let mut batch = Batch::sharing(tensor(), states(COUNT)).expect("a body");
    let all = std::thread::available_parallelism().map_or(1, |count| count.get());
    for count in [1, all] {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(count).build();
        let pool = pool.expect("threads");
        group.bench_function(format!("threads: {count}"), |b| {
            b.iter(|| {
                pool.install(|| batch.advance(&Rk4, Torque::None, STEP, 20))
                    .expect("finite");
            });
        });
    }
    group.finish();
}

/// One thread, which the other groups show.
#[cfg(not(feature = "parallel"))]
fn threads(_: &mut Criterion) {}

criterion_group!(benches, steps, jacobians, threads);
criterion_main!(benches);
