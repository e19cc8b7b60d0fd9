//! Lines in numbers: the bounds of a proof, and the repair of a false line.

use polhode::notation::{document::Format, read};
use polhode::verify::{Finding, check};

fn findings(text: &str) -> Vec<Finding> {
    let (document, _) = read("numbers.md", text, Format::Markdown);
    check(&document).findings
}

/// The verdict of one displayed line behind an opening.
fn verdict(opening: &str, line: &str) -> &'static str {
    let text = format!("{opening}\n\nWe find\n\n$$\n{line}\n$$\n");
    let found = findings(&text);
    found.last().map_or("nothing", |f| f.verdict.name())
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

/// The sides of a line differ by less than half a unit of the last digit shown, by less than a unit, or by more.
#[test]
fn a_digit_may_be_rounded_and_is_not_cut_off() {
    for (line, found) in [
        ("125.74 = 125.7", "proved"),
        ("125.77 = 125.7", "undecided"),
        ("125.81 = 125.7", "refuted"),
        (r"0.002049 = 2.0\times 10^{-3}", "proved"),
        (r"0.00206 = 2.0\times 10^{-3}", "undecided"),
        (r"0.00211 = 2.0\times 10^{-3}", "refuted"),
        // 360 has two or three digits.
        ("360.4 = 360", "proved"),
        ("360.6 = 360", "undecided"),
        ("364.9 = 360", "undecided"),
        ("365.1 = 360", "refuted"),
        // 10 has one or two digits, and is not said of 5.
        ("9.6 = 10", "proved"),
        ("5.2 = 10", "undecided"),
        ("14.8 = 10", "undecided"),
        ("5 = 10", "refuted"),
        ("5.05 = 10", "refuted"),
        // 0 is exact.
        ("0.0001 = 0", "refuted"),
    ] {
        assert_eq!(verdict("", line), found, "{line}");
    }
}

#[test]
fn units_become_factors() {
    for (left, right) in [
        ("2 kg m^2", "2"),
        ("2 rad/s", "2"),
        ("45 rev/min", "4.712 rad/s"),
        ("45 rpm", "4.712 rad/s"),
        ("30 deg", "0.5236 rad"),
        ("30 deg/s", "0.5236 rad/s"),
        ("3000000 mm^2", "3 m^2"),
        ("2 kg.m^2", "2 kg m^2"),
        ("3000 N mm", "3 N m"),
        ("36 km/h", "10 m/s"),
        ("5 m s^{-1}", "18 km/h"),
        ("120 min^-1", "2 s^-1"),
        ("30000000 g·cm²", "3 kg m²"),
        // Of a unit that is not known nothing is made.
        ("2 furlong", "2"),
    ] {
        let side = |text: &str| match text.split_once(' ') {
            Some((number, unit)) => format!(r"{number}\ \text{{{unit}}}"),
            None => text.to_owned(),
        };
        let line = format!("{} = {}", side(left), side(right));
        assert_eq!(verdict("", &line), "proved", "{line}");
        let line = format!("{} = 2 \\cdot {}", side(left), side(right));
        assert_eq!(verdict("", &line), "refuted", "{line}");
    }
}

#[test]
fn units_have_dimensions() {
    for (units, found) in [
        (["N m s", "kg m^2/s"], "proved"),
        (["rad/s", "rad/s"], "proved"),
        (["kg m^2", "kg m"], "refuted"),
        (["N m", "N"], "refuted"),
        (["J", "W"], "refuted"),
        // Of these no dimensions are known.
        (["lb ft", "lb"], "proved"),
    ] {
        let [left, right] = units.map(|unit| format!(r"3\ \text{{{unit}}}"));
        assert_eq!(
            verdict("", &format!("{left} = {right}")),
            found,
            "{units:?}"
        );
    }
}
