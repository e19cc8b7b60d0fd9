//! The Jacobian of one body, its six rows side by side in registers.

use super::algebra::loaded;
use super::alone::{Alone, full, principal};
use super::stages::Stages;
use super::tensor::Tensor;
use crate::motion::registers::{Registers, Work, in_widest};
use crate::motion::{StepJacobian, System, TorqueLaw};

/// The state and an empty matrix overwritten by those after the step; `false` if the law gives a torque that depends on the
/// attitude. In place, for the matrix is large beside the work.
#[inline(always)]
pub(crate) fn step_with_jacobian<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    step: f64,
    out: &mut StepJacobian<N>,
) -> bool {
    in_widest(One {
        system,
        time,
        step,
        out,
    })
}

/// One body: the state before the step and an empty matrix, to be overwritten.
struct One<'a, const N: usize, L> {
    system: &'a System<f64, L>,
    time: f64,
    step: f64,
    out: &'a mut StepJacobian<N>,
}

impl<const N: usize, L: TorqueLaw<f64>> Work for One<'_, N, L> {
    type Output = bool;

    #[inline(always)]
    fn run<R: Registers>(self, registers: R) -> bool {
        let (system, out) = (self.system, self.out);
        let Some(alone) = Alone::new(registers, system, self.time, &out.state, self.step) else {
            return false;
        };
        if system.is_principal() {
            write(&alone, principal(system).splat(registers), out);
        } else {
            write(&alone, full(system).splat(registers), out);
        }
        true
    }
}

/// Rows of a Jacobian and room to fill up a register: 1 where a row is the one of a component of θ' or of ω'.
const OF_THETA: [[f64; 8]; 3] = [
    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
];
const OF_OMEGA: [[f64; 8]; 3] = [
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
];

#[cfg_attr(not(debug_assertions), inline(always))]
fn write<R: Registers, I: Tensor<R::Wide>, const N: usize>(
    alone: &Alone<R>,
    tensor: I,
    out: &mut StepJacobian<N>,
) {
    let stages = alone.stages(tensor);
    out.state = alone.end(&stages);
    let columns = &mut out.matrix.data.0;
    // From the last rows to the first: what a register holds beyond the sixth row falls on the column after, whose
    // rows come later.
    match R::LANES {
        8 => rows(alone.registers, &stages, 0, columns),
        4 => {
            rows(alone.registers, &stages, 4, columns);
            rows(alone.registers, &stages, 0, columns);
        }
        lanes => {
            for first in (0..6).step_by(lanes).rev() {
                rows(alone.registers, &stages, first, columns);
            }
        }
    }
}

/// The rows from `first` on, as many as a register holds.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rows<R: Registers, I: Tensor<R::Wide>, const N: usize>(
    registers: R,
    stages: &Stages<R::Wide, I>,
    first: usize,
    columns: &mut [[f64; 6]; N],
) {
    let (mut of_theta, mut of_omega) = (None, None);
    if first < 3 {
        of_theta = Some(loaded(registers, &OF_THETA, first));
    }
    if first + R::LANES > 3 {
        of_omega = Some(loaded(registers, &OF_OMEGA, first));
    }
    let pulled = stages.pulled_back::<N>(of_theta, of_omega);
    let flat = columns.as_flattened_mut();
    put(registers, flat, first, pulled.theta);
    put(registers, flat, 6 * 3 + first, pulled.omega);
    put(registers, flat, 6 * 6 + first, pulled.torque);
    put(registers, flat, 6 * 9 + first, pulled.inertia);
    put(registers, flat, 6 * 15 + first, [pulled.span]);
}

/// Writes the rows of columns one after the other, if they are asked for: `from` is the place of the first.
#[inline(always)]
fn put<R: Registers, const M: usize>(
    registers: R,
    flat: &mut [f64],
    from: usize,
    values: [R::Wide; M],
) {
    for (i, value) in values.into_iter().enumerate() {
        let from = from + 6 * i;
        if let Some(room) = flat.get_mut(from..from + R::LANES) {
            registers.store(value, room);
        } else if let Some(last) = flat.get_mut(from..) {
            let mut room = [0.0; 8];
            registers.store(value, &mut room);
            last.copy_from_slice(&room[..last.len()]);
        }
    }
}
