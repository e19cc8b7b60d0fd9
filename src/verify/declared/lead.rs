//! The words of running text that lead to a formula.

use crate::notation::document::{Formula, Item};
use crate::verify::declared::Rows;
use crate::verify::declared::cases::leave_open;
use crate::verify::language::messages::under_condition;
use crate::verify::language::spoken_conditions::condition_in;
use crate::verify::verdict::{Finding, Verdict};

/// Of a longer sentence only the end is kept.
const LONGEST: usize = 400;

/// The sentence of the text that is under way.
#[derive(Default)]
pub(super) struct Lead {
    words: String,
}

impl Lead {
    /// Goes on past an item.
    pub(super) fn pass(&mut self, item: &Item) {
        match item {
            Item::Prose { text, .. } => self.add(text),
            // A formula set apart ends what leads to the next one, as often as not.
            Item::Formula(Formula { display: true, .. }) | Item::Heading { .. } | Item::Break => {
                self.words.clear();
            }
            Item::Formula(_) => self.words.push('…'),
            Item::Comment { .. } => {}
        }
    }

    fn add(&mut self, text: &str) {
        let stops = ['.', '!', '?', ';'];
        let ends = text.match_indices(stops);
        let mut ends =
            ends.filter(|(at, stop)| text[at + stop.len()..].starts_with(char::is_whitespace));
        match ends.next_back() {
            None => self.words.push_str(text),
            Some((at, stop)) => text[at + stop.len()..].clone_into(&mut self.words),
        }
        while self.words.len() > LONGEST {
            self.words.remove(0);
        }
    }

    /// The condition that it puts on what follows.
    pub(super) fn condition(&self) -> Option<&str> {
        condition_in(&self.words)
    }
}

impl Rows<'_> {
    /// Leaves a false line open that holds under a condition of the text, of which the declarations don't speak.
    pub(super) fn doubt_under_condition(&self, finding: &mut Finding) {
        let Some(condition) = self.lead.condition() else {
            return;
        };
        let at = self.at(finding.span);
        let spoken_of = self
            .judgments
            .iter()
            .any(|own| own.judge.part.speaks_of(&at));
        if finding.verdict == Verdict::Refuted && !spoken_of {
            leave_open(finding);
            finding.reason = Some(under_condition(condition));
        }
    }
}
