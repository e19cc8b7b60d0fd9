//! The Jacobians of eight bodies, the same row of each side by side in registers.

use super::algebra::{axes, loaded};
use super::alone::{full, principal};
use super::moments::{ByTurn, Linear, Moment, Moments, Parts, Seen, parts, some_length};
use super::stages::{Stages, Start};
use super::tensor::{Full, Principal, Tensor};
use crate::motion::block::{Block, LANES, Lane};
use crate::motion::registers::{Arithmetic, Registers, Work, in_widest};
use crate::motion::{Frame, System, TorqueLaw};

/// Eight steps and the columns of their Jacobians; `false` if the law is none that is linear in ω and in
/// a vector of space.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn block_with_jacobian<const N: usize, L: TorqueLaw<f64>>(
    system: &impl Fn(usize) -> System<f64, L>,
    time: f64,
    block: &mut Block,
    step: f64,
    columns: &mut [[Lane; 6]; N],
) -> bool {
    L::LINEAR
        && in_widest(Eight {
            system,
            time,
            step,
            block,
            columns,
        })
}

struct Eight<'a, const N: usize, F> {
    system: &'a F,
    time: f64,
    step: f64,
    block: &'a mut Block,
    columns: &'a mut [[Lane; 6]; N],
}

impl<const N: usize, L: TorqueLaw<f64>, F: Fn(usize) -> System<f64, L>> Work for Eight<'_, N, F> {
    type Output = bool;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(self, registers: R) -> bool {
        let (system, time, step) = (self.system, self.time, some_length(self.step));
        // The bodies of a block are under one law.
        let first = system(0);
        let Some(parts) = parts(&first, time, step) else {
            return false;
        };
        let mut rows = Rows {
            registers,
            step,
            in_space: first.law().added_in() == Frame::Space,
            block: self.block,
            columns: self.columns,
        };
        match parts {
            Parts::Linear(linear) => rows.of(system, &linear.splat(registers)),
            Parts::Seen(seen) => rows.of(system, &seen.splat(registers)),
        }
        true
    }
}

/// The moments of a law as bodies see them that start their step in certain axes.
trait Shared<T: Arithmetic> {
    fn seen(&self, axes: [[T; 3]; 3]) -> impl Moments<T>;
}

impl<T: Arithmetic> Shared<T> for Linear<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn seen(&self, _: [[T; 3]; 3]) -> impl Moments<T> {
        *self
    }
}

impl<T: Arithmetic> Shared<T> for Seen<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn seen(&self, axes: [[T; 3]; 3]) -> impl Moments<T> {
        self.from(axes)
    }
}

/// Where the rows of eight Jacobians go.
struct Rows<'a, const N: usize, R: Registers> {
    registers: R,
    step: f64,
    /// Whether an added torque stands in space.
    in_space: bool,
    block: &'a mut Block,
    columns: &'a mut [[Lane; 6]; N],
}

impl<const N: usize, R: Registers> Rows<'_, N, R> {
    /// All eight.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of<L: TorqueLaw<f64>>(
        &mut self,
        system: &impl Fn(usize) -> System<f64, L>,
        moments: &impl Shared<R::Wide>,
    ) {
        let registers = self.registers;
        if (0..LANES).all(|lane| system(lane).is_principal()) {
            let ratios = lanes(|lane| principal(&system(lane)).ratios);
            let inverse = lanes(|lane| principal(&system(lane)).inverse);
            for first in (0..LANES).step_by(R::LANES) {
                let tensor = Principal {
                    ratios: loaded(registers, &ratios, first),
                    inverse: loaded(registers, &inverse, first),
                };
                self.side_by_side(first, tensor, moments);
            }
        } else {
            let entries = lanes(|lane| full(&system(lane)).entries);
            let inverse = lanes(|lane| full(&system(lane)).inverse);
            for first in (0..LANES).step_by(R::LANES) {
                let tensor = Full {
                    entries: loaded(registers, &entries, first),
                    inverse: loaded(registers, &inverse, first),
                };
                self.side_by_side(first, tensor, moments);
            }
        }
    }

    /// The bodies from `first` on, as many as a register holds.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn side_by_side(
        &mut self,
        first: usize,
        tensor: impl Tensor<R::Wide>,
        moments: &impl Shared<R::Wide>,
    ) {
        let registers = self.registers;
        let [w, x, y, z, a, b, c] = loaded(registers, self.block.lanes(), first);
        let axes = axes([w, x, y, z]);
        let start = Start {
            attitude: [w, x, y, z],
            omega: [a, b, c],
            step: self.step,
            axes: self.in_space.then_some(axes),
        };
        let stages = Stages::new(tensor, &moments.seen(axes), start);
        let ([w, x, y, z], [a, b, c]) = stages.state();
        let (lanes, values) = (self.block.lanes_mut(), [w, x, y, z, a, b, c]);
        for i in 0..7 {
            registers.store(values[i], &mut lanes[i][first..]);
        }
        self.row::<_, _, 0>(first, &stages);
        self.row::<_, _, 1>(first, &stages);
        self.row::<_, _, 2>(first, &stages);
        self.row::<_, _, 3>(first, &stages);
        self.row::<_, _, 4>(first, &stages);
        self.row::<_, _, 5>(first, &stages);
    }

    /// The row `ROW` of each Jacobian.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn row<I: Tensor<R::Wide>, D: ByTurn<R::Wide>, const ROW: usize>(
        &mut self,
        first: usize,
        stages: &Stages<R::Wide, I, Moment<R::Wide, D>>,
    ) {
        let registers = self.registers;
        let mut seed = [registers.splat(0.0); 3];
        seed[ROW % 3] = registers.splat(1.0);
        let (of_theta, of_omega) = if ROW < 3 {
            (Some(seed), None)
        } else {
            (None, Some(seed))
        };
        let pulled = stages.pulled_back::<N>(of_theta, of_omega);
        self.put::<ROW, 3>(first, 0, pulled.theta);
        self.put::<ROW, 3>(first, 3, pulled.omega);
        self.put::<ROW, 3>(first, 6, pulled.torque);
        self.put::<ROW, 6>(first, 9, pulled.inertia);
        self.put::<ROW, 1>(first, 15, [pulled.span]);
    }

    /// Writes the row in the columns from `column` on, if they are asked for.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn put<const ROW: usize, const M: usize>(
        &mut self,
        first: usize,
        column: usize,
        values: [R::Wide; M],
    ) {
        for (column, value) in self.columns.iter_mut().skip(column).zip(values) {
            self.registers.store(value, &mut column[ROW][first..]);
        }
    }
}

/// Numbers of eight bodies side by side.
#[cfg_attr(not(debug_assertions), inline(always))]
fn lanes<const N: usize>(of: impl Fn(usize) -> [f64; N]) -> [Lane; N] {
    let mut lanes = [[0.0; LANES]; N];
    for body in 0..LANES {
        for (lane, value) in lanes.iter_mut().zip(of(body)) {
            lane[body] = value;
        }
    }
    lanes
}
