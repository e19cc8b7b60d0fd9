//! What is false does not pass: under a brace, as a definition of what is defined elsewhere, by a bound that nothing
//! else has, and by a sentence that ended.

use super::{BODY, judged, verdicts};
use polhode::notation::{document::Format, read, sentences};
use polhode::source::Source;
use polhode::verify::{Sheet, check_declared, declarations};
use std::fmt::Write;

#[test]
fn a_brace_says_that_its_part_is_what_it_names() {
    let line = |name: &str| {
        format!(
            r"
It follows that

$$ \underbrace{{\mathbf J\vec\omega}}_{{{name}}} = \vec L $$
"
        )
    };
    assert_eq!(judged(BODY, &line(r"\vec L")), "p");
    assert_eq!(judged(BODY, &line(r"-\vec L")), "r");
    assert_eq!(judged(BODY, &line(r"\text{spin}")), "p");
    assert_eq!(judged(BODY, &line(r"q")), "p");
    assert_eq!(judged(BODY, &line(r"1")), "p");
}

#[test]
fn each_brace_on_a_line_is_asked_and_a_remark_is_not() {
    let line = |left: &str| format!("\nIt follows that\n\n$$ {left} = 2\\vec L $$\n");
    let brace = |name: &str, over: &str| {
        line(&format!(
            r"\underbrace{{\mathbf J\vec\omega}}_{{{name}}} + \overbrace{{\vec L}}^{{{over}}}"
        ))
    };
    assert_eq!(judged(BODY, &brace("1", r"\text{Euler}")), "p");
    assert_eq!(
        judged(BODY, &brace(r"= \vec L", r"\mathbf J\vec\omega")),
        "p"
    );
    assert_eq!(judged(BODY, &brace(r"= -\vec L", r"\vec L")), "r");
    assert_eq!(judged(BODY, &brace(r"\vec L", r"\vec M")), "r");
    let within = r"\underbrace{\vec L + \underbrace{\mathbf J\vec\omega}_{-\vec L}}_{2\vec L}";
    assert_eq!(judged(BODY, &line(within)), "r");
}

#[test]
fn a_new_letter_among_known_ones_is_not_defined_by_the_way() {
    let text = r"
We write the balance as

$$ \mathbf J\dot{\vec\omega} + \vec\omega\times\mathbf J\vec\Gamma = \vec M $$

and define the rest

$$ \vec s = \vec M - \vec\omega\times\vec L $$
";
    assert_eq!(judged(BODY, text), "ua");
}

#[test]
fn a_letter_that_a_line_is_said_to_define_is_defined_by_no_other() {
    let sentences = format!("{BODY}Line 4 defines $h$.\n");
    let text = r"
Here $h = \vec\omega\cdot\vec M$ stands.

$$ h = \vec\omega\cdot\vec L $$
";
    assert_eq!(judged(&sentences, text), "ua");
}

#[test]
fn a_sum_runs_as_far_as_the_sums_of_the_document_do() {
    let sentences = format!(
        "{BODY}The body consists of particles.\n$i$ numbers the particles.\n$m_i$ is the mass of particle $i$.\n$\\vec r_i$ is the position of particle $i$ from G.\n"
    );
    let with = |first: &str| {
        format!(
            r"
$$ \sum_{{i=1}}^{first} m_i\vec r_i = 0 $$

$$ \sum_{{i=1}}^n m_i\dot{{\vec r}}_i = 0 $$

$$ \sum_{{i=1}}^n m_i\ddot{{\vec r}}_i = 0 $$
"
        )
    };
    assert_eq!(judged(&sentences, &with("n")), "ppp");
    assert_eq!(judged(&sentences, &with("s")), "upp");
}

#[test]
fn a_full_stop_in_a_display_ends_the_sentence() {
    let text = r"
We define the rest

$$ \vec s = \vec M - \vec\omega\times\vec L. $$

Then come words $\vec\omega\cdot\vec s = \vec q\cdot\vec M$ and more.
";
    assert_eq!(judged(BODY, text), "au");
}

