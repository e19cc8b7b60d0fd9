//! How a frame is turned at each time about a unit vector that itself may turn: Euler's axis and angle.

use crate::algebra::Fraction;
use crate::verify::language::statement::{
    Declaration, Extent, Formula, Slot, Statement, Term, slot,
};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{UNIT_VECTOR, letter_of, name_of};
use crate::verify::reading::parents_read::of_euler_angles;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::quaternions::Layout;
use crate::verify::term::value::Value;

/// "B is turned relative to A about `$n$` by the angle `$\\phi$`."
struct Attitude<'d> {
    frame: FrameId,
    relative: FrameId,
    axis: &'d Formula,
    angle: &'d Term,
}

impl Builder<'_> {
    /// Whether a sentence says how a frame is turned by an axis that no sentence fixes, where this frame is turned otherwise as
    /// well: of the whole document, or of another part of it, or by an axis whose rate the document writes.
    pub(super) fn tells_attitude(&self, declaration: &Declaration) -> bool {
        self.attitude_told(declaration).is_some()
    }

    fn attitude_told<'d>(&self, declaration: &'d Declaration) -> Option<Attitude<'d>> {
        let ([subject], slots) = declaration.statement.does("turn")? else {
            return None;
        };
        let (about, angle) = (slot(slots, Slot::About)?, slot(slots, Slot::By)?);
        let axis = letter_of(about)?;
        let frame = self.frame(subject)?;
        let relative = match slot(slots, Slot::RelativeTo) {
            Some(relative) => self.frame(relative)?,
            None => self.reading.system.ground,
        };
        let free = self.said_fixed(axis).is_none() && self.is_free_unit_vector(about, axis);
        let anew = declaration.extent != Extent::Document || self.writes_rate(about);
        let otherwise = || {
            let mut others = self.declarations.iter().filter(|d| *d != declaration);
            others.any(|d| self.turns_by_angles(d, frame))
        };
        (free && frame != relative && (anew || otherwise())).then_some(Attitude {
            frame,
            relative,
            axis,
            angle,
        })
    }

    /// Whether sentences say of a letter no more than that it is a unit vector.
    fn is_free_unit_vector(&self, about: &Term, axis: &Formula) -> bool {
        let own = |term: &Term| letter_of(term).is_some_and(|letter| letter.source == axis.source);
        let told = self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if subjects.iter().any(own) => {
                let bare = what.slots.iter().all(|(slot, _)| *slot == Slot::On);
                what.head != UNIT_VECTOR || !bare
            }
            Statement::Same { subjects, .. } => subjects.iter().any(own),
            _ => false,
        });
        let axis_of_frame = self.number_of_axis(about).is_some();
        !told && !axis_of_frame && self.directed_elsewhere(axis).is_none()
    }

    /// Whether a sentence about all of the document tells how a frame turns by angles.
    fn turns_by_angles(&self, declaration: &Declaration, frame: FrameId) -> bool {
        let named = |name: &str| self.frames.get(name) == Some(&frame);
        let euler = of_euler_angles(declaration).is_some_and(|(of, _)| named(&of));
        let turn = declaration
            .statement
            .does("turn")
            .is_some_and(|(of, slots)| {
                let own = of.iter().filter_map(name_of).any(|name| named(&name));
                own && slot(slots, Slot::By).is_some()
            });
        (euler || turn) && declaration.extent == Extent::Document
    }

    /// The quaternion of such a frame has to be known before any rotation is worked out.
    pub(super) fn turn_by_told_attitude(&mut self, declaration: &Declaration) {
        if let Some(attitude) = self.attitude_told(declaration) {
            let (frame, relative) = (attitude.frame, attitude.relative);
            self.system().frames[frame].by_quaternion = true;
            self.system().frames[relative].by_quaternion = true;
        }
    }

    /// Its quaternion is (cos φ/2, n sin φ/2).
    pub(super) fn hold_told_attitudes(&mut self) {
        for declaration in self.declarations {
            if let Some(attitude) = self.attitude_told(declaration)
                && self.hold_attitude(&attitude, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
    }

    fn hold_attitude(&mut self, attitude: &Attitude<'_>, said: &Declaration) -> Option<()> {
        let Attitude {
            frame,
            relative,
            axis,
            angle,
        } = *attitude;
        let angle = self.scalar_term(angle, said)?;
        let half = angle * Fraction::from_ratio(1, 2);
        let (cosine, sine) = self.system().atoms.cosine_sine(&half)?;
        let quaternion = self
            .system()
            .quaternion(relative, frame, Layout::ScalarFirst)?;
        let [scalar, parts @ ..] = quaternion.entries.as_slice() else {
            return None;
        };
        // The axis has the same components on both frames, and so have its rates entry by entry.
        let parts = parts.iter().map(|part| part.clone() / sine.clone());
        let column = Value::written(3, 1, parts.collect());
        self.denote(axis, Meaning::Quantity(Quantity::Known(column)), said);
        // The premise keeps lines from being denied by it, and its rate tells that of the angle.
        let (one, other) = (scalar.clone(), cosine.clone());
        let rate = self.system().atoms.derivative(&(one - other));
        self.hold(scalar.clone() - cosine, said);
        self.hold(rate, said);
        Some(())
    }

    /// Whether a letter is the axis of such a turn.
    pub(super) fn is_axis_of_attitude(&self, letter: &Formula) -> bool {
        let mut told = self
            .declarations
            .iter()
            .filter_map(|d| self.attitude_told(d));
        told.any(|attitude| attitude.axis.source == letter.source)
    }
}
