//! Claims that are the first to speak of a symbol whose name and the laws say what it is.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

#[test]
fn what_is_no_root_of_the_equation_above_is_not_defined_as_one() {
    let text = |four: &str| {
        format!(
            "We find the frequency equation\n\n$$ as^2 - bs - c = 0 $$\n\nwith the two roots\n\n\
             $$ s_1 = \\frac{{b + \\sqrt{{b^2 + {four}ac}}}}{{2a}} $$\n"
        )
    };
    assert!(verdicts(&text("4")).ends_with('a'));
    assert!(verdicts(&text("")).ends_with('u'));
}

#[test]
fn the_acceleration_of_a_point_is_the_rate_of_its_velocity() {
    let with = |centripetal: &str| {
        let text = r"The axes xyz turn with the body at $\vec\omega$. The vector $\vec\rho$ from $C$ to $Q$ is fixed in the body, $\left(\frac{d\vec\rho}{dt}\right)_{xyz} = \vec 0$. Suppose

$$ \vec v_Q = \vec v_C + \vec\omega\times\vec\rho $$

Then

$$ \vec a_Q = \vec a_C + \dot{\vec\omega}\times\vec\rho SIGN \vec\omega\times(\vec\omega\times\vec\rho) $$
";
        verdicts(&text.replace("SIGN", centripetal))
    };
    assert_eq!(with("+"), "aap");
    assert_eq!(with("-"), "aar");
}

#[test]
fn the_momentum_about_another_point_has_the_moment_of_the_momentum() {
    let with = |term: &str| {
        let text = r"Let $\mathbf L_C = \mathbf I_C\boldsymbol\omega$ be the angular momentum about the centre of mass $C$, $m$ the mass and $\mathbf{r}_{PC}$ the vector from $P$ to $C$. Suppose that

$$ \mathbf v_C = \boldsymbol\omega\times\mathbf r_{PC} $$

About $P$ the angular momentum is

$$ \mathbf L_P = \mathbf L_C + TERM $$
";
        let all = verdicts(&text.replace("TERM", term));
        all.chars().last()
    };
    assert_eq!(with(r"m\,\mathbf r_{PC}\times\mathbf v_C"), Some('p'));
    assert_eq!(with(r"m\,\mathbf v_C\times\mathbf r_{PC}"), Some('r'));
}

#[test]
fn the_moment_of_inertia_about_an_axis_is_told_by_its_unit_vector() {
    let with = |factor: &str| {
        let text = r"Let the unit vector $\hat n = n_x\hat i + n_y\hat j + n_z\hat k$ lie on an axis. The moment of inertia about it is

$$ I_n = I_{xx}n_x^2 + I_{yy}n_y^2 + I_{zz}n_z^2 - FACTOR(I_{xy}n_xn_y + I_{yz}n_yn_z + I_{xz}n_xn_z) $$
";
        verdicts(&text.replace("FACTOR", factor))
    };
    assert_eq!(with("2"), "ap");
    assert_eq!(with(""), "ar");
}

#[test]
fn a_moment_about_an_axis_is_used_before_it_is_written_out() {
    let text = r"Let the body turn about the unit vector $\hat n = n_x\hat i + n_y\hat j + n_z\hat k$, that is, $\vec\omega = \omega\,\hat n$. Then $T = \frac12 I_n\omega^2$ with

$$ I_n = I_{xx}n_x^2 + I_{yy}n_y^2 + I_{zz}n_z^2 - I_{xy}n_xn_y - I_{yz}n_yn_z - I_{xz}n_xn_z $$

The momentum along the axis is

$$ \hat n\cdot\vec L = I_n\omega $$
";
    assert_eq!(verdicts(text), "aaprp");
}

#[test]
fn a_value_that_rests_on_a_formula_nothing_checked_is_left_open() {
    let text = r"The body is a block with axes x, y, z as principal axes, and therefore

$$ I_x = m (b^2 + c^2)/6 $$

Put in $m = 12$, $b = 2$, $c = 1$:

$$ I_x = 10 $$
";
    assert!(verdicts(text).ends_with('u'), "{}", verdicts(text));
}

#[test]
fn the_energy_of_a_part_is_that_of_its_moment_and_its_rate() {
    let with = |factor: &str| {
        let text = r"The motor behind a gear of the ratio $n$ has the moment of inertia $J_r$, and its speed is $\dot\varphi_r = n\dot\theta$. Its kinetic energy is

$$ T_r = \frac12 FACTOR J_r\,\dot\theta^2 $$

so the shaft feels the moment of inertia

$$ J_{\text{tot}} = FACTOR J_r $$
";
        verdicts(&text.replace("FACTOR", factor))
    };
    assert_eq!(with("n^2"), "aaa");
    assert_eq!(with("n"), "aru");
}

