//! The exact motion of a free body, at any time from one epoch.
//!
//! Along the principal axes I₁ ≤ I₂ ≤ I₃ the angular momentum is m = (A₁ cn, A₂ sn, A₃ dn)(λt + u₀) where it turns
//! about axis 3, and with 1 and 3 exchanged about axis 1 (Jacobi 1849; Whittaker, *Analytical Dynamics* §69).
//! The attitude is a turn χ about the fixed L after the shortest turn that brings m to L (Celledoni, Fassò,
//! Säfström, Zanna, SIAM J. Sci. Comput. 30 (2008)), and χ' = (2T + G ω₃)/(G + m₃) integrates to a uniform
//! turn and one argument of a theta function.
//!
//! What makes it good near the separatrix: every quantity is a sum of positive terms of the three moment
//! differences and the invariants Dⱼ = G² − 2 T Iⱼ = Σ Iᵢ (Iᵢ − Iⱼ) ωᵢ², formed once; k and k' are each given by
//! them; and where k' is small the series are those of the complementary nome.

mod elliptic;
mod motion;
mod series;

pub use motion::FreeMotion;

use crate::motion::{Body, MotionError, Quaternion, State};
use nalgebra::{Matrix3, Vector3};
use series::Series;

/// The motion of a free body from a state at time 0.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::motion::{Body, FreeBody, State};
///
/// // A T-handle spun about its middle axis flips over and back.
/// let handle = Body::new(&Matrix3::from_diagonal(&Vector3::new(2.0, 3.0, 4.0)))?;
/// let start = State::at_rest().turning(Vector3::new(0.0, 3.0, 1e-3));
/// let motion = FreeBody::new(&handle, &start);
/// let flipped = motion.at(17.0)?;
/// assert!(flipped.angular_velocity.y < -2.9);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
#[derive(Clone, Copy, Debug)]
pub struct FreeBody {
    start: State<f64>,
    /// None where ω does not change: spin about a principal axis, equal moments, rest.
    turning: Option<Turning>,
}

/// A motion in which ω changes, in working axes: the first along the cn component, the third along dn, both
/// positive at the start.
#[derive(Clone, Copy, Debug)]
struct Turning {
    /// Attitude at the epoch, up to the turn about L.
    left: Quaternion<f64>,
    /// Working axes to body axes.
    axes: Matrix3<f64>,
    right: Quaternion<f64>,
    series: Series,
    /// λ, 1/s, and u₀.
    rate: f64,
    start: f64,
    quarter: f64,
    /// Amplitudes of m / G, and of ω in rad/s.
    momentum: Vector3<f64>,
    velocity: Vector3<f64>,
    /// Half the uniform rate of χ; the sign of the argument in it; its value at the epoch.
    half_rate: f64,
    sign: f64,
}

impl FreeBody {
    /// The motion of `body` from `start` at time 0, with no torque.
    pub fn new(body: &Body, start: &State<f64>) -> Self {
        Self {
            start: *start,
            turning: Turning::new(body, start),
        }
    }

    /// The state at `time` (s), before or after the epoch.
    ///
    /// # Errors
    /// A time so large that the angle turned is not finite, or no number.
    pub fn at(&self, time: f64) -> Result<State<f64>, MotionError> {
        let state = match &self.turning {
            None => State {
                attitude: self.start.attitude
                    * Quaternion::exp(&(self.start.angular_velocity * time)),
                ..self.start
            },
            Some(turning) => turning.at(time),
        };
        if state.is_finite() {
            Ok(state)
        } else {
            Err(MotionError::NotFinite {
                what: "the angle turned at the time asked for",
                value: time,
            })
        }
    }
}

/// The moments, differences and invariants of one motion, about axis 3 or, exchanged, about axis 1.
struct Invariants {
    /// Moments of the cn, sn and dn axes, scaled.
    moments: Vector3<f64>,
    /// Between sn and cn, dn and sn, dn and cn; all positive.
    inner: f64,
    outer: f64,
    whole: f64,
    /// |D| of the cn axis, of the sn axis, of the dn axis.
    of_cn: f64,
    of_sn: f64,
    of_dn: f64,
    /// Angular velocity, scaled, along these axes.
    omega: Vector3<f64>,
    /// Whether 1 and 3 are exchanged.
    exchanged: bool,
}

