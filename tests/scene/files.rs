//! Scene files: what is read from them, and what is said of those that are wrong.

use nalgebra::{Matrix3, Vector3};
use polhode::mechanics::parallel_axis;
use polhode::scene::{self, Scene};
use polhode::source::Source;
use std::{fs, path::Path};

const HEAD: &str = "[[body]]\nname = 'a'\nangular_velocity = [1, 0, 0]\n";
const RUN: &str = "[run]\nduration = 1\n";

fn read(text: &str) -> Result<Scene, Vec<(String, String)>> {
    let source = Source::new("scene.toml", text);
    scene::read(&source).map_err(|errors| {
        assert!(!errors.is_empty(), "refused without a reason: {text}");
        let place =
            |error: &polhode::diagnostic::Diagnostic| source.slice(error.primary.span).to_owned();
        errors
            .iter()
            .map(|error| {
                (
                    format!("{}: {} {:?}", error.code, error.message, error.helps),
                    place(error),
                )
            })
            .collect()
    })
}

/// The tensor of the only body.
fn tensor(inertia: &str) -> Matrix3<f64> {
    let scene = read(&format!("{HEAD}inertia = {inertia}\n{RUN}")).expect("a good scene");
    let body = scene.groups[0]
        .shared_body()
        .expect("a body")
        .expect("one for all");
    *body.inertia()
}

#[test]
fn every_example_is_read() {
    let mut count = 0;
    for entry in fs::read_dir("examples/scenes").expect("the examples") {
        let path = entry.expect("readable").path();
        if path.extension() != Some(Path::new("toml").as_os_str()) {
            continue;
        }
        let text = fs::read_to_string(&path).expect("UTF-8");
        let source = Source::new(path.to_string_lossy(), text);
        let scene = scene::read(&source).unwrap_or_else(|errors| panic!("{path:?}: {errors:?}"));
        assert!(scene.bodies() > 0);
        count += 1;
    }
    assert!(count >= 6);
}

/// The words of the first list that is called `KEYS`.
fn keys(source: &str) -> impl Iterator<Item = &str> {
    let (_, list) = source.split_once(" KEYS: &[&str] = &[").expect("a list");
    let (list, _) = list.split_once("];").expect("its end");
    list.split('"').skip(1).step_by(2)
}

#[test]
fn the_manual_names_every_key() {
    let body = keys(include_str!("../../src/scene/read/body.rs"));
    let run = keys(include_str!("../../src/scene/read/run.rs"));
    let all: Vec<_> = body.chain(run).collect();
    assert!(all.contains(&"name") && all.contains(&"estimate_error"));
    let missing = |key: &&&str| !scene::MANUAL.contains(&format!("{key} ="));
    // A step is named beside its method.
    assert_eq!(all.iter().filter(missing).collect::<Vec<_>>(), [&"step"]);
}

#[test]
fn the_manual_is_a_scene_itself() {
    let scene = read(scene::MANUAL).expect("a good scene");
    assert_eq!(scene.bodies(), 4);
}

#[test]
fn the_sign_convention_decides_what_a_product_is() {
    let integrals = tensor("{ xx = 2.0, yy = 3, zz = 4, xy = 0.1 }");
    assert_eq!(integrals[(0, 1)].to_bits(), (-0.1f64).to_bits());
    let text = format!(
        "{HEAD}inertia = {{ xx = 2, yy = 3, zz = 4, xy = 0.1 }}\nproducts = 'entries'\n{RUN}"
    );
    let scene = read(&text).expect("a good scene");
    let body = scene.groups[0]
        .shared_body()
        .expect("a body")
        .expect("one for all");
    assert_eq!(*body.inertia(), integrals.map(f64::abs));
}

/// The tensor of a solid by summing small cubes of it.
fn summed(half: Vector3<f64>, inside: impl Fn(&Vector3<f64>) -> bool) -> Matrix3<f64> {
    let n = 50;
    let mut points = Vec::new();
    for (i, j, k) in (0..n * n * n).map(|c| (c / (n * n), c / n % n, c % n)) {
        let at = |index: i32| (2.0 * f64::from(index) + 1.0) / f64::from(n) - 1.0;
        let r = Vector3::new(at(i) * half.x, at(j) * half.y, at(k) * half.z);
        if inside(&r) {
            points.push(r);
        }
    }
    let centre = points.iter().sum::<Vector3<f64>>() / points.len() as f64;
    let mass = 1.0 / points.len() as f64;
    points.iter().fold(Matrix3::zeros(), |sum, r| {
        parallel_axis(&sum, &mass, &(r - centre))
    })
}

