//! How far a computed state may be off the true one.

use crate::motion::{FreeBody, MotionError, State};
use crate::scene::{Course, Member, Way, plan};
use nalgebra::Vector3;

/// Rounding errors of a state that is computed once, in units of the last place.
const ROUNDING: f64 = 4.0 * f64::EPSILON;

/// Bound of a step of the companion run, against which the run itself counts as exact.
const LOOSE: [f64; 4] = [1e-4, 1e-6, 1e-9, 1e-12];
/// Above this the companion has lost the motion, and says nothing of how errors grow.
const LOST: f64 = 0.05;
/// An estimate from one other run may be off by as much.
const SAFETY: f64 = 8.0;

/// A final state and an estimate of its error.
#[derive(Clone, Copy, Debug)]
pub struct Estimated {
    /// The state at the end of the run.
    pub state: State<f64>,
    /// The larger of the attitude's error in radians and that of ω against its size; `None` where none was made.
    pub error: Option<f64>,
    /// The way that led there, its bound adapted to the tolerance.
    pub way: Way,
}

/// The larger of the attitude's distance in radians and that of ω against the larger |ω|.
pub fn distance(one: &State<f64>, other: &State<f64>, scale: f64) -> f64 {
    let tangent = one.difference(other);
    let attitude = tangent.fixed_rows::<3>(0).norm();
    let off = tangent.fixed_rows::<3>(3).norm();
    let scale = scale.max(one.angular_velocity.norm());
    let rate = if scale > 0.0 { off / scale } else { off };
    // What is no number is as far as can be.
    if attitude.is_nan() || rate.is_nan() {
        f64::INFINITY
    } else {
        attitude.max(rate)
    }
}

/// Computes the state at `duration`, with steps as small as the tolerance needs, and estimates its error.
///
/// A motion that is stepped is run a second time with a looser bound: the difference is the error of the looser run, and
/// says how the motion magnifies what each step leaves. Where the error so foreseen is above the tolerance, the run is
/// repeated with a smaller bound.
///
/// # Errors
/// A motion that stops being finite.
pub fn settle(
    member: &Member,
    way: Way,
    duration: f64,
    tolerance: f64,
) -> Result<Estimated, MotionError> {
    let mut settled = end(member, way, duration)?;
    let Some(bound) = way.step_tolerance() else {
        settled.error = closed_error(member, &way, duration);
        return Ok(settled);
    };
    let growth = growth(member, way, duration, &settled.state, bound)?;
    settled.error = Some(SAFETY * growth * bound.max(ROUNDING));
    let needed = tolerance / (SAFETY * growth);
    if needed < bound && bound > plan::LEAST {
        let bound = needed.max(plan::LEAST);
        settled = end(member, way.within(bound), duration)?;
        settled.error = Some(SAFETY * growth * bound.max(ROUNDING));
    }
    Ok(settled)
}

fn end(member: &Member, way: Way, duration: f64) -> Result<Estimated, MotionError> {
    Ok(Estimated {
        state: Course::new(member, &way)?.at(duration)?,
        error: None,
        way,
    })
}

/// The error at the end for a unit of error bound in each step, from a companion run with a looser bound.
fn growth(
    member: &Member,
    way: Way,
    duration: f64,
    state: &State<f64>,
    bound: f64,
) -> Result<f64, MotionError> {
    let scale = member.start.angular_velocity.norm();
    let mut growth = f64::INFINITY;
    for loose in LOOSE.into_iter().filter(|loose| *loose > 4.0 * bound) {
        let other = end(member, way.within(loose), duration)?;
        let off = distance(state, &other.state, scale);
        growth = off / loose;
        if off < LOST {
            break;
        }
    }
    // Two runs that agree by chance: a bound is not met better than by itself.
    Ok(growth.max(1.0))
}

/// The error of a closed form: what rounding its input would do.
fn closed_error(member: &Member, way: &Way, duration: f64) -> Option<f64> {
    match way {
        Way::Spin(spin) => {
            let speed = spin.at(duration).angular_velocity.norm();
            let speed = speed.max(member.start.angular_velocity.norm());
            Some(ROUNDING * (1.0 + speed * duration))
        }
        Way::Free => Some(free_error(member, duration)),
        _ => None,
    }
}

/// By moving the initial ω a little each way: the state after it moves by the conditioning of the problem.
fn free_error(member: &Member, duration: f64) -> f64 {
    let omega = member.start.angular_velocity;
    let speed = omega.norm();
    if speed == 0.0 {
        return ROUNDING;
    }
    let end = |omega: Vector3<f64>| {
        let start = member.start.turning(omega);
        FreeBody::new(&member.body, &start).at(duration)
    };
    let Ok(here) = end(omega) else {
        return f64::INFINITY;
    };
    let mut largest = 0.0_f64;
    for shift in [1e-9, 1e-13] {
        largest = 0.0;
        for k in 0..3 {
            let mut moved = omega;
            moved[k] += shift * speed;
            let off = end(moved).map_or(f64::INFINITY, |there| distance(&here, &there, speed));
            largest = largest.max(off / shift);
        }
        if largest * shift < LOST {
            break;
        }
    }
    ROUNDING * largest.max(1.0 + speed * duration)
}
