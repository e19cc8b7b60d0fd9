//! Lines in numbers: true to the digits shown, false in one of them, or not to be told.

use polhode::notation::{document::Format, read};
use polhode::verify::{Finding, check};

fn findings(text: &str) -> Vec<Finding> {
    let (document, _) = read("numbers.md", text, Format::Markdown);
    check(&document).findings
}

/// The verdicts of a document's lines.
fn verdicts(text: &str) -> Vec<&'static str> {
    findings(text).iter().map(|f| f.verdict.name()).collect()
}

/// The verdict of one displayed line behind an opening.
fn verdict(opening: &str, line: &str) -> &'static str {
    let text = format!("{opening}\n\nWe find\n\n$$\n{line}\n$$\n");
    let found = findings(&text);
    found.last().map_or("nothing", |f| f.verdict.name())
}

#[test]
fn numerals_hold_to_the_digits_shown_and_not_beyond() {
    let cases = [
        (r"\sqrt{2^2 + 6^2 + 12^2} = 13.56", "proved"),
        (r"\sqrt{2^2 + 6^2 + 12^2} = 13.57", "refuted"),
        (r"\sqrt{2^2 + 6^2 + 12^2} = 13.5", "undecided"),
        (r"\sqrt{2^2 + 6^2 + 12^2} = 13.6", "proved"),
        (r"\sqrt{2^2 + 6^2 + 12^2} = 14", "proved"),
        (r"\sqrt{2^2 + 6^2 + 12^2} = 15", "refuted"),
        (r"\frac{2\pi\,(1200)}{60} = 125.7", "proved"),
        (r"\frac{2\pi\,(1200)}{60} = 40\pi", "proved"),
        (r"\frac{2\pi\,(1200)}{60} = 41\pi", "refuted"),
        (r"(0.012)(125.7)^2 = 189.6\ \text{N}\cdot\text{m}", "proved"),
        (
            r"(0.012)(125.7)^2 = 198.6\ \text{N}\cdot\text{m}",
            "refuted",
        ),
        (r"(0.012)(125.7)^2 = -189.6", "refuted"),
        (r"2 + 12 + 36 = 50", "proved"),
        (r"2 + 12 + 36 = 51", "refuted"),
        (r"\frac{7}{2} = 4", "refuted"),
        (r"\frac{7}{2} \approx 4", "proved"),
        (r"\frac{7}{2} \simeq 5", "refuted"),
        (r"\frac{1}{3} = 0.333", "proved"),
        (r"\frac{1}{3} = 0.334", "refuted"),
        (r"\frac{2}{3}\times 10^{-3} = 6.67\times 10^{-4}", "proved"),
        (r"\frac{2}{3}\times 10^{-3} = 6.67\times 10^{-5}", "refuted"),
        (r"\sin 30^\circ = \tfrac12", "proved"),
        (r"\cos 45^\circ = 0.707", "proved"),
        (r"\cos 45^\circ = \frac{\sqrt 2}{2}", "proved"),
        (r"\cos 36^\circ = 0.809", "proved"),
        (r"\cos 36^\circ = 0.808", "refuted"),
        (
            r"\begin{bmatrix} 2/3 \\ -1/4 \\ 0 \end{bmatrix} = \begin{bmatrix} 0.6667 \\ -0.25 \\ 0 \end{bmatrix}",
            "proved",
        ),
        (
            r"\begin{bmatrix} 2/3 \\ -1/4 \\ 0 \end{bmatrix} = \begin{bmatrix} 0.6667 \\ 0.25 \\ 0 \end{bmatrix}",
            "refuted",
        ),
    ];
    for (line, expected) in cases {
        assert_eq!(verdict("Some arithmetic.", line), expected, "{line}");
    }
}

#[test]
fn results_from_exact_and_from_rounded_values_are_both_right() {
    let opening = "Given $I_{xz} = 0.012\\ \\text{kg m}^2$ and the speed\n\n\
        $$\n\\omega = \\frac{2\\pi(1200)}{60} = 125.7\\ \\text{rad/s}\n$$\n";
    let cases = [
        (
            r"I_{xz}\,\omega^2 = (0.012)(125.7)^2 = 189.6\ \text{N m}",
            "proved",
        ),
        (r"I_{xz}\,\omega^2 = 189.6\ \text{N m}", "proved"),
        (r"I_{xz}\,\omega^2 = 189.5\ \text{N m}", "proved"),
        (r"I_{xz}\,\omega^2 = 189.7\ \text{N m}", "refuted"),
        (
            r"I_{xz}\,\omega = (0.012)(125.7)^2 = 189.6\ \text{N m}",
            "refuted",
        ),
        (r"I_{xz}\,\omega^2 = 18.95\ \text{N m}", "refuted"),
    ];
    for (line, expected) in cases {
        assert_eq!(verdict(opening, line), expected, "{line}");
    }
}

