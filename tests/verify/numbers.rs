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
