//! The product that chains the Jacobians of two steps, in registers: it is taken once a step, and must not cost as much.

use crate::motion::registers::{Arithmetic, Registers, Work, in_widest};
use nalgebra::SMatrix;

/// Takes derivatives of the state before a step to those of the state after it: its Jacobian in the state times each column, and
/// besides what the step itself gives to that column. The columns are those of a Jacobian from number `from` on.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::motion) fn chain<const N: usize, const M: usize>(
    columns: &mut SMatrix<f64, 6, M>,
    from: usize,
    step: &SMatrix<f64, 6, N>,
) {
    in_widest(Chain {
        columns: &mut columns.data.0,
        from,
        step: &step.data.0,
    });
}

/// Columns of six rows.
struct Chain<'a, const N: usize, const M: usize> {
    columns: &'a mut [[f64; 6]; M],
    from: usize,
    step: &'a [[f64; 6]; N],
}

impl<const N: usize, const M: usize> Work for Chain<'_, N, M> {
    type Output = ();

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(self, registers: R) {
        // With room for the widest register behind the sixth row.
        let mut padded = [[0.0; 8]; N];
        for (room, column) in padded.iter_mut().zip(self.step) {
            room[..6].copy_from_slice(column);
        }
        for (number, column) in (self.from..).zip(self.columns) {
            let before = *column;
            let mut row = 0;
            while row < 6 {
                let mut sum = registers.splat(0.0);
                if let (6.., Some(own)) = (number, padded.get(number)) {
                    sum = registers.load(&own[row..]);
                }
                for (by_state, factor) in padded.iter().zip(before) {
                    let by_state = registers.load(&by_state[row..]);
                    sum = sum.plus_product(by_state, registers.splat(factor));
                }
                let mut room = [0.0; 8];
                registers.store(sum, &mut room);
                let rows = R::LANES.min(6 - row);
                column[row..row + rows].copy_from_slice(&room[..rows]);
                row += R::LANES;
            }
        }
    }
}
