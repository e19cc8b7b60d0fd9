//! The exact free body as a motion under way.

use crate::motion::{Body, FreeBody, MotionError, State, Stepper, stepper};

/// A free body that is moved on in time like any other motion. Every state comes from the epoch, so nothing adds up on the
/// way.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Body, FreeMotion, State, Stepper};
///
/// let body = Body::new(&Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)))?;
/// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
/// let mut motion = FreeMotion::new(&body, &start);
/// motion.step(0.1)?;
/// motion.advance_to(10.0)?;
/// assert_eq!(motion.at(10.0)?, *motion.state());
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FreeMotion {
    body: FreeBody,
    before: f64,
    time: f64,
    state: State<f64>,
}

impl FreeMotion {
    /// The motion of `body` from `state` at time 0.
    pub fn new(body: &Body, state: &State<f64>) -> Self {
        Self {
            body: FreeBody::new(body, state),
            before: 0.0,
            time: 0.0,
            state: *state,
        }
    }
}

impl Stepper for FreeMotion {
    fn time(&self) -> f64 {
        self.time
    }

    fn state(&self) -> &State<f64> {
        &self.state
    }

    fn advance_to(&mut self, time: f64) -> Result<(), MotionError> {
        stepper::onward(time, self.time)?;
        self.state = self.body.at(time)?;
        (self.before, self.time) = (self.time, time);
        Ok(())
    }

    /// To rounding.
    fn at(&self, time: f64) -> Result<State<f64>, MotionError> {
        stepper::within(time, self.before, self.time)?;
        self.body.at(time)
    }
}
