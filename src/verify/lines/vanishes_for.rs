//! Conditions under which what stands before is zero: "it vanishes for ⟨tan 2θ = …⟩".

use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::theory::Premise;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::lowered;

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
        if !says_so(&self.sentence) {
            return false;
        }
        let Some(subject) = self.last_side.clone() else {
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
