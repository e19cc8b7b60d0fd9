//! One interface to every way of moving a body through time.

use crate::motion::block::{Block, LANES, Lane, Tensors};
use crate::motion::{
    MotionError, Number, SmoothLaw, State, StepJacobian, System, TorqueLaw, jacobian,
};
use crate::scalar::Jet;
use nalgebra::{SVector, Vector6};

/// A method that takes one step of a given length, over any number: on dual numbers the step is its own
/// Jacobian.
pub trait Scheme<L> {
    /// The order p: the error over a fixed span falls as hᵖ.
    fn order(&self) -> usize;

    /// The state at `time + step`, from `state` at `time`. On dual numbers it has first derivatives, on hyper-dual numbers
    /// second ones: an example is in [`jacobian`].
    fn step<T: Number>(
        &self,
        system: &System<T, L>,
        time: T,
        state: &State<T>,
        step: T,
    ) -> State<T>
    where
        L: TorqueLaw<T>;

    /// The step and its Jacobian: the derivative of the numerical map itself, columns as in
    /// [`jacobian`].
    fn step_with_jacobian<const N: usize>(
        &self,
        system: &System<f64, L>,
        time: f64,
        state: &State<f64>,
        step: f64,
    ) -> StepJacobian<N>
    where
        L: SmoothLaw,
    {
        jacobian::by_dual_numbers(self, system, time, state, step)
    }

    /// A step of each of eight bodies side by side, and `true`; or `false`, and nothing has moved, if they have to go one
    /// by one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block_step(
        &self,
        _law: &L,
        _tensors: &Tensors<'_>,
        _time: f64,
        _block: &mut Block,
        _step: f64,
    ) -> bool
    where
        L: TorqueLaw<f64>,
        Self: Sized,
    {
        false
    }

    /// A step of each of eight bodies, `system` giving that of each, and the columns of their Jacobians. One by one,
    /// unless the method knows better.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block_with_jacobian<const N: usize>(
        &self,
        system: &impl Fn(usize) -> System<f64, L>,
        time: f64,
        block: &mut Block,
        step: f64,
        columns: &mut [[Lane; 6]; N],
    ) where
        Self: Sized,
        L: SmoothLaw,
    {
        one_by_one(self, system, time, block, step, columns);
    }

    /// The step, and its Jacobian times a `direction` of the first `N` of (θ, ω, torque, inertia, dt), without the matrix.
    fn jvp<const N: usize>(
        &self,
        system: &System<f64, L>,
        time: f64,
        state: &State<f64>,
        step: f64,
        direction: &SVector<f64, N>,
    ) -> (State<f64>, Vector6<f64>)
    where
        L: SmoothLaw,
    {
        jacobian::jvp(self, system, time, state, step, direction)
    }

    /// The step, and a `covector` of (θ', ω') times its Jacobian: the gradient of a cost of the result in the first `N` of
    /// (θ, ω, torque, inertia, dt). By the whole matrix, unless the method knows better.
    fn vjp<const N: usize>(
        &self,
        system: &System<f64, L>,
        time: f64,
        state: &State<f64>,
        step: f64,
        covector: &Vector6<f64>,
    ) -> (State<f64>, SVector<f64, N>)
    where
        L: SmoothLaw,
    {
        self.step_with_jacobian::<N>(system, time, state, step)
            .pulled_back(covector)
    }

    /// A `covector` of (θ', ω') times the derivative of the step in the parameters that its system is made of: `variable` is the
    /// system of them as in [`by_parameters`](jacobian::by_parameters), `system` the same of numbers. By the whole step on dual
    /// numbers, unless the method knows better.
    fn vjp_by_parameters<const P: usize, K>(
        &self,
        system: &System<f64, L>,
        variable: &System<Jet<f64, P>, K>,
        times: (f64, f64),
        state: &State<f64>,
        covector: &Vector6<f64>,
    ) -> SVector<f64, P>
    where
        L: SmoothLaw,
        Self: Scheme<K>,
        K: Copy + TorqueLaw<Jet<f64, P>>,
    {
        let _ = system;
        jacobian::by_parameters(self, |_| *variable, [0.0; P], times, state)
            .1
            .tr_mul(covector)
    }
}

