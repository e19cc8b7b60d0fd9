//! The exact free body and Taylor motion against DOP853 of `ode_solvers`, each with the error that it ends with.
//!
//! The errors are printed before the times: of ω against its size and of the attitude in radians, the larger, against the
//! exact free body, or for the heavy top against steps of order 30 and 0.01 s.

use criterion::{
    BenchmarkGroup, Criterion, criterion_group, criterion_main, measurement::WallTime,
};
use nalgebra::{Matrix3, Vector3};
use ode_solvers::dop_shared::OutputType;
use ode_solvers::{Dop853, SVector, System as Equations};
use polhode::motion::{
    Body, Dop853Motion, FixedStep, FreeBody, Quaternion, State, Stepper, System, Taylor,
    TaylorMotion, Torque,
};
use std::hint::black_box;

type Vector7 = SVector<f64, 7>;

/// The heavy top (free at weight 0) as a user writes it down for a solver.
struct Rival {
    weight: f64,
    arm: Vector3<f64>,
}

impl Equations<f64, Vector7> for Rival {
    fn system(&self, _: f64, y: &Vector7, dy: &mut Vector7) {
        let (w, x, yq, z) = (y[3], y[4], y[5], y[6]);
        let down = Vector3::new(
            -2.0 * (x * z - w * yq),
            -2.0 * (yq * z + w * x),
            -(w * w - x * x - yq * yq + z * z),
        ) * self.weight;
        let m = self.arm.cross(&down);
        dy[0] = (m.x - 0.2 * y[1] * y[2]) / 0.6;
        dy[1] = (m.y + 0.4 * y[2] * y[0]) / 0.8;
        dy[2] = m.z - 0.2 * y[0] * y[1];
        dy[3] = -0.5 * (x * y[0] + yq * y[1] + z * y[2]);
        dy[4] = 0.5 * (w * y[0] + yq * y[2] - z * y[1]);
        dy[5] = 0.5 * (w * y[1] + z * y[0] - x * y[2]);
        dy[6] = 0.5 * (w * y[2] + x * y[1] - yq * y[0]);
    }
}

fn body() -> Body {
    Body::new(&Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0))).expect("a body")
}

fn rival(weight: f64, omega: [f64; 3], tolerance: f64) -> State<f64> {
    let equations = Rival {
        weight,
        arm: Vector3::new(0.1, -0.2, 1.0),
    };
    let start = Vector7::from_column_slice(&[omega[0], omega[1], omega[2], 1.0, 0.0, 0.0, 0.0]);
    let mut solver = Dop853::new(equations, 0.0, 10.0, 10.0, start, tolerance, tolerance);
    // Its dense output over one interval would extrapolate its first step.
    solver.set_output(OutputType::Sparse);
    solver.integrate().expect("solved");
    let y = solver.y_out().last().expect("an end");
    State {
        attitude: Quaternion::new([y[3], y[4], y[5], y[6]]).normalised(),
        angular_velocity: Vector3::new(y[0], y[1], y[2]),
    }
}

fn by_taylor(body: &Body, law: Torque, start: &State<f64>, tolerance: f64) -> State<f64> {
    let mut motion = TaylorMotion::new(body, law, start, tolerance).expect("a motion");
    motion.advance_to(10.0).expect("finite");
    *motion.state()
}

fn by_dop853(body: &Body, law: Torque, start: &State<f64>, tolerance: f64) -> State<f64> {
    let system = System::principal(body, law);
    let mut motion =
        Dop853Motion::new(system, &body.state_along(start), tolerance).expect("a motion");
    motion.advance_to(10.0).expect("finite");
    body.state_from(motion.state())
}

fn error(exact: &State<f64>, found: &State<f64>) -> f64 {
    let apart = exact.difference(found);
    let speed = exact.angular_velocity.norm();
    apart.rows(0, 3).norm().max(apart.rows(3, 3).norm() / speed)
}

/// A way to the end of a motion.
type Way<'a> = &'a dyn Fn(&State<f64>) -> State<f64>;

fn compare(
    group: &mut BenchmarkGroup<'_, WallTime>,
    name: String,
    (start, exact): (&State<f64>, &State<f64>),
    way: Way<'_>,
) {
    println!("{name}: error {:.1e}", error(exact, &way(start)));
    group.bench_function(name, |b| b.iter(|| way(black_box(start))));
}

fn free(c: &mut Criterion) {
    let omega = [3.0, 0.5, -0.9];
    let (body, start) = (body(), State::at_rest().turning(omega.into()));
    let mut group = c.benchmark_group("free body to t = 10");
    group.bench_function("exact, set up and one time", |b| {
        b.iter(|| FreeBody::new(black_box(&body), black_box(&start)).at(10.0));
    });
    let motion = FreeBody::new(&body, &start);
    group.bench_function("exact, one more time", |b| {
        b.iter(|| motion.at(black_box(9.0)))
    });
    let exact = motion.at(10.0).expect("finite");
    rivals(&mut group, &body, Torque::None, (&start, &exact));
    group.finish();
}

fn top(c: &mut Criterion) {
    let (body, start) = (
        body(),
        State::at_rest().turning(Vector3::new(1.0, -2.0, 8.0)),
    );
    let law = Torque::Gravity {
        weight: 1.0,
        arm: Vector3::new(0.1, -0.2, 1.0),
    };
    let system = System::new(*body.inertia(), law).expect("a body");
    let mut fine = FixedStep::new(Taylor::of_order(30), system, start, 0.01).expect("a step");
    fine.advance_to(10.0).expect("finite");
    let mut group = c.benchmark_group("heavy top to t = 10");
    rivals(&mut group, &body, law, (&start, fine.state()));
    group.finish();
}

fn rivals(
    group: &mut BenchmarkGroup<'_, WallTime>,
    body: &Body,
    law: Torque,
    ends: (&State<f64>, &State<f64>),
) {
    let weight = match law {
        Torque::Gravity { weight, .. } => weight,
        _ => 0.0,
    };
    for tolerance in [1e-6, 1e-9, 1e-12] {
        compare(group, format!("Taylor {tolerance:e}"), ends, &|start| {
            by_taylor(body, law, start, tolerance)
        });
        compare(group, format!("DOP853 {tolerance:e}"), ends, &|start| {
            by_dop853(body, law, start, tolerance)
        });
        let name = format!("DOP853 of ode_solvers {tolerance:e}");
        compare(group, name, ends, &|start| {
            rival(weight, start.angular_velocity.into(), tolerance)
        });
    }
}

criterion_group!(benches, free, top);
criterion_main!(benches);
