//! How far a computed state may be off the true one.

use crate::motion::{MotionError, Quaternion, State};
use crate::scene::conditioning::free_error;
use crate::scene::{Course, Member, Way, angle, plan};
use nalgebra::Vector3;

/// Rounding errors of a state that is computed once, in units of the last place; 16 were met in random scenes, against
/// thirty digits.
pub(crate) const ROUNDING: f64 = 18.0 * f64::EPSILON;

/// Bounds of a step of the companion run, and how far off it starts: the first at which it does not lose the motion says
/// how errors grow.
const LOOSE: [f64; 4] = [1e-3, 1e-6, 1e-9, 1e-12];
/// Down to this bound DOP853 is the cheapest companion.
const CHEAPLY: f64 = 1e-6;
/// Above this the companion has lost the motion, and says nothing of how errors grow.
pub(crate) const LOST: f64 = 0.05;
/// What of two companions the bound of the tighter one is of the other's.
const CLOSER: f64 = 0.1;
/// The part of the tolerance for a run that is made again with a smaller bound.
const MARGIN: f64 = 0.9;
/// Where a companion starts: directions of ω and of the attitude that are none of a body's axes.
const ASIDE: [[f64; 3]; 2] = [[0.6, 0.64, 0.48], [0.48, -0.6, 0.64]];
/// The angle turned between two points at which a run may be stopped, rad, and the most of these in a quarter.
const BETWEEN_STOPS: f64 = 400.0;
const MOST_STOPS: f64 = 1000.0;

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
/// Beside a motion that is stepped goes a companion with looser steps that starts a little off: where they end up apart says
/// how the motion magnifies what each step leaves, whether by truncation or by rounding. (A companion with the same start
/// does not tell: near an unstable balance steps leave next to nothing, and all of that grows.) Where the error so
/// foreseen is above the tolerance, the run is repeated with a smaller bound. `stop` is asked from time to time whether to
/// give up.
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
    let mut found = quarters(member, &way, duration, stop)?;
    let Some(bound) = way.step_tolerance() else {
        let error = without_bound(member, &way, &found[3], (duration, tolerance), stop)?;
        return Ok(Estimated {
            state: found[3],
            error: Some(error),
            way,
        });
    };
    let mut growth = None;
    for loose in LOOSE.into_iter().filter(|loose| *loose >= bound) {
        let off = apart(member, &companion(&way, loose), duration, &found, stop)?;
        if off < LOST {
            growth = Some(off / loose);
            break;
        }
    }
    let growth = match growth {
        Some(growth) => growth,
        // The run itself may have lost the motion.
        None => growth_by_companions(member, &way, duration, stop)?,
    };
    let (needed, error) = needed(growth, member, &way, (duration, tolerance));
    let way = way.within(needed);
    if needed < bound {
        found = quarters(member, &way, duration, stop)?;
    }
    Ok(Estimated {
        state: found[3],
        error: Some(error),
        way,
    })
}

/// The way within the tolerance and the error to expect, from runs that are looser than it: for a run whose rows are
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
    if way.step_tolerance().is_none() {
        let [.., end] = quarters(member, &way, duration, stop)?;
        let error = without_bound(member, &way, &end, (duration, tolerance), stop)?;
        return Ok((way, error));
    }
    let growth = growth_by_companions(member, &way, duration, stop)?;
    let (needed, error) = needed(growth, member, &way, (duration, tolerance));
    Ok((way.within(needed), error))
}

/// What a motion makes of a small error, by pairs of companions of which one is tighter than the other.
fn growth_by_companions(
    member: &Member,
    way: &Way,
    duration: f64,
    stop: &dyn Fn() -> bool,
) -> Result<f64, Unsettled> {
    let mut growth = f64::INFINITY;
    for loose in LOOSE {
        let tighter = companion(way, (CLOSER * loose).max(plan::LEAST));
        let other = quarters(member, &tighter, duration, stop)?;
        let off = apart(member, &companion(way, loose), duration, &other, stop)?;
        growth = off / loose;
        if off < LOST {
            break;
        }
    }
    Ok(growth)
}

