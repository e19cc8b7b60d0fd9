//! The equation of variation, column beside column.
//!
//! The derivative of a motion in its start and its parameters follows a linear equation along the motion: with θ the turn
//! of the body side and J the moments along principal axes,
//!
//! δθ' = δω − ω × δθ, J δω' = δ(−ω × Jω) + δM − (δJ ω' + ω × δJ ω).
//!
//! Its matrices are the same for all columns, so they are formed once a stage, in doubles, and the columns are taken
//! through them side by side in registers. A change of the tensor is a torque: nothing is divided by differences of
//! moments, and repeated ones are nothing special.

use super::runge_kutta::algebra::{loaded, plus_cross, splat};
use super::runge_kutta::tensor::symmetric;
use crate::motion::block::{LANES, Lane};
use crate::motion::dop853::{END, Row, STAGES, TIMES, Taken, unpack};
use crate::motion::registers::{Arithmetic, Registers, Work, in_widest};
use crate::motion::system::entries;
use crate::motion::{Body, Frame, Quaternion, State, System, Torque, TorqueLaw};
use nalgebra::{Matrix3, SMatrix, Vector3};

/// Columns of which each has a register's lane: rows θ and ω.
type Columns = [Lane; 6];

/// Eight columns of a Jacobian and what makes them grow.
struct Eight {
    value: Columns,
    slopes: [Columns; 12],
    /// The column's own torque, in the axes in which one is added.
    torque: [Lane; 3],
    /// The column's own δJ along principal axes, xx, yy, zz, xy, xz, yz.
    inertia: [Lane; 6],
    /// What of these is not zero throughout.
    with_torque: bool,
    with_inertia: bool,
}

/// The columns of a Jacobian under way, along principal axes.
pub(super) struct Variation<'a> {
    body: &'a Body,
    eights: Vec<Eight>,
}

impl<'a> Variation<'a> {
    /// The first `count` columns at the start of a motion.
    pub(super) fn new(body: &'a Body, count: usize) -> Self {
        let mut eights: Vec<_> = (0..count.div_ceil(LANES)).map(|_| Eight::zeros()).collect();
        for column in 0..count {
            if let Some(eight) = eights.get_mut(column / LANES) {
                eight.begin(column % LANES, column, body.axes());
            }
        }
        Self { body, eights }
    }

    /// The columns after a step of the motion of `system`, which is along principal axes.
    pub(super) fn step(&mut self, system: &System<f64, Torque>, taken: &Taken<'_>) {
        let stages = std::array::from_fn(|i| {
            let time = taken.time + TIMES[i] * taken.span;
            let state = unpack(&taken.stages.places[i]);
            let [.., x, y, z, _] = taken.stages.slopes[i];
            let turned = (
                &state.attitude,
                &state.angular_velocity,
                Vector3::new(x, y, z),
            );
            Stage::new(system, self.body.axes(), time, turned)
        });
        in_widest(Step {
            stages: &stages,
            span: taken.span,
            eights: &mut self.eights,
        });
    }

    /// The columns in body axes.
    pub(super) fn matrix<const N: usize>(&self) -> SMatrix<f64, 6, N> {
        let inner = SMatrix::<f64, 6, N>::from_fn(|row, column| {
            let eight = self.eights.get(column / LANES);
            eight.map_or(0.0, |eight| eight.value[row][column % LANES])
        });
        let axes = self.body.axes();
        let mut found = inner;
        for (mut column, inner) in found.column_iter_mut().zip(inner.column_iter()) {
            for first in [0, 3] {
                let turned = axes * inner.fixed_rows::<3>(first);
                column.fixed_rows_mut::<3>(first).copy_from(&turned);
            }
        }
        found
    }
}

impl Eight {
    fn zeros() -> Self {
        let none = [[0.0; LANES]; 6];
        Self {
            value: none,
            slopes: [none; 12],
            torque: [[0.0; LANES]; 3],
            inertia: none,
            with_torque: false,
            with_inertia: false,
        }
    }

    /// Sets a lane to the column of that place in (θ, ω, torque, inertia).
    fn begin(&mut self, lane: usize, column: usize, axes: &Matrix3<f64>) {
        match column {
            0..6 => {
                let first = column / 3 * 3;
                for row in 0..3 {
                    self.value[first + row][lane] = axes[(column % 3, row)];
                }
            }
            6..9 => {
                self.torque[column - 6][lane] = 1.0;
                self.with_torque = true;
            }
            9..15 => {
                let (r, c) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][column - 9];
                let mut entry = Matrix3::zeros();
                (entry[(r, c)], entry[(c, r)]) = (1.0, 1.0);
                let along = axes.tr_mul(&entry) * axes;
                for (values, entry) in self.inertia.iter_mut().zip(entries(&along)) {
                    values[lane] = entry;
                }
                self.with_inertia = true;
            }
            _ => {}
        }
    }
}

/// The matrices of the equation at a stage of a step: rows of 3 × 3.
struct Stage {
    omega: [f64; 3],
    acceleration: [f64; 3],
    inverse: [f64; 3],
    by_omega: [[f64; 3]; 3],
    by_theta: Option<[[f64; 3]; 3]>,
    by_torque: [[f64; 3]; 3],
}

