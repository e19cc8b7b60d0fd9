//! The Jacobian of one body, its six rows side by side in registers.

use super::algebra::loaded;
use super::alone::{Task, alone, end};
use super::moments::{ByTurn, Moment, Moments};
use super::stages::{Stages, Start};
use super::tensor::Tensor;
use crate::motion::registers::{Registers, Work, in_widest};
use crate::motion::{SmoothLaw, State, StepJacobian, System};

/// The state and an empty matrix overwritten by those after the step. `false` if the law is
/// said to be linear and is not. In place, for the matrix is large beside the work.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn step_with_jacobian<const N: usize, L: SmoothLaw>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    out: &mut StepJacobian<N>,
) -> bool {
    in_widest(One {
        system,
        time,
        state,
        step,
        out,
    })
}

/// One body.
struct One<'a, const N: usize, L> {
    system: &'a System<f64, L>,
    time: f64,
    state: &'a State<f64>,
    step: f64,
    out: &'a mut StepJacobian<N>,
}

impl<const N: usize, L: SmoothLaw> Work for One<'_, N, L> {
    type Output = bool;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(self, registers: R) -> bool {
        let times = (self.time, self.step);
        alone(registers, self.system, times, self.state, Rows(self.out))
    }
}

/// Where the state and the matrix are to be written.
struct Rows<'a, const N: usize>(&'a mut StepJacobian<N>);

impl<const N: usize> Task for Rows<'_, N> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(
        self,
        registers: R,
        start: Start<R::Wide>,
        tensor: impl Tensor<R::Wide>,
        moments: &impl Moments<R::Wide>,
    ) {
        let stages = Stages::new(tensor, moments, start);
        self.0.state = end(registers, &stages);
        let columns = &mut self.0.matrix.data.0;
        // From the last rows to the first: what a register holds beyond the sixth row falls on the column after, whose
        // rows come later.
        match R::LANES {
            8 => rows(registers, &stages, 0, columns),
            4 => {
                rows(registers, &stages, 4, columns);
                rows(registers, &stages, 0, columns);
            }
            lanes => {
                for first in (0..6).step_by(lanes).rev() {
                    rows(registers, &stages, first, columns);
                }
            }
        }
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

/// The rows from `first` on, as many as a register holds.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rows<R: Registers, I: Tensor<R::Wide>, D: ByTurn<R::Wide>, const N: usize>(
    registers: R,
    stages: &Stages<R::Wide, I, Moment<R::Wide, D>>,
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
#[cfg_attr(not(debug_assertions), inline(always))]
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
