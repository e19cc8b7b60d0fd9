//! Time and error of one method at one setting.

use crate::bench::{Contender, Problem};
use crate::motion::State;
use crate::scene::{Balance, distance, size};
use std::hint::black_box;
use std::time::{Duration, Instant};

/// One point of a work-precision diagram.
#[derive(Clone, Debug, PartialEq)]
pub struct Point {
    /// The problem.
    pub problem: String,
    /// The method.
    pub contender: Contender,
    /// Its tolerance, or the angle turned in a step.
    pub setting: f64,
    /// The least time of one run, s.
    pub seconds: f64,
    /// The larger of the attitude's error in radians and that of ω against its size; infinite where the method failed.
    pub error: f64,
    /// The drift of the energy, where it is conserved.
    pub energy_drift: Option<f64>,
    /// The drift of the angular momentum, where it is known.
    pub momentum_drift: Option<f64>,
}

/// Repetitions of one run, at least and at most.
const FEWEST: u32 = 3;
const MOST: u32 = 2000;

/// Runs a method on a problem again and again within `budget`, and compares the end with `truth`. The least time counts:
/// whatever disturbs a run makes it longer.
pub fn measure(
    problem: &Problem,
    contender: Contender,
    setting: f64,
    truth: &State<f64>,
    budget: Duration,
) -> Point {
    let begun = Instant::now();
    let (mut least, mut end) = (f64::INFINITY, None);
    for count in 0..MOST {
        let start = Instant::now();
        end = contender.end(black_box(problem), black_box(setting));
        least = least.min(start.elapsed().as_secs_f64());
        let spent = begun.elapsed();
        // One long run is enough to know that it is long.
        if end.is_none() || spent > budget && (count + 1 >= FEWEST || spent > 4 * budget) {
            break;
        }
    }
    let scale = size(&problem.member.start.angular_velocity);
    let balance = Balance::new(&problem.member);
    Point {
        problem: problem.name.clone(),
        contender,
        setting,
        seconds: least,
        error: end.map_or(f64::INFINITY, |end| distance(truth, &end, scale)),
        energy_drift: end.and_then(|end| balance.energy_drift(&end)),
        momentum_drift: end.and_then(|end| balance.momentum_drift(problem.duration, &end)),
    }
}

/// The least time within which a method came to an error of at most `error` on a problem.
pub fn time_to(points: &[Point], problem: &str, contender: Contender, error: f64) -> Option<f64> {
    let fit = |p: &&Point| p.problem == problem && p.contender == contender && p.error <= error;
    points
        .iter()
        .filter(fit)
        .map(|p| p.seconds)
        .min_by(f64::total_cmp)
}

/// The least error to which a method came on a problem.
pub fn floor(points: &[Point], problem: &str, contender: Contender) -> Option<f64> {
    let of = |p: &&Point| p.problem == problem && p.contender == contender;
    points
        .iter()
        .filter(of)
        .map(|p| p.error)
        .min_by(f64::total_cmp)
}
