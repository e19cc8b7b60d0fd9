//! Values in numbers that false lines show, where later lines go on with them.

use crate::notation::ast::{Kind, Line, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::symbols;
use crate::verify::reason::FALSE_VALUE;
use crate::verify::verdict::{Finding, Verdict};
use num_rational::BigRational;

/// The digits that a value must have to be known again.
const TELLING: usize = 3;

impl Checker<'_> {
    /// Leaves a value open that is worked out, though rightly, from one that a false line shows.
    pub(crate) fn withhold_false_value(&self, line: &Line, finding: &mut Finding) {
        let inside = &line.sides[..line.sides.len().saturating_sub(1)];
        let digits = inside.iter().filter(|side| symbols(side).is_empty());
        let numbers: Vec<&BigRational> = digits.flat_map(numbers).collect();
        let mut false_values = self.doubts.values.iter();
        if matches!(finding.verdict, Verdict::Proved(_))
            && false_values.any(|value| numbers.contains(&value))
        {
            finding.verdict = Verdict::Undecided;
            finding.reason = Some(FALSE_VALUE.to_owned());
        }
    }

    /// Keeps the value that a false line shows.
    pub(super) fn note_false_value(&mut self, line: &Line, finding: &Finding) {
        if finding.verdict == Verdict::Refuted
            && let Some(last) = line.sides.last()
            && let [value] = numbers(last).as_slice()
            && symbols(last).is_empty()
            && value.to_string().len() > TELLING
        {
            self.doubts.values.push((*value).clone());
        }
    }
}

/// The numbers that are written in a node.
fn numbers(node: &Node) -> Vec<&BigRational> {
    match &node.kind {
        Kind::Number(number) => vec![&number.value],
        _ => node.children().flat_map(numbers).collect(),
    }
}
