//! What is told of places and masses by letters that other sentences tell: premises, once all are known.

use crate::verify::language::statement::{Slot, Statement, slot};
use crate::verify::reading::bodies_read::{EACH, masses_said};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::is_letter;
use crate::verify::reading::points_read::name_of_particle;
use crate::verify::term::quantity::{Quantity, Whole};

impl Builder<'_> {
    /// "Q is a particle of mass `$2m$`."
    pub(super) fn hold_masses(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            for formula in masses_said(what).filter(|mass| !is_letter(mass)) {
                for subject in subjects {
                    if let Some(body) = self.body(subject) {
                        let mass = Quantity::Mass(Whole::Body(body));
                        self.hold_formula_is(formula, &mass, declaration);
                    }
                }
            }
        }
    }

    /// "P is the midpoint of A and B": the one place is the mean of the others.
    pub(super) fn hold_midpoints(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let of: Vec<_> = what
                .all(Slot::Of)
                .filter_map(|term| self.point(term))
                .collect();
            if let ("middle", &[one, other]) = (what.head, of.as_slice()) {
                for subject in subjects {
                    if let Some(point) = self.point(subject) {
                        let system = &self.reading.system;
                        let ways = system.position(point, one) + system.position(point, other);
                        self.hold_zero(&ways, declaration);
                    }
                }
            }
        }
    }

    /// What is told of places by letters that other sentences tell, for a part of the document, or once more.
    pub(super) fn hold_told_places(&mut self) {
        for (index, declaration) in self.declarations.iter().enumerate() {
            let Statement::Does {
                subjects,
                verb: "lie" | "place",
                slots,
            } = &declaration.statement
            else {
                continue;
            };
            let from = slot(slots, Slot::From).or(slot(slots, Slot::RelativeTo));
            let by_way = slot(slots, Slot::By).is_some() || from.is_some();
            for name in subjects
                .iter()
                .filter_map(name_of_particle)
                .filter(|_| by_way)
            {
                let Some(&point) = self.points.get(&name) else {
                    continue;
                };
                let indexed = name.contains('_') || name == EACH;
                let Some((from, way)) = self.told_way(index, indexed) else {
                    self.say_unused(declaration);
                    continue;
                };
                let other = self.system().position(point, from) - way;
                self.hold_zero(&other, declaration);
            }
        }
    }
}
