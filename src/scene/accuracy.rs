//! How far a computed state may be off the true one.

use crate::motion::{MotionError, State};
use crate::scene::conditioning::free_error;
use crate::scene::{Course, Member, Way, plan};
use nalgebra::Vector3;

/// Rounding errors of a state that is computed once, in units of the last place; 16 were met in random scenes, against
/// thirty digits.
pub(crate) const ROUNDING: f64 = 18.0 * f64::EPSILON;

/// Bound of a step of the companion run, against which the run itself counts as exact.
const LOOSE: [f64; 4] = [1e-4, 1e-6, 1e-9, 1e-12];
/// What a companion's bound is of the run's own where there is none to loosen.
const TIGHTER: f64 = 0.01;
/// Above this the companion has lost the motion, and says nothing of how errors grow.
pub(crate) const LOST: f64 = 0.05;
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

/// |v|, without squares that overflow.
pub fn size(v: &Vector3<f64>) -> f64 {
    v.x.hypot(v.y).hypot(v.z)
}

/// The larger of the attitude's distance in radians and that of ω against the larger |ω|.
pub fn distance(one: &State<f64>, other: &State<f64>, scale: f64) -> f64 {
    let tangent = one.difference(other);
    let attitude = size(&tangent.fixed_rows::<3>(0).into_owned());
    let off = size(&tangent.fixed_rows::<3>(3).into_owned());
    let scale = scale.max(size(&one.angular_velocity));
    let rate = if scale > 0.0 { off / scale } else { off };
    // What is no number is as far as can be.
    if attitude.is_nan() || rate.is_nan() {
        f64::INFINITY
    } else {
        attitude.max(rate)
    }
}

/// Why no final state was found.
#[derive(Clone, Debug, PartialEq)]
pub enum Unsettled {
    /// The motion stops being finite, or takes too many steps.
    Motion(MotionError),
    /// It was stopped from outside.
    Stopped,
}

impl From<MotionError> for Unsettled {
    fn from(error: MotionError) -> Self {
        Self::Motion(error)
    }
}

/// Computes the state at `duration`, with steps as small as the tolerance needs, and estimates its error.
///
/// A motion that is stepped is run a second time with a looser bound: the difference is the error of the looser run, and
/// says how the motion magnifies what each step leaves. Where the error so foreseen is above the tolerance, the run is
/// repeated with a smaller bound. `stop` is asked from time to time whether to give up.
///
/// # Errors
/// A motion that stops being finite; a stop.
pub fn settle(
    member: &Member,
    way: Way,
    duration: f64,
    tolerance: f64,
    stop: &dyn Fn() -> bool,
) -> Result<Estimated, Unsettled> {
    let mut settled = end(member, way, duration, stop)?;
    let Some(bound) = way.step_tolerance() else {
        settled.error = Some(error_without_bound(
            member,
            &settled,
            (duration, tolerance),
            stop,
        )?);
        return Ok(settled);
    };
    let scale = size(&member.start.angular_velocity);
    let mut growth = f64::INFINITY;
    let looser = LOOSE.into_iter().filter(|loose| *loose > 4.0 * bound);
    // Where nothing looser says anything, a tighter one shows the error of the run itself.
    let tighter = Some(TIGHTER * bound).filter(|tight| *tight >= plan::LEAST);
    for other_bound in looser.chain(tighter) {
        let other = end(member, way.within(other_bound), duration, stop)?;
        let off = distance(&settled.state, &other.state, scale);
        // Two runs that agree by chance: a bound is not met better than by itself.
        growth = (off / other_bound.max(bound)).max(1.0);
        if off < LOST {
            break;
        }
    }
    let (needed, error) = needed(growth, bound, tolerance);
    if needed < bound {
        settled = end(member, way.within(needed), duration, stop)?;
    }
    settled.error = Some(error);
    Ok(settled)
}

/// The way within the tolerance and the error to expect, from two runs that are looser than it: for a run whose rows are
/// written as they come, and can't be taken back.
///
/// # Errors
/// As of [`settle`].
pub fn foresee(
    member: &Member,
    way: Way,
    duration: f64,
    tolerance: f64,
    stop: &dyn Fn() -> bool,
) -> Result<(Way, f64), Unsettled> {
    let Some(bound) = way.step_tolerance() else {
        let settled = end(member, way, duration, stop)?;
        return Ok((
            way,
            error_without_bound(member, &settled, (duration, tolerance), stop)?,
        ));
    };
    let scale = size(&member.start.angular_velocity);
    let mut growth = f64::INFINITY;
    let mut one = end(member, way.within(LOOSE[0]), duration, stop)?;
    for (loose, tight) in LOOSE.into_iter().zip(LOOSE.into_iter().skip(1)) {
        let other = end(member, way.within(tight), duration, stop)?;
        let off = distance(&one.state, &other.state, scale);
        growth = (off / loose).max(1.0);
        if off < LOST {
            break;
        }
        one = other;
    }
    let (needed, error) = needed(growth, bound, tolerance);
    Ok((way.within(needed), error))
}

/// The bound of a step, at most the one given, that keeps the error within the tolerance if anything does; and the error.
fn needed(growth: f64, bound: f64, tolerance: f64) -> (f64, f64) {
    // Half of it, so that the estimate stays below the tolerance when it is rounded.
    let least = plan::LEAST.min(bound);
    let needed = (0.5 * tolerance / (SAFETY * growth)).clamp(least, bound);
    (needed, SAFETY * growth * needed.max(ROUNDING))
}

/// Parts of a run between which it may be stopped.
const PARTS: u32 = 64;

fn end(
    member: &Member,
    way: Way,
    duration: f64,
    stop: &dyn Fn() -> bool,
) -> Result<Estimated, Unsettled> {
    let mut course = Course::new(member, &way)?;
    if way.step_tolerance().is_some() {
        for part in 1..PARTS {
            course.at(duration * (f64::from(part) / f64::from(PARTS)))?;
            if stop() {
                return Err(Unsettled::Stopped);
            }
        }
    }
    Ok(Estimated {
        state: course.at(duration)?,
        error: None,
        way,
    })
}

/// The error of a way whose steps have no bound: what rounding its input would do to a closed form, and for steps of
/// fixed length the distance to a run by Taylor series.
fn error_without_bound(
    member: &Member,
    found: &Estimated,
    (duration, tolerance): (f64, f64),
    stop: &dyn Fn() -> bool,
) -> Result<f64, Unsettled> {
    let speed = size(&member.start.angular_velocity);
    Ok(match found.way {
        Way::Free => free_error(member, duration, tolerance),
        Way::Spin(_) => {
            let speed = speed.max(size(&found.state.angular_velocity));
            ROUNDING * (1.0 + speed * duration)
        }
        _ => {
            let fine = Way::Taylor { tolerance: 1e-14 };
            let other = end(member, fine, duration, stop)?;
            distance(&found.state, &other.state, speed)
        }
    })
}
