//! Vectors that lie along others: "`$H$` points along Z", "`$\\omega$` is parallel to z".

use crate::verify::language::statement::{Declaration, Slot, Statement, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::lying_read::axis_of;

impl Builder<'_> {
    /// A vector is its component along an axis; where it points there, this component is its magnitude.
    pub(super) fn read_parallel(
        &mut self,
        subjects: &[Term],
        axis: &Term,
        points: bool,
        declaration: &Declaration,
    ) -> Option<()> {
        let axis = self.axis_vector(axis, declaration)?;
        for subject in subjects {
            let vector = self.vector(subject, declaration)?;
            let letter = self.magnitudes_of(subject).pop().filter(|_| points);
            let along = match letter {
                Some(letter) => self.scalar_term(&letter, declaration)?,
                None => vector.dot(&axis),
            };
            self.hold_zero(&(vector - axis.clone() * along), declaration);
        }
        Some(())
    }

    /// "`$\omega$` is parallel to z."
    pub(super) fn read_parallel_to(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        let read = match slots {
            [(Slot::With | Slot::Along, axis)] => {
                self.read_parallel(subjects, axis, false, declaration)
            }
            _ => None,
        };
        read.unwrap_or_else(|| self.say_unused(declaration));
    }

    /// Where things lie and vectors point.
    pub(super) fn read_direction(
        &mut self,
        subjects: &[Term],
        verb: &str,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        match verb {
            "point" if formulas(subjects).count() == subjects.len() => {
                self.read_pointing(subjects, slots, declaration);
            }
            "lie" => {
                if let Some(axis) = axis_of(slots) {
                    self.read_lying(subjects, axis, declaration);
                }
                if let [(Slot::At, at)] = slots {
                    let read = self.read_lying_at(subjects, at, declaration);
                    read.unwrap_or_else(|| self.say_unused(declaration));
                }
            }
            _ => {}
        }
    }

    /// Where vectors point; where forces do is read with the loads.
    fn read_pointing(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        if subjects.iter().all(|subject| self.is_force(subject)) {
            // A number is told by the direction; a vector lies along it.
            let vectors = subjects
                .iter()
                .all(|subject| self.vector(subject, declaration).is_some());
            if let ([(Slot::Along, axis)], true) = (slots, vectors) {
                self.read_parallel(subjects, axis, true, declaration);
            }
            return;
        }
        let read = match slots {
            [(Slot::Along, axis)] => self.read_parallel(subjects, axis, true, declaration),
            _ => None,
        };
        read.unwrap_or_else(|| self.say_unused(declaration));
    }

    /// The letters that sentences say to be the magnitude of a vector.
    fn magnitudes_of(&self, vector: &Term) -> Vec<Term> {
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "magnitude" => {
                let own = what.slot(Slot::Of) == Some(vector);
                own.then_some(subjects)
            }
            _ => None,
        });
        said.flatten().cloned().collect()
    }
}
