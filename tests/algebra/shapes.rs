//! The bodies against published tables, against sums over points, and against the laws of moments.
//!
//! What has no root is checked in a field of 2⁶¹ − 1 elements, where an identity holds exactly or not at all.

use nalgebra::{Matrix3, Vector3};
use num_dual::Dual;
use polhode::mechanics::{Moments, Shape, possible_body};
use polhode::scalar::Field;
use std::f64::consts::PI;

mod laws;
mod published;

fn shape(name: &str) -> Shape {
    Shape::by_name(name).unwrap_or_else(|| panic!("{name}"))
}

fn moments<T: Field>(name: &str, mass: &T, sizes: &[T], pi: &T) -> Moments<T> {
    shape(name)
        .moments(mass, sizes, pi)
        .unwrap_or_else(|| panic!("sizes of {name}"))
}

/// How many numbers a shape takes.
fn count(shape: Shape) -> usize {
    shape.sizes().iter().map(|size| size.count).sum()
}

/// Sizes for every shape: its numbers grow, so that an outer radius is beyond an inner one, and corners span a solid.
const SIZES: [f64; 12] = [
    0.5, 0.9, 1.4, -0.3, 0.7, 2.0, -0.8, 1.1, -0.4, 0.6, -1.3, 1.7,
];

/// A body as the points of a lattice that lie in it, of the mass 1.
fn lattice(parts: i32, inside: impl Fn(f64, f64, f64) -> bool) -> Moments<f64> {
    let along = |k: i32| (f64::from(k) + 0.5) * 4.0 / f64::from(parts) - 2.0;
    let mut sum = Moments::of_point(&0.0, &Vector3::zeros());
    for (i, j, k) in
        (0..parts).flat_map(|i| (0..parts).flat_map(move |j| (0..parts).map(move |k| (i, j, k))))
    {
        let r = Vector3::new(along(i), along(j), along(k));
        if inside(r.x, r.y, r.z) {
            sum = sum.plus(&Moments::of_point(&1.0, &r));
        }
    }
    sum.scaled(&(1.0 / sum.mass))
}

#[test]
fn solids_are_their_points() {
    type Inside = fn(f64, f64, f64) -> bool;
    let cases: [(&str, &[f64], Inside); 7] = [
        ("half cone", &[1.5, 1.8], |x, y, z| {
            y > 0.0 && z > 0.0 && x.hypot(y) < 1.5 * (1.0 - z / 1.8)
        }),
        ("half thick shell", &[1.0, 1.7], |x, y, z| {
            z > 0.0 && (1.0..1.7).contains(&x.hypot(y).hypot(z))
        }),
        ("elliptic cylinder", &[1.9, 0.9, 3.0], |x, y, z| {
            (x / 1.9).hypot(y / 0.9) < 1.0 && z.abs() < 1.5
        }),
        ("quarter tube", &[0.8, 1.9, 3.0], |x, y, z| {
            x > 0.0 && y > 0.0 && (0.8..1.9).contains(&x.hypot(y)) && z.abs() < 1.5
        }),
        ("pyramid", &[3.0, 2.4, 1.8], |x, y, z| {
            z > 0.0 && (x.abs() / 1.5).max(y.abs() / 1.2) < 1.0 - z / 1.8
        }),
        ("paraboloid", &[1.5, 1.8], |x, y, z| {
            z > 0.0 && (x * x + y * y) / 2.25 < 1.0 - z / 1.8
        }),
        ("half ellipsoid", &[1.9, 1.2, 0.9], |x, y, z| {
            z > 0.0 && (x / 1.9).hypot(y / 1.2).hypot(z / 0.9) < 1.0
        }),
    ];
    for (name, sizes, inside) in cases {
        let exact = moments(name, &1.0, sizes, &PI);
        let off = |parts: i32| {
            let sum = lattice(parts, inside);
            (sum.first - exact.first)
                .amax()
                .max((sum.second - exact.second).amax())
        };
        assert!(
            off(48) < 0.02 && off(16) < 0.06,
            "{name}: {} {}",
            off(16),
            off(48)
        );
    }
}

#[test]
fn every_shape_is_a_body() {
    for shape in Shape::all() {
        let sizes = &SIZES[..count(shape)];
        let sizes: Vec<_> = match shape.sizes()[0].is_place {
            true => sizes.to_vec(),
            false => sizes.iter().map(|s| s.abs()).collect(),
        };
        let body = shape.moments(&2.0, &sizes, &PI).expect("all sizes");
        assert!((body.mass - 2.0).abs() < 1e-15);
        if shape.name() != "rod" {
            let possible = possible_body(&body.central_inertia());
            assert!(possible.is_ok(), "{shape:?}: {possible:?}");
        }
        assert_eq!(Shape::by_name(shape.name()), Some(shape));
        assert!(shape.moments(&2.0, &sizes[1..], &PI).is_none());
        assert!(
            shape
                .moments(&2.0, &[&sizes[..], &[1.0]].concat(), &PI)
                .is_none()
        );
    }
    assert_eq!(Shape::by_name("thin disc"), Shape::by_name("disc"));
    assert_eq!(Shape::by_name("thin cylinder"), None);
}

#[test]
fn the_derivative_in_a_size_is_the_limit_of_differences() {
    for shape in Shape::all() {
        let sizes = SIZES[..count(shape)].to_vec();
        let entries =
            |body: Moments<f64>| [body.central_inertia(), Matrix3::from_diagonal(&body.first)];
        for k in 0..sizes.len() {
            let at = |step: f64| {
                let mut moved = sizes.clone();
                moved[k] += step;
                entries(shape.moments(&1.0, &moved, &PI).expect("all sizes"))
            };
            let dual: Vec<_> = (0..sizes.len())
                .map(|i| Dual::new(sizes[i], f64::from(u8::from(i == k))))
                .collect();
            let (one, pi) = (Dual::from_re(1.0), Dual::from_re(PI));
            let body = shape.moments(&one, &dual, &pi).expect("all sizes");
            let slope = [body.central_inertia(), Matrix3::from_diagonal(&body.first)]
                .map(|m| m.map(|e| e.eps));
            // Central differences: half the step, a quarter of the error.
            let off = |step: f64| {
                let (ahead, behind) = (at(step), at(-step));
                let each =
                    (0..2).map(|i| ((ahead[i] - behind[i]) / (2.0 * step) - slope[i]).amax());
                each.fold(0.0, f64::max)
            };
            assert!(off(1e-2) < 1e-2, "{shape:?} {k}");
            assert!(
                off(5e-3) < off(1e-2) / 3.9 + 1e-11,
                "{shape:?} {k}: {} {}",
                off(1e-2),
                off(5e-3)
            );
        }
    }
}

/// A wall of no thickness is the surface, with nothing cancelled on the way.
#[test]
fn a_thin_wall_is_its_surface() {
    let cases: [(&str, &[f64], &str, &[f64]); 3] = [
        ("annulus", &[3.0, 3.0], "ring", &[3.0]),
        ("tube", &[3.0, 3.0, 2.0], "cylindrical shell", &[3.0, 2.0]),
        ("thick shell", &[3.0, 3.0], "shell", &[3.0]),
    ];
    for (wall, sizes, surface, radius) in cases {
        let [thick, thin] = [(wall, sizes), (surface, radius)].map(|(name, sizes)| {
            let body = moments(name, &2.0, sizes, &PI);
            (body.first, body.second)
        });
        assert_eq!(thick, thin, "{wall}");
    }
}
