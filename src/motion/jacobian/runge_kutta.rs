//! The Jacobian of the classical Runge–Kutta step, backwards through its four stages.
//!
//! Six rows go back through the stages instead of sixteen columns forward, a lane each. What symmetry knows is
//! written down: under a torque that does not look at the attitude the step commutes with turns of space, so
//! ∂θ'/∂θ is the turn of the step and ∂ω'/∂θ is 0. A change δI of the tensor acts as the moment
//! −(δI α + ω × δI ω), so the inverse is never differentiated and repeated moments are nothing special.

mod products;

use crate::mechanics::{angular_momentum, apply, cross, regressor, skew};
use crate::motion::{Quaternion, State, StepJacobian, System, TorqueLaw};
use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};

/// Six rows (θ', ω') of three columns, column by column.
type Rows = [[f64; 6]; 3];

/// What a stage leaves behind for the way back.
struct Stage {
    omega: Vector3<f64>,
    acceleration: Vector3<f64>,
    /// The derivative of the net moment in ω.
    slope: Matrix3<f64>,
    /// The torque's own rate in time.
    by_time: Vector3<f64>,
    /// Attitude since the start of the step, and its rate ½ p ω.
    turn: Quaternion<f64>,
    turn_rate: Quaternion<f64>,
}

/// The step and its Jacobian, or `None` if the law gives a torque that depends on the attitude.
pub(crate) fn step_with_jacobian<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> Option<StepJacobian<N>> {
    Some(Back::new(system, time, state, step)?.finish(state))
}

/// The step and its Jacobian times a direction of the input.
pub(crate) fn jvp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, 16>,
) -> Option<(State<f64>, Vector6<f64>)> {
    let back = Back::new(system, time, state, step)?;
    Some((back.state(state), back.along(direction)))
}

/// The step and a covector of its result times the Jacobian.
pub(crate) fn vjp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
) -> Option<(State<f64>, SVector<f64, 16>)> {
    let back = Back::new(system, time, state, step)?;
    Some((back.state(state), back.pulled_back(covector)))
}

/// Weights of the stages in the result, and the part of the step at which each stands.
const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];
const PARTS: [f64; 4] = [0.0, 0.5, 0.5, 1.0];

struct Back<'a> {
    stages: [Stage; 4],
    inverse: &'a Matrix3<f64>,
    step: f64,
    /// The turn of the step before it is made unit, and the mean of its rate.
    end: Quaternion<f64>,
    mean: Quaternion<f64>,
}

impl<'a> Back<'a> {
    /// The stages of a step, or `None` if the law gives a torque that depends on the attitude.
    #[inline]
    fn new<L: TorqueLaw<f64>>(
        system: &'a System<f64, L>,
        time: f64,
        state: &State<f64>,
        step: f64,
    ) -> Option<Self> {
        let (inertia, inverse) = (system.inertia(), system.inverse());
        let start = state.angular_velocity;
        let stage = |part: f64, before: Option<&Stage>| {
            let span = part * step;
            let (omega, turn) = before.map_or((start, Quaternion::identity()), |b| {
                (
                    start + b.acceleration * span,
                    Quaternion::identity() + b.turn_rate * span,
                )
            });
            let torque = system.law().without_attitude(time + span, &omega)?;
            let momentum = angular_momentum(inertia, &omega);
            let net = torque.torque + system.added() - cross(&omega, &momentum);
            Some(Stage {
                acceleration: apply(inverse, &net),
                slope: torque.by_angular_velocity + skew(&momentum) - skew(&omega) * inertia,
                by_time: torque.by_time,
                turn_rate: turn.rate(&omega),
                omega,
                turn,
            })
        };
        let first = stage(0.0, None)?;
        let second = stage(0.5, Some(&first))?;
        let third = stage(0.5, Some(&second))?;
        let fourth = stage(1.0, Some(&third))?;
        let stages = [first, second, third, fourth];
        let mean = (0..4).fold(stages[0].turn_rate * 0.0, |sum, i| {
            sum + stages[i].turn_rate * WEIGHTS[i]
        });
        Some(Self {
            end: Quaternion::identity() + mean * step,
            stages,
            inverse,
            step,
            mean,
        })
    }

