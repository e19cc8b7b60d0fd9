//! Inertia about two points: the law of parallel axes, whatever the points and the offset are called.

#[path = "outcome/verdicts.rs"]
mod outcome;

use outcome::verdicts;

/// The verdicts of lines that stand as displays behind an opening.
fn behind(opening: &str, lines: &[&str]) -> String {
    let displays: String = lines
        .iter()
        .map(|line| format!("\n\n$$\n{line}\n$$"))
        .collect();
    verdicts(&format!("{opening}{displays}\n"))
}

#[test]
fn components_are_shifted_by_coordinates_named_in_words() {
    let opening =
        "The centre of mass $S$ lies at $(p, q, s)$ in axes at the corner $A$; the mass is $M$.";
    let lines = [
        r"(J_{xx})_A = (J_{xx})_S + M(q^2 + s^2)",
        r"(J_{yy})_A = (J_{yy})_S + M(p^2 + q^2)",
        r"J_{zz}^{A} = J_{zz}^{S} + M(p^2 + q^2)",
        r"J_{xy}^{A} = J_{xy}^{S} + M p q",
        r"J_{yz}^{A} = J_{yz}^{S} - M q s",
    ];
    assert_eq!(behind(opening, &lines), "prppr");
}

#[test]
fn the_convention_of_the_products_tells_their_sign() {
    let lines = [
        r"I_{xy}^O = I_{xy}^G + m\,x_G y_G",
        r"I_{xy}^O = I_{xy}^G - m\,x_G y_G",
    ];
    let entries =
        r"Here $I_{xy} = -\int xy\,dm$. Axes at $O$ are parallel to those at the mass centre $G$.";
    let integrals =
        r"Here $I_{xy} = \int xy\,dm$. Axes at $O$ are parallel to those at the mass centre $G$.";
    assert_eq!(behind(integrals, &lines), "ppr");
    assert_eq!(behind(entries, &lines), "prp");
}

#[test]
fn the_matrix_form_takes_the_vector_of_the_line() {
    let opening =
        r"Let $\mathbf c$ be the position of the mass centre $G$ relative to $P$ and $m$ the mass.";
    let lines = [
        r"\mathbf J_P = \mathbf J_G + m\left[(\mathbf c\cdot\mathbf c)\,\mathbf 1 - \mathbf c\,\mathbf c^T\right]",
        r"\mathbf J_G = \mathbf J_P - m\left[(\mathbf c\cdot\mathbf c)\,\mathbf 1 - \mathbf c\,\mathbf c^T\right]",
        r"\mathbf J_P = \mathbf J_G - m\,[\mathbf c]_\times^2",
        r"\mathbf J_P = \mathbf J_G + m\,[\mathbf c]_\times[\mathbf c]_\times^T",
        r"\mathbf J_P = \mathbf J_G + m\,[\mathbf c]_\times^2",
        r"\mathbf J_P = \mathbf J_G + m\left[(\mathbf c\cdot\mathbf c)\,\mathbf 1 + \mathbf c\,\mathbf c^T\right]",
    ];
    assert_eq!(behind(opening, &lines), "pppprr");
}

#[test]
fn one_moment_about_an_axis_is_shifted_by_the_distance() {
    let opening =
        r"The mass centre $G$ is at the distance $e$ from the hinge $O$; let $I_G = m k^2$.";
    let lines = [r"I_O = I_G + m e^2 = m(k^2 + e^2)", r"I_O = I_G - m e^2"];
    assert_eq!(behind(opening, &lines), "apr");
}

