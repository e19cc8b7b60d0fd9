//! The points and axes that momenta, moments and energies are about.

use crate::verify::language::heads::{
    ANGULAR_MOMENTUM, AXES, INERTIA_TENSOR, MOMENT, MOMENT_OF_INERTIA, NORMAL,
};
use crate::verify::language::statement::{NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, PointId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{MASS_CENTRE, UNIT_VECTOR, name_of};
use crate::verify::term::quantity::Whole;

impl Builder<'_> {
    /// The point that a quantity is about; the mass centre where none is said, as of an axis through none.
    pub(super) fn about(&self, phrase: &NounPhrase, of: &Whole) -> Option<PointId> {
        let centre = match of {
            Whole::Body(body) => self.centre_of(*body),
            Whole::Member(..) => 0,
        };
        let Some(term) = phrase.slot(Slot::About) else {
            // "no moment along the axis through O"
            let through = match phrase.slot(Slot::Along) {
                Some(Term::Phrase(axis)) if phrase.head == MOMENT => axis.slot(Slot::Through),
                _ => None,
            };
            return through.map_or(Some(centre), |through| self.point(through));
        };
        self.point(term).or_else(|| match term {
            Term::Phrase(point) if point.head == MASS_CENTRE => None,
            Term::Phrase(axis) if axis.slot(Slot::Through).is_some() => {
                self.point(axis.slot(Slot::Through)?)
            }
            // An end, a rim, a corner is no axis.
            Term::Phrase(axis) if !is_line(axis) => None,
            Term::Name(name) if self.axes.get(name).is_none() => None,
            // Through which point the axis passes is not said, where the mass centre and a pivot may be meant.
            _ if phrase.head == MOMENT_OF_INERTIA && self.has_other_pivot(of) => None,
            Term::Name(_) | Term::Formula(_)
                if phrase.head == MOMENT_OF_INERTIA && self.has_tensor_elsewhere(of) =>
            {
                None
            }
            _ => Some(self.point_on_axis(phrase, of, centre)),
        })
    }

    /// A point on an axis that passes through none that is told: for loads and momenta the one that is fixed in space.
    fn point_on_axis(&self, phrase: &NounPhrase, of: &Whole, centre: PointId) -> PointId {
        let Whole::Body(body) = of else {
            return centre;
        };
        match phrase.head {
            MOMENT | ANGULAR_MOMENTUM => self.fixed_point_of(*body).unwrap_or(centre),
            _ => centre,
        }
    }

    /// The point about which a moment along an axis is taken: the one that is said, one that is fixed in space, or the mass
    /// centre.
    pub(super) fn pivot_of(&self, moment: &NounPhrase, body: BodyId) -> Option<PointId> {
        match moment.slot(Slot::About) {
            Some(about) => self.point(about),
            None => Some(self.fixed_point_of(body).unwrap_or(self.centre_of(body))),
        }
    }

    /// A point of a body that is fixed in space.
    pub(super) fn fixed_point_of(&self, body: BodyId) -> Option<PointId> {
        let mut points = 0..self.reading.system.points.len();
        points.find(|&point| self.is_fixed_point(point, body))
    }

    fn has_other_pivot(&self, of: &Whole) -> bool {
        matches!(of, Whole::Body(body) if self.has_pivot(*body))
    }

    /// Whether the tensor of a body about another point than its mass centre is spoken of.
    fn has_tensor_elsewhere(&self, of: &Whole) -> bool {
        let Whole::Body(body) = of else { return false };
        let centre = self.centre_of(*body);
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == INERTIA_TENSOR => {
                let own = what.slot(Slot::Of).and_then(|of| self.body(of)) == Some(*body);
                let about = what.slot(Slot::About).and_then(|about| self.point(about));
                own && about.is_some_and(|about| about != centre)
            }
            _ => false,
        })
    }

    /// Whether a point is fixed in a body and in space.
    pub(super) fn is_fixed_point(&self, point: PointId, body: BodyId) -> bool {
        let system = &self.reading.system;
        let fixed = &system.points[point].fixed_in;
        let own = system.bodies[body].frame;
        fixed.contains(&system.ground) && own.is_some_and(|frame| fixed.contains(&frame))
    }

    /// The axis that a moment or an angular momentum is about: of a vector, the component along it.
    pub(super) fn axis_about<'t>(&self, phrase: &'t NounPhrase) -> Option<&'t Term> {
        let about = phrase.slot(Slot::About)?;
        let axis = match about {
            Term::Phrase(axis) => AXES.contains(&axis.head),
            _ => {
                let named = name_of(about).is_some_and(|name| self.axes.get(&name).is_some());
                named && self.point(about).is_none()
            }
        };
        (axis && matches!(phrase.head, MOMENT | ANGULAR_MOMENTUM)).then_some(about)
    }
}

/// Whether a noun is that of an axis or a direction.
fn is_line(phrase: &NounPhrase) -> bool {
    AXES.contains(&phrase.head) || matches!(phrase.head, "line" | UNIT_VECTOR | NORMAL)
}