#[test]
fn a_shape_has_the_tensor_of_its_mass() {
    let (r, h) = (0.7, 0.9);
    let half = Vector3::new(0.7, 0.7, 0.9);
    let in_cone = |p: &Vector3<f64>| p.xy().norm() < r * (h - p.z) / (2.0 * h);
    let in_pyramid = |p: &Vector3<f64>| p.xy().amax() < r * (h - p.z) / (2.0 * h);
    let in_ellipsoid = |p: &Vector3<f64>| p.component_div(&half).norm() < 1.0;
    let cases = [
        (
            "shape = 'box', size = [1.4, 1.4, 1.8]",
            summed(half, |_| true),
        ),
        (
            "shape = 'cylinder', radius = 0.7, height = 1.8",
            summed(half, |p| p.xy().norm() < r),
        ),
        (
            "shape = 'rod', radius = 0.7, length = 1.8",
            summed(half, |p| p.xy().norm() < r),
        ),
        (
            "shape = 'cone', radius = 0.7, height = 1.8",
            summed(half, in_cone),
        ),
        (
            "shape = 'pyramid', base = [1.4, 1.4], height = 1.8",
            summed(half, in_pyramid),
        ),
        (
            "shape = 'ellipsoid', semi_axes = [0.7, 0.7, 0.9]",
            summed(half, in_ellipsoid),
        ),
    ];
    for (shape, expected) in cases {
        let found = tensor(&format!("{{ {shape}, mass = 1.0 }}"));
        // The staircase of the cubes along a curved face.
        assert!(
            (found - expected).amax() < 2e-3,
            "{shape}: {found}{expected}"
        );
    }
    let ball = tensor("{ shape = 'sphere', radius = 0.5, mass = 2.0 }");
    assert!((ball - Matrix3::from_diagonal_element(0.2)).amax() < 1e-15);
    let moved = tensor("{ shape = 'sphere', radius = 0.5, mass = 2.0, offset = [0, 0, 1] }");
    assert!((moved - Matrix3::from_diagonal(&Vector3::new(2.2, 2.2, 0.2))).amax() < 1e-15);
}

/// Half a ring about its mass centre: m r² about the axis through the ends' middle, less m (2 r / π)².
#[test]
fn a_shape_is_an_inertia_about_its_mass_centre() {
    let scene = |shape: &str| {
        let text = format!("{HEAD}shape = {{ {shape} }}\n{RUN}");
        let scene = read(&text).expect("a good scene");
        let body = scene.groups[0].shared_body();
        *body.expect("a body").expect("one for all").inertia()
    };
    let ring = scene("kind = 'half ring', mass = 3, radius = 2");
    let lost = 3.0 * (4.0 / std::f64::consts::PI).powi(2);
    let expected = Matrix3::from_diagonal(&Vector3::new(6.0 - lost, 6.0, 12.0 - lost));
    assert!((ring - expected).amax() < 1e-14, "{ring}");
    let tube = "mass = 2, inner_radius = 0.3, outer_radius = 0.4, height = 0.5";
    let same = tensor(&format!("{{ shape = 'tube', {tube} }}"));
    assert!((scene(&format!("kind = 'tube', {tube}")) - same).amax() < 1e-16);
    let corners = "first_corner = [1, -2], second_corner = [4, -2], third_corner = [1, 2]";
    let triangle = scene(&format!("kind = 'triangle', mass = 36, {corners}"));
    // About the mass centre of a right triangle ∫ x y dm = −m b h / 36, and the entry is its negative.
    assert!((triangle[(0, 1)] - 12.0).abs() < 1e-13, "{triangle}");
}

#[test]
fn points_far_away_have_the_tensor_of_points_nearby() {
    let points = |x: f64| {
        format!(
            "{{ points = [{{ mass = 1, position = [{x}, 1, 0] }}, {{ mass = 1, position = [{x}, -1, 0] }}, \
             {{ mass = 1, position = [{x}, 0, 1] }}] }}"
        )
    };
    assert!((tensor(&points(0.0)) - tensor(&points(1e6))).amax() < 1e-9);
}

