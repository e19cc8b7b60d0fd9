//! The summation convention: an index that a term has twice is summed over the axes, and one that it has once runs over them.
//!
//! `L_i = I_{ij}\omega_j` is three lines with three terms each. ε_{ijk} and δ_{ij} are put in as the numbers that they are.

use crate::notation::ast::{Factor, FrameLabel, Kind, Line, Node, Number, Symbol, Term};
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::usage::symbols;
use crate::verify::lines::defined_squares::is_two;
use num_rational::BigRational;
use num_traits::{One, Zero};
use std::collections::BTreeMap;

/// Indices of a line that are free at most: an identity of two ε has four.
const FREE: usize = 4;
/// Indices of a term that are summed at most.
const SUMMED: usize = 4;
/// The axes.
const AXES: [&str; 3] = ["1", "2", "3"];

/// What a document sums over.
#[derive(Clone, Debug)]
pub(crate) struct Indices {
    /// Letters that are indices in this document.
    letters: Vec<char>,
    /// The lines that have some, as they are written.
    written: Vec<Line>,
}

impl Indices {
    /// The indices of a document that sums over them: those of an ε or a δ, and the usual ones.
    pub(crate) fn of(document: &Document) -> Option<Self> {
        let mut letters: Vec<char> = vec![];
        let mut permutes = false;
        let mut note = |node: &Node| {
            for indices in symbols(node).into_iter().filter_map(tensor_indices) {
                permutes |= indices.len() == 3;
                letters.extend(indices);
            }
        };
        let mut told = false;
        for item in &document.items {
            match item {
                Item::Formula(formula) => formula.rows.iter().for_each(|row| match row {
                    Row::Line(line) => line.sides.iter().for_each(&mut note),
                    Row::Expression(node) => note(node),
                    Row::Unreadable { .. } => {}
                }),
                Item::Prose { text, .. } => told |= tells(text),
                _ => {}
            }
        }
        letters.extend("ijklmn".chars());
        letters.sort_unstable();
        letters.dedup();
        (told || permutes).then_some(Self {
            letters,
            written: vec![],
        })
    }

    /// The line for each value of its free indices, or nothing where it has no index.
    pub(crate) fn lines(&self, line: &Line) -> Option<Vec<Line>> {
        let zero = |side: &&Node| !matches!(&side.kind, Kind::Number(n) if n.value.is_zero());
        let sides = line.sides.iter().filter(zero);
        let met: Vec<Vec<char>> = sides.map(|side| self.met(side)).collect();
        let mut frees = met.iter().map(|met| {
            let mut free = once(met);
            free.sort_unstable();
            free
        });
        let free = frees.next()?;
        let alike = frees.all(|other| other == free);
        if met.iter().all(Vec::is_empty) || !alike || free.len() > FREE {
            return None;
        }
        let each = assignments(&free).into_iter().map(|values| {
            let mut line = line.clone();
            for side in &mut line.sides {
                values
                    .iter()
                    .for_each(|(index, axis)| put(side, *index, axis));
                self.sum(side)?;
                settle(side);
            }
            Some(line)
        });
        each.collect()
    }

    /// Writes out the lines of the document, and keeps them as they were.
    pub(crate) fn write_out(&mut self, document: &mut Document) {
        for item in &mut document.items {
            let Item::Formula(formula) = item else {
                continue;
            };
            let rows = std::mem::take(&mut formula.rows);
            formula.rows = rows.into_iter().flat_map(|row| self.rows(row)).collect();
        }
    }

    fn rows(&mut self, row: Row) -> Vec<Row> {
        match row {
            Row::Line(line) => {
                let lines = self.lines(&line);
                let out = lines.map(|lines| lines.into_iter().map(Row::Line).collect());
                if out.is_some() {
                    self.written.push(line.clone());
                }
                out.unwrap_or_else(|| vec![Row::Line(line)])
            }
            Row::Expression(mut node) => {
                self.whole(&mut node);
                vec![Row::Expression(node)]
            }
            row => vec![row],
        }
    }

    /// The line that one with numbers for its indices was written as.
    pub(crate) fn as_written(&self, line: &Line) -> Option<&Line> {
        self.written
            .iter()
            .find(|written| written.span == line.span)
    }

