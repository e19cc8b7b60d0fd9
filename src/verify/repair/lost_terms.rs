//! Terms that a false line has lost: ω × L of a rate, or what its difference shows.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::usage::Letter;
use crate::verify::names;
use crate::verify::repair::edit::Edit;
use crate::verify::repair::lost_vectors::added;
use crate::verify::repair::{Search, first_symbol};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::Diagnosis;
use num_traits::Zero;

impl Checker<'_> {
    /// `+ ω × L` at the end of a side, in the letters of the document.
    pub(crate) fn lost_transport(&self, line: &Line) -> Vec<Edit> {
        let rate = self
            .spelled_vector(Quantity::FrameRate)
            .or_else(|| self.spelled_vector(Quantity::AngularVelocity));
        let (Some(rate), Some(momentum)) = (rate, self.spelled_vector(Quantity::Momentum)) else {
            return vec![];
        };
        let times = if rate.is_ascii() { "\\times " } else { "× " };
        let term = format!("{rate} {times}{momentum}");
        let last = line.sides.last();
        last.map(|side| added(side, '+', &term))
            .into_iter()
            .collect()
    }

    /// A vector quantity as the document first writes it.
    pub(crate) fn spelled_vector(&self, quantity: Quantity) -> Option<String> {
        let letters: Vec<&Letter> = self
            .reading
            .quantities
            .iter()
            .filter(|(_, q)| **q == quantity)
            .map(|(l, _)| l)
            .collect();
        let vector = |s: &Symbol| {
            letters.contains(&&Letter::of(s))
                && s.subscripts.is_empty()
                && self.reading.usage.is_vector(&Letter::of(s))
        };
        let marked = first_symbol(self.document, &|s| {
            vector(s) && (s.style.vector || s.style.bar)
        });
        let node = marked.or_else(|| first_symbol(self.document, &vector))?;
        Some(self.document.source.slice(node).to_owned())
    }

    /// What the right side lacks, written in the author's letters, where it is short.
    pub(crate) fn lost_term(&mut self, line: &Line, search: &mut Search<'_>) -> Option<Diagnosis> {
        let sides = match (line.continues, self.last_side.clone()) {
            (true, Some(side)) => [vec![side], line.sides.clone()].concat(),
            _ => line.sides.clone(),
        };
        let reads = self.readings(&sides).ok()?;
        let (equations, last) = (&reads.first()?.equations, line.sides.last()?);
        let [equation] = equations.as_slice() else {
            return None;
        };
        let cells = cells(last, equation.residual.entries.len())?;
        let mut edits = vec![];
        for (cell, entry) in cells.iter().zip(&equation.residual.entries) {
            let reduced = self.theory.normal(entry);
            if reduced.is_zero() {
                continue;
            }
            if !reduced.is_polynomial() || reduced.numerator().len() > 3 {
                return None;
            }
            let text = names::fraction(&self.theory.atoms, &reduced);
            // Nobody writes a term in the functions of half an angle that the algebra works with.
            if text.contains("(\\tfrac{1}{2} ") {
                return None;
            }
            let joined = match text.strip_prefix('-') {
                Some(rest) => format!(" - {rest}"),
                None => format!(" + {text}"),
            };
            let message = format!("a term is missing:{joined}");
            let zero = matches!(&cell.kind, Kind::Number(n) if n.value.is_zero());
            let (span, text) = match zero {
                true => (cell.span, text),
                false => (cell.span.behind(), joined),
            };
            edits.push(Edit {
                span,
                text,
                kind: "missing-term",
                message,
                cost: 30,
            });
        }
        let all: Vec<&Edit> = edits.iter().collect();
        (!all.is_empty())
            .then(|| self.tried(&all, search))
            .flatten()
    }
}

/// The cells of a written column, or the whole side for a scalar.
fn cells(side: &Node, count: usize) -> Option<Vec<&Node>> {
    match &side.kind {
        _ if count == 1 => Some(vec![side]),
        Kind::Matrix(rows) if rows.iter().flatten().count() == count => {
            Some(rows.iter().flatten().collect())
        }
        Kind::Tuple(entries) if entries.len() == count => Some(entries.iter().collect()),
        Kind::Transpose(inner) => cells(inner, count),
        _ => None,
    }
}
