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

/// The words of a phrase behind its first one, and what it makes of formulas; nothing where a word in it is no cue.
type Phrase = (Vec<&'static str>, Option<Cue>);

/// The phrases by their first words.
static PHRASES: LazyLock<HashMap<&str, Vec<Phrase>>> = LazyLock::new(|| {
    let mut phrases: HashMap<&str, Vec<Phrase>> = HashMap::default();
    for line in WORDS.lines() {
        let Some((kind, of_kind)) = line.split_once(':') else {
            continue;
        };
        let cue = match kind.trim() {
            "derive" => Some(Cue::Derive),
            "define" => Some(Cue::Define),
            "assume" => Some(Cue::Assume),
            "give" => Some(Cue::Give),
            "idle" => None,
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

/// The words of the longest phrase.
static LONGEST: LazyLock<usize> = LazyLock::new(|| {
    let phrases = PHRASES.values().flatten();
    phrases.map(|(rest, _)| 1 + rest.len()).max().unwrap_or(1)
});

/// A cue, and at which word from the end of a sentence its phrase begins and ends.
struct Found {
    begins: usize,
    ends: usize,
    cue: Option<Cue>,
}

/// The last cue of a sentence. It is looked for from the end: most sentences are long, and have it there.
pub(crate) fn last_cue(sentence: &str) -> Option<Cue> {
    let sentence = without_remarks(sentence);
    let words = words_from_end(&sentence).map(in_small_letters);
    // Those from the end up to the one that is looked at.
    let mut behind: Vec<Cow<'_, str>> = vec![];
    let mut found: Vec<Found> = vec![];
    for (at, word) in words.enumerate() {
        if let Some((more, cue)) = longest_phrase(&word, &behind) {
            let (begins, ends) = (at, at - more);
            found.push(Found { begins, ends, cue });
        }
        behind.push(word);
        // No phrase that begins farther from the end reaches into those that were found.
        let first = found.last().map(|found| found.begins);
        if first.is_some_and(|first| at >= first + *LONGEST) {
            break;
        }
    }
    // A phrase hides the words in it.
    let mut left = usize::MAX;
    let mut last = None;
    for phrase in found.iter().rev() {
        if phrase.begins < left {
            left = phrase.ends;
            last = phrase.cue.or(last);
        }
    }
    last
}

/// The words of a sentence, the last one first.
fn words_from_end(sentence: &str) -> impl Iterator<Item = &str> {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '\'';
    let is_sign = |c: char| c.is_ascii() || matches!(c, '⟨' | '⟩');
    let in_word = move |c: char| is_plain(c) || !is_sign(c) && c.is_alphanumeric();
    let mut rest = sentence;
    std::iter::from_fn(move || {
        let to_end = rest.trim_end_matches(|c| !in_word(c));
        rest = to_end.trim_end_matches(in_word);
        let word = &to_end[rest.len()..];
        (!word.is_empty()).then_some(word)
    })
}

/// The longest phrase that begins with a word: how many words it has besides, and what it makes of formulas. What stands
/// behind the word is given from the end on.
fn longest_phrase(first: &str, behind: &[Cow<'_, str>]) -> Option<(usize, Option<Cue>)> {
    let fits = |(rest, _): &&Phrase| {
        let mut both = rest.iter().zip(behind.iter().rev());
        rest.len() <= behind.len() && both.all(|(a, b)| *a == "*" || *a == b.as_ref())
    };
    let phrases = PHRASES.get(first).into_iter().flatten();
    // Of two kinds with one phrase the first counts.
    let longest = phrases
        .filter(fits)
        .rev()
        .max_by_key(|(rest, _)| rest.len());
    longest.map(|(rest, cue)| (rest.len(), *cue))
}

fn in_small_letters(word: &str) -> Cow<'_, str> {
    match word.is_ascii() {
        true if word.bytes().any(|b| b.is_ascii_uppercase()) => {
            Cow::Owned(word.to_ascii_lowercase())
        }
        true => Cow::Borrowed(word),
        false => Cow::Owned(word.to_lowercase()),
    }
}
