//! How far a premise reaches, and which sentences set none, in small documents.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn no_torque_lasts_where_nothing_speaks_of_a_torque_again() {
    let text = |later: &str| {
        format!(
            "## One\n\nThe axes are principal. No torque acts on the body from here on.\n\n## Two\n\n{later} With $I_x = I_y$,\n\n\
             $$ \\dot\\omega_z = 0 $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "ap");
    assert_ne!(
        verdicts(&text("A torque $\\mathbf M$ is switched on.")),
        "ap"
    );
}

#[test]
fn principal_axes_last_where_only_the_diagonal_is_written() {
    let text = |more: &str| {
        format!(
            "## One\n\nOn principal axes\n\n$$ L_1 = I_{{11}}\\omega_1 {more} $$\n\n## Two\n\n$$ L_2 = I_{{22}}\\omega_2 $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "pp");
    assert_eq!(verdicts(&text("- I_{12}\\omega_2")), "pr");
}

#[test]
fn a_moment_of_the_motion_is_no_value_for_good() {
    let text = r"Measured from the lowest place ($\beta = 0$ at rest), the angle obeys

$$ N = -k\sin\beta $$

$$ J\ddot\beta = -3k\sin\beta $$
";
    let found = verdicts(text);
    assert!(found.starts_with("aa") && !found.ends_with('p'), "{found}");
    assert_eq!(verdicts("Both sets of axes coincide at $t = 0$.\n"), "a");
}

#[test]
fn a_criterion_for_what_was_said_is_not_assumed() {
    let text = r"The motion has real roots exactly when

$$ c^2 \ge 3 b $$

It is stable if

$$ c > b $$
";
    assert_eq!(verdicts(text), "uu");
    assert_eq!(verdicts("If\n\n$$ c > b $$\n\nthe sum is positive.\n"), "a");
}

#[test]
fn a_display_behind_a_condition_is_the_main_clause() {
    let text = r"With $I_x = I_y$ and everything else the same,

$$ L_x = I_y\,\omega_x - I_{xy}\,\omega_y - 2 I_{xz}\,\omega_z $$
";
    assert_eq!(verdicts(text), "ar");
}
