//! Points about which the inertia of bodies is told: where all that is said of it is said about one point of the body, its
//! tensor is written about that one.

use crate::verify::language::heads::{INERTIA_TENSOR, MOMENT_OF_INERTIA};
use crate::verify::language::is_bodily;
use crate::verify::language::statement::{NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, PointId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{PRINCIPAL_MOMENTS, PRODUCTS};
use crate::verify::term::quantity::Whole;

/// Nouns of the inertia of a body about a point.
const INERTIAS: [&str; 4] = [
    INERTIA_TENSOR,
    MOMENT_OF_INERTIA,
    PRINCIPAL_MOMENTS,
    PRODUCTS,
];

impl Builder<'_> {
    /// Finds the point of each body.
    pub(super) fn find_bases(&mut self) {
        for body in 0..self.reading.system.bodies.len() {
            self.reading.system.bodies[body].base = self.told_base(body);
        }
    }

    /// The point that a tensor is about where no other is said.
    pub(super) fn base_of(&self, of: &Whole) -> Option<PointId> {
        match of {
            Whole::Body(body) => self.reading.system.bodies[*body].base,
            Whole::Member(..) => None,
        }
    }

    fn told_base(&self, body: BodyId) -> Option<PointId> {
        let known = &self.reading.system.bodies[body];
        let frame = known.frame?;
        let whole = known.parts.is_empty() && known.members.is_none() && known.inertia.is_none();
        let points: Option<Vec<PointId>> = self
            .declarations
            .iter()
            .filter_map(|declaration| match &declaration.statement {
                Statement::Is { what, .. } => self.inertia_about(what, body),
                _ => None,
            })
            .collect();
        let points = points?;
        let (first, others) = points.split_first()?;
        let one = others.iter().all(|other| other == first) && *first != known.centre;
        let fixed = self.reading.system.points[*first].fixed_in.contains(&frame);
        (whole && one && fixed && !self.has_shape(body)).then_some(*first)
    }

    /// About which point a phrase speaks of the inertia of a body: `None` if it does not, `Some(None)` if the point is not
    /// told.
    fn inertia_about(&self, phrase: &NounPhrase, body: BodyId) -> Option<Option<PointId>> {
        if !INERTIAS.contains(&phrase.head) || !(is_bodily(phrase.head) || phrase.head == PRODUCTS)
        {
            return None;
        }
        let of = phrase.slot(Slot::Of).and_then(|term| self.body(term));
        if of != Some(body) {
            return None;
        }
        let about = phrase.slot(Slot::About);
        let point = about.and_then(|about| match about {
            Term::Phrase(axis) if axis.slot(Slot::Through).is_some() => {
                self.point(axis.slot(Slot::Through)?)
            }
            term => self.point(term),
        });
        Some(point)
    }

    /// Whether a sentence says that a body has a shape.
    fn has_shape(&self, body: BodyId) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                self.is_shape(what.head) && subjects.iter().any(|s| self.body(s) == Some(body))
            }
            _ => false,
        })
    }
}
