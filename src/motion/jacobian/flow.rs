//! The Jacobian of a whole motion, from time 0 to a given time; from another one by a law that is [`Later`](crate::motion::Later).
//!
//! Rows and columns are those of a step: (θ, ω) at the end by (θ, ω) at the start, the added torque, the inertia and
//! the length, which is here the time itself. Each step's Jacobian is chained to those before it.

use super::variation::Variation;
use crate::motion::{
    Body, Dop853, Dop853Motion, FreeBody, MotionError, Scheme, SmoothLaw, State, StepJacobian,
    Stepper, System, Taylor, TaylorMotion, Torque, TorqueLaw, stepper,
};
use nalgebra::SMatrix;

/// The steps' Jacobians so far.
struct Chain<const N: usize> {
    time: f64,
    state: State<f64>,
    matrix: SMatrix<f64, 6, N>,
}

impl<const N: usize> Chain<N> {
    fn new(state: &State<f64>) -> Self {
        Self {
            time: 0.0,
            state: *state,
            matrix: SMatrix::from_fn(|r, c| if r == c { 1.0 } else { 0.0 }),
        }
    }

    fn step_to<S, L>(&mut self, scheme: &S, system: &System<f64, L>, end: f64)
    where
        S: Scheme<L>,
        L: SmoothLaw,
    {
        let span = end - self.time;
        let step = scheme.step_with_jacobian::<N>(system, self.time, &self.state, span);
        let chained = StepJacobian {
            state: self.state,
            matrix: self.matrix,
        }
        .then(&step);
        (self.time, self.state, self.matrix) = (end, chained.state, chained.matrix);
    }
}

impl<const N: usize> Chain<N> {
    /// With the rates at the end as the derivative in the time.
    fn finish<L: TorqueLaw<f64>>(
        mut self,
        system: &System<f64, L>,
    ) -> Result<StepJacobian<N>, MotionError> {
        if N > 15 {
            let rates = system.rates(self.time, &self.state);
            for i in 0..3 {
                self.matrix[(i, 15)] = self.state.angular_velocity[i];
                self.matrix[(3 + i, 15)] = rates.angular_acceleration[i];
            }
        }
        if !self.state.is_finite() || self.matrix.iter().any(|d| !d.is_finite()) {
            return Err(MotionError::Diverged { time: self.time });
        }
        Ok(StepJacobian {
            state: self.state,
            matrix: self.matrix,
        })
    }
}

/// The motion by steps of a scheme, each at most `step` (s) long, to `time`, with its Jacobian: the derivative of the
/// numerical map, and in the column of the time the rate of the state.
///
/// # Errors
/// A step that is not positive and finite, a time before 0 or not finite, too many steps, a motion that stops being
/// finite.
pub fn by_steps<const N: usize, S, L>(
    scheme: &S,
    system: &System<f64, L>,
    state: &State<f64>,
    step: f64,
    time: f64,
) -> Result<StepJacobian<N>, MotionError>
where
    S: Scheme<L>,
    L: SmoothLaw,
{
    let mut chain = Chain::new(state);
    for end in stepper::ends(0.0, time, step)? {
        chain.step_to(scheme, system, end);
    }
    chain.finish(system)
}

