//! A line that does not stand in the document, tried at a place of it.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Line, Node, Relation, Symbol};
use crate::notation::document::Row;
use crate::notation::reread;
use crate::source::{Source, Span};
use crate::verify::facts::proof::prove;
use crate::verify::standing::chains::{Chain, Link};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::written::without_number;
use crate::verify::term::letters::At;
use num_traits::Zero;
use std::borrow::Cow;
use std::collections::BTreeSet;

/// What a term by itself comes to.
#[derive(Clone, Debug)]
pub(crate) enum Tried {
    /// A number.
    Number(Fraction),
    /// A vector or a matrix.
    NoNumber,
    /// A letter in it is new.
    New,
    /// It is not worked out.
    Open,
}

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
        self.written.trial = Some(Source::new("", text));
        let follows = self.all_follow(new);
        self.written.trial = None;
        follows
    }

    /// Whether a line follows with another symbol in the place of one, or that symbol can't be put there alone.
    pub(crate) fn may_follow_with(&mut self, line: &Line, place: Span, symbol: &Symbol) -> bool {
        let mut changed = line.clone();
        let mut put = changed
            .sides
            .iter_mut()
            .map(|side| put(side, place, symbol));
        // All of them: a macro may write one letter in several places.
        match put.try_fold(false, |any, put| Some(any | put?)) {
            Some(true) => self.all_follow(&changed),
            _ => true,
        }
    }

    /// What is left of the difference of the two sides of a line that are worth this, if they are numbers.
    pub(crate) fn left_over(
        &mut self,
        line: &Line,
        sides: &[(Fraction, Fraction)],
    ) -> Option<Fraction> {
        let [(relation, _)] = line.relations.as_slice() else {
            return None;
        };
        let equal = matches!(relation, Relation::Equal | Relation::Defined);
        let numbered = matches!(without_number(line), Cow::Owned(_));
        if !equal || numbered || sides.len() != 1 || !self.small_here().is_empty() {
            return None;
        }
        self.residuals(sides).ok()?.pop()
    }

    /// A term by itself, in free variables; `None` where it is no number or a letter in it is new.
    pub(crate) fn term(&mut self, node: &Node) -> Option<Fraction> {
        match self.tried(node) {
            Tried::Number(value) => Some(value),
            Tried::NoNumber | Tried::New | Tried::Open => None,
        }
    }

    /// What a term by itself comes to, in free variables.
    pub(crate) fn tried(&mut self, node: &Node) -> Tried {
        let mut lowering = self.lowering();
        let Ok(value) = lowering.value(node) else {
            return Tried::Open;
        };
        match value.entries.as_slice() {
            _ if !lowering.unknown.is_empty() => Tried::New,
            [entry] if value.is_scalar() => {
                let atoms = &mut self.reading.system.atoms;
                let normal = self.facts.normal(atoms, entry);
                normal.map_or(Tried::Open, Tried::Number)
            }
            _ => Tried::NoNumber,
        }
    }

    /// A value with what is told put in; `None` where that is not worked out.
    pub(crate) fn normal(&mut self, value: &Fraction) -> Option<Fraction> {
        let atoms = &mut self.reading.system.atoms;
        self.facts.normal(atoms, value).ok()
    }

    /// Whether values are multiplied without anything that is told of squares.
    pub(crate) fn knows_no_square(&self) -> bool {
        let atoms = &self.reading.system.atoms;
        let mut all = 0..atoms.len() as Variable;
        self.facts.has_no_squares() && all.all(|variable| atoms.atom(variable).square.is_none())
    }

    /// Whether a letter is worth the same on every line, and no line has told anything.
    pub(crate) fn is_alike_everywhere(&self) -> bool {
        self.again.recalled.is_some()
    }

    fn all_follow(&mut self, line: &Line) -> bool {
        let line = without_number(line);
        let links = Chain::default().links(&line, &self.at);
        !links.is_empty() && links.iter().all(|link| self.follows(link))
    }

    /// Whether a link is entailed, all its letters are known, and it is not that both sides vanish.
    fn follows(&mut self, link: &Link<'_>) -> bool {
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
        // Nothing is left of the difference: a line that was entailed with these sides was by the proof that is looked for.
        if self.is_entailed_by_sides(&sides) {
            return true;
        }
        let small = self.small_here();
        let atoms = &mut self.reading.system.atoms;
        prove(&mut self.facts, atoms, &sides, &small).is_some()
    }

    /// Whether every left side is zero, and none is written so on the right.
    fn vanishes(&mut self, sides: &[(Fraction, Fraction)]) -> bool {
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

/// Puts a symbol into the place of one, and says whether there is one; `None` where it is the head of a call, which with
/// another letter may be a product.
fn put(node: &mut Node, place: Span, symbol: &Symbol) -> Option<bool> {
    match &mut node.kind {
        Kind::Symbol(own) if node.span == place => {
            own.clone_from(symbol);
            return Some(true);
        }
        Kind::Call(head, _) if head.span == place => return None,
        _ => {}
    }
    let mut children = node.children_mut().into_iter();
    children.try_fold(false, |any, child| Some(any | put(child, place, symbol)?))
}