#[test]
fn units_are_converted_where_a_line_changes_them() {
    let cases = [
        (r"1200\ \text{rev/min} = 125.7\ \text{rad/s}", "proved"),
        (r"1200\ \text{rpm} = 1257\ \text{rad/s}", "refuted"),
        (r"250\ \text{mm} = 0.25\ \text{m}", "proved"),
        (r"250\ \text{mm} = 2.5\ \text{m}", "refuted"),
        (r"\SI{1.5}{kN} = \SI{1500}{N}", "proved"),
        (r"\SI{90}{\degree} = \SI{1.571}{rad}", "proved"),
        (
            r"(20\ \text{N})(250\ \text{mm}) = 5.0\ \text{N m}",
            "proved",
        ),
        (
            r"(20\ \text{N})(250\ \text{mm}) = 5000\ \text{N m}",
            "refuted",
        ),
        (
            r"\frac{(\num{2.0e-3})(300)^2}{2(0.25)}\,\si{N} = \SI{360}{N}",
            "proved",
        ),
        (
            r"\frac{(\num{2.0e-3})(300)^2}{2(0.25)}\,\si{N} = \SI{36.0}{N}",
            "refuted",
        ),
    ];
    for (line, expected) in cases {
        assert_eq!(verdict("Some units.", line), expected, "{line}");
    }
}

#[test]
fn a_value_at_an_instant_says_nothing_of_its_rate() {
    let text = "The axes are fixed in the body. Given are\n\n\
        $$J = \\begin{bmatrix} 2 & 0 & 0 \\\\ 0 & 3 & 0 \\\\ 0 & 0 & 4 \\end{bmatrix}$$\n\n\
        $$\\omega = \\begin{bmatrix} 1 \\\\ 2 \\\\ 3 \\end{bmatrix}$$\n\n\
        There is no torque. Then\n\n\
        $$\\dot\\omega = \\begin{bmatrix} -3 \\\\ 2 \\\\ -0.5 \\end{bmatrix}$$\n\n\
        $$\\dot\\omega = \\begin{bmatrix} -3 \\\\ -2 \\\\ -0.5 \\end{bmatrix}$$\n\n\
        $$\\frac{\\partial\\dot\\omega}{\\partial\\omega} = \\begin{bmatrix} 0 & -1.5 & -1 \\\\ 2 & 0 & 0.6667 \\\\ -0.5 & -0.25 & 0 \\end{bmatrix}$$\n\n\
        $$\\frac{\\partial\\dot\\omega}{\\partial\\omega} = \\begin{bmatrix} 0 & -1.5 & -1 \\\\ 2 & 0 & 0.6667 \\\\ -0.5 & -0.52 & 0 \\end{bmatrix}$$\n";
    assert_eq!(
        verdicts(text),
        [
            "accepted", "accepted", "proved", "refuted", "proved", "refuted"
        ]
    );
}

#[test]
fn every_proof_in_numbers_names_its_bounds() {
    let found = findings("We find\n\n$$\n\\sqrt{2} = 1.414\n$$\n");
    let polhode::verify::Verdict::Proved(proof) = &found[0].verdict else {
        panic!("not proved: {:?}", found[0].reason);
    };
    let bounds: Vec<_> = proof.arguments().iter().flat_map(|a| &a.bounds).collect();
    assert_eq!(bounds.len(), 1);
    assert!(found[0].remarks.iter().any(|r| r.contains("digits shown")));
}

#[test]
fn a_false_bound_is_not_believed() {
    let found = findings("We find\n\n$$\n\\sqrt{2} = 1.414\n$$\n");
    let polhode::verify::Verdict::Proved(proof) = &found[0].verdict else {
        panic!("not proved");
    };
    let mut argument = proof.arguments()[0].clone();
    let tenth = polhode::algebra::Rational::from((1, 100_000));
    argument.bounds[0].upper = tenth.clone();
    argument.bounds[0].lower = -tenth;
    assert!(argument.checked().is_err());
}

#[test]
fn numbers_that_nothing_gives_decide_nothing() {
    // Nothing says how large T is.
    let text = "We find\n\n$$\nI_{xz}\\,\\omega_x^2 = 189.6\n$$\n";
    assert_eq!(verdicts(text), ["undecided"]);
}

#[test]
fn terms_in_different_units_are_not_added() {
    let with = |mass: &str| {
        let text = r"A ball has the mass $m = 6\ \mathrm{kg}$ and the moment $I_c = 2.0\ \mathrm{kg\,m^2}$ about its centre, at the distance $d = 1.6\ \mathrm{m}$ from the axle. About the axle it is

$$ I_a = I_c + MASS d^2 = VALUE\ \mathrm{kg\,m^2} $$

and two of them have

$$ 2\cdot VALUE = TWICE\ \mathrm{kg\,m^2} $$
";
        let (value, twice) = if mass.is_empty() {
            ("4.56", "9.12")
        } else {
            ("17.36", "34.72")
        };
        let text = text.replace("MASS", mass).replace("VALUE", value);
        verdicts(&text.replace("TWICE", twice))
    };
    assert!(!with("m").contains(&"refuted"));
    assert!(
        with("").ends_with(&["refuted", "undecided"]),
        "{:?}",
        with("")
    );
}

