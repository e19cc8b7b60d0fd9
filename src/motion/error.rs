//! What can be wrong with a motion that is asked for.

use crate::mechanics::ImpossibleInertia;
use std::{error::Error, fmt};

/// Why a motion cannot be computed. Each message names the number and the rule that it breaks.
#[derive(Clone, Debug, PartialEq)]
pub enum MotionError {
    /// A number that has to be finite is not.
    NotFinite {
        /// What the number is.
        what: &'static str,
        /// The number.
        value: f64,
    },
    /// The attitude is the quaternion 0, which has no direction.
    ZeroAttitude,
    /// The inertia tensor is that of no body.
    Inertia(ImpossibleInertia),
    /// The step is zero, negative or no number.
    Step {
        /// The step, s.
        step: f64,
    },
    /// The tolerance cannot be met or means nothing.
    Tolerance {
        /// The tolerance.
        tolerance: f64,
    },
    /// The time asked for is no number, or before the time reached.
    Time {
        /// The time asked for, s.
        asked: f64,
        /// The earliest time that can be given, s.
        from: f64,
    },
    /// The span needs more steps than are allowed.
    TooManySteps {
        /// Steps that the span needs.
        needed: f64,
        /// The most that are taken.
        most: u64,
    },
    /// The motion or its torque stopped being finite.
    Diverged {
        /// The time at the start of the step that failed, s.
        time: f64,
    },
}

impl fmt::Display for MotionError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { what, value } => write!(f, "{what} is {value}, and has to be finite"),
            Self::ZeroAttitude => write!(
                f,
                "the attitude quaternion is 0, and has to have a direction"
            ),
            Self::Inertia(reason) => reason.fmt(f),
            Self::Step { step } => {
                write!(f, "the step is {step} s, and has to be positive and finite")
            }
            Self::Tolerance { tolerance } => {
                write!(
                    f,
                    "the tolerance is {tolerance:e}, and has to be between 1e-16 and 0.1"
                )
            }
            Self::Time { asked, from } => {
                write!(
                    f,
                    "the time {asked} s was asked for, and has to be finite and not before {from} s"
                )
            }
            Self::TooManySteps { needed, most } => {
                write!(
                    f,
                    "{needed:e} steps are needed, and at most {most} are taken"
                )
            }
            Self::Diverged { time } => write!(
                f,
                "the torque or the state is no longer finite in the step from t = {time} s"
            ),
        }
    }
}

impl Error for MotionError {}