#[test]
fn a_model_that_grows_too_large_is_bounded_and_said() {
    let mut said = String::from(BODY);
    for k in 1..12 {
        let parent = match k {
            1 => "N".to_owned(),
            _ => format!("F{}", k - 1),
        };
        let _ = writeln!(said, "F{k} is a frame that turns relative to {parent}.");
    }
    said += "The axes of F11 are principal axes of the body.\n";
    let text =
        "\n$$ \\vec L = \\mathbf J\\vec\\omega $$\n\n$$ \\vec L = 2\\mathbf J\\vec\\omega $$\n";
    let (document, _) = read("a document", text, Format::Markdown);
    let sheet = Sheet {
        sentences: sentences(&said),
        source: Source::new("what is declared", &said),
    };
    let declared = declarations(&document, &[sheet]);
    assert!(declared.misunderstood.is_empty(), "{declared:?}");
    let report = check_declared(&document, &declared);
    let verdicts: Vec<_> = report.findings.iter().map(|f| f.verdict.name()).collect();
    // A proof stands; nothing is denied while a sentence is not in force.
    assert_eq!(verdicts, ["proved", "undecided"]);
    assert!(
        report.unused.iter().any(|unused| unused.beyond),
        "{report:?}"
    );
}

#[test]
fn of_several_letters_each_is_about_its_own_point() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
O is a point fixed in N.
$\\vec r$ is the position of G from O.
$\\vec p$ is the momentum of the body relative to N.
$\\vec L$ and $\\vec H$ are the angular momenta of the body about O and about G relative to N.
";
    let text = r"
$$ \vec L = \vec H + \vec r\times\vec p $$
$$ \vec L = \vec H $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn what_is_assumed_for_some_lines_ends_with_them() {
    let sentences = "N is an inertial frame.
P is a particle of mass $m$.
$\\vec p$ is the momentum of P relative to N.
$\\vec F$ is the total force on P.
On lines 2 and 3 line 2 is assumed.
";
    let text = r"
$$ \vec F = 0 $$
$$ \dot{\vec p} = 0 $$
$$ \dot{\vec p} = 0 $$
";
    assert_eq!(judged(sentences, text), "apr");
}

#[test]
fn labels_bound_what_is_said_of_the_lines_between_them() {
    let sentences = "N is an inertial frame.
P is a particle.
O is a point fixed in N.
$\\vec r$ is the position of P from O.
Between (1) and (2) $\\vec q$ is the velocity of P relative to N.
From (3) on $\\vec q$ is the acceleration of P relative to N.
";
    let text = r"
$$ \vec q = \dot{\vec r} \tag{1} $$
$$ \vec q = \ddot{\vec r} \tag{2} $$
$$ \vec q = \ddot{\vec r} \tag{3} $$
$$ \vec q = \dot{\vec r} $$
";
    assert_eq!(judged(sentences, text), "prpr");
}

#[test]
fn labels_that_the_document_lacks_leave_lines_open() {
    let sentences = "N is an inertial frame.
P is a particle.
O is a point fixed in N.
$\\vec r$ is the position of P from O.
Between (1) and (7) $\\vec q$ is the velocity of P relative to N.
";
    let text = r"
$$ \vec q = \dot{\vec r} \tag{1} $$
";
    assert_eq!(judged(sentences, text), "u");
}

#[test]
fn numbers_that_deny_a_line_obey_the_inequalities() {
    let sentences = "$a > b$
$b > 0$
$a$ is a constant.
$b$ is a constant.
";
    let text = r"
$$ \sqrt{(a - b)^2} = a - b $$
$$ \sqrt{(a - b)^2} = b - a $$
";
    let verdicts = judged(sentences, text);
    assert!(
        !verdicts.starts_with('r') && !verdicts.ends_with('p'),
        "{verdicts}"
    );
}

#[test]
fn a_frame_that_is_fixed_in_a_body_is_its_frame_whatever_else_is_said_of_it() {
    let sentences = "N is an inertial frame.
B, the body frame, is fixed in the body.
G is the mass centre of the body.
The axes of B are principal axes of the body.
No moment about G acts on the body.
$I_1$, $I_2$, $I_3$ are the principal moments of the body about G on B.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components on B of the angular velocity of B relative to N.
From line 3 to line 4 everything holds to first order in $\\omega_1$ and $\\omega_2$.
";
    let text = r"
$$ I_3\dot\omega_3 = (I_1 - I_2)\omega_1\omega_2 $$
$$ I_3\dot\omega_3 = 0 $$
$$ I_1\dot\omega_1 = (I_3 - I_2)\omega_2\omega_3 $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn they_are_not_the_thing_of_which_the_sentence_speaks() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
The body consists of particles, and $i$ numbers them.
O is a point fixed in N.
$m_i$ is the mass of particle $i$.
$\\vec r_i$ is the position of particle $i$ from O.
$\\vec L$ is the angular momentum of the body about O relative to N.
";
    let text = r"
$$ \vec L = \sum_i m_i\vec r_i\times\dot{\vec r}_i $$
$$ \vec L = -\sum_i m_i\vec r_i\times\dot{\vec r}_i $$
";
    assert_eq!(judged(sentences, text), "pr");
}

