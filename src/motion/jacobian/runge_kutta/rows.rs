//! The Jacobian of one body, its six rows side by side in registers.

use super::algebra::{Full, Principal, Tensor, entries, loaded, matrix, splat, splat_rows};
use super::stages::{ByInertia, Stage, Stages, moments};
use crate::motion::registers::{Registers, Work, in_widest};
use crate::motion::{Quaternion, State, StepJacobian, System, TorqueLaw};
use nalgebra::SMatrix;

/// The step and its Jacobian, or `None` if the law gives a torque that depends on the attitude.
#[inline(always)]
pub(crate) fn step_with_jacobian<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> Option<StepJacobian<N>> {
    let mut out = StepJacobian {
        state: *state,
        matrix: SMatrix::zeros(),
    };
    let done = in_widest(One {
        system,
        time,
        step,
        out: &mut out,
    });
    done.then_some(out)
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
        if system.is_principal() {
            let Some(stages) = stages(principal(system), system, self.time, &out.state, self.step)
            else {
                return false;
            };
            let tensor = stages.tensor.splat(registers);
            write(registers, &stages, tensor, out);
        } else {
            let Some(stages) = stages(full(system), system, self.time, &out.state, self.step)
            else {
                return false;
            };
            let tensor = stages.tensor.splat(registers);
            write(registers, &stages, tensor, out);
        }
        true
    }
}

/// The stages of a step of one body.
#[inline(always)]
pub(super) fn stages<I: Tensor<f64>, L: TorqueLaw<f64>>(
    tensor: I,
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> Option<Stages<f64, I>> {
    let moments = moments(system, time, step)?;
    let start = state.angular_velocity.into();
    Some(Stages::new(tensor, start, step, &moments))
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
        differences: [y - z, z - x, x - y],
        inverse: [a, b, c],
    }
}

/// The state after the step.
#[inline(always)]
pub(super) fn end<I: Tensor<f64>>(stages: &Stages<f64, I>, state: &State<f64>) -> State<f64> {
    let before = (state.attitude.components(), state.angular_velocity.into());
    let (attitude, omega) = stages.state(before.0, before.1);
    State {
        attitude: Quaternion::new(attitude),
        angular_velocity: omega.into(),
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
fn write<R: Registers, I: Tensor<f64>, J: Tensor<R::Wide>, const N: usize>(
    registers: R,
    stages: &Stages<f64, I>,
    tensor: J,
    out: &mut StepJacobian<N>,
) {
    out.state = end(stages, &out.state);
    let wide = stages.splat(registers, tensor);
    let columns = &mut out.matrix.data.0;
    // From the last rows to the first: what a register holds beyond the sixth row falls on the column after, whose
    // rows come later.
    match R::LANES {
        8 => rows(registers, &wide, 0, columns),
        4 => {
            rows(registers, &wide, 4, columns);
            rows(registers, &wide, 0, columns);
        }
        lanes => {
            for first in (0..6).step_by(lanes).rev() {
                rows(registers, &wide, first, columns);
            }
        }
    }
    let turn = matrix(stages.end);
    for (row, values) in turn.iter().enumerate() {
        for (column, value) in values.iter().enumerate() {
            columns[row][column] = value * stages.unit;
            columns[row][3 + column] = 0.0;
        }
    }
}

/// The rows from `first` on, as many as a register holds, of the columns after those of θ.
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

impl Full<f64> {
    #[inline(always)]
    fn splat<R: Registers>(&self, registers: R) -> Full<R::Wide> {
        Full {
            entries: splat(registers, self.entries),
            inverse: splat(registers, self.inverse),
        }
    }
}

impl Principal<f64> {
    #[inline(always)]
    fn splat<R: Registers>(&self, registers: R) -> Principal<R::Wide> {
        Principal {
            differences: splat(registers, self.differences),
            inverse: splat(registers, self.inverse),
        }
    }
}

impl<I> Stages<f64, I> {
    #[inline(always)]
    fn splat<R: Registers, J>(&self, registers: R, tensor: J) -> Stages<R::Wide, J> {
        let [a, b, c, d] = &self.stages;
        Stages {
            tensor,
            step: self.step,
            stages: [
                a.splat(registers),
                b.splat(registers),
                c.splat(registers),
                d.splat(registers),
            ],
            end: splat(registers, self.end),
            unit: registers.splat(self.unit),
            mean_turn: splat(registers, self.mean_turn),
            mean: splat(registers, self.mean),
        }
    }
}

impl Stage<f64> {
    #[inline(always)]
    fn splat<R: Registers>(&self, registers: R) -> Stage<R::Wide> {
        Stage {
            half: splat(registers, self.half),
            acceleration: splat(registers, self.acceleration),
            slope: splat_rows(registers, self.slope),
            by_time: splat(registers, self.by_time),
            by_inertia: ByInertia {
                against: splat(registers, self.by_inertia.against),
                products: splat(registers, self.by_inertia.products),
                off: splat_rows(registers, self.by_inertia.off),
            },
            turn: splat(registers, self.turn),
            turn_rate: splat(registers, self.turn_rate),
        }
    }
}
