//! The classical Runge–Kutta method.

mod lanes;

use crate::motion::block::{Block, Lane, Tensors};
use crate::motion::jacobian::runge_kutta::Felt;
use crate::motion::{
    Number, Scheme, SmoothLaw, State, StepJacobian, System, TorqueLaw, jacobian,
    jacobian::runge_kutta, stepper,
};
use crate::scalar::Jet;
use nalgebra::{SMatrix, SVector, Vector6};

/// The classical method of four stages, order 4, on quaternion and angular velocity; the quaternion is
/// made unit after the step. It conserves neither energy nor momentum: both drift as t h⁴.
///
/// Kutta (1901); Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, table II.1.2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rk4;

impl<L> Scheme<L> for Rk4 {
    fn order(&self) -> usize {
        4
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn step<T: Number>(&self, system: &System<T, L>, time: T, state: &State<T>, step: T) -> State<T>
    where
        L: TorqueLaw<T>,
    {
        let half = step * T::of(0.5);
        let [at_start, midway, at_end] = system.law().clock([time, time + half, time + step]);
        let first = system.rates_by(at_start, state);
        let second = system.rates_by(midway, &state.along(&first, half));
        let third = system.rates_by(midway, &state.along(&second, half));
        let fourth = system.rates_by(at_end, &state.along(&third, step));
        let inner = second.plus(&third, T::one());
        let sum = first.plus(&inner, T::of(2.0)).plus(&fourth, T::one());
        let end = state.along(&sum, step * T::of(1.0 / 6.0));
        State {
            attitude: end.attitude.normalised(),
            ..end
        }
    }

    /// Backwards through the stages, in registers; a law that is not written out as a [`LinearTorque`](crate::motion::LinearTorque)
    /// is alone run on dual numbers.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
        let mut out = StepJacobian {
            state: *state,
            matrix: SMatrix::zeros(),
        };
        if !runge_kutta::step_with_jacobian(system, time, state, step, &mut out) {
            out = jacobian::by_dual_numbers(self, system, time, state, step);
        }
        out
    }

    /// In registers where the torque does not look at the attitude.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block_step(
        &self,
        law: &L,
        tensors: &Tensors<'_>,
        time: f64,
        block: &mut Block,
        step: f64,
    ) -> bool
    where
        L: TorqueLaw<f64>,
    {
        lanes::block_step(law, tensors, time, block, step)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn block_with_jacobian<const N: usize>(
        &self,
        system: &impl Fn(usize) -> System<f64, L>,
        time: f64,
        block: &mut Block,
        step: f64,
        columns: &mut [[Lane; 6]; N],
    ) where
        L: SmoothLaw,
    {
        if !runge_kutta::block_with_jacobian(system, time, block, step, columns) {
            stepper::one_by_one(self, system, time, block, step, columns);
        }
    }

    /// Forward through the stages, as the Jacobian.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
        let mut out = (*state, Vector6::zeros());
        if !runge_kutta::jvp(system, time, state, step, direction, &mut out) {
            out = jacobian::jvp(self, system, time, state, step, direction);
        }
        out
    }

    /// Backwards through the stages, as the Jacobian.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
        let mut out = (*state, SVector::zeros());
        if !runge_kutta::vjp(system, time, state, step, covector, &mut out) {
            let whole = jacobian::by_dual_numbers::<N, _, _>(self, system, time, state, step);
            out = whole.pulled_back(covector);
        }
        out
    }

    /// Backwards through the stages to the tensor and the torques, of which alone the derivatives are taken.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
        K: Copy + TorqueLaw<Jet<f64, P>>,
    {
        let mut felt = Felt::in_state(state);
        if !runge_kutta::felt(system, times, state, covector, &mut felt) {
            let own = jacobian::by_parameters(self, |_| *variable, [0.0; P], times, state).1;
            return own.tr_mul(covector);
        }
        felt.by_parameters(variable, times)
    }
}
