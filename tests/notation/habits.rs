//! What only the whole document can decide: decimal commas, letters above that name frames, rates written with δ.

use super::outline::{document, latex};
use polhode::notation::document::Format;
use polhode::notation::read;
use polhode::verify::{Verdict, check};

fn markdown(text: &str) -> String {
    document(text, Format::Markdown)
}

#[test]
fn a_comma_in_braces_shows_what_all_commas_part() {
    assert_eq!(
        markdown(r"$I_{xx} = 2{,}5\,\mathrm{kg\,m^2}$ und $I_{yy} = 3,75 + 0,125\cdot 10^{-3}$"),
        "I_xx = (unit 5/2:1 \"kg m^2\")\nI_yy = (+ 15/4:2 1/8000:3e-3)"
            .replace("1/8000:3e-3", &latex(r"0.125\cdot 10^{-3}"))
    );
}

#[test]
fn lists_stay_lists_in_a_document_with_decimal_commas() {
    assert_eq!(
        markdown(
            r"$a = 2{,}5$, $\vec\omega = (1,2,3)$, $\vec v = (a, b)$, $\vec r = (2,5)$, $I_{1,2} = 0$, $c_i = 0, i = 1,2$"
        ),
        "a = 5/2:1\nvec:omega = (tuple 1 2 3)\nvec:v = (tuple a b)\nvec:r = (tuple 2 5)\nI_1_2 = 0\nc_i = 0 {i: 1 2}"
    );
}

#[test]
fn several_commas_decide_and_one_does_not() {
    assert_eq!(
        markdown("$a = 2,5$ und $b = 3,75$"),
        "a = 5/2:1\nb = 15/4:2"
    );
    assert!(markdown("$a = 2,5$").contains("a comma between digits"));
    // Groups of thousands look alike.
    assert!(markdown("$a = 2,500$ and $b = 3,750$").contains("a comma between digits"));
    // A point shows that the comma is something else.
    assert!(markdown("$a = 2,5$, $b = 3,75$, $c = 1.5$").contains("a comma between digits"));
}

#[test]
fn all_formats_read_decimal_commas() {
    let text = "I_x = 2,5 kg m^2\nI_y = 3,5 kg m^2\n";
    assert_eq!(
        document(text, Format::Text),
        "I_x = (unit 5/2:1 \"kg m^2\")\nI_y = (unit 7/2:1 \"kg m^2\")"
    );
    let tex = r"\[ a = 2{,}5 \] und \[ b = 3,5 \]";
    assert_eq!(document(tex, Format::Latex), "a = 5/2:1\nb = 7/2:1");
    let cells = r#"{"cells": [{"cell_type": "markdown", "source": ["$a = 2{,}5$"]},
                              {"cell_type": "markdown", "source": ["$b = 3,5$"]}]}"#;
    assert_eq!(document(cells, Format::Notebook), "a = 5/2:1\nb = 7/2:1");
}

#[test]
fn the_report_says_how_commas_were_read() {
    let said = |text: &str| {
        let (document, _) = read("a.md", text, Format::Markdown);
        let readings = check(&document).readings;
        readings.iter().any(|r| r.contains("decimal commas"))
    };
    assert!(said("$a = 2{,}5$"));
    assert!(!said("$a = 2.5$") && !said("$a = 2,5$"));
}

#[test]
fn letters_that_only_stand_above_name_frames() {
    let rows = markdown(
        r"$$\omega^b = R^T\omega^s$$ $$\dot L^b + \omega^b\times L^b = M^b$$ $$E = \omega^2, \quad v^n = r$$",
    );
    assert_eq!(
        rows,
        "omega^b = (* (T R) omega^s)\n(+ (dot L^b) (* omega^b × L^b)) = M^b\nE = (^ omega 2)\n(^ v n) = r"
    );
    // A letter that is used by itself may be a number.
    assert_eq!(
        markdown(r"$\omega^b = L^b$ and $b = 2$"),
        "(^ omega b) = (^ L b)\nb = 2"
    );
    assert_eq!(markdown(r"$\omega^b = 1$"), "(^ omega b) = 1");
}

#[test]
fn small_deltas_are_a_rate_where_nothing_is_varied() {
    let both = r"$$\frac{d\vec L}{dt} = \frac{\delta\vec L}{\delta t} + \vec\omega\times\vec L$$";
    assert_eq!(
        markdown(both),
        "(d/dt vec:L) = (+ (d/dt@' vec:L) (* vec:omega × vec:L))"
    );
    let framed = r"$$\left(\frac{\delta\vec L}{\delta t}\right)_{xyz} = \vec N$$";
    assert_eq!(markdown(framed), "(d/dt@xyz vec:L) = vec:N");
    let varied =
        r"In $\delta t$ the body turns by $\delta\theta$: $\omega = \frac{\delta\theta}{\delta t}$";
    assert!(markdown(varied).ends_with("omega = (d/dt@δ theta)"));
    let mean = r"$$\omega = \frac{\Delta\theta}{\Delta t}$$";
    assert_eq!(markdown(mean), "omega = (/ delta:theta delta:t)");
}

#[test]
fn the_transport_law_in_deltas_is_proved_and_its_slip_refuted() {
    let verdict = |sign: &str| {
        let text = format!(
            "The vector $\\vec L$ is the angular momentum, $\\vec\\omega$ the angular velocity of the body axes.\n\n\
             $$\\frac{{d\\vec L}}{{dt}} = \\frac{{\\delta\\vec L}}{{\\delta t}} {sign} \\vec\\omega\\times\\vec L$$\n"
        );
        let (document, _) = read("a.md", &text, Format::Markdown);
        check(&document).findings.remove(0).verdict
    };
    assert!(matches!(verdict("+"), Verdict::Proved(_)));
    assert!(matches!(verdict("-"), Verdict::Refuted));
}
