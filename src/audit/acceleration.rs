//! An acceleration function under audit.

use super::finding::{Audit, Finding, Unseen};
use super::model::{identify, instants};
use crate::mechanics::{possible_body, principal_axes};
use crate::motion::MotionError;
use nalgebra::{Matrix3, Vector3};

/// Audits `f(ω, torque)`, which gives the angular acceleration of a body with this inertia tensor, all in body axes.
///
/// It should be I⁻¹ (M − ω × Iω), to 1e-6. A tensor with products of inertia and three different moments tells most. Where
/// several slips fit, the fewest are told.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::audit::{self, Finding, Where};
/// let inertia = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
/// // Euler's equations of principal axes, for a body of which these are none.
/// let [a, b, c] = [0.6, 0.8, 1.0];
/// let f = |w: &Vector3<f64>, m: &Vector3<f64>| Vector3::new(
///     (m.x + (b - c) * w.y * w.z) / a,
///     (m.y + (c - a) * w.z * w.x) / b,
///     (m.z + (a - b) * w.x * w.y) / c,
/// );
/// let audit = audit::acceleration(f, &inertia)?;
/// assert_eq!(audit.findings(), [Finding::DiagonalOnly(Where::Everywhere)]);
/// # Ok::<(), polhode::motion::MotionError>(())
/// ```
///
/// # Errors
/// A tensor that no body has.
pub fn acceleration(
    f: impl Fn(&Vector3<f64>, &Vector3<f64>) -> Vector3<f64>,
    inertia: &Matrix3<f64>,
) -> Result<Audit, MotionError> {
    possible_body(inertia).map_err(MotionError::Inertia)?;
    let instants = instants(inertia, 2.0).into_iter();
    let seen: Vec<_> = instants.map(|at| (at, f(&at.omega, &at.torque))).collect();
    let findings = match identify(inertia, &seen, 1e-6, false) {
        Ok(model) => model.slips,
        Err(off) => vec![Finding::Unknown(off)],
    };
    Ok(Audit {
        findings,
        witnesses: None,
        order: None,
        unseen: unseen(inertia),
    })
}

/// What a body does not show.
pub(super) fn unseen(inertia: &Matrix3<f64>) -> Vec<Unseen> {
    let mut unseen = vec![];
    if [(0, 1), (0, 2), (1, 2)]
        .iter()
        .all(|place| inertia[*place] == 0.0)
    {
        unseen.push(Unseen::Products);
    }
    let moments = principal_axes(inertia).moments;
    if moments.max() - moments.min() <= 1e-6 * moments.max() {
        unseen.push(Unseen::Gyroscopic);
    }
    unseen
}
