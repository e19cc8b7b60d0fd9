//! The bodies against published tables.

use super::{moments, shape};
use nalgebra::Vector3;
use polhode::mechanics::inertia_of_points;
use polhode::scalar::{Field, Prime, Ring};

/// A body of mass 1 against its mass centre and its moments of inertia about x, y, z through the origin.
///
/// All tables are those of Meriam and Kraige, *Engineering Mechanics: Dynamics*, table D/4, moved to our origins. Thick
/// walls are differences of its solids. Sizes are 3, 5, 7, so that 9, 25, 49 below are their squares.
fn check<T: Field>(pi: &T, name: &str, sizes: usize, centre: Vector3<T>, moments_of: Vector3<T>) {
    let sizes = &[3, 5, 7].map(T::int)[..sizes];
    let body = moments(name, &T::one(), sizes, pi);
    assert_eq!(body.mass_centre(), centre, "{name}");
    let about_origin = body.inertia_about(&Vector3::zeros());
    assert_eq!(about_origin.diagonal(), moments_of, "{name}");
}

fn about_z<T: Field>(across: T, along: T) -> Vector3<T> {
    Vector3::new(across.clone(), across, along)
}

fn along_y<T: Field>(y: T) -> Vector3<T> {
    Vector3::new(T::zero(), y, T::zero())
}

fn along_z<T: Field>(z: T) -> Vector3<T> {
    Vector3::new(T::zero(), T::zero(), z)
}

fn wires_and_surfaces<T: Field>(pi: &T) {
    let n = T::ratio;
    let per_pi = |p: i32, q: i32| n(p, q) / pi.clone();
    let check = |name, sizes, centre, moments| check(pi, name, sizes, centre, moments);
    check("rod", 1, along_z(n(0, 1)), about_z(n(9, 12), n(0, 1)));
    check("ring", 1, along_z(n(0, 1)), about_z(n(9, 2), n(9, 1)));
    check(
        "half ring",
        1,
        along_y(per_pi(6, 1)),
        about_z(n(9, 2), n(9, 1)),
    );
    check("disc", 1, along_z(n(0, 1)), about_z(n(9, 4), n(9, 2)));
    check(
        "half disc",
        1,
        along_y(per_pi(12, 3)),
        about_z(n(9, 4), n(9, 2)),
    );
    check(
        "annulus",
        2,
        along_z(n(0, 1)),
        about_z(n(9 + 25, 4), n(9 + 25, 2)),
    );
    check("shell", 1, along_z(n(0, 1)), about_z(n(18, 3), n(18, 3)));
    check(
        "half shell",
        1,
        along_z(n(3, 2)),
        about_z(n(18, 3), n(18, 3)),
    );
    let side = about_z(n(9, 2) + n(25, 12), n(9, 1));
    check("cylindrical shell", 2, along_z(n(0, 1)), side.clone());
    check("half cylindrical shell", 2, along_y(per_pi(6, 1)), side);
    check(
        "conical shell",
        2,
        along_z(n(5, 3)),
        about_z(n(9, 4) + n(25, 6), n(9, 2)),
    );
    let plate = Vector3::new(n(25, 12), n(9, 12), n(9 + 25, 12));
    check("plate", 2, along_z(n(0, 1)), plate);
    let elliptic = Vector3::new(n(25, 4), n(9, 4), n(9 + 25, 4));
    check("elliptic disc", 2, along_z(n(0, 1)), elliptic);
}

fn solids<T: Field>(pi: &T) {
    let n = T::ratio;
    let per_pi = |p: i32, q: i32| n(p, q) / pi.clone();
    let check = |name, sizes, centre, moments| check(pi, name, sizes, centre, moments);
    check("sphere", 1, along_z(n(0, 1)), about_z(n(18, 5), n(18, 5)));
    check(
        "half sphere",
        1,
        along_z(n(9, 8)),
        about_z(n(18, 5), n(18, 5)),
    );
    // 2/5 (R⁵ − r⁵) / (R³ − r³).
    let thick = n(2 * (3125 - 243), 5 * (125 - 27));
    check(
        "thick shell",
        2,
        along_z(n(0, 1)),
        about_z(thick.clone(), thick),
    );
    let cylinder = about_z(n(9, 4) + n(25, 12), n(9, 2));
    check("cylinder", 2, along_z(n(0, 1)), cylinder.clone());
    check("half cylinder", 2, along_y(per_pi(12, 3)), cylinder);
    let tube = about_z(n(9 + 25, 4) + n(49, 12), n(9 + 25, 2));
    check("tube", 3, along_z(n(0, 1)), tube);
    let cone = about_z(n(27, 20) + n(25, 10), n(27, 10));
    check("cone", 2, along_z(n(5, 4)), cone.clone());
    check(
        "half cone",
        2,
        along_y(per_pi(3, 1)) + along_z(n(5, 4)),
        cone,
    );
    check(
        "paraboloid",
        2,
        along_z(n(5, 3)),
        about_z(n(9 + 25, 6), n(9, 3)),
    );
    // m (b² + 2 h²) / 20, m (a² + 2 h²) / 20, m (a² + b²) / 20.
    let pyramid = Vector3::new(n(25 + 98, 20), n(9 + 98, 20), n(9 + 25, 20));
    check("pyramid", 3, along_z(n(7, 4)), pyramid);
    let squares = |q| Vector3::new(n(25 + 49, q), n(9 + 49, q), n(9 + 25, q));
    check("box", 3, along_z(n(0, 1)), squares(12));
    check("ellipsoid", 3, along_z(n(0, 1)), squares(5));
    check("half ellipsoid", 3, along_z(n(21, 8)), squares(5));
}

