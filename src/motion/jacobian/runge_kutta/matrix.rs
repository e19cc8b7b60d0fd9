//! The whole Jacobian: six rows at once, back through the stages.

use super::{Back, Columns, PARTS, Stage, WEIGHTS};
use crate::mechanics::{regressor, skew};
use crate::motion::{Number, Quaternion};
use nalgebra::Matrix3;

/// Six rows (θ', ω') of three columns, column by column.
type Rows<T> = [[T; 6]; 3];

/// What the way back carries from one stage to the one before.
struct Carried<T> {
    of_acceleration: Rows<T>,
    /// The adjoint of a stage's attitude rate is 2 end e_r S / |end|² for row r, with S the same for all rows.
    chain: Quaternion<T>,
}

impl<T: Number> Back<'_, T> {
    #[inline(always)]
    pub(super) fn columns<const N: usize>(&self) -> Columns<T, N> {
        let mut matrix = [[T::zero(); 6]; N];
        let turn = self.end.normalised().matrix();
        for i in 0..3 {
            for row in 0..3 {
                matrix[i][row] = turn[(i, row)];
            }
            matrix[3 + i][3 + i] = T::one();
        }
        let last = self.step * T::of(WEIGHTS[3]);
        let mut carried = Carried {
            of_acceleration: identity(last),
            chain: Quaternion::identity() * last,
        };
        for i in (0..4).rev() {
            carried = self.back(&mut matrix, i, &carried);
        }
        if N > 15 {
            let unit = T::of(2.0) / self.end.norm_squared();
            let turned = (self.end.conjugate() * self.mean).v * unit;
            let mean = self.mean_acceleration();
            for i in 0..3 {
                matrix[15][i] += turned[i];
                matrix[15][3 + i] += mean[i];
            }
        }
        matrix
    }

    /// Back through stage `i`.
    #[inline(always)]
    fn back<const N: usize>(
        &self,
        matrix: &mut Columns<T, N>,
        i: usize,
        carried: &Carried<T>,
    ) -> Carried<T> {
        let stage = &self.stages[i];
        let unit = T::one() / self.end.norm_squared();
        let of_moment = times(&carried.of_acceleration, self.inverse);
        let mut of_omega = times(&of_moment, &stage.slope);
        let direct = sandwich(&(stage.turn.conjugate() * self.end), &carried.chain);
        for (column, rows) in of_omega.iter_mut().enumerate() {
            for row in 0..3 {
                rows[row] += unit * direct[(column, row)];
            }
        }
        add(matrix, 3, &of_omega);
        if N > 6 {
            add(matrix, 6, &of_moment);
        }
        if N > 9 {
            by_inertia(matrix, stage, &of_moment);
        }
        let spin = Quaternion {
            w: T::zero(),
            v: stage.omega,
        };
        let of_turn = carried.chain * spin * T::of(-0.5);
        if N > 15 && i > 0 {
            self.span(
                matrix,
                i,
                (&of_omega, &of_moment),
                &(of_turn * (unit + unit)),
            );
        }
        let span = self.step * T::of(PARTS[i]);
        let next = self.step * T::of(WEIGHTS[i.saturating_sub(1)]);
        let mut of_acceleration = identity(next);
        for (to, from) in of_acceleration.iter_mut().zip(&of_omega) {
            for (a, b) in to.iter_mut().zip(from) {
                *a += span * *b;
            }
        }
        Carried {
            of_acceleration,
            chain: Quaternion::identity() * next + of_turn * span,
        }
    }

    /// The part of the step's length that comes in at the start of stage `i`.
    #[inline(always)]
    fn span<const N: usize>(
        &self,
        matrix: &mut Columns<T, N>,
        i: usize,
        (of_omega, of_moment): (&Rows<T>, &Rows<T>),
        of_turn: &Quaternion<T>,
    ) {
        let (stage, before) = (&self.stages[i], &self.stages[i - 1]);
        // ⟨end e_r S, p⟩ is component r of end* p S*.
        let turned = (self.end.conjugate() * before.turn_rate * of_turn.conjugate()).v;
        for row in 0..6 {
            let mut sum = if row < 3 { turned[row] } else { T::zero() };
            for k in 0..3 {
                sum += of_omega[k][row] * before.acceleration[k]
                    + of_moment[k][row] * stage.by_time[k];
            }
            matrix[15][row] += T::of(PARTS[i]) * sum;
        }
    }
}

/// The columns of the inertia: a change of the tensor takes from the moment what the regressor says.
#[inline(always)]
fn by_inertia<T: Number, const N: usize>(
    matrix: &mut Columns<T, N>,
    stage: &Stage<T>,
    of_moment: &Rows<T>,
) {
    let moments = regressor(&stage.omega, &stage.acceleration);
    for (column, moment) in matrix[9..15].iter_mut().zip(moments.column_iter()) {
        for (row, value) in column.iter_mut().enumerate() {
            *value -= of_moment[0][row] * moment[0]
                + of_moment[1][row] * moment[1]
                + of_moment[2][row] * moment[2];
        }
    }
}

/// `factor` in the rows of ω'.
#[inline(always)]
fn identity<T: Number>(factor: T) -> Rows<T> {
    let mut rows = [[T::zero(); 6]; 3];
    for (i, column) in rows.iter_mut().enumerate() {
        column[3 + i] = factor;
    }
    rows
}

/// Rows times a matrix.
#[inline(always)]
fn times<T: Number>(rows: &Rows<T>, m: &Matrix3<T>) -> Rows<T> {
    let mut product = [[T::zero(); 6]; 3];
    for (column, out) in product.iter_mut().enumerate() {
        let (a, b, c) = (m[(0, column)], m[(1, column)], m[(2, column)]);
        for (r, value) in out.iter_mut().enumerate() {
            *value = rows[0][r] * a + rows[1][r] * b + rows[2][r] * c;
        }
    }
    product
}

/// Adds rows to the three columns from `from`.
#[inline(always)]
fn add<T: Number, const N: usize>(matrix: &mut Columns<T, N>, from: usize, rows: &Rows<T>) {
    for (column, rows) in matrix[from..from + 3].iter_mut().zip(rows) {
        for (value, row) in column.iter_mut().zip(rows) {
            *value += *row;
        }
    }
}

/// The matrix of e ↦ Im(p e s) for pure e: (ab + u·v) 1 + [b u − a v]× − u vᵀ − v uᵀ with p = a + u, s = b + v.
#[inline(always)]
fn sandwich<T: Number>(p: &Quaternion<T>, s: &Quaternion<T>) -> Matrix3<T> {
    let turned = skew(&(p.v * s.w - s.v * p.w));
    let same = p.w * s.w + p.v.dot(&s.v);
    Matrix3::from_fn(|r, c| {
        let across = turned[(r, c)] - p.v[r] * s.v[c] - s.v[r] * p.v[c];
        if r == c { same + across } else { across }
    })
}