/// The bound of a step, at most the one given, that keeps the error within the tolerance if anything does; and the error.
/// `growth` is what the motion makes of a small error.
fn needed(
    growth: f64,
    member: &Member,
    way: &Way,
    (duration, tolerance): (f64, f64),
) -> (f64, f64) {
    // Two runs that agree by chance: a bound is not met better than by itself.
    let growth = growth.max(1.0) * plan::gathered(angle(member, duration));
    let bound = way.step_tolerance().unwrap_or(plan::LEAST);
    let least = plan::LEAST.min(bound);
    let safety = plan::safety(way);
    let grown = safety * growth;
    let needed = match grown * bound <= tolerance {
        true => bound,
        false => (MARGIN * tolerance / grown).clamp(least, bound),
    };
    (needed, growth * (safety * needed).max(ROUNDING))
}

/// The cheapest way of a companion.
fn companion(way: &Way, bound: f64) -> Way {
    match bound {
        tolerance if tolerance >= CHEAPLY => Way::Dop853 { tolerance },
        _ => way.within(bound),
    }
}

/// How far a companion that starts off by the bound of its steps gets from a run, at the worst of its quarters.
fn apart(
    member: &Member,
    way: &Way,
    duration: f64,
    found: &[State<f64>; 4],
    stop: &dyn Fn() -> bool,
) -> Result<f64, Unsettled> {
    let speed = size(&member.start.angular_velocity);
    let shift = way.step_tolerance().unwrap_or(0.0);
    let mut moved = *member;
    // Where a torque drives the body on, rounding is that of its speed then.
    let fastest = found
        .iter()
        .map(|state| size(&state.angular_velocity))
        .fold(speed, f64::max);
    let omega = member.start.angular_velocity + Vector3::from(ASIDE[0]) * (shift * fastest);
    moved.start = member.start.turning(omega);
    let turn = Quaternion::exp(&(Vector3::from(ASIDE[1]) * shift));
    moved.start.attitude = (member.start.attitude * turn).normalised();
    let others = quarters(&moved, way, duration, stop)?;
    let pairs = found.iter().zip(&others);
    Ok(pairs
        .map(|(one, other)| distance(one, other, speed))
        .fold(0.0, f64::max))
}

/// The states at each quarter of a run; of a closed form four times the last, as nothing adds up on the way there.
fn quarters(
    member: &Member,
    way: &Way,
    duration: f64,
    stop: &dyn Fn() -> bool,
) -> Result<[State<f64>; 4], Unsettled> {
    let mut course = Course::new(member, way)?;
    if matches!(way, Way::Free | Way::Spin(_)) {
        return Ok([course.at(duration)?; 4]);
    }
    let parts = (angle(member, duration) / BETWEEN_STOPS).ceil();
    let parts = 4 * parts.clamp(1.0, MOST_STOPS) as usize;
    let mut found = [member.start; 4];
    for part in 1..=parts {
        if part > 1 && stop() {
            return Err(Unsettled::Stopped);
        }
        let state = course.at(duration * (part as f64 / parts as f64))?;
        if let Some(place) = found.get_mut((4 * part / parts).wrapping_sub(1)) {
            *place = state;
        }
    }
    Ok(found)
}

/// The error at the `end` of a way whose steps have no bound: what rounding its input would do to a closed form, and for
/// steps of fixed length the distance to a run by Taylor series.
fn without_bound(
    member: &Member,
    way: &Way,
    end: &State<f64>,
    (duration, tolerance): (f64, f64),
    stop: &dyn Fn() -> bool,
) -> Result<f64, Unsettled> {
    let speed = size(&member.start.angular_velocity);
    Ok(match way {
        Way::Free => free_error(member, end, duration, tolerance),
        Way::Spin(_) => {
            let speed = speed.max(size(&end.angular_velocity));
            ROUNDING * (1.0 + speed * duration)
        }
        _ => {
            let fine = Way::Taylor { tolerance: 1e-14 };
            let [.., other] = quarters(member, &fine, duration, stop)?;
            distance(end, &other, speed)
        }
    })
}
