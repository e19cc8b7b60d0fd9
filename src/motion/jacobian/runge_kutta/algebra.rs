//! Vectors, tensors and quaternions of plain numbers or of whole registers.
//!
//! In loops, and everything inlined: a closure handed to `map` is compiled apart, for the least of machines.

use crate::motion::block::Lane;
use crate::motion::registers::{Arithmetic, Registers};
use nalgebra::Matrix3;

pub(super) type Vector<T> = [T; 3];

/// Scalar first.
pub(super) type Turn<T> = [T; 4];

#[inline(always)]
pub(super) fn plus<T: Arithmetic, const N: usize>(mut a: [T; N], b: [T; N]) -> [T; N] {
    for i in 0..N {
        a[i] = a[i] + b[i];
    }
    a
}

#[inline(always)]
pub(super) fn times<T: Arithmetic, const N: usize>(mut a: [T; N], factor: T) -> [T; N] {
    for component in &mut a {
        *component = *component * factor;
    }
    a
}

#[inline(always)]
pub(super) fn dot<T: Arithmetic, const N: usize>(a: [T; N], b: [T; N]) -> T {
    let mut sum = a[0] * b[0];
    for i in 1..N {
        sum = sum + a[i] * b[i];
    }
    sum
}

#[inline(always)]
pub(super) fn cross<T: Arithmetic>([a, b, c]: Vector<T>, [x, y, z]: Vector<T>) -> Vector<T> {
    [b * z - c * y, c * x - a * z, a * y - b * x]
}

/// A matrix times a vector.
#[inline(always)]
pub(super) fn applied<T: Arithmetic>([a, b, c]: [Vector<T>; 3], v: Vector<T>) -> Vector<T> {
    [dot(a, v), dot(b, v), dot(c, v)]
}

/// A covector times a matrix.
#[inline(always)]
pub(super) fn pulled<T: Arithmetic>([a, b, c]: [Vector<T>; 3], [x, y, z]: Vector<T>) -> Vector<T> {
    plus(plus(times(a, x), times(b, y)), times(c, z))
}

/// Each number in all lanes.
#[inline(always)]
pub(super) fn splat<R: Registers, const N: usize>(registers: R, values: [f64; N]) -> [R::Wide; N] {
    let mut wide = [registers.splat(0.0); N];
    for i in 0..N {
        wide[i] = registers.splat(values[i]);
    }
    wide
}

/// The same of a matrix.
#[inline(always)]
pub(super) fn splat_rows<R: Registers>(
    registers: R,
    [a, b, c]: [Vector<f64>; 3],
) -> [Vector<R::Wide>; 3] {
    [
        splat(registers, a),
        splat(registers, b),
        splat(registers, c),
    ]
}

/// Numbers of each lane from `first` on.
#[inline(always)]
pub(super) fn loaded<R: Registers, const N: usize>(
    registers: R,
    lanes: &[Lane; N],
    first: usize,
) -> [R::Wide; N] {
    let mut wide = [registers.splat(0.0); N];
    for i in 0..N {
        wide[i] = registers.load(&lanes[i][first..]);
    }
    wide
}

/// The product of a turn and a pure quaternion.
#[inline(always)]
pub(super) fn turned<T: Arithmetic>([w, a, b, c]: Turn<T>, [x, y, z]: Vector<T>) -> Turn<T> {
    [
        w.constant(0.0) - (a * x + b * y + c * z),
        w * x + b * z - c * y,
        w * y + c * x - a * z,
        w * z + a * y - b * x,
    ]
}

/// The vector part of p⁻¹ q for a unit p, and |p|² times that for any other.
#[inline(always)]
pub(super) fn between<T: Arithmetic>([w, a, b, c]: Turn<T>, [s, x, y, z]: Turn<T>) -> Vector<T> {
    [
        w * x - a * s - (b * z - c * y),
        w * y - b * s - (c * x - a * z),
        w * z - c * s - (a * y - b * x),
    ]
}

