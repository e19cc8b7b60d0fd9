//! Points about which the inertia of bodies is told: where all that is said of it is said about one point of the body, its
//! tensor is written about that one.

use crate::verify::language::heads::{INERTIA_TENSOR, MOMENT_OF_INERTIA};
use crate::verify::language::statement::{Slot, Statement};
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
        if !known.parts.is_empty() || known.members.is_some() || known.inertia.is_some() {
            return None;
        }
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { what, .. } if INERTIAS.contains(&what.head) => Some(what),
            _ => None,
        });
        let own = said.filter(|what| {
            let of = what.slot(Slot::Of).and_then(|term| self.body(term));
            of == Some(body)
        });
        let points: Option<Vec<PointId>> = own
            .map(|what| self.about(what, &Whole::Body(body)))
            .collect();
        let points = points?;
        let (first, others) = points.split_first()?;
        let one = others.iter().all(|other| other == first) && *first != known.centre;
        let fixed = self.reading.system.points[*first].fixed_in.contains(&frame);
        (one && fixed).then_some(*first)
    }
}
