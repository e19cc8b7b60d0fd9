//! Sentences that are not understood and speak of words in formulas alone: "A member "const" says that …".

use super::reader::Reader;
use super::words::{Kind, Token};

/// What words in formulas are called.
const OF_WORDS: [&str; 16] = [
    "word",
    "words",
    "member",
    "members",
    "remark",
    "remarks",
    "abbreviation",
    "abbreviations",
    "text",
    "texts",
    "phrase",
    "phrases",
    "note",
    "notes",
    "comment",
    "comments",
];

/// What a sentence says by which a word may name a thing of which other sentences speak.
const NAMING: [&str; 9] = [
    "mean", "means", "stand", "stands", "denote", "denotes", "name", "names", "called",
];

impl Reader<'_> {
    /// The quoted words of which a sentence speaks, if it speaks of no letter and of no thing besides: it changes what carries
    /// them, and nothing else.
    pub(super) fn quoted_words(&self) -> Option<Vec<String>> {
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let named = |pair: &[Token]| {
            pair[1].kind != Kind::Quoted || OF_WORDS.contains(&pair[0].lower.as_str())
        };
        let first = rest.first().is_some_and(|t| t.kind != Kind::Quoted);
        let letters = rest
            .iter()
            .any(|t| matches!(t.kind, Kind::Formula | Kind::Plain));
        let capital = |t: &Token| t.kind == Kind::Word && t.text.starts_with(char::is_uppercase);
        let names = rest.iter().skip(1).any(capital);
        let naming = rest.iter().any(|t| NAMING.contains(&t.lower.as_str()));
        let alone = first && rest.windows(2).all(named) && !letters && !names && !naming;
        let quoted = rest.iter().filter(|t| t.kind == Kind::Quoted);
        let quoted: Vec<String> = quoted.map(|t| t.text.clone()).collect();
        (alone && !quoted.is_empty()).then_some(quoted)
    }
}
