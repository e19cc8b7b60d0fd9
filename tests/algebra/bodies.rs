//! The inertia of bodies: what is possible, its principal axes, its parameters, and how it is identified.

use nalgebra::{Matrix3, SMatrix, SVector, Vector3, Vector4};
use polhode::mechanics::{
    ImpossibleInertia, InertiaParameters, PrincipalAxes, Products, determinant, inertia,
    inertia_in_axes, inertia_of_points, inertial_parameters, log_cholesky, log_cholesky_of_inertia,
    moment, parallel_axis, possible_body, possible_inertia, principal_axes, rotation,
};
use proptest::prelude::*;

#[test]
fn the_tensor_of_points_is_the_one_of_the_integrals() {
    let points = [
        (2, Vector3::new(1, -2, 3)),
        (3, Vector3::new(0, 1, 4)),
        (1, Vector3::new(-5, 2, 0)),
    ];
    let sum = |f: fn(&Vector3<i32>) -> i32| points.iter().map(|(m, r)| m * f(r)).sum::<i32>();
    let moments = [
        sum(|r| r.y * r.y + r.z * r.z),
        sum(|r| r.z * r.z + r.x * r.x),
        sum(|r| r.x * r.x + r.y * r.y),
    ];
    let products = [sum(|r| r.x * r.y), sum(|r| r.x * r.z), sum(|r| r.y * r.z)];
    assert_eq!(
        inertia_of_points(&points),
        inertia(moments, products, Products::Integrals)
    );
}

#[test]
fn shifted_points_have_the_shifted_tensor() {
    // The mass centre of these is the origin.
    let points = [
        (1, Vector3::new(2, -4, 6)),
        (2, Vector3::new(-3, 1, 0)),
        (1, Vector3::new(4, 2, -6)),
    ];
    let shift = Vector3::new(5, -1, 7);
    let shifted = points.map(|(m, r)| (m, r + shift));
    let about_centre = inertia_of_points(&points);
    let about_origin = inertia_of_points(&shifted);
    assert_eq!(parallel_axis(&about_centre, &4, &shift), about_origin);
    assert_eq!(parallel_axis(&about_origin, &-4, &shift), about_centre);
}

fn diagonal(x: f64, y: f64, z: f64) -> Matrix3<f64> {
    Matrix3::from_diagonal(&Vector3::new(x, y, z))
}

#[test]
fn a_plate_is_possible_in_all_axes_and_scales() {
    for q in [
        Vector4::new(1.0, 2.0, -3.0, 0.5),
        Vector4::new(0.1, 0.0, 7.0, -2.0),
    ] {
        let turn = rotation(&q) / q.norm_squared();
        for scale in [1e-150, 1.0, 1e150] {
            let plate = inertia_in_axes(&turn, &(diagonal(1.0, 2.0, 3.0) * scale));
            assert_eq!(possible_body(&plate), Ok(()));
            let more = inertia_in_axes(&turn, &(diagonal(1.0, 2.0, 3.0001) * scale));
            assert!(matches!(
                possible_body(&more),
                Err(ImpossibleInertia::Triangle { .. })
            ));
        }
    }
}

#[test]
fn a_thin_needle_is_possible_and_a_line_is_not() {
    assert_eq!(possible_body(&diagonal(1.0, 1.0, 1e-12)), Ok(()));
    let turn = rotation(&Vector4::new(0.5, 0.5, 0.5, 0.5));
    let line = inertia_in_axes(&turn, &diagonal(1.0, 1.0, 0.0));
    assert_eq!(possible_body(&line), Err(ImpossibleInertia::Zero));
    assert_eq!(
        possible_body(&Matrix3::zeros()),
        Err(ImpossibleInertia::Zero)
    );
}

#[test]
fn what_is_no_tensor_of_a_body_is_told_why() {
    let mut lopsided = diagonal(1.0, 1.0, 1.0);
    lopsided[(1, 2)] = 0.1;
    let error = possible_body(&lopsided).expect_err("yz and zy differ");
    assert!(
        (error.to_string()).contains("entries yz = 0.1 and zy = 0 differ"),
        "{error}"
    );
    let large_product = inertia([1.0, 1.0, 1.0], [2.0, 0.0, 0.0], Products::Integrals);
    assert!(matches!(
        possible_body(&large_product),
        Err(ImpossibleInertia::Negative { .. })
    ));
    let not_a_number = diagonal(1.0, f64::NAN, 1.0);
    let error = possible_body(&not_a_number).expect_err("yy is not a number");
    assert_eq!(
        error.to_string(),
        "the entry yy of the inertia tensor is NaN, and has to be finite"
    );
}

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

const ALL: [InertiaParameters; 4] = [
    InertiaParameters::Lecture,
    InertiaParameters::Urdf,
    InertiaParameters::MuJoCo,
    InertiaParameters::Pinocchio,
];

#[test]
fn the_regressor_times_the_parameters_is_the_moment() {
    let (omega, alpha) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
    let parameters = [11, 13, 17, 2, 3, 5];
    for order in ALL {
        let tensor = order.tensor(parameters);
        assert_eq!(order.of_tensor(&tensor), parameters);
        let y = order.regressor(&omega, &alpha);
        assert_eq!(
            y * SVector::from(parameters),
            moment(&tensor, &omega, &alpha)
        );
    }
}

