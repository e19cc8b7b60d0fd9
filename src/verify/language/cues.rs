//! Words that give a line its role: `suppose`, `hence`, `where`.

use foldhash::HashMap;
use std::borrow::Cow;
use std::sync::LazyLock;

/// What a word makes of the formulas behind it.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Cue {
    /// They are said to follow.
    Derive,
    /// They give letters their meaning.
    Define,
    /// They narrow the motion or the body.
    Assume,
    /// They are handed over.
    Give,
}

/// The words, one kind a line.
const WORDS: &str = include_str!("cues.txt");

/// The words of a phrase behind its first one, and what it makes of formulas.
type Phrase = (Vec<&'static str>, Cue);

/// The phrases by their first words.
static PHRASES: LazyLock<HashMap<&str, Vec<Phrase>>> = LazyLock::new(|| {
    let mut phrases: HashMap<&str, Vec<Phrase>> = HashMap::default();
    for line in WORDS.lines() {
        let Some((kind, of_kind)) = line.split_once(':') else {
            continue;
        };
        let cue = match kind.trim() {
            "derive" => Cue::Derive,
            "define" => Cue::Define,
            "assume" => Cue::Assume,
            "give" => Cue::Give,
            _ => continue,
        };
        for phrase in of_kind.split('|') {
            let mut words = phrase.split_whitespace();
            if let Some(first) = words.next() {
                phrases
                    .entry(first)
                    .or_default()
                    .push((words.collect(), cue));
            }
        }
    }
    phrases
});

/// What takes an assumption back.
const DENIALS: [&str; 16] = [
    "not assume",
    "n't assume",
    "not suppose",
    "never assume",
    "cannot assume",
    "no longer assume",
    "wrong to assume",
    "wrong to suppose",
    "instead of assuming",
    "instead of supposing",
    "without assuming",
    "without this assumption",
    "unless we assume",
    "unless",
    "not be the case",
    "others assume",
];

/// Whether a sentence says that something is not assumed: "we do not assume that".
pub(crate) fn denies_assumption(sentence: &str) -> bool {
    let sentence = sentence.to_lowercase();
    DENIALS.iter().any(|denial| sentence.contains(denial))
}

/// A sentence without what stands in round brackets that are closed: it is not said of the formulas behind it.
fn without_remarks(sentence: &str) -> Cow<'_, str> {
    if !sentence.contains('(') {
        return Cow::Borrowed(sentence);
    }
    let mut open: Vec<usize> = vec![];
    let mut kept = String::with_capacity(sentence.len());
    for c in sentence.chars() {
        match c {
            '(' => open.push(kept.len()),
            ')' => {
                if let Some(from) = open.pop() {
                    kept.truncate(from);
                    continue;
                }
            }
            _ => {}
        }
        kept.push(c);
    }
    Cow::Owned(kept)
}

/// The cues of a sentence in their order.
pub(crate) fn cues(sentence: &str) -> Vec<Cue> {
    let sentence = without_remarks(sentence);
    let words = sentence.split(|c: char| !c.is_alphanumeric() && c != '-' && c != '\'');
    let words: Vec<Cow<'_, str>> = words
        .filter(|word| !word.is_empty())
        .map(in_small_letters)
        .collect();
    let (mut cues, mut end) = (vec![], 0);
    for (at, first) in words.iter().enumerate() {
        let behind = &words[at + 1..];
        let fits = |(rest, _): &&Phrase| {
            rest.len() <= behind.len()
                && rest
                    .iter()
                    .zip(behind)
                    .all(|(a, b)| *a == "*" || *a == b.as_ref())
        };
        let phrases = PHRASES.get(first.as_ref()).into_iter().flatten();
        // A longer phrase hides the words in it; of two kinds with one phrase the first counts.
        let longest = phrases
            .filter(fits)
            .rev()
            .max_by_key(|(rest, _)| rest.len());
        if let Some((rest, cue)) = longest.filter(|_| at >= end) {
            cues.push(*cue);
            end = at + 1 + rest.len();
        }
    }
    cues
}

fn in_small_letters(word: &str) -> Cow<'_, str> {
    match word
        .bytes()
        .all(|b| b.is_ascii() && !b.is_ascii_uppercase())
    {
        true => Cow::Borrowed(word),
        false => Cow::Owned(word.to_lowercase()),
    }
}

#[cfg(test)]
mod tests {
    use super::{Cue, cues};

    #[test]
    fn a_remark_in_brackets_gives_no_role() {
        assert_eq!(
            cues("We find (assuming that it is constant)"),
            [Cue::Derive]
        );
        assert_eq!(cues("It is small (assuming"), [Cue::Assume]);
        assert_eq!(cues("We take the derivative of it"), [Cue::Derive]);
        assert_eq!(cues("We take the body-frame derivative"), [Cue::Derive]);
        assert_eq!(cues("We take"), [Cue::Assume]);
    }
}
