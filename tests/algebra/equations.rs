//! Each equation of rotation beside another way to say the same, mostly on small integers, where both are exact.

use nalgebra::{Matrix3, Vector2, Vector3, Vector4};
use polhode::mechanics::{
    Products, acceleration_of_body_point, adjugate, apply, attitude_rate, centrifugal_moment,
    coriolis_moment, cross, determinant, euler_moment, force, inertia, inertia_of_points,
    inertia_rate, lowest_of_disc, lowest_of_sphere, moment, moment_about_moving_point,
    moment_components, moment_in_axes, product, quaternion_conjugate, quaternion_product,
    quaternion_rate, relative_acceleration, rotation, skew, spring_energy, spring_force, transport,
    transport_twice, velocity_in_moving_frame, velocity_in_moving_plane, velocity_of_body_point,
};
use polhode::scalar::Jet;

const M: Matrix3<i64> = Matrix3::new(2, -3, 1, 4, 0, -5, 7, 6, 8);
const V: Vector3<i64> = Vector3::new(3, -2, 5);

#[test]
fn the_adjugate_times_the_matrix_is_the_determinant() {
    // 2 (0 + 30) + 3 (32 + 35) + 1 (24 − 0)
    assert_eq!(determinant(&M), 285);
    assert_eq!(product(&M, &adjugate(&M)), Matrix3::identity() * 285);
    assert_eq!(product(&adjugate(&M), &M), Matrix3::identity() * 285);
}

#[test]
fn nine_products_are_those_of_nalgebra() {
    assert_eq!(apply(&M, &V), M * V);
    assert_eq!(product(&M, &M.transpose()), M * M.transpose());
    let other = Vector3::new(-1, 4, 9);
    assert_eq!(apply(&skew(&V), &other), cross(&V, &other));
}

const P: Vector4<i32> = Vector4::new(2, -1, 3, 5);
const Q: Vector4<i32> = Vector4::new(1, 4, -2, 6);

#[test]
fn the_matrix_is_the_sandwich() {
    let v = Vector3::new(3, -7, 2);
    let pure = Vector4::new(0, v.x, v.y, v.z);
    let turned = quaternion_product(&quaternion_product(&P, &pure), &quaternion_conjugate(&P));
    assert_eq!((rotation(&P) * v).insert_row(0, 0), turned);
    assert_eq!(
        rotation(&quaternion_product(&P, &Q)),
        rotation(&P) * rotation(&Q)
    );
}

/// Both rates say one thing: d/dt of the matrix of q, by q̇ = ½ q ω, is R [ω]×.
#[test]
fn the_quaternion_turns_as_the_matrix_does() {
    let q = P.map(f64::from);
    let omega = Vector3::new(2.0, -4.0, 6.0);
    let moving = q.zip_map(&quaternion_rate(&q, &omega), Jet::<f64, 1>::moving);
    let rate = rotation(&moving).map(|r| r.rate());
    // Small integers: every product is exact, so the equality is too.
    assert_eq!(rate, attitude_rate(&rotation(&q), &omega));
}

#[test]
fn components_are_the_transport_of_momentum() {
    let rate = Vector3::new(3, -1, 4);
    let (momentum, turn) = (Vector3::new(6, 2, -9), Vector3::new(-2, 7, 5));
    let lines = moment_components(&rate, &momentum, &turn);
    assert_eq!(Vector3::from(lines), transport(&rate, &turn, &momentum));
}

/// The lecture's lines with every product of inertia, typed in by hand: the thing to compare with.
#[test]
fn the_full_tensor_gives_the_hand_expanded_components() {
    let ([a, b, c], [d, e, f]) = ([11, 13, 17], [2, 3, 5]);
    let (w, o) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
    let m = moment(&inertia([a, b, c], [d, e, f], Products::Integrals), &w, &o);
    let x = a * o.x - d * o.y - e * o.z - (b - c) * w.y * w.z - e * w.x * w.y
        + d * w.x * w.z
        + f * (w.z * w.z - w.y * w.y);
    let y = b * o.y - d * o.x - f * o.z - (c - a) * w.z * w.x - d * w.y * w.z
        + f * w.x * w.y
        + e * (w.x * w.x - w.z * w.z);
    let z = c * o.z - e * o.x - f * o.y - (a - b) * w.x * w.y - f * w.x * w.z
        + e * w.y * w.z
        + d * (w.y * w.y - w.x * w.x);
    assert_eq!(m, Vector3::new(x, y, z));
}

