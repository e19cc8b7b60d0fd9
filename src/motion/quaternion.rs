//! Quaternions, scalar first.

use crate::mechanics::{cross, quaternion_product, rotation};
use crate::motion::{Coefficient, Number};
use nalgebra::{Matrix3, Vector3, Vector4};
use std::ops::{Add, Mul};

/// The quaternion w + x i + y j + z k. As an attitude it is of unit length and turns body axes into space
/// axes: a vector v in the body is q v q⁻¹ in space.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Quaternion<T> {
    /// The scalar part.
    pub w: T,
    /// The vector part (x, y, z).
    pub v: Vector3<T>,
}

impl<T: Number> Quaternion<T> {
    /// The quaternion of the components w, x, y, z.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn new([w, x, y, z]: [T; 4]) -> Self {
        Self {
            w,
            v: Vector3::new(x, y, z),
        }
    }

    /// The components w, x, y, z.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn components(&self) -> [T; 4] {
        [self.w, self.v.x, self.v.y, self.v.z]
    }

    /// No rotation.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn identity() -> Self {
        Self::new([T::one(), T::zero(), T::zero(), T::zero()])
    }

    /// w − x i − y j − z k: of a unit quaternion the inverse rotation.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn conjugate(&self) -> Self {
        Self {
            w: self.w,
            v: -self.v,
        }
    }

    /// w² + x² + y² + z².
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn norm_squared(&self) -> T {
        self.w * self.w + self.v.x * self.v.x + self.v.y * self.v.y + self.v.z * self.v.z
    }

    /// The quaternion of unit length in this direction.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn normalised(&self) -> Self {
        *self * (T::one() / self.norm_squared().sqrt())
    }

    /// The vector of the space frame that has the components `v` in the body: q v q⁻¹.
    ///
    /// Of a quaternion off unit length it is |q|² times that, whatever the axes: a stage of a step knows none.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn to_space(&self, v: &Vector3<T>) -> Vector3<T> {
        let (w, u) = (self.w, &self.v);
        let (square, along) = (
            u.x * u.x + u.y * u.y + u.z * u.z,
            u.x * v.x + u.y * v.y + u.z * v.z,
        );
        // Doubled by sums: a product with a constant would have derivatives to multiply by.
        v * (w * w - square) + u * (along + along) + cross(u, v) * (w + w)
    }

    /// The components in the body of the space vector `v`: q⁻¹ v q.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn to_body(&self, v: &Vector3<T>) -> Vector3<T> {
        self.conjugate().to_space(v)
    }

    /// The components in the body of a vector that is constant in space, as [`to_body`](Self::to_body) has them: with derivatives
    /// at about half the cost.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn constant_to_body<C: Coefficient<T>>(&self, v: &Vector3<C>) -> Vector3<T> {
        let (w, u) = (self.w, &self.v);
        let square = u.x * u.x + u.y * u.y + u.z * u.z;
        let along = v.x.times(u.x) + v.y.times(u.y) + v.z.times(u.z);
        let across = Vector3::new(
            v.z.times(u.y) - v.y.times(u.z),
            v.x.times(u.z) - v.z.times(u.x),
            v.y.times(u.x) - v.x.times(u.y),
        );
        let straight = w * w - square;
        v.map(|component| component.times(straight)) + u * (along + along) - across * (w + w)
    }

    /// The rotation matrix R, body → space.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn matrix(&self) -> Matrix3<T> {
        rotation(&self.components().into())
    }

    /// The rate q̇ = ½ q ω of an attitude whose body turns with ω, in body axes.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub fn rate(&self, omega: &Vector3<T>) -> Self {
        // Written out: the product with a scalar part of 0 would be multiplied all the same.
        let ([w, x, y, z], half) = (self.components(), T::of(0.5));
        let [a, b, c] = [omega.x * half, omega.y * half, omega.z * half];
        Self::new([
            -(x * a + y * b + z * c),
            w * a + y * c - z * b,
            w * b - x * c + z * a,
            w * c + x * b - y * a,
        ])
    }
}

impl Quaternion<f64> {
    /// The rotation by the vector `theta` (axis times angle in radians), exp(θ/2).
    ///
    /// ```
    /// use nalgebra::Vector3;
    /// use polhode::motion::Quaternion;
    /// let quarter = Quaternion::exp(&Vector3::new(0.0, 0.0, std::f64::consts::FRAC_PI_2));
    /// assert!((quarter.to_space(&Vector3::x()) - Vector3::y()).norm() < 1e-15);
    /// ```
    pub fn exp(theta: &Vector3<f64>) -> Self {
        let angle = theta.norm();
        // Below this sin(x)/x is 1 to the last bit, and 0/0 is kept away.
        let over = if angle < 1e-8 {
            0.5
        } else {
            (0.5 * angle).sin() / angle
        };
        Self {
            w: (0.5 * angle).cos(),
            v: theta * over,
        }
    }

    /// The unit quaternion of a rotation matrix, by its largest component (Shepperd 1978).
    pub fn of_matrix(r: &Matrix3<f64>) -> Self {
        let squares = [
            1.0 + r[(0, 0)] + r[(1, 1)] + r[(2, 2)],
            1.0 + r[(0, 0)] - r[(1, 1)] - r[(2, 2)],
            1.0 - r[(0, 0)] + r[(1, 1)] - r[(2, 2)],
            1.0 - r[(0, 0)] - r[(1, 1)] + r[(2, 2)],
        ];
        let [x, y, z] = [
            r[(2, 1)] - r[(1, 2)],
            r[(0, 2)] - r[(2, 0)],
            r[(1, 0)] - r[(0, 1)],
        ];
        let [xy, xz, yz] = [
            r[(0, 1)] + r[(1, 0)],
            r[(0, 2)] + r[(2, 0)],
            r[(1, 2)] + r[(2, 1)],
        ];
        let largest = squares.iter().fold(squares[0], |m, s| m.max(*s));
        let row = if squares[0] >= largest {
            [squares[0], x, y, z]
        } else if squares[1] >= largest {
            [x, squares[1], xy, xz]
        } else if squares[2] >= largest {
            [y, xy, squares[2], yz]
        } else {
            [z, xz, yz, squares[3]]
        };
        Self::new(row).normalised()
    }

    /// The rotation vector θ with |θ| ≤ π whose exponential is this unit quaternion or its negative.
    pub fn log(&self) -> Vector3<f64> {
        let sine = self.v.norm();
        let sign = if self.w < 0.0 { -1.0 } else { 1.0 };
        if sine < 1e-9 {
            return self.v * (2.0 * sign);
        }
        self.v * (sign * 2.0 * sine.atan2(self.w.abs()) / sine)
    }
}

impl<T: Number> Mul for Quaternion<T> {
    type Output = Self;
    /// The product: first `other`, then `self`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul(self, other: Self) -> Self {
        let (p, q): (Vector4<T>, Vector4<T>) =
            (self.components().into(), other.components().into());
        Self::new(quaternion_product(&p, &q).into())
    }
}

impl<T: Number> Mul<T> for Quaternion<T> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn mul(self, factor: T) -> Self {
        Self {
            w: self.w * factor,
            v: self.v * factor,
        }
    }
}

impl<T: Number> Add for Quaternion<T> {
    type Output = Self;
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn add(self, other: Self) -> Self {
        Self {
            w: self.w + other.w,
            v: self.v + other.v,
        }
    }
}
