//! The targets of speed and the figures of this run, as a table.
//!
//! What is compared is run in turns, a little of each at a time, and medians are taken: whatever else the machine does falls
//! on all alike. Ratios are to be believed on a busy machine, nanoseconds on a quiet one.

#[path = "reference/step.rs"]
mod reference_step;
#[path = "reference/turns.rs"]
mod turns;

use nalgebra::{SVector, Vector3, Vector6};
use polhode::bench::{Contender, Point, Problem, floor, measure, problems, reference, time_to};
use polhode::motion::{
    Batch, Body, FreeBody, Jacobians, Rk4, Scheme, State, System, Torque, jacobian,
};
use reference_step::{STEP, central_differences, full, principal, start};
use std::hint::black_box;
use std::time::Duration;
use turns::{TURNS, in_turns, repeated};

fn main() {
    let quick = std::env::args().any(|arg| arg == "--quick");
    // What is timed, and compiled alone, by `cargo test`.
    if std::env::args().any(|arg| arg == "--test") {
        return;
    }
    println!("{:<66}{:>12}{:>12}", "", "figure", "target");
    step();
    batch(quick);
    free_body();
    curves(Duration::from_millis(if quick { 2 } else { 10 }));
}

/// A row: a figure that is to be at most, or at least, the target.
fn row(what: &str, figure: f64, unit: &str, target: Option<(f64, bool)>) {
    let said = match target {
        None => String::new(),
        Some((target, true)) => format!("≤ {target}"),
        Some((target, false)) => format!("≥ {target}"),
    };
    let missed = match target {
        Some((target, true)) if figure > target => "  missed",
        Some((target, false)) if figure < target => "  missed",
        _ => "",
    };
    let figure = match figure {
        f if f < 1e-3 => format!("{f:.1e}"),
        f if f < 10.0 => format!("{f:.2}"),
        f => format!("{f:.1}"),
    };
    println!(
        "{what:<66}{:>12}{said:>12}{missed}",
        format!("{figure} {unit}")
    );
}

fn at_most(target: f64) -> Option<(f64, bool)> {
    Some((target, true))
}

fn at_least(target: f64) -> Option<(f64, bool)> {
    Some((target, false))
}

fn step() {
    let state = start();
    for (axes, tensor, most) in [
        ("full tensor", full(), 140.0),
        ("principal", principal(), 105.0),
    ] {
        let system = System::new(tensor, Torque::None).expect("a body");
        let direction: SVector<f64, 15> = SVector::from_fn(|i, _| 0.1 * i as f64 - 0.7);
        let covector = Vector6::from_fn(|i, _| 0.3 * i as f64 - 0.7);
        let (system, state) = (&system, &state);
        let own = black_box((system, state));
        let [plain, matrix, along, back, dual, differences] = in_turns(
            TURNS,
            [
                repeated!(Rk4.step(black_box(own.0), 0.0, black_box(own.1), STEP)),
                repeated!(Rk4.step_with_jacobian::<15>(black_box(own.0), 0.0, own.1, STEP)),
                repeated!(Rk4.jvp(black_box(own.0), 0.0, own.1, STEP, black_box(&direction))),
                repeated!(Rk4.vjp::<15>(black_box(own.0), 0.0, own.1, STEP, black_box(&covector))),
                repeated!(jacobian::by_dual_numbers::<15, _, _>(
                    &Rk4,
                    black_box(own.0),
                    0.0,
                    own.1,
                    STEP
                )),
                repeated!(central_differences(black_box(own.0), own.1)),
            ],
        );
        let row = |what: &str, figure, unit, target| {
            row(&format!("{axes}: {what}"), figure, unit, target);
        };
        row("RK4 step", plain, "ns", None);
        row("with 15 columns", matrix, "ns", at_most(most));
        row(
            "with 15 columns, in steps",
            matrix / plain,
            "",
            at_most(3.5),
        );
        row("dual numbers against it", dual / matrix, "", at_least(3.0));
        row(
            "central differences against it",
            differences / matrix,
            "",
            at_least(10.0),
        );
        row(
            "Jacobian times a direction, in steps",
            along / plain,
            "",
            at_most(1.5),
        );
        row(
            "covector times Jacobian, in steps",
            back / plain,
            "",
            at_most(1.5),
        );
    }
}

