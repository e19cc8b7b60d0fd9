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
