//! Moments of inertia: about an axis that is told, about the one that a body has of its own, across it.

use crate::algebra::Fraction;
use crate::verify::language::heads::AXES;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::contact::Round;
use crate::verify::model::system::{BodyId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::term::quantity::{Quantity, Whole};
use crate::verify::term::value::{Basis, Value};

impl Builder<'_> {
    /// "the moment of inertia of the wheel about its axis", "the transverse moment of inertia of the rotor".
    pub(super) fn moment_of_inertia(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let of = self.whole_of(phrase)?;
        if let Some(rotors) = self.rotors_of(&of) {
            let along = any_axis_across(phrase).is_none() && !phrase.is("transverse");
            return along.then(|| Quantity::Known(Value::scalar(rotors.inertia)));
        }
        let about = self.about(phrase, &of)?;
        let tensor = Quantity::Inertia {
            of: of.clone(),
            about,
        };
        let own = match of {
            Whole::Body(body) => Some(body),
            Whole::Member(..) => None,
        };
        if phrase.is("transverse") {
            let axis = self.axis_of_body(own?)?;
            return self.transverse_moment(own?, &axis, tensor, declaration);
        }
        if let Some(across) = any_axis_across(phrase) {
            let axis = self.axis_to_stand_on(across, own?, declaration)?;
            // About one axis across another the moment may be what it is about no other one.
            let known = is_about_any(phrase) || self.is_symmetric_about(own?, &axis, declaration);
            return known
                .then(|| self.transverse_moment(own?, &axis, tensor, declaration))
                .flatten();
        }
        let axis = match (self.told_axis(phrase, declaration), own) {
            (Some(axis), _) if !phrase.is("axial") => axis,
            (None, Some(body)) => self.axis_by_itself(phrase, body, declaration)?,
            _ => return None,
        };
        Some(Quantity::Along {
            of: tensor.boxed(),
            axis: axis.boxed(),
        })
    }

    /// The axis that a sentence names, by its letter or by what it is along.
    fn told_axis(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<Quantity> {
        let about = phrase.slot(Slot::About).or(phrase.slot(Slot::Along))?;
        let along = match about {
            Term::Phrase(line) => line.slot(Slot::Along).unwrap_or(about),
            _ => about,
        };
        // "along the axis of the cylinder"
        if let Term::Phrase(axis) = along
            && AXES.contains(&axis.head)
            && let Some(body) = axis.slot(Slot::Of).and_then(|of| self.body(of))
            && axis.slots.len() == 1
        {
            let told = self.axis_of_symmetry_told(body, declaration);
            let axis = self.axis_of_body(body).or(told)?;
            return Some(Quantity::Known(Value::vector(&axis, Basis::Itself)));
        }
        self.axis_quantity(&along.clone(), declaration)
    }

    /// The axis that is meant where none is told: that of the body itself, one across its line, or the one about which it turns.
    fn axis_by_itself(
        &mut self,
        phrase: &NounPhrase,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let axis = match phrase.slot(Slot::About) {
            Some(Term::Phrase(axis)) if AXES.contains(&axis.head) => {
                let own = axis.all(Slot::Of).all(|of| self.body(of) == Some(body));
                if !own || !axis.adjectives.is_empty() {
                    return None;
                }
                let across = axis.slot(Slot::With).map(|of| self.body(of));
                match across {
                    Some(of) => self.axis_across(of?)?,
                    None if axis.slot(Slot::Through).is_none() => {
                        let told = self.axis_of_symmetry_told(body, declaration);
                        self.axis_of_body(body).or(told)?
                    }
                    None => return None,
                }
            }
            _ if phrase.is("axial") => self.axis_of_body(body)?,
            None if self.has_pivot(body) => return None,
            _ if self.turns_in_plane(body) => {
                let frame = self.reading.system.bodies[body].frame?;
                let axis = self.axis_of_turn(body)?;
                self.system().axis(frame, axis)
            }
            _ if self.is_rod(body) => self.axis_across(body)?,
            _ => return None,
        };
        Some(Quantity::Known(Value::vector(&axis, Basis::Itself)))
    }

    /// Whether a point of a body that is not its mass centre is fixed in space.
    pub(super) fn has_pivot(&self, body: BodyId) -> bool {
        let centre = self.centre_of(body);
        let mut points = 0..self.reading.system.points.len();
        points.any(|point| point != centre && self.is_fixed_point(point, body))
    }

    /// The axis about which a body is round or symmetric, or else turns.
    pub(super) fn axis_of_body(&mut self, body: BodyId) -> Option<Vector> {
        let known = &self.reading.system.bodies[body];
        let round = match &known.round {
            Some(Round::Rim { axis, .. }) => Some(*axis),
            _ => None,
        };
        let frame = known.frame?;
        let line = self.axis_of_line(body).filter(|_| self.is_cone(body));
        let round = round.or(line.map(|(axis, _)| axis));
        let told = self.told_axis_of_shape(body).or(round);
        let axis = told.or_else(|| self.axis_of_turn(body).filter(|_| !self.is_rod(body)))?;
        Some(self.system().axis(frame, axis))
    }

    /// An axis that stands on a rod, or on the plane of what is flat and round.
    fn axis_across(&mut self, body: BodyId) -> Option<Vector> {
        if !self.is_rod(body) {
            return match self.reading.system.bodies[body].round {
                Some(Round::Rim { axis, .. }) if self.is_flat(body) => {
                    let frame = self.reading.system.bodies[body].frame?;
                    Some(self.system().axis(frame, axis))
                }
                _ => None,
            };
        }
        let frame = self.reading.system.bodies[body].frame?;
        let (line, _) = self.axis_of_line(body)?;
        Some(self.system().axis(frame, (line + 1) % 3))
    }

    /// The axis across which another one is: a direction by its letter, or that of the body itself.
    fn axis_to_stand_on(
        &mut self,
        across: &Term,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let own = match across {
            Term::Phrase(axis) if AXES.contains(&axis.head) => axis
                .slots
                .iter()
                .all(|(slot, of)| *slot == Slot::Of && self.body(of) == Some(body)),
            term => self.body(term) == Some(body),
        };
        if own {
            let told = self.axis_told_with(body, declaration);
            let told = told.or_else(|| self.axis_of_symmetry_told(body, declaration));
            return self.axis_of_body(body).or(told);
        }
        self.axis_vector(across, declaration)
    }

    /// The axis about which a sentence says that a body is symmetric.
    fn axis_of_symmetry_told(&mut self, body: BodyId, declaration: &Declaration) -> Option<Vector> {
        let declarations = self.declarations;
        let axis = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "symmetric" => {
                let own = subjects.iter().any(|s| self.body(s) == Some(body));
                what.slot(Slot::About).filter(|_| own)
            }
            _ => None,
        })?;
        self.axis_vector(axis, declaration)
    }

    /// Whether a sentence or the shape of a body says that it is symmetric about an axis.
    fn is_symmetric_about(
        &mut self,
        body: BodyId,
        axis: &Vector,
        declaration: &Declaration,
    ) -> bool {
        let told = self.axis_of_symmetry_told(body, declaration);
        let own = self.axis_of_body(body);
        let told =
            told.or_else(|| own.filter(|_| self.reading.system.bodies[body].round.is_some()));
        told.is_some_and(|told| told == *axis || told == -axis.clone())
    }

    /// The axis of another moment of the same sentence: "`$C$` is the moment about the axis along `$n$`, and `$A$` the one about
    /// any axis across it".
    fn axis_told_with(&mut self, body: BodyId, declaration: &Declaration) -> Option<Vector> {
        let declarations = self.declarations;
        let axis = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { what, .. }
                if d.line == declaration.line && d.text == declaration.text =>
            {
                let of = what.slot(Slot::Of).and_then(|of| self.body(of)) == Some(body);
                match what.slot(Slot::About).filter(|_| of)? {
                    Term::Phrase(axis) => axis.slot(Slot::Along),
                    _ => None,
                }
            }
            _ => None,
        })?;
        self.axis_vector(axis, declaration)
    }

    /// The moment about all axes across that of a symmetric body: half of what the trace leaves.
    fn transverse_moment(
        &mut self,
        body: BodyId,
        axis: &Vector,
        tensor: Quantity,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        self.hold_symmetry(body, axis, declaration)?;
        let tensor = self.system().value_of(&tensor).ok()?.to_matrix().ok()?;
        let along = axis.dot(&crate::mechanics::apply(&tensor, axis));
        let across = (tensor.trace() - along) * Fraction::from_ratio(1, 2);
        Some(Quantity::Known(Value::scalar(across)))
    }
}

/// What the axes stand on about which a moment is told: "any axis through G normal to n", "an axis through G normal to n".
fn any_axis_across(phrase: &NounPhrase) -> Option<&Term> {
    let Some(Term::Phrase(axis)) = phrase.slot(Slot::About) else {
        return None;
    };
    let one = axis.all(Slot::With).count() == 1;
    let alone = axis.slot(Slot::Along).is_none() && axis.slot(Slot::Of).is_none();
    // What stands on a body is not across its axis: "perpendicular to the disc".
    let of_body =
        matches!(axis.slot(Slot::With), Some(Term::Name(name)) if name.chars().count() > 2);
    let across = axis.head == "axis" && (axis.is("any") || one && alone && !of_body);
    axis.slot(Slot::With).filter(|_| across)
}

/// Whether a moment is told about any axis, so that it is the same about all of them.
fn is_about_any(phrase: &NounPhrase) -> bool {
    matches!(phrase.slot(Slot::About), Some(Term::Phrase(axis)) if axis.is("any"))
}
