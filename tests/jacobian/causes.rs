//! Each slip of the hand, planted into a right Jacobian, is found and called by its name.

use super::steps::{at, columns, end, inertia, quaternion_step, right, rows, start, step};
use nalgebra::{DMatrix, DVector, Matrix3, SMatrix, SVector, Vector3};
use polhode::assert_jacobian;
use polhode::jacobian::{Check, Kind, Other, Report, Verdict, check};
use polhode::mechanics::InertiaParameters;
use polhode::motion::Number;

type Step = SMatrix<f64, 6, 16>;

fn named() -> Check {
    Check::default().rows(rows()).columns(columns())
}

fn report(matrix: Step) -> Report {
    named().of(step, |_| matrix, &at())
}

/// The one cause that explains everything.
fn only(report: &Report) -> Kind {
    assert_eq!(report.verdict(), Verdict::Wrong, "{report}");
    assert_eq!(report.causes().len(), 1, "{report}");
    let wrong = report
        .entries()
        .iter()
        .filter(|e| e.verdict == Verdict::Wrong)
        .count();
    assert_eq!(report.causes()[0].explains, wrong, "{report}");
    report.causes()[0].kind
}

fn changed(change: impl Fn(&mut Step)) -> Kind {
    let mut matrix = right();
    change(&mut matrix);
    only(&report(matrix))
}

#[test]
fn a_right_one_is_right() {
    assert_jacobian!(step, |_| right(), &at());
    assert_jacobian!(step, |_| right(), &at(), rows: rows(), columns: columns());
}

#[test]
fn signs_of_a_block_a_row_a_column_and_an_entry() {
    assert_eq!(
        changed(|m| m.fixed_view_mut::<3, 3>(3, 0).neg_mut()),
        Kind::Sign
    );
    assert_eq!(changed(|m| m.row_mut(4).neg_mut()), Kind::Sign);
    assert_eq!(changed(|m| m.column_mut(15).neg_mut()), Kind::Sign);
    assert_eq!(changed(|m| m[(5, 3)] *= -1.0), Kind::Sign);
    assert_eq!(changed(|m| m.neg_mut()), Kind::Sign);
}

#[test]
fn a_transposed_block_and_a_transposed_matrix() {
    let block = |m: &mut Step| {
        let turned = m.fixed_view::<3, 3>(3, 3).transpose();
        m.fixed_view_mut::<3, 3>(3, 3).copy_from(&turned);
    };
    assert_eq!(changed(block), Kind::Transposed);
    let by_omega = |x: &SVector<f64, 3>| inertia() * x.cross_matrix();
    let f = |x: &SVector<num_dual::Dual64, 3>| {
        let turn = Vector3::new(1.0, 2.0, 3.0).map(num_dual::Dual64::from_re);
        inertia().map(num_dual::Dual64::from_re) * turn.cross(x)
    };
    let matrix = by_omega(&SVector::from([1.0, 2.0, 3.0]));
    assert_jacobian!(f, |_| matrix, &at().fixed_rows::<3>(3).into_owned());
    let report = check(f, |_| matrix.transpose(), &SVector::from([3.0, 0.5, -0.9]));
    assert_eq!(only(&report), Kind::Transposed);
}

/// A skew block with the other sign is its transpose: both are said.
#[test]
fn what_cannot_be_told_apart_is_said_together() {
    let f = |x: &SVector<num_dual::Dual64, 3>| {
        Vector3::new(1.0, 2.0, 3.0)
            .map(num_dual::Dual64::from_re)
            .cross(x)
    };
    let matrix = -Vector3::new(1.0, 2.0, 3.0).cross_matrix();
    let report = check(f, |_| matrix, &SVector::from([3.0, 0.5, -0.9]));
    assert_eq!(only(&report), Kind::Sign);
    assert_eq!(report.causes()[0].or, [Kind::Transposed]);
}

#[test]
fn swapped_rows_columns_and_slots() {
    assert_eq!(changed(|m| m.swap_rows(1, 4)), Kind::SwappedRows(1, 4));
    assert_eq!(
        changed(|m| m.swap_columns(3, 11)),
        Kind::SwappedColumns(3, 11)
    );
    let slots = |m: &mut Step| (0..3).for_each(|i| m.swap_columns(3 + i, 6 + i));
    assert_eq!(changed(slots), Kind::ColumnSlots(1, 2));
    let slots = |m: &mut Step| (0..3).for_each(|i| m.swap_rows(i, 3 + i));
    assert_eq!(changed(slots), Kind::RowSlots(0, 1));
    let block = |m: &mut Step| {
        let mut block = m.fixed_view_mut::<3, 3>(3, 3);
        block.swap_rows(0, 2);
    };
    assert_eq!(changed(block), Kind::SwappedRows(3, 5));
}

