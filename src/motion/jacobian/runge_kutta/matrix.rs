//! The whole Jacobian, row by row: every row takes the same operations, so that a loop over the rows of one body or
//! over the same row of many bodies runs on whole registers.

use super::{Back, PARTS, WEIGHTS};
use crate::mechanics::{apply, regressor, skew};
use crate::motion::{Quaternion, block::LANES, block::Lane};
use nalgebra::{Matrix3, SVector, Vector3};

/// What a stage gives to the way back, the same for all rows.
#[derive(Clone, Copy)]
struct Pull {
    omega: Vector3<f64>,
    acceleration: Vector3<f64>,
    /// The transposes of the slopes of the net moment in ω and of the end's attitude in the stage's ω.
    slope: Matrix3<f64>,
    direct: Matrix3<f64>,
}

/// Numbers in a [`Pull`].
const PULL: usize = 24;

/// The four stages of eight bodies, number by number.
pub(super) type Tape = [[Lane; PULL]; 4];

/// A tape with nothing on it.
pub(super) const EMPTY: Tape = [[[0.0; LANES]; PULL]; 4];

impl Pull {
    #[inline(always)]
    fn write(&self, tape: &mut [Lane; PULL], lane: usize) {
        for i in 0..3 {
            tape[i][lane] = self.omega[i];
            tape[3 + i][lane] = self.acceleration[i];
        }
        for i in 0..9 {
            tape[6 + i][lane] = self.slope[(i / 3, i % 3)];
            tape[15 + i][lane] = self.direct[(i / 3, i % 3)];
        }
    }

    #[inline(always)]
    fn read(tape: &[Lane; PULL], lane: usize) -> Self {
        let vector = |first: usize| {
            Vector3::new(
                tape[first][lane],
                tape[first + 1][lane],
                tape[first + 2][lane],
            )
        };
        let rows = |first: usize| {
            let [a, b, c] = [vector(first), vector(first + 3), vector(first + 6)];
            Matrix3::new(a.x, a.y, a.z, b.x, b.y, b.z, c.x, c.y, c.z)
        };
        Self {
            omega: vector(0),
            acceleration: vector(3),
            slope: rows(6),
            direct: rows(15),
        }
    }
}

/// A row on its way back: the covector (of θ', of ω'), and what has come together so far.
struct Row {
    of_theta: Vector3<f64>,
    of_end: Vector3<f64>,
    of_acceleration: Vector3<f64>,
    omega: Vector3<f64>,
    torque: Vector3<f64>,
    inertia: [f64; 6],
}

impl Row {
    #[inline(always)]
    fn new(of_theta: Vector3<f64>, of_end: Vector3<f64>, step: f64) -> Self {
        Self {
            of_theta,
            of_end,
            of_acceleration: of_end * (step * WEIGHTS[3]),
            omega: of_end,
            torque: Vector3::zeros(),
            inertia: [0.0; 6],
        }
    }

    /// Back through stage `i`; a `turning` row is one of θ'.
    #[inline(always)]
    fn back<const N: usize>(
        &mut self,
        i: usize,
        pull: &Pull,
        inverse: &Matrix3<f64>,
        step: f64,
        turning: bool,
    ) {
        // The inverse is symmetric.
        let of_moment = apply(inverse, &self.of_acceleration);
        let mut of_omega = apply(&pull.slope, &of_moment);
        if turning {
            of_omega += apply(&pull.direct, &self.of_theta);
        }
        self.omega += of_omega;
        if N > 6 {
            self.torque += of_moment;
        }
        if N > 9 {
            let moments = regressor(&pull.omega, &pull.acceleration);
            for (k, sum) in self.inertia.iter_mut().enumerate() {
                *sum -= moments[(0, k)] * of_moment.x
                    + moments[(1, k)] * of_moment.y
                    + moments[(2, k)] * of_moment.z;
            }
        }
        if i > 0 {
            self.of_acceleration =
                self.of_end * (step * WEIGHTS[i - 1]) + of_omega * (step * PARTS[i]);
        }
    }

    #[inline(always)]
    fn all<const N: usize>(
        mut self,
        pulls: impl Fn(usize) -> Pull,
        inverse: &Matrix3<f64>,
        step: f64,
        turning: bool,
    ) -> Self {
        self.back::<N>(3, &pulls(3), inverse, step, turning);
        self.back::<N>(2, &pulls(2), inverse, step, turning);
        self.back::<N>(1, &pulls(1), inverse, step, turning);
        self.back::<N>(0, &pulls(0), inverse, step, turning);
        self
    }

    /// Writes column 3 and those after it by `write(column, value)`.
    #[inline(always)]
    fn write<const N: usize>(&self, mut write: impl FnMut(usize, f64)) {
        for k in 0..3 {
            write(3 + k, self.omega[k]);
            if N > 6 {
                write(6 + k, self.torque[k]);
            }
        }
        if N > 9 {
            for (k, value) in self.inertia.iter().enumerate() {
                write(9 + k, *value);
            }
        }
    }
}