fn published<T: Field>(pi: &T) {
    wires_and_surfaces(pi);
    solids(pi);
}

#[test]
fn the_moments_are_those_of_the_tables() {
    published(&Prime::new(271_828_182));
    #[cfg(feature = "verify")]
    published(&<num_rational::BigRational as Field>::ratio(22, 7));
}

/// A plate with three corners has the moments of three points, a third of its mass in the middle of each edge (Routh,
/// *Elementary Rigid Dynamics*, on equimomental bodies).
#[test]
fn corners_give_the_points_of_routh_and_the_products_of_the_tables() {
    let pi = Prime::new(271_828_182);
    let n = Prime::int;
    let corners = [[2, 1], [7, -3], [4, 9]].map(|[x, y]| Vector3::new(n(x), n(y), n(0)));
    let flat: Vec<_> = corners.iter().flat_map(|c| [c.x, c.y]).collect();
    let middles = [(0, 1), (1, 2), (2, 0)].map(|(i, j)| (n(2), (corners[i] + corners[j]) / n(2)));
    let plate = moments("triangle", &n(6), &flat, &pi);
    let about_origin = plate.inertia_about(&Vector3::zeros());
    assert_eq!(about_origin, inertia_of_points(&middles));
    assert_eq!(shape("triangle").content(&flat, &pi), Some(n(24)));
    // Meriam's rectangular tetrahedron with the edges 3, 5, 7: ∫ x y dm = m a b / 20, I_xx = m (b² + c²) / 10.
    let corner = [0, 0, 0, 3, 0, 0, 0, 5, 0, 0, 0, 7].map(n);
    let body = moments("tetrahedron", &n(20), &corner, &pi);
    assert_eq!(body.first, Vector3::new(n(15), n(25), n(35)));
    let [xx, xy, yz] = [n(2 * 74), n(-15), n(-35)];
    let tensor = body.inertia_about(&Vector3::zeros());
    assert_eq!(
        [tensor[(0, 0)], tensor[(0, 1)], tensor[(1, 2)]],
        [xx, xy, yz]
    );
    assert_eq!(
        shape("tetrahedron").content(&corner, &pi),
        Some(Prime::ratio(35, 2))
    );
    // A quarter ring: ∫ x y dm = m r² / π.
    let quarter = moments("quarter ring", &pi, &[n(3)], &pi);
    assert_eq!(quarter.second[(0, 1)], n(9));
}

#[test]
fn contents_are_those_of_geometry() {
    let pi = Prime::new(271_828_182);
    let n = Prime::int;
    let cases: [(&str, &[i32], Prime); 15] = [
        ("rod", &[3], n(3)),
        ("ring", &[3], n(6) * pi),
        ("quarter ring", &[4], n(2) * pi),
        ("half disc", &[2], n(2) * pi),
        ("annulus", &[3, 5], n(16) * pi),
        ("elliptic disc", &[3, 5], n(15) * pi),
        ("cylindrical shell", &[3, 5], n(30) * pi),
        ("shell", &[3], n(36) * pi),
        ("sphere", &[3], n(36) * pi),
        ("thick shell", &[3, 6], n(252) * pi),
        ("half ellipsoid", &[1, 2, 3], n(4) * pi),
        ("cone", &[3, 5], n(15) * pi),
        ("pyramid", &[3, 4, 5], n(20)),
        ("paraboloid", &[2, 5], n(10) * pi),
        ("tube", &[3, 5, 2], n(32) * pi),
    ];
    for (name, sizes, content) in cases {
        let sizes: Vec<_> = sizes.iter().map(|&s| n(s)).collect();
        assert_eq!(shape(name).content(&sizes, &pi), Some(content), "{name}");
    }
    assert_eq!(shape("conical shell").content(&[n(3), n(4)], &pi), None);
}
