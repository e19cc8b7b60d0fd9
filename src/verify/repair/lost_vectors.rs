//! A vector that a false line has lost: a rate, a cross product, whatever the document writes elsewhere.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line, Node};
use crate::notation::document::Format;
use crate::scalar::Prime;
use crate::verify::check::Checker;
use crate::verify::correction::edit::Edit;
use crate::verify::letters::frame::Frame;
use crate::verify::repair::Search;
use crate::verify::repair::vocabulary::expression;
use crate::verify::repair::wanted::values;
use crate::verify::theory::world::World;
use crate::verify::values::quantity::Quantity;
use num_traits::Zero;

/// Vectors that are tried at most.
const VECTORS: usize = 60;

impl Checker<'_> {
    /// Edits that add a vector of the document to a side of a line between vectors.
    pub(crate) fn lost_vectors(&mut self, line: &Line, search: &mut Search<'_>) -> Vec<Edit> {
        let residual = match self.residual_with(line, &[], search) {
            Some(residual) if residual.len() == 3 => residual,
            _ => return vec![],
        };
        let vectors = self.vectors();
        let mut world: World<Prime> = World::new(&mut self.theory, 1);
        let gap = values(&mut world, &residual);
        let known: Vec<Option<Vec<Prime>>> = vectors
            .iter()
            .map(|(_, entries)| values(&mut world, entries))
            .collect();
        let exhausted = std::mem::take(&mut self.theory.exhausted);
        let (Some(gap), false) = (gap, exhausted) else {
            return vec![];
        };
        let turned: Vec<Prime> = gap.iter().map(|g| -*g).collect();
        let fits = |((text, _), value): (&(String, Vec<Fraction>), &Option<Vec<Prime>>)| {
            let value = value.as_ref()?;
            let last = line.sides.last()?;
            let (side, sign) = match (value == &gap, value == &turned) {
                (true, _) => (last, '+'),
                // What the right side has too much of the left may lack, unless it is a name.
                (_, true)
                    if line.sides.len() == 2 && !matches!(line.sides[0].kind, Kind::Symbol(_)) =>
                {
                    (&line.sides[0], '+')
                }
                (_, true) => (last, '-'),
                _ => return None,
            };
            Some(added(side, sign, text))
        };
        vectors.iter().zip(&known).filter_map(fits).collect()
    }

    /// The vectors that the document writes, and the rate of the angular momentum on the axes used.
    fn vectors(&mut self) -> Vec<(String, Vec<Fraction>)> {
        let document = self.document;
        let mut texts: Vec<(String, Node)> = vec![];
        let mut keep = |node: &Node| {
            let text = document.source.slice(node.span).trim();
            if texts.len() < VECTORS && !text.contains('&') && texts.iter().all(|(t, _)| t != text)
            {
                texts.push((text.to_owned(), node.clone()));
            }
        };
        document
            .lines()
            .flat_map(|l| &l.sides)
            .for_each(|side| visit(side, &mut keep));
        let own = self.moving_rate().and_then(|text| {
            let node = expression(self.document, &text)?;
            Some((text, node))
        });
        texts.extend(own);
        let valued = |(text, node): (String, Node)| {
            let value = self.lowering(Frame::Moving).value(&node).ok()?;
            let nonzero = value.entries.iter().any(|e| !e.is_zero());
            (value.entries.len() == 3 && nonzero).then_some((text, value.entries))
        };
        texts.into_iter().filter_map(valued).collect()
    }

    /// `(\dot{\vec{L}})_{xyz}` in the letters of the document.
    fn moving_rate(&self) -> Option<String> {
        let momentum = self.spelled_vector(Quantity::Momentum)?;
        let [_, moving] = self.frame_labels();
        let label = moving.trim_matches(['{', '}']).to_owned();
        Some(match self.document.format {
            Format::Text => format!("(d{momentum}/dt)_{label}"),
            _ => format!("(\\dot{{{momentum}}})_{{{label}}}"),
        })
    }
}

fn visit(node: &Node, keep: &mut impl FnMut(&Node)) {
    match node.kind {
        Kind::TimeDerivative { .. } => return keep(node),
        Kind::Product(_) | Kind::InFrame(..) | Kind::Symbol(_) => keep(node),
        _ => {}
    }
    node.children().for_each(|child| visit(child, keep));
}

/// The edit that adds a term behind a side.
pub(crate) fn added(side: &Node, sign: char, text: &str) -> Edit {
    Edit {
        span: side.span.behind(),
        text: format!(" {sign} {text}"),
        kind: "missing-term",
        message: format!("the term {text} is missing"),
        cost: 13,
    }
}
