//! A motion that is under way by the method that was chosen.

use crate::motion::{
    Dop853Motion, FixedStep, FreeBody, MotionError, Rk4, State, Stepper, System, TaylorMotion,
    Torque,
};
use crate::scene::{Member, Spin, Way};

/// A motion from time 0 on, asked for times that ascend.
#[derive(Clone, Debug)]
pub enum Course {
    /// About a fixed axis.
    Spin(Spin),
    /// Free.
    Free(FreeBody),
    /// By Taylor series.
    Taylor(Box<TaylorMotion>),
    /// By DOP853, along principal axes.
    Dop853(Box<Dop853Motion<Torque>>, Member),
    /// By the classical Runge–Kutta method.
    Rk4(Box<FixedStep<Rk4, Torque>>),
}

impl Course {
    /// The motion of a member by a way.
    ///
    /// # Errors
    /// A motion that is not finite from the start.
    pub fn new(member: &Member, way: &Way) -> Result<Self, MotionError> {
        let Member {
            body,
            start,
            torque,
        } = member;
        Ok(match *way {
            Way::Spin(spin) => Self::Spin(spin),
            Way::Free => Self::Free(FreeBody::new(body, start)),
            Way::Taylor { tolerance } => Self::Taylor(Box::new(TaylorMotion::new(
                body, *torque, start, tolerance,
            )?)),
            Way::Dop853 { tolerance } => {
                let system = System::principal(body, *torque);
                let inner = body.state_along(start);
                let motion = Dop853Motion::new(system, &inner, tolerance)?;
                Self::Dop853(Box::new(motion), *member)
            }
            Way::Rk4 { step } => {
                let system = System::new(*body.inertia(), *torque)?;
                Self::Rk4(Box::new(FixedStep::new(Rk4, system, *start, step)?))
            }
        })
    }

    /// The same motion without its attitude, where that saves work and the torque does not look at it.
    #[must_use]
    pub fn without_attitude(self) -> Self {
        match self {
            Self::Taylor(motion) => Self::Taylor(Box::new(motion.without_attitude())),
            other => other,
        }
    }

    /// The state at `time`, at which the motion ends: steps of error control end there too.
    ///
    /// # Errors
    /// As of [`at`](Self::at).
    pub fn last(mut self, time: f64) -> Result<State<f64>, MotionError> {
        match &mut self {
            Self::Dop853(motion, member) => {
                motion.end_at(time)?;
                Ok(member.body.state_from(motion.state()))
            }
            other => other.at(time),
        }
    }

    /// The state at `time`, which is not before the last one asked for.
    ///
    /// # Errors
    /// A motion that stops being finite; too many steps.
    pub fn at(&mut self, time: f64) -> Result<State<f64>, MotionError> {
        match self {
            Self::Spin(spin) => {
                let state = spin.at(time);
                match state.is_finite() {
                    true => Ok(state),
                    false => Err(MotionError::Diverged { time }),
                }
            }
            Self::Free(motion) => motion.at(time),
            Self::Taylor(motion) => {
                motion.advance_to(time)?;
                Ok(*motion.state())
            }
            Self::Dop853(motion, member) => {
                motion.advance_to(time)?;
                Ok(member.body.state_from(motion.state()))
            }
            Self::Rk4(motion) => {
                motion.advance_to(time)?;
                Ok(*motion.state())
            }
        }
    }
}
