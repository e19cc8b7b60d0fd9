//! Values out of a TOML tree, each checked, each complaint with its place.

use crate::diagnostic::Diagnostic;
use crate::scene::Quantity;
use crate::source::Span;
use std::ops::Range;
use std::path::PathBuf;
use toml::Spanned;
use toml::de::{DeTable, DeValue};

/// A value and its place.
pub(super) type Value<'a> = Spanned<DeValue<'a>>;

/// Complaints that are kept; a file of a million wrong keys needs no more.
const KEPT: usize = 100;

/// What was found wrong so far.
#[derive(Default)]
pub(super) struct Reader {
    pub(super) diagnostics: Vec<Diagnostic>,
    /// Where the scene lies, and the files that it names.
    pub(super) folder: PathBuf,
}

/// A table of the file.
#[derive(Clone, Copy)]
pub(super) struct Table<'a> {
    pub(super) entries: &'a DeTable<'a>,
    pub(super) span: Span,
    /// What it is, as a message says it.
    pub(super) what: &'static str,
}

impl<'a> Table<'a> {
    pub(super) fn get(&self, key: &str) -> Option<&'a Value<'a>> {
        self.entries.get(key)
    }
}

/// What a number has to be.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Bound {
    Any,
    NotNegative,
    Positive,
}

impl Bound {
    fn admits(self, value: f64) -> bool {
        match self {
            Self::Any => true,
            Self::NotNegative => value >= 0.0,
            Self::Positive => value > 0.0,
        }
    }

    fn said(self) -> &'static str {
        match self {
            Self::Any => "a number",
            Self::NotNegative => "not negative",
            Self::Positive => "positive",
        }
    }
}

/// The bytes of a range.
pub(super) fn span(range: Range<usize>) -> Span {
    Span::new(range.start, range.end)
}

impl Reader {
    pub(super) fn report(&mut self, diagnostic: Diagnostic) {
        if self.diagnostics.len() < KEPT {
            self.diagnostics.push(diagnostic);
        }
    }

    /// Reports a value that is not what it has to be.
    pub(super) fn wrong<T>(&mut self, value: &Value<'_>, message: impl Into<String>) -> Option<T> {
        self.report(Diagnostic::error("bad-value", span(value.span()), message));
        None
    }

    fn wrong_type<T>(&mut self, value: &Value<'_>, what: &str, wanted: &str) -> Option<T> {
        let found = value.get_ref().type_str();
        let message = format!("{what} has to be {wanted}, and is of the type {found}");
        self.report(Diagnostic::error("wrong-type", span(value.span()), message));
        None
    }

