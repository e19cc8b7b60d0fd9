//! The laws that any right equation of rotational motion keeps, at random bodies and motions, exactly.

use nalgebra::{Matrix3, Vector3, Vector4};
use polhode::algebra::Rational;
use polhode::mechanics::{
    Products, angular_acceleration, angular_momentum, apply, attitude_rate, determinant, inertia,
    inertia_in_axes, inertia_of_points, inertia_rate, kinetic_energy, moment, moment_components,
    moment_in_axes, momentum_rate, parallel_axis, power, product, quaternion_product,
    quaternion_rate, relative_acceleration, rotation, transport, transport_derived,
    transport_twice, velocity_in_moving_frame, velocity_in_moving_plane, vis_viva,
};
use polhode::scalar::{Jet, Ring};
use proptest::prelude::*;

fn rational() -> impl Strategy<Value = Rational> {
    (-30i64..31, 1i64..7).prop_map(Rational::from)
}

fn vector() -> impl Strategy<Value = Vector3<Rational>> {
    [rational(), rational(), rational()].prop_map(Vector3::from)
}

/// Any symmetric tensor: the laws do not ask whether a body can have it.
fn tensor() -> impl Strategy<Value = Matrix3<Rational>> {
    (vector(), vector()).prop_map(|(m, p)| inertia(m.into(), p.into(), Products::Integrals))
}

/// An exact unit quaternion's rotation: the homogeneous one over |q|².
fn turn() -> impl Strategy<Value = Matrix3<Rational>> {
    let part = || -9i64..10;
    [part(), part(), part(), part()]
        .prop_filter("zero is no rotation", |q| q.iter().any(|&c| c != 0))
        .prop_map(|q| {
            let square = Rational::from(q.iter().map(|c| c * c).sum::<i64>());
            rotation(&Vector4::from(q.map(Rational::from))).map(|e| e / square.clone())
        })
}

fn scaled(v: &Vector3<Rational>, by: &Rational) -> Vector3<Rational> {
    v.map(|c| c * by.clone())
}