/// Each order names its own entries: what one says of a tensor the other reads.
#[test]
fn the_orders_are_those_of_the_formats() {
    let tensor = Matrix3::new(1, 4, 5, 4, 2, 6, 5, 6, 3);
    let of = |order: InertiaParameters| order.of_tensor(&tensor);
    assert_eq!(of(InertiaParameters::Lecture), [1, 2, 3, -4, -5, -6]);
    assert_eq!(of(InertiaParameters::Urdf), [1, 4, 5, 2, 6, 3]);
    assert_eq!(of(InertiaParameters::MuJoCo), [1, 2, 3, 4, 5, 6]);
    assert_eq!(of(InertiaParameters::Pinocchio), [1, 4, 2, 5, 6, 3]);
}

/// A quadratic in ω and α differs from its tangent by its value at the change, less the linear part there.
#[test]
fn the_derivatives_are_those_of_the_regressor() {
    let (omega, alpha) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
    for order in ALL {
        let slopes = order.regressor_derivatives(&omega, &alpha);
        for (k, slope) in slopes.iter().enumerate() {
            let mut ahead = (omega, alpha);
            let mut behind = ahead;
            let (place, to, from) = match k {
                0..3 => (k, &mut ahead.0, &mut behind.0),
                _ => (k - 3, &mut ahead.1, &mut behind.1),
            };
            to[place] += 1;
            from[place] -= 1;
            let change =
                order.regressor(&ahead.0, &ahead.1) - order.regressor(&behind.0, &behind.1);
            assert_eq!(change, slope * 2, "{order:?} {k}");
        }
    }
}

fn ten() -> impl Strategy<Value = SVector<f64, 10>> {
    prop::array::uniform10(-1.5_f64..1.5).prop_map(SVector::from)
}

/// The central difference of a column, and the width's fourth power off.
fn difference<const M: usize, const N: usize>(
    f: impl Fn(&SVector<f64, N>) -> SVector<f64, M>,
    at: &SVector<f64, N>,
    column: usize,
) -> SVector<f64, M> {
    let side = |h: f64| {
        let mut moved = *at;
        moved[column] += h;
        f(&moved)
    };
    let quotient = |h: f64| (side(h) - side(-h)) / (2.0 * h);
    (quotient(1e-3) * 4.0 - quotient(2e-3)) / 3.0
}

proptest! {
    #[test]
    fn every_vector_is_a_body_and_the_derivative_is_that_of_the_value(parameters in ten()) {
        let (body, jacobian) = inertial_parameters(&parameters);
        prop_assert!(body[0] > 0.0);
        let entries = std::array::from_fn(|i| body[4 + i]);
        prop_assert_eq!(possible_body(&InertiaParameters::MuJoCo.tensor(entries)), Ok(()));
        for column in 0..10 {
            let found = difference(|p| inertial_parameters(p).0, &parameters, column);
            let scale = 1.0 + body.amax();
            prop_assert!((found - jacobian.column(column)).amax() < 1e-8 * scale);
        }
    }

    #[test]
    fn both_ways_undo_each_other(parameters in ten()) {
        let (body, forth) = inertial_parameters(&parameters);
        let (back, inverse) = log_cholesky(&body).expect("a body");
        // Rounding times what the smallest diagonal entry costs, e^±2d twice over.
        prop_assert!((back - parameters).amax() < 1e-11);
        prop_assert!((inverse * forth - SMatrix::<f64, 10, 10>::identity()).amax() < 1e-9);
    }

    #[test]
    fn six_of_a_tensor(parameters in prop::array::uniform6(-1.5_f64..1.5)) {
        let parameters = SVector::from(parameters);
        let (tensor, forth) = possible_inertia(&parameters);
        prop_assert_eq!(possible_body(&tensor), Ok(()));
        let entries = |p: &SVector<f64, 6>| {
            SVector::<f64, 6>::from(InertiaParameters::MuJoCo.of_tensor(&possible_inertia(p).0))
        };
        for column in 0..6 {
            let found = difference(entries, &parameters, column);
            prop_assert!((found - forth.column(column)).amax() < 1e-8 * (1.0 + tensor.amax()));
        }
        let (back, inverse) = log_cholesky_of_inertia(&tensor).expect("a body");
        prop_assert!((back - parameters).amax() < 1e-11);
        prop_assert!((inverse * forth - SMatrix::<f64, 6, 6>::identity()).amax() < 1e-9);
    }
}

#[test]
fn no_body_has_no_parameters() {
    let plate = Matrix3::from_diagonal(&Vector3::new(1.0, 2.0, 3.0));
    assert_eq!(log_cholesky_of_inertia(&plate), None);
    assert_eq!(log_cholesky_of_inertia(&(plate * f64::NAN)), None);
    let massless = SVector::from([0.0, 0.0, 0.0, 0.0, 1.0, 1.0, 1.0, 0.0, 0.0, 0.0]);
    assert_eq!(log_cholesky(&massless), None);
}
