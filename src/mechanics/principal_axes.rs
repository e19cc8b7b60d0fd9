//! Principal axes and moments, by Jacobi's rotations.

use crate::mechanics::determinant;
use nalgebra::{Matrix3, Vector3};

/// Principal moments and the axes that they belong to.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct PrincipalAxes {
    /// The moments in kg m², ascending.
    pub moments: Vector3<f64>,
    /// The axes as columns, in the order of the moments: a rotation matrix from principal to body components.
    pub axes: Matrix3<f64>,
}

/// Sweeps of three rotations. Convergence is quadratic and five suffice in practice; the cap is for input that is no number.
const SWEEPS: usize = 24;

/// The principal axes of a symmetric tensor: `I = P diag(I₁, I₂, I₃) Pᵀ`.
///
/// Jacobi 1846, cyclic: plane rotations until the products vanish against the moments beside them, which keeps small moments
/// to their own relative accuracy (Demmel and Veselić 1992). Where moments repeat the axes are some of the many,
/// orthonormal to rounding. Nothing is squared, so that tensors of 1e±150 work. Only the upper triangle is read. From
/// entries that are not finite come moments that are not.
pub fn principal_axes(inertia: &Matrix3<f64>) -> PrincipalAxes {
    let mut tensor = *inertia;
    let mut axes = Matrix3::identity();
    for _ in 0..SWEEPS {
        let mut rotated = false;
        for (p, q) in [(0, 1), (0, 2), (1, 2)] {
            rotated |= rotate(&mut tensor, &mut axes, p, q);
        }
        if !rotated {
            break;
        }
    }
    sorted(tensor.diagonal(), axes)
}

/// Makes the product (p, q) vanish; false where it was nothing beside its moments already.
fn rotate(tensor: &mut Matrix3<f64>, axes: &mut Matrix3<f64>, p: usize, q: usize) -> bool {
    let product = tensor[(p, q)];
    let (a, b) = (tensor[(p, p)], tensor[(q, q)]);
    let negligible = f64::EPSILON / 4.0 * a.abs().sqrt() * b.abs().sqrt();
    if product == 0.0 || product.abs() < negligible {
        return false;
    }
    // The smaller root of t² + 2θt − 1 = 0: a turn of at most 45°. An infinite θ makes no turn.
    let theta = (b / 2.0 - a / 2.0) / product;
    let tangent = theta.signum() / (theta.abs() + theta.hypot(1.0));
    let cosine = 1.0 / tangent.hypot(1.0);
    let sine = tangent * cosine;
    tensor[(p, p)] = a - tangent * product;
    tensor[(q, q)] = b + tangent * product;
    tensor[(p, q)] = 0.0;
    let r = 3 - p - q;
    let (rp, rq) = (upper(r, p), upper(r, q));
    let (x, y) = (tensor[rp], tensor[rq]);
    (tensor[rp], tensor[rq]) = (cosine * x - sine * y, sine * x + cosine * y);
    for row in 0..3 {
        let (x, y) = (axes[(row, p)], axes[(row, q)]);
        (axes[(row, p)], axes[(row, q)]) = (cosine * x - sine * y, sine * x + cosine * y);
    }
    true
}

fn upper(i: usize, j: usize) -> (usize, usize) {
    (i.min(j), i.max(j))
}

/// Moments ascending, axes right-handed.
fn sorted(moments: Vector3<f64>, axes: Matrix3<f64>) -> PrincipalAxes {
    let mut order = [0, 1, 2];
    order.sort_by(|&i, &j| moments[i].total_cmp(&moments[j]));
    let mut axes = Matrix3::from_fn(|r, c| axes[(r, order[c])]);
    if determinant(&axes) < 0.0 {
        axes.column_mut(2).neg_mut();
    }
    PrincipalAxes {
        moments: Vector3::from_fn(|i, _| moments[order[i]]),
        axes,
    }
}
