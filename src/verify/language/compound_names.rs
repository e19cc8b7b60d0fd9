//! "The pendulum arm" and "the arm": one body, where no other word stands before the noun; "the wheel assembly" and "the rod
//! assembly": two.

use super::body_words::APART;
use super::lexicon::{Class, Lexicon};
use super::reader::ARTICLES;
use super::words::{Kind, Token};
use std::collections::{BTreeMap, BTreeSet};

/// The words before each noun for a body that stand for bodies themselves, in all sentences.
pub(crate) struct Compounds(BTreeMap<String, BTreeSet<String>>);

impl Compounds {
    pub(crate) fn of<'t>(sentences: impl Iterator<Item = &'t [Token]>, lexicon: &Lexicon) -> Self {
        let mut before: BTreeMap<String, BTreeSet<String>> = BTreeMap::new();
        for tokens in sentences {
            for at in (0..tokens.len()).filter(|&at| is_compound(tokens, at, lexicon)) {
                let (word, noun) = (tokens[at + 1].lower.clone(), tokens[at + 2].lower.clone());
                before.entry(noun).or_default().insert(word);
            }
        }
        Self(before)
    }

    /// The names of bodies that are told apart by the words before one noun.
    pub(crate) fn told_apart(&self) -> impl Iterator<Item = String> {
        let several = self.0.iter().filter(|(_, words)| words.len() > 1);
        several.flat_map(|(noun, words)| words.iter().map(move |word| format!("{word} {noun}")))
    }

    /// The sentence with the noun alone, where one word only stands before it anywhere.
    pub(crate) fn shortened(&self, tokens: &[Token], lexicon: &Lexicon) -> Option<Vec<Token>> {
        let single = |noun: &str| self.0.get(noun).is_some_and(|words| words.len() == 1);
        let left_out = |at: usize| {
            let start = at.checked_sub(1);
            start.is_some_and(|start| {
                is_compound(tokens, start, lexicon) && single(&tokens[at + 1].lower)
            })
        };
        let kept = (0..tokens.len()).filter(|&at| !left_out(at));
        let kept: Vec<Token> = kept.map(|at| tokens[at].clone()).collect();
        (kept.len() < tokens.len()).then_some(kept)
    }
}

/// Whether an article and two nouns for bodies begin here that are no entry together.
fn is_compound(tokens: &[Token], at: usize, lexicon: &Lexicon) -> bool {
    let Some([article, word, noun]) = tokens.get(at..at + 3) else {
        return false;
    };
    let words = [word.lower.as_str(), noun.lower.as_str()];
    let plain = [word, noun]
        .iter()
        .all(|t| t.kind == Kind::Word && t.text == t.lower);
    let thing = |word: &str| lexicon.find(&[word], &[Class::Thing]).is_some();
    // "the top rod" is not another name of "the rod".
    let apart = APART.contains(&words[0]);
    let entry = lexicon
        .find(&words, &Class::ALL)
        .is_some_and(|found| found.length > 1);
    ARTICLES.contains(&article.lower.as_str())
        && plain
        && !apart
        && !entry
        && words.iter().all(|w| thing(w))
}