    fn finish<const N: usize>(&self, state: &State<f64>) -> StepJacobian<N> {
        let unit = 1.0 / self.end.norm_squared();
        let turn = self.end.normalised();
        let mut matrix = SMatrix::<f64, 6, N>::zeros();
        matrix
            .fixed_view_mut::<3, 3>(0, 0)
            .copy_from(&turn.matrix().transpose());
        for i in 3..6 {
            matrix[(i, i)] = 1.0;
        }
        // The adjoint of stage i's attitude rate is 2 end e_r S / |end|² for row r; S is the same for all rows.
        let mut chain = Quaternion::identity() * (self.step * WEIGHTS[3]);
        let mut of_acceleration = identity(self.step * WEIGHTS[3]);
        for i in (0..4).rev() {
            let stage = &self.stages[i];
            let of_moment = times(&of_acceleration, self.inverse);
            let mut of_omega = times(&of_moment, &stage.slope);
            let direct = sandwich(&(stage.turn.conjugate() * self.end), &chain);
            for (column, rows) in of_omega.iter_mut().enumerate() {
                for row in 0..3 {
                    rows[row] += unit * direct[(column, row)];
                }
            }
            add(&mut matrix, 3, &of_omega);
            self.parameters(&mut matrix, stage, &of_moment);
            let of_turn = chain
                * Quaternion {
                    w: 0.0,
                    v: stage.omega,
                }
                * -0.5;
            if i > 0 {
                if N > 15 {
                    self.span(
                        &mut matrix,
                        i,
                        &of_omega,
                        &of_moment,
                        &(of_turn * (2.0 * unit)),
                    );
                }
                let span = self.step * PARTS[i];
                chain = Quaternion::identity() * (self.step * WEIGHTS[i - 1]) + of_turn * span;
                of_acceleration = identity(self.step * WEIGHTS[i - 1]);
                for (to, from) in of_acceleration.iter_mut().zip(&of_omega) {
                    for (a, b) in to.iter_mut().zip(from) {
                        *a += span * b;
                    }
                }
            }
        }
        if N > 15 {
            let turned = (self.end.conjugate() * self.mean).v * (2.0 * unit);
            for i in 0..3 {
                matrix[(i, 15)] += turned[i];
                matrix[(3 + i, 15)] += self.mean_acceleration()[i];
            }
        }
        StepJacobian {
            state: self.state(state),
            matrix,
        }
    }

    /// Columns of torque and inertia: a torque adds to the moment, a change of the tensor takes from it.
    #[inline]
    fn parameters<const N: usize>(
        &self,
        matrix: &mut SMatrix<f64, 6, N>,
        stage: &Stage,
        of_moment: &Rows,
    ) {
        if N > 6 {
            add(matrix, 6, of_moment);
        }
        if N > 9 {
            let moments = regressor(&stage.omega, &stage.acceleration);
            for (column, moment) in (9..15).zip(moments.column_iter()) {
                for row in 0..6 {
                    matrix[(row, column)] -= of_moment[0][row] * moment[0]
                        + of_moment[1][row] * moment[1]
                        + of_moment[2][row] * moment[2];
                }
            }
        }
    }

    /// The part of the step's length that comes in at the start of stage `i`.
    fn span<const N: usize>(
        &self,
        matrix: &mut SMatrix<f64, 6, N>,
        i: usize,
        of_omega: &Rows,
        of_moment: &Rows,
        of_turn: &Quaternion<f64>,
    ) {
        let (stage, before) = (&self.stages[i], &self.stages[i - 1]);
        // ⟨end e_r S, p⟩ is component r of end* p S*.
        let turned = (self.end.conjugate() * before.turn_rate * of_turn.conjugate()).v;
        for row in 0..6 {
            let mut sum = if row < 3 { turned[row] } else { 0.0 };
            for k in 0..3 {
                sum += of_omega[k][row] * before.acceleration[k]
                    + of_moment[k][row] * stage.by_time[k];
            }
            matrix[(row, 15)] += PARTS[i] * sum;
        }
    }
}

/// `factor` in the rows of ω'.
fn identity(factor: f64) -> Rows {
    let mut rows = [[0.0; 6]; 3];
    for (i, column) in rows.iter_mut().enumerate() {
        column[3 + i] = factor;
    }
    rows
}

/// Rows times a matrix.
#[inline]
fn times(rows: &Rows, m: &Matrix3<f64>) -> Rows {
    let mut product = [[0.0; 6]; 3];
    for (column, out) in product.iter_mut().enumerate() {
        let (a, b, c) = (m[(0, column)], m[(1, column)], m[(2, column)]);
        for (r, value) in out.iter_mut().enumerate() {
            *value = rows[0][r] * a + rows[1][r] * b + rows[2][r] * c;
        }
    }
    product
}

/// Adds rows to the three columns from `from`.
#[inline]
fn add<const N: usize>(matrix: &mut SMatrix<f64, 6, N>, from: usize, rows: &Rows) {
    for (column, rows) in rows.iter().enumerate() {
        for (row, value) in rows.iter().enumerate() {
            matrix[(row, from + column)] += value;
        }
    }
}

/// The matrix of e ↦ Im(p e s) for pure e: (ab + u·v) 1 + [b u − a v]× − u vᵀ − v uᵀ with p = a + u, s = b + v.
#[inline]
fn sandwich(p: &Quaternion<f64>, s: &Quaternion<f64>) -> Matrix3<f64> {
    let outer = p.v * s.v.transpose();
    Matrix3::from_diagonal_element(p.w * s.w + p.v.dot(&s.v)) + skew(&(p.v * s.w - s.v * p.w))
        - outer
        - outer.transpose()
}
