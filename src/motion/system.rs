//! A body and the torque on it.

use crate::mechanics::{adjugate, angular_momentum, apply, cross, possible_body};
use crate::motion::{Frame, MotionError, Number, Rates, State, TorqueLaw, torque::in_body};
use nalgebra::{Matrix3, Vector3};

/// A rigid body about its mass centre or a fixed point, and the law of the torque on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct System<T, L> {
    inertia: Matrix3<T>,
    inverse: Matrix3<T>,
    law: L,
    added: Vector3<T>,
}

impl<L: TorqueLaw<f64>> System<f64, L> {
    /// The system of an inertia tensor (kg m², body axes, the tensor's own entries) and a law of torque.
    ///
    /// # Errors
    /// A tensor that no body has.
    pub fn new(inertia: Matrix3<f64>, law: L) -> Result<Self, MotionError> {
        possible_body(&inertia).map_err(MotionError::Inertia)?;
        Ok(Self::over(inertia, law, Vector3::zeros()))
    }
}

impl<T: Number, L: TorqueLaw<T>> System<T, L> {
    /// The system over any number, with a constant torque `added` to the law in the axes that the law names.
    /// A tensor without an inverse gives numbers that are not finite.
    pub fn over(inertia: Matrix3<T>, law: L, added: Vector3<T>) -> Self {
        Self {
            inverse: inverse(&inertia),
            inertia,
            law,
            added,
        }
    }

    /// The inertia tensor.
    pub fn inertia(&self) -> &Matrix3<T> {
        &self.inertia
    }

    /// Its inverse.
    pub(crate) fn inverse(&self) -> &Matrix3<T> {
        &self.inverse
    }

    /// The torque added to the law.
    pub(crate) fn added(&self) -> &Vector3<T> {
        &self.added
    }

    /// The law of torque.
    pub fn law(&self) -> &L {
        &self.law
    }

    /// The whole torque at a time in a state, body axes.
    #[inline]
    pub fn torque(&self, time: T, state: &State<T>) -> Vector3<T> {
        let added = match self.law.added_in() {
            Frame::Body => self.added,
            Frame::Space => in_body(Frame::Space, &state.attitude, self.added),
        };
        self.law.torque(time, state) + added
    }

    /// q̇ = ½ q ω, and ω̇ = I⁻¹ (M − ω × I ω) as in
    /// [`angular_acceleration`](crate::mechanics::angular_acceleration), with the inverse formed once.
    #[inline]
    pub fn rates(&self, time: T, state: &State<T>) -> Rates<T> {
        let omega = &state.angular_velocity;
        let momentum = angular_momentum(&self.inertia, omega);
        let net = self.torque(time, state) - cross(omega, &momentum);
        Rates {
            attitude: state.attitude.rate(omega),
            angular_acceleration: apply(&self.inverse, &net),
        }
    }
}

/// The inverse of a symmetric matrix by its adjugate, without a branch. The scale is taken out first by the
/// trace, so that moments of 1e±150 keep their determinant.
fn inverse<T: Number>(m: &Matrix3<T>) -> Matrix3<T> {
    let scale = T::one() / (m[(0, 0)] + m[(1, 1)] + m[(2, 2)]);
    let scaled = m * scale;
    let minors = adjugate(&scaled);
    let determinant = scaled[(0, 0)] * minors[(0, 0)]
        + scaled[(0, 1)] * minors[(1, 0)]
        + scaled[(0, 2)] * minors[(2, 0)];
    minors * (scale / determinant)
}
