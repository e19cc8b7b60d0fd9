//! Vectors, tensors and quaternions of plain numbers or of whole registers.
//!
//! In loops, and everything inlined: a closure handed to `map` is compiled apart, for the least of machines.

use crate::motion::block::Lane;
use crate::motion::registers::{Arithmetic, Registers};

pub(in crate::motion::jacobian) type Vector<T> = [T; 3];

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
pub(super) fn minus<T: Arithmetic, const N: usize>(mut a: [T; N], b: [T; N]) -> [T; N] {
    for i in 0..N {
        a[i] = a[i] - b[i];
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

/// a + b · factor.
#[inline(always)]
pub(super) fn plus_times<T: Arithmetic, const N: usize>(
    mut a: [T; N],
    b: [T; N],
    factor: T,
) -> [T; N] {
    for i in 0..N {
        a[i] = a[i].plus_product(b[i], factor);
    }
    a
}

#[inline(always)]
pub(super) fn dot<T: Arithmetic, const N: usize>(a: [T; N], b: [T; N]) -> T {
    let mut sum = a[0] * b[0];
    for i in 1..N {
        sum = sum.plus_product(a[i], b[i]);
    }
    sum
}

#[inline(always)]
pub(super) fn cross<T: Arithmetic>([a, b, c]: Vector<T>, [x, y, z]: Vector<T>) -> Vector<T> {
    [
        (b * z).less_product(c, y),
        (c * x).less_product(a, z),
        (a * y).less_product(b, x),
    ]
}

/// A vector plus a product of two.
#[inline(always)]
pub(in crate::motion::jacobian) fn plus_cross<T: Arithmetic>(
    [p, q, r]: Vector<T>,
    [a, b, c]: Vector<T>,
    [x, y, z]: Vector<T>,
) -> Vector<T> {
    [
        p.plus_product(b, z).less_product(c, y),
        q.plus_product(c, x).less_product(a, z),
        r.plus_product(a, y).less_product(b, x),
    ]
}

/// A matrix times a vector.
#[inline(always)]
pub(super) fn applied<T: Arithmetic>([a, b, c]: [Vector<T>; 3], v: Vector<T>) -> Vector<T> {
    [dot(a, v), dot(b, v), dot(c, v)]
}

/// A covector times a matrix.
#[inline(always)]
pub(super) fn pulled<T: Arithmetic>([a, b, c]: [Vector<T>; 3], [x, y, z]: Vector<T>) -> Vector<T> {
    plus_times(plus_times(times(a, x), b, y), c, z)
}

/// Each number in all lanes.
#[inline(always)]
pub(in crate::motion::jacobian) fn splat<R: Registers, const N: usize>(
    registers: R,
    values: [f64; N],
) -> [R::Wide; N] {
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
pub(in crate::motion::jacobian) fn loaded<R: Registers, const N: usize>(
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
    let zero = w.constant(0.0);
    [
        zero.less_product(a, x)
            .less_product(b, y)
            .less_product(c, z),
        (w * x).plus_product(b, z).less_product(c, y),
        (w * y).plus_product(c, x).less_product(a, z),
        (w * z).plus_product(a, y).less_product(b, x),
    ]
}

/// The vector part of p⁻¹ q for a unit p, and |p|² times that for any other.
#[inline(always)]
pub(super) fn between<T: Arithmetic>([w, a, b, c]: Turn<T>, [s, x, y, z]: Turn<T>) -> Vector<T> {
    let gained = [
        (w * x).less_product(a, s),
        (w * y).less_product(b, s),
        (w * z).less_product(c, s),
    ];
    plus_cross(gained, [x, y, z], [a, b, c])
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
    /// What its derivatives need of the gyroscopic moment again.
    type Kept: Copy;

    /// A moment and −ω × I ω.
    fn net(&self, moment: Vector<T>, omega: Vector<T>) -> (Vector<T>, Self::Kept);

    /// The change of −ω × I ω with a change of ω and of the tensor, the latter given times ω.
    fn along(
        &self,
        omega: Vector<T>,
        kept: Self::Kept,
        by_omega: Vector<T>,
        by_inertia: Vector<T>,
    ) -> Vector<T>;

    /// `onto` and a covector of −ω × I ω times its derivative in ω; `across` is the covector × ω.
    fn back(
        &self,
        onto: Vector<T>,
        omega: Vector<T>,
        kept: Self::Kept,
        covector: Vector<T>,
        across: Vector<T>,
    ) -> Vector<T>;

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

/// A symmetric matrix times a vector.
#[inline(always)]
pub(in crate::motion::jacobian) fn symmetric<T: Arithmetic>(
    [xx, yy, zz, xy, xz, yz]: [T; 6],
    v: Vector<T>,
) -> Vector<T> {
    [
        dot([xx, xy, xz], v),
        dot([xy, yy, yz], v),
        dot([xz, yz, zz], v),
    ]
}

impl<T: Arithmetic> Tensor<T> for Full<T> {
    /// The angular momentum.
    type Kept = Vector<T>;

    #[inline(always)]
    fn net(&self, moment: Vector<T>, omega: Vector<T>) -> (Vector<T>, Vector<T>) {
        let momentum = symmetric(self.entries, omega);
        (plus_cross(moment, momentum, omega), momentum)
    }

    #[inline(always)]
    fn along(
        &self,
        omega: Vector<T>,
        momentum: Vector<T>,
        by_omega: Vector<T>,
        by_inertia: Vector<T>,
    ) -> Vector<T> {
        let gained = plus(symmetric(self.entries, by_omega), by_inertia);
        plus_cross(cross(momentum, by_omega), gained, omega)
    }

    #[inline(always)]
    fn back(
        &self,
        onto: Vector<T>,
        _: Vector<T>,
        momentum: Vector<T>,
        covector: Vector<T>,
        [x, y, z]: Vector<T>,
    ) -> Vector<T> {
        let [a, b, c] = plus_cross(onto, covector, momentum);
        let [xx, yy, zz, xy, xz, yz] = self.entries;
        [
            a.less_product(xx, x)
                .less_product(xy, y)
                .less_product(xz, z),
            b.less_product(xy, x)
                .less_product(yy, y)
                .less_product(yz, z),
            c.less_product(xz, x)
                .less_product(yz, y)
                .less_product(zz, z),
        ]
    }

    #[inline(always)]
    fn inverse(&self, v: Vector<T>) -> Vector<T> {
        symmetric(self.inverse, v)
    }
}

impl<T: Arithmetic> Tensor<T> for Principal<T> {
    type Kept = ();

    #[inline(always)]
    fn net(&self, [l, m, n]: Vector<T>, [x, y, z]: Vector<T>) -> (Vector<T>, ()) {
        let [a, b, c] = self.differences;
        let net = [
            l.plus_product(a, y * z),
            m.plus_product(b, z * x),
            n.plus_product(c, x * y),
        ];
        (net, ())
    }

    #[inline(always)]
    fn along(
        &self,
        [x, y, z]: Vector<T>,
        (): (),
        [p, q, r]: Vector<T>,
        by_inertia: Vector<T>,
    ) -> Vector<T> {
        let [a, b, c] = self.differences;
        let [l, m, n] = cross(by_inertia, [x, y, z]);
        [
            l.plus_product(a, (y * r).plus_product(z, q)),
            m.plus_product(b, (z * p).plus_product(x, r)),
            n.plus_product(c, (x * q).plus_product(y, p)),
        ]
    }

    #[inline(always)]
    fn back(
        &self,
        [l, m, n]: Vector<T>,
        [x, y, z]: Vector<T>,
        (): (),
        [p, q, r]: Vector<T>,
        _: Vector<T>,
    ) -> Vector<T> {
        let [a, b, c] = self.differences;
        let [p, q, r] = [a * p, b * q, c * r];
        [
            l.plus_product(q, z).plus_product(r, y),
            m.plus_product(p, z).plus_product(r, x),
            n.plus_product(p, y).plus_product(q, x),
        ]
    }

    #[inline(always)]
    fn inverse(&self, [x, y, z]: Vector<T>) -> Vector<T> {
        let [a, b, c] = self.inverse;
        [a * x, b * y, c * z]
    }
}
