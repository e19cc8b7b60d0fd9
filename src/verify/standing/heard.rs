//! What documents say apart from laws that others said before.

use crate::algebra::Fraction;
use crate::verify::model::system::System;
use crate::verify::standing::apart::{Apart, Said};
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Sides, WorkedOut};
use crate::verify::standing::memory::{Formula, Memory, Recall, Wording};
use std::collections::BTreeSet;

/// Sides of more terms are not kept.
const MOST_TERMS: usize = 300;

/// What was heard of documents that go on from the same: the sides of links, and what follows from what.
#[derive(Clone, Debug, Default)]
pub(super) struct Heard {
    sides: Memory<Sides>,
    follows: Memory<Option<bool>>,
}

/// The same, as one document uses it.
pub(super) struct Recalled {
    sides: Recall<Sides>,
    follows: Recall<Option<bool>>,
}

impl Heard {
    /// For a document that begins with this.
    pub(super) fn used_by(self, system: &mut System) -> Recalled {
        Recalled {
            sides: Recall::new(self.sides, system),
            follows: Recall::new(self.follows, system),
        }
    }
}

impl Apart<'_> {
    /// The sides of a link, as another document had them or worked out.
    pub(super) fn sides_of(&mut self, link: &Link) -> WorkedOut {
        let asked = self.judge.reading.letters.written.times_asked();
        let own = self.wording_of(link);
        let system = &mut self.judge.reading.system;
        let known = self.recalled.as_mut().zip(own.as_ref());
        if let Some(sides) = known.and_then(|(recalled, own)| recalled.sides.known(system, own)) {
            return Ok(sides);
        }
        let sides = self.judge.sides(link, &BTreeSet::new())?;
        let size = |of: &Fraction| of.numerator().len() + of.denominator().len();
        let terms = sides.sides.iter();
        let terms: usize = terms.map(|(left, right)| size(left) + size(right)).sum();
        // What hangs on other lines of the document is not the same in the next one.
        let alone = sides.settles.is_none()
            && self.judge.reading.letters.written.times_asked() == asked
            && terms <= MOST_TERMS;
        if let (Some(recalled), Some(own)) = (&mut self.recalled, own.filter(|_| alone)) {
            let system = &self.judge.reading.system;
            recalled.sides.keep(system, own, sides.clone(), terms);
        }
        Ok(sides)
    }

    /// A link as it is looked for; `None` for one that is not kept.
    fn wording_of(&mut self, link: &Link) -> Option<Wording> {
        let recalled = self.recalled.as_mut()?;
        let integrals = self.judge.reading.letters.customs.integrals;
        let of = Formula::of_link(link, link.relation as usize * 2 + usize::from(integrals))?;
        recalled.sides.wording(&self.judge.reading.system, of)
    }

    /// Whether these vanish if those do, as it came out for another document or is worked out.
    pub(crate) fn follow(
        &mut self,
        goals: &[Fraction],
        from: &[Fraction],
        rates: bool,
    ) -> Option<bool> {
        let system = &mut self.judge.reading.system;
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh);
        let asked = recalled.and_then(|recalled| {
            let of = Formula::of_goals(goals, from, rates);
            let wording = recalled.follows.wording(system, of)?;
            Some((recalled.follows.known(system, &wording), wording))
        });
        let wording = match asked {
            Some((Some(known), _)) => return known,
            Some((None, wording)) => Some(wording),
            None => None,
        };
        let follows = self.works_out(goals, from, rates);
        if let (Some(recalled), Some(wording)) = (&mut self.recalled, wording) {
            let system = &self.judge.reading.system;
            recalled.follows.keep(system, wording, follows, 0);
        }
        follows
    }

    /// How what a line says is looked for among lines of other documents, which took in the same; `None` for a line that
    /// says what a letter is.
    pub(crate) fn wording(&mut self, said: &Said) -> Option<Wording> {
        let sides = said.sides.as_ref().filter(|_| !said.defines)?;
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh)?;
        let system = &self.judge.reading.system;
        recalled.sides.wording(system, Formula::of_sides(sides))
    }

    /// The number of the variables that there are, where nothing of this document was taken in.
    pub(crate) fn state(&mut self) -> Option<usize> {
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh)?;
        recalled.sides.state(&self.judge.reading.system)
    }

    /// A number that is another one after each change of the variables.
    pub(crate) fn changes(&self) -> u64 {
        self.judge.reading.system.atoms.changes()
    }
}
