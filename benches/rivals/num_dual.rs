//! The step written out on dual numbers of the crate num-dual, as its best user would: no matrix type, constants without
//! derivatives, and no more columns at once than registers take.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector6};
use num_dual::{Dual64, DualNum, DualSVec64};
use polhode::motion::{Quaternion, State};
use std::ops::Mul;

/// A dual number of doubles.
pub(crate) trait Scalar: DualNum<Primitive = f64, InnerDual = f64> + Copy {}
impl<T: DualNum<Primitive = f64, InnerDual = f64> + Copy> Scalar for T {}

/// A law of torque for the rival: time, quaternion and ω.
pub(crate) trait Law: Copy {
    /// Whether an added torque stands in space.
    const IN_SPACE: bool = false;

    fn torque<T: Scalar>(&self, time: T, attitude: &[T; 4], omega: &[T; 3]) -> [T; 3];
}

/// The components in the body of a vector of space.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn seen<T: Scalar + Mul<V, Output = T>, V: Copy>(
    [w, a, b, c]: &[T; 4],
    [x, y, z]: [V; 3],
) -> [T; 3] {
    let (w, a, b, c) = (*w, *a, *b, *c);
    let (ww, aa, bb, cc) = (w * w, a * a, b * b, c * c);
    let (ab, ac, bc) = (a * b * 2.0, a * c * 2.0, b * c * 2.0);
    let (wa, wb, wc) = (w * a * 2.0, w * b * 2.0, w * c * 2.0);
    [
        (ww + aa - bb - cc) * x + (ab + wc) * y + (ac - wb) * z,
        (ab - wc) * x + (ww - aa + bb - cc) * y + (bc + wa) * z,
        (ac + wb) * x + (bc - wa) * y + (ww - aa - bb + cc) * z,
    ]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn cross<T: Scalar>([a, b, c]: [T; 3], [x, y, z]: [T; 3]) -> [T; 3] {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// xx, yy, zz, xy, xz, yz, times a vector.
#[cfg_attr(not(debug_assertions), inline(always))]
fn times<T: Scalar>([xx, yy, zz, xy, xz, yz]: &[T; 6], [x, y, z]: [T; 3]) -> [T; 3] {
    [
        *xx * x + *xy * y + *xz * z,
        *xy * x + *yy * y + *yz * z,
        *xz * x + *yz * y + *zz * z,
    ]
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn inverse<T: Scalar>([xx, yy, zz, xy, xz, yz]: [T; 6]) -> [T; 6] {
    let minors = [
        yy * zz - yz * yz,
        xx * zz - xz * xz,
        xx * yy - xy * xy,
        xz * yz - xy * zz,
        xy * yz - xz * yy,
        xy * xz - xx * yz,
    ];
    let over = (xx * minors[0] + xy * minors[3] + xz * minors[4]).recip();
    minors.map(|minor| minor * over)
}

/// The inputs of a step.
pub(crate) struct Input<T> {
    state: [T; 7],
    torque: [T; 3],
    inertia: [T; 6],
    step: T,
}

impl<T: Scalar> Input<T> {
    /// Column `c` is the variable `c`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(
        inertia: &Matrix3<f64>,
        state: &State<f64>,
        step: f64,
        variable: impl Fn(f64, usize) -> T,
    ) -> Self {
        let [w, a, b, c] = state.attitude.components();
        let [x, y, z] = [0, 1, 2].map(|i| variable(0.0, i) * 0.5);
        let omega = &state.angular_velocity;
        let places = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        Self {
            state: [
                T::from(w) - (x * a + y * b + z * c),
                x * w + z * b - y * c + a,
                y * w + x * c - z * a + b,
                z * w + y * a - x * b + c,
                variable(omega.x, 3),
                variable(omega.y, 4),
                variable(omega.z, 5),
            ],
            torque: [6, 7, 8].map(|c| variable(0.0, c)),
            inertia: std::array::from_fn(|i| variable(inertia[places[i]], 9 + i)),
            step: variable(step, 15),
        }
    }

    /// The classical step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn stepped<L: Law>(&self, law: &L, time: f64) -> [T; 7] {
        let inverse = inverse(self.inertia);
        let rates = |time: T, [w, x, y, z, p, q, r]: &[T; 7]| {
            let (w, x, y, z) = (*w, *x, *y, *z);
            let omega = [*p, *q, *r];
            let torque = law.torque(time, &[w, x, y, z], &omega);
            let added = match L::IN_SPACE {
                true => seen(&[w, x, y, z], self.torque),
                false => self.torque,
            };
            let gyroscopic = cross(omega, times(&self.inertia, omega));
            let net = std::array::from_fn(|i| torque[i] + added[i] - gyroscopic[i]);
            let [d, e, f] = times(&inverse, net);
            let [a, b, c] = omega.map(|o| o * 0.5);
            let scalar = -(x * a + y * b + z * c);
            [
                scalar,
                w * a + y * c - z * b,
                w * b - x * c + z * a,
                w * c + x * b - y * a,
                d,
                e,
                f,
            ]
        };
        let along = |rates: &[T; 7], span: T| {
            std::array::from_fn::<T, 7, _>(|i| self.state[i] + rates[i] * span)
        };
        let (start, half) = (T::from(time), self.step * 0.5);
        let first = rates(start, &self.state);
        let second = rates(start + half, &along(&first, half));
        let third = rates(start + half, &along(&second, half));
        let fourth = rates(start + self.step, &along(&third, self.step));
        let sum = std::array::from_fn(|i| first[i] + (second[i] + third[i]) * 2.0 + fourth[i]);
        let mut end = along(&sum, self.step * (1.0 / 6.0));
        let [w, x, y, z, ..] = end;
        let size = (w * w + x * x + y * y + z * z).sqrt().recip();
        for component in &mut end[..4] {
            *component *= size;
        }
        end
    }
}

/// The turn of the body side that the rate of a unit quaternion is.
fn turn([w, a, b, c]: [f64; 4], [s, x, y, z]: [f64; 4]) -> Vector3<f64> {
    let gained = Vector3::new(w * x - a * s, w * y - b * s, w * z - c * s);
    (gained + Vector3::new(x, y, z).cross(&Vector3::new(a, b, c))) * 2.0
}

/// Columns in one pass: more make dual numbers that are copied instead of kept in registers.
const PASS: usize = 6;

/// The first `N` columns of the Jacobian.
#[inline(never)]
pub(crate) fn columns<const N: usize>(
    law: &impl Law,
    inertia: &Matrix3<f64>,
    state: &State<f64>,
    step: f64,
) -> (State<f64>, SMatrix<f64, 6, N>) {
    let mut matrix = SMatrix::<f64, 6, N>::zeros();
    let mut end = *state;
    for first in (0..N).step_by(PASS) {
        let variable = |value: f64, column: usize| {
            let number = DualSVec64::<PASS>::from_re(value);
            match column.checked_sub(first) {
                Some(place) if place < PASS && column < N => number.derivative(place),
                _ => number,
            }
        };
        let found = Input::new(inertia, state, step, variable).stepped(law, 0.0);
        let [w, x, y, z, p, q, r] = found.map(|c| c.re);
        let parts = found.map(|c| c.eps.0.unwrap_or_else(SVector::zeros));
        for k in 0..PASS.min(N - first) {
            let [a, b, c, d, ..] = parts.map(|part| part[k]);
            let theta = turn([w, x, y, z], [a, b, c, d]);
            let omega = [parts[4][k], parts[5][k], parts[6][k]];
            let column = [theta.x, theta.y, theta.z, omega[0], omega[1], omega[2]];
            matrix.set_column(first + k, &column.into());
        }
        end = State {
            attitude: Quaternion::new([w, x, y, z]),
            angular_velocity: Vector3::new(p, q, r),
        };
    }
    (end, matrix)
}

/// The Jacobian times a direction.
#[inline(never)]
pub(crate) fn along(
    law: &impl Law,
    inertia: &Matrix3<f64>,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, 15>,
) -> Vector6<f64> {
    let variable =
        |value, column: usize| Dual64::new(value, direction.get(column).copied().unwrap_or(0.0));
    let end = Input::new(inertia, state, step, variable).stepped(law, 0.0);
    let attitude = [end[0].re, end[1].re, end[2].re, end[3].re];
    let theta = turn(attitude, [end[0].eps, end[1].eps, end[2].eps, end[3].eps]);
    Vector6::new(
        theta.x, theta.y, theta.z, end[4].eps, end[5].eps, end[6].eps,
    )
}

/// The step alone.
#[inline(never)]
pub(crate) fn plain(
    law: &impl Law,
    inertia: &Matrix3<f64>,
    state: &State<f64>,
    step: f64,
) -> [f64; 7] {
    Input::new(inertia, state, step, |value, _| value).stepped(law, 0.0)
}

/// The gradient of a cost of as many steps as there are costs but one.
#[inline(never)]
pub(crate) fn gradient(
    law: &impl Law,
    inertia: &Matrix3<f64>,
    state: &State<f64>,
    step: f64,
    costs: &[Vector6<f64>],
) -> SVector<f64, 15> {
    let (mut state, mut steps) = (*state, Vec::with_capacity(costs.len()));
    for _ in 1..costs.len() {
        let (end, matrix) = columns::<15>(law, inertia, &state, step);
        steps.push(matrix);
        state = end;
    }
    pulled_back(&steps, costs)
}

/// The gradient of a cost, backwards through the columns of each step.
pub(crate) fn pulled_back(
    steps: &[SMatrix<f64, 6, 15>],
    costs: &[Vector6<f64>],
) -> SVector<f64, 15> {
    let mut gradient = SVector::<f64, 15>::zeros();
    let mut covector = costs.last().copied().unwrap_or_else(Vector6::zeros);
    for (step, cost) in steps.iter().zip(costs).rev() {
        let found = step.tr_mul(&covector);
        gradient += found;
        covector = found.fixed_rows::<6>(0) + cost;
    }
    gradient
}