#[test]
fn a_sentence_that_is_not_understood_takes_nothing_back_of_what_others_tell() {
    let sentences = |last: &str| {
        format!(
            "N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of N.
$e_1$, $e_2$, $e_3$ are the axes of B.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\vec\\omega$ on B.
$\\vec u$ is a vector fixed in N.
{last}
"
        )
    };
    let text = r"
$$ \vec\omega\times\vec\omega = 0 $$
$$ \vec\omega = \omega_1 e_1 + \omega_2 e_2 + \omega_3 e_3 $$
$$ \omega_z = \vec\omega\cdot e_3 $$
$$ \vec\omega\times\vec\omega = \vec\omega $$
$$ \dot{\vec u} = 0 $$
$$ \vec v\times\vec v = 0 $$
";
    for (last, wanted) in [
        ("$\\vec\\omega$ blorps.", "ppuupp"),
        // The letter of which nothing else is told.
        ("$\\vec v$ blorps.", "ppuupu"),
        // What the letter and its label mean apart is not what both mean.
        ("$\\omega_z$ blorps.", "ppuupp"),
        // A rule for a sign holds what carries it.
        ("A dot on a vector blorps.", "pprrup"),
        ("Vectors blorp on every component.", "uuuuuu"),
        (
            "$\\vec u$ and every vector blorp on their components.",
            "uuuuuu",
        ),
        ("$\\vec u$ blorps, and a dot on a vector blurps.", "uuuuuu"),
        // For any labels, or in a part of the document, a letter may mean something else.
        (
            "$\\vec\\omega_{X/Y}$ blorps, for any frames X and Y.",
            "uuuupp",
        ),
        ("On lines 1 to 3 $\\vec\\omega$ blorps.", "uurrpp"),
    ] {
        let (found, misread) = verdicts(&sentences(last), text);
        assert_eq!((found.as_str(), misread.len()), (wanted, 1), "{last}");
    }
}

#[test]
fn a_label_that_names_an_axis_of_one_frame_is_a_component_on_it() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
x, y, z are the axes of N.
$\\phi$, $\\theta$, $\\psi$ are the Euler angles of B relative to N in the order z, x, z.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\vec\\omega$ on B.
";
    let text = r"
$$ \omega_3 = \dot\phi\cos\theta + \dot\psi $$
$$ \omega_z = \dot\psi\cos\theta + \dot\phi $$
$$ \omega_z = \omega_3 $$
";
    assert_eq!(judged(sentences, text), "ppr");
}

#[test]
fn what_is_declared_to_be_a_definition_may_fix_what_sentences_leave_free() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$e_1$, $e_2$, $e_3$ are the axes of B.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\vec\\omega$ on B.
Line 1 is a definition.
Line 4 is a definition.
";
    let text = r"$$ \vec\omega = \omega_1 e_1 $$
$$ \omega_2 = 0 $$
$$ \omega_1 = 0 $$
$$ \omega_1 + 1 = \omega_1 $$
";
    assert_eq!(judged(sentences, text), "aprr");
}

#[test]
fn everything_on_some_lines_is_no_more_than_that() {
    let sentences = format!("{BODY}On lines 1 to 2 everything is given.\n");
    let text = r"$$ \vec M = \dot{\vec L} $$
$$ \vec L = \mathbf J\vec\omega $$
$$ \vec M = 2\dot{\vec L} $$
$$ \vec M = \dot{\vec L} $$
";
    assert_eq!(judged(&sentences, text), "aarp");
}

