//! Which convention of products of inertia a submission keeps.

use crate::grade::key::Key;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Document, Item, Row};
use crate::source::Span;
use crate::verify::{Verdict, written_symbols};

/// Whether products of inertia are entries: as the submission sets or its matrices show, else as the key has it.
pub(super) fn products(key: &Key, documents: &[Document]) -> bool {
    let said = documents
        .iter()
        .find_map(|d| d.front_matter.products.as_deref());
    match said {
        Some("entries") => return true,
        Some("integrals") => return false,
        _ => {}
    }
    if !key.is_declared || !documents.iter().any(has_matrix) {
        return key.entries;
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
    if good(!key.entries) && !good(key.entries) {
        !key.entries
    } else {
        key.entries
    }
}

fn has_matrix(document: &Document) -> bool {
    !matrix_lines(document).is_empty()
}

/// The lines in which a square matrix is written out.
fn matrix_lines(document: &Document) -> Vec<Span> {
    fn square(node: &Node) -> bool {
        let own = matches!(&node.kind, Kind::Matrix(rows) if rows.len() == 3 && rows.iter().all(|row| row.len() == 3));
        own || node.children().any(square)
    }
    let formulas = document.items.iter().filter_map(|item| match item {
        Item::Formula(formula) => Some(formula),
        _ => None,
    });
    let lines = formulas.flat_map(|f| &f.rows).filter_map(|row| match row {
        Row::Line(line) => Some(line),
        _ => None,
    });
    let squares = lines.filter(|line| line.sides.iter().any(square));
    squares.map(|line| line.span).collect()
}
