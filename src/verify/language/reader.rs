//! Goes along a sentence word by word.

use super::bodies::{LONGEST_NAME, WHOLE};
use super::body_words::may_name;
use super::lexicon::{Class, Found, Lexicon};
use super::statement::{Formula, Misread, NounPhrase, Term};
use super::words::{Kind, Token, wrong};
use crate::notation::document::{Document, Format, FrontMatter, Row};
use crate::notation::{Macros, read_formula, reread};
use crate::source::{Source, Span};
use std::collections::BTreeSet;

/// A phrase may stand in a phrase so many times.
const DEEPEST: usize = 12;

/// What is said of a thing.
pub(crate) const COPULAS: [&str; 7] = ["is", "are", "be", "denotes", "denote", "equals", "equal"];

/// Words before a noun that say nothing of it.
pub(crate) const ARTICLES: [&str; 6] = ["the", "a", "an", "its", "their", "each"];

/// Letters that are written by their names.
const GREEK: [&str; 18] = [
    "alpha", "beta", "gamma", "delta", "epsilon", "zeta", "eta", "theta", "iota", "kappa",
    "lambda", "rho", "sigma", "tau", "phi", "chi", "psi", "omega",
];

/// Words that hold a sentence together and name nothing.
const GLUE: [&str; 19] = [
    "and", "or", "that", "which", "where", "as", "means", "mean", "hold", "holds", "stands", "if",
    "when", "not", "so", "we", "it", "do", "us",
];

/// Whether a word in lower case holds a sentence together and names nothing.
pub(crate) fn is_glue(word: &str) -> bool {
    GLUE.contains(&word) || COPULAS.contains(&word)
}

/// Result of reading a part of a sentence.
pub(crate) type Read<T> = Result<T, Misread>;

/// What the clause before spoke of.
#[derive(Clone, Debug, Default)]
pub(crate) struct Before {
    /// The thing of which it said what a letter is.
    pub(crate) thing: Option<Term>,
    /// What it said a letter to be, or each of several letters.
    pub(crate) what: Vec<NounPhrase>,
}

/// A sentence that is being read.
#[derive(Debug)]
pub(crate) struct Reader<'a> {
    /// Its pieces.
    pub(crate) tokens: &'a [Token],
    /// How many of them are read.
    pub(crate) at: usize,
    /// The words of the language.
    pub(crate) lexicon: &'a Lexicon,
    /// What "its" and "their" mean here.
    pub(crate) owner: Vec<Term>,
    /// What the clause before spoke of.
    pub(crate) before: Before,
    /// Whether bodies are being spoken of "as particles"; inside that it is not said again.
    pub(crate) particles: bool,
    /// Whether the verb of the clause is read.
    pub(crate) in_predicate: bool,
    macros: &'a Macros,
    named: &'a BTreeSet<String>,
    lower: Vec<&'a str>,
    /// The line of the sentence, and the column at which it ends.
    place: (usize, usize),
    depth: usize,
}

impl<'a> Reader<'a> {
    /// At the beginning of a sentence that stands on a line and ends at a column; `named` are the
    /// bodies that the text introduces.
    pub(crate) fn new(
        tokens: &'a [Token],
        place: (usize, usize),
        lexicon: &'a Lexicon,
        macros: &'a Macros,
        named: &'a BTreeSet<String>,
    ) -> Self {
        Self {
            tokens,
            at: 0,
            lexicon,
            owner: vec![],
            before: Before::default(),
            particles: false,
            in_predicate: false,
            macros,
            named,
            lower: tokens.iter().map(|t| t.lower.as_str()).collect(),
            place,
            depth: 0,
        }
    }

