//! What is known of a body, and the numbers that are left of its tensor.

use crate::mechanics::{InertiaParameters, inertia};
use crate::scalar::Ring;
use nalgebra::Matrix3;

/// What is known of the inertia tensor when code is written: what is zero, equal or a number stands in no operation.
#[derive(Clone, Copy, Debug, Default, PartialEq)]
pub enum KnownInertia {
    /// Nothing: six parameters.
    #[default]
    Full,
    /// xz is a plane of symmetry: I_xx, I_yy, I_zz and I_xz.
    OnePlane,
    /// No products of inertia: I_xx, I_yy, I_zz.
    Principal,
    /// No products, and I_yy = I_xx: I_xx and I_zz.
    Axisymmetric,
    /// No products, and all three moments equal: I_xx.
    Sphere,
    /// The tensor itself, kg m², its own entries: no parameter.
    Tensor(Matrix3<f64>),
}

/// Where the numbers of a tensor stand in the order xx, yy, zz, xy, xz, yz.
const ENTRIES: [(usize, usize); 6] = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];

/// Their indices.
pub(super) const INDICES: [&str; 6] = ["xx", "yy", "zz", "xy", "xz", "yz"];

impl KnownInertia {
    /// Which of xx, yy, zz, xy, xz, yz are parameters, in the order of `parameters`.
    pub(super) fn places(&self, parameters: InertiaParameters) -> Vec<usize> {
        let free: &[usize] = match self {
            Self::Full => &[0, 1, 2, 3, 4, 5],
            Self::OnePlane => &[0, 1, 2, 4],
            Self::Principal => &[0, 1, 2],
            Self::Axisymmetric => &[0, 2],
            Self::Sphere => &[0],
            Self::Tensor(_) => &[],
        };
        let order = parameters.places().into_iter();
        order.filter(|place| free.contains(place)).collect()
    }

    /// Whether the axes are principal ones.
    pub(super) fn is_principal(&self) -> bool {
        match self {
            Self::Full | Self::OnePlane => false,
            Self::Principal | Self::Axisymmetric | Self::Sphere => true,
            Self::Tensor(tensor) => ENTRIES[3..].iter().all(|place| tensor[*place] == 0.0),
        }
    }

    /// The tensor of as many parameters as there are places, over any ring to which a `constant` can be brought.
    pub(super) fn tensor<T: Ring>(
        &self,
        parameters: InertiaParameters,
        values: &[T],
        constant: impl Fn(f64) -> T,
    ) -> Matrix3<T> {
        if let Self::Tensor(tensor) = self {
            return tensor.map(constant);
        }
        let places = self.places(parameters);
        let [xx, yy, zz, xy, xz, yz] = std::array::from_fn(|place| {
            let source = match (self, place) {
                (Self::Axisymmetric, 1) | (Self::Sphere, 1 | 2) => 0,
                _ => place,
            };
            let value = places
                .iter()
                .zip(values)
                .find(|(place, _)| **place == source);
            value.map_or_else(T::zero, |(_, value)| value.clone())
        });
        inertia([xx, yy, zz], [xy, xz, yz], parameters.products())
    }
}