proptest! {
    #[test]
    fn the_moment_is_linear_in_inertia_and_in_alpha(
        i in tensor(), j in tensor(), w in vector(), a in vector(), b in vector(), k in rational(),
    ) {
        let sum = &i + j.map(|e| e * k.clone());
        prop_assert_eq!(moment(&sum, &w, &a), moment(&i, &w, &a) + scaled(&moment(&j, &w, &a), &k));
        let still = Vector3::zeros();
        prop_assert_eq!(
            moment(&i, &w, &(&a + scaled(&b, &k))),
            moment(&i, &w, &a) + scaled(&moment(&i, &still, &b), &k)
        );
    }

    #[test]
    fn the_moment_is_objective(i in tensor(), w in vector(), a in vector(), r in turn()) {
        prop_assert_eq!(determinant(&r), Rational::int(1));
        let turned = moment(&inertia_in_axes(&r, &i), &apply(&r, &w), &apply(&r, &a));
        prop_assert_eq!(turned, apply(&r, &moment(&i, &w, &a)));
    }

    #[test]
    fn the_power_of_the_moment_is_the_rate_of_the_energy(i in tensor(), w in vector(), a in vector()) {
        let (still, moving) = (i.map(Jet::<_, 1>::constant), w.zip_map(&a, Jet::moving));
        let rate = kinetic_energy(&still, &moving).rate();
        prop_assert_eq!(power(&moment(&i, &w, &a), &w), rate);
        let twice = Rational::int(2) * kinetic_energy(&i, &w);
        prop_assert_eq!(vis_viva(&i, &w), twice.clone());
        prop_assert_eq!(w.dot(&angular_momentum(&i, &w)), twice);
    }

    #[test]
    fn a_free_body_keeps_its_energy_and_its_momentum(i in tensor(), w in vector(), r in turn()) {
        prop_assume!(determinant(&i) != Rational::int(0));
        let a = angular_acceleration(&i, &w, &Vector3::zeros());
        prop_assert_eq!(power(&apply(&i, &a), &w), Rational::int(0));
        // R L is constant in space, with Ṙ = R [ω]×.
        let attitude = r.zip_map(&attitude_rate(&r, &w), Jet::<_, 1>::moving);
        let momentum = angular_momentum(&i, &w).zip_map(&apply(&i, &a), Jet::moving);
        prop_assert_eq!(apply(&attitude, &momentum).map(|l| l.rate()), Vector3::zeros());
    }

    #[test]
    fn both_conventions_describe_one_body(m in vector(), p in vector(), w in vector(), a in vector()) {
        let integrals = inertia(m.clone().into(), p.clone().into(), Products::Integrals);
        let entries = inertia(m.into(), (-p).into(), Products::Entries);
        prop_assert_eq!(moment(&integrals, &w, &a), moment(&entries, &w, &a));
    }

    #[test]
    fn the_stated_transport_is_the_derived_one(
        r in turn(), rate in vector(), frame in vector(), q in vector(),
    ) {
        let stated = transport(&rate, &frame, &q);
        prop_assert_eq!(transport_derived(&r, &rate, &frame, &q), stated.clone());
        let [x, y, z] = moment_components(&rate, &q, &frame);
        prop_assert_eq!(Vector3::new(x, y, z), stated);
    }

    /// d²(R Q)/dt² by jets of jets in time, with R̈ = R ([Ω]× [Ω]× + [Ω̇]×).
    #[test]
    fn the_second_transport_is_the_second_derivative(
        r in turn(), second in vector(), rate in vector(), q in vector(), frame in vector(), turn_rate in vector(),
    ) {
        let first = attitude_rate(&r, &frame);
        let again = attitude_rate(&first, &frame) + attitude_rate(&r, &turn_rate);
        let nest = |value, once: Rational, twice| {
            Jet::<_, 1>::moving(Jet::<_, 1>::moving(value, once.clone()), Jet::moving(once, twice))
        };
        let attitude = Matrix3::from_fn(|i, j| {
            nest(r[(i, j)].clone(), first[(i, j)].clone(), again[(i, j)].clone())
        });
        let moving = Vector3::from_fn(|i, _| nest(q[i].clone(), rate[i].clone(), second[i].clone()));
        let in_space = apply(&attitude, &moving).map(|c| c.rate().rate());
        let seen = transport_twice(&second, &rate, &q, &frame, &turn_rate);
        prop_assert_eq!(apply(&r.transpose(), &in_space), seen.clone());
        let terms = relative_acceleration(&second, &rate, &q, &frame, &turn_rate);
        prop_assert_eq!(terms.relative + terms.coriolis + terms.euler + terms.centripetal, seen);
    }

    #[test]
    fn the_plane_lies_in_space(v in vector(), rate in vector(), r in vector(), turn in rational()) {
        let flat = |v: &Vector3<Rational>| Vector3::new(v[0].clone(), v[1].clone(), Rational::int(0));
        let axis = Vector3::new(Rational::int(0), Rational::int(0), turn.clone());
        let space = velocity_in_moving_frame(&flat(&v), &flat(&rate), &axis, &flat(&r));
        let plane = velocity_in_moving_plane(
            &v.fixed_rows::<2>(0).into_owned(), &rate.fixed_rows::<2>(0).into_owned(), &turn, &r.fixed_rows::<2>(0).into_owned());
        prop_assert_eq!(space, Vector3::new(plane[0].clone(), plane[1].clone(), Rational::int(0)));
    }

    #[test]
    fn the_moment_is_the_same_from_axes_of_any_turn(
        i in tensor(), w in vector(), a in vector(), frame in vector(),
    ) {
        let seen = &a - frame.cross(&w);
        let rate = inertia_rate(&i, &w, &frame);
        prop_assert_eq!(moment_in_axes(&i, &rate, &w, &seen, &frame), moment(&i, &w, &a));
    }

    /// The tensor of a turning cloud of points, by a jet in time, against the closed form.
    #[test]
    fn the_inertia_rate_is_that_of_the_points(
        points in prop::collection::vec((rational(), vector()), 1..5), w in vector(), frame in vector(),
    ) {
        let moving: Vec<_> = points.iter().map(|(m, r)| {
            let velocity = (&w - &frame).cross(r);
            (Jet::constant(m.clone()), r.zip_map(&velocity, Jet::<_, 1>::moving))
        }).collect();
        let rate = inertia_of_points(&moving).map(|e| e.rate());
        prop_assert_eq!(inertia_rate(&inertia_of_points(&points), &w, &frame), rate);
    }

    /// From Newton's law of each point: Σ r × m a is the moment, and Σ ½ m v² the energy, of L = I ω and T = ½ ω·I ω.
    #[test]
    fn the_equation_follows_from_newton_for_each_point(
        points in prop::collection::vec((rational(), vector()), 1..5), w in vector(), a in vector(),
    ) {
        let body = inertia_of_points(&points);
        let zero = || (Vector3::zeros(), Vector3::zeros(), Rational::int(0));
        let (momentum, moments, energy) = points.iter().fold(zero(), |(l, m, t), (mass, r)| {
            let v = w.cross(r);
            let acceleration = a.cross(r) + w.cross(&v);
            (
                l + scaled(&r.cross(&v), mass),
                m + scaled(&r.cross(&acceleration), mass),
                t + mass.clone() * v.dot(&v),
            )
        });
        prop_assert_eq!(angular_momentum(&body, &w), momentum);
        prop_assert_eq!(moment(&body, &w, &a), moments);
        prop_assert_eq!(vis_viva(&body, &w), energy);
        let still = Matrix3::zeros();
        prop_assert_eq!(momentum_rate(&body, &still, &w, &a), apply(&body, &a));
    }

    #[test]
    fn the_parallel_axis_shift_is_that_of_the_points(
        points in prop::collection::vec((1i64..9, vector()), 1..5), d in vector(),
    ) {
        let points: Vec<_> = points.into_iter().map(|(m, r)| (Rational::from(m), r)).collect();
        let mass = points.iter().fold(Rational::int(0), |sum, (m, _)| sum + m.clone());
        let first = points.iter().fold(Vector3::zeros(), |sum, (m, r)| sum + scaled(r, m));
        let centre = first.map(|c| c / mass.clone());
        let from = |origin: &Vector3<Rational>| -> Vec<_> {
            points.iter().map(|(m, r)| (m.clone(), r - origin)).collect()
        };
        prop_assert_eq!(
            parallel_axis(&inertia_of_points(&from(&centre)), &mass, &d),
            inertia_of_points(&from(&(&centre + &d)))
        );
    }

    #[test]
    fn quaternions_turn_as_their_matrices(p in [rational(), rational(), rational(), rational()],
        q in [rational(), rational(), rational(), rational()], w in vector(),
    ) {
        let (p, q) = (Vector4::from(p), Vector4::from(q));
        prop_assert_eq!(
            rotation(&quaternion_product(&p, &q)),
            product(&rotation(&p), &rotation(&q))
        );
        let moving = q.zip_map(&quaternion_rate(&q, &w), Jet::<_, 1>::moving);
        prop_assert_eq!(rotation(&moving).map(|e| e.rate()), attitude_rate(&rotation(&q), &w));
    }
}
