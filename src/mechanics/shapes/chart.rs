//! A body as the image of three parameters.

use crate::mechanics::Moments;
use crate::mechanics::shapes::range::{Powers, Range};
use crate::scalar::{Field, Ring};
use nalgebra::{Matrix3, Vector3};

/// A product of powers of the three parameters.
pub(super) type Monomial = [Powers; 3];

/// No parameter at all: the number 1.
pub(super) const ONE: Monomial = [[0, 0]; 3];

/// A body, described once: everything else is integration.
#[derive(Clone, Debug)]
pub(super) struct Chart<T> {
    /// What each parameter runs over.
    pub(super) ranges: [Range<T>; 3],
    /// The length, area or volume at a point, per range of the parameters.
    pub(super) measure: Monomial,
    /// The coordinates x, y, z of a point.
    pub(super) point: [Monomial; 3],
}

impl<T: Field> Chart<T> {
    /// Length, area or volume.
    pub(super) fn content(&self) -> T {
        let lengths = self.ranges.iter().map(Range::length);
        lengths.fold(self.integral(&[]), |content, length| content * length)
    }

    /// The moments of the body with the mass 1.
    pub(super) fn moments(&self) -> Moments<T> {
        let whole = self.integral(&[]);
        let mean = |factors: &[Monomial]| self.integral(factors) / whole.clone();
        let [x, y, z] = self.point;
        let [xx, yy, zz] = self.point.map(|r| mean(&[r, r]));
        let [xy, xz, yz] = [[x, y], [x, z], [y, z]].map(|pair| mean(&pair));
        Moments {
            mass: T::one(),
            first: Vector3::from(self.point.map(|r| mean(&[r]))),
            second: Matrix3::new(xx, xy.clone(), xz.clone(), xy, yy, yz.clone(), xz, yz, zz),
        }
    }

    /// The integral of a product of monomials over the body, less the lengths of the ranges.
    fn integral(&self, factors: &[Monomial]) -> T {
        let mut powers = self.measure;
        for (k, power) in powers.iter_mut().enumerate() {
            for factor in factors {
                *power = [power[0] + factor[k][0], power[1] + factor[k][1]];
            }
        }
        let each = self.ranges.iter().zip(powers);
        each.fold(T::one(), |product, (range, power)| {
            product * range.integral(power)
        })
    }
}

/// A body of mass 1, and its length, area or volume where that takes no root.
#[derive(Clone, Debug)]
pub(super) struct Unit<T> {
    pub(super) moments: Moments<T>,
    pub(super) content: Option<T>,
}

impl<T: Field> From<Chart<T>> for Unit<T> {
    fn from(chart: Chart<T>) -> Self {
        Self {
            moments: chart.moments(),
            content: Some(chart.content()),
        }
    }
}

impl<T: Ring> Unit<T> {
    /// The image under `r ↦ A r + d`, which multiplies the content by `factor`.
    pub(super) fn image(self, linear: &Matrix3<T>, shift: &Vector3<T>, factor: T) -> Self {
        Self {
            moments: self.moments.placed(linear, shift),
            content: self.content.map(|content| content * factor),
        }
    }

    /// The image under a stretch along the axes.
    pub(super) fn stretched(self, by: &Vector3<T>, factor: T) -> Self {
        self.image(&Matrix3::from_diagonal(by), &Vector3::zeros(), factor)
    }
}
