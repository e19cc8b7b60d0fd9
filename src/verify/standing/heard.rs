//! What documents say apart from laws that others said before.

use crate::algebra::Fraction;
use crate::recent::Digest;
use crate::verify::model::system::System;
use crate::verify::standing::apart::{Apart, Said};
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Sides, Untold};
use crate::verify::standing::memory::{Formula, Memory, Recall, Wording};
use std::collections::BTreeSet;
use std::sync::Arc;

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

/// The sides of a link.
pub(super) struct Worded {
    pub(super) sides: Arc<Sides>,
    /// How they are looked for, if they are kept by what they are worth.
    pub(super) of: Option<Wording>,
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
    /// The sides of a link, which may be known by a tree, as another document had them or worked out.
    pub(super) fn sides_of(
        &mut self,
        link: &Link<'_>,
        tree: Option<Digest>,
    ) -> Result<Worded, Untold> {
        let asked = self.judge.reading.letters.written.times_asked();
        let own = self.wording_of(link, tree);
        let system = &mut self.judge.reading.system;
        let known = self.recalled.as_mut().zip(own);
        let known = known.and_then(|(recalled, own)| recalled.sides.known_of(system, own));
        if let Some((sides, of)) = known {
            let of = Some(of).filter(|_| sides.unknown.is_empty());
            return Ok(Worded { sides, of });
        }
        let sides = Arc::new(self.judge.sides(link, &BTreeSet::new())?);
        // What hangs on other lines of the document is not the same in the next one.
        let alone = sides.settles.is_none()
            && self.judge.reading.letters.written.times_asked() == asked
            && terms(&sides) <= MOST_TERMS;
        match own.filter(|_| alone) {
            Some(own) => Ok(self.keep_sides(own, sides)),
            None => Ok(Worded { sides, of: None }),
        }
    }

    /// Keeps the sides of a link; where another writing came to the same, they are kept once.
    fn keep_sides(&mut self, own: Wording, sides: Arc<Sides>) -> Worded {
        let system = &mut self.judge.reading.system;
        let Some(recalled) = &mut self.recalled else {
            return Worded { sides, of: None };
        };
        let of = recalled
            .sides
            .wording(system, &Formula::of_sides(&sides.sides));
        let Some(of) = of.filter(|_| sides.unknown.is_empty()) else {
            let terms = terms(&sides);
            recalled.sides.keep(system, own, sides.clone(), terms);
            return Worded { sides, of: None };
        };
        let known = recalled.sides.known(system, of);
        let sides = known.unwrap_or_else(|| {
            let terms = terms(&sides);
            recalled.sides.keep(system, of, sides.clone(), terms);
            sides
        });
        recalled.sides.keep_as(system, own, of);
        Worded {
            sides,
            of: Some(of),
        }
    }

    /// A link as it is looked for; `None` for one that is not kept.
    fn wording_of(&mut self, link: &Link<'_>, tree: Option<Digest>) -> Option<Wording> {
        let recalled = self.recalled.as_mut()?;
        let integrals = self.judge.reading.letters.customs.integrals;
        let beside = link.relation as usize * 2 + usize::from(integrals);
        let of = Formula::of_link(link, tree, beside)?;
        recalled.sides.wording(&self.judge.reading.system, &of)
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
            let wording = recalled.follows.wording(system, &of)?;
            Some((recalled.follows.known(system, wording), wording))
        });
        let wording = match asked {
            Some((Some(known), _)) => return *known,
            Some((None, wording)) => Some(wording),
            None => None,
        };
        let follows = self.works_out(goals, from, rates);
        if let (Some(recalled), Some(wording)) = (&mut self.recalled, wording) {
            let system = &self.judge.reading.system;
            recalled.follows.keep(system, wording, Arc::new(follows), 0);
        }
        follows
    }

    /// How what a line says is looked for among lines of other documents, which took in the same; `None` for a line that
    /// says what a letter is.
    pub(crate) fn wording(&mut self, said: &Said) -> Option<Wording> {
        let sides = said.sides.as_ref().filter(|_| !said.defines)?;
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh)?;
        let system = &self.judge.reading.system;
        match said.of {
            Some(of) => recalled.sides.anew(system, of),
            None => recalled.sides.wording(system, &Formula::of_sides(sides)),
        }
    }

    /// The number of the variables that there are, where nothing of this document was taken in.
    pub(crate) fn state(&mut self) -> Option<u32> {
        let recalled = self.recalled.as_mut().filter(|_| self.is_fresh)?;
        recalled.sides.state(&self.judge.reading.system)
    }

    /// A number that is another one after each change of the variables.
    pub(crate) fn changes(&self) -> u64 {
        self.judge.reading.system.atoms.changes()
    }
}

/// How many terms sides have.
fn terms(of: &Sides) -> usize {
    let size = |of: &Fraction| of.numerator().len() + of.denominator().len();
    let sides = of.sides.iter();
    sides.map(|(left, right)| size(left) + size(right)).sum()
}
