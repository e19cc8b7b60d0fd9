//! The inertia tensor: from six numbers in either sign convention, from masses, in other axes, and its rate.

use crate::mechanics::{apply, product, skew};
use crate::scalar::Ring;
use nalgebra::{Matrix3, Vector3};

/// What a product of inertia stands for. Half of the world writes the one, half the other.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash)]
pub enum Products {
    /// I_xy = ∫ x y dm, and the tensor holds −I_xy: textbooks of mechanics (Beer and Johnston, Hibbeler).
    #[default]
    Integrals,
    /// I_xy = −∫ x y dm is the tensor's entry: URDF, SDFormat, MuJoCo, Drake, Pinocchio.
    Entries,
}

/// The inertia tensor in kg m², from the moments `[I_xx, I_yy, I_zz]` and the products `[I_xy, I_xz, I_yz]`.
///
/// The entries are ∫ (y² + z²) dm … on the diagonal and −∫ x y dm … off it, along the axes of the six numbers.
///
/// ```
/// use polhode::mechanics::{Products, inertia};
/// let textbook = inertia([2, 3, 4], [1, 0, 0], Products::Integrals);
/// assert_eq!(textbook, inertia([2, 3, 4], [-1, 0, 0], Products::Entries));
/// assert_eq!(textbook[(0, 1)], -1);
/// ```
#[inline]
pub fn inertia<T: Ring>(moments: [T; 3], products: [T; 3], convention: Products) -> Matrix3<T> {
    let [xx, yy, zz] = moments;
    let [xy, xz, yz] = match convention {
        Products::Integrals => products.map(|p| -p),
        Products::Entries => products,
    };
    Matrix3::new(xx, xy.clone(), xz.clone(), xy, yy, yz.clone(), xz, yz, zz)
}

/// The inertia tensor of point masses about the origin: Σ m (r·r 1 − r rᵀ), along the axes of the positions.
///
/// Each point is its mass in kg and its position in m.
pub fn inertia_of_points<'a, T: Ring>(
    points: impl IntoIterator<Item = &'a (T, Vector3<T>)>,
) -> Matrix3<T> {
    points
        .into_iter()
        .fold(Matrix3::zeros(), |sum, (mass, position)| {
            sum + of_point(mass, position)
        })
}

/// `m (r·r 1 − r rᵀ)`: one point mass, about the origin.
pub(in crate::mechanics) fn of_point<T: Ring>(mass: &T, r: &Vector3<T>) -> Matrix3<T> {
    let square = r.dot(r);
    Matrix3::from_fn(|i, j| {
        let outer = r[i].clone() * r[j].clone();
        let entry = if i == j {
            square.clone() - outer
        } else {
            -outer
        };
        mass.clone() * entry
    })
}

/// The same tensor along other axes: `R I Rᵀ`, where the rows of `R` are the new axes in the old ones
/// (so that `R v` are the new components of a vector `v`).
pub fn inertia_in_axes<T: Ring>(rotation: &Matrix3<T>, inertia: &Matrix3<T>) -> Matrix3<T> {
    product(&product(rotation, inertia), &rotation.transpose())
}

/// The rate of the tensor's entries along axes that turn with Ω, while the body turns with ω:
/// `İ = [ω−Ω]× I − I [ω−Ω]×`, in kg m²/s.
///
/// It is the transport theorem of a tensor that is constant in the body. Zero where the axes are attached to the
/// body, Ω = ω; the full rate in space where Ω = 0. All components along the turning axes.
pub fn inertia_rate<T: Ring>(
    inertia: &Matrix3<T>,
    omega: &Vector3<T>,
    frame_rate: &Vector3<T>,
) -> Matrix3<T> {
    let spin = skew(&(omega - frame_rate));
    product(&spin, inertia) - product(inertia, &spin)
}

/// The tensor of a body that is the same about all axes across a unit vector d: `I_t 1 + (I_s − I_t) d dᵀ` in kg m².
///
/// `across` is I_t and `along` I_s. No spin about d changes it, so it needs no axes fixed in the body.
pub fn symmetric_inertia<T: Ring>(across: &T, along: &T, axis: &Vector3<T>) -> Matrix3<T> {
    Matrix3::from_fn(|r, c| {
        let dyad = (along.clone() - across.clone()) * axis[r].clone() * axis[c].clone();
        if r == c { across.clone() + dyad } else { dyad }
    })
}

/// `v · I v`.
pub(in crate::mechanics) fn quadratic<T: Ring>(inertia: &Matrix3<T>, v: &Vector3<T>) -> T {
    v.dot(&apply(inertia, v))
}
