//! The moment as a linear function of the six inertia parameters.

use crate::mechanics::{Products, inertia};
use crate::scalar::{Jet, Ring};
use nalgebra::{Matrix3, SMatrix, Vector3};

/// The order and the sign in which six inertia parameters are written.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum InertiaParameters {
    /// I_xx, I_yy, I_zz, I_xy, I_xz, I_yz with I_xy = ∫ x y dm: textbooks, [`Products::Integrals`].
    #[default]
    Lecture,
    /// ixx, ixy, ixz, iyy, iyz, izz, the tensor's own entries: the attributes of `<inertia>`.
    Urdf,
    /// xx, yy, zz, xy, xz, yz, the tensor's own entries: the attribute `fullinertia`.
    MuJoCo,
    /// xx, xy, yy, xz, yz, zz, the tensor's own entries: the last six of `toDynamicParameters`.
    Pinocchio,
}

impl InertiaParameters {
    /// Where each parameter stands in the order xx, yy, zz, xy, xz, yz.
    pub(crate) fn places(self) -> [usize; 6] {
        match self {
            Self::Lecture | Self::MuJoCo => [0, 1, 2, 3, 4, 5],
            Self::Urdf => [0, 3, 4, 1, 5, 2],
            Self::Pinocchio => [0, 3, 1, 4, 5, 2],
        }
    }

    /// What the products of inertia stand for.
    pub fn products(self) -> Products {
        match self {
            Self::Lecture => Products::Integrals,
            _ => Products::Entries,
        }
    }

    /// The tensor of six parameters, kg m².
    ///
    /// ```
    /// use polhode::mechanics::InertiaParameters;
    /// let lecture = InertiaParameters::Lecture.tensor([2, 3, 4, -1, 0, 0]);
    /// assert_eq!(lecture, InertiaParameters::Urdf.tensor([2, 1, 0, 3, 0, 4]));
    /// ```
    pub fn tensor<T: Ring>(self, parameters: [T; 6]) -> Matrix3<T> {
        let mut ordered: [T; 6] = std::array::from_fn(|_| T::zero());
        for (place, parameter) in self.places().into_iter().zip(parameters) {
            ordered[place] = parameter;
        }
        let [xx, yy, zz, xy, xz, yz] = ordered;
        inertia([xx, yy, zz], [xy, xz, yz], self.products())
    }

    /// The six parameters of a tensor; its upper triangle is read.
    pub fn of_tensor<T: Ring>(self, tensor: &Matrix3<T>) -> [T; 6] {
        let entries = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
        self.places().map(|place| {
            let entry = tensor[entries[place]].clone();
            if place > 2 && self.products() == Products::Integrals {
                -entry
            } else {
                entry
            }
        })
    }

    /// The regressor Y(ω, α) of [`regressor()`] for parameters in this order and sign.
    pub fn regressor<T: Ring>(self, omega: &Vector3<T>, alpha: &Vector3<T>) -> SMatrix<T, 3, 6> {
        let columns = regressor(omega, alpha);
        let places = self.places();
        SMatrix::from_fn(|row, column| {
            let entry = columns[(row, places[column])].clone();
            if places[column] > 2 && self.products() == Products::Integrals {
                -entry
            } else {
                entry
            }
        })
    }

    /// The derivatives of the regressor in ω_x, ω_y, ω_z, α_x, α_y, α_z.
    pub fn regressor_derivatives<T: Ring>(
        self,
        omega: &Vector3<T>,
        alpha: &Vector3<T>,
    ) -> [SMatrix<T, 3, 6>; 6] {
        let seeded = |v: &Vector3<T>, first: usize| {
            Vector3::from_fn(|i, _| Jet::<T, 6>::variable(v[i].clone(), first + i))
        };
        let moving = self.regressor(&seeded(omega, 0), &seeded(alpha, 3));
        std::array::from_fn(|k| moving.map(|entry| entry.partials[k].clone()))
    }
}

/// The regressor Y(ω, α), 3 × 6: `I α + ω × I ω = Y (I_xx, I_yy, I_zz, I_xy, I_xz, I_yz)`, in N m per kg m².
///
/// The parameters are the tensor's own entries, in body axes, a product of inertia and its mirror image moving
/// together. For other orders and signs see [`InertiaParameters::regressor`].
///
/// ```
/// use nalgebra::Vector3;
/// use polhode::mechanics::{InertiaParameters, moment};
/// let (omega, alpha) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
/// let urdf = [11, 2, 3, 13, 5, 17];
/// let y = InertiaParameters::Urdf.regressor(&omega, &alpha);
/// let tensor = InertiaParameters::Urdf.tensor(urdf);
/// assert_eq!(y * nalgebra::SVector::from(urdf), moment(&tensor, &omega, &alpha));
/// ```
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn regressor<T: Ring>(omega: &Vector3<T>, alpha: &Vector3<T>) -> SMatrix<T, 3, 6> {
    let [x, y, z] = [0, 1, 2].map(|i| alpha[i].clone());
    let product = |i: usize, j: usize| omega[i].clone() * omega[j].clone();
    let (xx, yy, zz) = (product(0, 0), product(1, 1), product(2, 2));
    let (xy, xz, yz) = (product(0, 1), product(0, 2), product(1, 2));
    SMatrix::from_columns(&[
        Vector3::new(x.clone(), xz.clone(), -xy.clone()),
        Vector3::new(-yz.clone(), y.clone(), xy.clone()),
        Vector3::new(yz.clone(), -xz.clone(), z.clone()),
        Vector3::new(
            y.clone() - xz.clone(),
            x.clone() + yz.clone(),
            xx.clone() - yy.clone(),
        ),
        Vector3::new(z.clone() + xy.clone(), zz.clone() - xx, x - yz),
        Vector3::new(yy - zz, z - xy, y + xz),
    ])
}
