//! From the full tensor to Euler's equations, decided on polynomials: equal as polynomials is equal for every body and motion.

use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;
use polhode::algebra::Polynomial;
use polhode::mechanics::{
    Products, euler_principal, inertia, inertia_in_axes, inertia_rate, moment, moment_in_axes,
    rotation,
};
use polhode::scalar::Ring;

fn unknowns<const N: usize>(first: u32) -> [Polynomial; N] {
    std::array::from_fn(|i| Polynomial::variable(first + i as u32))
}

fn vector(first: u32) -> Vector3<Polynomial> {
    Vector3::from(unknowns(first))
}

#[test]
fn with_the_products_zero_the_general_equation_is_eulers() {
    let moments = unknowns(0);
    let (omega, alpha) = (vector(3), vector(6));
    for convention in [Products::Integrals, Products::Entries] {
        let none = std::array::from_fn(|_| Polynomial::zero());
        let body = inertia(moments.clone(), none, convention);
        assert_eq!(
            moment(&body, &omega, &alpha),
            euler_principal(&Vector3::from(moments.clone()), &omega, &alpha)
        );
    }
}

/// What falls away, and only that: each product of inertia leaves its own terms.
#[test]
fn each_product_of_inertia_adds_its_own_terms() {
    let (moments, products) = (unknowns(0), unknowns::<3>(9));
    let (omega, alpha) = (vector(3), vector(6));
    let [x, y, z] = [0, 1, 2].map(|i| omega[i].clone());
    let general = moment(
        &inertia(moments.clone(), products, Products::Integrals),
        &omega,
        &alpha,
    );
    let left = general - euler_principal(&Vector3::from(moments), &omega, &alpha);
    let of_xz = left.map(|term| term.coefficient_of(10, 1));
    let expected = Vector3::new(
        -alpha[2].clone() - x.clone() * y.clone(),
        x.clone() * x.clone() - z.clone() * z.clone(),
        -alpha[0].clone() + y * z,
    );
    assert_eq!(of_xz, expected);
    // Nothing is left once all three products are zero.
    let zero = Polynomial::zero();
    let vanished = left.map(|t| (9..12).fold(t, |t, v| t.substitute(v, &zero)));
    assert_eq!(vanished, Vector3::zeros());
}

/// Equal moments: the axes need not be attached to the body, as any that turn with Ω leave a sphere's tensor alone.
#[test]
fn a_sphere_has_the_same_equation_in_all_axes() {
    let moment_of_all = Polynomial::variable(0);
    let sphere = Matrix3::identity().map(|e: Polynomial| e * moment_of_all.clone());
    let (omega, turn, seen) = (vector(1), vector(4), vector(7));
    let rate = inertia_rate(&sphere, &omega, &turn);
    assert_eq!(rate, Matrix3::zeros());
    let alpha = seen.clone() + turn.cross(&omega);
    assert_eq!(
        moment_in_axes(&sphere, &rate, &omega, &seen, &turn),
        moment(&sphere, &omega, &alpha)
    );
}

/// A symmetric body seen from axes that follow its axis but not its spin: the tensor is constant there too.
#[test]
fn axes_that_follow_the_axis_of_a_symmetric_body_need_no_inertia_rate() {
    let [a, c, spin] = unknowns(0);
    let body = inertia(
        [a.clone(), a, c],
        std::array::from_fn(|_| Polynomial::zero()),
        Products::Integrals,
    );
    let turn = vector(3);
    let omega = &turn + Vector3::new(Polynomial::zero(), Polynomial::zero(), spin);
    assert_eq!(inertia_rate(&body, &omega, &turn), Matrix3::zeros());
}

/// Objectivity: with R from any quaternion, |q|⁶ R M(I, ω, α) = M(R I Rᵀ, R ω, R α) in homogeneous form.
#[test]
fn the_moment_of_the_turned_body_is_the_turned_moment() {
    // Integer quaternions and unknown bodies: the homogeneous rotation is |q|² times a rotation.
    for q in [[1, 2, -3, 1], [0, 1, 1, 0], [5, -2, 0, 4]] {
        let square: i32 = q.iter().map(|c| c * c).sum();
        let turn = rotation(&nalgebra::Vector4::from(q)).map(Polynomial::int);
        let apply = |v: &Vector3<Polynomial>| polhode::mechanics::apply(&turn, v);
        let body = inertia(unknowns(0), unknowns(3), Products::Integrals);
        let (omega, alpha) = (vector(6), vector(9));
        let turned = inertia_in_axes(&turn, &body);
        let scale = |v: Vector3<Polynomial>, by: i32| v.map(|c| c * Polynomial::int(by));
        // The gyroscopic part has one more factor |q|² than the part with α.
        let none = Vector3::zeros();
        let inertial = moment(&turned, &none, &apply(&alpha));
        let expected = moment(&body, &none, &alpha);
        assert_eq!(inertial, scale(apply(&expected), square * square));
        let gyroscopic = moment(&turned, &apply(&omega), &none);
        let expected = moment(&body, &omega, &none);
        assert_eq!(gyroscopic, scale(apply(&expected), square.pow(3)));
    }
}
