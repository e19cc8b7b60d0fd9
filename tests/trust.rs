//! A refutation that no slip explains is withheld where a document was not understood, and only there.

#[path = "outcome/verdicts.rs"]
mod outcome;
use outcome::verdicts;

/// Euler's equations with a torque of its own letter, and three lines that no single slip turns into true ones.
const STRANGE: &str = "$$I_1\\dot\\omega_1 = I_2^3\\omega_1\\omega_2$$\n\n$$I_2\\dot\\omega_2 = 7 I_3\\omega_1^2$$\n\n$$I_3\\dot\\omega_3 = 5 I_1 I_2\\omega_3$$\n";

const OPENING: &str =
    "The axes are attached to the body and principal, and the body moves without torque.\n\n";

#[test]
fn lines_that_are_all_false_without_a_slip_are_left_open() {
    assert_eq!(verdicts(&format!("{OPENING}{STRANGE}")), "uuu");
}

#[test]
fn a_line_that_is_false_among_true_ones_stays_so() {
    let one = "$$I_3\\dot\\omega_3 = 5 I_1 I_2\\omega_3$$\n";
    assert_eq!(verdicts(&format!("{OPENING}{one}")), "r");
}

#[test]
fn a_named_slip_stays_refuted_in_any_company() {
    let slip = "\n$$I_1\\dot\\omega_1 = (I_3 - I_2)\\omega_2\\omega_3$$\n";
    assert_eq!(verdicts(&format!("{OPENING}{STRANGE}{slip}")), "uuur");
}
