//! Lines that follow from more than a name: nothing here works them out, and they are not taken on trust.
#![cfg(feature = "verify")]

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn the_least_value_of_a_known_letter_is_no_definition() {
    let text = "A top has the moment of inertia $C$ about its axis. We define the spin $s$ by\n\n\
                $$ p = C s $$\n\nThe least spin is\n\n$$ s_{\\min} = \\frac{3}{C}\\sqrt{Amgl} $$\n";
    assert!(verdicts(text).ends_with('u'), "{}", verdicts(text));
}

#[test]
fn what_equated_sides_come_to_is_no_definition() {
    let text = |words: &str| {
        format!(
            "The forces have the moment\n\n$$ \\vec M_O = (mg - P)\\,b\\,\\hat n $$\n\n\
             {words} $$ P = mg - \\frac{{K\\nu^2}}{{a}} $$\n"
        )
    };
    let found = verdicts(&text("Equating both sides we find\n\n"));
    assert!(found.ends_with('u'), "{found}");
}

#[test]
fn a_labelled_momentum_by_moments_of_inertia_is_no_definition() {
    let text = "With the rates $p$ and $r$ about the stability axes the angular momentum is\n\n\
                $$ \\begin{bmatrix} H_{x_s} \\\\ H_{z_s} \\end{bmatrix} = \\begin{bmatrix} I_{x_s} & I_{xz_s} \\\\ \
                I_{xz_s} & I_{z_s} \\end{bmatrix}\\begin{bmatrix} p \\\\ r \\end{bmatrix} $$\n";
    assert_eq!(verdicts(text), "u");
}

#[test]
fn the_angle_of_principal_axes_is_no_assumption() {
    let text = "The axes on which the product of inertia vanishes are inclined at the angle $\\beta$ with\n\n\
                $$ \\tan 2\\beta = \\frac{2I_{xy}}{I_x - I_y} $$\n";
    assert_eq!(verdicts(text), "u");
}

#[test]
fn an_axis_that_goes_round_the_momentum_does_so_at_the_known_rate() {
    let text = |moment: &str| {
        format!(
            "A symmetric body has $I_1 = I_2$, and no torque acts. Its angular momentum is $\\vec L$.\n\n\
             The axis of the body goes round $\\vec L$ at the rate\n\n$$ \\dot\\phi = \\frac{{L}}{{{moment}}} $$\n"
        )
    };
    assert!(verdicts(&text("I_1")).ends_with('a'));
    assert!(verdicts(&text("I_3")).ends_with('r'));
}

#[test]
fn numbers_alone_are_worked_out_and_not_handed_over() {
    let text = |line: &str| {
        verdicts(&format!(
            "Let $m = 2$ and $r = 3$. The root is\n\n$$ {line} $$\n"
        ))
    };
    assert_eq!(
        text(r"\tfrac12\sqrt{18\,000^2 + 4\cdot 1200^2} = 9080"),
        "aap"
    );
    assert_eq!(
        text(r"\tfrac12\sqrt{18\,000^2 + 4\cdot 1200^2} = 9180"),
        "aar"
    );
    assert_eq!(text(r"3\sqrt{17} = 12.37"), "aap");
    assert_eq!(text(r"3\sqrt{17} = 12.47"), "aar");
}
