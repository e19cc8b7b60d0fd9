//! The sign of every product of inertia in a line, turned round.

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::correction::edit::Edit;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes};
use crate::verify::repair::trial::Search;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Diagnosis, Finding};

impl Checker<'_> {
    /// Every product of inertia with the other sign, if that makes the line true.
    pub(crate) fn convention_slip(
        &mut self,
        line: &Line,
        search: &mut Search<'_>,
    ) -> Option<Diagnosis> {
        let edits = sign_flips(&line.sides, &self.reading);
        let all: Vec<&Edit> = edits.iter().collect();
        let before = |f: &Finding| f.diagnosis.as_ref().is_some_and(|d| d.kind == "convention");
        // One flipped sign alone is a slip of sign, unless the document has shown the other convention before.
        if all.is_empty() || (all.len() == 1 && !self.findings.iter().any(before)) {
            return None;
        }
        let text = self.proved_with(&all, search)?;
        Some(Diagnosis {
            kind: "convention",
            message: format!(
                "the products of inertia have the sign of the other convention; this document uses {}",
                self.convention.name
            ),
            suggestion: Some(text),
            place: edits.first().map(|edit| edit.span),
        })
    }
}

/// The edits that give each product of inertia the other sign, each at the sign of the smallest term around it.
fn sign_flips(sides: &[Node], reading: &Reading) -> Vec<Edit> {
    let mut edits = vec![];
    for side in sides {
        // A side that is a lone product names it; the definition is on the other side.
        if !matches!(&side.kind, Kind::Symbol(_)) {
            flip(side, Sign::opening(side), reading, &mut edits);
        }
    }
    edits.dedup_by_key(|edit: &mut Edit| edit.span);
    edits
}

/// The sign that governs what stands inside.
#[derive(Clone, Copy)]
struct Sign {
    span: Span,
    negative: bool,
    /// Whether nothing stands before it that it would have to be joined to.
    opens: bool,
}

impl Sign {
    /// The plus that nobody writes before what stands first.
    fn opening(node: &Node) -> Self {
        Self {
            span: node.span.before(),
            negative: false,
            opens: true,
        }
    }
}

fn flip(node: &Node, sign: Sign, reading: &Reading, out: &mut Vec<Edit>) {
    match &node.kind {
        Kind::Symbol(symbol) if is_product(symbol, reading) => {
            let text = match (sign.negative, sign.opens) {
                (true, true) => "",
                (true, false) => "+",
                (false, _) => "-",
            };
            out.push(Edit {
                span: sign.span,
                text: text.into(),
                kind: "convention",
                message: String::new(),
                cost: 5,
            });
        }
        Kind::Sum(terms) => {
            for (i, term) in terms.iter().enumerate() {
                let written = term.sign.start < term.sign.end;
                let span = if written {
                    term.sign
                } else {
                    term.node.span.before()
                };
                flip(
                    &term.node,
                    Sign {
                        span,
                        negative: term.negative,
                        opens: i == 0,
                    },
                    reading,
                    out,
                );
            }
        }
        Kind::Negate(inner) => {
            let span = Span {
                start: node.span.start,
                end: inner.span.start,
            };
            flip(
                inner,
                Sign {
                    span,
                    negative: true,
                    opens: true,
                },
                reading,
                out,
            );
        }
        Kind::Matrix(_) | Kind::Determinant(_) | Kind::Tuple(_) => {
            for cell in node.children() {
                flip(cell, Sign::opening(cell), reading, out);
            }
        }
        _ => node
            .children()
            .for_each(|child| flip(child, sign, reading, out)),
    }
}

fn is_product(symbol: &Symbol, reading: &Reading) -> bool {
    let product = |index: &String| axes(index).is_some_and(|(r, c)| r != c);
    reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Inertia)
        && symbol.subscripts.iter().any(product)
}