/// The moment is one vector whatever the axes: with İ and Ω × L, any Ω gives the same as Ω = ω.
#[test]
fn the_moment_does_not_depend_on_how_the_axes_turn() {
    let body = inertia([11, 13, 17], [2, 3, 5], Products::Entries);
    let (omega, alpha) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
    for turn in [Vector3::zeros(), Vector3::new(3, 1, -2), omega] {
        let change = inertia_rate(&body, &omega, &turn);
        let seen = alpha - cross(&turn, &omega);
        assert_eq!(
            moment_in_axes(&body, &change, &omega, &seen, &turn),
            moment(&body, &omega, &alpha)
        );
    }
}

/// Two masses on given courses, as jets of jets: the law follows from Σ r × m a.
#[test]
fn the_moment_about_a_moving_point_is_the_moment_of_the_forces() {
    let masses = [2, 5];
    let places = [Vector3::new(1, 4, -2), Vector3::new(3, 0, 7)];
    let velocities = [Vector3::new(-1, 2, 2), Vector3::new(4, -3, 1)];
    let accelerations = [Vector3::new(6, 1, 0), Vector3::new(-2, 5, 3)];
    let (point, point_velocity) = (Vector3::new(2, 2, 1), Vector3::new(-3, 1, 4));
    let (mut momentum, mut linear, mut moment) =
        (Vector3::zeros(), Vector3::zeros(), Vector3::zeros());
    for i in 0..2 {
        let arm = (places[i] - point).zip_map(&(velocities[i] - point_velocity), Jet::moving);
        let motion = velocities[i].zip_map(&accelerations[i], Jet::<i32, 1>::moving);
        momentum += cross(&arm, &motion).map(|l| masses[i] * l.rate());
        linear += velocities[i] * masses[i];
        moment += cross(&(places[i] - point), &force(&masses[i], &accelerations[i]));
    }
    let law = moment_about_moving_point(&momentum, &point_velocity, &linear);
    assert_eq!(law, moment);
    assert_ne!(momentum, moment);
}

const RATE: Vector3<i32> = Vector3::new(3, -1, 4);
const TURN: Vector3<i32> = Vector3::new(-2, 7, 5);
const VECTOR: Vector3<i32> = Vector3::new(6, 2, -9);

#[test]
fn twice_is_the_sum_of_the_four_named_terms() {
    let (second, turn_rate) = (Vector3::new(1, 8, -3), Vector3::new(4, -6, 2));
    let terms = relative_acceleration(&second, &RATE, &VECTOR, &TURN, &turn_rate);
    assert_eq!(
        transport_twice(&second, &RATE, &VECTOR, &TURN, &turn_rate),
        terms.relative + terms.coriolis + terms.euler + terms.centripetal
    );
}

#[test]
fn the_plane_is_space_with_one_component_of_omega() {
    let lift = |v: Vector2<i32>| Vector3::new(v.x, v.y, 0);
    let (rate, vector, origin) = (RATE.xy(), VECTOR.xy(), TURN.xy());
    let in_plane = velocity_in_moving_plane(&origin, &rate, &5, &vector);
    let turn = Vector3::new(0, 0, 5);
    let in_space = velocity_in_moving_frame(&lift(origin), &lift(rate), &turn, &lift(vector));
    assert_eq!(lift(in_plane), in_space);
}

