//! Products of inertia of plain text: integrals in words, and two letters of opposite sign.
#![cfg(feature = "verify")]

use polhode::notation::{document::Format, read};
use polhode::verify::{Verdict, check};

fn last(row: &str) -> Verdict {
    let text = format!(
        "The program prints

    Dxy = integral of x*y dm
    Dxz = integral of x*z dm
    Dyz = integral of y*z dm

and the matrix has the entries

    Ixy = -Dxy
    Ixz = -Dxz
    Iyz = -Dyz

With the angular velocity w = (wx, wy, wz) and the angular momentum H on body axes

    {row}
"
    );
    let (document, _) = read("a mail", &text, Format::Text);
    let mut findings = check(&document).findings;
    findings.pop().expect("a line").verdict
}

#[test]
fn a_letter_for_the_integrals_tells_the_sign_of_the_entries() {
    assert!(matches!(
        last("Hy = Iyy*wy - Dxy*wx - Dyz*wz"),
        Verdict::Proved(_)
    ));
    assert!(matches!(
        last("Hy = Iyy*wy + Ixy*wx + Iyz*wz"),
        Verdict::Proved(_)
    ));
    assert_eq!(last("Hy = Iyy*wy + Dxy*wx - Dyz*wz"), Verdict::Refuted);
    assert_eq!(last("Hy = Iyy*wy - Ixy*wx + Iyz*wz"), Verdict::Refuted);
}
