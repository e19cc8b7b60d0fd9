//! Three letters that the words call the components of the angular velocity: "$u$, $v$, $w$ are the components of the
//! angular velocity".

use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::has_any;

/// Words between a list of letters and what the letters are.
const VERBS: &[&str] = &["denote ", "are ", "be ", "being ", "stand for ", "mean "];
/// Words between what letters are and a list of them.
const LEADS: &[&str] = &["are", "be", "by", "as", "called", "components", "velocity"];
/// Words of components that are not those along the axes of the body.
const ELSEWHERE: &[&str] = &["space", "inertial", "fixed axes", "laboratory", "relative"];

impl Reading {
    /// Takes three letters in a row that the words before or behind them call so.
    pub(crate) fn named_rates(&mut self, document: &Document) {
        let mut row: Vec<Letter> = vec![];
        let mut before = String::new();
        for item in &document.items {
            match item {
                Item::Formula(formula) => match letters(formula) {
                    Some(more) => row.extend(more),
                    None => row.clear(),
                },
                Item::Prose { text, .. } => {
                    let text = text.to_lowercase();
                    let words: Vec<&str> = text.split_whitespace().collect();
                    let words = words.join(" ");
                    if !row.is_empty() && matches!(words.as_str(), "," | "and" | ", and") {
                        continue;
                    }
                    if called_behind(&words)
                        || called_before(&before)
                        || called_around(&before, &words)
                    {
                        self.take_rates(&row);
                    }
                    row.clear();
                    before = words;
                }
                _ => {
                    row.clear();
                    before.clear();
                }
            }
        }
    }

    fn take_rates(&mut self, row: &[Letter]) {
        let [first, second, third] = row else { return };
        let apart = first != second && second != third && first != third;
        let plain = row.iter().all(|letter| {
            let used = self.usage.get(letter);
            let number = used.vector + used.component == 0;
            number && !matches!(letter.name.as_str(), "x" | "y" | "z" | "t")
        });
        if apart && plain {
            let rates = [first, second, third].map(Clone::clone);
            self.take_components(rates, Quantity::AngularVelocity);
        }
    }
}

/// The letters without index that a formula lists and nothing else.
fn letters(formula: &Formula) -> Option<Vec<Letter>> {
    let rows = formula.rows.iter().map(|row| match row {
        Row::Expression(node) => listed(node),
        _ => None,
    });
    Some(rows.collect::<Option<Vec<_>>>()?.concat())
}

fn listed(node: &Node) -> Option<Vec<Letter>> {
    match &inner(node).kind {
        Kind::Symbol(symbol) if symbol.subscripts.is_empty() && symbol.primes == 0 => {
            Some(vec![Letter::of(symbol)])
        }
        Kind::Tuple(entries) => {
            let entries = entries.iter().map(listed);
            Some(entries.collect::<Option<Vec<_>>>()?.concat())
        }
        _ => None,
    }
}

/// "denote the components of the angular velocity on the principal axes".
fn called_behind(words: &str) -> bool {
    let clause = words.split(['.', ';']).next().unwrap_or_default();
    let said = VERBS.iter().find_map(|verb| clause.strip_prefix(verb));
    said.is_some_and(|said| names_components(said).is_some_and(|at| at < 24))
}

/// "the components of the angular velocity along the principal axes are".
fn called_before(words: &str) -> bool {
    let clause = words.rsplit(['.', ';']).next().unwrap_or_default();
    let leads = LEADS
        .iter()
        .any(|lead| clause.ends_with(&format!(" {lead}")));
    leads && names_components(clause).is_some()
}

/// "the components $p$, $q$, $r$ of the angular velocity".
fn called_around(before: &str, behind: &str) -> bool {
    let clause = behind.split(['.', ';', ',']).next().unwrap_or_default();
    let of = ["of the angular velocity", "of its angular velocity"];
    let elsewhere = has_any(before, ELSEWHERE) || has_any(clause, ELSEWHERE);
    before.ends_with("components") && of.iter().any(|of| clause.starts_with(of)) && !elsewhere
}

/// Where a clause speaks of the components of the angular velocity on the axes of the body.
fn names_components(clause: &str) -> Option<usize> {
    if has_any(clause, ELSEWHERE) {
        return None;
    }
    let near = clause.find("angular velocity components");
    near.or_else(|| {
        let at = clause.find("components of ")?;
        let behind = clause[at..].split_whitespace().skip(2).take(4);
        let named: Vec<&str> = behind.collect();
        let named = named.join(" ");
        named.contains("angular velocity").then_some(at)
    })
}
