//! Taylor series of the motion.

mod moments;
mod series;

use crate::motion::registers::at_its_best;
use crate::motion::{
    Body, MotionError, Number, Scheme, State, Stepper, System, Torque, TorqueLaw, stepper,
};
use nalgebra::Vector3;
use series::{Beside, MOST, Series};

/// One step by the Taylor series of the motion, of order 2 to 30, for the laws of torque that have a recurrence
/// ([`Torque`]). Energy and momentum drift by the truncation alone, below rounding from order 16 or so.
///
/// The right side is polynomial, so its coefficients are convolutions: the equation of motion on truncated
/// power series, the dual number taken further. A vector that is constant in space is carried as γ = Rᵀ v with
/// γ' = γ × ω, a sinusoid by its own recurrence of two terms.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Taylor {
    order: usize,
}

impl Taylor {
    /// The series to `order`, brought into 2 ..= 30.
    pub fn of_order(order: usize) -> Self {
        Self {
            order: order.clamp(2, MOST),
        }
    }
}

impl Scheme<Torque> for Taylor {
    fn order(&self) -> usize {
        self.order
    }

    fn step<T: Number>(
        &self,
        system: &System<T, Torque>,
        time: T,
        state: &State<T>,
        step: T,
    ) -> State<T> {
        // In units of the step: terms that are lost are too small to count.
        let unit = if step.magnitude() > 0.0 {
            step
        } else {
            T::one()
        };
        let mut series = Series::default();
        let what = (self.order, true);
        series.become_motion(&mut Beside::default(), system, (time, state), what, unit);
        series.at(step)
    }
}

/// A motion by Taylor series of an order and a step that follow from a tolerance, with the series themselves as dense
/// output.
///
/// It runs along principal axes, where the moment differences are formed once: a needle loses nothing.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Body, State, Stepper, TaylorMotion, Torque};
///
/// let body = Body::new(&Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)))?;
/// let top = Torque::Gravity { weight: 1.0, arm: Vector3::new(0.1, -0.2, 1.0) };
/// let start = State::at_rest().turning(Vector3::new(1.0, -2.0, 8.0));
/// let mut motion = TaylorMotion::new(&body, top, &start, 1e-12)?;
/// motion.advance_to(10.0)?;
/// assert!(motion.steps() < 150);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct TaylorMotion {
    /// Along principal axes.
    system: System<f64, Torque>,
    body: Body,
    order: usize,
    tolerance: f64,
    with_attitude: bool,
    /// The series in use, its start and its end.
    series: Series<f64>,
    beside: Beside<f64>,
    start: f64,
    end: f64,
    steps: u64,
    time: f64,
    state: State<f64>,
}

/// The most units of time that are tried: the second is right unless torque and speed are of very different sizes.
const MOST_UNITS: usize = 3;

impl TaylorMotion {
    /// The motion of `body` under `torque` from `state` at time 0. `tolerance` bounds the last term of each
    /// step, of the attitude in radians and of ω against |ω|: from 1e-16 to 0.1.
    ///
    /// # Errors
    /// A tolerance outside of these bounds; a motion that is not finite from the start.
    pub fn new(
        body: &Body,
        torque: Torque,
        state: &State<f64>,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        stepper::tolerable(tolerance)?;
        let order = ((-0.5 * tolerance.ln()).ceil() as usize + 2).clamp(4, MOST);
        let system = System::principal(body, torque);
        let inner = body.state_along(state);
        let mut motion = Self {
            system,
            body: *body,
            order,
            tolerance,
            with_attitude: true,
            end: 0.0,
            start: 0.0,
            series: Series::default(),
            beside: Beside::default(),
            steps: 0,
            time: 0.0,
            state: *state,
        };
        motion.begin_series(&inner);
        motion.end = motion.end_of_series()?;
        Ok(motion)
    }