    /// An expression in passing names the whole: `$L_i$` is the vector.
    fn whole(&self, node: &mut Node) {
        let indexed = |s: &String| !s.is_empty() && s.chars().all(|c| self.letters.contains(&c));
        node.change_symbols(&mut |symbol| {
            let count: usize = symbol
                .subscripts
                .iter()
                .filter(|s| indexed(s))
                .map(|s| s.chars().count())
                .sum();
            if symbol.style.vector || symbol.style.tensor {
                return;
            }
            symbol.subscripts.retain(|s| !indexed(s));
            symbol.style.vector |= count == 1;
            symbol.style.tensor |= count == 2;
        });
    }

    /// The indices in a subscript.
    fn within<'a>(&'a self, text: &'a str) -> impl Iterator<Item = char> + 'a {
        let all = text
            .chars()
            .all(|c| self.letters.contains(&c) || c.is_ascii_digit() || c == ',' || c == ' ');
        text.chars()
            .filter(move |c| all && self.letters.contains(c))
    }

    /// The indices of a node as often as one of its terms has them.
    fn met(&self, node: &Node) -> Vec<char> {
        match &node.kind {
            // What stands under a bold letter is a label.
            Kind::Symbol(symbol) if symbol.style.vector || symbol.style.tensor => vec![],
            Kind::Symbol(symbol) => {
                let texts = symbol.subscripts.iter();
                texts.flat_map(|text| self.within(text)).collect()
            }
            Kind::Sum(terms) => {
                let mut all: Vec<char> = vec![];
                for term in terms {
                    let free = once(&self.met(&term.node));
                    let new: Vec<char> = free.into_iter().filter(|c| !all.contains(c)).collect();
                    all.extend(new);
                }
                all
            }
            Kind::InFrame(inside, label) => {
                let mut met = self.met(inside);
                met.extend(self.within(&label.text));
                met
            }
            Kind::Power(base, exponent) if is_two(exponent) => {
                let met = self.met(base);
                met.iter().chain(&met).copied().collect()
            }
            Kind::Product(_) | Kind::Quotient(..) | Kind::Call(..) | Kind::Derivative { .. } => {
                let each = node.children().flat_map(|child| once(&self.met(child)));
                each.collect()
            }
            _ => {
                let children = node.children();
                children.flat_map(|child| self.met(child)).collect()
            }
        }
    }

    /// Sums over each index that a term has twice; nothing where there are too many.
    fn sum(&self, node: &mut Node) -> Option<()> {
        if matches!(node.kind, Kind::Sum(_) | Kind::Group(..) | Kind::Negate(_)) {
            return node
                .children_mut()
                .into_iter()
                .try_for_each(|child| self.sum(child));
        }
        let met = self.met(node);
        let mut twice: Vec<char> = met.clone();
        twice.sort_unstable();
        twice.dedup();
        twice.retain(|c| met.iter().filter(|m| *m == c).count() > 1);
        if twice.len() > SUMMED {
            return None;
        }
        if !twice.is_empty() {
            let terms = assignments(&twice).into_iter().map(|values| {
                let mut node = node.clone();
                values
                    .iter()
                    .for_each(|(index, axis)| put(&mut node, *index, axis));
                settle(&mut node);
                Term {
                    negative: false,
                    sign: node.span.before(),
                    node,
                }
            });
            node.kind = Kind::Sum(terms.collect());
        }
        node.children_mut()
            .into_iter()
            .try_for_each(|child| self.sum(child))
    }
}

/// Whether words say that indices are summed over.
fn tells(text: &str) -> bool {
    let text = text.to_lowercase();
    let index = text.contains("indices") || text.contains("index");
    let summed = text.contains("repeated") || text.contains("twice");
    index && summed || text.contains("summation convention")
}

/// The indices of an ε or a δ.
fn tensor_indices(symbol: &Symbol) -> Option<Vec<char>> {
    let [text] = symbol.subscripts.as_slice() else {
        return None;
    };
    let letters: Vec<char> = text.chars().filter(|c| !matches!(c, ' ' | ',')).collect();
    let indices = letters.iter().all(char::is_ascii_lowercase) && !letters.contains(&'x');
    (indices && rank(symbol) == Some(letters.len())).then_some(letters)
}

/// The number of indices of the permutation symbol and of the unit tensor.
fn rank(symbol: &Symbol) -> Option<usize> {
    match symbol.name.as_str() {
        "epsilon" | "varepsilon" => Some(3),
        "delta" => Some(2),
        _ => None,
    }
}