#[test]
fn what_is_denied_is_no_fact() {
    let sentences = |last: &str| {
        format!(
            "N is an inertial frame.
B is a frame fixed in the top.
O is a point fixed in N and in B.
x, y, z are the axes of B.
$\\vec L$ is the angular momentum of the top about O relative to N.
$A$, $B$, $C$ are the moments of inertia of the top about the axes of B through O.
A dot means the rate seen from N.
{last}
"
        )
    };
    let text = r"
$$ \dot{\vec L} = 0 $$
$$ A = B $$
";
    for denied in [
        "$\\vec L$ is not constant.",
        "The top is not symmetric about z.",
    ] {
        let verdicts = judged(&sentences(denied), text);
        assert!(!verdicts.contains('p'), "{denied} {verdicts}");
    }
    assert_eq!(judged(&sentences(""), text), "rr");
}

#[test]
fn an_order_is_that_of_letters_with_a_meaning_there() {
    let sentences = |from: &str, lines: &str| {
        format!(
            "N is an inertial frame.
A is a frame that turns relative to N about z by the angle $\\varphi$.
From line {from} on $s$ is the rate of $\\varphi$.
{lines} hold to first order in $s$.
"
        )
    };
    let text = r"
$$ s^2 = 0 $$
$$ s^2 = 0 $$
";
    assert_eq!(judged(&sentences("2", "Lines 2 and 3"), text), "pp");
    // What the letter means on line 2 is not told.
    let verdicts = judged(&sentences("3", "Lines 2 and 3"), text);
    assert!(!verdicts.contains('r'), "{verdicts}");
}

#[test]
fn a_root_is_no_letter_whose_sign_is_open() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\omega_1$, $\\omega_2$, $\\omega_3$ are the components of $\\vec\\omega$ on B.
$w$ is the magnitude of $\\vec\\omega$.
";
    let text = r"
$$ \sqrt{\omega_3^2} = \omega_3 $$
$$ \sqrt{\omega_3^2} = |\omega_3| $$
$$ |\vec\omega| = w $$
$$ w \neq \sqrt{\omega_1^2 + \omega_2^2 + \omega_3^2} $$
";
    assert_eq!(judged(sentences, text), "uppr");
}

#[test]
fn a_sum_runs_as_far_as_it_says() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$e_1$, $e_2$, $e_3$ are the axes of B.
$i$, $j$ and $k$ number the axes of B.
O is a point fixed in N and in B.
$\\mathbf I$ is the inertia tensor of the body about O.
$I_{ij}$ are the entries of $\\mathbf I$ on B.
$L_i$ is the component $i$ on B of the angular momentum of the body about O relative to N.
$\\vec\\omega$ is the angular velocity of B relative to N.
$\\omega_i$ is the component $i$ of $\\vec\\omega$ on B.
";
    let text = r"
$$ \vec\omega = \sum_{i=1}^3 \omega_i e_i $$
$$ \vec\omega = \sum_{i=1}^2 \omega_i e_i $$
$$ \omega_1 e_1 + \omega_2 e_2 = \sum_{i=1}^2 \omega_i e_i $$
$$ L_1 = \sum_k I_{1k}\omega_k $$
$$ L_2 = \sum_k I_{1k}\omega_k $$
";
    assert_eq!(judged(sentences, text), "prppr");
    let particles = "N is an inertial frame.
The body consists of particles.
$k$ numbers the particles.
$m_k$ is the mass of particle $k$.
$M$ is the mass of the body.
";
    assert_eq!(judged(particles, "\n$$ M = \\sum_{k=1}^n m_k $$\n"), "p");
    for sum in ["\\sum_{k=1}^{n-1}", "\\sum_{k=2}^n", "\\sum_{k=1}^2"] {
        assert_eq!(judged(particles, &format!("\n$$ M = {sum} m_k $$\n")), "u");
    }
}

#[test]
fn a_label_of_which_nothing_is_said_is_no_power() {
    let sentences = "N is an inertial frame.\n$E$ is the identity matrix.\n";
    assert_eq!(judged(sentences, "\n$$ R_1^0 = 1 $$\n"), "u");
}

#[test]
fn a_shape_that_lacks_something_is_not_taken_for_the_whole() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
The body is a sphere minus a gribble.
$A$, $C$, $D$ are the principal moments of the body about G on B.
";
    let (found, misread) = verdicts(sentences, "\n$$ A = C $$\n");
    assert_eq!((found.as_str(), misread.len()), ("u", 1));
}