/// A bad scene, what has to be said of it, and at which text.
const BAD: &[(&str, &str, &str)] = &[
    ("", "no-body", ""),
    ("[run]\nduration = 1", "no-body", ""),
    ("body = []\n[run]\nduration = 1", "no-body", "[]"),
    ("[body]\nname = 'a'\n[run]\nduration = 1", "[[body]]", ""),
    ("[[body]\n", "syntax", ""),
    ("[[body]]\nname = 'a'\nname = 'b'", "syntax", "name"),
    (
        "H inertai = { xx = 1, yy = 1, zz = 1 }\nR",
        "write `inertia`",
        "inertai",
    ),
    ("H R", "needs the key `inertia`", ""),
    ("H I colour = 'red'\nR", "its keys are", "colour"),
    (
        "H I torque = { kind = 'gravty' }\nR",
        "write `gravity`",
        "'gravty'",
    ),
    (
        "H I torque = { kind = 'constant', value = [nan, 0, 0] }\nR",
        "has to be finite",
        "nan",
    ),
    (
        "H I torque = { kind = 'damping', coefficient = -1 }\nR",
        "not negative",
        "-1",
    ),
    (
        "H I torque = { kind = 'none', value = [1, 0, 0] }\nR",
        "no key `value`",
        "value",
    ),
    (
        "H inertia = { xx = 1, yy = 1, zz = 3 }\nR",
        "impossible-inertia",
        "{ xx = 1, yy = 1, zz = 3 }",
    ),
    (
        "H inertia = { xx = 1, yy = 1, zz = -1 }\nR",
        "impossible-inertia",
        "{ xx = 1, yy = 1, zz = -1 }",
    ),
    (
        "H inertia = { shape = 'rod', mass = 1, length = 2 }\nR",
        "give its `radius`",
        "",
    ),
    (
        "H shape = { kind = 'cylindr', mass = 1 }\nR",
        "write `cylinder`",
        "'cylindr'",
    ),
    (
        "H shape = { kind = 'tube', mass = 1, inner_radius = 1, height = 2 }\nR",
        "needs the key `outer_radius`",
        "",
    ),
    (
        "H shape = { kind = 'tube', mass = 1, inner_radius = 3, outer_radius = 2, height = 2 }\nR",
        "the inner one has to be the smaller",
        "3",
    ),
    (
        "H shape = { kind = 'sphere', mass = 1, radius = -2 }\nR",
        "has to be positive",
        "-2",
    ),
    (
        "H shape = { kind = 'sphere', mass = 1, raduis = 2 }\nR",
        "write `radius`",
        "raduis",
    ),
    (
        "H shape = { mass = 1, radius = 2 }\nR",
        "needs the key `kind`",
        "",
    ),
    ("H shape = 'box'\nR", "has to be a table", "'box'"),
    (
        "H I shape = { kind = 'sphere', mass = 1, radius = 2 }\nR",
        "keep one of `shape` and `inertia`",
        "{ xx = 1, yy = 1, zz = 1 }",
    ),
    ("H inertia = 5\nR", "an inertia is", "5"),
    (
        "H I attitude = [0, 0, 0, 0]\nR",
        "has to have a direction",
        "[0, 0, 0, 0]",
    ),
    ("H I attitude = [1, 0, 0]\nR", "has to have 4", "[1, 0, 0]"),
    ("H I count = 0\nR", "at least one body", "0"),
    ("H I count = 1000000000\nR", "too-many-bodies", ""),
    ("H I count = -3\nR", "has to be 0", "-3"),
    ("H I seed = 1.5\nR", "a whole number", "1.5"),
    ("H I H I R", "duplicate-name", "'a'"),
    ("H I [run]\nduration = -1", "has to be positive", "-1"),
    ("H I [run]\nduration = inf", "has to be finite", "inf"),
    (
        "H I [run]\nduration = '1 s'",
        "is of the type string",
        "'1 s'",
    ),
    (
        "H I [run]\nduration = 1\ntolerance = 1e-17",
        "below what doubles can hold",
        "1e-17",
    ),
    ("H I [run]\nduration = 1\ntolerance = 1", "too large", "1"),
    (
        "H I [run]\nduration = 1\noutputs = ['final', 'enrgy']",
        "write `energy`",
        "'enrgy'",
    ),
    ("H I [run]\nduration = 1\noutputs = []", "no output", "[]"),
    (
        "H I [run]\nduration = 1\nmethod = 'rk4'",
        "needs the key `step`",
        "",
    ),
    (
        "H I [run]\nduration = 1\nstep = 0.1",
        "method of fixed step",
        "0.1",
    ),
    (
        "H I [run]\nduration = 1e9\nmethod = 'rk4'\nstep = 1e-9",
        "steps",
        "1e-9",
    ),
    (
        "H I [run]\nduration = 1\noutput_interval = 1e-30",
        "rows",
        "1e-30",
    ),
    ("H I ", "missing-key", ""),
];

#[test]
fn a_bad_scene_is_told_what_and_where() {
    for (text, said, at) in BAD {
        let text = text
            .replace("H ", HEAD)
            .replace("I ", "inertia = { xx = 1, yy = 1, zz = 1 }\n")
            .replace('R', RUN);
        let errors = read(&text).expect_err("a bad scene");
        let found = errors
            .iter()
            .any(|(message, place)| message.contains(said) && (at.is_empty() || place == at));
        assert!(found, "{text}\nwanted {said:?} at {at:?}, got {errors:?}");
    }
}

#[test]
fn all_that_is_wrong_is_said_at_once() {
    let text = "[[body]]\nname = ''\ninertia = { xx = 'a', yy = 1, zz = 1 }\nangular_velocity = 3\n[run]\nduration = 0";
    assert_eq!(read(text).expect_err("a bad scene").len(), 4);
}
