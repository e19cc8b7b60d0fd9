//! A line that does not stand in the document, tried at a place of it.

use crate::notation::ast::{Line, Relation};
use crate::notation::document::Row;
use crate::notation::reread;
use crate::source::{Source, Span};
use crate::verify::facts::proof::prove;
use crate::verify::standing::chains::{Chain, Link};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::written::without_number;
use crate::verify::term::letters::At;
use num_traits::Zero;
use std::collections::BTreeSet;

impl Judge<'_> {
    /// Goes to a place of the document, with the premises that are in force there. Returns where it was.
    pub(crate) fn stand_at(&mut self, at: &At) -> At {
        let before = std::mem::replace(&mut self.at, at.clone());
        let own = self.source();
        self.take_premises_but(Some(&own));
        self.enter_space();
        before
    }

    /// Whether a text in the place of a line follows from the facts, and says something. A row that goes on is held against
    /// the head of its chain.
    pub(crate) fn follows_as(&mut self, text: &str, head: Span, line: &Line) -> bool {
        let text = match line.continues {
            true => format!("{} {text}", self.document.source.slice(head)),
            false => text.to_owned(),
        };
        let rows = reread(self.document, &text);
        let [Row::Line(new)] = rows.as_slice() else {
            return false;
        };
        if new.continues || new.relations.len() != line.relations.len() {
            return false;
        }
        let links = Chain::default().links(&without_number(new));
        self.written.trial = Some(Source::new("", text));
        let follows = !links.is_empty() && links.iter().all(|link| self.follows(link));
        self.written.trial = None;
        follows
    }

    /// Whether a link is entailed, all its letters are known, and it is not that both sides vanish.
    fn follows(&mut self, link: &Link) -> bool {
        if !matches!(link.relation, Relation::Equal | Relation::Defined) {
            return false;
        }
        let Ok(worked_out) = self.sides(link, &BTreeSet::new()) else {
            return false;
        };
        let sides = worked_out.sides;
        let holds = worked_out.unknown.is_empty()
            && self
                .residuals(&sides)
                .is_ok_and(|residuals| residuals.iter().all(Zero::is_zero));
        if !holds || self.vanishes(&sides) {
            return false;
        }
        let small = self.small_here();
        let atoms = &mut self.reading.system.atoms;
        prove(&mut self.facts, atoms, &sides, &small).is_some()
    }

    /// Whether every left side is zero, and none is written so on the right.
    fn vanishes(&mut self, sides: &[(crate::algebra::Fraction, crate::algebra::Fraction)]) -> bool {
        let written = sides
            .iter()
            .all(|(left, right)| left.is_zero() || right.is_zero());
        let atoms = &mut self.reading.system.atoms;
        !written
            && sides.iter().all(|(left, _)| {
                let normal = self.facts.normal(atoms, left);
                normal.is_ok_and(|normal| normal.is_zero())
            })
    }
}
