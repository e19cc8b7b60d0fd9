//! Conditions under which what stands before is zero: "it vanishes for ⟨tan 2θ = …⟩".

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::Premise;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};

const VANISHES: &[&str] = &[
    "vanishes",
    "vanish",
    "is zero",
    "disappears",
    "becomes zero",
];
const UNDER: &[&str] = &[
    "for",
    "if",
    "when",
    "at",
    "where",
    "provided",
    "provided that",
];

impl Checker<'_> {
    /// Checks that the last side before is zero if a line holds, where the words say so, and supposes the line then.
    pub(crate) fn vanishes_for(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let subject = match says_so(&self.sentence) {
            true => self.last_side.clone(),
            false => self
                .last_product
                .clone()
                .filter(|_| says_of_product(&self.sentence)),
        };
        let Some(subject) = subject else {
            return false;
        };
        let Ok(subject) = self.lowering(Frame::Moving).value(&subject) else {
            return false;
        };
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let name = self.line_name(finding);
        self.theory.assume(Premise {
            name: name.clone(),
            residuals: read.residuals().cloned().collect(),
            preferred: vec![],
            definition: false,
        });
        let zero = subject.map(|entry| entry.clone() - entry.clone());
        let equation = Equation {
            left: subject.clone(),
            right: zero,
            residual: subject,
        };
        match decide(&mut self.theory, &[equation]) {
            Decision::True(_) => {
                self.keep(&name, false);
                finding.role = Role::Assume;
                finding.verdict = Verdict::Accepted;
                finding
                    .remarks
                    .push("what stands before vanishes then".to_owned());
                return true;
            }
            Decision::False(witness) => {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("what stands before does not vanish then".to_owned());
                finding.counterexample = Some(*witness);
            }
            _ => {}
        }
        self.theory.retain(|premise| premise.name != name);
        finding.verdict == Verdict::Refuted
    }
}

impl Checker<'_> {
    /// Keeps the product of inertia that a line says most lately what it is.
    pub(crate) fn note_product(&mut self, sides: &[Node]) {
        let [left, _, ..] = sides else { return };
        if let Kind::Symbol(symbol) = &inner(left).kind
            && self.reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Inertia)
        {
            let index = symbol.subscripts.concat();
            let mut axes = index.chars().filter(char::is_ascii_alphabetic);
            if let (Some(a), Some(b), None) = (axes.next(), axes.next(), axes.next())
                && a != b
            {
                self.last_product = Some(left.clone());
            }
        }
    }
}

/// "The product of inertia vanishes on axes which are found from": words before a formula say of the product that was
/// spoken of last that it is zero then.
fn says_of_product(sentence: &str) -> bool {
    let text = lowered(sentence);
    let text = text.trim_end_matches([' ', '.', ':']);
    let determined = [
        "found from",
        "given by",
        "determined by",
        "follow from",
        "follows from",
    ];
    has_any(
        text,
        &["product of inertia", "product vanish", "product is zero"],
    ) && has_any(text, VANISHES)
        && determined
            .iter()
            .chain(UNDER)
            .any(|end| text.ends_with(end))
}

/// Whether the words behind the last formula say so of it.
fn says_so(sentence: &str) -> bool {
    let text = lowered(sentence.rsplit('⟩').next().unwrap_or_default());
    // A paragraph that ends there ends no sentence.
    let text = text.trim_end_matches([' ', '.', ':']);
    let first = text
        .split_whitespace()
        .find(|word| word.starts_with(char::is_alphabetic));
    let end = |text: &str| {
        UNDER
            .iter()
            .find_map(|word| Some(text.strip_suffix(word)?.trim_end().len()))
    };
    matches!(first, Some("it" | "this" | "which"))
        && end(text).is_some_and(|at| VANISHES.iter().any(|verb| text[..at].ends_with(verb)))
}