/// The rows as covectors, three of θ' and three of ω'.
const OF_THETA: [[f64; 6]; 3] = [
    [1.0, 0.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 1.0, 0.0, 0.0, 0.0, 0.0],
    [0.0, 0.0, 1.0, 0.0, 0.0, 0.0],
];
const OF_OMEGA: [[f64; 6]; 3] = [
    [0.0, 0.0, 0.0, 1.0, 0.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 1.0, 0.0],
    [0.0, 0.0, 0.0, 0.0, 0.0, 1.0],
];

impl Back<'_> {
    #[inline(always)]
    pub(super) fn columns<const N: usize>(&self) -> [[f64; 6]; N] {
        let mut columns = [[0.0; 6]; N];
        let pulls = self.pulls();
        for r in 0..6 {
            let part = |of: &[[f64; 6]; 3]| Vector3::new(of[0][r], of[1][r], of[2][r]);
            let row = Row::new(part(&OF_THETA), part(&OF_OMEGA), self.step);
            let row = row.all::<N>(|i| pulls[i], self.inverse, self.step, true);
            row.write::<N>(|column, value| columns[column][r] = value);
        }
        let turn = self.end.normalised().matrix();
        for (i, column) in columns.iter_mut().take(3).enumerate() {
            for (row, value) in column.iter_mut().take(3).enumerate() {
                *value = turn[(i, row)];
            }
        }
        if N > 15 {
            columns[15] = self.by_time();
        }
        columns
    }

    /// The derivative in the length of the step.
    #[inline(always)]
    fn by_time(&self) -> [f64; 6] {
        let mut direction = SVector::<f64, 16>::zeros();
        direction[15] = 1.0;
        self.along(&direction).into()
    }

    #[inline(always)]
    fn pulls(&self) -> [Pull; 4] {
        let unit = 1.0 / self.end.norm_squared();
        let [first, second, third, fourth] = &self.stages;
        let half = |stage: &super::Stage| Quaternion {
            w: 0.0,
            v: stage.omega * -0.5,
        };
        // The adjoint of a stage's attitude rate is 2 end e S / |end|² for a row e, with S the same for all rows.
        let one = Quaternion::identity() * self.step;
        let last = one * WEIGHTS[3];
        let third_chain = one * WEIGHTS[2] + last * half(fourth) * (self.step * PARTS[3]);
        let second_chain = one * WEIGHTS[1] + third_chain * half(third) * (self.step * PARTS[2]);
        let first_chain = one * WEIGHTS[0] + second_chain * half(second) * (self.step * PARTS[1]);
        let pull = |stage: &super::Stage, chain: &Quaternion<f64>| Pull {
            omega: stage.omega,
            acceleration: stage.acceleration,
            slope: stage.slope.transpose(),
            direct: sandwich(&(stage.turn.conjugate() * self.end), chain, unit),
        };
        [
            pull(first, &first_chain),
            pull(second, &second_chain),
            pull(third, &third_chain),
            pull(fourth, &last),
        ]
    }

    /// Writes what the way back needs, and the columns that need no way back.
    #[inline(always)]
    pub(super) fn record<const N: usize>(
        &self,
        tape: &mut Tape,
        columns: &mut [[Lane; 6]; N],
        lane: usize,
    ) {
        for (pull, tape) in self.pulls().iter().zip(tape) {
            pull.write(tape, lane);
        }
        let turn = self.end.normalised().matrix();
        for i in 0..3 {
            for row in 0..3 {
                columns[i][row][lane] = turn[(i, row)];
                columns[i][3 + row][lane] = 0.0;
            }
        }
        if N > 15 {
            let rates = self.by_time();
            for (row, rate) in rates.iter().enumerate() {
                columns[15][row][lane] = *rate;
            }
        }
    }
}

/// The row `R` of eight Jacobians, from what was recorded of their stages.
#[inline(always)]
pub(super) fn rows<const N: usize, const R: usize>(
    tape: &Tape,
    inverse: impl Fn(usize) -> Matrix3<f64>,
    step: f64,
    columns: &mut [[Lane; 6]; N],
) {
    for lane in 0..LANES {
        let part = |of: &[[f64; 6]; 3]| Vector3::new(of[0][R], of[1][R], of[2][R]);
        let row = Row::new(part(&OF_THETA), part(&OF_OMEGA), step);
        let pulls = |i: usize| Pull::read(&tape[i], lane);
        let row = row.all::<N>(pulls, &inverse(lane), step, R < 3);
        row.write::<N>(|column, value| put(columns, (column, R, lane), value));
    }
}

#[inline(always)]
fn put<const N: usize>(
    columns: &mut [[Lane; 6]; N],
    (column, row, lane): (usize, usize, usize),
    value: f64,
) {
    columns[column][row][lane] = value;
}

/// The matrix of e ↦ f Im(p e s) for pure e: (ab + u·v) 1 + [b u − a v]× − u vᵀ − v uᵀ with p = a + u, s = b + v.
#[inline(always)]
fn sandwich(p: &Quaternion<f64>, s: &Quaternion<f64>, factor: f64) -> Matrix3<f64> {
    let turned = skew(&(p.v * s.w - s.v * p.w));
    let same = p.w * s.w + p.v.dot(&s.v);
    Matrix3::from_fn(|r, c| {
        let across = turned[(r, c)] - p.v[r] * s.v[c] - s.v[r] * p.v[c];
        factor * if r == c { same + across } else { across }
    })
}
