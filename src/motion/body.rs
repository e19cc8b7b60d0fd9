//! A possible body and its principal axes.

use crate::mechanics::{possible_body, principal_axes};
use crate::motion::{MotionError, Quaternion, State};
use nalgebra::{Matrix3, Vector3};

/// A body: its inertia tensor, checked, and what it looks like along its principal axes.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Body {
    inertia: Matrix3<f64>,
    moments: Vector3<f64>,
    axes: Matrix3<f64>,
    turn: Quaternion<f64>,
}

impl Body {
    /// The body of an inertia tensor (kg m², body axes, the tensor's own entries; for products of inertia in the
    /// other sign see [`inertia`](crate::mechanics::inertia)).
    ///
    /// # Errors
    /// A tensor that no body has: not finite, not symmetric, not positive definite, or against the triangle
    /// inequality. A flat plate, where the inequality is an equality, is a body.
    ///
    /// ```
    /// use nalgebra::Matrix3;
    /// use polhode::{mechanics::{Products, inertia}, motion::Body};
    /// let handle = Body::new(&inertia([2.0, 3.0, 4.0], [0.1, 0.0, 0.0], Products::Integrals))?;
    /// assert!(handle.moments().x < 2.0);
    /// assert!(Body::new(&Matrix3::from_diagonal_element(-1.0)).is_err());
    /// # Ok::<(), polhode::motion::MotionError>(())
    /// ```
    pub fn new(inertia: &Matrix3<f64>) -> Result<Self, MotionError> {
        possible_body(inertia).map_err(MotionError::Inertia)?;
        let principal = principal_axes(inertia);
        Ok(Self {
            inertia: *inertia,
            moments: principal.moments,
            axes: principal.axes,
            turn: Quaternion::of_matrix(&principal.axes),
        })
    }

    /// The inertia tensor in body axes.
    pub fn inertia(&self) -> &Matrix3<f64> {
        &self.inertia
    }

    /// The principal moments, ascending, kg m².
    pub fn moments(&self) -> &Vector3<f64> {
        &self.moments
    }

    /// The principal axes as columns: a rotation from principal to body components.
    pub fn axes(&self) -> &Matrix3<f64> {
        &self.axes
    }

    /// A state of the body, seen along its principal axes.
    pub fn state_along(&self, state: &State<f64>) -> State<f64> {
        State {
            attitude: state.attitude * self.turn,
            angular_velocity: self.axes.tr_mul(&state.angular_velocity),
        }
    }

    /// A state along principal axes, seen in body axes again.
    pub fn state_from(&self, principal: &State<f64>) -> State<f64> {
        State {
            attitude: principal.attitude * self.turn.conjugate(),
            angular_velocity: self.axes * principal.angular_velocity,
        }
    }

    /// The same rotation as a quaternion.
    pub fn turn(&self) -> &Quaternion<f64> {
        &self.turn
    }
}