#[test]
fn the_moments_are_those_of_the_forces_on_the_points() {
    // Four points about their mass centre.
    let points = [
        (2, Vector3::new(1, -2, 3)),
        (2, Vector3::new(-1, 2, -3)),
        (1, Vector3::new(4, 0, 1)),
        (1, Vector3::new(-4, 0, -1)),
    ];
    let (turn, change) = (Vector3::new(3, -1, 2), Vector3::new(0, 5, -4));
    let spin = Vector3::new(-2, 7, 1);
    let inertia = inertia_of_points(&points);
    let mut sums = [Vector3::zeros(); 3];
    for (mass, place) in points {
        let rate = spin.cross(&place);
        let terms = relative_acceleration(&Vector3::zeros(), &rate, &place, &turn, &change);
        let forces = [terms.coriolis, terms.centripetal, terms.euler];
        for (sum, force) in sums.iter_mut().zip(forces) {
            *sum -= place.cross(&force) * mass;
        }
    }
    assert_eq!(coriolis_moment(&inertia, &turn, &spin), sums[0]);
    assert_eq!(centrifugal_moment(&inertia, &turn), sums[1]);
    assert_eq!(euler_moment(&inertia, &change), sums[2]);
}

#[test]
fn the_lowest_point_of_a_tilted_disc_is_on_its_rim_and_below_all_others() {
    let (sine, cosine): (f64, f64) = (0.6, 0.8);
    let (axis, upward) = (Vector3::new(sine, 0.0, cosine), Vector3::z());
    let lowest: Vector3<f64> = lowest_of_disc(&2.0, &axis, &upward) / sine;
    assert!((lowest.norm() - 2.0).abs() < 1e-12 && lowest.dot(&axis).abs() < 1e-12);
    let across = axis.cross(&lowest);
    let other = |angle: f64| lowest * angle.cos() + across * angle.sin();
    let height = |angle: f64| other(angle).dot(&upward);
    assert!((1..63).all(|k| height(0.1 * f64::from(k)) >= height(0.0)));
    assert_eq!(
        lowest_of_sphere(&2.0, &upward),
        Vector3::new(0.0, 0.0, -2.0)
    );
}

#[test]
fn what_a_body_point_does_is_the_rate_of_what_it_did() {
    let omega = Vector3::new(0.3, -0.7, 1.1);
    let (alpha, place) = (Vector3::new(-0.2, 0.5, 0.4), Vector3::new(1.0, 2.0, -1.5));
    let (v, a) = (Vector3::new(0.1, 0.2, 0.3), Vector3::new(-1.0, 0.0, 2.0));
    let velocity = |t: f64| {
        // The place is carried along: its rate is ω × r.
        let carried = place + omega.cross(&place) * t;
        velocity_of_body_point(&(v + a * t), &(omega + alpha * t), &carried)
    };
    let step = 1e-6;
    let rate = (velocity(step) - velocity(-step)) / (2.0 * step);
    assert!((rate - acceleration_of_body_point(&a, &omega, &alpha, &place)).norm() < 1e-8);
}

#[test]
fn the_force_is_the_slope_of_the_energy_downhill() {
    let (stiffness, natural, at) = (3.0_f64, 1.25_f64, Vector3::new(0.4_f64, -1.1, 2.0));
    let force = spring_force(&stiffness, &natural, &at, &at.norm());
    let energy = |way: Vector3<f64>| spring_energy(&stiffness, &natural, &way.norm());
    let step = 1e-5;
    for axis in 0..3 {
        let mut way = Vector3::zeros();
        way[axis] = step;
        let slope = (energy(at + way) - energy(at - way)) / (2.0 * step);
        assert!((force[axis] + slope).abs() < 1e-8);
    }
}

#[test]
fn stretched_it_pulls_back_and_compressed_it_pushes() {
    let at = Vector3::new(0.0_f64, 3.0, 4.0);
    let force = |natural: f64| spring_force(&2.0, &natural, &at, &5.0);
    assert!((force(4.0) + at * 0.4).norm() < 1e-12);
    assert!((force(6.0) - at * 0.4).norm() < 1e-12);
}