/// A step of each of eight bodies with its Jacobian.
pub(crate) fn one_by_one<const N: usize, S, L>(
    scheme: &S,
    system: &impl Fn(usize) -> System<f64, L>,
    time: f64,
    block: &mut Block,
    step: f64,
    columns: &mut [[Lane; 6]; N],
) where
    S: Scheme<L>,
    L: SmoothLaw,
{
    for lane in 0..LANES {
        let state = block.get(lane);
        let found = scheme.step_with_jacobian::<N>(&system(lane), time, &state, step);
        block.set(lane, &found.state);
        for (column, values) in columns.iter_mut().enumerate() {
            for (row, value) in values.iter_mut().enumerate() {
                value[lane] = found.matrix[(row, column)];
            }
        }
    }
}

/// A motion that can be moved on in time.
pub trait Stepper {
    /// The time reached, s.
    fn time(&self) -> f64;

    /// The state at that time.
    fn state(&self) -> &State<f64>;

    /// Moves on by a span of length `step` (s): by one step where the method's steps are of fixed length.
    ///
    /// # Errors
    /// A step that is not positive and finite; a state that stops being finite. The motion then stays
    /// where it was.
    fn step(&mut self, step: f64) -> Result<(), MotionError> {
        positive(step)?;
        self.advance_to(self.time() + step)
    }

    /// Moves on to `time`, in as many steps as the method needs.
    ///
    /// # Errors
    /// A time before the one reached or not finite; too many steps; a state that stops being finite.
    fn advance_to(&mut self, time: f64) -> Result<(), MotionError>;

    /// The state at a `time` within the last step taken, to the order of the method or one less.
    ///
    /// # Errors
    /// A time outside of the last step.
    fn at(&self, time: f64) -> Result<State<f64>, MotionError>;
}

/// The most steps that one call takes.
const MOST_STEPS: u64 = 1 << 32;

/// A [`Scheme`] repeated with steps of one length.
///
/// To reach a time the step is shortened so that a whole number of equal steps fits, and the time is kept as
/// start + n h: a sum of rounded steps would drift.
#[derive(Clone, Copy, Debug)]
pub struct FixedStep<S, L> {
    scheme: S,
    system: System<f64, L>,
    longest: f64,
    time: f64,
    state: State<f64>,
    before: (f64, State<f64>),
}

impl<S: Scheme<L>, L: TorqueLaw<f64>> FixedStep<S, L> {
    /// The motion of `system` from `state` at time 0, in steps of at most `step` (s).
    ///
    /// # Errors
    /// A step that is not positive and finite.
    pub fn new(
        scheme: S,
        system: System<f64, L>,
        state: State<f64>,
        step: f64,
    ) -> Result<Self, MotionError> {
        positive(step)?;
        Ok(Self {
            scheme,
            system,
            longest: step,
            time: 0.0,
            state,
            before: (0.0, state),
        })
    }

    /// The system that moves.
    pub fn system(&self) -> &System<f64, L> {
        &self.system
    }

    fn step_until(&mut self, end: f64) -> Result<(), MotionError> {
        let next = self
            .scheme
            .step(&self.system, self.time, &self.state, end - self.time);
        if !next.is_finite() {
            return Err(MotionError::Diverged { time: self.time });
        }
        self.before = (self.time, self.state);
        (self.time, self.state) = (end, next);
        Ok(())
    }
}

/// That a step is positive and finite.
pub(crate) fn positive(step: f64) -> Result<(), MotionError> {
    if step > 0.0 && step.is_finite() {
        Ok(())
    } else {
        Err(MotionError::Step { step })
    }
}

