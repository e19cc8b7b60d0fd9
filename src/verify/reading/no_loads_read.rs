//! Loads of which a sentence says that none act.

use crate::verify::language::heads::{FORCE, MOMENT, WEIGHT};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::loads::{Lasting, Load};
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::loads_read::letters_of;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

/// The adverb of what is left out.
const EXCEPT: &str = "except";

/// Whether a noun leaves something out.
pub(super) fn leaves_out(phrase: &NounPhrase) -> bool {
    phrase.all(Slot::With).any(is_exception)
}

/// "except the weight"
pub(super) fn is_exception(term: &Term) -> bool {
    matches!(term, Term::Phrase(except) if except.head == EXCEPT)
}

impl Builder<'_> {
    pub(super) fn no_moment(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        // Beside a list of loads it says that no couple is among them, and not what their moment about a point is.
        let placed = [Slot::About, Slot::At, Slot::Along];
        let placed = placed.iter().any(|slot| premise.slot(*slot).is_some());
        let couple = declaration.text.contains("couple");
        if !placed && (couple || self.are_loads_listed()) {
            return None;
        }
        let of = self.whole_of(premise)?;
        let about = self.about(premise, &of)?;
        let body = self.body_of(premise)?;
        let moment = self.system().total_moment(body, about);
        let others = self.exceptions(premise, declaration)?;
        let others = self.reading.system.moment_of_loads(&others, about);
        self.hold_none(&(moment - others), premise, declaration)
    }

    /// Whether a sentence says which loads alone act.
    fn are_loads_listed(&self) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Premise(premise) => premise.is("only"),
            _ => false,
        })
    }

    /// "except the weight": the loads that may act.
    fn exceptions(&mut self, premise: &NounPhrase, declaration: &Declaration) -> Option<Vec<Load>> {
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
                // A part of a load, or one that only other words tell, is not worked with.
                let whole = load
                    .slots
                    .iter()
                    .all(|(slot, _)| matches!(slot, Slot::Of | Slot::Which | Slot::At));
                if let ([], Some(at)) = (letters_of(load).as_slice(), load.slot(Slot::At)) {
                    let at = self.point(at).filter(|_| load.head == FORCE)?;
                    loads.push(self.force_on_at(self.body_of(premise)?, at, declaration)?);
                    continue;
                }
                let told = load.head == WEIGHT || load.slot(Slot::Which).is_some();
                if !whole || !told {
                    return None;
                }
                loads.extend(self.told_loads(load, premise, Lasting::Always)?);
            }
        }
        Some(loads)
    }

    /// The one force that acts on a body at a point; where none is told it is one of its own.
    fn force_on_at(
        &mut self,
        body: BodyId,
        at: PointId,
        declaration: &Declaration,
    ) -> Option<Load> {
        match self.loads_on(body, at, Lasting::Always).as_slice() {
            [told] => Some(told.clone()),
            [_, ..] => None,
            [] => {
                let open = self.open_load(FORCE, at, None, declaration)?;
                self.system().loads.push(open.clone());
                Some(open)
            }
        }
    }

    /// "the total force on the aircraft other than the weight": what is left of the force, or of the moment about a point.
    pub(super) fn total_but_for(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let body = self.body_of(phrase)?;
        let others = self.exceptions(phrase, declaration)?;
        let rest = match phrase.head {
            MOMENT => {
                let of = self.whole_of(phrase)?;
                let about = self.about(phrase, &of)?;
                self.system()
                    .rest_of_moment(body, about, &others, Lasting::Always)
            }
            _ => self.system().rest_of_load(body, &others, Lasting::Always),
        };
        Some(Quantity::Known(Value::vector(&rest, Basis::Itself)))
    }

    pub(super) fn no_force(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body_of(premise)?;
        let force = self.system().total_force(body);
        let others = self.exceptions(premise, declaration)?;
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
