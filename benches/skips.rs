//! What each skip of the plan is worth: the planned run beside the same run without the skip.

use criterion::{Criterion, criterion_group, criterion_main};
use nalgebra::{Matrix3, Vector3};
use polhode::mechanics::Products;
use polhode::motion::{Body, Frame, State, Torque};
use polhode::motion::{Dop853Motion, FixedStep, Rk4, Stepper, System, Taylor};
use polhode::scene::{
    self, Course, Group, Member, Outcome, Row, Scene, Sink, Way, Wrt, sensitivity, simulate,
};
use polhode::source::Source;
use std::convert::Infallible;
use std::hint::black_box;
use std::time::Duration;

const TOLERANCE: f64 = 1e-10;
const DURATION: f64 = 10.0;

fn member(tensor: Matrix3<f64>, omega: [f64; 3], torque: Torque) -> Member {
    Member {
        body: Body::new(&tensor).expect("a body"),
        start: State::at_rest().turning(omega.into()),
        torque,
    }
}

fn diagonal(moments: [f64; 3]) -> Matrix3<f64> {
    Matrix3::from_diagonal(&moments.into())
}

/// With products of inertia, far from its principal axes.
fn full() -> Matrix3<f64> {
    Matrix3::new(0.7, 0.05, -0.08, 0.05, 0.8, 0.06, -0.08, 0.06, 0.9)
}

fn top() -> Torque {
    Torque::Gravity {
        weight: 1.0,
        arm: Vector3::new(0.1, -0.2, 1.0),
    }
}

const DAMPING: Torque = Torque::Damping { coefficient: 0.1 };

/// What the scene's plan makes of a member, and the same by Taylor series.
fn closed_form(c: &mut Criterion) {
    let across = [3.0, 0.5, -0.9];
    let cases = [
        ("sphere", member(diagonal([1.0; 3]), across, Torque::None)),
        ("damped sphere", member(diagonal([1.0; 3]), across, DAMPING)),
        (
            "pure spin, damped",
            member(diagonal([0.6, 0.8, 1.0]), [0.0, 3.0, 0.0], DAMPING),
        ),
        ("free body", member(full(), across, Torque::None)),
    ];
    for (name, member) in cases {
        let mut group = c.benchmark_group(name);
        let spin = scene::Spin::new(&member).map(Way::Spin);
        let planned = spin.unwrap_or(Way::Free);
        let stepped = Way::Taylor {
            tolerance: 0.05 * TOLERANCE,
        };
        for (which, way) in [("skipped", planned), ("unskipped, Taylor", stepped)] {
            group.bench_function(which, |b| {
                b.iter(|| Course::new(black_box(&member), &way).and_then(|mut c| c.at(DURATION)));
            });
        }
        group.finish();
    }
}

/// Of worth to the series, which need not square ω. A stage of a Runge–Kutta method is mostly attitude and torque: there the
/// principal axes are for the digits of a needle, and cost nothing.
fn principal_axes(c: &mut Criterion) {
    let top = member(full(), [1.0, -2.0, 8.0], top());
    let inner = top.body.state_along(&top.start);
    let system = || System::new(*top.body.inertia(), top.torque).expect("a body");
    let principal = || System::principal(&top.body, top.torque);
    let rk4 = |system, start| {
        let mut motion = FixedStep::new(Rk4, system, start, 0.01).expect("a motion");
        motion.advance_to(DURATION).map(|()| *motion.state())
    };
    let dop853 = |system, start: &State<f64>| {
        let mut motion = Dop853Motion::new(system, start, TOLERANCE).expect("a motion");
        motion.advance_to(DURATION).map(|()| *motion.state())
    };
    let taylor = |system, start| {
        let mut motion =
            FixedStep::new(Taylor::of_order(16), system, start, 0.1).expect("a motion");
        motion.advance_to(DURATION).map(|()| *motion.state())
    };
    let mut group = c.benchmark_group("principal axes");
    group.bench_function("skipped, Taylor", |b| b.iter(|| taylor(principal(), inner)));
    group.bench_function("unskipped, Taylor", |b| {
        b.iter(|| taylor(system(), top.start))
    });
    group.bench_function("skipped, RK4", |b| b.iter(|| rk4(principal(), inner)));
    group.bench_function("unskipped, RK4", |b| b.iter(|| rk4(system(), top.start)));
    group.bench_function("skipped, DOP853", |b| {
        b.iter(|| dop853(principal(), &inner))
    });
    group.bench_function("unskipped, DOP853", |b| {
        b.iter(|| dop853(system(), &top.start))
    });
    group.finish();
}

/// Where the torque does not look at the attitude, and nobody asks for it.
fn attitude(c: &mut Criterion) {
    let damped = member(full(), [3.0, 0.5, -0.9], DAMPING);
    let way = Way::Taylor {
        tolerance: 0.05 * TOLERANCE,
    };
    let mut group = c.benchmark_group("attitude");
    for (which, asked) in [("skipped", false), ("unskipped", true)] {
        group.bench_function(which, |b| {
            b.iter(|| {
                let course = Course::new(black_box(&damped), &way);
                let course = course.map(|c| if asked { c } else { c.without_attitude() });
                course.and_then(|mut course| course.at(DURATION))
            });
        });
    }
    group.finish();
}

