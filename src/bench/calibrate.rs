//! What methods cost on the machine at hand.

use crate::bench::{Contender, Problem, measure, problems};
use crate::motion::{FreeBody, MotionError, Torque};
use crate::scene::{BOUNDS, Costs, Spin, angle, is_free};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// Evaluations of a closed form that are timed together: a clock ticks too slowly for one.
const TOGETHER: u32 = 1000;
/// Angle turned in a step of RK4.
const STEP: f64 = 0.05;

/// The costs of methods on one core of this machine, each measured for `budget` on each of the problems with a torque.
///
/// # Errors
/// None for these bodies.
pub fn calibrate(budget: Duration) -> Result<Costs, MotionError> {
    let all = problems()?;
    let (free, stepped): (Vec<_>, Vec<_>) = all
        .iter()
        .partition(|problem| is_free(&problem.member.torque));
    let (tops, damped): (Vec<_>, Vec<_>) = stepped
        .iter()
        .copied()
        .partition(|problem| matches!(problem.member.torque, Torque::Gravity { .. }));
    let by = |problems: &[&Problem], contender| {
        BOUNDS.map(|bound| per_radian(problems, contender, bound, budget))
    };
    let mut costs = Costs {
        taylor: by(&damped, Contender::Taylor),
        taylor_space: by(&tops, Contender::Taylor),
        dop853: by(&damped, Contender::Dop853),
        dop853_space: by(&tops, Contender::Dop853),
        rk4: STEP * per_radian(&stepped, Contender::Rk4, STEP, budget),
        ..Costs::default()
    };
    if let Some(problem) = free.first() {
        let (body, start) = (&problem.member.body, &problem.member.start);
        let motion = FreeBody::new(body, start);
        let more = nanoseconds(budget, |time| motion.at(time).is_ok());
        let whole = nanoseconds(budget, |time| {
            FreeBody::new(black_box(body), start).at(time).is_ok()
        });
        costs.free = [(whole - more).max(1.0), more];
        let mut about_axis = problem.member;
        about_axis.start.angular_velocity.y = 0.0;
        about_axis.start.angular_velocity.z = 0.0;
        if let Some(spin) = Spin::new(&about_axis) {
            costs.spin = nanoseconds(budget, |time| spin.at(time).is_finite());
        }
    }
    Ok(costs)
}

/// Nanoseconds for each radian turned, the geometric mean over the problems.
fn per_radian(problems: &[&Problem], contender: Contender, setting: f64, budget: Duration) -> f64 {
    let sum: f64 = problems
        .iter()
        .map(|problem| {
            let point = measure(problem, contender, setting, &problem.member.start, budget);
            (1e9 * point.seconds / angle(&problem.member, problem.duration)).ln()
        })
        .sum();
    (sum / problems.len().max(1) as f64).exp()
}

/// The least time of a call, ns.
fn nanoseconds(budget: Duration, call: impl Fn(f64) -> bool) -> f64 {
    let (begun, mut least) = (Instant::now(), f64::INFINITY);
    while least.is_infinite() || begun.elapsed() < budget {
        let start = Instant::now();
        for n in 0..TOGETHER {
            black_box(call(black_box(f64::from(n) * 0.01)));
        }
        least = least.min(start.elapsed().as_secs_f64());
    }
    1e9 * least / f64::from(TOGETHER)
}
