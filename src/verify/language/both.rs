//! "Both gimbals": the two bodies of a kind that words tell apart. "Each wheel": the one that a letter counts.

use super::bodies::singular;
use super::body_words::APART;
use super::rewrite::put_in;
use super::words::{Kind, Token};
use std::collections::{BTreeMap, BTreeSet};

/// Words before the plural of a kind of bodies that mean all of them.
const ALL: [&[&str]; 5] = [
    &["both", "of", "the"],
    &["both", "the"],
    &["the", "two"],
    &["both"],
    &["the"],
];

/// The names of the bodies in the place of "both gimbals". None where no two words tell bodies of the kind apart, where one
/// is called by the kind alone, and where a list of letters stands before it: in which order the bodies are is not said.
pub(crate) fn tell_both(tokens: &[Token], kinds: &Kinds) -> Option<Vec<Token>> {
    let words: Vec<&str> = tokens.iter().map(|t| t.lower.as_str()).collect();
    (0..words.len()).find_map(|at| {
        let all = ALL.iter().find(|all| words[at..].starts_with(all))?;
        let end = at + all.len();
        let kind = singular(words.get(end)?)?;
        let told = kinds.apart.get(&kind)?;
        let listed = tokens[..at]
            .windows(2)
            .any(|pair| is_letter(&pair[0]) && (is_letter(&pair[1]) || pair[1].lower == "and"));
        if told.len() != 2 || kinds.alone.contains(&kind) || listed {
            return None;
        }
        let (one, other) = (told.first()?, told.last()?);
        let names = [
            "the",
            one.as_str(),
            kind.as_str(),
            "and",
            "the",
            other.as_str(),
            kind.as_str(),
        ];
        let names = names.map(|word| put_in(Kind::Word, word, &tokens[at]));
        Some([&tokens[..at], &names, &tokens[end + 1..]].concat())
    })
}

/// How sentences call bodies of a kind.
pub(crate) struct Kinds {
    /// The words that tell bodies of a kind apart, by its noun.
    apart: BTreeMap<String, BTreeSet<String>>,
    /// The nouns that stand directly behind their article: bodies that are called by their kind alone.
    alone: BTreeSet<String>,
}

impl Kinds {
    pub(crate) fn of<'t>(sentences: impl Iterator<Item = &'t [Token]>) -> Self {
        let (mut apart, mut alone) = (BTreeMap::new(), BTreeSet::new());
        for pair in sentences.flat_map(|tokens| tokens.windows(2)) {
            let [word, noun] = [&pair[0].lower, &pair[1].lower];
            if APART.contains(&word.as_str()) {
                let words: &mut BTreeSet<String> = apart.entry(noun.clone()).or_default();
                words.insert(word.clone());
            }
            if word == "the" {
                alone.insert(noun.clone());
            }
        }
        Self { apart, alone }
    }
}

fn is_letter(token: &Token) -> bool {
    matches!(token.kind, Kind::Formula | Kind::Plain | Kind::Comma)
}

/// The letters that count things, by the noun: "`$i$` numbers the wheels".
pub(crate) fn counting_letters<'t>(
    sentences: impl Iterator<Item = &'t [Token]>,
) -> BTreeMap<String, Token> {
    let mut letters = BTreeMap::new();
    for tokens in sentences {
        for at in 0..tokens.len() {
            if let [letter, counts, the, rest @ ..] = &tokens[at..]
                && letter.kind == Kind::Formula
                && COUNTS.contains(&counts.lower.as_str())
                && the.lower == "the"
            {
                let noun = rest
                    .iter()
                    .take_while(|t| t.kind == Kind::Word && t.lower != "and")
                    .last();
                let noun = noun.and_then(|noun| singular(&noun.lower));
                letters.extend(noun.map(|noun| (noun, letter.clone())));
            }
        }
    }
    letters
}

const COUNTS: [&str; 4] = ["numbers", "counts", "number", "count"];

/// "Each wheel" and "every wheel" as "wheel `$i$`", where that letter counts them.
pub(crate) fn tell_each(tokens: &[Token], letters: &BTreeMap<String, Token>) -> Option<Vec<Token>> {
    let each = |t: &Token| matches!(t.lower.as_str(), "each" | "every");
    let at = tokens
        .windows(2)
        .position(|pair| each(&pair[0]) && letters.contains_key(&pair[1].lower))?;
    let noun = &tokens[at + 1];
    let letter = Token {
        column: noun.column,
        ..letters.get(&noun.lower)?.clone()
    };
    Some([&tokens[..at], &[noun.clone(), letter], &tokens[at + 2..]].concat())
}
