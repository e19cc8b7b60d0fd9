//! Each member of a chain `a = b = c` is a line of its own, as where its rows stand below each other.

use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::notation::document::{Document, Item, Row};
use crate::source::{Source, Span};

/// Parts the chains of a document, but for those that only set quantities equal: `I_{xy} = I_{yz} = 0` says one thing.
pub(super) fn part(document: &mut Document) {
    let source = &document.source;
    for item in &mut document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        if formula.rows.iter().any(is_chain) {
            let rows = std::mem::take(&mut formula.rows).into_iter();
            formula.rows = rows.flat_map(|row| members(source, row)).collect();
        }
    }
}

fn is_chain(row: &Row) -> bool {
    let Row::Line(line) = row else { return false };
    let equal = |(relation, _): &(Relation, Span)| *relation == Relation::Equal;
    line.relations.len() > 1 && line.relations.iter().all(equal) && !line.sides.iter().all(is_bare)
}

/// Whether a side is a quantity or a number, and nothing was worked out to write it.
fn is_bare(side: &Node) -> bool {
    match &side.kind {
        Kind::Number(_) | Kind::Symbol(_) | Kind::Bold(_) => true,
        Kind::Negate(inner) | Kind::Group(_, inner) => is_bare(inner),
        _ => false,
    }
}

fn members(source: &Source, row: Row) -> Vec<Row> {
    let line = match row {
        Row::Line(line) if line.relations.len() > 1 => line,
        row => return vec![row],
    };
    let relations = line.relations.clone();
    let begins = relations.iter().map(|(_, sign)| sign.start).skip(1);
    let ends: Vec<u32> = begins.chain([line.span.end]).collect();
    let mut sides = line.sides.clone().into_iter();
    let mut head: Vec<Node> = match line.continues {
        true => vec![],
        false => sides.by_ref().take(1).collect(),
    };
    let members = relations.into_iter().zip(sides).zip(ends).enumerate();
    let members = members.map(|(at, ((relation, side), end))| {
        let start = match at {
            0 => line.span.start,
            _ => relation.1.start,
        };
        let last = end == line.span.end;
        let mut sides = std::mem::take(&mut head);
        sides.push(side);
        Row::Line(Line {
            sides,
            relations: vec![relation],
            continues: line.continues || at > 0,
            labels: line.labels.clone(),
            ranges: line.ranges.clone(),
            remarks: if last { line.remarks.clone() } else { vec![] },
            span: trimmed(source, Span { start, end }),
        })
    });
    members.collect()
}

/// Without blanks and marks of alignment at the end.
fn trimmed(source: &Source, span: Span) -> Span {
    let text = source.slice(span);
    let left = text.trim_end_matches(|c: char| c.is_whitespace() || c == '&');
    let cut = u32::try_from(text.len() - left.len()).unwrap_or(0);
    Span {
        end: span.end - cut,
        ..span
    }
}
