//! The equation of motion on truncated power series.

use super::moments::Moments;
use crate::motion::{Number, Quaternion, State, System, Torque, stepper};
use nalgebra::Vector3;

/// The highest order.
pub(crate) const MOST: usize = 30;

/// A term smaller than this against the start may have lost factors to underflow.
const LOST: f64 = 1e-200;

/// Four components side by side, so that one operation takes them all.
type Lane<T> = [T; 4];

/// The coefficients of a motion in powers of the time since its start. Time and all that has time in it are in a unit
/// of their own: what is far too slow or too fast for seconds keeps coefficients that are numbers.
#[derive(Clone, Debug)]
pub(crate) struct Series<T> {
    order: usize,
    unit: T,
    attitude: [Lane<T>; MOST + 1],
    omega: [Lane<T>; MOST + 1],
}

/// What grows beside a series while it is made, order by order. Kept from one to the next: to clear it would cost as much
/// as a series of low order.
#[derive(Clone, Debug)]
pub(crate) struct Beside<T>([Term<T>; MOST + 1]);

/// What stands beside the coefficients of one order.
#[derive(Clone, Copy, Debug)]
pub(super) struct Term<T> {
    pub(super) omega: Turned<T>,
    /// The columns q i, q j, q k of the quaternion product.
    units: [Lane<T>; 3],
    /// Vectors constant in space, seen from the body: γ' = γ × ω. A torque or a force, and an amplitude.
    pub(super) space: Turned<T>,
    pub(super) amplitude: Turned<T>,
    pub(super) sine: T,
    pub(super) cosine: T,
}

impl<T: Number> Default for Beside<T> {
    fn default() -> Self {
        let (zero, none) = (T::zero(), [[T::zero(); 4]; 3]);
        Self(
            [Term {
                omega: none,
                units: none,
                space: none,
                amplitude: none,
                sine: zero,
                cosine: zero,
            }; MOST + 1],
        )
    }
}

impl<T: Number> Default for Series<T> {
    fn default() -> Self {
        let none = [[T::zero(); 4]; MOST + 1];
        Self {
            order: 0,
            unit: T::one(),
            attitude: none,
            omega: none,
        }
    }
}

impl<T: Number> Series<T> {
    /// Becomes the motion of `system` from `state` at `time`, to `order` (at most [`MOST`]), in powers of the time over
    /// `unit` (s). The attitude is left as it is unless it is asked for: right where the torque does not look at it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn become_motion(
        &mut self,
        beside: &mut Beside<T>,
        system: &System<T, Torque>,
        (time, state): (T, &State<T>),
        (order, with_attitude): (usize, bool),
        unit: T,
    ) {
        (self.order, self.unit) = (order.min(MOST), unit);
        let terms = &mut beside.0;
        let torque = Moments::begin(&mut terms[0], system, (time, state), unit);
        let wanted = Wanted {
            attitude: with_attitude,
            space: torque.space,
            amplitude: torque.amplitude,
            squares: !system.is_principal(),
        };
        let omega = state.angular_velocity * unit;
        self.attitude[0] = state.attitude.components();
        self.omega[0] = [omega.x, omega.y, omega.z, T::zero()];
        terms[0].omega = turned(self.omega[0]);
        for n in 0..self.order {
            // To all the digits of the number: a third in doubles is none of a reference.
            let next = T::one() / T::of((n + 1) as f64);
            if with_attitude {
                terms[n].units = units(&self.attitude[n]);
            }
            let applied = torque.coefficient(&terms[..=n]);
            let sums = wanted.convolved(&terms[..=n]);
            let [yz, zx, xy, fourth] = sums.products;
            let [xx, yy, zz, _] = sums.squares;
            let acceleration = system.acceleration_of(
                &Vector3::new(yz, zx, xy),
                || Vector3::new(xx, yy, zz),
                &applied,
            ) * next;
            let half = next * T::of(0.5);
            self.attitude[n + 1] = sums.turning.map(|r| r * half);
            let [x, y, z] = acceleration.into();
            self.omega[n + 1] = [x, y, z, fourth * next];
            let after = &mut terms[n + 1];
            after.omega = turned(self.omega[n + 1]);
            after.space = turned(sums.space.map(|r| r * next));
            after.amplitude = turned(sums.amplitude.map(|r| r * next));
            torque.carry(terms, n, next);
        }
    }

    /// The state `span` after the start, the quaternion brought to unit length.
    #[inline]
    pub(crate) fn at(&self, span: T) -> State<T> {
        let span = span / self.unit;
        let sum = |coefficients: &[Lane<T>; MOST + 1]| {
            let mut value = coefficients[self.order];
            for c in coefficients[..self.order].iter().rev() {
                for (v, c) in value.iter_mut().zip(c) {
                    *v = *v * span + *c;
                }
            }
            value
        };
        let [x, y, z, _] = sum(&self.omega);
        State {
            attitude: Quaternion::new(sum(&self.attitude)).normalised(),
            angular_velocity: Vector3::new(x, y, z) / self.unit,
        }
    }
}

