//! A mass, or another number, that a vector of a false line has lost.

use crate::notation::ast::{Kind, Line, Node, Operator};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::correction::edit::Edit;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::latex_name;

/// Places of a line that are looked at.
const PLACES: usize = 40;

impl Checker<'_> {
    /// Edits that multiply a vector of the line by the mass, in a line between vectors.
    pub(crate) fn lost_masses(&mut self, line: &Line) -> Vec<Edit> {
        let Some(mass) = self.spelled_mass() else {
            return vec![];
        };
        let mut places = vec![];
        for side in &line.sides {
            vectors(side, &mut places);
        }
        places.truncate(PLACES);
        places.retain(|place| self.is_vector(place));
        let edit = |place: &Node| {
            let text = self.document.source.slice(place.span);
            let text = match &place.kind {
                Kind::Sum(_) | Kind::Negate(_) => format!("{mass} ({text})"),
                _ => format!("{mass} {text}"),
            };
            Edit {
                span: place.span,
                text,
                kind: "factor",
                message: format!("a factor {mass} is missing"),
                cost: 12,
            }
        };
        let mut edits: Vec<Edit> = places.into_iter().map(edit).collect();
        let mut tails = vec![];
        line.sides
            .iter()
            .for_each(|side| tails_of_sums(side, &mut tails));
        let tails = tails.into_iter().take(PLACES);
        edits.extend(tails.map(|span| Edit {
            span,
            text: format!("{mass} ({})", self.document.source.slice(span)),
            kind: "factor",
            message: format!("a factor {mass} is missing"),
            cost: 12,
        }));
        edits
    }

    /// The mass as the document first writes it.
    fn spelled_mass(&self) -> Option<String> {
        let is_mass =
            |letter: &Letter| self.reading.quantities.get(letter) == Some(&Quantity::Mass);
        let mut written = self
            .document
            .lines()
            .flat_map(|l| &l.sides)
            .flat_map(symbols);
        let symbol = written.find(|s| s.subscripts.is_empty() && is_mass(&Letter::of(s)))?;
        Some(latex_name(&symbol.name))
    }

    fn is_vector(&mut self, node: &Node) -> bool {
        let value = self.lowering(Frame::Moving).value(node);
        value.is_ok_and(|value| value.entries.len() == 3)
    }
}

/// The last terms of a sum, two of them or more but not all: those of `I_G + d^2 - d d^T` that lack a mass.
fn tails_of_sums(node: &Node, tails: &mut Vec<Span>) {
    if let Kind::Sum(terms) = &inner(node).kind
        && let [_, rest @ .., last] = terms.as_slice()
    {
        let first = rest.iter().filter(|term| !term.negative);
        tails.extend(first.map(|term| term.node.span.to(last.node.span)));
    }
    node.children()
        .for_each(|child| tails_of_sums(child, tails));
}

/// Sides, terms and operands of ×, outermost first.
fn vectors<'a>(node: &'a Node, places: &mut Vec<&'a Node>) {
    places.push(node);
    match &inner(node).kind {
        Kind::Sum(terms) => terms.iter().for_each(|term| vectors(&term.node, places)),
        Kind::Negate(inside) => vectors(inside, places),
        Kind::Product(factors) if factors.iter().any(|f| f.operator == Operator::Cross) => {
            factors
                .iter()
                .for_each(|factor| vectors(&factor.node, places));
        }
        _ => {}
    }
}