fn columns(c: &mut Criterion) {
    let body = Torque::Constant {
        frame: Frame::Body,
        value: Vector3::new(0.1, 0.2, -0.1),
    };
    let member = member(full(), [3.0, 0.5, -0.9], body);
    let end = Course::new(&member, &Way::Taylor { tolerance: 1e-12 })
        .and_then(|mut course| course.at(DURATION))
        .expect("finite");
    let only = |which: &str| Wrt {
        attitude: which == "attitude",
        angular_velocity: which == "angular velocity",
        torque: which == "torque",
        inertia: which == "inertia",
        dt: which == "duration",
    };
    let mut group = c.benchmark_group("Jacobian columns");
    group.bench_function("none skipped", |b| {
        let products = Products::Integrals;
        b.iter(|| {
            sensitivity(
                black_box(&member),
                &Wrt::ALL,
                products,
                DURATION,
                &end,
                1e-12,
            )
        });
    });
    for which in [
        "attitude",
        "angular velocity",
        "torque",
        "inertia",
        "duration",
    ] {
        let wrt = only(which);
        group.bench_function(format!("all but {which} skipped"), |b| {
            let products = Products::Integrals;
            b.iter(|| sensitivity(black_box(&member), &wrt, products, DURATION, &end, 1e-12));
        });
    }
    group.finish();
}

/// Counts what comes, or keeps it.
struct Counted {
    bodies: u64,
    rows: u64,
    kept: Option<Vec<Row>>,
}

impl Sink for Counted {
    type Error = Infallible;

    fn begin(&mut self, _: &Group, _: u64) -> Result<(), Infallible> {
        Ok(())
    }

    fn row(&mut self, row: &Row) -> Result<(), Infallible> {
        self.rows += 1;
        if let Some(kept) = &mut self.kept {
            kept.push(*row);
        }
        Ok(())
    }

    fn end(&mut self, outcome: &Outcome) -> Result<(), Infallible> {
        black_box(outcome);
        self.bodies += 1;
        Ok(())
    }
}

fn scene(bodies: &str, run: &str) -> Scene {
    let text = format!("[[body]]\nname = 'a'\n{bodies}\n[run]\nduration = 10\n{run}\n");
    scene::read(&Source::new("scene.toml", text)).expect("a good scene")
}

fn ran(scene: &Scene, keep: bool) -> Counted {
    let mut counted = Counted {
        bodies: 0,
        rows: 0,
        kept: keep.then(Vec::new),
    };
    let Ok(complete) = simulate(scene, &mut counted) else {
        return counted;
    };
    assert!(complete);
    counted
}

const TOP: &str = "inertia = { xx = 0.6, yy = 0.8, zz = 1.0 }\n\
                   torque = { kind = 'gravity', weight = 1, arm = [0.1, -0.2, 1] }\n\
                   angular_velocity = [1, -2, { from = 7.5, to = 8.5 }]";

fn trajectory(c: &mut Criterion) {
    let run = |outputs: &str| {
        scene(
            TOP,
            &format!("output_interval = 1e-4\noutputs = [{outputs}]\nestimate_error = false"),
        )
    };
    let (last, rows) = (run("'final'"), run("'trajectory'"));
    let mut group = c.benchmark_group("trajectory of 100 000 rows");
    group.bench_function("skipped, final state alone", |b| {
        b.iter(|| ran(&last, false))
    });
    group.bench_function("skipped storage, rows as they come", |b| {
        b.iter(|| ran(&rows, false))
    });
    group.bench_function("unskipped, rows kept", |b| b.iter(|| ran(&rows, true)));
    group.finish();
}

fn ensembles(c: &mut Criterion) {
    let throw = "inertia = { xx = 2.0, yy = 3.0, zz = 4.0, xy = 0.1 }\ncount = 100000\nseed = 2026\n\
                 angular_velocity = [{ mean = 0.0, deviation = 0.05 }, { from = 2.9, to = 3.1 }, \
                 { mean = 0.0, deviation = 0.05 }]";
    let tops = format!("{TOP}\ncount = 10000");
    let mut group = c.benchmark_group("ensembles");
    group
        .sample_size(10)
        .measurement_time(Duration::from_secs(8));
    for (which, run) in [
        ("with the estimate of the error", ""),
        ("without", "estimate_error = false"),
    ] {
        let free = scene(throw, run);
        group.bench_function(format!("100 000 free bodies, {which}"), |b| {
            b.iter(|| ran(&free, false))
        });
        let tops = scene(&tops, &format!("tolerance = 1e-9\n{run}"));
        group.bench_function(format!("10 000 heavy tops, {which}"), |b| {
            b.iter(|| ran(&tops, false))
        });
    }
    group.finish();
}

criterion_group!(
    benches,
    closed_form,
    principal_axes,
    attitude,
    columns,
    trajectory,
    ensembles
);
criterion_main!(benches);
