//! Equations whose roots are looked for: "the moments are the roots of `(5 - λ)(2 - λ) - 4 = λ² - 7λ + 6 = 0`".

use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::decide::{Decision, decide};
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};

/// Words of a sentence that speaks of them.
const WORDS: &[&str] = &["roots", "root of", "characteristic", "eigenvalue"];

impl Checker<'_> {
    /// Settles an equation for a new symbol that its sentence calls a root: what the chain says before its zero is a
    /// claim, that it vanishes picks the symbol out.
    pub(crate) fn seeks_roots(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [before @ .., last] = sides else {
            return false;
        };
        let sentence = lowered(&self.sentence);
        let speaks = has_any(&sentence, WORDS);
        if !speaks || !is_zero(last) || self.unknown(sides).is_none() {
            return false;
        }
        if before.len() > 1 {
            let Ok(read) = self.read(before, Frame::Moving) else {
                return false;
            };
            if !matches!(decide(&mut self.theory, &read.equations), Decision::True(_)) {
                return false;
            }
        }
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Assume;
        finding.remarks.push("its roots are looked for".to_owned());
        true
    }
}
