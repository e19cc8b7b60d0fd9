//! Vectors, tensors and quaternions of plain numbers or of whole registers.
//!
//! In loops, and everything inlined: a closure handed to `map` is compiled apart, for the least of machines.

use crate::motion::block::Lane;
use crate::motion::registers::{Arithmetic, Registers};

pub(in crate::motion::jacobian) type Vector<T> = [T; 3];

/// Scalar first.
pub(super) type Turn<T> = [T; 4];

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn plus<T: Arithmetic, const N: usize>(mut a: [T; N], b: [T; N]) -> [T; N] {
    for i in 0..N {
        a[i] = a[i] + b[i];
    }
    a
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn minus<T: Arithmetic, const N: usize>(mut a: [T; N], b: [T; N]) -> [T; N] {
    for i in 0..N {
        a[i] = a[i] - b[i];
    }
    a
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn times<T: Arithmetic, const N: usize>(mut a: [T; N], factor: T) -> [T; N] {
    for component in &mut a {
        *component = *component * factor;
    }
    a
}

/// a + b · factor.
#[cfg_attr(not(debug_assertions), inline(always))]
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

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn dot<T: Arithmetic, const N: usize>(a: [T; N], b: [T; N]) -> T {
    let mut sum = a[0] * b[0];
    for i in 1..N {
        sum = sum.plus_product(a[i], b[i]);
    }
    sum
}

#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn cross<T: Arithmetic>([a, b, c]: Vector<T>, [x, y, z]: Vector<T>) -> Vector<T> {
    [
        (b * z).less_product(c, y),
        (c * x).less_product(a, z),
        (a * y).less_product(b, x),
    ]
}

/// A vector plus a product of two.
#[cfg_attr(not(debug_assertions), inline(always))]
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
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn applied<T: Arithmetic>([a, b, c]: [Vector<T>; 3], v: Vector<T>) -> Vector<T> {
    [dot(a, v), dot(b, v), dot(c, v)]
}

/// A covector times a matrix.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn pulled<T: Arithmetic>([a, b, c]: [Vector<T>; 3], [x, y, z]: Vector<T>) -> Vector<T> {
    plus_times(plus_times(times(a, x), b, y), c, z)
}

/// Each number in all lanes.
#[cfg_attr(not(debug_assertions), inline(always))]
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
#[cfg_attr(not(debug_assertions), inline(always))]
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
#[cfg_attr(not(debug_assertions), inline(always))]
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

/// The matrix of a turn, whose rows are the axes that it starts from: v ↦ q v q⁻¹ for a unit q, and |q|² times that for any
/// other.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn axes<T: Arithmetic>([w, a, b, c]: Turn<T>) -> [Vector<T>; 3] {
    let two = w.constant(2.0);
    let [p, q, r] = [w * two, a * two, b * two];
    let square = (w * w).less_product(c, c);
    let difference = (a * a).less_product(b, b);
    let last = (w * w).plus_product(c, c);
    [
        [
            square + difference,
            (q * b).less_product(p, c),
            (q * c).plus_product(p, b),
        ],
        [
            (q * b).plus_product(p, c),
            square - difference,
            (r * c).less_product(p, a),
        ],
        [
            (q * c).less_product(p, b),
            (r * c).plus_product(p, a),
            last.less_product(a, a).less_product(b, b),
        ],
    ]
}

/// The product of a turn and a pure quaternion.
#[cfg_attr(not(debug_assertions), inline(always))]
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

/// The product of a pure quaternion and a turn.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn turning<T: Arithmetic>([x, y, z]: Vector<T>, [w, a, b, c]: Turn<T>) -> Turn<T> {
    let zero = w.constant(0.0);
    [
        zero.less_product(x, a)
            .less_product(y, b)
            .less_product(z, c),
        (w * x).plus_product(y, c).less_product(z, b),
        (w * y).plus_product(z, a).less_product(x, c),
        (w * z).plus_product(x, b).less_product(y, a),
    ]
}

/// The vector part of p⁻¹ q for a unit p, and |p|² times that for any other.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn between<T: Arithmetic>([w, a, b, c]: Turn<T>, [s, x, y, z]: Turn<T>) -> Vector<T> {
    let gained = [
        (w * x).less_product(a, s),
        (w * y).less_product(b, s),
        (w * z).less_product(c, s),
    ];
    plus_cross(gained, [x, y, z], [a, b, c])
}

/// The vector part of q p⁻¹ for a unit p, and |p|² times that for any other.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn before<T: Arithmetic>([w, a, b, c]: Turn<T>, [s, x, y, z]: Turn<T>) -> Vector<T> {
    let gained = [
        (w * x).less_product(a, s),
        (w * y).less_product(b, s),
        (w * z).less_product(c, s),
    ];
    plus_cross(gained, [a, b, c], [x, y, z])
}

/// A turn less the product of another and a pure quaternion: the way back through that product.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn turned_back<T: Arithmetic>(
    [p, q, r, s]: Turn<T>,
    [w, a, b, c]: Turn<T>,
    [x, y, z]: Vector<T>,
) -> Turn<T> {
    [
        p.plus_product(a, x).plus_product(b, y).plus_product(c, z),
        q.less_product(w, x).less_product(b, z).plus_product(c, y),
        r.less_product(w, y).less_product(c, x).plus_product(a, z),
        s.less_product(w, z).less_product(a, y).plus_product(b, x),
    ]
}
