//! The rules by which sentences are brought to plainer ones, from the data that come with the crate.

use super::words::{Kind, Token};
use foldhash::HashMap;
use std::sync::LazyLock;

/// The rules that come with the crate.
pub(super) const RULES: &str = include_str!("rewrites.txt");

/// A piece of a pattern, or of what it becomes.
#[derive(Clone, Debug, PartialEq)]
pub(super) enum Piece {
    /// One of some words.
    Words(Vec<&'static str>),
    /// One of some words, or nothing.
    Maybe(Vec<&'static str>),
    /// One piece or more, as few as fit.
    Any(char),
    /// A list of formulas.
    Formulas(char),
    /// One piece.
    One(char),
    /// One piece or more without a comma.
    Clause(char),
    /// One piece or more that begin with an article or another word that belongs to a noun.
    Phrase(char),
    /// A sign.
    Sign(Kind),
    /// A formula that is put together from formulas and signs.
    Built(&'static str),
}

/// A way to say something, and the plain one.
#[derive(Clone, Debug)]
pub(super) struct Rule {
    pub(super) pattern: Vec<Piece>,
    /// What it becomes, as it is written.
    plain: &'static str,
    /// Whether it is said of a whole clause, and not of words inside of one.
    pub(super) whole: bool,
    /// Whether it comes before the grammar, which takes the words for something else.
    pub(super) first: bool,
    /// The words of which one must stand in the sentence, for each place of the pattern that asks for some: by their numbers.
    asks_for: Vec<Vec<usize>>,
}

/// The rules, in the order in which they are tried, and the words that they ask for by their numbers.
pub(super) struct Rules {
    all: Vec<Rule>,
    numbers: HashMap<&'static str, usize>,
}

pub(super) fn rules() -> &'static Rules {
    static READ: LazyLock<Rules> = LazyLock::new(|| {
        let (mut all, mut numbers) = (vec![], HashMap::default());
        for mut rule in RULES.lines().filter_map(rule) {
            for piece in &rule.pattern {
                let Piece::Words(words) = piece else { continue };
                let mut alternatives = vec![];
                for word in words {
                    let next = numbers.len();
                    alternatives.push(*numbers.entry(*word).or_insert(next));
                }
                rule.asks_for.push(alternatives);
            }
            all.push(rule);
        }
        Rules { all, numbers }
    });
    &READ
}

impl Rules {
    /// Those of which all words stand in a sentence.
    pub(super) fn fitting(&self, tokens: &[Token]) -> impl Iterator<Item = &Rule> {
        let mut stands = vec![false; self.numbers.len()];
        for token in tokens {
            let number = said_word(token).and_then(|word| self.numbers.get(word.as_str()));
            if let Some(&number) = number {
                stands[number] = true;
            }
        }
        let all = self.all.iter();
        all.filter(move |rule| {
            let mut asked = rule.asks_for.iter();
            asked.all(|words| words.iter().any(|&number| stands[number]))
        })
    }
}

impl Rule {
    /// The pieces of what it becomes: few rules are applied, and so they are parted then alone.
    pub(super) fn plain(&self) -> Vec<Piece> {
        pieces(self.plain)
    }
}

/// `pattern => plain ## example`; a rule behind `~` is one of words inside a clause, one behind `!` comes before the grammar.
pub(super) fn rule(line: &'static str) -> Option<Rule> {
    let line = line.split("##").next()?.trim();
    if line.starts_with('#') {
        return None;
    }
    let before = line.strip_prefix('!');
    let line = before.unwrap_or(line).trim_start();
    let inside = line.strip_prefix('~');
    let (pattern, plain) = inside.unwrap_or(line).split_once("=>")?;
    Some(Rule {
        whole: inside.is_none(),
        first: before.is_some(),
        pattern: pieces(pattern),
        plain,
        asks_for: vec![],
    })
}

fn pieces(text: &'static str) -> Vec<Piece> {
    text.split_whitespace().map(piece).collect()
}

fn piece(text: &'static str) -> Piece {
    let mut letters = text.chars();
    match (letters.next(), letters.next()) {
        (Some(','), None) => return Piece::Sign(Kind::Comma),
        (Some(';'), None) => return Piece::Sign(Kind::Semicolon),
        (Some('('), None) => return Piece::Sign(Kind::Open),
        (Some(')'), None) => return Piece::Sign(Kind::Close),
        (Some(c @ ('F' | 'G' | 'H')), None) => return Piece::Formulas(c),
        (Some(c @ ('N' | 'M')), None) => return Piece::Phrase(c),
        (Some(c @ ('S' | 'U')), None) => return Piece::Clause(c),
        (Some('V'), None) => return Piece::One('V'),
        (Some(c), None) if c.is_ascii_uppercase() => return Piece::Any(c),
        _ => {}
    }
    if let Some(built) = text.strip_prefix('[').and_then(|t| t.strip_suffix(']')) {
        return Piece::Built(built);
    }
    let words = |text: &'static str| text.split('|').collect();
    match text.strip_suffix('?') {
        Some(text) => Piece::Maybe(words(text)),
        None => Piece::Words(words(text)),
    }
}

/// A word, a number or a sign that may be spoken of, as patterns ask for it.
pub(super) fn said_word(token: &Token) -> Option<&String> {
    match token.kind {
        // The lower case of a formula is empty, but for that of a sign.
        Kind::Word | Kind::Formula => Some(&token.lower),
        Kind::Number => Some(&token.text),
        _ => None,
    }
}
