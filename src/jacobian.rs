//! Is the Jacobian that I wrote by hand right, and if not, what is wrong with it?
//!
//! [`check()`] holds a Jacobian against dual numbers: there is no step size, and the answer is right to rounding. It takes
//! any function that is generic over its number. [`check_black_box`] takes a function of which only values can be had, and
//! holds the Jacobian against differences over a whole range of steps. `assert_jacobian!` is the
//! first of them for tests.
//!
//! ```
//! use nalgebra::{SMatrix, SVector};
//! use polhode::{jacobian, motion::Number};
//!
//! /// Range and bearing of a point.
//! fn polar<T: Number>(p: &SVector<T, 2>) -> SVector<T, 2> {
//!     SVector::from([p[0] * p[0] + p[1] * p[1], p[1] / p[0]])
//! }
//! let by_hand = |p: &SVector<f64, 2>| {
//!     SMatrix::<f64, 2, 2>::new(2.0 * p.x, 2.0 * p.y, p.y / p.x.powi(2), 1.0 / p.x)
//! };
//! let report = jacobian::check(polar, by_hand, &SVector::from([3.0, 4.0]));
//! assert_eq!(report.causes()[0].kind, jacobian::Kind::Sign);
//! assert!(report.to_string().contains("∂[1]/∂[0]: wrong sign"));
//! ```
//!
//! # What it says
//!
//! A [`Report`] gives a verdict on each entry, the largest discrepancy first, and the likely causes: the fewest simple
//! changes that make the right matrix into the given one. A wrong sign, a missing block, a lost factor of 2, a transpose and
//! swapped rows or columns are found in any matrix. Where rows and columns have names and a meaning ([`Slot`]), it also
//! knows the other ways to write the same: space for body axes, the perturbation on the other side of the attitude, the
//! other order of a quaternion, other orders and signs of inertia parameters, slots in another order.
//!
//! ```
//! use nalgebra::{SMatrix, SVector, Vector3};
//! use polhode::jacobian::{Check, Kind, Other, Slot};
//! use polhode::motion::{Number, Quaternion};
//!
//! // The velocity of a thruster's jet in space, by the attitude and by the velocity in the body.
//! const Q: [f64; 4] = [0.1, 0.7, -0.5, 0.5];
//! fn jet<T: Number>(x: &SVector<T, 6>) -> SVector<T, 3> {
//!     let half = x.fixed_rows::<3>(0) * T::of(0.5);
//!     let turn = Quaternion { w: T::one() - half.dot(&half) * T::of(0.5), v: half };
//!     let attitude = Quaternion::new(Q.map(T::of)) * turn;
//!     attitude.to_space(&x.fixed_rows::<3>(3).into_owned())
//! }
//! let q = Quaternion::new(Q);
//! // Written for a turn of the space side: −[v in space]×.
//! let by_hand = |x: &SVector<f64, 6>| {
//!     let velocity = q.to_space(&x.fixed_rows::<3>(3).into_owned());
//!     let mut matrix = SMatrix::<f64, 3, 6>::zeros();
//!     matrix.fixed_view_mut::<3, 3>(0, 0).copy_from(&-velocity.cross_matrix());
//!     matrix.fixed_view_mut::<3, 3>(0, 3).copy_from(&q.matrix());
//!     matrix
//! };
//! let report = Check::default()
//!     .rows([Slot::vector("v")])
//!     .columns([Slot::turn("θ", &q), Slot::vector_in_body("u", &q)])
//!     .of(jet, by_hand, &SVector::from([0.0, 0.0, 0.0, 1.0, 2.0, 3.0]));
//! assert_eq!(report.causes()[0].kind, Kind::Written(Other::Side));
//! ```
//! The guide to derivatives in optimisation, from the convention of the tangent space on, is
//! [`optimise`](../optimise/index.html).

mod by_differences;
mod by_dual_numbers;
mod cause;
mod check;
mod dual_vector;
mod explain;
mod report;
mod scale;
mod slot;

pub use cause::{Cause, Kind};
pub use check::{Check, check, check_black_box};
pub use dual_vector::DualVector;
pub use report::{Entry, Report, Verdict};
pub use slot::{Other, Slot};

/// Fails with a [`Report`] as its message unless a Jacobian is right.
///
/// Takes what [`check()`] takes, `assert_jacobian!(f, jacobian, at)`, with rows and columns named if wished, or a report that
/// has been made otherwise.
///
/// ```
/// use nalgebra::{SMatrix, SVector};
/// use polhode::{assert_jacobian, jacobian::{Slot, check_black_box}, motion::Number};
///
/// fn energy<T: Number>(omega: &SVector<T, 3>) -> SVector<T, 1> {
///     let [x, y, z] = [omega.x, omega.y, omega.z];
///     SVector::from([x * x + y * y * T::of(1.5) + z * z * T::of(2.0)])
/// }
/// let by_hand = |w: &SVector<f64, 3>| SMatrix::<f64, 1, 3>::new(2.0 * w.x, 3.0 * w.y, 4.0 * w.z);
/// let at = SVector::from([3.0, 0.5, -0.9]);
/// assert_jacobian!(energy, by_hand, &at);
/// assert_jacobian!(energy, by_hand, &at, rows: [Slot::scalar("T")], columns: [Slot::vector("ω")]);
/// assert_jacobian!(check_black_box(energy, by_hand, &at));
/// ```
#[macro_export]
macro_rules! assert_jacobian {
    ($report:expr $(,)?) => {{
        let report: $crate::jacobian::Report = $report;
        assert!(report.is_right(), "{report}");
    }};
    ($f:expr, $jacobian:expr, $at:expr $(,)?) => {{
        let report = $crate::jacobian::check($f, $jacobian, $at);
        assert!(report.is_right(), "{report}");
    }};
    ($f:expr, $jacobian:expr, $at:expr, rows: $rows:expr, columns: $columns:expr $(,)?) => {{
        let check = $crate::jacobian::Check::default()
            .rows($rows)
            .columns($columns);
        let report = check.of($f, $jacobian, $at);
        assert!(report.is_right(), "{report}");
    }};
}
