//! What documents say apart from laws that others said before.

use crate::algebra::Fraction;
use crate::verify::standing::apart::{Apart, Said};
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::WorkedOut;
use crate::verify::standing::memory::{Formula, Wording};
use std::collections::BTreeSet;

/// Sides of more terms are not kept.
const MOST_TERMS: usize = 300;

impl Apart<'_> {
    /// The sides of a link, as another document had them or worked out.
    pub(super) fn sides_of(&mut self, link: &Link) -> WorkedOut {
        let asked = self.judge.reading.letters.written.times_asked();
        let own = self.wording_of(link);
        let system = &mut self.judge.reading.system;
        let known = self.recalled.as_mut().zip(own.as_ref());
        if let Some(sides) = known.and_then(|(recalled, own)| recalled.known(system, own)) {
            return Ok(sides);
        }
        let sides = self.judge.sides(link, &BTreeSet::new())?;
        let size = |of: &Fraction| of.numerator().len() + of.denominator().len();
        let terms = sides.sides.iter();
        let terms = terms.map(|(left, right)| size(left) + size(right));
        // What hangs on other lines of the document is not the same in the next one.
        let alone = sides.settles.is_none()
            && self.judge.reading.letters.written.times_asked() == asked
            && terms.sum::<usize>() <= MOST_TERMS;
        if let (Some(recalled), Some(own)) = (&mut self.recalled, own.filter(|_| alone)) {
            let system = &self.judge.reading.system;
            recalled.keep(system, own, sides.clone());
        }
        Ok(sides)
    }

    /// A link as it is looked for; `None` for one that is not kept.
    fn wording_of(&mut self, link: &Link) -> Option<Wording> {
        let recalled = self.recalled.as_mut()?;
        let integrals = self.judge.reading.letters.customs.integrals;
        let of = Formula::of_link(link, link.relation as usize * 2 + usize::from(integrals))?;
        recalled.wording(&self.judge.reading.system, of)
    }

    /// How what a line says is looked for among lines of other documents, which took in the same; `None` for a line that
    /// says what a letter is.
    pub(crate) fn wording(&mut self, said: &Said) -> Option<Wording> {
        let sides = said.sides.as_ref().filter(|_| !said.defines)?;
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh)?;
        recalled.wording(&self.judge.reading.system, Formula::of_sides(sides))
    }

    /// The number of the variables that there are, where nothing of this document was taken in.
    pub(crate) fn state(&mut self) -> Option<usize> {
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh)?;
        recalled.state(&self.judge.reading.system)
    }

    /// A number that is another one after each change of the variables.
    pub(crate) fn changes(&self) -> u64 {
        self.judge.reading.system.atoms.changes()
    }
}
