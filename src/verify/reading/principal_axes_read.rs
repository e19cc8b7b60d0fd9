//! Principal axes: which entries of an inertia tensor vanish.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::told;
use crate::verify::reading::premises_read::zero;
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// "The axes of B are principal axes of the body", "z is a principal axis of the body": of one axis alone the products
    /// with the others vanish, and of two all do.
    pub(super) fn principal_axes(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        // At an instant alone they are told of no other.
        if premise.slots.iter().any(|(_, term)| term.is_condition()) {
            return None;
        }
        let of = self.whole_of(premise)?;
        let about = match premise.slot(Slot::About).or(premise.slot(Slot::At)) {
            Some(_) => self.about(premise, &of)?,
            None => self
                .base_of(&of)
                .map_or_else(|| self.about(premise, &of), Some)?,
        };
        let (frame, alone) = self.axes_said(premise)?;
        let tensor = Quantity::Inertia { of, about };
        for (row, column) in [(0, 1), (0, 2), (1, 2)] {
            if alone.is_some_and(|axis| axis != row && axis != column) {
                continue;
            }
            let of = tensor.clone().boxed();
            let entry = Quantity::Entry {
                of,
                row,
                column,
                on: frame,
                integral: false,
            };
            self.hold_quantities(&entry, &zero(), declaration);
        }
        Some(())
    }

    /// The frame whose axes a sentence names, and the one of them that it names alone.
    fn axes_said(&self, premise: &NounPhrase) -> Option<(FrameId, Option<usize>)> {
        let customary = self.reading.letters.component_frame;
        let said: Vec<&Term> = premise.all(Slot::With).collect();
        match said.as_slice() {
            [] => Some((customary, None)),
            [Term::Phrase(axes)] if axes.head == "axes" => {
                let frame = told(axes.slot(Slot::Of), customary, |t| self.frame(t))?;
                Some((frame, None))
            }
            [axis] => {
                let (frame, axis) = self.axis_of_frame(axis)?;
                Some((frame, Some(axis)))
            }
            [first, others @ ..] => {
                let (frame, _) = self.axis_of_frame(first)?;
                let own =
                    |axis: &&Term| self.axis_of_frame(axis).is_some_and(|(of, _)| of == frame);
                others.iter().all(own).then_some((frame, None))
            }
        }
    }
}