/// That a tolerance bounds an error that a double can tell.
pub(crate) fn tolerable(tolerance: f64) -> Result<(), MotionError> {
    if (1e-16..=0.1).contains(&tolerance) {
        Ok(())
    } else {
        Err(MotionError::Tolerance { tolerance })
    }
}

/// That one call may take another step behind so many.
pub(crate) fn another(taken: u64) -> Result<(), MotionError> {
    if taken < MOST_STEPS {
        Ok(())
    } else {
        Err(MotionError::TooManySteps {
            needed: f64::INFINITY,
            most: MOST_STEPS,
        })
    }
}

/// What to measure an error by: 1 over the size of what errs, and 1 at rest. A number so small that nothing is its
/// reciprocal is rest: a damped body comes to it.
pub(crate) fn over(size: f64) -> f64 {
    let over = 1.0 / size;
    if over.is_finite() { over } else { 1.0 }
}

/// That a time lies within a step.
pub(crate) fn within(time: f64, start: f64, end: f64) -> Result<(), MotionError> {
    if (start..=end).contains(&time) {
        Ok(())
    } else {
        Err(MotionError::Time {
            asked: time,
            from: start,
        })
    }
}

/// The span to a time that is not before the one reached.
pub(crate) fn onward(time: f64, from: f64) -> Result<f64, MotionError> {
    let span = time - from;
    if span >= 0.0 && span.is_finite() {
        Ok(span)
    } else {
        Err(MotionError::Time { asked: time, from })
    }
}

/// The ends of equal steps from `start` to `time`, none longer than `longest`.
pub(crate) fn ends(
    start: f64,
    time: f64,
    longest: f64,
) -> Result<impl Iterator<Item = f64>, MotionError> {
    positive(longest)?;
    let span = onward(time, start)?;
    let needed = (span / longest).ceil();
    if needed > MOST_STEPS as f64 {
        return Err(MotionError::TooManySteps {
            needed,
            most: MOST_STEPS,
        });
    }
    let count = needed as u64;
    // Times as n · h: a sum of steps would drift.
    Ok((1..=count).map(move |n| {
        if n == count {
            time
        } else {
            start + span * (n as f64 / needed)
        }
    }))
}

impl<S: Scheme<L>, L: TorqueLaw<f64>> Stepper for FixedStep<S, L> {
    fn time(&self) -> f64 {
        self.time
    }

    fn state(&self) -> &State<f64> {
        &self.state
    }

    fn step(&mut self, step: f64) -> Result<(), MotionError> {
        positive(step)?;
        self.step_until(self.time + step)
    }

    fn advance_to(&mut self, time: f64) -> Result<(), MotionError> {
        for end in ends(self.time, time, self.longest)? {
            self.step_until(end)?;
        }
        Ok(())
    }

    /// By the cubic through both ends and their rates (Hermite), of order 3 in the step.
    fn at(&self, time: f64) -> Result<State<f64>, MotionError> {
        let (start, from) = (self.before.0, &self.before.1);
        within(time, start, self.time)?;
        let span = self.time - start;
        if span == 0.0 {
            return Ok(self.state);
        }
        let s = (time - start) / span;
        let (r0, r1) = (
            self.system.rates(start, from),
            self.system.rates(self.time, &self.state),
        );
        let (a, b) = (span * s * (1.0 - s) * (1.0 - s), span * s * s * (s - 1.0));
        let w = s * s * (3.0 - 2.0 * s);
        let mixed = State {
            attitude: from.attitude * (1.0 - w) + self.state.attitude * w,
            angular_velocity: from.angular_velocity * (1.0 - w) + self.state.angular_velocity * w,
        };
        let curved = mixed.along(&r0, a).along(&r1, b);
        Ok(State {
            attitude: curved.attitude.normalised(),
            ..curved
        })
    }
}
