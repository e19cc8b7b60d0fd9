//! Moments of inertia that an adjective names: "its transverse moment of inertia is ⟨I_t⟩", "the axial and transverse
//! moments ⟨C⟩ and ⟨A⟩", "⟨A⟩ (transverse)".

use crate::verify::words::book::has_any;
use crate::verify::words::phrases::speaks_of_wheels;

const AXIAL: &[&str] = &["axial", "polar", "longitudinal"];
const TRANSVERSE: &[&str] = &["transverse", "equatorial", "lateral", "diametral"];
/// What a rotor may be a part of.
const CARRIERS: &[&str] = &[
    "satellite",
    "spacecraft",
    "platform",
    "body",
    "housing",
    "vehicle",
    "ship",
    "airframe",
    "carrier",
];
const MOMENT: &[&str] = &[
    " moments of inertia",
    " moment of inertia",
    " moments",
    " moment",
    " inertia",
];

/// The numbers of symbols in a sentence with `⟨n⟩` in their places, and whether each is the moment about the axis of
/// symmetry.
pub(crate) fn by_adjective(text: &str) -> Vec<(usize, bool)> {
    let mut found = vec![];
    // That of a wheel is not one of the body that carries it; a rotor alone has both.
    let both = has_any(text, AXIAL) && has_any(text, TRANSVERSE);
    if speaks_of_wheels(text) && !(both && text.contains("rotor") && !has_any(text, CARRIERS)) {
        return found;
    }
    for (words, other, axial) in [(AXIAL, TRANSVERSE, true), (TRANSVERSE, AXIAL, false)] {
        for (at, word) in words.iter().flat_map(|word| text.match_indices(word)) {
            let (before, behind) = (&text[..at], &text[at + word.len()..]);
            let listed = before
                .strip_suffix(" and ")
                .is_some_and(|lead| other.iter().any(|word| lead.ends_with(word)));
            if listed {
                continue;
            }
            if let Some(rest) = of_moment(behind) {
                let named = symbol_behind(rest).or_else(|| symbol_before(before));
                found.extend(named.map(|symbol| (symbol, axial)));
            } else if behind.starts_with(')') && before.ends_with('(') {
                let named = symbol_before(&before[..before.len() - 1]);
                found.extend(named.map(|symbol| (symbol, axial)));
            } else if let Some(rest) = behind.strip_prefix(" and ")
                && let Some(rest) = other.iter().find_map(|word| rest.strip_prefix(word))
                && let Some(rest) = of_moment(rest)
                && let Some(first) = symbol_behind(rest)
                && let Some((_, rest)) = rest.split_once('⟩')
                && let Some(second) = rest.strip_prefix(" and ").and_then(symbol_behind)
            {
                found.extend([(first, axial), (second, !axial)]);
            }
        }
    }
    found
}

fn of_moment(text: &str) -> Option<&str> {
    MOMENT.iter().find_map(|words| text.strip_prefix(words))
}

fn symbol_behind(text: &str) -> Option<usize> {
    let text = text.trim_start_matches([',', ' ']);
    let text = ["is ", "are ", "be ", "being "]
        .iter()
        .find_map(|verb| text.strip_prefix(verb))
        .unwrap_or(text);
    text.strip_prefix('⟨')?.split_once('⟩')?.0.parse().ok()
}

/// The symbol before "is the transverse moment", or right before a bracket.
fn symbol_before(text: &str) -> Option<usize> {
    let (number, words) = text[text.rfind('⟨')? + '⟨'.len_utf8()..].split_once('⟩')?;
    let naming = ["is", "are", "for", "the", "its", "be", "denotes", "as"];
    let names = words.split_whitespace().all(|word| naming.contains(&word));
    names.then(|| number.parse().ok())?
}
