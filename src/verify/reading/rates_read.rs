//! Rates of quantities, and from where they are seen.

use crate::verify::language::heads::SECOND_RATE;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::told;
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// "the rate of `$L$` seen from B", the second rate.
    pub(super) fn rate(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let ground = self.reading.system.ground;
        let of = self.operand(phrase.slot(Slot::Of)?, declaration)?;
        let told_from = phrase.slot(Slot::SeenFrom);
        let seen = told(told_from, ground, |t| self.frame(t))?;
        // Seen from a frame it is the vector that changes, and not its components on another one.
        let (of, on) = match of {
            Quantity::On(vector, on) if told_from.is_some() => (*vector, Some(on)),
            of => (of, None),
        };
        let rate = |of: Quantity| Quantity::Rate {
            of: of.boxed(),
            seen,
        };
        let rate = match phrase.head == SECOND_RATE {
            true => rate(rate(of)),
            false => rate(of),
        };
        Some(match on.filter(|_| phrase.slot(Slot::On).is_none()) {
            Some(on) => Quantity::On(rate.boxed(), on),
            None => rate,
        })
    }
}