/// The motion by Taylor series within `tolerance`, as [`TaylorMotion`] takes it, with its Jacobian.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Body, State, Torque, jacobian::flow};
///
/// let body = Body::new(&Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)))?;
/// let top = Torque::Gravity { weight: 1.0, arm: Vector3::new(0.1, -0.2, 1.0) };
/// let start = State::at_rest().turning(Vector3::new(1.0, -2.0, 8.0));
/// let end = flow::by_taylor::<15>(&body, top, &start, 1e-12, 2.0)?;
/// // Flows keep the volume of (θ, L), and so that of (θ, ω).
/// let volume = end.matrix.fixed_view::<6, 6>(0, 0).determinant();
/// assert!((volume - 1.0).abs() < 1e-10);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// # Errors
/// As [`TaylorMotion`].
pub fn by_taylor<const N: usize>(
    body: &Body,
    torque: Torque,
    state: &State<f64>,
    tolerance: f64,
    time: f64,
) -> Result<StepJacobian<N>, MotionError>
where
{
    let system = System::new(*body.inertia(), torque)?;
    let mut motion = TaylorMotion::new(body, torque, state, tolerance)?;
    let mut chain = Chain::new(state);
    let scheme = Taylor::of_order(motion.order());
    motion.steps_to(time, |end| chain.step_to(&scheme, &system, end))?;
    chain.finish(&system)
}

/// The motion by DOP853 within `tolerance`, as [`Dop853Motion`] takes it, with its Jacobian.
///
/// # Errors
/// As [`Dop853Motion`].
pub fn by_dop853<const N: usize, L>(
    system: &System<f64, L>,
    state: &State<f64>,
    tolerance: f64,
    time: f64,
) -> Result<StepJacobian<N>, MotionError>
where
    L: SmoothLaw,
{
    let mut motion = Dop853Motion::new(*system, state, tolerance)?;
    let mut chain = Chain::new(state);
    motion.steps_to(time, |end| chain.step_to(&Dop853, system, end))?;
    chain.finish(system)
}

/// The motion by DOP853 within `tolerance` along principal axes, and by the same steps the solution of its equation of
/// variation: the columns side by side in registers, at about twice the time of the motion alone.
///
/// The derivative of the motion itself to the order of the method, where [`by_dop853`] gives that of the numerical map.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Body, State, Torque, jacobian::flow};
///
/// let body = Body::new(&Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)))?;
/// let drag = Torque::Damping { coefficient: 0.1 };
/// let start = State::at_rest().turning(Vector3::new(1.0, -2.0, 8.0));
/// let found = flow::by_variation::<9>(&body, drag, &start, 1e-10, 2.0)?;
/// let series = flow::by_taylor::<9>(&body, drag, &start, 1e-14, 2.0)?;
/// assert!((found.matrix - series.matrix).amax() < 1e-8);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// # Errors
/// As [`Dop853Motion`].
pub fn by_variation<const N: usize>(
    body: &Body,
    torque: Torque,
    state: &State<f64>,
    tolerance: f64,
    time: f64,
) -> Result<StepJacobian<N>, MotionError> {
    let system = System::principal(body, torque);
    let mut motion = Dop853Motion::new(system, &body.state_along(state), tolerance)?;
    let mut variation = Variation::new(body, N.min(15));
    motion.steps_ending_at(time, |taken| variation.step(&system, taken))?;
    let reached = Chain {
        time,
        state: body.state_from(motion.state()),
        matrix: variation.matrix(),
    };
    reached.finish(&System::new(*body.inertia(), torque)?)
}

/// The exact free body at `time` and its Jacobian, the solution of the variational equation to rounding.
///
/// The attitude's columns are known by symmetry: a body that is turned beforehand moves as it did. The others come from
/// the series of the motion, not from derivatives of elliptic functions, which are 0/0 at repeated moments and on
/// the separatrix, where the motion itself is smooth.
///
/// # Errors
/// A time before 0 or not finite.
pub fn of_free_body<const N: usize>(
    body: &Body,
    state: &State<f64>,
    time: f64,
) -> Result<StepJacobian<N>, MotionError>
where
{
    stepper::onward(time, 0.0)?;
    let end = FreeBody::new(body, state).at(time)?;
    let mut found = by_taylor::<N>(body, Torque::None, state, 1e-16, time)?;
    let turned = (end.attitude.conjugate() * state.attitude).matrix();
    found.matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&turned);
    found.matrix.fixed_view_mut::<3, 3>(3, 0).fill(0.0);
    found.state = end;
    Ok(found)
}