#[test]
fn momentum_and_energy_about_a_fixed_point_have_both_parts() {
    let opening = r"The body of mass $m$ turns about the fixed point $O$. The vector from $O$ to the mass centre $G$ is $\mathbf d$.";
    let lines = [
        r"\mathbf I_O = \mathbf I_G + m\left(\mathbf d^T\mathbf d\,\mathbf 1 - \mathbf d\mathbf d^T\right)",
        r"\mathbf L_G = \mathbf I_G\boldsymbol\omega",
        r"\mathbf v_G = \boldsymbol\omega\times\mathbf d",
        r"\mathbf L_O = \mathbf L_G + m\,\mathbf d\times\mathbf v_G",
        r"\mathbf L_O = \mathbf L_G - m\,\mathbf d\times\mathbf v_G",
        r"\mathbf L_O = \mathbf I_O\boldsymbol\omega",
        r"T = \tfrac12 m v_G^2 + \tfrac12\boldsymbol\omega\cdot\mathbf I_G\boldsymbol\omega = \tfrac12\boldsymbol\omega\cdot\mathbf I_O\boldsymbol\omega",
        r"T = \tfrac12 m v_G^2 + \tfrac12\boldsymbol\omega\cdot\mathbf I_O\boldsymbol\omega",
    ];
    assert_eq!(behind(opening, &lines), "pppprppr");
}

#[test]
fn a_bar_marks_the_mass_centre_and_a_component_left_unsaid_stays_open() {
    let opening = r"The centroid has the coordinates $(\bar x, \bar y, \bar z)$.";
    let lines = [
        r"I_{xx} = \bar I_{xx} + m(\bar y^2 + \bar z^2)",
        r"I_{xy} = \bar I_{xy} + m\,\bar x\bar y",
        r"I_{xx} = \bar I_{xx} + m(\bar x^2 + \bar z^2)",
    ];
    assert_eq!(behind(opening, &lines), "ppr");
    let told = r"The mass centre $G$ has the coordinates $(u, v, w)$. Given are $I_{xx}^G = j$ and $I_{xy}^G = 0$.";
    let lines = [
        r"I_{xx}^O = I_{xx}^G + m(v^2 + w^2)",
        r"I_{xy}^O = m u v",
        r"I_{xz}^O = m u w",
    ];
    assert_eq!(behind(told, &lines), "aappu");
}

#[test]
fn the_place_of_the_mass_centre_may_be_given_in_expressions() {
    let text = r"
A uniform lamina of mass $M$ has the sides $2p$ (along $x$) and $2q$ (along $y$). $C$ is its centre of mass and $A$ is a corner. The lamina lies in the plane $z=0$. The vector from $A$ to $C$ has the components $p$, $q$, $0$. Then

$$
\begin{aligned}
J_{xx}^A &= J_{xx}^C + Mq^2 \\
J_{zz}^A &= J_{zz}^C + M(p^2 + q^2) \\
J_{zz}^A &= J_{zz}^C + M(p + q)^2 \\
J_{xy}^A &= J_{xy}^C - Mpq
\end{aligned}
$$
";
    assert_eq!(verdicts(text), "apprr");
}

#[test]
fn the_mass_may_be_lost_beside_the_square_of_the_distance() {
    let text = r"A rod of mass $m$ and length $\ell$ has $I_G = \frac{1}{12}m\ell^2$ about its centre. The distance between the two parallel
axes is $d = \ell/2$. About the end it is

$$ I_A = I_G + d^2 $$

$$ I_A = I_G + m d^2 = \frac{1}{3}m\ell^2 $$
";
    assert_eq!(verdicts(text), "aarp");
}

#[test]
fn a_case_is_named_before_what_one_finds_for_it() {
    let text = |last: &str| {
        format!(
            "Let $G$ be the mass centre of a body of mass $m$, and let $O$ be another point. The vector from $O$ to $G$ is\n\n\
             $$ \\mathbf{{d}} = a\\,\\mathbf{{i}} + b\\,\\mathbf{{j}} + c\\,\\mathbf{{k}} $$\n\n\
             Then\n\n\
             $$ I_{{xx}}^O = I_{{xx}}^G + m\\,(b^2 + c^2), \\qquad I_{{yy}}^O = I_{{yy}}^G + m\\,(c^2 + a^2) $$\n\n\
             For the end of the rod, $a = \\ell/2$ and $b = c = 0$, one finds\n\n\
             $$ I_{{yy}}^O = I_{{yy}}^G + {last}\\,m\\ell^2 $$\n"
        )
    };
    assert_eq!(verdicts(&text("\\frac14")), "aaaaap");
    assert!(!verdicts(&text("\\frac12")).ends_with(['p', 'a']));
}

