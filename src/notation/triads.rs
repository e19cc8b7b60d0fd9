//! Letters that a plain text runs together with x, y and z: its `tx`, `ty` and `tz` are the components of one vector.

use crate::notation::plain_words::{Spelling, undotted};
use crate::notation::token::Lexeme;
use std::collections::BTreeSet;

/// Such letters of a text, a bit for each letter from A on.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) struct Triads {
    /// The letters of the vectors.
    vectors: u64,
    /// Letters that tell one ω from another where words name it so: "let ωs be the spin rate".
    labels: u64,
}

/// Words right behind a symbol that say what it is.
const NAMED: &[&str] = &[
    "be the ", "is the ", "are the ", "the ", "denotes ", "for the ",
];

impl Triads {
    /// Those of a text: all three are words of it, and no coordinate is a factor that the letter could multiply, or they
    /// stand before the unit vectors.
    pub(crate) fn of(text: &str) -> Self {
        let labels = labels_of_rates(text);
        let coordinates = has_coordinates(text);
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
                && (!coordinates || is_along_units(text, head.into()))
                && all
                    .iter()
                    .all(|&axis| words.contains([head, axis].as_slice()))
        });
        let vectors = heads.fold(0, |set, head| set | bit(head));
        Self { vectors, labels }
    }

    /// Whether a letter close behind an ω is its label.
    pub(crate) fn labels_rate(self, label: char) -> bool {
        label.is_ascii_lowercase() && self.labels & bit(label as u8) != 0
    }

    /// What a word stands for, if it is a component of one of them.
    pub(crate) fn word(self, word: &str) -> Option<Spelling<'_>> {
        let (stem, dots) = undotted(word);
        let &[head, axis] = stem.as_bytes() else {
            return None;
        };
        let component = head.is_ascii_alphabetic() && matches!(axis, b'x' | b'y' | b'z');
        (component && self.vectors & bit(head) != 0).then(|| Spelling {
            base: Lexeme::Letter(head.into()),
            subscript: &stem[1..],
            dots,
        })
    }
}

fn labels_of_rates(text: &str) -> u64 {
    let named = text.match_indices('ω').filter_map(|(at, found)| {
        let behind = &text[at + found.len()..];
        let label = behind.bytes().next().filter(u8::is_ascii_lowercase)?;
        let rest = behind[1..].strip_prefix([' ', '\n'])?;
        let axis = matches!(label, b'x' | b'y' | b'z');
        (!axis && NAMED.iter().any(|words| rest.starts_with(words))).then_some(label)
    });
    named.fold(0, |set, label| set | bit(label))
}

fn bit(letter: u8) -> u64 {
    1 << (letter - b'A')
}

/// `Qx i + Qy j + Qz k`.
fn is_along_units(text: &str, head: char) -> bool {
    let parts = [('x', 'i'), ('y', 'j'), ('z', 'k')];
    parts
        .iter()
        .all(|(axis, unit)| text.contains(&format!("{head}{axis} {unit}")))
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