    /// The same motion without its attitude, which stays that of the start: most of the work, where the torque does not
    /// look at it. A motion whose torque does stays as it is.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use polhode::motion::{Body, State, Stepper, TaylorMotion, Torque};
    ///
    /// let body = Body::new(&Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)))?;
    /// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
    /// let drag = Torque::Damping { coefficient: 0.1 };
    /// let mut whole = TaylorMotion::new(&body, drag, &start, 1e-12)?;
    /// let mut spin = whole.clone().without_attitude();
    /// whole.advance_to(10.0)?;
    /// spin.advance_to(10.0)?;
    /// assert!((spin.state().angular_velocity - whole.state().angular_velocity).norm() < 1e-11);
    /// # Ok::<(), polhode::motion::MotionError>(())
    /// ```
    #[must_use]
    pub fn without_attitude(mut self) -> Self {
        let parts = TorqueLaw::<f64>::linear(self.system.law(), 0.0);
        if parts.is_some_and(|torque| torque.looks_away()) {
            self.with_attitude = false;
            let inner = self.series.at(0.0);
            self.begin_series(&inner);
            // What ends with its attitude ends without it, if later.
            self.end = self.end_of_series().unwrap_or(self.end);
        }
        self
    }

    /// Makes the series from its start on, in seconds, or in another unit of time where its terms would be too large or
    /// too small.
    fn begin_series(&mut self, inner: &State<f64>) {
        let mut unit = 1.0;
        for _ in 0..=MOST_UNITS {
            at_its_best(
                #[cfg_attr(not(debug_assertions), inline(always))]
                || {
                    self.series.become_motion(
                        &mut self.beside,
                        &self.system,
                        (self.start, inner),
                        (self.order, self.with_attitude),
                        unit,
                    );
                },
            );
            match self.series.better_unit() {
                Some(better) => unit = better,
                None => break,
            }
        }
    }

    /// How many steps were taken.
    pub fn steps(&self) -> u64 {
        self.steps
    }

    pub(crate) fn order(&self) -> usize {
        self.order
    }

    /// Takes steps until `time` is reached, and calls `each` with the end of every one; the last ends at `time`.
    pub(crate) fn steps_to(
        &mut self,
        time: f64,
        mut each: impl FnMut(f64),
    ) -> Result<(), MotionError> {
        stepper::onward(time, self.time)?;
        let first = self.steps;
        while self.end < time {
            stepper::another(self.steps - first)?;
            each(self.end);
            self.next_series()?;
        }
        if time > self.start {
            each(time);
        }
        Ok(())
    }

    fn end_of_series(&self) -> Result<f64, MotionError> {
        let span = self.series.span(self.tolerance);
        let end = self.start + span;
        // A step that does not move the time is a motion that has run away, as is a NaN.
        if end > self.start {
            Ok(end)
        } else {
            Err(MotionError::Diverged { time: self.start })
        }
    }

    /// Makes the series that holds from the end of the present one.
    fn next_series(&mut self) -> Result<(), MotionError> {
        let (time, inner) = (self.end, self.series.at(self.end - self.start));
        self.restart(time, &inner)
    }

    fn restart(&mut self, time: f64, inner: &State<f64>) -> Result<(), MotionError> {
        if !inner.is_finite() {
            return Err(MotionError::Diverged { time: self.start });
        }
        self.start = time;
        // So slow that nothing is the reciprocal of its speed, a damped body is at rest.
        let slow = !(1.0 / inner.angular_velocity.amax()).is_finite();
        let inner = match slow {
            true => inner.turning(Vector3::zeros()),
            false => *inner,
        };
        self.begin_series(&inner);
        self.steps += 1;
        self.end = self.end_of_series()?;
        Ok(())
    }

    fn state_at(&self, time: f64) -> State<f64> {
        self.body.state_from(&self.series.at(time - self.start))
    }
}

impl Stepper for TaylorMotion {
    fn time(&self) -> f64 {
        self.time
    }

    fn state(&self) -> &State<f64> {
        &self.state
    }

    fn advance_to(&mut self, time: f64) -> Result<(), MotionError> {
        self.steps_to(time, |_| {})?;
        self.time = time;
        self.state = self.state_at(time);
        Ok(())
    }

    fn at(&self, time: f64) -> Result<State<f64>, MotionError> {
        stepper::within(time, self.start, self.end)?;
        Ok(self.state_at(time))
    }
}
