//! Mass, first and second moments of a body, which add up and move with it.

use crate::mechanics::{apply, product};
use crate::scalar::{Field, Ring};
use nalgebra::{Matrix3, Vector3};

/// The moments of a body about the origin of its coordinates, along their axes.
///
/// They determine mass centre and inertia tensor about every point. Unlike these they are sums over the parts, so that
/// the parallel axis theorem needs no place of its own.
#[derive(Clone, Debug, PartialEq)]
pub struct Moments<T> {
    /// ∫ dm, kg.
    pub mass: T,
    /// ∫ r dm, kg m.
    pub first: Vector3<T>,
    /// ∫ r rᵀ dm, kg m². It is no inertia tensor: its diagonal is ∫ x² dm, ∫ y² dm, ∫ z² dm.
    pub second: Matrix3<T>,
}

impl<T: Ring> Moments<T> {
    /// A point mass, kg, at a position, m.
    pub fn of_point(mass: &T, position: &Vector3<T>) -> Self {
        let first = position.map(|r| r * mass.clone());
        Self {
            mass: mass.clone(),
            second: outer(&first, position),
            first,
        }
    }

    /// The inertia tensor about a point, kg m²: `∫ (s·s 1 − s sᵀ) dm` with s from the point.
    ///
    /// A product of inertia stands in it as the entry −∫ x y dm. `point` is in the coordinates of the moments, and the
    /// tensor along their axes.
    pub fn inertia_about(&self, point: &Vector3<T>) -> Matrix3<T> {
        let from_point = self.placed(&Matrix3::identity(), &-point.clone());
        Matrix3::from_diagonal_element(from_point.second.trace()) - from_point.second
    }

    /// The body after `r ↦ R r + d`: turned by R, then shifted by d in m.
    ///
    /// With R from the body's axes to others these are its moments along the others. R may be any linear map: the body
    /// is stretched with its mass, which keeps a solid uniform, but not a curved shell or wire.
    #[must_use]
    pub fn placed(&self, rotation: &Matrix3<T>, shift: &Vector3<T>) -> Self {
        let turned = apply(rotation, &self.first);
        let crossed = outer(&turned, shift) + outer(shift, &turned);
        let moved = shift.map(|d| d * self.mass.clone());
        let second = product(&product(rotation, &self.second), &rotation.transpose());
        let second = second + crossed + outer(&moved, shift);
        Self {
            mass: self.mass.clone(),
            first: turned + moved,
            // Both halves the same, to the last bit.
            second: Matrix3::from_fn(|i, j| second[(i.min(j), i.max(j))].clone()),
        }
    }

    /// This body and another, in the same coordinates.
    #[must_use]
    pub fn plus(&self, other: &Self) -> Self {
        Self {
            mass: self.mass.clone() + other.mass.clone(),
            first: &self.first + &other.first,
            second: &self.second + &other.second,
        }
    }

    /// This body without another, in the same coordinates: a hole.
    #[must_use]
    pub fn minus(&self, other: &Self) -> Self {
        Self {
            mass: self.mass.clone() - other.mass.clone(),
            first: &self.first - &other.first,
            second: &self.second - &other.second,
        }
    }

    /// The same body, each of its points `factor` times as heavy.
    #[must_use]
    pub fn scaled(&self, factor: &T) -> Self {
        Self {
            mass: self.mass.clone() * factor.clone(),
            first: self.first.map(|f| f * factor.clone()),
            second: self.second.map(|s| s * factor.clone()),
        }
    }
}

impl<T: Field> Moments<T> {
    /// The mass centre, m: `∫ r dm / ∫ dm`. The mass must not be zero.
    pub fn mass_centre(&self) -> Vector3<T> {
        self.first.map(|f| f / self.mass.clone())
    }

    /// The inertia tensor about the mass centre, kg m², along the axes of the moments. The mass must not be zero.
    pub fn central_inertia(&self) -> Matrix3<T> {
        self.inertia_about(&self.mass_centre())
    }
}

/// `a bᵀ`.
fn outer<T: Ring>(a: &Vector3<T>, b: &Vector3<T>) -> Matrix3<T> {
    Matrix3::from_fn(|i, j| a[i].clone() * b[j].clone())
}