    /// The piece that comes next.
    pub(crate) fn peek(&self) -> Option<&'a Token> {
        self.tokens.get(self.at)
    }

    /// What kind of piece comes next.
    pub(crate) fn kind(&self) -> Option<Kind> {
        self.peek().map(|token| token.kind)
    }

    /// The next word in lower case; empty where none comes.
    pub(crate) fn word(&self) -> &'a str {
        self.word_at(0)
    }

    /// A word further on in lower case.
    pub(crate) fn word_at(&self, ahead: usize) -> &'a str {
        let token = self.tokens.get(self.at + ahead);
        token.map_or("", |token| token.lower.as_str())
    }

    /// The words behind some others, in lower case.
    pub(crate) fn following(&self, ahead: usize) -> &[&'a str] {
        self.lower.get(self.at + ahead..).unwrap_or_default()
    }

    /// Whether all is read.
    pub(crate) fn done(&self) -> bool {
        self.at >= self.tokens.len()
    }

    /// Takes words if they come next.
    pub(crate) fn take(&mut self, words: &str) -> bool {
        let mut ahead = 0;
        for word in words.split(' ') {
            if self.word_at(ahead) != word {
                return false;
            }
            ahead += 1;
        }
        self.at += ahead;
        true
    }

    /// Takes one of some words.
    pub(crate) fn take_any(&mut self, words: &[&str]) -> bool {
        let found = !self.word().is_empty() && words.contains(&self.word());
        self.at += usize::from(found);
        found
    }

    /// Takes a sign if it comes next.
    pub(crate) fn take_sign(&mut self, kind: Kind) -> bool {
        let found = self.kind() == Some(kind);
        self.at += usize::from(found);
        found
    }

    /// Takes the comma or "and" between the members of a list.
    pub(crate) fn take_separator(&mut self) -> bool {
        let comma = self.take_sign(Kind::Comma);
        self.take("and") || comma
    }

    /// Takes what stands between signs of which the same is said: "a dot over `$a$` or `$b$`".
    pub(crate) fn take_choice(&mut self) -> bool {
        let comma = self.take_sign(Kind::Comma);
        self.take_any(&["and", "or"]) || comma
    }

    /// The longest entry of some classes that comes next.
    pub(crate) fn find(&self, classes: &[Class]) -> Option<Found<'a>> {
        self.lexicon.find(self.lower.get(self.at..)?, classes)
    }

    /// Takes the longest entry of some classes.
    pub(crate) fn take_entry(&mut self, classes: &[Class]) -> Option<Found<'a>> {
        let found = self.find(classes)?;
        self.at += found.length;
        Some(found)
    }

    /// Takes a whole number.
    pub(crate) fn take_number(&mut self) -> Option<usize> {
        let token = self.peek().filter(|t| t.kind == Kind::Number)?;
        let number = token.text.parse().ok()?;
        self.at += 1;
        Some(number)
    }

    /// How many of the next words are the name of a body that the text introduces; 0 for none.
    pub(crate) fn introduced(&self, ahead: usize) -> usize {
        if self.named.is_empty() {
            return 0;
        }
        let words = self.following(ahead);
        let longest = LONGEST_NAME.min(words.len());
        let mut lengths = (1..=longest).rev();
        let named = |length: &usize| self.named.contains(&words[..*length].join(" "));
        let length = lengths.find(named).unwrap_or(0);
        match length == 1 && words.first() == Some(&WHOLE) {
            true => usize::from(self.is_noun(ahead + 1)),
            false => length,
        }
    }

    /// Whether a word is the noun before these words: "the whole" is a body, but "the whole satellite" is the satellite, and
    /// "the whole of the body" the body.
    fn is_noun(&self, behind: usize) -> bool {
        let words = self.following(behind);
        let hangs = self.lexicon.find(words, &[Class::Preposition]).is_some();
        match hangs {
            true => words.first() != Some(&"of"),
            false => !self.noun_behind(behind) && self.introduced(behind) == 0,
        }
    }

    /// Whether the next word is the name of a thing: it has a capital, a digit or a mark in it, or it is short, and the
    /// language has no such word.
    pub(crate) fn at_name(&self) -> bool {
        let Some(token) = self.peek().filter(|t| t.kind == Kind::Word) else {
            return false;
        };
        let word = token.lower.as_str();
        if self.is_glue() || self.introduced(0) > 0 {
            return false;
        }
        if token.text.chars().count() == 1 && token.text != "a" {
            return token.text != "A" || !self.article_here();
        }
        if ARTICLES.contains(&word) || self.lexicon.begins(word) || !may_name(word) {
            return false;
        }
        if GREEK.contains(&word) {
            return true;
        }
        let marked = |c: char| c.is_uppercase() || c.is_ascii_digit() || "_'′’^".contains(c);
        token.text.chars().any(marked) || token.text.chars().count() <= 2
    }

    /// Whether the next word holds a sentence together and names nothing.
    pub(crate) fn is_glue(&self) -> bool {
        is_glue(self.word())
    }

    /// Whether "A" is an article where it stands and no name: a word follows that can be named.
    fn article_here(&self) -> bool {
        let nameable = [
            Class::Noun,
            Class::Place,
            Class::Thing,
            Class::Adjective,
            Class::Mark,
            Class::Custom,
        ];
        let rest = self.following(1);
        self.at == 0
            && (self.lexicon.find(rest, &nameable).is_some() || self.introduced(1) > 0)
            && self.lexicon.find(rest, &[Class::Verb]).is_none()
    }

    /// Goes into a phrase of a phrase.
    pub(crate) fn deeper<T>(&mut self, read: impl FnOnce(&mut Self) -> Read<T>) -> Read<T> {
        if self.depth == DEEPEST {
            return Err(self.error(
                "the phrases stand too deep in one another",
                "say it in several sentences",
            ));
        }
        self.depth += 1;
        let result = read(self);
        self.depth -= 1;
        result
    }

    /// Whether a phrase is read that hangs on another, or on a verb.
    pub(crate) fn hangs(&self) -> bool {
        self.depth > 1
    }

    /// An error at the next piece.
    pub(crate) fn error(&self, message: &str, help: &str) -> Misread {
        let (line, end) = self.place;
        let column = self.peek().map_or(end, |token| token.column);
        wrong(line, column, message, help)
    }

    /// An error at the next piece, which is none of some classes; `wanted` says what could stand there.
    pub(crate) fn unexpected(&self, what: &str, wanted: &str, classes: &[Class]) -> Misread {
        let Some(token) = self.peek() else {
            return self.error("the sentence ends too early", wanted);
        };
        let shown = match token.kind {
            Kind::Formula => format!("${}$", token.text),
            Kind::Plain | Kind::Quoted => format!("\"{}\"", token.text),
            _ => token.text.clone(),
        };
        let near = (token.kind == Kind::Word && !self.lexicon.begins(&token.lower))
            .then(|| self.lexicon.nearest(&token.lower, classes))
            .flatten();
        let help = near.map_or_else(
            || wanted.to_owned(),
            |near| format!("did you mean `{near}`?"),
        );
        self.error(&format!("`{shown}` is no {what} here"), &help)
    }

    /// The formula that comes next, a list `i, j, k` as several.
    pub(crate) fn formulas(&mut self) -> Vec<Formula> {
        let Some(token) = self.peek() else {
            return vec![];
        };
        let plain = match token.kind {
            Kind::Formula => false,
            Kind::Plain => true,
            _ => return vec![],
        };
        self.at += 1;
        let rows = rows(&token.text, plain, self.macros);
        let parts: Vec<Formula> = match rows.len() {
            0 | 1 => vec![],
            _ => rows
                .iter()
                .filter_map(|row| self.part(&token.text, row, plain))
                .collect(),
        };
        if parts.len() == rows.len() && parts.len() > 1 {
            return parts;
        }
        let row = rows.into_iter().next();
        vec![Formula {
            source: token.text.clone(),
            row: row.unwrap_or_else(unread),
        }]
    }

    /// Whether a formula comes next.
    pub(crate) fn at_formula(&self) -> bool {
        matches!(self.kind(), Some(Kind::Formula | Kind::Plain))
    }

    /// A formula that a sentence says with words between its parts.
    pub(crate) fn formula(&self, text: &str, plain: bool) -> Option<Formula> {
        formula(text, plain, self.macros)
    }

    /// A member of a list of formulas, read on its own.
    fn part(&self, text: &str, row: &Row, plain: bool) -> Option<Formula> {
        let span = match row {
            Row::Line(line) => line.span,
            Row::Expression(node) => node.span,
            Row::Unreadable { .. } => return None,
        };
        let source = text.get(span.range())?.trim();
        let row = rows(source, plain, self.macros).into_iter().next()?;
        (!source.is_empty()).then(|| Formula {
            source: source.to_owned(),
            row,
        })
    }
}

/// A formula by its source.
pub(super) fn formula(source: &str, plain: bool, macros: &Macros) -> Option<Formula> {
    let row = rows(source, plain, macros).into_iter().next()?;
    let source = source.to_owned();
    Some(Formula { source, row })
}

/// The rows of a formula, spans counted from its first byte. One with a command and its argument is no plain text.
pub(crate) fn rows(text: &str, plain: bool, macros: &Macros) -> Vec<Row> {
    if !plain || text.contains('\\') && text.contains('{') {
        return read_formula(text, 0, macros);
    }
    let document = Document {
        format: Format::Text,
        source: Source::new("", ""),
        cells: vec![],
        front_matter: FrontMatter::default(),
        macros: macros.clone(),
        items: vec![],
    };
    reread(&document, text)
}

fn unread() -> Row {
    Row::Unreadable {
        message: "nothing stands here".into(),
        help: None,
        span: Span::default(),
    }
}
