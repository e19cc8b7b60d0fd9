//! Derivatives of the exponential of rotations and of its inverse: what is needed to differentiate through states.

use crate::motion::State;
use nalgebra::{Matrix3, Matrix6, Vector3, Vector6};

/// The right Jacobian of SO(3): exp(θ + δ) = exp(θ) exp(J δ) to first order in δ.
///
/// `J = 1 − (1 − cos θ)/θ² [θ]× + (θ − sin θ)/θ³ [θ]×²`. Chirikjian (2012), *Stochastic Models, Information Theory, and Lie
/// Groups* 2, section 10.6. Singular at a full turn.
pub fn right_jacobian(theta: &Vector3<f64>) -> Matrix3<f64> {
    let cross = theta.cross_matrix();
    let square = theta.norm_squared();
    Matrix3::identity() - cross * versine(square) + cross * cross * third(square)
}

/// The inverse of [`right_jacobian`]: Log(exp(θ) exp(δ)) = θ + J⁻¹ δ to first order in δ.
///
/// `J⁻¹ = 1 + ½ [θ]× + (1/θ² − (1 + cos θ)/(2 θ sin θ)) [θ]×²`. Not finite at a full turn.
pub fn right_jacobian_inverse(theta: &Vector3<f64>) -> Matrix3<f64> {
    let cross = theta.cross_matrix();
    let square = theta.norm_squared();
    Matrix3::identity() + cross * 0.5 + cross * cross * inverse_third(square)
}

/// (1 − cos θ)/θ² of θ².
fn versine(square: f64) -> f64 {
    let half = square.sqrt() / 2.0;
    // Below this sin(x)/x is 1 to the last bit, and 0/0 is kept away.
    let ratio = if half < 1e-9 { 1.0 } else { half.sin() / half };
    ratio * ratio / 2.0
}

/// (θ − sin θ)/θ³ of θ², below one radian by its series: the difference cancels.
fn third(square: f64) -> f64 {
    if square >= 1.0 {
        let angle = square.sqrt();
        return (angle - angle.sin()) / (angle * square);
    }
    let (mut term, mut sum) = (1.0 / 6.0, 0.0);
    for k in 0..9 {
        sum += term;
        let next = f64::from(2 * k + 4) * f64::from(2 * k + 5);
        term *= -square / next;
    }
    sum
}

/// (1 − A/2B)/θ² with A = sin θ/θ and B = (1 − cos θ)/θ², of θ². Below one radian 2B − A by its series,
/// Σ (−1)^(k+1) 2k θ^2k/(2k + 2)! from k = 1.
fn inverse_third(square: f64) -> f64 {
    let versine = versine(square);
    if square >= 1.0 {
        let angle = square.sqrt();
        return (1.0 - angle.sin() / angle / (2.0 * versine)) / square;
    }
    let (mut power, mut sum) = (1.0 / 24.0, 0.0);
    for k in 1..10 {
        sum += f64::from(2 * k) * power;
        let next = f64::from(2 * k + 3) * f64::from(2 * k + 4);
        power *= -square / next;
    }
    sum / (2.0 * versine)
}

impl State<f64> {
    /// [`perturbed`](Self::perturbed), and its derivatives in this state's own tangent and in the tangent vector.
    ///
    /// Rows and columns (θ, ω); the rows are of the tangent at the result.
    ///
    /// ```
    /// use nalgebra::Vector6;
    /// use polhode::motion::State;
    /// let tangent = Vector6::new(0.3, -0.2, 0.5, 0.0, 1.0, 0.0);
    /// let (end, [by_state, by_tangent]) = State::at_rest().perturbed_with_jacobians(&tangent);
    /// let step = Vector6::new(1e-6, 2e-6, -1e-6, 0.0, 0.0, 0.0);
    /// let moved = State::at_rest().perturbed(&(tangent + step));
    /// assert!((end.difference(&moved) - by_tangent * step).norm() < 1e-11);
    /// let moved = State::at_rest().perturbed(&step).perturbed(&tangent);
    /// assert!((end.difference(&moved) - by_state * step).norm() < 1e-11);
    /// ```
    pub fn perturbed_with_jacobians(&self, tangent: &Vector6<f64>) -> (Self, [Matrix6<f64>; 2]) {
        let theta = tangent.fixed_rows::<3>(0).into_owned();
        let turned = crate::motion::Quaternion::exp(&theta).matrix().transpose();
        let jacobians = [turned, right_jacobian(&theta)].map(|block| beside_identity(&block));
        (self.perturbed(tangent), jacobians)
    }

    /// [`difference`](Self::difference), and its derivatives in the tangents of this state and of `other`.
    ///
    /// Rows and columns (θ, ω). Where the states are half a turn apart the difference jumps, and so do the derivatives.
    ///
    /// ```
    /// use nalgebra::{Vector3, Vector6};
    /// use polhode::motion::State;
    /// let start = State::at_rest().turning(Vector3::new(1.0, 2.0, 3.0));
    /// let other = start.perturbed(&Vector6::new(0.3, -0.2, 0.5, 0.0, 1.0, 0.0));
    /// let (found, [by_start, by_other]) = start.difference_with_jacobians(&other);
    /// let step = Vector6::new(1e-6, 2e-6, -1e-6, 0.0, 0.0, 3e-6);
    /// let moved = start.difference(&other.perturbed(&step));
    /// assert!((moved - found - by_other * step).norm() < 1e-11);
    /// let moved = start.perturbed(&step).difference(&other);
    /// assert!((moved - found - by_start * step).norm() < 1e-11);
    /// ```
    pub fn difference_with_jacobians(&self, other: &Self) -> (Vector6<f64>, [Matrix6<f64>; 2]) {
        let found = self.difference(other);
        let inverse = right_jacobian_inverse(&found.fixed_rows::<3>(0).into_owned());
        // The left Jacobian is the right one of −θ, which is the transpose.
        let by_self = -beside_identity(&inverse.transpose());
        (found, [by_self, beside_identity(&inverse)])
    }
}

/// A block for θ, and the identity for ω.
fn beside_identity(block: &Matrix3<f64>) -> Matrix6<f64> {
    let mut matrix = Matrix6::identity();
    matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(block);
    matrix
}
