//! Many heavy tops, one after the other on one core.

use crate::bench::{Contender, Problem, problems};
use crate::motion::{MotionError, State};
use crate::scene::{Course, Way, distance, size};
use std::hint::black_box;
use std::time::Instant;

/// What an ensemble took by one method.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct EnsembleTime {
    /// The method.
    pub contender: Contender,
    /// Its tolerance.
    pub setting: f64,
    /// The largest error among the tops that were looked at.
    pub error: f64,
    /// The least time for all tops, s.
    pub seconds: f64,
}

/// Those that are compared: what the plan is asked for, and the rival at the loosest setting that comes to the same error.
const COMPARED: [Contender; 3] = [
    Contender::Plan,
    Contender::PlanEstimated,
    Contender::RivalDop853,
];
/// Tops whose error is looked at, and repetitions of the whole.
const LOOKED_AT: usize = 20;
const ROUNDS: u32 = 3;

/// The time that `count` heavy tops of different spin take for 10 s with an error of at most `tolerance`.
///
/// The plan has that tolerance, as a user would give it. The rival, who promises nothing of the end, has the loosest
/// tolerance with which all tops that are looked at come to it.
///
/// # Errors
/// A top whose motion is not finite: none of these.
pub fn ensemble(count: usize, tolerance: f64) -> Result<Vec<EnsembleTime>, MotionError> {
    let tops = tops(count)?;
    let sample: Vec<&Problem> = tops.iter().step_by((count / LOOKED_AT).max(1)).collect();
    let truths = sample
        .iter()
        .map(|top| Course::new(&top.member, &Way::Taylor { tolerance: 1e-16 })?.at(top.duration))
        .collect::<Result<Vec<State<f64>>, _>>()?;
    let worst = |contender: Contender, setting: f64| {
        let errors = sample.iter().zip(&truths).map(|(top, truth)| {
            let scale = size(&top.member.start.angular_velocity);
            let end = contender.end(top, setting);
            end.map_or(f64::INFINITY, |end| distance(truth, &end, scale))
        });
        errors.fold(0.0, f64::max)
    };
    let mut found: Vec<_> = COMPARED
        .iter()
        .map(|&contender| {
            let setting = match contender {
                Contender::RivalDop853 => contender
                    .settings()
                    .into_iter()
                    .find(|setting| worst(contender, *setting) <= tolerance)
                    .unwrap_or(tolerance),
                _ => tolerance,
            };
            EnsembleTime {
                contender,
                setting,
                error: worst(contender, setting),
                seconds: f64::INFINITY,
            }
        })
        .collect();
    for _ in 0..ROUNDS {
        for of in &mut found {
            let start = Instant::now();
            for top in &tops {
                black_box(of.contender.end(black_box(top), of.setting));
            }
            of.seconds = of.seconds.min(start.elapsed().as_secs_f64());
        }
    }
    Ok(found)
}

/// Copies of the heavy top of the bench, spun from 7.5 to 8.5 rad/s.
fn tops(count: usize) -> Result<Vec<Problem>, MotionError> {
    let all = problems()?;
    let of = |top: &Problem| {
        let spun = |n: usize| {
            let mut top = top.clone();
            top.member.start.angular_velocity.z = 7.5 + n as f64 / count as f64;
            top
        };
        (0..count).map(spun).collect()
    };
    let top = all.iter().find(|problem| problem.name == "top");
    Ok(top.map(of).unwrap_or_default())
}
