//! Lines that one edit makes false, where a premise, a letter or another reading would have carried them.

use super::{BODY, Format, Sheet, Source, check_declared, declarations, judged, read, sentences};

#[test]
fn a_distance_of_several_letters_changes_with_each_of_which_a_rate_is_written() {
    let said = r"N is an inertial frame.
O is a point fixed in N.
A is a frame that turns relative to N.
$\vec e$ is a unit vector fixed in A.
P lies at the distance $R+z$ from O along $\vec e$.
$\vec v$ is the velocity of P relative to N.
";
    let text = r"
$$ \vec v = \dot z\,\vec e + (R+z)\,\dot{\vec e} $$

$$ \vec v = (R+z)\,\dot{\vec e} $$

$$ \vec v\cdot\vec e = \dot z $$
";
    assert_eq!(judged(said, text), "prp");
    assert_eq!(
        judged(said, "\n$$ \\vec v = (R+z)\\,\\dot{\\vec e} $$\n"),
        "p"
    );
}

#[test]
fn what_is_assumed_tells_nothing_of_lines_before() {
    let said = format!("{BODY}Line 5 is assumed.\n");
    let with = |right: &str| {
        format!(
            r"
$$ \dot{{\vec L}}\cdot\vec s = {right}\vec M\cdot\vec s $$

Here $\vec s = 2\vec\omega$, and
$$ \vec M = 0 $$

$$ \dot{{\vec L}}\cdot\vec s = {right}\vec M\cdot\vec s $$
"
        )
    };
    assert_eq!(judged(&said, &with("")), "paap");
    assert_eq!(judged(&said, &with("-")), "raap");
}

#[test]
fn the_letter_d_of_a_place_is_no_differential() {
    let said = r"N is an inertial frame.
O is a point fixed in N and in B.
B is a frame fixed in the body.
$\hat\imath$, $\hat\jmath$, $\hat k$ are the axes of B.
U is placed from O by $d\hat\imath+e\hat k$.
V is placed from O by $-d\hat\imath-e\hat k$.
U and V are particles of mass $\mu$.
The body consists of U and V.
$K_{13}$ is entry (1, 3) of the inertia tensor of the body about O on B.
";
    let text = r"
$$ K_{13} = -2\mu\,d\,e $$

$$ K_{13} = -4\mu\,d\,e $$
";
    assert_eq!(judged(said, text), "pr");
}

#[test]
fn a_letter_d_before_a_constant_and_other_factors_is_no_differential() {
    let sentences = "\
N is an inertial frame.
B is a frame fixed in the body.
G is the mass centre of the body.
$\\omega$ is the angular velocity of B relative to N in components on B.
$J$ is the inertia tensor of the body about G in components on B.
$L$ is the angular momentum of the body about G relative to N in components on B.
";
    let text = r"
$$ L=J\omega $$
$$ L=J\omega+\omega\times(dJ\omega) $$
";
    assert_eq!(judged(sentences, text), "pu");
}

#[test]
fn a_line_that_is_false_of_axes_does_not_define_their_names() {
    let said = r"N is an inertial frame.
n, w, u are the axes of N.
F is a frame that turns relative to N about u by the angle $\alpha$.
a, b, u are the axes of F.
";
    let text = r"
$$ b = -\sin\alpha\,n + \cos\alpha\,w $$

$$ b = \sin\alpha\,n + \cos\alpha\,w $$
";
    assert_eq!(judged(said, text), "pu");
}

/// What puts each false line right: the name of the slip, and the line as it should stand.
#[test]
fn each_slip_in_a_component_is_named() {
    let said = format!(
        "{BODY}$p$, $q$, $r$ are the components of $\\vec\\omega$ on B.
$A$, $B$, $C$ are the principal moments of the body about G on B.
$M_x$, $M_y$, $M_z$ are the components of $\\vec M$ on B.
"
    );
    let slips = [
        (
            r"M_x = A p - (B - C)qr",
            "missing-dot",
            r"M_x = A \dot p - (B - C)qr",
        ),
        (
            r"M_x = A\dot p - (B - C)\dot q r",
            "extra-dot",
            r"M_x = A\dot p - (B - C)q r",
        ),
        (
            r"M_x = A\dot p - (C - B)qr",
            "sign",
            r"M_x = A\dot p + (C - B)qr",
        ),
        (
            r"M_x = A\dot p - (B + C)qr",
            "sign",
            r"M_x = A\dot p - (B - C)qr",
        ),
        (
            r"-M_x = A\dot p - (B - C)qr",
            "sign",
            r"M_x = A\dot p - (B - C)qr",
        ),
        (
            r"M_x = A\dot p - (B - C)qp",
            "symbol",
            r"M_x = A\dot p - (B - C)qr",
        ),
        (
            r"M_x = A\dot p - (B - A)qr",
            "symbol",
            r"M_x = A\dot p - (B - C)qr",
        ),
        (
            r"M_z = A\dot p - (B - C)qr",
            "index",
            r"M_x = A\dot p - (B - C)qr",
        ),
        (
            r"M_x = \frac{1}{2}A\dot p - (B - C)qr",
            "factor",
            r"M_x = A\dot p - (B - C)qr",
        ),
        (
            r"M_x = A\dot p + Cqr - Bqr + pq",
            "extra-term",
            r"M_x = A\dot p + Cqr - Bqr",
        ),
        // Moments of inertia never change: no dot was lost here.
        (
            r"M_x = A\dot p - (B - C)qr - q A",
            "extra-term",
            r"M_x = A\dot p - (B - C)qr",
        ),
    ];
    let text: String = slips
        .iter()
        .map(|(line, ..)| format!("$$ {line} $$\n"))
        .collect();
    let (document, _) = read("a document", &text, Format::Markdown);
    let sheet = Sheet {
        sentences: sentences(&said),
        source: Source::new("what is declared", said),
    };
    let report = check_declared(&document, &declarations(&document, &[sheet]));
    for (finding, (line, kind, right)) in report.findings.iter().zip(slips) {
        let diagnosis = finding.diagnosis.as_ref();
        let found = diagnosis.map(|d| (d.kind, d.suggestion.as_deref().unwrap_or_default()));
        assert_eq!(found, Some((kind, right)), "{line}");
    }
    assert_eq!(report.findings.len(), slips.len());
}
