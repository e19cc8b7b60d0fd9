//! The inertia tensor about another point.

use crate::mechanics::inertia::of_point;
use crate::scalar::Ring;
use nalgebra::{Matrix3, Vector3};

/// The tensor about a point O from the one about the mass centre G: `I_O = I_G + m (d·d 1 − d dᵀ)`, in kg m².
///
/// Huygens 1673, Steiner 1840. `offset` is d between G and O along the axes of the tensor; its sign does not matter.
/// With the mass negated it leads from O back to G. It does not join two points of which neither is G.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::mechanics::parallel_axis;
/// let about_end = parallel_axis(&Matrix3::from_diagonal(&Vector3::new(1, 1, 0)), &3, &Vector3::new(0, 0, 2));
/// assert_eq!(about_end, Matrix3::from_diagonal(&Vector3::new(13, 13, 0)));
/// ```
#[inline]
pub fn parallel_axis<T: Ring>(inertia: &Matrix3<T>, mass: &T, offset: &Vector3<T>) -> Matrix3<T> {
    inertia + of_point(mass, offset)
}
