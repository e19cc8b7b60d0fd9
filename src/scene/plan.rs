//! The plan: how a body's motion is computed, and what of the work is skipped.

use crate::motion::Torque;
use crate::scene::sensitivity::looks_away;
use crate::scene::{Member, Method, Reach, Run, Spin, angle};
use std::{error, fmt};

/// How the motion of one body is computed.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Way {
    /// About a fixed axis, in closed form.
    Spin(Spin),
    /// Free, in closed form.
    Free,
    /// By Taylor series, the last terms of each step below `tolerance`.
    Taylor {
        /// The bound of a step.
        tolerance: f64,
    },
    /// By DOP853, the error of each step below `tolerance`.
    Dop853 {
        /// The bound of a step.
        tolerance: f64,
    },
    /// By the classical Runge–Kutta method.
    Rk4 {
        /// The longest step, s.
        step: f64,
    },
}

impl Way {
    /// The same way with another bound of each step; a way without such a bound stays as it is.
    pub fn within(self, tolerance: f64) -> Self {
        match self {
            Self::Taylor { .. } => Self::Taylor { tolerance },
            Self::Dop853 { .. } => Self::Dop853 { tolerance },
            other => other,
        }
    }

    /// The bound of each step, where there is one.
    pub fn step_tolerance(&self) -> Option<f64> {
        match self {
            Self::Taylor { tolerance } | Self::Dop853 { tolerance } => Some(*tolerance),
            _ => None,
        }
    }
}

impl fmt::Display for Way {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Spin(spin) if spin.is_rest() => f.write_str("at rest"),
            Self::Spin(_) => f.write_str("closed form, spin about a fixed axis"),
            Self::Free => f.write_str("closed form, free body"),
            Self::Taylor { tolerance } => write!(f, "Taylor series, {tolerance:.0e} a step"),
            Self::Dop853 { tolerance } => write!(f, "DOP853, {tolerance:.0e} a step"),
            Self::Rk4 { step } => write!(f, "RK4, step {step:e} s"),
        }
    }
}

/// Why no plan can be made.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum PlanError {
    /// The closed form is asked for, and the motion has none.
    NoClosedForm,
}

impl fmt::Display for PlanError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("the method `exact` is for a free body or a spin about a fixed axis, and the torque allows neither")
    }
}

impl error::Error for PlanError {}

/// Errors at the end of a run by Taylor series and by DOP853, whose own estimate knows less: in units of the bound of its
/// steps, of what the motion magnifies, and of the root of the radians turned, as errors of steps add up like those of a
/// random walk. Ninety-nine times of a hundred they are a quarter of this; over six thousand random scenes of up to 1500 rad,
/// at nine bounds each, at most 0.2 and 2.0.
const SAFETY: [f64; 2] = [0.25, 2.5];
/// How much a motion magnifies an error for each radian that it turns, nine times of ten.
const GROWTH: f64 = 2.0;
/// The least bound of a step: rounding makes more error than a smaller one would save.
pub(crate) const LEAST: f64 = 1e-16;
/// The least bound of a step of DOP853 that carries a Jacobian: its estimate knows no less.
const FINEST: f64 = 1e-15;
/// The largest bound that methods take.
const MOST: f64 = 0.1;

/// The way for a member of a scene.
///
/// # Errors
/// A method that the motion does not allow.
pub fn way(member: &Member, run: &Run) -> Result<Way, PlanError> {
    let spin = || Spin::new(member).map(Way::Spin);
    let free = || is_free(&member.torque).then_some(Way::Free);
    let stepped = || ways(member, run);
    match run.method {
        Method::Auto => Ok(spin()
            .or_else(free)
            .unwrap_or_else(|| cheapest(member, run))),
        Method::Exact => free().or_else(spin).ok_or(PlanError::NoClosedForm),
        Method::Taylor => Ok(stepped()[0]),
        Method::Dop853 => Ok(stepped()[1]),
        Method::Rk4 => Ok(Way::Rk4 {
            step: run.step.unwrap_or(run.duration),
        }),
    }
}

/// The ways of stepping with the bounds of a step to begin with, by which errors that grow as they mostly do stay within
/// the tolerance: Taylor series, DOP853.
pub(crate) fn ways(member: &Member, run: &Run) -> [Way; 2] {
    within(angle(member, run.duration), run.tolerance)
}

fn within(angle: f64, tolerance: f64) -> [Way; 2] {
    let grown = GROWTH * (1.0 + angle) * gathered(angle);
    let [taylor, dop853] = SAFETY.map(|safety| (tolerance / (safety * grown)).clamp(LEAST, MOST));
    [
        Way::Taylor { tolerance: taylor },
        Way::Dop853 { tolerance: dop853 },
    ]
}

/// What the errors of steps come to over an angle, in units of that of one.
pub(crate) fn gathered(angle: f64) -> f64 {
    (1.0 + angle).sqrt()
}

/// What an error is at most, in units of the bound of the steps, where the motion magnifies none and turns little.
pub(crate) fn safety(way: &Way) -> f64 {
    let [taylor, dop853] = SAFETY;
    match way {
        Way::Dop853 { .. } => dop853,
        _ => taylor,
    }
}

/// The bound of a step of DOP853 that carries the Jacobian: as exact as the motion's own steps; of a closed form a hundredth
/// of the tolerance, as a Jacobian may be large.
pub fn jacobian_bound(way: &Way, tolerance: f64) -> f64 {
    let [taylor, dop853] = SAFETY;
    let bound = match way {
        Way::Taylor { tolerance } => tolerance * (taylor / dop853),
        Way::Dop853 { tolerance } => *tolerance,
        _ => 0.01 * tolerance,
    };
    bound.max(FINEST)
}

/// The cheapest of those ways that may be used for the motion. Where none may, each does its best, and the estimate of the
/// error says how good that is.
fn cheapest(member: &Member, run: &Run) -> Way {
    let angle = angle(member, run.duration);
    let holds = |way: &Way| Reach::of(way).is_some_and(|reach| reach.holds(member, angle));
    let cost = |way: &Way| run.costs.per_radian(&member.torque, way);
    let rank = |way: &Way| (!holds(way), cost(way));
    let [taylor, dop853] = within(angle, run.tolerance);
    if rank(&dop853) < rank(&taylor) {
        dop853
    } else {
        taylor
    }
}

/// Whether the attitude is left out: where only the energy is asked for, which is of ω alone unless the torque looks at
/// the attitude.
pub(crate) fn spares_attitude(member: &Member, run: &Run, way: &Way) -> bool {
    let o = &run.outputs;
    let asked = o.last || o.trajectory || o.momentum || o.jacobian;
    !asked && matches!(way, Way::Taylor { .. }) && looks_away(member)
}

/// Whether the torque is zero whatever the body does.
pub fn is_free(torque: &Torque) -> bool {
    match torque {
        Torque::None => true,
        Torque::Constant { value, .. } => value.amax() == 0.0,
        Torque::Gravity { weight, arm } => *weight == 0.0 || arm.amax() == 0.0,
        Torque::Damping { coefficient } => *coefficient == 0.0,
        Torque::Sinusoid {
            amplitude,
            angular_frequency,
            phase,
            ..
        } => amplitude.amax() == 0.0 || (*angular_frequency == 0.0 && *phase == 0.0),
    }
}