    /// The value as a table with no key but the known ones.
    pub(super) fn table<'a>(
        &mut self,
        value: &'a Value<'a>,
        what: &'static str,
        keys: &[&str],
    ) -> Option<Table<'a>> {
        let Some(entries) = value.get_ref().as_table() else {
            return self.wrong_type(value, what, "a table");
        };
        let table = Table {
            entries,
            span: span(value.span()),
            what,
        };
        self.known(&table, keys);
        Some(table)
    }

    /// Reports the keys of a table that mean nothing.
    pub(super) fn known(&mut self, table: &Table<'_>, keys: &[&str]) {
        for key in table.entries.keys() {
            let name: &str = key.get_ref();
            if keys.contains(&name) {
                continue;
            }
            let message = format!("{} has no key `{}`", table.what, shortened(name));
            let unknown = Diagnostic::error("unknown-key", span(key.span()), message);
            self.report(unknown.help(match nearest(name, keys.iter().copied()) {
                Some(near) => format!("write `{near}`"),
                None => format!("its keys are {}", keys.join(", ")),
            }));
        }
    }

    /// The value of a key that has to be there.
    pub(super) fn required<'a>(&mut self, table: &Table<'a>, key: &str) -> Option<&'a Value<'a>> {
        let value = table.get(key);
        if value.is_none() {
            let message = format!("{} needs the key `{key}`", table.what);
            self.report(Diagnostic::error("missing-key", table.span, message));
        }
        value
    }

    pub(super) fn text<'a>(&mut self, value: &'a Value<'a>, what: &str) -> Option<&'a str> {
        let text = value.get_ref().as_str();
        text.or_else(|| self.wrong_type(value, what, "a text"))
    }

    pub(super) fn flag(&mut self, value: &Value<'_>, what: &str) -> Option<bool> {
        let flag = value.get_ref().as_bool();
        flag.or_else(|| self.wrong_type(value, what, "true or false"))
    }

    pub(super) fn list<'a>(&mut self, value: &'a Value<'a>, what: &str) -> Option<&'a [Value<'a>]> {
        match value.get_ref().as_array() {
            Some(list) => Some(list),
            None => self.wrong_type(value, what, "a list"),
        }
    }

    /// One of some words.
    pub(super) fn word<T: Copy>(
        &mut self,
        value: &Value<'_>,
        what: &str,
        words: &[(&str, T)],
    ) -> Option<T> {
        let text = self.text(value, what)?;
        if let Some((_, found)) = words.iter().find(|(word, _)| *word == text) {
            return Some(*found);
        }
        let message = format!("`{}` is no {what}", shortened(text));
        let unknown = Diagnostic::error("bad-value", span(value.span()), message);
        let names: Vec<_> = words.iter().map(|(word, _)| *word).collect();
        self.report(unknown.help(match nearest(text, names.iter().copied()) {
            Some(near) => format!("write `{near}`"),
            None => format!("it can be {}", names.join(", ")),
        }));
        None
    }

    /// A whole number that is not negative.
    pub(super) fn whole(&mut self, value: &Value<'_>, what: &str) -> Option<u64> {
        let Some(integer) = value.get_ref().as_integer() else {
            return self.wrong_type(value, what, "a whole number");
        };
        match u64::from_str_radix(integer.as_str(), integer.radix()) {
            Ok(number) => Some(number),
            Err(_) => self.wrong(
                value,
                format!("{what} is {integer}, and has to be 0 … 2^64 − 1"),
            ),
        }
    }

    /// A finite number within its bound.
    pub(super) fn number(&mut self, value: &Value<'_>, what: &str, bound: Bound) -> Option<f64> {
        let number = match value.get_ref() {
            DeValue::Integer(integer) => i64::from_str_radix(integer.as_str(), integer.radix())
                .ok()
                .map(|n| n as f64),
            DeValue::Float(float) => float.as_str().parse().ok(),
            _ => return self.wrong_type(value, what, "a number"),
        };
        match number {
            None => self.wrong(value, format!("{what} does not fit into 64 bits")),
            Some(number) if !f64::is_finite(number) => {
                self.wrong(value, format!("{what} is {number}, and has to be finite"))
            }
            Some(number) if !bound.admits(number) => {
                let said = bound.said();
                self.wrong(value, format!("{what} is {number}, and has to be {said}"))
            }
            number => number,
        }
    }

    /// A number, `{ from, to }` or `{ mean, deviation }`.
    pub(super) fn quantity(
        &mut self,
        value: &Value<'_>,
        what: &str,
        bound: Bound,
    ) -> Option<Quantity> {
        if !value.get_ref().is_table() {
            return self.number(value, what, bound).map(Quantity::Fixed);
        }
        let keys = ["from", "to", "mean", "deviation"];
        let table = self.table(value, "a distribution", &keys)?;
        match ["from", "to", "mean", "deviation"].map(|key| table.get(key)) {
            [Some(from), Some(to), None, None] => {
                let (from, to) = (self.number(from, what, bound), self.number(to, what, bound));
                let (from, to) = (from?, to?);
                if from > to {
                    return self.wrong(
                        value,
                        format!("{what} goes from {from} to {to}, and has to ascend"),
                    );
                }
                Some(Quantity::Uniform { from, to })
            }
            [None, None, Some(mean), Some(deviation)] => {
                let mean = self.number(mean, what, bound);
                let deviation = self.number(deviation, "the deviation", Bound::NotNegative);
                Some(Quantity::Normal {
                    mean: mean?,
                    deviation: deviation?,
                })
            }
            _ => self.wrong(
                value,
                "a distribution is { from, to } or { mean, deviation }",
            ),
        }
    }

    /// A list of `N` quantities.
    pub(super) fn quantities<const N: usize>(
        &mut self,
        value: &Value<'_>,
        what: &str,
        bound: Bound,
    ) -> Option<[Quantity; N]> {
        self.components(value, what, N, bound)?.try_into().ok()
    }

    /// A list of `count` quantities.
    pub(super) fn components(
        &mut self,
        value: &Value<'_>,
        what: &str,
        count: usize,
        bound: Bound,
    ) -> Option<Vec<Quantity>> {
        let list = self.list(value, what)?;
        if list.len() != count {
            let found = list.len();
            return self.wrong(
                value,
                format!("{what} has {found} components, and has to have {count}"),
            );
        }
        let component = format!("a component of {what}");
        let found: Vec<_> = list
            .iter()
            .map(|value| self.quantity(value, &component, bound))
            .collect();
        found.into_iter().collect()
    }
}

/// The word that was probably meant: within a third of its length in typing slips, or told by its beginning.
fn nearest<'a>(word: &str, known: impl Iterator<Item = &'a str>) -> Option<&'a str> {
    let word = shortened(word).to_lowercase();
    known
        .map(|near| (strsim::damerau_levenshtein(&word, near), near))
        .filter(|(slips, near)| {
            *slips <= near.len().max(3) / 3 || (word.len() > 2 && near.starts_with(&word))
        })
        .min_by_key(|(slips, _)| *slips)
        .map(|(_, near)| near)
}

/// A word as a message quotes it: no longer than a name is.
fn shortened(word: &str) -> String {
    word.chars().take(40).collect()
}
