//! A trajectory of steps with a torque for each, and its derivatives.

use crate::motion::jacobian::chain::chain;
use crate::motion::{
    MotionError, Number, Scheme, SmoothLaw, State, StepJacobian, System, TorqueLaw, jacobian,
    stepper,
};
use crate::scalar::Jet;
use nalgebra::{Matrix6, SMatrix, SVector, Vector3, Vector6};

/// The trajectory of a system in steps of one length, a torque of its own added in each.
///
/// ```
/// use nalgebra::{Matrix3, Vector3, Vector6};
/// use polhode::motion::{Rk4, Rollout, State, System, Torque};
///
/// let system = System::new(Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)), Torque::None)?;
/// let torques = vec![Vector3::new(0.1, 0.0, -0.2); 100];
/// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
/// let rollout = Rollout::new(Rk4, system, start, 0.01, &torques)?;
/// // The cost ½ |ω|² at the end, and its gradient in every torque.
/// let mut costs = vec![Vector6::zeros(); 101];
/// let end = rollout.states()[100].angular_velocity;
/// costs[100].fixed_rows_mut::<3>(3).copy_from(&end);
/// let gradient = rollout.gradient(&costs);
/// let mut other = torques.clone();
/// other[40].y += 1e-4;
/// let moved = Rollout::new(Rk4, system, start, 0.01, &other)?.states()[100].angular_velocity;
/// let difference = (moved.norm_squared() - end.norm_squared()) / 2e-4;
/// assert!((gradient.torques[40].y - difference).abs() < 1e-5);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Debug)]
pub struct Rollout<'a, S, L> {
    scheme: S,
    system: System<f64, L>,
    step: f64,
    torques: &'a [Vector3<f64>],
    states: Vec<State<f64>>,
}

/// The gradient of a cost of a [`Rollout`] in everything that it depends on, `P` parameters of its system among it.
#[derive(Clone, Debug, PartialEq)]
pub struct RolloutGradient<const P: usize = 0> {
    /// In the tangent (θ, ω) of the start.
    pub start: Vector6<f64>,
    /// In the torque of each step.
    pub torques: Vec<Vector3<f64>>,
    /// In the tensor's entries xx, yy, zz, xy, xz, yz.
    pub inertia: Vector6<f64>,
    /// In the length of all steps, the times at which the torque law is asked held.
    pub step: f64,
    /// In the parameters of [`Rollout::gradient_by_parameters`].
    pub parameters: SVector<f64, P>,
}

impl<const P: usize> RolloutGradient<P> {
    /// That of a trajectory of no step, with room for the torques of so many.
    fn of_end(cost: Vector6<f64>, steps: usize) -> Self {
        Self {
            start: cost,
            torques: vec![Vector3::zeros(); steps],
            inertia: Vector6::zeros(),
            step: 0.0,
            parameters: SVector::zeros(),
        }
    }
}

