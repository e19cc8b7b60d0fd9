//! Bodies that are symmetric: about an axis, or about a plane.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::whole;
use crate::verify::model::system::{BodyId, Matrix, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::vectors_read::entry_of;
use crate::verify::term::quantity::{Quantity, Whole};
use crate::verify::term::value::Value;
use num_traits::Zero;

impl Builder<'_> {
    pub(super) fn read_symmetry(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        for subject in subjects {
            let about = what.slot(Slot::About);
            if about.is_some_and(|axis| self.is_axis_of_rotor(subject, axis, declaration)) {
                continue;
            }
            let held =
                about.and_then(|about| self.read_symmetric_body(subject, about, declaration));
            held.unwrap_or_else(|| self.say_unused(declaration));
        }
    }

    fn read_symmetric_body(
        &mut self,
        subject: &Term,
        about: &Term,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body(subject)?;
        if let Term::Phrase(plane) = about
            && plane.head == "plane"
        {
            return self.hold_plane_of_symmetry(plane, body, declaration);
        }
        let frame = self.reading.system.bodies[body].frame?;
        let axis = match self.axis_of_frame(about) {
            Some((frame, axis)) => self.system().axis(frame, axis),
            None => self.direction(about, declaration, Some(frame))?,
        };
        self.hold_symmetry(body, &axis, declaration)
    }

    /// A part that is symmetric about a vector and turns about it has I_t 1 + (I_s − I_t) n nᵀ on any axes: its spin does not
    /// change that.
    pub(super) fn tell_tensors_of_wheels(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let ("symmetric", [subject], Some(about @ Term::Formula(letter))) =
                (what.head, subjects.as_slice(), what.slot(Slot::About))
            else {
                continue;
            };
            let part = self.body(subject).filter(|&body| self.is_plain_part(body));
            let named = self.axis_of_frame(about).is_some();
            if let Some(body) = part.filter(|_| !named) {
                self.reading.system.bodies[body].inertia = self.tensor_of_wheel(body, letter);
            }
        }
    }

    /// Whether a body is a part of another, and nothing is told yet of its inertia.
    fn is_plain_part(&self, body: BodyId) -> bool {
        let bodies = &self.reading.system.bodies;
        let known = &bodies[body];
        let plain = known.parts.is_empty() && known.members.is_none() && known.frame.is_some();
        let untold = known.inertia.is_none() && known.base.is_none();
        plain && untold && bodies.iter().any(|whole| whole.parts.contains(&body))
    }

    fn tensor_of_wheel(&mut self, body: BodyId, axis: &Formula) -> Option<Matrix> {
        let axis = Quantity::UnitVector {
            text: axis.source.clone(),
            carried: Some(self.said_fixed(axis)?),
        };
        let axis = self.system().value_of(&axis).ok()?.to_vector().ok()?;
        let name = self.reading.system.bodies[body].name.clone();
        let mut moment = |which: &str| {
            let text = format!("I_{{\\text{{{which},{name}}}}}");
            let constant = true;
            let moment = self.system().value_of(&Quantity::Scalar { text, constant });
            let moment = moment.ok()?.to_scalar().ok()?;
            self.system().atoms.set_positive(&moment);
            Some(moment)
        };
        let (across, along) = (moment("transverse")?, moment("axial")?);
        Some(mechanics::symmetric_inertia(&across, &along, &axis))
    }

    /// "The plane of x and z is a plane of symmetry of the aircraft."
    pub(super) fn read_plane_of_symmetry(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Phrase(plane)] = subjects else {
            return None;
        };
        let body = self.body(what.slot(Slot::Of)?)?;
        self.hold_plane_of_symmetry(plane, body, declaration)
    }

    /// No product of inertia has the axis across a plane of symmetry.
    fn hold_plane_of_symmetry(
        &mut self,
        plane: &NounPhrase,
        body: BodyId,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = Whole::Body(body);
        let axes: Option<Vec<_>> = plane.all(Slot::Of).map(|t| self.axis_of_frame(t)).collect();
        let &[(frame, one), (other, two)] = axes?.as_slice() else {
            return None;
        };
        let across = (0..3).find(|axis| ![one, two].contains(axis))?;
        if frame != other || one == two {
            return None;
        }
        let about = self.base_of(&of).unwrap_or_else(|| self.centre_of(body));
        let tensor = Quantity::Inertia { of, about };
        for axis in [one, two] {
            let product = entry_of(&tensor, axis, across, frame);
            let zero = Quantity::Known(Value::scalar(Zero::zero()));
            self.hold_quantities(&product, &zero, declaration);
        }
        Some(())
    }

    /// A body that is symmetric about an axis has I = I_t 1 + (I_s − I_t) n nᵀ.
    pub(super) fn hold_symmetry(
        &mut self,
        body: usize,
        n: &Vector,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = Whole::Body(body);
        // The axis passes through the point about which all is told.
        let about = self.base_of(&of).unwrap_or_else(|| self.centre_of(body));
        let tensor = Quantity::Inertia { of, about };
        let tensor = self.system().value_of(&tensor).ok()?.to_matrix().ok()?;
        // I n is along n, and I is the same for all directions across.
        let along = mechanics::apply(&tensor, n);
        self.hold_zero(&mechanics::cross(n, &along), declaration);
        let spin = n.dot(&along);
        let across = (tensor.trace() - spin.clone()) * Fraction::from_ratio(1, 2);
        for row in 0..3 {
            for column in 0..=row {
                let one = whole(i64::from(row == column));
                let dyad = n[row].clone() * n[column].clone();
                let told = across.clone() * one + (spin.clone() - across.clone()) * dyad;
                self.hold(tensor[(row, column)].clone() - told, declaration);
            }
        }
        Some(())
    }
}
