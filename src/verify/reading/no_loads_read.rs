//! Loads of which a sentence says that none act.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot};
use crate::verify::model::system::Vector;
use crate::verify::reading::builder::Builder;

impl Builder<'_> {
    pub(super) fn no_moment(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = self.whole_of(premise)?;
        let about = self.about(premise, &of)?;
        let body = self.body_of(premise)?;
        let moment = self.system().total_moment(body, about);
        self.hold_none(&moment, premise, declaration)
    }

    pub(super) fn no_force(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(premise)?;
        let force = self.system().total_force(body);
        self.hold_none(&force, premise, declaration)
    }

    /// A load vanishes, or only its component along an axis that the sentence names.
    fn hold_none(
        &mut self,
        load: &Vector,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        match premise.slot(Slot::Along) {
            Some(along) => {
                let along = self.direction(along, declaration, None)?;
                self.hold(load.dot(&along), declaration);
            }
            None => self.hold_zero(load, declaration),
        }
        Some(())
    }
}
