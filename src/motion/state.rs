//! Where a body is and how it turns.

use crate::motion::{MotionError, Number, Quaternion};
use nalgebra::{Vector3, Vector6};

/// Attitude and angular velocity of a body.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct State<T> {
    /// Unit quaternion, body → space.
    pub attitude: Quaternion<T>,
    /// ω in body axes, rad/s.
    pub angular_velocity: Vector3<T>,
}

/// The rate of a [`State`].
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Rates<T> {
    /// q̇ = ½ q ω.
    pub attitude: Quaternion<T>,
    /// ω̇ in body axes, rad/s².
    pub angular_acceleration: Vector3<T>,
}

impl<T: Number> State<T> {
    /// Body axes along the space axes, at rest.
    pub fn at_rest() -> Self {
        Self {
            attitude: Quaternion::identity(),
            angular_velocity: Vector3::from_element(T::zero()),
        }
    }

    /// The same attitude with the angular velocity ω (body axes).
    pub fn turning(self, angular_velocity: Vector3<T>) -> Self {
        Self {
            angular_velocity,
            ..self
        }
    }

    /// The state `rates · span` further along a straight line; the attitude is not made unit again.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn along(&self, rates: &Rates<T>, span: T) -> Self {
        Self {
            attitude: self.attitude + rates.attitude * span,
            angular_velocity: self.angular_velocity + rates.angular_acceleration * span,
        }
    }
}

impl State<f64> {
    /// A state of finite numbers, its quaternion brought to unit length.
    ///
    /// # Errors
    /// A component that is not finite, or a quaternion of zeros.
    pub fn new(attitude: [f64; 4], angular_velocity: [f64; 3]) -> Result<Self, MotionError> {
        for value in attitude {
            finite("a component of the attitude", value)?;
        }
        for value in angular_velocity {
            finite("a component of the angular velocity", value)?;
        }
        // Scaled first: the square of 1e200 is no number.
        let largest = attitude.iter().fold(0.0_f64, |m, c| m.max(c.abs()));
        if largest == 0.0 {
            return Err(MotionError::ZeroAttitude);
        }
        Ok(Self {
            attitude: Quaternion::new(attitude.map(|c| c / largest)).normalised(),
            angular_velocity: angular_velocity.into(),
        })
    }

    /// The state moved by a tangent (θ, δω): q exp(θ/2) and ω + δω.
    pub fn perturbed(&self, tangent: &Vector6<f64>) -> Self {
        let theta = tangent.fixed_rows::<3>(0).into_owned();
        Self {
            attitude: self.attitude * Quaternion::exp(&theta),
            angular_velocity: self.angular_velocity + tangent.fixed_rows::<3>(3),
        }
    }

    /// The tangent (θ, δω) that leads from this state to `other`; the sign of a quaternion does not count.
    pub fn difference(&self, other: &Self) -> Vector6<f64> {
        let theta = (self.attitude.conjugate() * other.attitude).log();
        let delta = other.angular_velocity - self.angular_velocity;
        Vector6::new(theta.x, theta.y, theta.z, delta.x, delta.y, delta.z)
    }

    /// Whether every component is a finite number.
    pub fn is_finite(&self) -> bool {
        let omega = self.angular_velocity;
        (self.attitude.norm_squared() + omega.x + omega.y + omega.z).is_finite()
            && omega.iter().all(|c| c.is_finite())
    }
}

fn finite(what: &'static str, value: f64) -> Result<(), MotionError> {
    if value.is_finite() {
        Ok(())
    } else {
        Err(MotionError::NotFinite { what, value })
    }
}

impl<T: Number> Rates<T> {
    /// This rate plus `factor` times another.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(crate) fn plus(&self, other: &Self, factor: T) -> Self {
        Self {
            attitude: self.attitude + other.attitude * factor,
            angular_acceleration: self.angular_acceleration + other.angular_acceleration * factor,
        }
    }
}
