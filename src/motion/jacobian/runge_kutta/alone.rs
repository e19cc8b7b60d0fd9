//! The step of one body, each of its numbers in all lanes of a register.

use super::algebra::{Turn, Vector, splat};
use super::stages::{Moment, Stages, moments, some_length};
use super::tensor::{Full, Principal, Tensor};
use crate::motion::registers::Registers;
use crate::motion::system::entries;
use crate::motion::{Quaternion, State, System, TorqueLaw};

/// A step before it is taken.
pub(super) struct Alone<R: Registers> {
    pub(super) registers: R,
    pub(super) step: f64,
    pub(super) moments: [Moment<R::Wide>; 3],
    pub(super) attitude: Turn<R::Wide>,
    pub(super) omega: Vector<R::Wide>,
}

impl<R: Registers> Alone<R> {
    /// `None` if the law gives a torque that depends on the attitude.
    #[inline(always)]
    pub(super) fn new<L: TorqueLaw<f64>>(
        registers: R,
        system: &System<f64, L>,
        time: f64,
        state: &State<f64>,
        step: f64,
    ) -> Option<Self> {
        let step = some_length(step);
        let [a, b, c] = &moments(system, time, step)?;
        Some(Self {
            registers,
            step,
            moments: [a.splat(registers), b.splat(registers), c.splat(registers)],
            attitude: splat(registers, state.attitude.components()),
            omega: splat(registers, state.angular_velocity.into()),
        })
    }

    #[inline(always)]
    pub(super) fn stages<I: Tensor<R::Wide>>(&self, tensor: I) -> Stages<R::Wide, I> {
        Stages::new(tensor, self.omega, self.step, &self.moments)
    }

    /// The state after the step.
    #[inline(always)]
    pub(super) fn end<I: Tensor<R::Wide>>(&self, stages: &Stages<R::Wide, I>) -> State<f64> {
        let (attitude, omega) = stages.state(self.attitude, self.omega);
        State {
            attitude: Quaternion::new(self.firsts(attitude)),
            angular_velocity: self.firsts(omega).into(),
        }
    }

    /// What stands in the first lane of each.
    #[inline(always)]
    pub(super) fn firsts<const N: usize>(&self, wide: [R::Wide; N]) -> [f64; N] {
        let mut firsts = [0.0; N];
        for i in 0..N {
            firsts[i] = self.registers.first(wide[i]);
        }
        firsts
    }
}

#[inline(always)]
pub(super) fn full<L: TorqueLaw<f64>>(system: &System<f64, L>) -> Full<f64> {
    Full {
        entries: entries(system.inertia()),
        inverse: entries(system.inverse()),
    }
}

#[inline(always)]
pub(super) fn principal<L: TorqueLaw<f64>>(system: &System<f64, L>) -> Principal<f64> {
    let [x, y, z, ..] = entries(system.inertia());
    let [a, b, c, ..] = entries(system.inverse());
    Principal {
        ratios: [(y - z) * a, (z - x) * b, (x - y) * c],
        inverse: [a, b, c],
    }
}

impl Full<f64> {
    #[inline(always)]
    pub(super) fn splat<R: Registers>(&self, registers: R) -> Full<R::Wide> {
        Full {
            entries: splat(registers, self.entries),
            inverse: splat(registers, self.inverse),
        }
    }
}

impl Principal<f64> {
    #[inline(always)]
    pub(super) fn splat<R: Registers>(&self, registers: R) -> Principal<R::Wide> {
        Principal {
            ratios: splat(registers, self.ratios),
            inverse: splat(registers, self.inverse),
        }
    }
}