impl Series<f64> {
    /// The span over which the last two terms stay below `tolerance`, of the attitude absolutely and of ω
    /// against its own size (Jorba and Zou, Experimental Mathematics 14, 2005).
    pub(crate) fn span(&self, tolerance: f64) -> f64 {
        let size = |lane: &Lane<f64>| lane.iter().map(|c| c.abs()).sum::<f64>();
        let speed = size(&self.omega[0]);
        let over = stepper::over(speed);
        let [last, least] = [self.order, self.order - 1].map(|n| {
            let term = size(&self.attitude[n]) + size(&self.omega[n]) * over;
            (tolerance / term).powf(1.0 / n as f64)
        });
        // What is no number is passed on: `min` would drop it.
        let units = if last.is_nan() || last < least {
            last
        } else {
            least
        };
        units * self.unit
    }

    /// A unit of time in which the terms are numbers, if the last ones are none or may have been lost: the time in which
    /// one of the first three comes to the size of the start.
    pub(crate) fn better_unit(&self) -> Option<f64> {
        let size = |n: usize| {
            let part = |of: &[Lane<f64>; MOST + 1]| {
                let start = of[0].iter().fold(0.0, |m: f64, c| m.max(c.abs()));
                let over = stepper::over(start);
                of[n].iter().fold(0.0, |m: f64, c| m.max(c.abs() * over))
            };
            part(&self.attitude).max(part(&self.omega))
        };
        // NaN is lost in the largest, but not what comes before it: infinity.
        if (LOST..1.0 / LOST).contains(&size(self.order).max(size(self.order - 1))) {
            return None;
        }
        let pace = [1, 2, 3]
            .map(|n| size(n).powf(1.0 / n as f64))
            .into_iter()
            .filter(|pace| pace.is_finite())
            .fold(0.0, f64::max);
        let unit = self.unit / pace;
        (unit.is_finite() && unit > 0.0).then_some(unit)
    }
}

/// A vector and its two cyclic shifts that cross products take: (y, z, x) and (z, x, y). The fourth component is 0 and
/// carried along all the same: without it a register is taken apart.
pub(super) type Turned<T> = [Lane<T>; 3];

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn turned<T: Number>(v: Lane<T>) -> Turned<T> {
    let [x, y, z, fourth] = v;
    [v, [y, z, x, fourth], [z, x, y, fourth]]
}

/// Which convolutions are asked for.
struct Wanted {
    attitude: bool,
    space: bool,
    amplitude: bool,
    squares: bool,
}

/// Coefficients of products of series; zeros where they are not asked for.
struct Sums<T> {
    /// (yz, zx, xy) and (x², y², z²) of ω.
    products: Lane<T>,
    squares: Lane<T>,
    /// q ω.
    turning: Lane<T>,
    /// The cross products with ω of what is constant in space.
    space: Lane<T>,
    amplitude: Lane<T>,
}

impl Wanted {
    /// The coefficients of the highest of these orders: sums of products of the first with the last and so on. Those in
    /// which the last one stands are added at the end, so that the sum of all others does not wait for it; and all sums in
    /// one loop, as its end is seldom foreseen by the processor.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn convolved<T: Number>(&self, terms: &[Term<T>]) -> Sums<T> {
        let zero = [T::zero(); 4];
        let mut sums = Sums {
            products: zero,
            squares: zero,
            turning: zero,
            space: zero,
            amplitude: zero,
        };
        match terms {
            [first, between @ .., last] => {
                for (a, b) in between.iter().zip(between.iter().rev()) {
                    self.add(&mut sums, a, b);
                }
                self.add(&mut sums, first, last);
                self.add(&mut sums, last, first);
            }
            [only] => self.add(&mut sums, only, only),
            [] => {}
        }
        sums
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add<T: Number>(&self, sums: &mut Sums<T>, a: &Term<T>, b: &Term<T>) {
        let [straight, ahead, behind] = &b.omega;
        add_products(&mut sums.products, &a.omega[1], behind);
        if self.squares {
            add_products(&mut sums.squares, &a.omega[0], straight);
        }
        if self.attitude {
            let ([p, q, r], [x, y, z, _]) = (&a.units, straight);
            for i in 0..4 {
                sums.turning[i] += p[i] * *x + q[i] * *y + r[i] * *z;
            }
        }
        if self.space {
            add_cross(&mut sums.space, &a.space, ahead, behind);
        }
        if self.amplitude {
            add_cross(&mut sums.amplitude, &a.amplitude, ahead, behind);
        }
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn add_products<T: Number>(sum: &mut Lane<T>, a: &Lane<T>, b: &Lane<T>) {
    for i in 0..4 {
        sum[i] += a[i] * b[i];
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn add_cross<T: Number>(
    sum: &mut Lane<T>,
    [_, a, b]: &Turned<T>,
    ahead: &Lane<T>,
    behind: &Lane<T>,
) {
    for i in 0..4 {
        sum[i] += a[i] * behind[i] - b[i] * ahead[i];
    }
}

/// q i, q j, q k.
#[cfg_attr(not(debug_assertions), inline(always))]
fn units<T: Number>([w, x, y, z]: &Lane<T>) -> [Lane<T>; 3] {
    let (w, x, y, z) = (*w, *x, *y, *z);
    [[-x, w, z, -y], [-y, -z, w, x], [-z, y, -x, w]]
}
