//! The rules by which sentences are brought to plainer ones, from the data that come with the crate.

use super::words::{Kind, Token};
use foldhash::HashMap;
use std::sync::{LazyLock, OnceLock};

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
}

/// A rule as it is written. Few are tried, and each is read when it first is.
struct Written {
    line: &'static str,
    rule: OnceLock<Option<Rule>>,
}

/// Rules, in the order in which they are tried.
pub(super) struct Rules {
    all: Vec<Written>,
    /// Their numbers by the words of which one must stand in the sentence.
    asking: HashMap<&'static str, Vec<usize>>,
    /// The numbers of those that ask for no word.
    wordless: Vec<usize>,
}

/// All rules.
pub(super) static ALL: LazyLock<Rules> = LazyLock::new(|| Rules::of(RULES.lines()));

/// Those that come before the grammar, which takes the words for something else.
pub(super) static FIRST: LazyLock<Rules> =
    LazyLock::new(|| Rules::of(RULES.lines().filter(|line| line.starts_with('!'))));

impl Rules {
    fn of(lines: impl Iterator<Item = &'static str>) -> Self {
        let mut rules = Self {
            all: vec![],
            asking: HashMap::default(),
            wordless: vec![],
        };
        for line in lines.filter(|line| !line.starts_with('#')) {
            // No pattern has a sign of equality in it.
            let Some((pattern, _)) = line.split_once('=') else {
                continue;
            };
            let number = rules.all.len();
            rules.all.push(Written {
                line,
                rule: OnceLock::new(),
            });
            match rarest(pattern) {
                Some(words) => words
                    .split('|')
                    .for_each(|word| rules.asking.entry(word).or_default().push(number)),
                None => rules.wordless.push(number),
            }
        }
        rules
    }

    /// Those of which all words stand in a sentence.
    pub(super) fn fitting(&self, tokens: &[Token]) -> impl Iterator<Item = &Rule> {
        let words = tokens.iter().filter_map(said_word);
        let asking = words.filter_map(|word| self.asking.get(word.as_str()));
        let mut numbers: Vec<usize> = asking.flatten().chain(&self.wordless).copied().collect();
        numbers.sort_unstable();
        numbers.dedup();
        let rules = numbers.into_iter().filter_map(|at| self.all[at].rule());
        rules.filter(|rule| {
            rule.pattern.iter().all(|piece| match piece {
                Piece::Words(words) => tokens.iter().any(|token| is_one_of(token, words)),
                _ => true,
            })
        })
    }
}

impl Written {
    fn rule(&self) -> Option<&Rule> {
        self.rule.get_or_init(|| rule(self.line)).as_ref()
    }
}

/// The words of a pattern, one of which must stand in the sentence, that are likely to stand in the fewest: the longest.
fn rarest(pattern: &'static str) -> Option<&'static str> {
    let words = pattern
        .trim_start_matches(['!', '~', ' '])
        .split(' ')
        .filter(|text| asks_for_words(text));
    let shortest = |words: &&str| words.split('|').map(str::len).min();
    words.max_by_key(shortest)
}

/// Whether a piece of a pattern is one of some words.
fn asks_for_words(text: &str) -> bool {
    !matches!(
        text.as_bytes(),
        [] | [b',' | b';' | b'(' | b')' | b'A'..=b'Z'] | [b'[', ..] | [.., b'?']
    )
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
    let line = line.strip_prefix('!').unwrap_or(line).trim_start();
    let inside = line.strip_prefix('~');
    let (pattern, plain) = inside.unwrap_or(line).split_once("=>")?;
    Some(Rule {
        whole: inside.is_none(),
        pattern: pieces(pattern),
        plain,
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

/// Whether a word, a number or a sign that may be spoken of is one of some words.
pub(super) fn is_one_of(token: &Token, words: &[&str]) -> bool {
    said_word(token).is_some_and(|said| words.contains(&said.as_str()))
}
