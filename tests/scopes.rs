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
    assert_eq!(verdicts(&text("There is no outside torque.")), "ap");
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

#[test]
fn what_is_more_than_a_name_is_not_taken_on_trust() {
    let line = |words: &str, line: &str| verdicts(&format!("{words}\n\n$$ {line} $$\n"));
    assert_eq!(
        line("The ellipsoid has the semi-axes", "a_i = \\sqrt{2 I_i}"),
        "u"
    );
    assert_eq!(
        line("With $n' = 2n$ and all else as it was,", "p' = 3\\,p"),
        "au"
    );
    let shift = |term: &str| {
        verdicts(&format!(
            "About the fixed point $Q$, with the mass $m$ and the velocity $\\mathbf v_C$ of the mass centre $C$, the momentum \
             is\n\n$$ \\mathbf L_Q = \\mathbf L_C + {term} $$\n"
        ))
    };
    assert_eq!(shift("\\mathbf r_{QC}\\times m\\mathbf v_C"), "a");
    assert_eq!(shift("\\mathbf r_{CQ}\\times m\\mathbf v_C"), "u");
    assert_eq!(shift("m\\mathbf v_C\\times\\mathbf r_{QC}"), "u");
    assert_eq!(shift("m\\mathbf v_C\\times\\mathbf r_{CQ}"), "a");
}

#[test]
fn an_angular_velocity_between_two_frames_of_several_is_left_open() {
    let text = r"For the frames $A$, $B$ and $N$,

$$ {}^N\vec\omega^B = {}^N\vec\omega^A + {}^A\vec\omega^B $$

$$ {}^B\vec\omega^A = -{}^A\vec\omega^B $$
";
    assert!(!verdicts(text).contains('r'), "{}", verdicts(text));
}

#[test]
fn a_plane_of_symmetry_lasts_where_only_its_product_is_written() {
    let text = |sign: &str, behind: &str| {
        format!(
            "# A car\n\n## Body\n\nThe plane $xz$ is a plane of symmetry.\n\n$$ L_x = I_{{xx}}\\omega_x - I_{{xz}}\\omega_z $$\n\n\
             ## The rest\n\n{behind}\n\n$$ L_y = I_{{yy}}\\omega_y $$\n\n\
             $$ L_z = I_{{zz}}\\omega_z {sign} I_{{xz}}\\omega_x $$\n"
        )
    };
    assert_eq!(verdicts(&text("-", "Likewise")), "ppp");
    assert_eq!(verdicts(&text("+", "Likewise")), "ppr");
    assert_ne!(verdicts(&text("-", "For a body of arbitrary shape")), "ppp");
    assert_ne!(verdicts(&text("-", "Beside $I_{xy}$ we have")), "ppp");
}

#[test]
fn what_a_body_is_like_holds_for_the_sections_behind_its_own() {
    let text = |body: &str| {
        format!(
            "# An aeroplane\n\n## The body\n\n{body}\n\n## Its motion\n\n\
             $$ L_y = I_{{yy}}\\omega_y $$\n\n$$ M_y = \\dot L_y + L_x\\omega_z - L_z\\omega_x $$\n"
        )
    };
    assert_eq!(
        verdicts(&text("The only product of inertia is $E = \\int xz\\,dm$.")),
        "app"
    );
    assert!(verdicts(&text("All products of inertia may be met.")).starts_with('r'));
}

#[test]
fn a_torque_that_vanishes_in_one_case_acts_in_the_next() {
    let text = "## Case 1\n\nLet $\\mathbf M = 0$.\n\n## Case 2\n\nNow a torque acts. On principal axes\n\n\
                $$ I_1\\dot\\omega_1 = (I_2 - I_3)\\,\\omega_2\\omega_3 $$\n";
    assert!(!verdicts(text).ends_with('p'), "{}", verdicts(text));
}

#[test]
fn a_law_of_the_torque_lasts_where_the_next_section_goes_on_with_it() {
    let with = |use_of_it: &str| {
        let text = r"A rigid body has the inertia matrix $J$ and the control torque $u$ on body axes:

$$ J\dot\omega = -\omega^\times J\omega + u $$

## Damping

We choose $u = -c\,\omega$. Then

$$ \omega^\top u = -c\,\omega^\top\omega $$

## Momentum

For $H = J\omega$ we have

$$ H^\top u = USE $$
";
        verdicts(&text.replace("USE", use_of_it))
    };
    assert!(
        with(r"-c\,\omega^\top J\,\omega").ends_with('p'),
        "{}",
        with(r"-c\,\omega^\top J\,\omega")
    );
    assert!(with(r"-2c\,\omega^\top J\,\omega").ends_with('r'));
}

