//! Motion about an axis that stays: planar motion, in closed form.

use crate::motion::{Frame, Quaternion, State, Torque};
use crate::scene::{Member, size};
use nalgebra::{Matrix3, Vector3};

/// A spin about an axis fixed in the body and in space, under a torque along it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Spin {
    start: State<f64>,
    axis: Vector3<f64>,
    speed: f64,
    law: SpinLaw,
}

/// How the speed changes.
#[derive(Clone, Copy, Debug, PartialEq)]
enum SpinLaw {
    Steady,
    /// c / J, 1/s.
    Damped(f64),
    /// τ / J, rad/s².
    Driven(f64),
    /// A / J in rad/s², w in rad/s, φ.
    Shaken(f64, f64, f64),
}

impl Spin {
    /// The spin of a member, if its motion is one and that is certain to the last bit: an axis known only to rounding
    /// could be the unstable one.
    pub fn new(member: &Member) -> Option<Self> {
        let start = &member.start;
        let (drive, law) = drive(member)?;
        let omega = start.angular_velocity;
        let inertia = member.body.inertia();
        let sphere = *inertia == Matrix3::from_diagonal_element(inertia[(0, 0)]);
        let (axis, speed, drive, moment) = if sphere && drive == Vector3::zeros() {
            let speed = size(&omega);
            let axis = if speed > 0.0 { omega / speed } else { omega };
            (axis, speed, 0.0, inertia[(0, 0)])
        } else {
            let k = along_one(&[&omega, &drive])?;
            let (i, j) = ((k + 1) % 3, (k + 2) % 3);
            if inertia[(k, i)] != 0.0 || inertia[(k, j)] != 0.0 {
                return None;
            }
            let axis = Vector3::from_fn(|r, _| if r == k { 1.0 } else { 0.0 });
            (axis, omega[k], drive[k], inertia[(k, k)])
        };
        let spin = Self {
            start: *start,
            axis,
            speed,
            law: law(drive, moment, &member.torque),
        };
        spin.axis.iter().all(|c| c.is_finite()).then_some(spin)
    }

    /// The state at `time`.
    pub fn at(&self, time: f64) -> State<f64> {
        let (speed, t) = (self.speed, time);
        let (speed, angle) = match self.law {
            SpinLaw::Steady => (speed, speed * t),
            SpinLaw::Damped(rate) => (
                speed * (-rate * t).exp(),
                speed * t * exponential_mean(-rate * t),
            ),
            SpinLaw::Driven(a) => (speed + a * t, (speed + 0.5 * a * t) * t),
            SpinLaw::Shaken(a, w, phase) => shake(speed, a, w, phase, t),
        };
        State {
            attitude: self.start.attitude * Quaternion::exp(&(self.axis * angle)),
            angular_velocity: match self.law {
                SpinLaw::Steady => self.start.angular_velocity,
                _ => self.axis * speed,
            },
        }
    }

    /// Whether nothing moves at all.
    pub fn is_rest(&self) -> bool {
        let still = match self.law {
            SpinLaw::Steady | SpinLaw::Damped(_) => true,
            SpinLaw::Driven(a) | SpinLaw::Shaken(a, ..) => a == 0.0,
        };
        still && self.speed == 0.0
    }
}

/// How the speed follows from the drive along the axis and the moment about it.
type LawOf = fn(f64, f64, &Torque) -> SpinLaw;

/// The vector that drives the body, in body axes, if the torque has one direction or none.
fn drive(member: &Member) -> Option<(Vector3<f64>, LawOf)> {
    let seen = |frame: Frame, v: &Vector3<f64>| match frame {
        Frame::Body => *v,
        Frame::Space => member.start.attitude.to_body(v),
    };
    Some(match &member.torque {
        Torque::None => (Vector3::zeros(), |_, _, _| SpinLaw::Steady),
        Torque::Damping { .. } => (Vector3::zeros(), damped),
        Torque::Constant { frame, value } => (seen(*frame, value), |drive, moment, _| {
            SpinLaw::Driven(drive / moment)
        }),
        Torque::Sinusoid {
            frame, amplitude, ..
        } => (seen(*frame, amplitude), shaken),
        Torque::Gravity { weight, arm } => {
            // A weight above or below the fixed point has no moment, and keeps none in a turn about the vertical.
            let down = seen(Frame::Space, &Vector3::new(0.0, 0.0, -weight));
            along_one(&[&down, arm, &member.start.angular_velocity])?;
            (Vector3::zeros(), |_, _, _| SpinLaw::Steady)
        }
    })
}

fn damped(_: f64, moment: f64, torque: &Torque) -> SpinLaw {
    match torque {
        Torque::Damping { coefficient } => SpinLaw::Damped(coefficient / moment),
        _ => SpinLaw::Steady,
    }
}

fn shaken(drive: f64, moment: f64, torque: &Torque) -> SpinLaw {
    match torque {
        Torque::Sinusoid {
            angular_frequency,
            phase,
            ..
        } => SpinLaw::Shaken(drive / moment, *angular_frequency, *phase),
        _ => SpinLaw::Steady,
    }
}

/// The coordinate axis along which all the vectors lie, to the last bit.
fn along_one(vectors: &[&Vector3<f64>]) -> Option<usize> {
    let along = |k: usize| {
        vectors
            .iter()
            .all(|v| v[(k + 1) % 3] == 0.0 && v[(k + 2) % 3] == 0.0)
    };
    (0..3).find(|&k| along(k))
}

/// (eˣ − 1) / x.
fn exponential_mean(x: f64) -> f64 {
    if x == 0.0 { 1.0 } else { x.exp_m1() / x }
}

/// Speed and angle under the acceleration a sin(w t + φ). Sums and differences of nearly equal sines are written as
/// products, so that a slow drive loses nothing.
fn shake(speed: f64, a: f64, w: f64, phase: f64, t: f64) -> (f64, f64) {
    let half = 0.5 * w * t;
    let cardinal = if half == 0.0 { 1.0 } else { half.sin() / half };
    let (sine, cosine) = phase.sin_cos();
    let gained = a * t * cardinal * (half + phase).sin();
    // ∫ (t − s) sin(w s + φ) ds = t² (sin φ · ½ sinc² + cos φ · (x − sin x)/x²), x = w t.
    let mean = 0.5 * sine * cardinal * cardinal + cosine * lag(2.0 * half);
    (speed + gained, speed * t + a * t * t * mean)
}

/// (x − sin x) / x², by its series near 0.
fn lag(x: f64) -> f64 {
    if x.abs() > 1.0 {
        return (x - x.sin()) / (x * x);
    }
    let square = x * x;
    // 1/3!, 1/5!, … to the last bit at 1.
    let tail = [9, 8, 7, 6, 5, 4, 3, 2, 1].iter().fold(0.0, |sum, &n| {
        let n = f64::from(n);
        (1.0 - square * sum) / ((2.0 * n) * (2.0 * n + 1.0))
    });
    x * tail
}
