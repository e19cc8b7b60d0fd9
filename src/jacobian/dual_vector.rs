//! Vectors of dual numbers, and what the compiler says where others stand.

use nalgebra::{DefaultAllocator, Dim, OVector, allocator::Allocator};
use num_dual::Dual64;

/// A vector of dual numbers: what a function takes and gives whose derivative [`check`](super::check()) is to know.
///
/// A function over doubles does not, and the compiler says what to write:
///
/// ```compile_fail,E0277
/// use nalgebra::{SMatrix, SVector};
/// let square = |x: &SVector<f64, 1>| SVector::from([x[0] * x[0]]);
/// let by_hand = |x: &SVector<f64, 1>| SMatrix::<f64, 1, 1>::new(2.0 * x[0]);
/// polhode::jacobian::check(square, by_hand, &SVector::from([3.0]));
/// ```
#[diagnostic::on_unimplemented(
    message = "the function to be differentiated is not over dual numbers",
    label = "takes or gives `{Self}`",
    note = "write it for every number: `fn f<T: Number>(x: &SVector<T, 3>) -> SVector<T, 2>`, with `polhode::motion::Number`",
    note = "or for dual numbers: `|x: &SVector<Dual64, 3>| …`, with `polhode::num_dual::Dual64`",
    note = "a function over `f64` alone is checked by differences: `check_black_box`, `Check::of_black_box`"
)]
pub trait DualVector<N: Dim>: Sized
where
    DefaultAllocator: Allocator<N>,
{
    /// The vector as what a function takes.
    fn of(vector: OVector<Dual64, N>) -> Self;

    /// What a function gives as the vector.
    fn vector(self) -> OVector<Dual64, N>;
}

impl<N: Dim> DualVector<N> for OVector<Dual64, N>
where
    DefaultAllocator: Allocator<N>,
{
    fn of(vector: OVector<Dual64, N>) -> Self {
        vector
    }

    fn vector(self) -> OVector<Dual64, N> {
        self
    }
}