#[test]
fn the_title_of_a_paragraph_ends_no_assumption() {
    let text = r"\paragraph{Motion.} Let $\omega_z = n$ on the principal axes of the body.

\paragraph{Momentum.} Hence \[ L_z = I_z n . \]

\paragraph{Another spin.} Let now $\omega_z = 2n$. Then \[ L_z = 2 I_z n . \] \[ L_z = I_z n . \]
";
    let (document, _) =
        polhode::notation::read("t.tex", text, polhode::notation::document::Format::Latex);
    let found = polhode::verify::check(&document).findings;
    let names: Vec<&str> = found.iter().map(|f| f.verdict.name()).collect();
    assert_eq!(
        names,
        ["accepted", "proved", "accepted", "proved", "refuted"]
    );
}

#[test]
fn a_case_without_turning_about_an_axis_keeps_the_momentum_and_the_shape_of_the_body() {
    let text = |last: &str| {
        format!(
            r"The body axes 1, 2 and 3 are principal; $A$, $B$, $C$ are the moments of inertia with the wheel locked. The wheel axis is the pitch axis 2, and $h_w$ is the momentum of the wheel relative to the body.

The total angular momentum is

$$ \mathbf H = A\omega_1\,\mathbf e_1 + (B\omega_2 + h_w)\,\mathbf e_2 + C\omega_3\,\mathbf e_3 $$

**Free motion.** From here on we assume $\mathbf G = \mathbf 0$, where $\mathbf G$ is the torque.

**Nutation.** Keep the wheel speed constant, $\dot h_w = 0$, and let the satellite not turn about its pitch axis, $\omega_2 = 0$. Then

$$ A\dot\omega_1 = h_w\,\omega_3 $$

{last}
"
        )
    };
    let last = |line: &str| verdicts(&text(line)).pop();
    assert_eq!(last(r"$$ C\dot\omega_3 = -h_w\,\omega_1 $$"), Some('p'));
    assert_eq!(last(r"$$ C\dot\omega_3 = h_w\,\omega_1 $$"), Some('r'));
    assert_ne!(last(r"Therefore $$ A = C $$"), Some('p'));
    assert_eq!(verdicts(&text("")), "aaaap");
}

#[test]
fn equations_that_are_coupled_have_no_couple() {
    let text = "## One\n\nThe axes are principal. No torque acts on the body.\n\n## Two\n\nThe two others are coupled. With \
                $I_x = I_y$,\n\n$$ \\dot\\omega_z = 0 $$\n";
    assert_eq!(verdicts(text), "ap");
}

#[test]
fn the_semi_axes_are_those_of_the_surface_above() {
    let axes = |line: &str| {
        verdicts(&format!(
            "A free body has the principal moments $I_1$, $I_2$, $I_3$.\n\n\
             $$ 2T = I_1\\omega_1^2 + I_2\\omega_2^2 + I_3\\omega_3^2 $$\n\n\
             For a given $T$ the vector $\\vec\\omega$ ends on an ellipsoid whose semi-axes are\n\n$$ {line} $$\n"
        ))
    };
    assert_eq!(
        axes(r"a_1 = \sqrt{2T/I_1}, \qquad a_2 = \sqrt{2T/I_2}"),
        "paa"
    );
    assert_eq!(axes(r"a = \sqrt{\frac{2T}{I_1}}"), "pa");
    assert_eq!(axes(r"a_1 = \sqrt{2T/I_2}"), "pu");
    assert_eq!(axes(r"a_1 = \sqrt{2T I_1}"), "pu");
}

#[test]
fn a_weight_without_a_moment_leaves_a_flying_body_free() {
    let text = |words: &str| {
        format!(
            "{words}\n\n$$ \\left(\\frac{{d\\mathbf L}}{{dt}}\\right)_{{body}} = -\\boldsymbol\\omega\\times\\mathbf L $$\n"
        )
    };
    let free = "In the air the weight has no moment about the centre of mass.";
    assert_eq!(verdicts(&text(free)), "p");
    let drag =
        "In the air the weight has no moment about the centre of mass, but the drag has one.";
    assert_ne!(verdicts(&text(drag)), "p");
    let held = "On the bar the weight has no moment about the vertical axis.";
    assert_ne!(verdicts(&text(held)), "p");
}
