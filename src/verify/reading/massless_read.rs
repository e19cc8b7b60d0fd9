//! Bodies without mass: they have no momentum and no moments of inertia, however they move.

use crate::verify::language::statement::{Extent, Statement};
use crate::verify::model::system::Matrix;
use crate::verify::reading::builder::Builder;
use num_traits::Zero;

impl Builder<'_> {
    /// "The shaft has no mass", "a massless rod": of a single body, in the whole document.
    pub(super) fn read_massless(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let massless = what.head == "massless" || what.is("massless");
            if !massless || what.is("not") || declaration.extent != Extent::Document {
                continue;
            }
            let bodies: Vec<_> = subjects.iter().filter_map(|term| self.body(term)).collect();
            for body in bodies {
                let known = &mut self.reading.system.bodies[body];
                if known.parts.is_empty() && known.rotors.is_none() && known.members.is_none() {
                    known.mass = Zero::zero();
                    known.inertia = Some(Matrix::zeros());
                }
            }
        }
    }
}
