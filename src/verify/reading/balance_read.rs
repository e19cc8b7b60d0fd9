//! Rotors that are balanced about an axis: statically, the mass centre lies on it, so that the weight does not turn them;
//! dynamically, it is a principal axis as well, so that a steady turn about it needs no moment.

use crate::mechanics;
use crate::verify::language::heads::{DYNAMICALLY_BALANCED, STATICALLY_BALANCED, UNBALANCED};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::term::quantity::{Quantity, Whole};

/// Whether a noun is what is said of bodies that are balanced.
pub(super) fn is_balance(head: &str) -> bool {
    [DYNAMICALLY_BALANCED, STATICALLY_BALANCED].contains(&head)
}

impl Builder<'_> {
    /// "The rotor is balanced about the axis through O along z."
    pub(super) fn read_balance(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        for subject in subjects {
            let held = self.balance_body(subject, what, declaration);
            held.unwrap_or_else(|| self.say_unused(declaration));
        }
    }

    fn balance_body(
        &mut self,
        subject: &Term,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body(subject)?;
        let (on_axis, along) = self.axis_of_balance(body, what, declaration)?;
        let way = self.reading.system.position(self.centre_of(body), on_axis);
        self.hold_zero(&mechanics::cross(&way, &along), declaration);
        if what.head == STATICALLY_BALANCED {
            return Some(());
        }
        // A principal axis through the mass centre is one at each of its points: the tensor is taken where it is told.
        let of = Whole::Body(body);
        let told = self.base_of(&of).filter(|base| *base == on_axis);
        let about = told.unwrap_or(self.centre_of(body));
        let tensor = self.system().value_of(&Quantity::Inertia { of, about });
        let momentum = mechanics::apply(&tensor.ok()?.to_matrix().ok()?, &along);
        self.hold_zero(&mechanics::cross(&along, &momentum), declaration);
        Some(())
    }

    /// A point on the axis about which a body is balanced, and its direction: the axis that is said, through a point of the body
    /// that is at rest where none is said, or the one about which alone the body turns.
    fn axis_of_balance(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<(PointId, Vector)> {
        let frame = self.reading.system.bodies[body].frame?;
        let about = what.slot(Slot::About);
        let through = match about {
            Some(Term::Phrase(axis)) => axis.slot(Slot::Through),
            _ => None,
        };
        let on_axis = match through {
            Some(point) => self.point(point)?,
            None => self.fixed_point_of(body)?,
        };
        let along = match about {
            Some(axis) if self.is_open_direction(axis, declaration) => return None,
            Some(axis) => self.direction(axis, declaration, Some(frame))?,
            None => {
                let axis = self.axis_of_turn(body)?;
                self.system().axis(frame, axis)
            }
        };
        Some((on_axis, along))
    }

    /// Whether an axis is along a letter that no other sentence tells: it may be any direction.
    fn is_open_direction(&mut self, axis: &Term, declaration: &Declaration) -> bool {
        let along = match axis {
            Term::Phrase(axis) => axis.slot(Slot::Along),
            letter => Some(letter),
        };
        let Some(Term::Formula(letter)) = along else {
            return false;
        };
        let named = along.is_some_and(|along| self.axis_of_frame(along).is_some());
        !named && !self.is_told(letter, declaration)
    }

    /// Whether a sentence says that a body is out of balance: that it is uniform is not said of all its mass then.
    pub(super) fn is_unbalanced(&self, body: BodyId) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == UNBALANCED => {
                subjects.iter().any(|term| self.body(term) == Some(body))
            }
            _ => false,
        })
    }
}