#[test]
fn a_deviation_grows_by_the_root_of_the_coefficient() {
    let with = |below: &str| {
        let text = r"A free body on principal axes turns with $\omega_1 = x$, $\omega_2 = n$ and $\omega_3 = z$, where $x$ and $z$ are small and $n$ is constant. To first order

$$ I_1\dot x = (I_2 - I_3)\,n\,z $$

$$ I_3\dot z = (I_1 - I_2)\,n\,x $$

$$ \ddot x = \frac{(I_2 - I_3)(I_1 - I_2)}{I_1 I_3}\,n^2\,x $$

so that $x$ grows like $e^{\lambda t}$ with

$$ \lambda^2 = \frac{(I_2 - I_3)(I_1 - I_2)}{I_1 BELOW}\,n^2 $$
";
        verdicts(&text.replace("BELOW", below)).pop()
    };
    assert_eq!(with("I_3"), Some('a'));
    assert_eq!(with("I_2"), Some('r'));
}

#[test]
fn a_moment_of_inertia_made_of_lengths_alone_lacks_the_mass() {
    let text = |mass: &str| {
        format!(
            "The shapes have the mass $m$. A ball of radius $r$ has $I_{{ball}} = \\frac{{2}}{{5}}mr^2$, a plate with the sides $a$ and $b$ \
             has $I_{{plate}} = \\frac{{1}}{{12}}{mass}(a^2 + b^2)$ about its normal.\n"
        )
    };
    assert_eq!(verdicts(&text("m")), "aa");
    assert_eq!(verdicts(&text("")), "ar");
}

#[test]
fn what_an_open_line_was_to_determine_is_not_defined_behind_it() {
    let text = "The body turns with the rate $\\omega$. Divergence sets in where\n\n$$ (C - A)P_a^2 + M_a = 0 $$\n\n\
                that is, at the critical roll rate\n\n$$ P_a^2 = -\\frac{M_a}{C - B} $$\n";
    assert!(!verdicts(text).ends_with('a'), "{}", verdicts(text));
}

#[test]
fn a_balance_says_what_its_new_force_is() {
    let text = r"The wheel has the mass $m$ and turns the post at the rate $p$. Let $h = m R b p$ and $Q = h\,p$. The force on the plate is called $N$, and

$$ (N - m g)\,b = Q $$

$$ N = m g + 2 m R p^2 $$
";
    assert_eq!(verdicts(text), "aauu");
}

#[test]
fn the_form_in_which_a_known_quantity_is_written_says_what_is_new_in_it() {
    let text = |half: &str| {
        format!(
            "On principal axes the body turns with $\\omega_x = \\omega\\cos\\beta$, $\\omega_y = \\omega\\sin\\beta$ and $\\omega_z = 0$. If we write \
             $T = \\frac12 I_d\\,\\omega^2$ for the kinetic energy $T$, then\n\n$$ I_d = {half}(I_x\\cos^2\\beta + I_y\\sin^2\\beta) $$\n"
        )
    };
    assert_eq!(verdicts(&text("")), "aaaap");
    assert_eq!(verdicts(&text("\\frac12")), "aaaar");
}

#[test]
fn the_square_of_a_length_that_words_have_named_is_taken_unchecked() {
    let text = "The sides are $a$ and $b$, the length of the diagonal is $d$, so\n\n$$ d^2 = a^2 + b^2 $$\n\n\
                and with it\n\n$$ d^4 = a^4 + 2a^2b^2 + b^4 $$\n\n$$ d^4 = a^4 + b^4 $$\n";
    assert_eq!(verdicts(text), "upr");
}

#[test]
fn a_definition_may_have_its_symbol_on_the_right() {
    let text = |right: &str| {
        format!(
            "A symmetric top turns about its fixed tip; its moment of inertia is $C$ about the axis of figure and $A$ across it. \
             The angles are the precession angle $\\phi$, the inclination $\\theta$ and the spin angle $\\psi$. The Lagrangian is\n\n\
             $$ \\mathcal{{L}} = \\tfrac12 A(\\dot\\theta^2 + \\dot\\phi^2\\sin^2\\theta) + \\tfrac12 C(\\dot\\psi + \\dot\\phi\\cos\\theta)^2 - mgh\\cos\\theta $$\n\n\
             $$ p_\\psi = \\frac{{\\partial\\mathcal{{L}}}}{{\\partial\\dot\\psi}} = C(\\dot\\psi + \\dot\\phi\\cos\\theta) $$\n\n\
             and we define $n$ by $p_\\psi = Cn$. The other momentum is\n\n\
             $$ p_\\phi = \\frac{{\\partial\\mathcal{{L}}}}{{\\partial\\dot\\phi}} = A\\,\\dot\\phi\\sin^2\\theta + {right} $$\n"
        )
    };
    assert_eq!(verdicts(&text(r"C\,n\cos\theta")), "apap");
    assert_eq!(verdicts(&text(r"C\,n\sin\theta")), "apar");
}

