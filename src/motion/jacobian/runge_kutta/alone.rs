//! The step of one body, each of its numbers in all lanes of a register.

use super::algebra::{axes, splat};
use super::moments::{Any, Moments, Parts, parts, some_length};
use super::stages::{Stages, Start};
use super::tensor::{Full, Principal, Tensor};
use crate::motion::registers::Registers;
use crate::motion::system::entries;
use crate::motion::{Frame, Quaternion, SmoothLaw, State, System, TorqueLaw};

/// Something to be done with a step, of whatever kind its tensor and its law are.
pub(super) trait Task {
    /// Does it.
    fn run<R: Registers>(
        self,
        registers: R,
        start: Start<R::Wide>,
        tensor: impl Tensor<R::Wide>,
        moments: &impl Moments<R::Wide>,
    );
}

/// Does a task with a step of one body; `false` if the law is said to be linear and is not.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn alone<R: Registers, L: SmoothLaw>(
    registers: R,
    system: &System<f64, L>,
    (time, step): (f64, f64),
    state: &State<f64>,
    task: impl Task,
) -> bool {
    let step = some_length(step);
    let start = |axes| Start {
        attitude: splat(registers, state.attitude.components()),
        omega: splat(registers, state.angular_velocity.into()),
        step,
        axes,
    };
    let in_space = || match TorqueLaw::<f64>::added_in(system.law()) {
        Frame::Body => None,
        Frame::Space => Some(axes(splat(registers, state.attitude.components()))),
    };
    if !<L as TorqueLaw<f64>>::LINEAR {
        let any = Any {
            registers,
            system,
            attitude: state.attitude,
            time,
            step,
        };
        with_tensor(registers, system, start(in_space()), &any, task);
        return true;
    }
    match parts(system, time, step) {
        Some(Parts::Linear(linear)) => {
            let linear = linear.splat(registers);
            with_tensor(registers, system, start(None), &linear, task);
        }
        Some(Parts::Seen(seen)) => {
            let axes = axes(splat(registers, state.attitude.components()));
            let seen = seen.splat(registers).from(axes);
            with_tensor(registers, system, start(in_space()), &seen, task);
        }
        None => return false,
    }
    true
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn with_tensor<R: Registers, L: TorqueLaw<f64>>(
    registers: R,
    system: &System<f64, L>,
    start: Start<R::Wide>,
    moments: &impl Moments<R::Wide>,
    task: impl Task,
) {
    if system.is_principal() {
        let tensor = principal(system).splat(registers);
        task.run(registers, start, tensor, moments);
    } else {
        let tensor = full(system).splat(registers);
        task.run(registers, start, tensor, moments);
    }
}

/// The state after the step.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn end<R: Registers, I: Tensor<R::Wide>, D: Copy>(
    registers: R,
    stages: &Stages<R::Wide, I, D>,
) -> State<f64> {
    let (attitude, omega) = stages.state();
    State {
        attitude: Quaternion::new(firsts(registers, attitude)),
        angular_velocity: firsts(registers, omega).into(),
    }
}

/// What stands in the first lane of each.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn firsts<R: Registers, const N: usize>(registers: R, wide: [R::Wide; N]) -> [f64; N] {
    let mut firsts = [0.0; N];
    for i in 0..N {
        firsts[i] = registers.first(wide[i]);
    }
    firsts
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn full<L: TorqueLaw<f64>>(system: &System<f64, L>) -> Full<f64> {
    Full {
        entries: entries(system.inertia()),
        inverse: entries(system.inverse()),
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn principal<L: TorqueLaw<f64>>(system: &System<f64, L>) -> Principal<f64> {
    let [x, y, z, ..] = entries(system.inertia());
    let [a, b, c, ..] = entries(system.inverse());
    Principal {
        ratios: [(y - z) * a, (z - x) * b, (x - y) * c],
        inverse: [a, b, c],
    }
}

impl Full<f64> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn splat<R: Registers>(&self, registers: R) -> Full<R::Wide> {
        Full {
            entries: splat(registers, self.entries),
            inverse: splat(registers, self.inverse),
        }
    }
}

impl Principal<f64> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn splat<R: Registers>(&self, registers: R) -> Principal<R::Wide> {
        Principal {
            ratios: splat(registers, self.ratios),
            inverse: splat(registers, self.inverse),
        }
    }
}
