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

#[cfg(test)]
mod tests {
    use super::*;

    /// Axes are a rotation and bring the tensor back, to rounding of its largest moment.
    fn assert_principal(inertia: &Matrix3<f64>) -> PrincipalAxes {
        let found = principal_axes(inertia);
        let PrincipalAxes { moments, axes } = found;
        let near = 8.0 * f64::EPSILON;
        assert!((axes.transpose() * axes - Matrix3::identity()).amax() < near);
        assert!((determinant(&axes) - 1.0).abs() < near);
        let back = axes * Matrix3::from_diagonal(&(moments / moments.amax())) * axes.transpose();
        assert!(
            (back - inertia / moments.amax()).amax() < near,
            "{inertia}{back}"
        );
        assert!(moments.x <= moments.y && moments.y <= moments.z);
        found
    }

    #[test]
    fn a_full_tensor_and_its_scales() {
        let body = Matrix3::new(4.0, -1.0, 0.5, -1.0, 5.0, -0.3, 0.5, -0.3, 6.0);
        for scale in [1e-150, 1e-9, 1.0, 1e9, 1e150] {
            assert_principal(&(body * scale));
        }
    }

    #[test]
    fn repeated_and_nearly_repeated_moments() {
        assert_eq!(
            principal_axes(&Matrix3::identity()).axes,
            Matrix3::identity()
        );
        for tiny in [0.0, 1e-300, 1e-17, 1e-15, 1e-9] {
            let body = Matrix3::new(1.0, tiny, -tiny, tiny, 1.0, tiny, -tiny, tiny, 1.0);
            assert_principal(&body);
        }
        let plate = Matrix3::new(2.5, -1.5, 0.0, -1.5, 2.5, 0.0, 0.0, 0.0, 4.0);
        let moments = assert_principal(&plate).moments;
        assert!((moments - Vector3::new(1.0, 4.0, 4.0)).amax() < 1e-15);
    }

    #[test]
    fn a_needle_keeps_its_small_moment() {
        // diag(1e-12, 1, 1) turned by a small angle about z, whose small moment survives to about 1e-16 / 1e-12.
        let (s, c) = 0.3f64.sin_cos();
        let turn = Matrix3::new(c, -s, 0.0, s, c, 0.0, 0.0, 0.0, 1.0);
        let body = turn * Matrix3::from_diagonal(&Vector3::new(1e-12, 1.0, 1.0)) * turn.transpose();
        let found = assert_principal(&body).moments;
        assert!((found.x / 1e-12 - 1.0).abs() < 1e-3);
    }

    #[test]
    fn what_is_no_number_ends() {
        let moments = principal_axes(&Matrix3::from_element(f64::NAN)).moments;
        assert!(moments.iter().any(|m| m.is_nan()));
        principal_axes(&Matrix3::from_element(f64::INFINITY));
    }
}