#[test]
fn a_law_of_control_says_what_acts() {
    let text = |last: &str| {
        format!(
            "The dynamics with the inertia matrix $J$ are\n\n$$ J\\dot{{\\bm\\omega}} + \\bm\\omega\\times J\\bm\\omega = \\bm u $$\n\n\
             and the control law is chosen as\n\n$$ \\bm u = -c\\,\\bm s - d\\,\\bm\\omega $$\n\nHence\n\n$$ {last} $$\n"
        )
    };
    let power = |sign: &str| {
        format!(
            "\\bm\\omega\\cdot J\\dot{{\\bm\\omega}} = -c\\,\\bm s\\cdot\\bm\\omega {sign} d\\,\\bm\\omega\\cdot\\bm\\omega"
        )
    };
    assert_eq!(verdicts(&text(&power("-"))), "pap");
    assert_eq!(verdicts(&text(&power("+"))).get(..2), Some("pa"));
    assert_ne!(verdicts(&text(&power("+"))), "pap");
}

#[test]
fn a_law_for_the_rate_of_a_vector_leaves_its_components_to_be_said() {
    let text = r"The theorem is $\vec M = \dot{\vec D} + \vec\omega\times\vec D$. On principal axes

$$ D_1 = I_1\omega_1,\quad D_2 = I_2\omega_2, \quad D_3 = I_3\omega_3 $$

$$ M_1 = I_1\dot\omega_1 - (I_2 - I_3)\omega_2\omega_3 $$

$$ M_1 = I_1\dot\omega_1 + (I_2 - I_3)\omega_2\omega_3 $$
";
    assert_eq!(verdicts(text), "aaaapr");
}

#[test]
fn the_point_that_a_quantity_is_taken_about_is_not_what_is_named() {
    let text = |sign: &str| {
        format!(
            r"The angular momentum about the mass centre is called $\vec D$. Let the moment of the applied forces be $\vec N$.

$$ \vec N = \dot{{\vec D}} {sign} \vec\omega\times\vec D $$
"
        )
    };
    assert_eq!(verdicts(&text("+")), "p");
    assert_eq!(verdicts(&text("-")), "r");
}

#[test]
fn words_put_a_letter_for_another() {
    let text = |words: &str, moment: &str| {
        verdicts(&format!(
            "Principal axes. {words}\n\n$$ L_3 = {moment} n $$\n"
        ))
    };
    for words in [
        "If we write $n$ for $\\omega_3$,",
        "We write $n$ for the spin $\\omega_3$.",
        "Let $n$ stand for $\\omega_3$.",
        "Denote $\\omega_3$ by $n$.",
    ] {
        assert_eq!(text(words, "I_3"), "p", "{words}");
        assert_eq!(text(words, "I_2"), "r", "{words}");
    }
    assert_eq!(text("A wheel is known by $n$ and $\\omega_3$.", "I_2"), "u");
}

#[test]
fn a_letter_may_name_what_does_not_change() {
    let text = |kept: &str, last: &str| {
        verdicts(&format!(
            "No torque acts, and the kinetic energy is $T$. Let $A$, $B$, $C$ be the principal moments of inertia and $p$, $q$, $r$ the components of \
             the angular velocity.\n\n$$ Ap^2 + Bq^2 + Cr^2 = 2T $$\n\n$$ {kept} = G^2 $$\n\nEliminating $p$\n\n$$ r^2 = \
             \\frac{{{last}}}{{C(C - A)}} $$\n"
        ))
    };
    let kept = "A^2p^2 + B^2q^2 + C^2r^2";
    assert_eq!(text(kept, "G^2 - 2TA - B(B - A)q^2"), "pap");
    assert_eq!(text(kept, "G^2 - 2TA + B(B - A)q^2"), "par");
    assert!(text("A^2p^2 + B^2q^2 - C^2r^2", "0").starts_with("pu"));
}
