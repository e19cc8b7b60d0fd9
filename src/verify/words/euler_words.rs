//! What the words say of three angles: about which axes the body is turned by them, one after the other.

use crate::verify::words::book::has_any;
use crate::verify::words::text::Text;

/// The axes of three turns, each about an axis that the turns before have carried along.
pub(crate) type Sequence = [u8; 3];

/// Every sequence that reaches all attitudes, the usual ones first.
const SEQUENCES: [Sequence; 12] = [
    [2, 0, 2],
    [2, 1, 0],
    [2, 1, 2],
    [0, 1, 2],
    [0, 2, 0],
    [0, 1, 0],
    [1, 0, 1],
    [1, 2, 1],
    [2, 0, 1],
    [1, 2, 0],
    [1, 0, 2],
    [0, 2, 1],
];
/// Bytes on either side of a sequence in which a word tells that it is one.
const NEAR: usize = 120;
/// Words that tell that something is a sequence.
const TELLING: [&str; 6] = [
    "sequence",
    "convention",
    "euler",
    "order",
    "rotation",
    "angle",
];
/// Words between "about" and the axis.
const BETWEEN: usize = 4;

/// The sequences that a document may mean, the likelier first; none where it speaks of no such angles.
pub(crate) fn sequences(document: &Text) -> Vec<Sequence> {
    let said = document.named_sentences();
    let text: Vec<&str> = said.iter().map(|s| s.text.as_str()).collect();
    let text = text.join(" ");
    let mut found: Vec<Sequence> = vec![];
    let turned = said
        .iter()
        .filter_map(|sentence| one_after_the_other(&sentence.text));
    for sequence in written(document.lower()).into_iter().chain(turned) {
        if !found.contains(&sequence) {
            found.push(sequence);
        }
    }
    if !found.is_empty() {
        return found;
    }
    let names = |words: &[&str]| words.iter().filter(|word| text.contains(**word)).count();
    let of_a_top = text.contains("precess")
        && names(&["nutation", "spin", "inclin", "tilt", "line of nodes"]) > 0;
    let of_a_craft = names(&["yaw", "pitch", "roll", "heading", "bank"]) > 1;
    match (of_a_top, of_a_craft) {
        (true, false) => vec![[2, 0, 2], [2, 1, 2]],
        (false, true) => vec![[2, 1, 0]],
        (true, true) => vec![[2, 0, 2], [2, 1, 2], [2, 1, 0]],
        _ if names(&["euler angle", "eulerian angle", "euler's angle"]) > 0 => SEQUENCES.to_vec(),
        _ => vec![],
    }
}

/// Whether the words say that the axes used leave out the last turn.
pub(crate) fn leaves_out_the_spin(text: &Text) -> bool {
    let words = [
        "not the spin",
        "not in the spin",
        "not spin",
        "nodal",
        "do not turn with",
    ];
    let mut said = text.named_sentences().iter();
    said.any(|sentence| has_any(&sentence.text, &words))
}

/// Sequences as such, in small letters: "3-1-3", "z-x'-z''", "zyx", "the x-convention".
fn written(source: &str) -> Vec<Sequence> {
    if !has_any(source, &TELLING) {
        return vec![];
    }
    let plain: String = source
        .chars()
        .filter(|c| !matches!(c, '$' | '{' | '}' | '\'' | '′' | '″' | '’'))
        .collect();
    let mut found = vec![];
    let outside = |c: char| {
        c.is_whitespace() || matches!(c, '(' | ')' | ',' | ';' | ':' | '.' | '"' | '*' | '_')
    };
    for word in plain.split(outside).filter(|word| word.len() < NEAR) {
        let at = word.as_ptr() as usize - plain.as_ptr() as usize;
        let told = || {
            let near = around(&plain, at);
            has_any(near, &TELLING)
        };
        match word {
            "x-convention" => found.push([2, 0, 2]),
            "y-convention" => found.push([2, 1, 2]),
            _ => found.extend(sequence(word).filter(|_| told())),
        }
    }
    found
}

/// The text about a place.
fn around(text: &str, at: usize) -> &str {
    let start = (at.saturating_sub(NEAR)..=at).find(|&i| text.is_char_boundary(i));
    let end = (at..(at + NEAR).min(text.len()))
        .rev()
        .find(|&i| text.is_char_boundary(i));
    &text[start.unwrap_or(at)..end.unwrap_or(at)]
}

/// A word of three axes; the axes xyz and the numbers 123 need dashes between them.
fn sequence(word: &str) -> Option<Sequence> {
    let dash = |c: char| matches!(c, '-' | '–' | '—' | '‑' | '→' | '/');
    let axes: Vec<u8> = word
        .chars()
        .filter(|&c| !dash(c))
        .map(axis)
        .collect::<Option<_>>()?;
    let axes: Sequence = axes.try_into().ok()?;
    let plain = axes == [0, 1, 2] && !word.contains(dash);
    let numbers = word.starts_with(|c: char| c.is_ascii_digit());
    let one_kind = word
        .chars()
        .filter(|&c| !dash(c))
        .all(|c| c.is_ascii_digit() == numbers);
    (SEQUENCES.contains(&axes) && one_kind && !plain).then_some(axes)
}

fn axis(name: char) -> Option<u8> {
    match name {
        'x' | '1' => Some(0),
        'y' | '2' => Some(1),
        'z' | '3' => Some(2),
        _ => None,
    }
}

/// "By ψ about z, then by θ about the new y, then by φ about the new x."
fn one_after_the_other(sentence: &str) -> Option<Sequence> {
    let mut pieces = sentence.split("about ");
    pieces.next();
    let axes: Vec<u8> = pieces.filter_map(first_axis).take(3).collect();
    let axes: Sequence = axes.try_into().ok()?;
    SEQUENCES.contains(&axes).then_some(axes)
}

/// The axis that the next few words name.
fn first_axis(words: &str) -> Option<u8> {
    let trimmed = |word: &str| -> String {
        let kept = word.chars().filter(|c| c.is_alphanumeric());
        kept.collect()
    };
    words.split_whitespace().take(BETWEEN).find_map(|word| {
        let word = trimmed(word);
        let mut letters = word.trim_start_matches("e_").chars();
        match (letters.next(), letters.next()) {
            (Some(name), None) => axis(name),
            _ if matches!(word.as_str(), "down" | "vertical") => Some(2),
            _ => None,
        }
    })
}
