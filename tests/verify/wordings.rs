//! Many wordings say the same: each is read as plain sentences.

use polhode::notation::Macros;
use polhode::verify::language::{Lexicon, read_sentence, sentence};

/// A sentence a line, and indented below it what it is read as.
const WORDINGS: &str = include_str!("language/wordings.txt");

/// The sentences with what they are read as.
fn wordings() -> Vec<(&'static str, Vec<&'static str>)> {
    let mut all: Vec<(&str, Vec<&str>)> = vec![];
    for line in WORDINGS
        .lines()
        .filter(|l| !l.is_empty() && !l.starts_with('#'))
    {
        match line.strip_prefix("    ") {
            Some(plain) => all.last_mut().expect("a sentence before it").1.push(plain),
            None => all.push((line, vec![])),
        }
    }
    all
}

fn read(said: &str) -> Vec<String> {
    let lexicon = Lexicon::default();
    match read_sentence(said, 1, &Macros::default(), &lexicon) {
        Ok(declarations) => declarations.iter().map(|d| sentence(d, &lexicon)).collect(),
        Err(misread) => vec![misread.to_string()],
    }
}

#[test]
fn other_words_are_read_as_plain_ones() {
    for (said, plain) in wordings() {
        assert_eq!(read(said), plain, "{said}");
    }
}

/// What a sentence is read as reads as the same again.
#[test]
fn plain_words_stay_as_they_are() {
    for plain in wordings().iter().flat_map(|(_, plain)| plain) {
        assert_eq!(read(plain), [*plain]);
    }
}

/// A sentence that breaks off, loses a word or goes on where it ends is read or refused; no place behind its end is looked at.
#[test]
fn mangled_wordings_end_in_a_reading_or_an_error() {
    let mangled = |said: &str, at: usize| {
        let words: Vec<&str> = said.trim_end_matches('.').split(' ').collect();
        let at = at % words.len();
        let without = [&words[..at], &words[at + 1..]].concat();
        [
            words[..=at].join(" "),
            words[at..].join(" "),
            without.join(" "),
            format!("{}, respectively", words[..=at].join(" ")),
            format!("{} which", words[..=at].join(" ")),
            format!("{} with the force", words[..=at].join(" ")),
        ]
    };
    for (number, (said, _)) in wordings().into_iter().enumerate() {
        for sentence in mangled(said, number) {
            assert!(!read(&format!("{sentence}.")).is_empty(), "{sentence}");
        }
    }
}
