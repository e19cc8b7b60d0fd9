//! The Runge–Kutta method of Dormand and Prince of order 8, with error control and dense output.

mod motion;
mod tableau;

pub use motion::Dop853Motion;
pub(crate) use motion::Taken;
pub(in crate::motion) use tableau::{END, Row, STAGES, TIMES};

use crate::motion::{Number, Quaternion, Scheme, State, System, TorqueLaw};
use nalgebra::Vector3;
use tableau::{DENSE, DENSE_STAGES};

/// Attitude and angular velocity side by side, and one place to fill a register.
pub(crate) type Lane<T> = [T; 8];

/// One step of the method of twelve stages, order 8; the quaternion is made unit after the step. It conserves
/// neither energy nor momentum: both drift as t h⁸.
///
/// Dormand and Prince (1980) in the form of Hairer, Nørsett, Wanner, *Solving Ordinary Differential Equations
/// I*, section II.5.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct Dop853;

impl<L> Scheme<L> for Dop853 {
    fn order(&self) -> usize {
        8
    }

    fn step<T: Number>(&self, system: &System<T, L>, time: T, state: &State<T>, step: T) -> State<T>
    where
        L: TorqueLaw<T>,
    {
        let mut slopes = [[T::zero(); 8]; 16];
        let start = pack(state);
        slopes[0] = rate(system, time, &start);
        unit(&end(system, time, &start, step, &mut slopes))
    }
}

/// The stages of a step whose first is known, and where they lead; the quaternion is not made unit.
#[inline(always)]
fn end<T: Number, L: TorqueLaw<T>>(
    system: &System<T, L>,
    time: T,
    start: &Lane<T>,
    step: T,
    slopes: &mut [Lane<T>; 16],
) -> Lane<T> {
    for (i, row) in STAGES.iter().enumerate() {
        let place = along(start, &sum(slopes, row), step);
        slopes[i + 1] = rate(system, time + step * T::of(TIMES[i + 1]), &place);
    }
    along(start, &sum(slopes, END), step)
}

/// The dense output of a step whose end is stage 12, as `contd8` of `dop853.f` nests it.
fn dense<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    start: &Lane<f64>,
    end: &Lane<f64>,
    step: f64,
    slopes: &mut [Lane<f64>; 16],
) -> [Lane<f64>; 8] {
    for (i, row) in (13..).zip(DENSE_STAGES) {
        let place = along(start, &sum(slopes, row), step);
        slopes[i] = rate(system, time + step * TIMES[i], &place);
    }
    let change: Lane<f64> = std::array::from_fn(|i| end[i] - start[i]);
    let bend: Lane<f64> = std::array::from_fn(|i| step * slopes[0][i] - change[i]);
    let twist = std::array::from_fn(|i| change[i] - step * slopes[12][i] - bend[i]);
    let [a, b, c, d] = DENSE.map(|row| sum(slopes, row).map(|s| s * step));
    [*start, change, bend, twist, a, b, c, d]
}

#[inline(always)]
fn pack<T: Number>(state: &State<T>) -> Lane<T> {
    let ([w, x, y, z], o) = (state.attitude.components(), &state.angular_velocity);
    [w, x, y, z, o.x, o.y, o.z, T::zero()]
}

#[inline(always)]
pub(crate) fn unpack<T: Number>([w, x, y, z, a, b, c, _]: &Lane<T>) -> State<T> {
    State {
        attitude: Quaternion::new([*w, *x, *y, *z]),
        angular_velocity: Vector3::new(*a, *b, *c),
    }
}

#[inline(always)]
fn unit<T: Number>(lane: &Lane<T>) -> State<T> {
    let state = unpack(lane);
    State {
        attitude: state.attitude.normalised(),
        ..state
    }
}

#[inline(always)]
fn rate<T: Number, L: TorqueLaw<T>>(system: &System<T, L>, time: T, lane: &Lane<T>) -> Lane<T> {
    let rates = system.rates(time, &unpack(lane));
    pack(&State {
        attitude: rates.attitude,
        angular_velocity: rates.angular_acceleration,
    })
}

#[inline(always)]
pub(crate) fn sum<T: Number>(slopes: &[Lane<T>; 16], row: Row) -> Lane<T> {
    let mut sum = [T::zero(); 8];
    for (stage, coefficient) in row {
        let factor = T::of(*coefficient);
        for (s, k) in sum.iter_mut().zip(&slopes[*stage]) {
            *s += *k * factor;
        }
    }
    sum
}

#[inline(always)]
pub(crate) fn along<T: Number>(start: &Lane<T>, slope: &Lane<T>, step: T) -> Lane<T> {
    std::array::from_fn(|i| start[i] + slope[i] * step)
}
