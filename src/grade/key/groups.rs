//! Which lines a label, or a comment beside a formula, speaks of.

use crate::notation::document::{Document, Formula, Item, Row};
use crate::source::Span;
use crate::verify::Finding;
use std::collections::BTreeMap;

/// The lines of one formula, or the one line where rows have labels of their own.
pub(super) struct Group {
    pub(super) lines: Vec<usize>,
    pub(super) labels: Vec<String>,
    /// What a comment beside it says of marks.
    pub(super) marks: Option<String>,
}

/// The lines that a label or a comment speaks of: all rows of a formula with one label; of a chain that goes on, the last.
pub(super) fn groups(document: &Document, findings: &[Finding]) -> Vec<Group> {
    let number: BTreeMap<Span, usize> = findings
        .iter()
        .enumerate()
        .map(|(at, f)| (f.span, at))
        .collect();
    let mut groups: Vec<Group> = vec![];
    let mut pending: Option<String> = None;
    // Where the lines of the last formula begin among the groups, and where it ends.
    let mut last_formula = (usize::MAX, 0);
    for item in &document.items {
        match item {
            Item::Comment { text, span } => {
                let Some(marks) = text.trim().strip_prefix("marks:") else {
                    continue;
                };
                let line = document.place(span.start).line;
                match groups.get_mut(last_formula.0) {
                    // Behind a formula, on its last line.
                    Some(group) if last_formula.1 == line => {
                        group.marks = Some(marks.trim().to_owned())
                    }
                    _ => pending = Some(marks.trim().to_owned()),
                }
            }
            Item::Formula(formula) => {
                let mut own = of_formula(formula, &number);
                if let Some(first) = own.first_mut() {
                    first.marks = pending.take();
                }
                last_formula = (
                    groups.len(),
                    document.place(formula.span.end.saturating_sub(1)).line,
                );
                groups.extend(own);
            }
            _ => {}
        }
    }
    groups
}

/// The lines of one formula.
fn of_formula(formula: &Formula, number: &BTreeMap<Span, usize>) -> Vec<Group> {
    let rows = formula.rows.iter().filter_map(|row| match row {
        Row::Line(line) => Some((line, *number.get(&line.span)?)),
        _ => None,
    });
    let rows: Vec<_> = rows.collect();
    let labelled = rows
        .iter()
        .filter(|(line, _)| !line.labels.is_empty())
        .count();
    let mut own: Vec<Group> = vec![];
    for (line, at) in rows {
        match own.last_mut() {
            Some(last) if line.continues => {
                last.lines = vec![at];
                last.labels.extend(line.labels.clone());
            }
            Some(last) if labelled < 2 => {
                last.lines.push(at);
                last.labels.extend(line.labels.clone());
            }
            _ => own.push(Group {
                lines: vec![at],
                labels: line.labels.clone(),
                marks: None,
            }),
        }
    }
    own
}
