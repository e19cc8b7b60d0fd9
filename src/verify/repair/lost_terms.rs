//! Terms that a false line has lost: ω × L of a rate, or what its difference shows.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::correction::edit::{Edit, dotted, undotted};
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::names;
use crate::verify::repair::first_symbol;
use crate::verify::repair::lost_vectors::added;
use crate::verify::repair::trial::Search;
use crate::verify::theory::law::Axes;
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

    /// The rates of the inertia, where the rate of I ω was taken as if I were constant: `İ ω` beside each `I ω̇`.
    pub(crate) fn inertia_held(
        &mut self,
        line: &Line,
        search: &mut Search<'_>,
    ) -> Option<Diagnosis> {
        if self.theory.setting.axes != Axes::Turning {
            return None;
        }
        let mut edits = vec![];
        for side in &line.sides {
            let mut terms = vec![];
            innermost(side, false, &mut terms);
            let terms = terms.into_iter();
            edits.extend(terms.filter_map(|(term, negative)| self.other_half(term, negative)));
        }
        let all: Vec<&Edit> = edits.iter().collect();
        (!all.is_empty())
            .then(|| self.tried(&all, search))
            .flatten()
    }

    /// `+ İ ω` behind a term `I ω̇`.
    fn other_half(&self, term: &Node, negative: bool) -> Option<Edit> {
        let Kind::Product(factors) = &inner(term).kind else {
            return None;
        };
        let is_inertia = |node: &Node| {
            let of = |s: &Symbol| self.reading.quantities.get(&Letter::of(s)).copied();
            matches!(&node.kind, Kind::Symbol(s) if of(s) == Some(Quantity::Inertia))
        };
        let mut texts = vec![];
        let (mut inertia, mut rate) = (0, 0);
        for factor in factors {
            let text = self.document.source.slice(factor.node.span).trim();
            let single = matches!(factor.node.kind, Kind::TimeDerivative { order: 1, .. });
            texts.push(match (is_inertia(&factor.node), single) {
                (true, _) => {
                    inertia += 1;
                    dotted(text)
                }
                (_, true) => {
                    rate += 1;
                    undotted(text)?
                }
                _ => text.to_owned(),
            });
        }
        let sign = if negative { '-' } else { '+' };
        ((inertia, rate) == (1, 1)).then(|| Edit {
            span: term.span.behind(),
            text: format!(" {sign} {}", texts.join(" ")),
            kind: "missing-term",
            message: "the inertia changes on axes that do not turn with the body".to_owned(),
            cost: 13,
        })
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

/// The terms of a side, those in brackets too, each with the sign that stands before it.
fn innermost<'n>(node: &'n Node, negative: bool, terms: &mut Vec<(&'n Node, bool)>) {
    match &inner(node).kind {
        Kind::Sum(all) => all
            .iter()
            .for_each(|term| innermost(&term.node, term.negative, terms)),
        Kind::Negate(inside) => innermost(inside, true, terms),
        _ => terms.push((node, negative)),
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
