//! What `derive` prints is proved by `check`, for every body, axes, component and form.

use polhode::notation::{document::Format, read};
use polhode::report::derive::{Axes, Body, Component, Derivation, DeriveOptions, derive};
use polhode::verify::{Report, Role, check};

const BODIES: [Body; 5] = [
    Body::Full,
    Body::OnePlane,
    Body::Principal,
    Body::Axisymmetric,
    Body::Sphere,
];

fn every_option() -> impl Iterator<Item = DeriveOptions> {
    let components = [Component::All, Component::X, Component::Y, Component::Z];
    components.into_iter().flat_map(|component| {
        BODIES.into_iter().flat_map(move |body| {
            [Axes::Body, Axes::Turning].map(|axes| DeriveOptions {
                component,
                body,
                axes,
            })
        })
    })
}

fn checked(text: &str, format: Format, about: &str) -> Report {
    let (document, findings) = read("derived", text, format);
    assert!(findings.is_empty(), "{about}: {findings:?}");
    let report = check(&document);
    for finding in &report.findings {
        let expected = match finding.role {
            Role::Assume => "accepted",
            _ => "proved",
        };
        assert_eq!(
            finding.verdict.name(),
            expected,
            "{about}: {}\n{text}",
            finding.source
        );
    }
    report
}

fn proved(report: &Report) -> usize {
    report.summary().proved
}

fn assert_proved(print: impl Fn(&Derivation) -> String, format: Format) {
    for options in every_option() {
        let text = print(&derive(&options));
        let report = checked(&text, format, &format!("{options:?}"));
        // The law, the transport theorem, L = I ω and its three components; of each component asked for three more.
        let components = if options.component == Component::All {
            3
        } else {
            1
        };
        assert!(proved(&report) >= 6 + 3 * components, "{text}");
    }
}

#[test]
fn markdown_is_proved() {
    assert_proved(Derivation::markdown, Format::Markdown);
}

#[test]
fn latex_is_proved() {
    assert_proved(Derivation::latex, Format::Latex);
}

#[test]
fn unicode_is_proved() {
    assert_proved(Derivation::unicode, Format::Text);
}

#[test]
fn json_holds_the_same_lines() {
    for options in every_option() {
        let derivation = derive(&options);
        let json = derivation.json().expect("strings serialise");
        let page: serde_json::Value = serde_json::from_str(&json).expect("valid JSON");
        assert_eq!(page["schema"], "polhode-derive/1");
        let blocks = page["blocks"].as_array().expect("a list");
        let lines: Vec<_> = blocks
            .iter()
            .filter_map(|b| b["lines"].as_array())
            .flatten()
            .collect();
        let unicode = derivation.unicode();
        assert!(lines.len() >= 9);
        for line in lines {
            assert!(unicode.contains(line["unicode"].as_str().expect("a string")));
        }
    }
}

/// The end of the road, as every textbook has it.
#[test]
fn the_last_line_is_eulers() {
    let page = derive(&DeriveOptions::default()).markdown();
    let last =
        "\\Sigma M_z &= I_{zz} \\dot{\\omega}_z + (I_{yy} - I_{xx}) \\omega_x \\omega_y \\tag{18}";
    assert!(page.contains(last), "{page}");
}
