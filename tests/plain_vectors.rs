//! Plain text that runs a letter of its own together with x, y and z.
#![cfg(feature = "verify")]

use polhode::notation::{document::Format, read};
use polhode::verify::check;

fn verdicts(text: &str) -> Vec<&'static str> {
    let (document, _) = read("a note", text, Format::Text);
    let report = check(&document);
    report.findings.iter().map(|f| f.verdict.name()).collect()
}

#[test]
fn components_of_a_torque_that_touch_their_axes_are_read() {
    let text = "Vectors are on principal axes through the mass centre. tx, ty, tz: the torque.\n\n    \
                Ix*dwx/dt = tx + (Iy - Iz)*wy*wz\n    Iz*dwz/dt = tz + (Iy - Ix)*wx*wy\n    \
                Iy*wydot = ty + (Iz - Ix)*wz*wx\n    dL/dt + w x L = t\n";
    assert_eq!(verdicts(text), ["proved", "refuted", "proved", "proved"]);
}

#[test]
fn coordinates_stay_factors() {
    let text = "A force F acts at (x, y, z), all fixed in the body, on principal axes.\n\n    Mz = x*Fy - y*Fx\n    \
                d/dt(cx + cy + cz) = 0\n    Ix*dwx/dt = Mx + (Iy - Iz)*wy*wz\n";
    assert_eq!(verdicts(text).last(), Some(&"proved"));
    let text = "Principal axes.\n\n    tx, ty\n\n    Ix*dwx/dt = tx + (Iy - Iz)*wy*wz\n";
    assert_eq!(verdicts(text), ["undecided"]);
}

#[test]
fn a_vector_is_written_along_unit_vectors_that_turn() {
    let text = |last: &str| {
        format!(
            "Frame B turns with angular velocity w. Any vector can be written on the axes i, j, k of B, so let\n\n    \
             Q = Qx i + Qy j + Qz k\n\nSeen from B the unit vectors do not move:\n\n    (dQ/dt)_B = (dQx/dt) i + \
             (dQy/dt) j + (dQz/dt) k\n\nSeen from N they turn with w. With w = wx i + wy j + wz k the rates in N \
             are\n\n    di/dt = w x i = wz j - wy k\n    dk/dt = w x k = {last}\n\nWith the product of inertia Ixz = \
             integral of x*z dm we have more.\n"
        )
    };
    let of = |last: &str| verdicts(&text(last));
    let right = of("wy i - wx j");
    assert_eq!(right[4..5], ["proved"]);
    assert!(
        right
            .iter()
            .all(|verdict| matches!(*verdict, "proved" | "accepted")),
        "{right:?}"
    );
    assert_eq!(of("wx j - wy i")[4..5], ["refuted"]);
}

#[test]
fn words_in_brackets_say_from_where_a_rate_is_seen() {
    let law = |sign: char| {
        let text = format!(
            "The body has the angular momentum H and turns with w.\n\n    dH/dt (inertial) = dH/dt (body) {sign} w x H\n"
        );
        verdicts(&text)
    };
    assert_eq!(law('+'), ["proved"]);
    assert_eq!(law('-'), ["refuted"]);
}

#[test]
fn places_of_masses_are_written_by_a_factor_and_a_list() {
    let text = "Two masses m on a massless rod, turning about its centre with w along z. The rod makes the angle g with the z \
                axis.\n\nPosition of mass 1: r1 = b*(sin(g), 0, cos(g)), mass 2: r2 = -r1.\n\n    w = (0, 0, W)\n    v1 = w x \
                r1 = (0, W*b*sin(g), 0)\n    L = 2*m*(r1 x v1)\n";
    let found = verdicts(text);
    assert!(!found.contains(&"refuted"), "{found:?}");
    assert_ne!(found[3], "undecided");
}

#[test]
fn a_capital_and_two_axes_are_an_entry() {
    let text = "    Bxx = (60/12)*(0.6^2 + 1.0^2) = 6.8\n    Ixx = Bxx + 2*2*(0.3^2 + 0.4^2) = 6.8 + 1.0 = 7.8\n";
    let found = verdicts(text);
    assert_eq!(found.len(), 2);
    assert!(
        !found.contains(&"unreadable") && !found.contains(&"refuted"),
        "{found:?}"
    );
}
