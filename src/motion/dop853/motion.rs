//! A motion by steps of DOP853 whose length follows from a tolerance.

use super::tableau::{END, OVER_FIFTH, THIRD};
use super::{Lane, Stages, pack, rate, sum, unit};
use crate::motion::registers::at_its_best;
use crate::motion::{MotionError, State, Stepper, System, TorqueLaw, stepper};
use nalgebra::Vector3;

/// A motion by DOP853 whose steps follow from a tolerance, for any law of torque, closures included.
///
/// Output lies on a polynomial of order 7 through each step, so the times asked for do not change the steps.
/// For a body that is given with products of inertia, [`System::principal`] costs less and keeps the digits of a
/// needle.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Dop853Motion, State, Stepper, System};
///
/// let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
/// // A drag that grows with the square of the speed.
/// let drag = |_: f64, s: &State<f64>| s.angular_velocity * (-0.1 * s.angular_velocity.norm());
/// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
/// let mut motion = Dop853Motion::new(System::new(inertia, drag)?, &start, 1e-10)?;
/// motion.advance_to(10.0)?;
/// assert!(motion.state().angular_velocity.norm() < 2.0);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Dop853Motion<L> {
    system: System<f64, L>,
    tolerance: f64,
    longest: f64,
    /// The step in use: its start, its end, the state there with its rate.
    start: f64,
    end: f64,
    last: Lane<f64>,
    slope: Lane<f64>,
    stages: Stages<f64>,
    dense: [Lane<f64>; 8],
    /// The step to try next, and the longest that was tried.
    next: f64,
    scale: f64,
    /// How many steps in a row were too short to refuse.
    forced: u32,
    taken: u64,
    rejected: u64,
    time: f64,
    state: State<f64>,
}

/// A step that was taken.
pub(crate) struct Taken<'a> {
    /// Its start, s.
    pub(crate) time: f64,
    pub(crate) span: f64,
    pub(crate) stages: &'a Stages<f64>,
}

/// The most refusals of one step: each makes it shorter, down to [`SHORTEST`].
const MOST_REFUSALS: u32 = 700;

/// A step of this part of the time is not refused for its error: a jump of the torque is stepped over so.
const SHORTEST: f64 = 64.0 * f64::EPSILON;

/// The most steps in a row that are too short to refuse. A jump takes one; a motion that runs away, all.
const MOST_FORCED: u32 = 16;

impl<L: TorqueLaw<f64>> Dop853Motion<L> {
    /// The motion of `system` from `state` at time 0. `tolerance` bounds the error of each step, of the
    /// attitude in radians and of ω against |ω|: from 1e-16 to 0.1.
    ///
    /// # Errors
    /// A tolerance outside of these bounds; a torque that is not finite at the start.
    pub fn new(
        system: System<f64, L>,
        state: &State<f64>,
        tolerance: f64,
    ) -> Result<Self, MotionError> {
        stepper::tolerable(tolerance)?;
        let last = pack(state);
        let slope = rate(&system, 0.0, &last);
        if slope.iter().any(|r| !r.is_finite()) {
            return Err(MotionError::Diverged { time: 0.0 });
        }
        let mut dense = [[0.0; 8]; 8];
        dense[0] = last;
        let next = first_step(&last, &slope, tolerance);
        Ok(Self {
            next,
            scale: next,
            forced: 0,
            system,
            tolerance,
            longest: f64::INFINITY,
            start: 0.0,
            end: 0.0,
            last,
            slope,
            stages: Stages::default(),
            dense,
            taken: 0,
            rejected: 0,
            time: 0.0,
            state: *state,
        })
    }

    /// The same with no step longer than `longest` (s): a torque that sets in for less than a step can be missed.
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn with_longest_step(mut self, longest: f64) -> Result<Self, MotionError> {
        stepper::positive(longest)?;
        self.longest = longest;
        Ok(self)
    }

    /// How many steps were taken.
    pub fn steps(&self) -> u64 {
        self.taken
    }

    /// How many steps were tried and refused.
    pub fn rejected(&self) -> u64 {
        self.rejected
    }

    /// The system that moves.
    pub fn system(&self) -> &System<f64, L> {
        &self.system
    }

    /// Takes steps until `time` is reached, and calls `each` with the end of every one; the last ends at `time`.
    pub(crate) fn steps_to(
        &mut self,
        time: f64,
        mut each: impl FnMut(f64),
    ) -> Result<(), MotionError> {
        self.steps_until(time, f64::INFINITY, |taken| {
            each((taken.time + taken.span).min(time));
        })
    }

    /// Moves on to `time` with a last step that ends there: for a run that goes no further.
    ///
    /// # Errors
    /// As [`Stepper::advance_to`].
    pub fn end_at(&mut self, time: f64) -> Result<(), MotionError> {
        self.steps_ending_at(time, |_| {})
    }