#[test]
fn nothing_is_denied_where_it_is_not_understood_what_a_line_is() {
    let sentences = |role: &str| {
        format!(
            "N is an inertial frame.
$a$, $b$ and $c$ are numbers.
{role}
"
        )
    };
    let text = "\n$$ a = b $$\n$$ c a = c b $$\n";
    assert_eq!(judged(&sentences("Line 2 is given."), text), "ap");
    let (found, misread) = verdicts(&sentences("Line 2 is given gribbly."), text);
    assert!(!found.contains('r'), "{found}");
    assert_eq!(misread.len(), 1);
}

#[test]
fn a_relation_of_cosines_alone_is_no_relation_that_may_be_left_out() {
    let said = "\
N is an inertial frame.
B turns relative to N about $z$ by the angle $\\alpha$.
A turns relative to N about $z$ by the angle $\\beta$.
$\\cos\\alpha = \\cos\\beta$.
";
    let text = "$$ 3\\cos\\alpha = 3\\cos\\beta $$\n\n$$ \\cos^2\\alpha = 1 - \\sin^2\\beta $$\n";
    assert!(!verdicts(said, text).0.contains('r'));
}

#[test]
fn a_name_of_several_signs_is_no_product() {
    let sentences = "\
N is an inertial frame.
A turns relative to N about z by the angle $\\alpha$.
B turns relative to A about z by the angle $\\beta$.
$td1$, $td2$ are the same as $\\dot\\alpha$, $\\dot\\beta$.
$w$ is the angular velocity of B relative to N along z.
";
    let text = r"
$$ w=3\dot\alpha $$
$$ w=\dot\alpha+\dot\beta $$
";
    let got = verdicts(sentences, text).0;
    assert!(!got.starts_with('p'), "{got}");
}

#[test]
fn a_line_that_defines_one_letter_does_not_define_another() {
    let said = format!("{BODY}Line 2 defines $\\vec s$.\n");
    let line = |formula: &str| format!("\nLet ${formula}$ and $\\vec s := 2 \\vec L$.\n");
    assert_eq!(judged(&said, &line(r"\vec L := \mathbf J\vec\omega")), "pa");
    assert_eq!(
        judged(&said, &line(r"\vec L := -\mathbf J\vec\omega")),
        "ra"
    );
}

#[test]
fn rows_go_on_from_a_first_row_without_a_relation() {
    let text = r"
$$ \vec L = \mathbf J\vec\omega $$

while

$$\begin{align*}
&\phantom{=}~\vec\omega\times\vec M\\
&=-\vec M\times\vec\omega\\
&=\vec M\times\vec\omega
\end{align*}$$
";
    assert_eq!(judged(BODY, text), "ppr");
}

#[test]
fn an_axis_whose_rate_is_written_is_not_kept() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$\\mathbf{n}$ is a unit vector.
$\\boldsymbol{\\omega}$ is the angular velocity of B relative to N.
B is turned relative to N about $\\mathbf{n}$ by the angle $\\theta$.
A dot on a vector means the rate seen from N.
";
    let kept = r"\boldsymbol{\omega} = \dot{\theta} \mathbf{n}";
    assert_eq!(judged(sentences, &format!("\n$$ {kept} $$\n")), "p");
    let rest = |sign: &str| {
        format!(
            r"\dot{{\mathbf n}}\sin\theta {sign} \mathbf n\times\dot{{\mathbf n}}(1-\cos\theta)"
        )
    };
    let text = format!(
        "\n$$ {kept} + {} $$\n$$ {kept} + {} $$\n",
        rest("+"),
        rest("-")
    );
    assert_eq!(verdicts(sentences, &text).0, "uu");
}

#[test]
fn a_frame_at_the_lower_left_is_the_one_of_the_components() {
    let sentences = "N is an inertial frame.
B is a frame fixed in the body.
$\\boldsymbol{\\omega}_{XY}$ is the angular velocity of Y relative to X, for any frames X and Y.
A frame at the lower left means components on that frame.
";
    let text = r"
$$ {}_B\boldsymbol{\omega}_{NB} = {}_B\boldsymbol{\omega}_{BN} $$
";
    assert_eq!(judged(sentences, text), "r");
}
