//! The summation convention: an index that a term has twice is summed over the axes, and one that it has once runs over them.
//!
//! `L_i = I_{ij}\omega_j` is three lines with three terms each. ε_{ijk} and δ_{ij} are put in as the numbers that they are.

use crate::notation::ast::{FrameLabel, Kind, Line, Node, Symbol, Term};
use crate::notation::document::{Document, Item, Row};
use crate::source::Span;
use crate::verify::letters::usage::symbols;
use crate::verify::lines::defined_squares::is_two;
use crate::verify::lines::index::{MOST_NODES, size};
use crate::verify::lines::unit_tensors::{AXES, settle, tensor_indices};
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};

/// Indices of a line that are free at most: an identity of two ε has four.
const FREE: usize = 4;
/// Indices of a term that are summed at most.
const SUMMED: usize = 4;

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
        let (mut permutes, mut names) = (false, BTreeSet::new());
        let mut note = |node: &Node| {
            names.extend(symbols(node).into_iter().map(|s| s.name.clone()));
            for indices in symbols(node).into_iter().filter_map(tensor_indices) {
                permutes |= indices.len() == 3;
                letters.extend(indices);
            }
        };
        let mut defines = false;
        let mut told = false;
        for item in &document.items {
            match item {
                Item::Formula(formula) => formula.rows.iter().for_each(|row| match row {
                    Row::Line(line) => {
                        defines |= defines_elements(line);
                        defines |= line.sides.iter().any(sums_elements);
                        line.sides.iter().for_each(&mut note);
                    }
                    Row::Expression(node) => note(node),
                    Row::Unreadable { .. } => {}
                }),
                Item::Prose { text, .. } => told |= tells(text),
                _ => {}
            }
        }
        letters.extend("ijk".chars());
        // A letter of the document's own is no index: the n of `I_n = \sum I_{ij} n_i n_j`.
        letters.extend("lmn".chars().filter(|c| !names.contains(&c.to_string())));
        letters.sort_unstable();
        letters.dedup();
        (told || permutes || defines).then_some(Self {
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
        let sums = |side: &Node| self.sums(side) || self.repeats(side);
        let none = met.iter().all(Vec::is_empty) && !line.sides.iter().any(sums);
        if none || !alike || free.len() > FREE {
            return None;
        }
        let mut left = MOST_NODES;
        let each = assignments(&free).into_iter().map(|values| {
            let mut line = line.clone();
            for side in &mut line.sides {
                values
                    .iter()
                    .for_each(|(index, axis)| put(side, *index, axis));
                self.sum(side, &mut left)?;
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

    /// Whether a line that stands here has a running index.
    pub(crate) fn wrote(&self, span: Span) -> bool {
        self.written.iter().any(|written| written.span == span)
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
            Kind::IndexedSum { index, body, .. } => {
                let mut met = self.met(body);
                met.retain(|c| !index.name.starts_with(*c));
                met
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

    /// Whether a sum over an index is written out in a node.
    fn sums(&self, node: &Node) -> bool {
        self.index_of_sum(node).is_some() || node.children().any(|child| self.sums(child))
    }

    /// Whether a term of a sum has an index twice: `N_1 = I_{1j}\dot\omega_j + …`.
    fn repeats(&self, node: &Node) -> bool {
        if let Kind::Sum(terms) = &node.kind {
            return terms.iter().any(|term| self.repeats(&term.node));
        }
        let met = self.met(node);
        let index = !matches!(node.kind, Kind::IndexedSum { .. } | Kind::Integral { .. });
        index && once(&met).len() < met.len()
    }

    /// The index of `\sum_j I_{ij} ω_j`; not that of the particles of a body, which have a mass each.
    fn index_of_sum(&self, node: &Node) -> Option<char> {
        let Kind::IndexedSum { index, body, .. } = &node.kind else {
            return None;
        };
        let letter = index.name.chars().next()?;
        let particles = |s: &&Symbol| s.name == "m" && s.subscripts.contains(&index.name);
        let runs = index.name.len() == 1 && self.letters.contains(&letter);
        let particles = symbols(body).iter().any(particles);
        (runs && !particles).then_some(letter)
    }

    /// Sums over each index that a term has twice, or that a sum is written over; nothing where there are too many, or
    /// too many nodes come of it.
    fn sum(&self, node: &mut Node, left: &mut usize) -> Option<()> {
        if let Some(letter) = self.index_of_sum(node)
            && let Kind::IndexedSum { body, .. } = &node.kind
        {
            node.kind = terms_of(body, &[letter], left)?;
        }
        if matches!(node.kind, Kind::Sum(_) | Kind::Group(..) | Kind::Negate(_)) {
            let mut children = node.children_mut().into_iter();
            return children.try_for_each(|child| self.sum(child, left));
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
            node.kind = terms_of(node, &twice, left)?;
        }
        let mut children = node.children_mut().into_iter();
        children.try_for_each(|child| self.sum(child, left))
    }
}

/// The sum of a term over indices that it has, if so many nodes are left.
fn terms_of(term: &Node, indices: &[char], left: &mut usize) -> Option<Kind> {
    let terms = AXES.len().checked_pow(indices.len() as u32)?;
    *left = left.checked_sub(terms.checked_mul(size(term))?)?;
    let terms = assignments(indices).into_iter().map(|values| {
        let mut node = term.clone();
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
    Some(Kind::Sum(terms.collect()))
}

/// `I_{ij} = ∫(δ_{ij} r² − x_i x_j) dm`: the elements of a tensor, all nine at once.
fn defines_elements(line: &Line) -> bool {
    let [left, rest @ ..] = line.sides.as_slice() else {
        return false;
    };
    let Kind::Symbol(element) = &left.kind else {
        return false;
    };
    let pair = |indices: &[char]| matches!(indices, [a, b] if a != b);
    let mut units = rest.iter().flat_map(symbols).filter_map(|symbol| {
        let indices = tensor_indices(symbol).filter(|indices| pair(indices));
        indices.map(|_| &symbol.subscripts)
    });
    units.any(|indices| *indices == element.subscripts)
}

/// `\sum_j I_{ij} …`: a sum over an index of a tensor's elements.
fn sums_elements(node: &Node) -> bool {
    let sums = match &node.kind {
        Kind::IndexedSum { index, body, .. } => {
            let pair = |text: &String| {
                let indices = ('i'..='n').contains(&text.chars().next().unwrap_or(' '));
                indices && text.chars().count() == 2 && text.contains(index.name.as_str())
            };
            let elements = |s: &&Symbol| s.subscripts.iter().any(pair);
            index.name.len() == 1 && symbols(body).iter().any(elements)
        }
        _ => false,
    };
    sums || node.children().any(sums_elements)
}

/// Whether words say that indices are summed over.
fn tells(text: &str) -> bool {
    let text = text.to_lowercase();
    let index = text.contains("indices") || text.contains("index");
    let summed = text.contains("repeated") || text.contains("twice");
    index && summed || text.contains("summation convention")
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