    /// The same; calls `each` with every step.
    pub(crate) fn steps_ending_at(
        &mut self,
        time: f64,
        each: impl FnMut(&Taken<'_>),
    ) -> Result<(), MotionError> {
        self.steps_until(time, time, each)?;
        (self.time, self.state) = (time, unit(&self.last));
        Ok(())
    }

    /// Takes steps until `time` is reached, none beyond `border`.
    fn steps_until(
        &mut self,
        time: f64,
        border: f64,
        mut each: impl FnMut(&Taken<'_>),
    ) -> Result<(), MotionError> {
        stepper::onward(time, self.time)?;
        let first = self.taken;
        while self.end < time {
            stepper::another(self.taken - first)?;
            self.take(time, border, &mut each)?;
        }
        Ok(())
    }

    /// One step of the error control's own length, with dense output if it goes beyond `time`; it ends at `border` rather
    /// than beyond.
    fn take(
        &mut self,
        time: f64,
        border: f64,
        each: &mut impl FnMut(&Taken<'_>),
    ) -> Result<(), MotionError> {
        self.stages.begin(self.last, self.slope);
        let mut most = 6.0;
        for _ in 0..MOST_REFUSALS {
            let left = border - self.end;
            let step = self.next.min(self.longest).min(left);
            let forced = step <= SHORTEST * self.end.max(self.scale);
            if self.end + step <= self.end || (forced && self.forced >= MOST_FORCED) {
                break;
            }
            let (raw, error) = at_its_best(
                #[cfg_attr(not(debug_assertions), inline(always))]
                || {
                    self.stages.go_on(&self.system, self.end, step);
                    let raw = self.stages.end(step);
                    (raw, error(&self.stages, &raw, step) / self.tolerance)
                },
            );
            // A NaN is an error that no step brings down.
            let growth = if error.is_finite() {
                let eighth_root = error.sqrt().sqrt().sqrt();
                (0.9 / eighth_root).clamp(1.0 / 3.0, most)
            } else {
                1.0 / 3.0
            };
            if error <= 1.0 || (forced && error.is_finite()) {
                let unit = pack(&unit(&raw));
                let slope = rate(&self.system, self.end + step, &unit);
                if slope.iter().all(|r| r.is_finite()) {
                    self.forced = if forced { self.forced + 1 } else { 0 };
                    self.next = step * if forced { 6.0 } else { growth };
                    each(&Taken {
                        time: self.end,
                        span: step,
                        stages: &self.stages,
                    });
                    let reached = if step >= left {
                        border
                    } else {
                        self.end + step
                    };
                    self.accept(unit, slope, reached, reached >= time);
                    return Ok(());
                }
            }
            self.next = step * growth.min(1.0 / 1.5);
            most = 1.0;
            self.rejected += 1;
        }
        Err(MotionError::Diverged { time: self.end })
    }

    fn accept(&mut self, unit: Lane<f64>, slope: Lane<f64>, reached: f64, with_output: bool) {
        let step = reached - self.end;
        (self.stages.places[12], self.stages.slopes[12]) = (unit, slope);
        if with_output {
            self.dense = self.stages.dense(&self.system, self.end, step);
        }
        self.scale = self.scale.max(step);
        (self.start, self.end) = (self.end, reached);
        (self.last, self.slope) = (unit, slope);
        self.taken += 1;
    }

    fn state_at(&self, time: f64) -> State<f64> {
        let span = self.end - self.start;
        if span == 0.0 {
            return self.state;
        }
        let s = (time - self.start) / span;
        let mut value = self.dense[7];
        for (n, lane) in self.dense[..7].iter().enumerate().rev() {
            let factor = if n.is_multiple_of(2) { s } else { 1.0 - s };
            for (v, c) in value.iter_mut().zip(lane) {
                *v = *v * factor + c;
            }
        }
        unit(&value)
    }
}

impl<L: TorqueLaw<f64>> Stepper for Dop853Motion<L> {
    fn time(&self) -> f64 {
        self.time
    }

    fn state(&self) -> &State<f64> {
        &self.state
    }

    fn advance_to(&mut self, time: f64) -> Result<(), MotionError> {
        self.steps_to(time, |_| {})?;
        (self.time, self.state) = (time, self.state_at(time));
        Ok(())
    }

    fn at(&self, time: f64) -> Result<State<f64>, MotionError> {
        stepper::within(time, self.start, self.end)?;
        Ok(self.state_at(time))
    }
}

/// A step to begin with, from the rates of turning and of its change.
fn first_step(state: &Lane<f64>, slope: &Lane<f64>, tolerance: f64) -> f64 {
    // No squares: that of 1e160 is no number.
    let size = |lane: &Lane<f64>| Vector3::from_column_slice(&lane[4..7]).amax();
    let pace = size(state) + size(slope).sqrt();
    let span = if pace > 0.0 { 1.0 / pace } else { 1.0 };
    // The error control trebles or sixths it from here.
    tolerance.powf(0.125) * span
}

/// The error of a step to `end`, from the comparison with orders 5 and 3.
#[cfg_attr(not(debug_assertions), inline(always))]
fn error(stages: &Stages<f64>, end: &Lane<f64>, step: f64) -> f64 {
    let (start, slopes) = (&stages.places[0], &stages.slopes);
    let fifth = sum(slopes, OVER_FIFTH);
    let (eighth, low) = (sum(slopes, END), sum(slopes, THIRD));
    let third: Lane<f64> = std::array::from_fn(|i| eighth[i] - low[i]);
    let size = |lane: &Lane<f64>| {
        let speed = start[4..7].iter().chain(&end[4..7]);
        let speed = speed.fold(0.0_f64, |m, w| m.max(w.abs()));
        let over = stepper::over(speed);
        // Over the step first, for the square of a rate of 1e-160 is 0. An error δq is an angle of 2 |δq|.
        let square = |part: &[f64], factor: f64| {
            part.iter()
                .map(|c| (c * step * factor).powi(2))
                .sum::<f64>()
        };
        square(&lane[..4], 2.0) + square(&lane[4..], over)
    };
    let (fine, coarse) = (size(&fifth), size(&third));
    let whole = fine + 0.01 * coarse;
    if whole == 0.0 {
        return 0.0;
    }
    fine / whole.sqrt()
}