/// The rows of the matrix that a turn is, |q|² times a rotation.
#[inline(always)]
pub(super) fn matrix<T: Arithmetic>([w, x, y, z]: Turn<T>) -> [Vector<T>; 3] {
    let twice = w.constant(2.0);
    let [ww, xx, yy, zz] = [w * w, x * x, y * y, z * z];
    let [xy, xz, yz] = times([x * y, x * z, y * z], twice);
    let [wx, wy, wz] = times([w * x, w * y, w * z], twice);
    [
        [ww + xx - yy - zz, xy - wz, xz + wy],
        [xy + wz, ww - xx + yy - zz, yz - wx],
        [xz - wy, yz + wx, ww - xx - yy + zz],
    ]
}

/// An inertia tensor with its inverse.
pub(super) trait Tensor<T>: Copy {
    /// −ω × I ω.
    fn gyroscopic(&self, omega: Vector<T>) -> Vector<T>;

    /// The derivative of −ω × I ω: row by component of it, column by component of ω.
    fn slope(&self, omega: Vector<T>) -> [Vector<T>; 3];

    /// I⁻¹ v.
    fn inverse(&self, v: Vector<T>) -> Vector<T>;
}

/// A tensor of any axes: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy)]
pub(super) struct Full<T> {
    pub(super) entries: [T; 6],
    pub(super) inverse: [T; 6],
}

/// A tensor along its principal axes.
#[derive(Clone, Copy)]
pub(super) struct Principal<T> {
    /// I_y − I_z and cyclic: formed once, for the products would lose what the moments have in common.
    pub(super) differences: Vector<T>,
    pub(super) inverse: Vector<T>,
}

/// The six entries of a symmetric matrix.
#[inline(always)]
pub(super) fn entries(m: &Matrix3<f64>) -> [f64; 6] {
    [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)].map(|entry| m[entry])
}

#[inline(always)]
fn symmetric<T: Arithmetic>([xx, yy, zz, xy, xz, yz]: [T; 6], [x, y, z]: Vector<T>) -> Vector<T> {
    [
        xx * x + xy * y + xz * z,
        xy * x + yy * y + yz * z,
        xz * x + yz * y + zz * z,
    ]
}

impl<T: Arithmetic> Tensor<T> for Full<T> {
    #[inline(always)]
    fn gyroscopic(&self, omega: Vector<T>) -> Vector<T> {
        cross(symmetric(self.entries, omega), omega)
    }

    #[inline(always)]
    fn slope(&self, omega: Vector<T>) -> [Vector<T>; 3] {
        // [I ω]× − [ω]× I.
        let [l, m, n] = symmetric(self.entries, omega);
        let ([x, y, z], [xx, yy, zz, xy, xz, yz]) = (omega, self.entries);
        [
            [z * xy - y * xz, z * yy - y * yz - n, z * yz - y * zz + m],
            [x * xz - z * xx + n, x * yz - z * xy, x * zz - z * xz - l],
            [y * xx - x * xy - m, y * xy - x * yy + l, y * xz - x * yz],
        ]
    }

    #[inline(always)]
    fn inverse(&self, v: Vector<T>) -> Vector<T> {
        symmetric(self.inverse, v)
    }
}

impl<T: Arithmetic> Tensor<T> for Principal<T> {
    #[inline(always)]
    fn gyroscopic(&self, [x, y, z]: Vector<T>) -> Vector<T> {
        let [a, b, c] = self.differences;
        [a * (y * z), b * (z * x), c * (x * y)]
    }

    #[inline(always)]
    fn slope(&self, [x, y, z]: Vector<T>) -> [Vector<T>; 3] {
        let ([a, b, c], zero) = (self.differences, x.constant(0.0));
        [
            [zero, a * z, a * y],
            [b * z, zero, b * x],
            [c * y, c * x, zero],
        ]
    }

    #[inline(always)]
    fn inverse(&self, [x, y, z]: Vector<T>) -> Vector<T> {
        let [a, b, c] = self.inverse;
        [a * x, b * y, c * z]
    }
}