fn batch(quick: bool) {
    for count in [256, 30_000, 1_000_000] {
        let states: Vec<_> = (0..count)
            .map(|i| {
                let y = 0.5 + 1e-3 * (i % 1000) as f64;
                State::at_rest().turning(Vector3::new(3.0, y, -0.9))
            })
            .collect();
        let each = count as f64;
        let turns = (20_000_000 / count).clamp(if quick { 5 } else { 21 }, TURNS);
        let (from, mut to) = (states.clone(), states.clone());
        let mut whole = Batch::sharing(full(), states.iter().copied()).expect("a body");
        let mut along = Batch::sharing(principal(), states).expect("a body");
        let step = |batch: &mut Batch, count: u32| {
            for _ in 0..count {
                batch.advance(&Rk4, Torque::None, STEP, 1).expect("finite");
            }
        };
        let [copy, whole, along] = in_turns(
            turns,
            [
                &mut |count| {
                    for _ in 0..count {
                        // A copy that nobody reads is not made.
                        black_box(&mut to).copy_from_slice(black_box(&from));
                    }
                },
                &mut |count| step(&mut whole, count),
                &mut |count| step(&mut along, count),
            ],
        );
        let name = format!("{count} bodies: ");
        // In the nearest memories a copy costs next to nothing, and arithmetic what it costs anywhere.
        let most = (count == 1_000_000).then_some((1.5, true));
        row(
            &format!("{name}copy of their states, a body"),
            copy / each,
            "ns",
            None,
        );
        row(
            &format!("{name}step, full tensor, a body"),
            whole / each,
            "ns",
            None,
        );
        row(&format!("{name}step, in copies"), whole / copy, "", most);
        row(
            &format!("{name}step, principal, in copies"),
            along / copy,
            "",
            most,
        );
    }
    let count = 256;
    for (name, tensor) in [("full tensor", full()), ("principal", principal())] {
        let mut bodies = Batch::sharing(tensor, vec![start(); count]).expect("a body");
        let mut out = Jacobians::<15>::new();
        let [time] = in_turns(
            TURNS,
            [repeated!(bodies.step_with_jacobian(
                &Rk4,
                Torque::None,
                STEP,
                &mut out
            ))],
        );
        let what = format!("side by side, {name}: step with 15 columns, a body");
        row(&what, time / count as f64, "ns", at_most(75.0));
    }
}

fn free_body() {
    let body = Body::new(&principal()).expect("a body");
    let (motion, state) = (FreeBody::new(&body, &start()), start());
    let [whole, more] = in_turns(
        TURNS,
        [
            repeated!(FreeBody::new(black_box(&body), black_box(&state)).at(10.0)),
            repeated!(motion.at(black_box(9.0))),
        ],
    );
    row(
        "free body: set up and one time",
        whole,
        "ns",
        at_most(600.0),
    );
    row("free body: one more time", more, "ns", at_most(100.0));
}

/// Run time against error on the problems of `polhode bench`.
fn curves(budget: Duration) {
    let methods = [
        Contender::Exact,
        Contender::Taylor,
        Contender::Dop853,
        Contender::Rk4,
        Contender::RivalDop853,
    ];
    for problem in problems().expect("bodies") {
        let truth = reference(&problem.member, &[problem.duration]).expect("a motion");
        let name = problem.name.as_str();
        if name == "top" {
            row("top: RK4 step", step_of(&problem), "ns", None);
        }
        let others = [
            Contender::Plan,
            Contender::PlanJacobian,
            Contender::RivalDifferences,
        ];
        let mut points: Vec<Point> = Vec::new();
        for contender in methods.into_iter().chain(others) {
            if contender.takes(&problem.member) {
                let settings = contender.settings();
                let point = |s| measure(&problem, contender, s, &truth[0], budget);
                points.extend(finer(&settings).map(point));
            }
        }
        for digits in [3, 6, 9, 12] {
            let error = 0.1_f64.powi(digits);
            let to = |contender| time_to(&points, name, contender, error).unwrap_or(f64::INFINITY);
            let best = methods.map(to).into_iter().fold(f64::INFINITY, f64::min);
            let plan = to(Contender::Plan);
            if plan.is_infinite() {
                continue;
            }
            let what = |what: &str| format!("{name} to 1e-{digits}: {what}");
            row(&what("plan"), 1e6 * plan, "µs", top_target(name, digits));
            row(
                &what("plan, in runs of the best method"),
                plan / best,
                "",
                at_most(1.1),
            );
            let rival = plan / to(Contender::RivalDop853);
            row(
                &what("plan, in runs of ode_solvers"),
                rival,
                "",
                at_most(1.0),
            );
            let jacobian = to(Contender::PlanJacobian) / to(Contender::RivalDifferences);
            row(
                &what("Jacobian, in 15 differences of ode_solvers"),
                jacobian,
                "",
                at_most(1.0),
            );
        }
        if let Some(least) = floor(&points, name, Contender::Plan) {
            let target = (name == "top").then_some((2e-15, true));
            row(
                &format!("{name}: least error of the plan"),
                least,
                "",
                target,
            );
        }
    }
}

/// Settings with one more between any two: what is lucky at one of them is not a tenth of the time.
fn finer(settings: &[f64]) -> impl Iterator<Item = f64> + '_ {
    let between = settings.windows(2).map(|pair| (pair[0] * pair[1]).sqrt());
    settings.iter().copied().chain(between)
}

/// Nanoseconds for a step of RK4 on a problem, by which machines can be compared.
fn step_of(problem: &Problem) -> f64 {
    let system = System::principal(&problem.member.body, problem.member.torque);
    let [step] = in_turns(
        TURNS,
        [repeated!(Rk4.step(
            black_box(&system),
            0.0,
            black_box(&problem.member.start),
            STEP
        ))],
    );
    step
}

/// The times that are asked of the heavy top, µs.
fn top_target(name: &str, digits: i32) -> Option<(f64, bool)> {
    match (name, digits) {
        ("top", 6) => at_most(20.0),
        ("top", 12) => at_most(43.0),
        _ => None,
    }
}