impl Invariants {
    /// `None` where ω does not change.
    fn new(moments: &Vector3<f64>, omega: &Vector3<f64>) -> Option<Self> {
        let (d21, d32, d31) = (
            moments.y - moments.x,
            moments.z - moments.y,
            moments.z - moments.x,
        );
        let steady = omega.y * omega.z * d32 == 0.0
            && omega.z * omega.x * d31 == 0.0
            && omega.x * omega.y * d21 == 0.0;
        if steady {
            return None;
        }
        let [t1, t2, t3] = [0, 1, 2].map(|i| moments[i] * omega[i] * omega[i]);
        let d1 = t2 * d21 + t3 * d31;
        let d3 = t1 * d31 + t2 * d32;
        let d2 = t3 * d32 - t1 * d21;
        Some(if d2 >= 0.0 && d32 > 0.0 {
            Self {
                moments: *moments,
                inner: d21,
                outer: d32,
                whole: d31,
                of_cn: d1,
                of_sn: d2,
                of_dn: d3,
                omega: *omega,
                exchanged: false,
            }
        } else {
            // A half turn about the bisector of axes 1 and 3.
            Self {
                moments: Vector3::new(moments.z, moments.y, moments.x),
                inner: d32,
                outer: d21,
                whole: d31,
                of_cn: d3,
                of_sn: -d2,
                of_dn: d1,
                omega: Vector3::new(omega.z, -omega.y, omega.x),
                exchanged: true,
            }
        })
    }
}

impl Turning {
    fn new(body: &Body, start: &State<f64>) -> Option<Self> {
        let omega = body.axes().transpose() * start.angular_velocity;
        // Powers of two: the scaling is exact, and no square over- or underflows that matters.
        let (size, speed) = (power_of_two(body.moments().z), power_of_two(omega.amax()));
        let found = Invariants::new(&(body.moments() / size), &(omega / speed))?;
        let Invariants {
            moments,
            inner,
            outer,
            whole,
            of_cn,
            of_sn,
            of_dn,
            ..
        } = found;
        let signs = flip(&found.omega);
        let omega = found.omega.component_mul(&signs);
        let momentum = moments.component_mul(&omega);
        let size_of_momentum = momentum.norm();

        let modulus = (inner * of_dn / (outer * of_cn)).sqrt().min(1.0);
        let complementary = (of_sn * whole / (of_cn * outer)).sqrt().min(1.0);
        let pole = (moments.x * outer / (moments.z * inner)).sqrt();
        let (series, quarter) = Series::new(modulus, complementary, pole);
        let rate = (outer * of_cn / moments.product()).sqrt();

        let tangent = omega.y.abs() / omega.x * (moments.y * outer / (moments.x * whole)).sqrt();
        let from_peak = elliptic::incomplete(tangent, complementary, quarter);
        let middle = if found.exchanged { -1.0 } else { 1.0 };
        let u0 = from_peak.copysign(omega.y * middle);

        let velocity = Vector3::new(
            (of_dn / (moments.x * whole)).sqrt(),
            middle * (of_dn / (moments.y * outer)).sqrt(),
            (of_cn / (moments.z * whole)).sqrt(),
        );
        let peak = moments.z * velocity.z;
        let twice_energy = momentum.dot(&omega);
        let (slope, _) = series.rate_and_gain();
        let at_peak = (twice_energy + size_of_momentum * velocity.z) / (size_of_momentum + peak);
        let half_rate = 0.5 * at_peak + middle * rate * slope;

        let right = frame(&signs, found.exchanged);
        let working = *body.turn() * right;
        let base =
            start.attitude * working * to_momentum(&(momentum / size_of_momentum)).conjugate();
        let axes = working_axes(body.axes(), &signs, found.exchanged);
        Some(Self {
            left: (base * about_z(turned(series.at(u0).phase, middle))).normalised(),
            axes,
            right: working.conjugate(),
            series,
            rate: rate * speed,
            start: u0,
            quarter,
            momentum: moments.component_mul(&velocity) / size_of_momentum,
            velocity: velocity * speed,
            half_rate: half_rate * speed,
            sign: middle,
        })
    }

