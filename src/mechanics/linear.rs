//! Products of small matrices and vectors over a plain ring, where nalgebra asks for more or does more.

use crate::scalar::Ring;
use nalgebra::{Matrix3, Vector3};

/// `m v` in nine products. nalgebra's `*` multiplies by one besides, which costs an exact scalar dear.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn apply<T: Ring>(m: &Matrix3<T>, v: &Vector3<T>) -> Vector3<T> {
    Vector3::from_fn(|r, _| {
        m[(r, 0)].clone() * v[0].clone()
            + m[(r, 1)].clone() * v[1].clone()
            + m[(r, 2)].clone() * v[2].clone()
    })
}

/// `a b`, in twenty-seven products.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn product<T: Ring>(a: &Matrix3<T>, b: &Matrix3<T>) -> Matrix3<T> {
    Matrix3::from_fn(|r, c| {
        a[(r, 0)].clone() * b[(0, c)].clone()
            + a[(r, 1)].clone() * b[(1, c)].clone()
            + a[(r, 2)].clone() * b[(2, c)].clone()
    })
}

/// `a × b`, right-handed.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn cross<T: Ring>(a: &Vector3<T>, b: &Vector3<T>) -> Vector3<T> {
    let term = |i: usize, j: usize| a[i].clone() * b[j].clone() - a[j].clone() * b[i].clone();
    Vector3::new(term(1, 2), term(2, 0), term(0, 1))
}

/// The matrix `[v]×` with `[v]× a = v × a` for every `a`.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn skew<T: Ring>(v: &Vector3<T>) -> Matrix3<T> {
    let [x, y, z] = [0, 1, 2].map(|i| v[i].clone());
    let zero = T::zero;
    Matrix3::new(
        zero(),
        -z.clone(),
        y.clone(),
        z,
        zero(),
        -x.clone(),
        -y,
        x,
        zero(),
    )
}

/// The adjugate: `m adj(m) = det(m) 1`, without a division.
#[cfg_attr(not(debug_assertions), inline(always))]
pub fn adjugate<T: Ring>(m: &Matrix3<T>) -> Matrix3<T> {
    // The indices run on cyclically, so that each cofactor comes with its sign.
    Matrix3::from_fn(|r, c| {
        let (p, q) = ((r + 1) % 3, (r + 2) % 3);
        let (s, t) = ((c + 1) % 3, (c + 2) % 3);
        m[(s, p)].clone() * m[(t, q)].clone() - m[(s, q)].clone() * m[(t, p)].clone()
    })
}

/// The determinant, expanded by the first row.
#[inline]
pub fn determinant<T: Ring>(m: &Matrix3<T>) -> T {
    let minors = adjugate(m);
    m[(0, 0)].clone() * minors[(0, 0)].clone()
        + m[(0, 1)].clone() * minors[(1, 0)].clone()
        + m[(0, 2)].clone() * minors[(2, 0)].clone()
}
