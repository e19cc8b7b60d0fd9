//! Which convention of products of inertia a submission keeps.

use crate::grade::key::Key;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::{Verdict, written_symbols};

/// The convention of a submission.
#[derive(Clone, Debug, PartialEq, Eq)]
pub(super) struct Products {
    /// Whether products of inertia are entries of the tensor.
    pub(super) entries: bool,
    /// Said where it is not that of the sheet.
    pub(super) note: Option<String>,
}

/// Letters of tensors of inertia.
const TENSORS: [&str; 2] = ["I", "J"];

/// Whether products of inertia are entries: as the submission sets, or its matrices and integrals show, else as the key has
/// it.
pub(super) fn products(key: &Key, said: Option<&str>, documents: &[Document]) -> Products {
    let (entries, by) = match said {
        Some("entries") => (true, "your file says so"),
        Some("integrals") => (false, "your file says so"),
        _ => match shown(documents).or_else(|| proved(key, documents)) {
            Some((entries, by)) => (entries, by),
            None => (key.entries, ""),
        },
    };
    let note = (entries != key.entries).then(|| {
        let convention = match entries {
            true => "the entries of the matrix",
            false => "the integrals, whose negatives stand in the matrix",
        };
        format!("your products of inertia are taken as {convention}, because {by}; the sheet has it the other way")
    });
    Products { entries, note }
}

/// As the first matrix or integral shows in which products of inertia stand.
fn shown(documents: &[Document]) -> Option<(bool, &'static str)> {
    let mut lines = documents.iter().flat_map(Document::lines);
    lines.find_map(|line| {
        let mut sides = line.sides.iter();
        let by_matrix = sides.find_map(in_tree).map(|entries| (entries, MATRIX));
        let by_integral = || match line.sides.as_slice() {
            [
                Node {
                    kind: Kind::Symbol(symbol),
                    ..
                },
                ..,
                last,
            ] if product_of(symbol).is_some() => integral(last).map(|entries| (entries, INTEGRAL)),
            _ => None,
        };
        by_matrix.or_else(by_integral)
    })
}

const MATRIX: &str = "your matrix shows it";
const INTEGRAL: &str = "your integral shows it";

/// What the first matrix of inertia in a tree shows.
fn in_tree(node: &Node) -> Option<bool> {
    let own = match &node.kind {
        Kind::Matrix(rows) if is_square(rows) => of_matrix(rows),
        _ => None,
    };
    own.or_else(|| node.children().find_map(in_tree))
}

fn is_square(rows: &[Vec<Node>]) -> bool {
    rows.len() == 3 && rows.iter().all(|row| row.len() == 3)
}

/// Whether the products of inertia stand in a matrix with a plus; none where it has no moments of inertia on its diagonal, or
/// signs of both kinds.
fn of_matrix(rows: &[Vec<Node>]) -> Option<bool> {
    let moment = |at: usize| match &rows[at][at].kind {
        Kind::Symbol(symbol) => TENSORS.contains(&symbol.name.as_str()),
        _ => false,
    };
    if !(0..3).all(moment) {
        return None;
    }
    let entries = (0..3).flat_map(|row| (0..3).map(move |column| (row, column)));
    let beside = entries.filter(|(row, column)| row != column);
    let signs: Option<Vec<Option<bool>>> = beside
        .map(|(row, column)| sign(&rows[row][column]))
        .collect();
    let signs: Vec<bool> = signs?.into_iter().flatten().collect();
    match signs.as_slice() {
        [first, others @ ..] if others.iter().all(|sign| sign == first) => Some(*first),
        _ => None,
    }
}

/// The sign of a product of inertia; an inner none where there is a zero, and none where there is anything else.
fn sign(entry: &Node) -> Option<Option<bool>> {
    match &entry.kind {
        Kind::Symbol(symbol) => product_of(symbol).map(|()| Some(true)),
        Kind::Number(number) => num_traits::Zero::is_zero(&number.value).then_some(None),
        Kind::Negate(inner) => match sign(inner)? {
            Some(sign) => Some(Some(!sign)),
            None => Some(None),
        },
        Kind::Group(_, inner) => sign(inner),
        _ => None,
    }
}

/// Whether a letter is a product of inertia: its two indices differ.
fn product_of(symbol: &Symbol) -> Option<()> {
    let index: String = symbol.subscripts.concat();
    let mut letters = index.chars();
    let (first, second) = (letters.next()?, letters.next()?);
    let two = letters.next().is_none() && first != second;
    (two && TENSORS.contains(&symbol.name.as_str())).then_some(())
}

/// Whether an integral over the mass has a minus before it.
fn integral(side: &Node) -> Option<bool> {
    match &side.kind {
        Kind::Integral { integrand, .. } => match &integrand.kind {
            Kind::Negate(_) => Some(true),
            Kind::Product(_) => Some(false),
            _ => None,
        },
        Kind::Negate(inner) => integral(inner).map(|negative| !negative),
        Kind::Group(_, inner) => integral(inner),
        _ => None,
    }
}

/// As the matrices show that hold in one convention alone.
fn proved(key: &Key, documents: &[Document]) -> Option<(bool, &'static str)> {
    if !key.is_declared
        || documents
            .iter()
            .all(|document| matrix_lines(document).is_empty())
    {
        return None;
    }
    let good = |entries: bool| {
        let meaning = &key.stages[0].meaning[usize::from(entries)];
        let matrices = documents.iter().flat_map(|document| {
            let spans = matrix_lines(document);
            let findings = meaning.judge(document, &written_symbols(document)).findings;
            findings
                .into_iter()
                .filter(move |f| spans.contains(&f.span))
        });
        let verdicts: Vec<bool> = matrices
            .map(|f| matches!(f.verdict, Verdict::Proved(_)))
            .collect();
        !verdicts.is_empty() && verdicts.iter().all(|proved| *proved)
    };
    (good(!key.entries) && !good(key.entries)).then_some((!key.entries, MATRIX))
}

/// The lines in which a square matrix is written out.
fn matrix_lines(document: &Document) -> Vec<Span> {
    fn square(node: &Node) -> bool {
        matches!(&node.kind, Kind::Matrix(rows) if is_square(rows)) || node.children().any(square)
    }
    let squares = document
        .lines()
        .filter(|line| line.sides.iter().any(square));
    squares.map(|line| line.span).collect()
}