#[test]
fn missing_and_superfluous_blocks() {
    assert_eq!(
        changed(|m| m.fixed_view_mut::<3, 3>(3, 0).fill(0.0)),
        Kind::Missing
    );
    assert_eq!(changed(|m| m.row_mut(2).fill(0.0)), Kind::Missing);
    let free =
        |x: &SVector<num_dual::Dual64, 2>| SVector::from([x[0] * x[0], x[1] * 3.0, x[0] + x[1]]);
    let matrix = SMatrix::<f64, 3, 2>::new(4.0, 7.0, 0.0, 3.0, 1.0, 1.0);
    assert_eq!(
        only(&check(free, |_| matrix, &SVector::from([2.0, 1.0]))),
        Kind::Extra
    );
}

#[test]
fn factors() {
    let double = |m: &mut Step| m.fixed_view_mut::<3, 3>(0, 3).scale_mut(2.0);
    assert_eq!(changed(double), Kind::Factor(2.0));
    assert_eq!(changed(|m| m.row_mut(3).scale_mut(0.5)), Kind::Factor(0.5));
    // Degrees for radians.
    let degrees = 180.0 / std::f64::consts::PI;
    let Kind::Factor(found) = changed(|m| m.fixed_rows_mut::<3>(0).scale_mut(degrees)) else {
        panic!("a factor");
    };
    assert!((found - degrees).abs() < 1e-9);
}

#[test]
fn a_lost_identity_and_a_cross_product_too_much() {
    let identity = |m: &mut Step| {
        let block = m.fixed_view::<3, 3>(3, 3) - Matrix3::identity();
        m.fixed_view_mut::<3, 3>(3, 3).copy_from(&block);
    };
    let Kind::Identity(factor) = changed(identity) else {
        panic!("an identity");
    };
    assert!((factor + 1.0).abs() < 1e-9);
    let term = Vector3::new(0.1, -0.2, 0.3);
    let cross = |m: &mut Step| {
        let block = m.fixed_view::<3, 3>(3, 3) + term.cross_matrix();
        m.fixed_view_mut::<3, 3>(3, 3).copy_from(&block);
    };
    let Kind::CrossTerm(found) = changed(cross) else {
        panic!("a cross product");
    };
    assert!((found - term).norm() < 1e-9);
}

#[test]
fn space_for_body_axes() {
    let turn = start().attitude.matrix();
    // Columns in a torque of space axes, and rows of an angular velocity in space axes.
    let columns = |m: &mut Step| {
        let other = m.fixed_columns::<3>(6) * turn.transpose();
        m.fixed_columns_mut::<3>(6).copy_from(&other);
    };
    assert_eq!(changed(columns), Kind::Written(Other::Frame));
    let turn = end().attitude.matrix();
    let rows = |m: &mut Step| {
        let other = turn * m.fixed_rows::<3>(3);
        m.fixed_rows_mut::<3>(3).copy_from(&other);
    };
    assert_eq!(changed(rows), Kind::Written(Other::Frame));
}

#[test]
fn the_other_side_of_the_attitude() {
    let (before, after) = (start().attitude.matrix(), end().attitude.matrix());
    let columns = |m: &mut Step| {
        let other = m.fixed_columns::<3>(0) * before.transpose();
        m.fixed_columns_mut::<3>(0).copy_from(&other);
    };
    assert_eq!(changed(columns), Kind::Written(Other::Side));
    let rows = |m: &mut Step| {
        let other = after * m.fixed_rows::<3>(0);
        m.fixed_rows_mut::<3>(0).copy_from(&other);
    };
    assert_eq!(changed(rows), Kind::Written(Other::Side));
    let both = |m: &mut Step| {
        columns(m);
        rows(m);
    };
    assert_eq!(changed(both), Kind::Written(Other::Side));
}

#[test]
fn the_other_order_of_a_quaternion() {
    use polhode::jacobian::Slot;
    let (q, omega) = (start().attitude.components(), start().angular_velocity);
    let at = SVector::from([q[0], q[1], q[2], q[3], omega.x, omega.y, omega.z]);
    let exact = derivative(quaternion_step, &at);
    let slots = || [Slot::quaternion("q"), Slot::vector("ω")];
    let check = Check::default().rows(slots()).columns(slots());
    assert!(check.of(quaternion_step, |_| exact, &at).is_right());
    let order = [1, 2, 3, 0, 4, 5, 6];
    let columns = SMatrix::<f64, 7, 7>::from_fn(|r, c| exact[(r, order[c])]);
    let both = SMatrix::<f64, 7, 7>::from_fn(|r, c| exact[(order[r], order[c])]);
    for matrix in [columns, both] {
        let report = check.of(quaternion_step, |_| matrix, &at);
        assert_eq!(only(&report), Kind::Written(Other::QuaternionOrder));
    }
    let signs = [1.0, -1.0, -1.0, -1.0, 1.0, 1.0, 1.0];
    let conjugate = SMatrix::<f64, 7, 7>::from_fn(|r, c| exact[(r, c)] * signs[c]);
    let report = check.of(quaternion_step, |_| conjugate, &at);
    assert_eq!(only(&report), Kind::Written(Other::QuaternionConjugate));
}

