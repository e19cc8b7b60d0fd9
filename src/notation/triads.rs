//! Letters that a plain text runs together with x, y and z: its `tx`, `ty` and `tz` are the components of one vector.

use crate::notation::plain_words::{Spelling, undotted};
use crate::notation::token::Lexeme;
use std::collections::BTreeSet;

/// The letters of such vectors, a bit for each letter from A on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Triads(u64);

impl Triads {
    /// Those of a text: all three are words of it, and no coordinate is a factor that the letter could multiply.
    pub(crate) fn of(text: &str) -> Self {
        if has_coordinates(text) {
            return Self::default();
        }
        let letter = |c: char| !c.is_alphanumeric() && c != '_';
        let words: BTreeSet<&[u8]> = text
            .split(letter)
            .map(str::as_bytes)
            .filter(|word| word.len() == 2)
            .collect();
        // A dx is a differential.
        let heads = words.iter().map(|word| word[0]).filter(|&head| {
            let all = [b'x', b'y', b'z'];
            head.is_ascii_alphabetic()
                && head != b'd'
                && all
                    .iter()
                    .all(|&axis| words.contains([head, axis].as_slice()))
        });
        Self(heads.fold(0, |set, head| set | bit(head)))
    }

    /// What a word stands for, if it is a component of one of them.
    pub(crate) fn word(self, word: &str) -> Option<Spelling<'_>> {
        let (stem, dots) = undotted(word);
        let &[head, axis] = stem.as_bytes() else {
            return None;
        };
        let component = head.is_ascii_alphabetic() && matches!(axis, b'x' | b'y' | b'z');
        (component && self.0 & bit(head) != 0).then(|| Spelling {
            base: Lexeme::Letter(head.into()),
            subscript: &stem[1..],
            dots,
        })
    }
}

fn bit(letter: u8) -> u64 {
    1 << (letter - b'A')
}

/// Whether a y or a z, which cross nothing, stands beside a sign of a formula.
fn has_coordinates(text: &str) -> bool {
    let signs = ['*', '^', '+', '=', '/', '²'];
    text.match_indices(['y', 'z']).any(|(at, found)| {
        let (before, behind) = (&text[..at], &text[at + found.len()..]);
        let part = |c: char| c.is_alphanumeric() || c == '_';
        let alone = !before.ends_with(part) && !behind.starts_with(part);
        let near = [' ', '(', ')'];
        alone
            && (before.trim_end_matches(near).ends_with(signs)
                || behind.trim_start_matches(near).starts_with(signs))
    })
}
