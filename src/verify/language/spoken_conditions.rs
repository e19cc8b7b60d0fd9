//! Words by which running text puts a condition on the formula that stands in its sentence.

use crate::notation::document::{Formula, Item};

/// Words that begin a condition.
const IF: [&str; 6] = ["if", "when", "whenever", "provided", "suppose", "supposing"];

/// What is said of an instant, a position or a case.
const WHERE: [&str; 26] = [
    "at rest",
    "at equilibrium",
    "in equilibrium",
    "at the instant",
    "at the moment",
    "at the start",
    "at the beginning",
    "at the end",
    "at the top",
    "at the bottom",
    "at the lowest",
    "at the highest",
    "at time",
    "initially",
    "finally",
    "in the limit",
    "in the case",
    "in the special case",
    "in the initial",
    "in the final",
    "in the horizontal",
    "in the vertical",
    "in the upright",
    "in steady",
    "for small",
    "for the case",
];

/// Behind these words a condition says what the writer does: "if we take the moments about O".
const WRITERS: [&str; 4] = ["i", "we", "you", "one"];

/// The condition that a sentence puts, from the word that begins it. "when differentiating" says how, and not when.
fn condition_in(sentence: &str) -> Option<&str> {
    let starts = sentence
        .char_indices()
        .filter(|&(at, _)| !sentence[..at].ends_with(char::is_alphanumeric));
    let mut found = starts.filter_map(|(at, _)| {
        let rest = &sentence[at..];
        begins_condition(rest).then_some(rest.trim())
    });
    found.next()
}

fn begins_condition(rest: &str) -> bool {
    let mut words = rest.split_whitespace();
    let (first, second) = (words.next().unwrap_or_default(), words.next());
    let second = second.map(|word| word.trim_end_matches(','));
    let says_how = second.is_some_and(|word| {
        word.ends_with("ing") || WRITERS.iter().any(|one| word.eq_ignore_ascii_case(one))
    });
    let is = |word: &&str| first.eq_ignore_ascii_case(word);
    let place = |phrase: &&str| {
        let start = rest.get(..phrase.len());
        let ends = !rest[start.map_or(0, str::len)..].starts_with(char::is_alphanumeric);
        start.is_some_and(|start| start.eq_ignore_ascii_case(phrase)) && ends
    };
    IF.iter().any(is) && !says_how || WHERE.iter().any(place)
}

/// What ends a sentence.
const STOPS: [char; 4] = ['.', '!', '?', ';'];

/// Of a longer sentence only the end is kept.
const LONGEST: usize = 400;

/// The sentence of the text that is under way.
#[derive(Default)]
pub(crate) struct Lead {
    words: String,
}

impl Lead {
    /// Goes on past an item.
    pub(crate) fn pass(&mut self, item: &Item) {
        match item {
            Item::Prose { text, .. } => self.add(text),
            // A formula set apart ends what leads to the next one, as often as not.
            Item::Formula(Formula { display: true, .. }) | Item::Heading { .. } => {
                self.words.clear();
            }
            // "At rest", and the formula in a paragraph of its own.
            Item::Break if self.words.trim_end().ends_with(STOPS) => self.words.clear(),
            Item::Break => self.words.push(' '),
            Item::Formula(_) => self.words.push('…'),
            Item::Comment { .. } => {}
        }
        self.keep_the_end();
    }

    fn add(&mut self, text: &str) {
        let ends = text.match_indices(STOPS);
        let mut ends =
            ends.filter(|(at, stop)| text[at + stop.len()..].starts_with(char::is_whitespace));
        match ends.next_back() {
            None => self.words.push_str(text),
            Some((at, stop)) => text[at + stop.len()..].clone_into(&mut self.words),
        }
    }

    fn keep_the_end(&mut self) {
        let over = self.words.len().saturating_sub(LONGEST);
        let cut = (over..).find(|&at| self.words.is_char_boundary(at));
        self.words.drain(..cut.unwrap_or(over));
    }

    /// The condition that it puts on what follows.
    pub(crate) fn condition(&self) -> Option<&str> {
        condition_in(&self.words)
    }
}