    fn at(&self, time: f64) -> State<f64> {
        let u = self.rate * time + self.start;
        let halves = (u / (2.0 * self.quarter)).round();
        let reduced = if halves == 0.0 {
            u
        } else {
            u - 2.0 * self.quarter * halves
        };
        let values = self.series.at(reduced);
        let flipped = if halves % 2.0 == 0.0 { 1.0 } else { -1.0 };
        let functions = Vector3::new(flipped * values.cn, flipped * values.sn, values.dn);
        let (_, gain) = self.series.rate_and_gain();
        let half = self.half_rate * time + self.sign * gain * halves;
        // e^(i half) times e^(−i phase), of any length: the attitude is made unit at the end.
        let (sine, cosine) = half.sin_cos();
        let (real, imaginary) = turned(values.phase, self.sign);
        let turn = (
            cosine * real + sine * imaginary,
            sine * real - cosine * imaginary,
        );
        let swing = to_momentum(&self.momentum.component_mul(&functions));
        State {
            attitude: (self.left * about_z(turn) * swing * self.right).normalised(),
            angular_velocity: self.axes * self.velocity.component_mul(&functions),
        }
    }
}

/// The power of two at or below a positive number; 1 for zero.
fn power_of_two(x: f64) -> f64 {
    let exponent = f64::from_bits(x.to_bits() & 0x7ff0_0000_0000_0000);
    if exponent > 0.0 && exponent.is_finite() {
        exponent
    } else {
        1.0
    }
}

/// Signs that make the first and the third component positive and are a half turn or none.
fn flip(omega: &Vector3<f64>) -> Vector3<f64> {
    let (x, z) = (1.0_f64.copysign(omega.x), 1.0_f64.copysign(omega.z));
    Vector3::new(x, x * z, z)
}

/// Working axes to principal axes: the half turns of the signs and of the exchange.
fn frame(signs: &Vector3<f64>, exchanged: bool) -> Quaternion<f64> {
    let turn = match (signs.x > 0.0, signs.z > 0.0) {
        (true, true) => Quaternion::identity(),
        (true, false) => Quaternion::new([0.0, 1.0, 0.0, 0.0]),
        (false, true) => Quaternion::new([0.0, 0.0, 0.0, 1.0]),
        (false, false) => Quaternion::new([0.0, 0.0, 1.0, 0.0]),
    };
    if exchanged {
        let root = std::f64::consts::FRAC_1_SQRT_2;
        Quaternion::new([0.0, root, 0.0, root]) * turn
    } else {
        turn
    }
}

/// The working axes as columns, in body axes: the principal ones, signed and exchanged without rounding.
fn working_axes(principal: &Matrix3<f64>, signs: &Vector3<f64>, exchanged: bool) -> Matrix3<f64> {
    let mut axes = *principal;
    if exchanged {
        axes.swap_columns(0, 2);
        axes.column_mut(1).neg_mut();
    }
    for (mut column, sign) in axes.column_iter_mut().zip(signs.iter()) {
        column *= *sign;
    }
    axes
}

/// A turn about z by twice the argument of a complex number, as long as it.
fn about_z((real, imaginary): (f64, f64)) -> Quaternion<f64> {
    Quaternion::new([real, 0.0, 0.0, imaginary])
}

/// A complex number, or the conjugate for a sign of −1.
fn turned((real, imaginary): (f64, f64), sign: f64) -> (f64, f64) {
    (real, sign * imaginary)
}

/// The shortest turn that brings the direction `m`, with m_z ≥ 0, to z.
fn to_momentum(m: &Vector3<f64>) -> Quaternion<f64> {
    let over = 1.0 / (2.0 * (1.0 + m.z)).sqrt();
    Quaternion::new([(0.5 * (1.0 + m.z)).sqrt(), m.y * over, -m.x * over, 0.0])
}