#[test]
fn other_orders_and_signs_of_inertia() {
    let to = |order: InertiaParameters| {
        move |m: &mut Step| {
            let asked = m.fixed_columns::<6>(9).into_owned();
            for k in 0..6 {
                let unit = std::array::from_fn(|i| if i == k { 1.0 } else { 0.0 });
                let entries = InertiaParameters::MuJoCo.of_tensor(&order.tensor::<f64>(unit));
                m.column_mut(9 + k)
                    .copy_from(&(asked * SVector::from(entries)));
            }
        }
    };
    assert_eq!(
        changed(to(InertiaParameters::Lecture)),
        Kind::Written(Other::InertiaProducts)
    );
    for order in [InertiaParameters::Urdf, InertiaParameters::Pinocchio] {
        let kind = changed(to(order));
        assert_eq!(kind, Kind::Written(Other::InertiaOrder(order)));
    }
}

#[test]
fn several_slips_are_each_named() {
    let mut matrix = right();
    matrix.column_mut(0).neg_mut();
    matrix.fixed_view_mut::<3, 3>(3, 6).fill(0.0);
    matrix[(5, 15)] *= 2.0;
    let report = report(matrix);
    let kinds: Vec<_> = report.causes().iter().map(|cause| cause.kind).collect();
    assert_eq!(
        kinds,
        [Kind::Missing, Kind::Sign, Kind::Factor(2.0)],
        "{report}"
    );
    let told = report.to_string();
    assert!(told.contains("∂ω′/∂τ: missing"), "{told}");
    assert!(told.contains("columns θx: wrong sign"), "{told}");
    assert!(told.contains("∂ω′z/∂dt: a factor of 2"), "{told}");
}

#[test]
fn the_largest_discrepancy_comes_first() {
    let mut matrix = right();
    matrix[(0, 0)] *= 1.0 + 1e-3;
    matrix[(4, 4)] *= 3.0;
    let report = report(matrix);
    let first = report.entries()[0];
    assert_eq!((first.row, first.column), (4, 4));
    assert!(
        report
            .entries()
            .is_sorted_by(|a, b| (a.verdict, a.discrepancy) >= (b.verdict, b.discrepancy))
    );
}

#[test]
fn a_difference_quotient_is_called_one() {
    let wobble = |m: &mut Step| {
        for (i, entry) in m.iter_mut().enumerate() {
            *entry *= 1.0 + 1e-7 * (i as f64).sin();
        }
    };
    assert!(matches!(changed(wobble), Kind::Approximate(6 | 7)));
}

#[test]
fn a_matrix_of_the_wrong_shape_is_told_so() {
    let f = |x: &DVector<num_dual::Dual64>| DVector::from_vec(vec![x[0] * x[1], x[1], x[0] * 2.0]);
    let at = DVector::from_vec(vec![2.0, 3.0]);
    let right = DMatrix::from_row_slice(3, 2, &[3.0, 2.0, 0.0, 1.0, 2.0, 0.0]);
    assert!(check(f, |_| right.clone(), &at).is_right());
    let report = check(f, |_| right.transpose(), &at);
    assert_eq!(report.causes()[0].kind, Kind::Shape([2, 3], [3, 2]));
    assert_eq!(report.causes()[0].or, [Kind::Transposed]);
    assert_eq!(report.verdict(), Verdict::Wrong);
}

#[test]
#[should_panic(expected = "wrong sign")]
fn the_macro_fails_with_the_report() {
    assert_jacobian!(step, |_| -right(), &at(), rows: rows(), columns: columns());
}

#[test]
fn what_is_not_finite_is_not_right() {
    let mut matrix = right();
    matrix[(1, 1)] = f64::NAN;
    assert_eq!(report(matrix).verdict(), Verdict::Wrong);
    let root = |x: &SVector<num_dual::Dual64, 1>| x.map(|x| num_dual::DualNum::sqrt(&x));
    let report = check(
        root,
        |_| SMatrix::<f64, 1, 1>::new(1.0),
        &SVector::from([0.0]),
    );
    assert_eq!(report.verdict(), Verdict::Unsure, "{report}");
}

fn derivative<const M: usize, const N: usize>(
    f: impl Fn(&SVector<num_dual::Dual64, N>) -> SVector<num_dual::Dual64, M>,
    at: &SVector<f64, N>,
) -> SMatrix<f64, M, N> {
    let column = |k: usize| {
        let seeded =
            SVector::from_fn(|i, _| num_dual::Dual64::new(at[i], f64::from(u8::from(i == k))));
        f(&seeded).map(|y| y.eps)
    };
    SMatrix::from_fn(|r, c| column(c)[r])
}

/// Not all of the tests' functions are closures: the traits are met by a generic function.
#[test]
fn a_generic_function_is_taken_as_it_is() {
    fn square<T: Number>(x: &SVector<T, 1>) -> SVector<T, 1> {
        x.component_mul(x)
    }
    assert_jacobian!(
        square,
        |x: &SVector<f64, 1>| SMatrix::<f64, 1, 1>::new(2.0 * x.x),
        &SVector::from([3.0])
    );
}
