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