impl Stage {
    fn new(
        system: &System<f64, Torque>,
        axes: &Matrix3<f64>,
        time: f64,
        (attitude, omega, acceleration): (&Quaternion<f64>, &Vector3<f64>, Vector3<f64>),
    ) -> Self {
        let inverse = system.inverse().diagonal();
        let moments = system.inertia().diagonal();
        let rows = |m: Matrix3<f64>| -> [[f64; 3]; 3] {
            std::array::from_fn(|r| std::array::from_fn(|c| m[(r, c)] * inverse[r]))
        };
        let mut gyroscopic = Matrix3::zeros();
        for i in 0..3 {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            let difference = moments[j] - moments[k];
            gyroscopic[(i, j)] = difference * omega[k];
            gyroscopic[(i, k)] = difference * omega[j];
        }
        if let Torque::Damping { coefficient } = *system.law() {
            for i in 0..3 {
                gyroscopic[(i, i)] -= coefficient;
            }
        }
        let into_principal = match TorqueLaw::<f64>::added_in(system.law()) {
            Frame::Body => axes.transpose(),
            Frame::Space => attitude.matrix().transpose(),
        };
        Self {
            omega: (*omega).into(),
            acceleration: acceleration.into(),
            inverse: inverse.into(),
            by_omega: rows(gyroscopic),
            by_theta: by_theta(system.law(), time, attitude).map(rows),
            by_torque: rows(into_principal),
        }
    }
}

/// The derivative of a torque in the turn θ of the body side; `None` where it is zero. A vector γ that is constant in space
/// changes by γ × θ.
fn by_theta(law: &Torque, time: f64, attitude: &Quaternion<f64>) -> Option<Matrix3<f64>> {
    match *law {
        Torque::Gravity { weight, arm } => {
            let down = attitude.to_body(&Vector3::new(0.0, 0.0, -weight));
            Some(down * arm.transpose() - Matrix3::from_diagonal_element(arm.dot(&down)))
        }
        Torque::Constant {
            frame: Frame::Space,
            ..
        }
        | Torque::Sinusoid {
            frame: Frame::Space,
            ..
        } => {
            let turned = State {
                attitude: *attitude,
                ..State::at_rest()
            };
            let seen = law.torque(time, &turned);
            Some(seen.cross_matrix())
        }
        _ => None,
    }
}

/// A step of all columns.
struct Step<'a> {
    stages: &'a [Stage; 12],
    span: f64,
    eights: &'a mut [Eight],
}

impl Work for Step<'_> {
    type Output = ();

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn run<R: Registers>(self, registers: R) {
        for eight in self.eights {
            for first in (0..LANES).step_by(R::LANES) {
                for (i, stage) in self.stages.iter().enumerate() {
                    let mut place = loaded(registers, &eight.value, first);
                    if let Some(row) = i.checked_sub(1).and_then(|i| STAGES.get(i)).copied() {
                        place = onward(registers, eight, first, row, self.span);
                    }
                    let slope = rate(registers, stage, eight, first, place);
                    store(registers, &mut eight.slopes[i], first, slope);
                }
                let end = onward(registers, eight, first, END, self.span);
                store(registers, &mut eight.value, first, end);
            }
        }
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn store<R: Registers>(registers: R, lanes: &mut Columns, first: usize, wide: [R::Wide; 6]) {
    for i in 0..6 {
        registers.store(wide[i], &mut lanes[i][first..]);
    }
}

/// The columns and `span` times a sum of their slopes.
#[cfg_attr(not(debug_assertions), inline(always))]
fn onward<R: Registers>(
    registers: R,
    eight: &Eight,
    first: usize,
    row: Row,
    span: f64,
) -> [R::Wide; 6] {
    let mut place = loaded(registers, &eight.value, first);
    for (stage, coefficient) in row {
        let factor = registers.splat(coefficient * span);
        let slope = loaded(registers, &eight.slopes[*stage], first);
        for i in 0..6 {
            place[i] = place[i].plus_product(slope[i], factor);
        }
    }
    place
}

/// The rates of columns at a stage.
#[cfg_attr(not(debug_assertions), inline(always))]
fn rate<R: Registers>(
    registers: R,
    stage: &Stage,
    eight: &Eight,
    first: usize,
    [a, b, c, p, q, r]: [R::Wide; 6],
) -> [R::Wide; 6] {
    let omega = splat(registers, stage.omega);
    let turn = plus_cross([p, q, r], [a, b, c], omega);
    let mut faster = [registers.splat(0.0); 3];
    faster = plus_applied(registers, faster, &stage.by_omega, [p, q, r]);
    if let Some(by_theta) = &stage.by_theta {
        faster = plus_applied(registers, faster, by_theta, [a, b, c]);
    }
    if eight.with_torque {
        let torque = loaded(registers, &eight.torque, first);
        faster = plus_applied(registers, faster, &stage.by_torque, torque);
    }
    if eight.with_inertia {
        let inertia = loaded(registers, &eight.inertia, first);
        let moment = symmetric(inertia, splat(registers, stage.acceleration));
        // δJ α + ω × δJ ω.
        let against = plus_cross(moment, omega, symmetric(inertia, omega));
        let inverse = splat(registers, stage.inverse);
        for i in 0..3 {
            faster[i] = faster[i].less_product(against[i], inverse[i]);
        }
    }
    let ([a, b, c], [p, q, r]) = (turn, faster);
    [a, b, c, p, q, r]
}

/// `onto` plus a matrix times a vector.
#[cfg_attr(not(debug_assertions), inline(always))]
fn plus_applied<R: Registers>(
    registers: R,
    mut onto: [R::Wide; 3],
    rows: &[[f64; 3]; 3],
    v: [R::Wide; 3],
) -> [R::Wide; 3] {
    for r in 0..3 {
        let row = splat(registers, rows[r]);
        for c in 0..3 {
            onto[r] = onto[r].plus_product(row[c], v[c]);
        }
    }
    onto
}
