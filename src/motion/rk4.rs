//! The classical Runge–Kutta method.

use crate::motion::{Number, Scheme, State, System, TorqueLaw};

/// The classical method of four stages, order 4, on quaternion and angular velocity; the quaternion is
/// made unit after the step. It conserves neither energy nor momentum: both drift as t h⁴.
///
/// Kutta (1901); Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations I*, table II.1.2.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Rk4;

impl Scheme for Rk4 {
    const ORDER: u32 = 4;

    #[inline]
    fn step<T: Number, L: TorqueLaw<T>>(
        &self,
        system: &System<T, L>,
        time: T,
        state: &State<T>,
        step: T,
    ) -> State<T> {
        let half = step * T::of(0.5);
        let first = system.rates(time, state);
        let second = system.rates(time + half, &state.along(&first, half));
        let third = system.rates(time + half, &state.along(&second, half));
        let fourth = system.rates(time + step, &state.along(&third, step));
        let inner = second.plus(&third, T::one());
        let sum = first.plus(&inner, T::of(2.0)).plus(&fourth, T::one());
        let end = state.along(&sum, step * T::of(1.0 / 6.0));
        State {
            attitude: end.attitude.normalised(),
            ..end
        }
    }
}
