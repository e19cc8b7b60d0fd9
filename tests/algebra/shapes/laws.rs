//! The laws of moments, at random sizes.

use super::{count, moments, shape};
use nalgebra::{Matrix3, Vector3, Vector4};
use polhode::mechanics::{Shape, inertia_in_axes, parallel_axis, rotation};
use polhode::scalar::{Prime, Ring};
use proptest::prelude::*;

fn number() -> impl Strategy<Value = Prime> {
    (1..Prime::MODULUS).prop_map(Prime::new)
}

fn vector() -> impl Strategy<Value = Vector3<Prime>> {
    [number(), number(), number()].prop_map(Vector3::from)
}

fn turn() -> impl Strategy<Value = Matrix3<Prime>> {
    [number(), number(), number(), number()]
        .prop_map(Vector4::from)
        .prop_filter("no rotation", |q| q.dot(q) != Prime::int(0))
        .prop_map(|q| rotation(&q) / q.dot(&q))
}

/// Any shape with the sizes that it takes.
fn any_shape() -> impl Strategy<Value = (Shape, Vec<Prime>)> {
    let shapes: Vec<_> = Shape::all().collect();
    (
        prop::sample::select(shapes),
        prop::collection::vec(number(), 12),
    )
        .prop_map(|(shape, mut sizes)| {
            sizes.truncate(count(shape));
            (shape, sizes)
        })
}

proptest! {
    #[test]
    fn a_turned_body_has_the_turned_tensor(
        (shape, sizes) in any_shape(), m in number(), pi in number(), r in turn(), d in vector(),
    ) {
        let body = shape.moments(&m, &sizes, &pi).expect("all sizes");
        let placed = body.placed(&r, &d);
        prop_assert_eq!(placed.mass_centre(), r * body.mass_centre() + d);
        prop_assert_eq!(placed.central_inertia(), inertia_in_axes(&r, &body.central_inertia()));
    }

    #[test]
    fn the_axes_are_parallel((shape, sizes) in any_shape(), m in number(), pi in number(), p in vector()) {
        let body = shape.moments(&m, &sizes, &pi).expect("all sizes");
        let offset = p - body.mass_centre();
        prop_assert_eq!(body.inertia_about(&p), parallel_axis(&body.central_inertia(), &m, &offset));
    }

    /// Two halves, or four quarters, are the whole; turned about z, or over where the half is a dome.
    #[test]
    fn parts_make_the_whole((part, sizes) in any_shape(), m in number(), pi in number()) {
        let body = part.moments(&m, &sizes, &pi).expect("all sizes");
        let zero = Vector3::zeros();
        let turned = |q: [i32; 4]| {
            let q = Vector4::from(q.map(Prime::int));
            body.placed(&(rotation(&q) / q.dot(&q)), &zero)
        };
        let (sum, whole) = if let Some(whole) = part.name().strip_prefix("half ") {
            let over = if part.axes().contains("z ≥ 0") { [0, 1, 0, 0] } else { [0, 0, 0, 1] };
            (body.plus(&turned(over)), whole)
        } else if let Some(whole) = part.name().strip_prefix("quarter ") {
            let halves = body.plus(&turned([1, 0, 0, 1]));
            (halves.plus(&turned([0, 0, 0, 1])).plus(&turned([1, 0, 0, -1])), whole)
        } else {
            return Ok(());
        };
        prop_assert_eq!(moments(whole, &sum.mass, &sizes, &pi), sum);
    }

    #[test]
    fn a_hole_leaves_the_rest(r in number(), s in number(), h in number(), density in number(), pi in number()) {
        let of = |name: &str, sizes: &[Prime]| shape(name).uniform(&density, sizes, &pi).expect("all sizes");
        prop_assert_eq!(of("disc", &[s]).minus(&of("disc", &[r])), of("annulus", &[r, s]));
        prop_assert_eq!(of("cylinder", &[s, h]).minus(&of("cylinder", &[r, h])), of("tube", &[r, s, h]));
        prop_assert_eq!(of("sphere", &[s]).minus(&of("sphere", &[r])), of("thick shell", &[r, s]));
    }
}
