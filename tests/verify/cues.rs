//! The words that give a line its role: the last one of a sentence counts.

#[path = "../../src/verify/language/cues.rs"]
mod roles;

use roles::{Cue, denies_assumption, last_cue};

/// The phrases of the file, each with what it makes of the formulas behind it.
fn phrases() -> Vec<(Vec<&'static str>, Cue)> {
    let file = include_str!("../../src/verify/language/cues.txt");
    let kinds = file.lines().filter_map(|line| line.split_once(':'));
    let of_kind = |(kind, phrases): (&str, &'static str)| {
        let cue = match kind.trim() {
            "derive" => Cue::Derive,
            "define" => Cue::Define,
            "assume" => Cue::Assume,
            "give" => Cue::Give,
            _ => return vec![],
        };
        let words = phrases.split('|').map(|p| p.split_whitespace().collect());
        words.map(|words| (words, cue)).collect()
    };
    kinds.flat_map(of_kind).collect()
}

#[test]
fn a_remark_in_brackets_gives_no_role() {
    for (sentence, cue) in [
        ("We find (assuming that it is constant)", Cue::Derive),
        ("It is small (assuming", Cue::Assume),
        ("We take the derivative of it", Cue::Derive),
        ("We take the body-frame derivative", Cue::Derive),
        ("We take", Cue::Assume),
    ] {
        assert_eq!(last_cue(sentence), Some(cue), "{sentence}");
    }
}

#[test]
fn what_is_taken_back_is_not_assumed() {
    assert!(denies_assumption(
        "We do not assume that the spin is steady"
    ));
    assert!(!denies_assumption("We assume that the spin is steady"));
}

#[test]
fn the_last_cue_is_found_from_either_end() {
    let phrases = phrases();
    let longest_at = |words: &[&str]| {
        let fits = |(phrase, _): &&(Vec<&str>, Cue)| {
            let mut both = phrase.iter().zip(words);
            phrase.len() <= words.len() && both.all(|(a, b)| *a == "*" || a == b)
        };
        // Of two kinds with one phrase the first counts.
        let fitting = phrases.iter().filter(fits).rev();
        fitting.max_by_key(|(phrase, _)| phrase.len())
    };
    // All cues from left to right, as phrases hide the words in them.
    let from_left = |words: &[&str]| {
        let (mut last, mut end) = (None, 0);
        for at in 0..words.len() {
            if let Some((phrase, cue)) = longest_at(&words[at..]).filter(|_| at >= end) {
                (last, end) = (Some(*cue), at + phrase.len());
            }
        }
        last
    };
    let some = "take the find derivative so is the case in for when x";
    let some: Vec<&str> = some.split(' ').collect();
    let mut number = 1_u64;
    for _ in 0..2_000 {
        let words = (0..10).map(|_| {
            number = number
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1);
            some[(number >> 33) as usize % some.len()]
        });
        let words: Vec<&str> = words.collect();
        let sentence = words.join(" ");
        assert_eq!(last_cue(&sentence), from_left(&words), "{sentence}");
    }
}