impl<'a, S, L> Rollout<'a, S, L>
where
    S: Scheme<L>,
    L: Copy + TorqueLaw<f64>,
{
    /// The trajectory from `start` at time 0, step `k` with `torques[k]` added to the law, in the axes that the law names.
    ///
    /// # Errors
    /// A step that is not positive and finite; a state that stops being finite.
    pub fn new(
        scheme: S,
        system: System<f64, L>,
        start: State<f64>,
        step: f64,
        torques: &'a [Vector3<f64>],
    ) -> Result<Self, MotionError> {
        Self::starting_at(0, scheme, system, start, step, torques)
    }

    /// The trajectory of the steps from `first` on.
    fn starting_at(
        first: usize,
        scheme: S,
        system: System<f64, L>,
        start: State<f64>,
        step: f64,
        torques: &'a [Vector3<f64>],
    ) -> Result<Self, MotionError> {
        stepper::positive(step)?;
        let mut states = Vec::with_capacity(torques.len() + 1);
        states.push(start);
        let mut state = start;
        for (k, torque) in (first..).zip(torques) {
            let time = k as f64 * step;
            state = scheme.step(&system.with_torque(*torque), time, &state, step);
            if !state.is_finite() {
                return Err(MotionError::Diverged { time });
            }
            states.push(state);
        }
        Ok(Self {
            scheme,
            system,
            step,
            torques,
            states,
        })
    }

    /// The last state.
    pub fn end(&self) -> State<f64> {
        self.states[self.torques.len()]
    }

    /// The states: one more than there are steps.
    pub fn states(&self) -> &[State<f64>] {
        &self.states
    }

    /// The gradient of a cost of which `costs[k]` is that in the tangent (θ, ω) of state `k`; what `costs` lacks is zero.
    ///
    /// Backwards through all steps, one product of a covector and a Jacobian each: no matrix is formed, and no more is kept
    /// than the states.
    pub fn gradient(&self, costs: &[Vector6<f64>]) -> RolloutGradient
    where
        L: SmoothLaw,
    {
        self.gradient_through(costs, |_, _| SVector::zeros())
    }

    /// The same with the gradient in `P` parameters that the system is made of, as in [`by_parameters`](Self::by_parameters): one
    /// covector goes back through the steps, however many parameters there are, and no Jacobian is chained. By [`Rk4`](crate::motion::Rk4)
    /// the torque alone is run on dual numbers: the five parameters of a sinusoid in space take 2.8 times the gradient without them.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3, Vector6};
    /// use polhode::motion::{Frame, Law, Number, Rk4, Rollout, State, System};
    ///
    /// let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
    /// let (start, torques) = (State::at_rest(), vec![Vector3::zeros(); 100]);
    /// fn wave<T: Number>([most, angular_frequency, phase]: [T; 3]) -> Law<T> {
    ///     let amplitude = Vector3::z() * most;
    ///     Law::Sinusoid { frame: Frame::Body, amplitude, angular_frequency, phase }
    /// }
    /// let run = |values: [f64; 3]| {
    ///     let system = System::new(inertia, wave(values))?;
    ///     Rollout::new(Rk4, system, start, 0.02, &torques)
    /// };
    /// let variable = |values: [_; 3]| {
    ///     System::over(inertia.map(Number::of), wave(values), Vector3::zeros())
    /// };
    /// // The cost ½ ω_z² at the end, and its gradient in the amplitude, the frequency and the phase.
    /// let at = [0.5, 2.0, 0.3];
    /// let (rollout, mut costs) = (run(at)?, vec![Vector6::zeros(); 101]);
    /// let cost = |rollout: &Rollout<_, _>| 0.5 * rollout.end().angular_velocity.z.powi(2);
    /// costs[100][5] = rollout.end().angular_velocity.z;
    /// let gradient = rollout.gradient_by_parameters(&costs, variable, at).parameters;
    /// let difference = cost(&run([0.5, 2.0 + 1e-5, 0.3])?) - cost(&run([0.5, 2.0 - 1e-5, 0.3])?);
    /// assert!((gradient[1] - difference / 2e-5).abs() < 1e-8);
    /// # Ok::<(), polhode::motion::MotionError>(())
    /// ```
    pub fn gradient_by_parameters<const P: usize, K>(
        &self,
        costs: &[Vector6<f64>],
        system: impl Fn([Jet<f64, P>; P]) -> System<Jet<f64, P>, K>,
        parameters: [f64; P],
    ) -> RolloutGradient<P>
    where
        S: Scheme<K>,
        K: Copy + TorqueLaw<Jet<f64, P>>,
        L: SmoothLaw,
    {
        let variable = system(std::array::from_fn(|i| Jet::variable(parameters[i], i)));
        self.gradient_through(costs, |k, covector| {
            let torque = variable.added() + self.torques[k].map(Number::of);
            let (system, state) = (self.system.with_torque(self.torques[k]), &self.states[k]);
            let times = (k as f64 * self.step, self.step);
            let moved = variable.with_torque(torque);
            (self.scheme).vjp_by_parameters(&system, &moved, times, state, covector)
        })
    }

    /// The gradient of costs of the states, `own(k, covector)` what step `k` gives to that in the parameters.
    fn gradient_through<const P: usize>(
        &self,
        costs: &[Vector6<f64>],
        own: impl Fn(usize, &Vector6<f64>) -> SVector<f64, P>,
    ) -> RolloutGradient<P>
    where
        L: SmoothLaw,
    {
        let cost = |k: usize| costs.get(k).copied().unwrap_or_else(Vector6::zeros);
        let mut gradient = RolloutGradient::of_end(cost(self.torques.len()), self.torques.len());
        self.back(0, &mut gradient, |k, _| cost(k), own);
        gradient
    }

    /// The end of the trajectory and the gradient of a cost, in little memory: as many states as the root of the number of steps
    /// are kept, and those between are made again. `cost(k, state)` is the cost of state `k` in its tangent (θ, ω).
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3, Vector6};
    /// use polhode::motion::{Rk4, Rollout, State, System, Torque};
    ///
    /// let system = System::new(Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0)), Torque::None)?;
    /// let torques = vec![Vector3::new(0.1, 0.0, -0.2); 100];
    /// let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
    /// let cost = |k: usize, state: &State<f64>| match k {
    ///     100 => Vector6::new(0.0, 0.0, 0.0, 1.0, 0.0, 0.0) * state.angular_velocity.x,
    ///     _ => Vector6::zeros(),
    /// };
    /// let (end, gradient) = Rollout::end_with_gradient(Rk4, system, start, 0.01, &torques, cost)?;
    /// let whole = Rollout::new(Rk4, system, start, 0.01, &torques)?;
    /// let costs: Vec<_> = whole.states().iter().enumerate().map(|(k, state)| cost(k, state)).collect();
    /// assert_eq!((end, gradient), (whole.states()[100], whole.gradient(&costs)));
    /// # Ok::<(), polhode::motion::MotionError>(())
    /// ```
    ///
    /// # Errors
    /// As [`new`](Self::new).
    pub fn end_with_gradient(
        scheme: S,
        system: System<f64, L>,
        start: State<f64>,
        step: f64,
        torques: &'a [Vector3<f64>],
        cost: impl Fn(usize, &State<f64>) -> Vector6<f64>,
    ) -> Result<(State<f64>, RolloutGradient), MotionError>
    where
        S: Copy,
        L: SmoothLaw,
    {
        let part = torques.len().isqrt().max(1);
        let from = |first: usize, state| {
            let torques = &torques[first..torques.len().min(first + part)];
            Self::starting_at(first, scheme, system, state, step, torques)
        };
        let (mut kept, mut end) = (Vec::new(), start);
        for first in (0..torques.len()).step_by(part) {
            kept.push((first, end));
            end = from(first, end)?.end();
        }
        let mut gradient = RolloutGradient::of_end(cost(torques.len(), &end), torques.len());
        for (first, state) in kept.into_iter().rev() {
            from(first, state)?.back(first, &mut gradient, &cost, |_, _| SVector::zeros());
        }
        Ok((end, gradient))
    }

    /// Takes a gradient in the end back to the start, through steps of which the first is step `first`.
    fn back<const P: usize>(
        &self,
        first: usize,
        gradient: &mut RolloutGradient<P>,
        cost: impl Fn(usize, &State<f64>) -> Vector6<f64>,
        own: impl Fn(usize, &Vector6<f64>) -> SVector<f64, P>,
    ) where
        L: SmoothLaw,
    {
        let steps = self.torques.iter().zip(&self.states).enumerate();
        for (i, (torque, state)) in steps.rev() {
            let (k, system) = (first + i, self.system.with_torque(*torque));
            let time = k as f64 * self.step;
            let covector = gradient.start;
            let (_, found) = (self.scheme).vjp::<16>(&system, time, state, self.step, &covector);
            gradient.start = found.fixed_rows::<6>(0) + cost(k, state);
            gradient.torques[k] = found.fixed_rows::<3>(6).into_owned();
            gradient.inertia += found.fixed_rows::<6>(9);
            gradient.step += found[15];
            gradient.parameters += own(k, &covector);
        }
    }

    /// The Jacobian of each step, the blocks of a Gauss–Newton or multiple-shooting problem: with 9 columns
    /// [`by_state`](StepJacobian::by_state) is A and [`by_torque`](StepJacobian::by_torque) is B of δx' = A δx + B δu.
    pub fn jacobians<const N: usize>(&self) -> impl Iterator<Item = StepJacobian<N>> + '_
    where
        L: SmoothLaw,
    {
        let steps = self.torques.iter().zip(&self.states).enumerate();
        steps.map(|(k, (torque, state))| {
            let system = self.system.with_torque(*torque);
            let time = k as f64 * self.step;
            (self.scheme).step_with_jacobian::<N>(&system, time, state, self.step)
        })
    }

    /// The derivative of each state but the first in the tensor's entries xx, yy, zz, xy, xz, yz: rows (θ, ω). At less
    /// cost than all columns chained.
    pub fn by_inertia(&self) -> impl Iterator<Item = Matrix6<f64>> + '_
    where
        L: SmoothLaw,
    {
        const FIRST: usize = 9;
        let steps = self.torques.iter().zip(&self.states).enumerate();
        steps.scan(Matrix6::zeros(), |chained, (k, (torque, state))| {
            let system = self.system.with_torque(*torque);
            let time = k as f64 * self.step;
            let step = (self.scheme).step_with_jacobian::<15>(&system, time, state, self.step);
            chain(chained, FIRST, &step.matrix);
            Some(*chained)
        })
    }

    /// The derivative of each state but the first in `P` parameters that the system is made of, rows (θ, ω): those of
    /// [`by_parameters`](jacobian::by_parameters), chained. The torque of each step is added to that of the system.
    ///
    /// ```
    /// use nalgebra::{Matrix3, Vector3};
    /// use polhode::motion::{Law, Number, Rk4, Rollout, State, System};
    ///
    /// let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
    /// let (start, torques) = (State::at_rest(), vec![Vector3::new(0.1, 0.0, -0.2); 50]);
    /// let run = |coefficient| {
    ///     let system = System::new(inertia, Law::Damping { coefficient })?;
    ///     Rollout::new(Rk4, system, start, 0.02, &torques)
    /// };
    /// // The damping from the speed at the end, by Newton's steps.
    /// let (seen, mut damping) = (run(0.3)?.end().angular_velocity.z, 0.0);
    /// for _ in 0..5 {
    ///     let rollout = run(damping)?;
    ///     let damped = |[coefficient]: [_; 1]| {
    ///         System::over(inertia.map(Number::of), Law::Damping { coefficient }, Vector3::zeros())
    ///     };
    ///     let slope = rollout.by_parameters(damped, [damping]).last().ok_or("no step")?[(5, 0)];
    ///     damping += (seen - rollout.end().angular_velocity.z) / slope;
    /// }
    /// assert!((damping - 0.3).abs() < 1e-12);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn by_parameters<const P: usize, K>(
        &self,
        system: impl Fn([Jet<f64, P>; P]) -> System<Jet<f64, P>, K>,
        parameters: [f64; P],
    ) -> impl Iterator<Item = SMatrix<f64, 6, P>>
    where
        S: Scheme<K>,
        K: Copy + TorqueLaw<Jet<f64, P>>,
        L: SmoothLaw,
    {
        let steps = self.jacobians::<6>().enumerate();
        steps.scan(SMatrix::zeros(), move |chained, (k, step)| {
            let own = self.step_by_parameters(k, &system, parameters);
            *chained = step.matrix * *chained + own;
            Some(*chained)
        })
    }

    /// The derivative of what step `k` gives in parameters, the state before it held.
    fn step_by_parameters<const P: usize, K>(
        &self,
        k: usize,
        system: &impl Fn([Jet<f64, P>; P]) -> System<Jet<f64, P>, K>,
        parameters: [f64; P],
    ) -> SMatrix<f64, 6, P>
    where
        S: Scheme<K>,
        K: Copy + TorqueLaw<Jet<f64, P>>,
    {
        let moved = |variables| {
            let system = system(variables);
            let torque = system.added() + self.torques[k].map(Number::of);
            system.with_torque(torque)
        };
        let times = (k as f64 * self.step, self.step);
        jacobian::by_parameters(&self.scheme, moved, parameters, times, &self.states[k]).1
    }
}
