//! Loads of which a sentence says that none act.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::model::loads::{Lasting, Load};
use crate::verify::model::system::Vector;
use crate::verify::reading::builder::Builder;

/// The adverb of what is left out.
const EXCEPT: &str = "except";

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
        let others = self.exceptions(premise)?;
        let others = self.reading.system.moment_of_loads(&others, about);
        self.hold_none(&(moment - others), premise, declaration)
    }

    /// "except the weight": the loads that may act.
    fn exceptions(&mut self, premise: &NounPhrase) -> Option<Vec<Load>> {
        let mut loads = vec![];
        for term in premise.all(Slot::With) {
            let Term::Phrase(except) = term else {
                return None;
            };
            if except.head != EXCEPT {
                return None;
            }
            for load in except.all(Slot::Of) {
                let Term::Phrase(load) = load else {
                    return None;
                };
                loads.extend(self.told_loads(load, premise, Lasting::Always)?);
            }
        }
        Some(loads)
    }

    pub(super) fn no_force(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(premise)?;
        let force = self.system().total_force(body);
        let others = self.exceptions(premise)?;
        let others = others
            .iter()
            .fold(Vector::zeros(), |sum, load| sum + &load.value);
        self.hold_none(&(force - others), premise, declaration)
    }

    /// A load vanishes, or only its component along an axis that the sentence names.
    fn hold_none(
        &mut self,
        load: &Vector,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let along = premise
            .slot(Slot::Along)
            .or_else(|| self.axis_about(premise));
        match along.cloned() {
            Some(along) => {
                let along = self.direction(&along, declaration, None)?;
                self.hold(load.dot(&along), declaration);
            }
            None => self.hold_zero(load, declaration),
        }
        Some(())
    }
}
