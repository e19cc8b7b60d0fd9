//! The equation of motion on truncated power series.

use crate::motion::{Frame, Number, Quaternion, State, System, Torque};
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

impl<T: Number> Series<T> {
    /// The motion of `system` from `state` at `time`, to `order` (at most [`MOST`]), in powers of the time over `unit`
    /// (s). The attitude is left as it is unless it is asked for: right where the torque does not look at it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn new(
        system: &System<T, Torque>,
        (time, state): (T, &State<T>),
        order: usize,
        with_attitude: bool,
        unit: T,
    ) -> Self {
        let zero = [T::zero(); 4];
        let mut series = Self {
            order: order.min(MOST),
            unit,
            attitude: [zero; MOST + 1],
            omega: [zero; MOST + 1],
        };
        series.attitude[0] = state.attitude.components();
        let mut omega = Turned::default();
        series.omega[0] = omega.set(0, &(state.angular_velocity * unit));
        let mut torque = Moments::new(system, time, state, unit);
        // The columns q i, q j, q k of the quaternion product.
        let mut units = [[zero; MOST + 1]; 3];
        for n in 0..series.order {
            let next = T::of(1.0 / (n + 1) as f64);
            let applied = torque.coefficient(n, &series.omega);
            let acceleration =
                system.acceleration_of(&omega.products(n), || square(&series.omega, n), &applied);
            if with_attitude {
                set_units(&mut units, n, &series.attitude[n]);
                let rate = quaternion_rate(&units, &series.omega, n);
                let half = next * T::of(0.5);
                series.attitude[n + 1] = rate.map(|r| r * half);
            }
            torque.carry(n, &omega, next);
            series.omega[n + 1] = omega.set(n + 1, &(acceleration * next));
        }
        series
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
        let over = if speed > 0.0 { 1.0 / speed } else { 1.0 };
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
                let over = if start > 0.0 { 1.0 / start } else { 1.0 };
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

/// A vector series in the two cyclic shifts that cross products take: (y, z, x) and (z, x, y).
#[derive(Clone, Debug)]
struct Turned<T> {
    ahead: [Lane<T>; MOST + 1],
    behind: [Lane<T>; MOST + 1],
}

impl<T: Number> Default for Turned<T> {
    fn default() -> Self {
        let zeros = [[T::zero(); 4]; MOST + 1];
        Self {
            ahead: zeros,
            behind: zeros,
        }
    }
}

impl<T: Number> Turned<T> {
    /// Sets coefficient `n`, and returns it as a lane.
    #[inline(always)]
    fn set(&mut self, n: usize, v: &Vector3<T>) -> Lane<T> {
        let zero = T::zero();
        self.ahead[n] = [v.y, v.z, v.x, zero];
        self.behind[n] = [v.z, v.x, v.y, zero];
        [v.x, v.y, v.z, zero]
    }

    /// Coefficient `n` of (yz, zx, xy).
    #[inline(always)]
    fn products(&self, n: usize) -> Vector3<T> {
        let mut sum = [T::zero(); 4];
        for m in 0..=n {
            let (a, b) = (&self.ahead[m], &self.behind[n - m]);
            for i in 0..4 {
                sum[i] += a[i] * b[i];
            }
        }
        Vector3::new(sum[0], sum[1], sum[2])
    }

    /// Coefficient `n` of the cross product of this and another vector.
    #[inline(always)]
    fn cross(&self, other: &Self, n: usize) -> Vector3<T> {
        let mut sum = [T::zero(); 4];
        for m in 0..=n {
            let (a, b) = (&self.ahead[m], &other.behind[n - m]);
            let (c, d) = (&self.behind[m], &other.ahead[n - m]);
            for i in 0..4 {
                sum[i] += a[i] * b[i] - c[i] * d[i];
            }
        }
        Vector3::new(sum[0], sum[1], sum[2])
    }
}

/// Coefficient `n` of q ω, from q i, q j, q k.
#[inline(always)]
fn quaternion_rate<T: Number>(
    units: &[[Lane<T>; MOST + 1]; 3],
    omega: &[Lane<T>; MOST + 1],
    n: usize,
) -> Lane<T> {
    let mut rate = [T::zero(); 4];
    for (m, w) in omega[..=n].iter().rev().enumerate() {
        let (a, b, c) = (&units[0][m], &units[1][m], &units[2][m]);
        for i in 0..4 {
            rate[i] += a[i] * w[0] + b[i] * w[1] + c[i] * w[2];
        }
    }
    rate
}

/// Coefficient `n` of (x², y², z²).
#[inline(always)]
fn square<T: Number>(omega: &[Lane<T>; MOST + 1], n: usize) -> Vector3<T> {
    let mut sum = [T::zero(); 4];
    for m in 0..=n {
        let (a, b) = (&omega[m], &omega[n - m]);
        for i in 0..4 {
            sum[i] += a[i] * b[i];
        }
    }
    Vector3::new(sum[0], sum[1], sum[2])
}

#[inline(always)]
fn set_units<T: Number>(units: &mut [[Lane<T>; MOST + 1]; 3], n: usize, q: &Lane<T>) {
    let [w, x, y, z] = *q;
    units[0][n] = [-x, w, z, -y];
    units[1][n] = [-y, -z, w, x];
    units[2][n] = [-z, y, -x, w];
}

/// The series of the torque, grown with the motion, in the series' unit of time.
struct Moments<T> {
    law: Torque,
    unit: T,
    /// A torque constant in body axes.
    body: Vector3<T>,
    /// Vectors constant in space, seen from the body: γ' = γ × ω. The first is a torque or a force, the
    /// second an amplitude.
    space: Option<Box<Turned<T>>>,
    amplitude: Option<Box<Turned<T>>>,
    sine: [T; MOST + 1],
    cosine: [T; MOST + 1],
}

impl<T: Number> Moments<T> {
    fn new(system: &System<T, Torque>, time: T, state: &State<T>, unit: T) -> Self {
        // By the unit twice, whose square may be no number.
        let lift = |v: &Vector3<f64>| v.map(|c| T::of(c) * unit * unit);
        let seen = |v: Vector3<T>| {
            let mut series = Box::<Turned<T>>::default();
            series.set(0, &state.attitude.to_body(&v));
            Some(series)
        };
        let added = system.added() * unit * unit;
        let mut moments = Self {
            law: *system.law(),
            unit,
            body: Vector3::from_element(T::zero()),
            space: None,
            amplitude: None,
            sine: [T::zero(); MOST + 1],
            cosine: [T::zero(); MOST + 1],
        };
        match system.law() {
            Torque::None | Torque::Damping { .. } => moments.body = added,
            Torque::Constant {
                frame: Frame::Body,
                value,
            } => moments.body = added + lift(value),
            Torque::Constant {
                frame: Frame::Space,
                value,
            } => {
                moments.space = seen(added + lift(value));
            }
            Torque::Gravity { weight, .. } => {
                moments.body = added;
                moments.space = seen(lift(&Vector3::new(0.0, 0.0, -*weight)));
            }
            Torque::Sinusoid {
                frame,
                amplitude,
                angular_frequency,
                phase,
            } => {
                let angle = time * T::of(*angular_frequency) + T::of(*phase);
                (moments.sine[0], moments.cosine[0]) = angle.sin_cos();
                match frame {
                    Frame::Body => moments.body = added,
                    Frame::Space => {
                        moments.space = seen(added);
                        moments.amplitude = seen(lift(amplitude));
                    }
                }
            }
        }
        moments
    }

    /// Coefficient `n` of the torque in body axes, from those of ω to the same order.
    #[inline(always)]
    fn coefficient(&self, n: usize, omega: &[Lane<T>; MOST + 1]) -> Vector3<T> {
        let mut sum = if n == 0 {
            self.body
        } else {
            Vector3::from_element(T::zero())
        };
        let at = |series: &Turned<T>, m: usize| {
            let [y, z, x, _] = series.ahead[m];
            Vector3::new(x, y, z)
        };
        if let Some(space) = &self.space {
            let seen = at(space, n);
            sum += match &self.law {
                Torque::Gravity { arm, .. } => arm.map(T::of).cross(&seen),
                _ => seen,
            };
        }
        match &self.law {
            Torque::Damping { coefficient } => {
                let [x, y, z, _] = omega[n];
                sum -= Vector3::new(x, y, z) * (T::of(*coefficient) * self.unit);
            }
            Torque::Sinusoid { amplitude, .. } => match &self.amplitude {
                None => {
                    let factor = self.unit * self.sine[n];
                    sum += amplitude.map(|a| T::of(a) * self.unit * factor);
                }
                Some(series) => {
                    for m in 0..=n {
                        sum += at(series, m) * self.sine[n - m];
                    }
                }
            },
            _ => {}
        }
        sum
    }

    /// Grows the carried series from coefficient `n` to the next; `next` is 1/(n + 1).
    #[inline(always)]
    fn carry(&mut self, n: usize, omega: &Turned<T>, next: T) {
        for series in [&mut self.space, &mut self.amplitude].into_iter().flatten() {
            let rate = series.cross(omega, n);
            series.set(n + 1, &(rate * next));
        }
        if let Torque::Sinusoid {
            angular_frequency, ..
        } = &self.law
        {
            let turn = next * self.unit * T::of(*angular_frequency);
            self.sine[n + 1] = self.cosine[n] * turn;
            self.cosine[n + 1] = -self.sine[n] * turn;
        }
    }
}
