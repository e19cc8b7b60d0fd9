//! Phrases that are looked for in a text all at once.

use aho_corasick::{AhoCorasick, AhoCorasickKind};

/// A text in lower case: the same as `str::to_lowercase`, and faster on a text that is Latin but for some signs.
pub(crate) fn lowered(text: &str) -> String {
    // Brackets, arrows and signs; no letter is among them.
    let sign = |c: char| matches!(c, '\u{2500}'..='\u{2bff}');
    match text.is_ascii() || text.chars().all(|c| c.is_ascii() || sign(c)) {
        true => text.to_ascii_lowercase(),
        false => text.to_lowercase(),
    }
}

/// Phrases, with the automaton that finds all of them in one pass (Aho and Corasick, Efficient string matching, 1975).
#[derive(Debug)]
pub(crate) struct Book {
    automaton: AhoCorasick,
}

impl Book {
    /// The book of some phrases.
    pub(crate) fn of<P: AsRef<[u8]>>(phrases: impl IntoIterator<Item = P>) -> Self {
        // A table of all transitions would be searched a little faster, and take five times as long to build.
        let automaton = AhoCorasick::builder()
            .kind(Some(AhoCorasickKind::ContiguousNFA))
            .prefilter(false)
            .build(phrases);
        Self {
            automaton: automaton.expect("a few hundred short phrases"),
        }
    }

    /// The book of phrases that stand as whole words in a text with single spaces around each word.
    pub(crate) fn of_words<'p>(phrases: impl IntoIterator<Item = &'p str>) -> Self {
        Self::of(phrases.into_iter().map(|phrase| format!(" {phrase} ")))
    }

    /// Whether one of the phrases stands in a text.
    pub(crate) fn is_in(&self, text: &str) -> bool {
        self.automaton.is_match(text)
    }

    /// Every place where a phrase stands: which it is, from where, to where.
    pub(crate) fn places(&self, text: &str) -> impl Iterator<Item = (usize, usize, usize)> {
        let found = self.automaton.find_overlapping_iter(text);
        found.map(|found| (found.pattern().as_usize(), found.start(), found.end()))
    }
}

/// Whether one of a few phrases stands in a text.
pub(crate) fn has_any<P: AsRef<str>>(text: &str, phrases: &[P]) -> bool {
    phrases.iter().any(|phrase| text.contains(phrase.as_ref()))
}
