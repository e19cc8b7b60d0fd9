//! Words that give a line its role: `suppose`, `hence`, `where`.

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

/// The cues of a sentence in their order.
pub(crate) fn cues(sentence: &str) -> Vec<Cue> {
    let words: Vec<String> = sentence
        .split(|c: char| !c.is_alphanumeric() && c != '-' && c != '\'')
        .filter(|word| !word.is_empty())
        .map(str::to_lowercase)
        .collect();
    let mut found: Vec<(usize, usize, Cue)> = vec![];
    for line in WORDS.lines() {
        let Some((kind, phrases)) = line.split_once(':') else {
            continue;
        };
        let cue = match kind.trim() {
            "derive" => Cue::Derive,
            "define" => Cue::Define,
            "assume" => Cue::Assume,
            "give" => Cue::Give,
            _ => continue,
        };
        for phrase in phrases.split('|') {
            let phrase: Vec<&str> = phrase.split_whitespace().collect();
            let places = words.windows(phrase.len().max(1)).enumerate();
            let fits = places.filter(|(_, window)| window.iter().eq(phrase.iter()));
            found.extend(fits.map(|(at, _)| (at, phrase.len(), cue)));
        }
    }
    // A longer phrase hides the words in it.
    found.sort_by_key(|&(at, length, _)| (at, std::cmp::Reverse(length)));
    let mut cues = vec![];
    let mut end = 0;
    for (at, length, cue) in found {
        if at >= end {
            cues.push(cue);
            end = at + length;
        }
    }
    cues
}
