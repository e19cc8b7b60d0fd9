//! What is written twice, what is not found, and what stays open.

use crate::grade::matching::{Entry, Part};
use crate::grade::paper::Worth;
use crate::grade::result::Outcome;
use crate::grade::rules::{Decision, Goal, Marker, decision};
use crate::notation::document::Item;

/// Words by which a student takes back what stands before.
const SECOND_THOUGHTS: [&str; 12] = [
    "no",
    "wrong",
    "corrected",
    "correct",
    "correction",
    "mistake",
    "error",
    "sorry",
    "oops",
    "rather",
    "instead",
    "scratch",
];

impl Marker<'_> {
    /// A goal is written right and wrong.
    pub(super) fn contradicting(
        &mut self,
        goal: Goal,
        first: usize,
        last: usize,
        wrong: usize,
    ) -> Decision {
        if last > wrong && self.thinks_again(wrong, last) {
            return self.reached(goal, last);
        }
        if first < wrong && last < wrong && self.thinks_again(last, wrong) {
            return self.written_wrong(goal, wrong);
        }
        let (a, b) = (self.name(first.min(wrong)), self.name(first.max(wrong)));
        decision(
            Outcome::Human,
            Some(last),
            format!("{a} and {b} contradict each other"),
        )
    }

    /// Whether words between two lines take back the first.
    pub(super) fn thinks_again(&self, from: usize, to: usize) -> bool {
        let (from, to) = (&self.paper.lines[from], &self.paper.lines[to]);
        if from.document != to.document {
            return false;
        }
        let (start, end) = (
            from.found[self.stage].span.end,
            to.found[self.stage].span.start,
        );
        let items = self.paper.documents[from.document].items.iter();
        let mut words = items.filter_map(|item| match item {
            Item::Prose { text, span } if span.start >= start && span.end <= end => {
                Some(text.to_lowercase())
            }
            _ => None,
        });
        words.any(|text| {
            let mut words = text.split(|c: char| !c.is_alphabetic());
            words.any(|word| SECOND_THOUGHTS.contains(&word))
        })
    }

    /// No line that counts says a goal.
    pub(super) fn not_found(&mut self, part: &Part) -> Decision {
        for line in 0..self.paper.lines.len() {
            let worth = self.worth(line);
            let entry = self.entry(line).clone();
            if matches!(worth, Worth::Resting | Worth::Assumed) && self.board.says(&entry, part) {
                let name = self.name(line);
                let reason = match worth {
                    Worth::Assumed => format!("{name} assumes it"),
                    _ => format!("{name} rests on an assumption that was not asked for"),
                };
                return decision(Outcome::None, Some(line), reason);
            }
        }
        let defined = (0..self.paper.lines.len()).find(|&line| {
            self.worth(line) == Worth::Defined && self.board.defines_as(self.entry(line), part)
        });
        if let Some(line) = defined {
            return decision(
                Outcome::Human,
                Some(line),
                format!(
                    "{} defines a letter as what the key says of another; nothing tells whether they are the same",
                    self.name(line)
                ),
            );
        }
        match (0..self.paper.lines.len()).find(|&line| self.may_be(line, part)) {
            Some(line) => decision(
                Outcome::Human,
                Some(line),
                format!(
                    "{} may be it, and was not matched to the key",
                    self.name(line)
                ),
            ),
            None => decision(Outcome::None, None, "no line gives it"),
        }
    }

    /// Whether a line that was not matched speaks of the same.
    pub(super) fn may_be(&self, line: usize, part: &Part) -> bool {
        let worth = self.worth(line);
        if !matches!(worth, Worth::True | Worth::False) || !self.attempts[line].is_empty() {
            return false;
        }
        let Some(own) = &self.entry(line).parts else {
            return true;
        };
        let keys = self.board.key.iter().flat_map(Entry::components);
        let keys: Vec<&Part> = keys.collect();
        let matched = |own: &Part| keys.iter().any(|key| own.is_multiple_of(key));
        own.iter().any(|own| {
            let about = part
                .head
                .is_some_and(|head| own.residual.variables().contains(&head));
            (about || own.likeness(part).is_some()) && !matched(own)
        })
    }

    /// A goal that is not reached waits for a person while a line that may be it is open.
    pub(super) fn unless_open(&self, part: &Part, decided: Decision) -> Decision {
        if matches!(decided.outcome, Outcome::Full | Outcome::Human) {
            return decided;
        }
        let open = (0..self.paper.lines.len())
            .find(|&line| self.worth(line) == Worth::Open && self.concerns(line, part));
        match open {
            Some(line) => {
                let reason = &self.paper.lines[line].found[self.stage].reason;
                let unknown = "nothing tells what a letter in it is";
                let reason = reason.as_deref().unwrap_or(unknown);
                decision(
                    Outcome::Human,
                    Some(line),
                    format!("{} was not decided: {reason}", self.name(line)),
                )
            }
            None => decided,
        }
    }

    pub(super) fn concerns(&self, line: usize, part: &Part) -> bool {
        let entry = self.entry(line);
        let Some(parts) = &entry.parts else {
            return true;
        };
        let alike = |own: &Part| own.shares_variable(part) || own.likeness(part).is_some();
        entry.by_unknown || self.board.has_unknown(entry) || parts.iter().any(alike)
    }
}
