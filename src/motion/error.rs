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
    /// The body is at rest where its motion is asked for.
    AtRest,
    /// The inertia tensor is that of no body.
    Inertia(ImpossibleInertia),
    /// The inertia tensor of one of many bodies is that of no body.
    BodyInertia {
        /// The body's place in the batch, from 0.
        body: usize,
        /// What is wrong with its tensor.
        reason: ImpossibleInertia,
    },
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
    /// The motion of one of many bodies or the torque on it stopped being finite.
    BodyDiverged {
        /// The body's place in the batch, from 0.
        body: usize,
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
            Self::AtRest => {
                f.write_str("the body is at rest, and has to turn: give it an angular velocity")
            }
            Self::Inertia(reason) => reason.fmt(f),
            Self::BodyInertia { body, reason } => write!(f, "body {body}: {reason}"),
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
            Self::BodyDiverged { body, time } => write!(
                f,
                "body {body}: the torque or the state is no longer finite in the step from t = {time} s"
            ),
        }
    }
}

impl Error for MotionError {}
