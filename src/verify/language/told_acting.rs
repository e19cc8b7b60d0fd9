//! Loads that one thing exerts on another, as clauses: "`$N$` is the normal force of the floor on the wheel at C along y".

use super::reader::ARTICLES;
use super::rewrite::put_in;
use super::words::{Kind, Token};

/// A load with its letter: what it is, where it acts, and along what; or with the letters of its components.
#[derive(Clone)]
pub(super) struct Load<'t> {
    pub(super) noun: &'t [Token],
    pub(super) letter: Vec<Token>,
    pub(super) at: &'t [Token],
    pub(super) along: Vec<Token>,
    pub(super) components: bool,
}

/// What one clause says.
#[derive(Default)]
pub(super) struct Acting<'t> {
    pub(super) agent: &'t [Token],
    pub(super) body: &'t [Token],
    pub(super) at: &'t [Token],
    pub(super) along: Vec<Token>,
    pub(super) loads: Vec<Load<'t>>,
}

impl Acting<'_> {
    /// "`$N$` is the normal force of the floor on the wheel at C along y;" for each load.
    pub(super) fn clauses(&self, near: &Token) -> Vec<Token> {
        let word = |text: &str| put_in(Kind::Word, text, near);
        // A capital at the beginning of the sentence makes no name of an article.
        let agent: Vec<Token> = match self.agent {
            // "The load acts on gear 2": what the gear drives.
            [the, load] if the.lower == "the" && load.lower == "load" => {
                ["the", "machine"].map(word).to_vec()
            }
            [first, rest @ ..] if ARTICLES.contains(&first.lower.as_str()) => {
                [&[word(&first.lower)], rest].concat()
            }
            agent => agent.to_vec(),
        };
        let before = |text: &str, tokens: &[Token]| match tokens {
            [] => vec![],
            tokens => [&[word(text)], tokens].concat(),
        };
        let each = self.loads.iter().map(|load| {
            let at = if load.at.is_empty() { self.at } else { load.at };
            let along = if load.along.is_empty() {
                &self.along
            } else {
                &load.along
            };
            let is = match load.components {
                true => ["are", "the", "components"].map(word).to_vec(),
                false => ["is", "the"].map(word).to_vec(),
            };
            let (components, along) = match load.components {
                true => (
                    [along.as_slice(), &["of", "the"].map(word)].concat(),
                    vec![],
                ),
                false => (vec![], along.clone()),
            };
            [
                load.letter.as_slice(),
                &is,
                &components,
                load.noun,
                &before("of", &agent),
                &before("on", self.body),
                &before("at", at),
                &along,
                &[put_in(Kind::Semicolon, "", near)],
            ]
            .concat()
        });
        each.flatten().collect()
    }
}
