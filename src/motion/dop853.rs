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
        let mut stages = Stages::default();
        stages.begin(pack(state), rate(system, time, &pack(state)));
        stages.go_on(system, time, step);
        unit(&stages.end(step))
    }
}

/// The stages of a step: 0 to 11 make it, 12 is its end, 13 to 15 are for dense output. Kept from step to step: where a
/// stage stands is written down and not only its rates, so that the sums are made of whole registers.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stages<T> {
    pub(crate) places: [Lane<T>; 16],
    pub(crate) slopes: [Lane<T>; 16],
}

impl<T: Number> Default for Stages<T> {
    fn default() -> Self {
        let none = [[T::zero(); 8]; 16];
        Self {
            places: none,
            slopes: none,
        }
    }
}

impl<T: Number> Stages<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn begin(&mut self, start: Lane<T>, slope: Lane<T>) {
        (self.places[0], self.slopes[0]) = (start, slope);
    }

    /// The stages after the first, one after the other and not in a loop, so that each row is a sum of known length.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn go_on<L: TorqueLaw<T>>(&mut self, system: &System<T, L>, time: T, step: T) {
        macro_rules! stages {
            ($($i:literal)*) => {$(
                self.stage(system, (time, step), $i, const { STAGES[$i - 1] });
            )*};
        }
        stages!(1 2 3 4 5 6 7 8 9 10 11);
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn stage<L: TorqueLaw<T>>(
        &mut self,
        system: &System<T, L>,
        (time, step): (T, T),
        i: usize,
        row: Row,
    ) {
        self.places[i] = along(&self.places[0], &sum(&self.slopes, row), step);
        self.slopes[i] = rate(system, time + step * T::of(TIMES[i]), &self.places[i]);
    }

    /// Where they lead; the quaternion is not made unit.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn end(&self, step: T) -> Lane<T> {
        along(&self.places[0], &sum(&self.slopes, END), step)
    }
}

impl Stages<f64> {
    /// The dense output of a step, as `contd8` of `dop853.f` nests it.
    fn dense<L: TorqueLaw<f64>>(
        &mut self,
        system: &System<f64, L>,
        time: f64,
        step: f64,
    ) -> [Lane<f64>; 8] {
        for (i, row) in (13..).zip(DENSE_STAGES) {
            self.stage(system, (time, step), i, row);
        }
        let (start, end, slopes) = (&self.places[0], &self.places[12], &self.slopes);
        let change: Lane<f64> = std::array::from_fn(|i| end[i] - start[i]);
        let bend: Lane<f64> = std::array::from_fn(|i| step * slopes[0][i] - change[i]);
        let twist = std::array::from_fn(|i| change[i] - step * slopes[12][i] - bend[i]);
        let [a, b, c, d] = DENSE.map(|row| sum(slopes, row).map(|s| s * step));
        [*start, change, bend, twist, a, b, c, d]
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn pack<T: Number>(state: &State<T>) -> Lane<T> {
    let ([w, x, y, z], o) = (state.attitude.components(), &state.angular_velocity);
    [w, x, y, z, o.x, o.y, o.z, T::zero()]
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(crate) fn unpack<T: Number>([w, x, y, z, a, b, c, _]: &Lane<T>) -> State<T> {
    State {
        attitude: Quaternion::new([*w, *x, *y, *z]),
        angular_velocity: Vector3::new(*a, *b, *c),
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn unit<T: Number>(lane: &Lane<T>) -> State<T> {
    let state = unpack(lane);
    State {
        attitude: state.attitude.normalised(),
        ..state
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn rate<T: Number, L: TorqueLaw<T>>(system: &System<T, L>, time: T, lane: &Lane<T>) -> Lane<T> {
    let rates = system.rates(time, &unpack(lane));
    pack(&State {
        attitude: rates.attitude,
        angular_velocity: rates.angular_acceleration,
    })
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn sum<T: Number>(slopes: &[Lane<T>; 16], row: Row) -> Lane<T> {
    let mut sum = [T::zero(); 8];
    for (stage, coefficient) in row {
        let factor = T::of(*coefficient);
        for (s, k) in sum.iter_mut().zip(&slopes[*stage]) {
            *s += *k * factor;
        }
    }
    sum
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn along<T: Number>(start: &Lane<T>, slope: &Lane<T>, step: T) -> Lane<T> {
    std::array::from_fn(|i| start[i] + slope[i] * step)
}