#[test]
fn numbers_put_in_for_symbols_are_data() {
    let text = r"The ship turns on a circle:

$$ n = \frac{v}{R} = \frac{10}{100} = 0.1\ \text{rad/s} $$

$$ n = \frac{v}{R} = \frac{20}{100} = 0.2\ \text{rad/s} $$
";
    assert_eq!(verdicts(text), ["proved", "refuted"]);
    assert_eq!(verdicts(&text.replace("= 0.1", "= 0.3"))[0], "refuted");
}

#[test]
fn behind_a_sign_of_approximation_zeros_at_the_end_are_no_digits() {
    let text = |shown: &str| {
        let text = r"The arm is $a = 320$ and the force $b = 15.71$. So

$$ a b \approx SHOWN $$
";
        verdicts(&text.replace("SHOWN", shown)).pop()
    };
    assert_eq!(text("5030"), Some("proved"));
    assert_eq!(text("5000"), Some("proved"));
    assert_eq!(text("5040"), Some("refuted"));
    assert_eq!(text("5100"), Some("refuted"));
}

#[test]
fn a_rounded_multiple_of_a_symbol_is_decided() {
    let spin = "The body has $A = 2$ and $C = 3.1$, and spins at $r$. Let $\\lambda = \\frac{C - A}{A}\\,r$.";
    assert_eq!(verdict(spin, r"\lambda = 0.55\,r"), "proved");
    assert_eq!(verdict(spin, r"\lambda \approx 0.45\,r"), "refuted");
    assert_eq!(verdict(spin, r"\lambda^2 \approx 0.30\,r^2"), "proved");
    assert_eq!(verdict(spin, r"\sqrt{1.8}\,r \approx 1.34\,r"), "proved");
    let text = format!("{spin}\n\nWe find\n\n$$ \\lambda = 1.55\\,r $$\n");
    let found = findings(&text);
    let repair = found
        .last()
        .and_then(|f| f.diagnosis.as_ref()?.suggestion.clone());
    assert_eq!(repair.as_deref(), Some("\\lambda = 0.55\\,r"));
}

#[test]
fn a_rounded_multiple_of_a_quotient_is_decided() {
    let orbit =
        "The orbit has the rate $n$, and $\\nu = 1.2\\,n$. One swing takes $\\tau_p = 2\\pi/\\nu$.";
    assert_eq!(
        verdict(orbit, r"\tau_p \approx 0.83\,\frac{2\pi}{n}"),
        "proved"
    );
    assert_eq!(
        verdict(orbit, r"\tau_p \approx 1.2\,\frac{2\pi}{n}"),
        "refuted"
    );
}

#[test]
fn a_moment_in_numbers_waits_for_what_gives_it() {
    let wheel = "A wheel of moment $C$ about its axle spins at $s$ and is turned about the vertical at the rate $\\Omega$. \
                 The moment that must be applied has the size\n\n$$ M = C s\\Omega $$\n\n\
                 With $C = 0.2\\ \\mathrm{kg\\,m^2}$, $s = 30\\ \\mathrm{rad/s}$ and $\\Omega = 2\\ \\mathrm{rad/s}$:";
    assert_ne!(verdict(wheel, r"M = 12\ \mathrm{N\,m}"), "refuted");
}

/// The same, a letter for each.
fn initials(text: &str) -> String {
    verdicts(text).iter().map(|verdict| &verdict[..1]).collect()
}

#[test]
fn principal_moments_of_a_tensor_in_numbers_are_its_eigenvalues() {
    let text = |moments: &str| {
        format!(
            "The inertia matrix of a body is\n\n\
             $$ \\mathbf I = \\begin{{bmatrix}} 3 & -1 & 0 \\\\ -1 & 3 & 0 \\\\ 0 & 0 & 5 \\end{{bmatrix}} $$\n\n\
             The principal moments are\n\n$$ {moments} $$\n"
        )
    };
    assert_eq!(
        initials(&text("I_1 = 2, \\quad I_2 = 4, \\quad I_3 = 5")),
        "appp"
    );
    assert_eq!(
        initials(&text("I_1 = 2, \\quad I_2 = 3, \\quad I_3 = 5")),
        "aprp"
    );
    let roots = |first: &str| {
        text(&format!("\\lambda_1 = {first}")).replace("principal moments", "eigenvalues")
    };
    assert_eq!(initials(&roots("2")), "aa");
    assert!(!initials(&roots("3")).ends_with(['a', 'p']));
}

#[test]
fn what_gives_a_constant_torque_derives_nothing() {
    let text = |energy: &str| {
        format!(
            "A satellite turns about a fixed axis with the moment of inertia $I = 20$ kg m². A thruster gives the constant \
             torque $\\tau = 4$ N m.\n\n$$ \\alpha = \\frac{{\\tau}}{{I}} = 0.2\\ \\mathrm{{rad/s^2}} $$\n\n\
             At $\\omega = 2$ rad/s\n\n$$ T = \\tfrac12I\\omega^2 = {energy}\\ \\mathrm J $$\n"
        )
    };
    assert_eq!(initials(&text("40")), "aapap");
    assert_eq!(initials(&text("80")), "aapar");
}