/// The indices that are met but once.
fn once(met: &[char]) -> Vec<char> {
    let mut counts: BTreeMap<char, usize> = BTreeMap::new();
    met.iter().for_each(|c| *counts.entry(*c).or_default() += 1);
    let single = met.iter().filter(|c| counts.get(c) == Some(&1));
    single.copied().collect()
}

/// Each way to give the indices values.
fn assignments(indices: &[char]) -> Vec<Vec<(char, &'static str)>> {
    indices.iter().fold(vec![vec![]], |all, &index| {
        let longer = |values: Vec<(char, &'static str)>| {
            AXES.map(|axis| {
                let mut values = values.clone();
                values.push((index, axis));
                values
            })
        };
        all.into_iter().flat_map(longer).collect()
    })
}

/// Puts an axis for an index, in subscripts and in labels of components.
fn put(node: &mut Node, index: char, axis: &str) {
    match &mut node.kind {
        Kind::Symbol(symbol) if !symbol.style.vector && !symbol.style.tensor => {
            for text in &mut symbol.subscripts {
                *text = text.replace(index, axis);
            }
        }
        Kind::InFrame(_, FrameLabel { text, .. }) => *text = text.replace(index, axis),
        _ => {}
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| put(child, index, axis));
}

/// Puts in the numbers that ε and δ are, and drops terms that vanish.
fn settle(node: &mut Node) {
    node.children_mut().into_iter().for_each(settle);
    let zero = |node: &Node| matches!(&node.kind, Kind::Number(n) if n.value.is_zero());
    let one = |f: &Factor| matches!(&f.node.kind, Kind::Number(n) if n.value.is_one());
    match &mut node.kind {
        Kind::Symbol(symbol) => {
            if let Some(value) = constant(symbol) {
                let number = number(value.unsigned_abs().into());
                node.kind = match value < 0 {
                    true => Kind::Negate(Box::new(Node {
                        kind: number,
                        span: node.span,
                    })),
                    false => number,
                };
            }
        }
        Kind::Negate(inside) | Kind::Group(_, inside) if zero(inside) => {
            node.kind = number(0);
        }
        Kind::Group(_, inside) if matches!(inside.kind, Kind::Negate(_)) => {
            node.kind = inside.kind.clone();
        }
        Kind::Product(factors) if factors.iter().any(|f| zero(&f.node)) => node.kind = number(0),
        Kind::Product(factors) => {
            let mut negative = false;
            for factor in factors.iter_mut() {
                if let Kind::Negate(inside) = &factor.node.kind {
                    negative = !negative;
                    factor.node = (**inside).clone();
                }
            }
            factors.retain(|f| !one(f));
            let rest = match factors.as_slice() {
                [] => number(1),
                [only] => only.node.kind.clone(),
                _ => Kind::Product(std::mem::take(factors)),
            };
            node.kind = signed(rest, negative, node);
        }
        Kind::Sum(terms) => {
            terms.retain(|term| !zero(&term.node));
            for term in terms.iter_mut() {
                if let Kind::Negate(inside) = &term.node.kind {
                    term.negative = !term.negative;
                    term.node = (**inside).clone();
                }
            }
            match terms.as_slice() {
                [] => node.kind = number(0),
                [only] => node.kind = signed(only.node.kind.clone(), only.negative, node),
                _ => {}
            }
        }
        _ => {}
    }
}

fn signed(kind: Kind, negative: bool, place: &Node) -> Kind {
    match negative {
        true => Kind::Negate(Box::new(Node {
            kind,
            span: place.span,
        })),
        false => kind,
    }
}

/// The value of an ε or a δ with numbers for indices.
fn constant(symbol: &Symbol) -> Option<i8> {
    let [text] = symbol.subscripts.as_slice() else {
        return None;
    };
    let axes: Vec<i8> = text
        .chars()
        .filter(|c| !matches!(c, ' ' | ','))
        .map(|c| AXES.iter().position(|a| a.starts_with(c)).map(|p| p as i8))
        .collect::<Option<_>>()?;
    match (rank(symbol)?, axes.as_slice()) {
        (3, &[a, b, c]) => Some((b - a) * (c - b) * (c - a) / 2),
        (2, &[a, b]) => Some(i8::from(a == b)),
        _ => None,
    }
}

fn number(value: u64) -> Kind {
    Kind::Number(Number {
        value: BigRational::from_integer(value.into()),
        decimals: None,
        exponent: 0,
    })
}