#[test]
fn away_from_an_axis_through_the_centre_a_moment_grows() {
    let last = |words: &str, line: &str| {
        let text = format!(
            "A hoop has the mass $m = 2$ and the radius $a = 3$; $b = 1$. {words}\n\n$$ {line} $$\n"
        );
        verdicts(&text).chars().last()
    };
    let out = "Its moment of inertia about a diameter is $\\frac12 ma^2$. About a parallel axis at the distance $b$ it is, by Steiner's theorem,";
    assert_eq!(last(out, r"J = \frac12 ma^2 + mb^2"), Some('a'));
    assert_eq!(last(out, r"J = \frac12 ma^2 - mb^2"), Some('r'));
    let back =
        "The moment about a hinge is $Q$, so by the parallel-axis theorem that about the centre is";
    assert_eq!(last(back, "J = Q - m b^2"), Some('a'));
    assert_eq!(last(back, "J = Q + m b^2"), Some('u'));
}

#[test]
fn numbers_about_one_point_give_those_about_another() {
    let text = |moment: &str| {
        verdicts(&format!(
            "The link has the total mass $M = 3 + 2 = 5$. The products of inertia are positive integrals, $P_{{xz}} = \\int xz\\,dm$, and\n\n\
             $$ I_{{xx}} = 2\\cdot 0.15^2 = 0.045 $$\n\n$$ P_{{xz}} = 2\\cdot 0.6\\cdot 0.15 = 0.18 $$\n\n\
             The centre of mass is at\n\n$$ \\mathbf{{d}} = (0.42,\\ 0,\\ 0.06) $$\n\nThe theorem is\n\n\
             $$ \\mathbf{{I}}_O = \\mathbf{{I}}_C + M\\left(d^2\\,\\mathbf{{E}} - \\mathbf{{d}}\\,\\mathbf{{d}}^T\\right) $$\n\n\
             so that\n\n$$ I_{{xx}}^C = {moment} $$\n"
        ))
    };
    assert_eq!(text("0.045 - 5\\cdot 0.06^2 = 0.027"), "paaaapp");
    assert_eq!(text("0.045 + 5\\cdot 0.06^2 = 0.063"), "paaaapu");
}

#[test]
fn a_trace_is_that_of_a_tensor() {
    let text = |times: &str| {
        verdicts(&format!(
            "For the tensor about the mass centre $G$ and about a point $O$ with $\\vec{{OG}} = (a, b, c)$ and the mass $m$:\n\n\
             $$ I^O_{{xx}} = I^G_{{xx}} + m(b^2 + c^2) $$\n\n\
             $$ \\operatorname{{tr}} I^O = \\operatorname{{tr}} I^G + {times}m(a^2 + b^2 + c^2) $$\n"
        ))
    };
    assert!(text("2").ends_with("pp"));
    assert!(text("").ends_with("pr"));
}

#[test]
fn a_display_behind_named_tensors_is_a_claim() {
    let text = |sign: &str| {
        verdicts(&format!(
            "Let $\\mathbf I_G$ be the inertia matrix about the mass centre and $\\mathbf I_O$ that about $O$, with $\\mathbf d$ \
             from $O$ to $G$:\n\n$$ \\mathbf I_O = \\mathbf I_G {sign} m[\\mathbf d]_\\times^2 $$\n"
        ))
    };
    assert_eq!(text("-"), "p");
    assert_eq!(text("+"), "r");
}

#[test]
fn the_tensor_about_the_mass_centre_may_have_a_letter_of_its_own() {
    let text = |product: &str, moment: &str| {
        verdicts(&format!(
            "Let $I_{{xx}}, I_{{xy}}, \\dots$ be the moments and products of inertia about the point $O$, and $J_{{xx}}, J_{{xy}}, \
             \\dots$ those about the mass centre $G$, which has the coordinates $(a, b, c)$. $I_{{xy}} = \\int xy\\,dm$. With the \
             mass $m$\n\n$$ I_{{xx}} = J_{{xx}} + m({moment}) $$\n\n$$ I_{{xy}} = J_{{xy}} {product} mab $$\n"
        ))
    };
    assert_eq!(text("+", "b^2 + c^2"), "ppp");
    assert_eq!(text("-", "b^2 + c^2"), "ppr");
    assert_eq!(text("+", "a^2 + c^2"), "prp");
}
