//! Links that are judged by fewer premises than are in force, where all of them together grow too large.

use crate::algebra::{Fraction, Place, Proof};
use crate::verify::facts::Source;
use crate::verify::facts::parts::Part;
use crate::verify::facts::premises::Facts;
use crate::verify::facts::proof::prove;
use crate::verify::facts::relevant::{Relevant, relevant};
use crate::verify::facts::turned::spoken_of;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Held, Sides};
use crate::verify::standing::judge::Judge;
use crate::verify::standing::verdicts::Standing;
use num_traits::Zero;

/// A premise of no more terms is a short one.
const MOST_OF_SHORT: usize = 12;

/// The premises of no more sentences and lines are tried alone.
const MOST_PARTS: usize = 36;

/// In no more choices of the premises that links need facts are kept.
const MOST_KEPT: usize = 64;

impl Judge<'_> {
    /// Whether a link follows of a few premises, where all of them are too many.
    pub(super) fn weigh_by_few_premises(&mut self, mut held: Held) -> Held {
        if let Some(proof) = self.proof_by_few_premises(&held.sides) {
            held.proof = Some(proof);
            (held.standing, held.reason, held.doubt) = (Standing::Entailed, None, None);
        }
        held
    }

    /// What it is worth by the premises that it needs, or in letters that are short.
    pub(super) fn weigh_by_needed(&mut self, link: &Link<'_>, worked_out: &Sides) -> Option<Held> {
        self.weigh_by_relevant(link, worked_out)
            .or_else(|| self.weigh_keeping_letters(link, worked_out))
    }

    /// What it is worth without the premises that only tell letters of which it does not speak.
    fn weigh_by_relevant(&mut self, link: &Link<'_>, worked_out: &Sides) -> Option<Held> {
        let atoms = &self.reading.system.atoms;
        let relevant = relevant(atoms, self.premises(), &worked_out.sides)?;
        self.weigh_by_part(
            link,
            worked_out,
            Part::of(relevant.premises),
            relevant.exact,
        )
    }

    /// What it is worth where the letters stay that laws tell by constants: what stands in these laws is told by them.
    fn weigh_keeping_letters(&mut self, link: &Link<'_>, worked_out: &Sides) -> Option<Held> {
        let atoms = &self.reading.system.atoms;
        let (all, goal) = (self.premises(), &worked_out.sides);
        let relevant = relevant(atoms, all.clone(), goal);
        let Relevant { premises, exact } = relevant.unwrap_or(Relevant {
            premises: all,
            exact: true,
        });
        let letters = spoken_of(atoms, &premises, goal);
        let atoms = &mut self.reading.system.atoms;
        if !Facts::keeping(atoms, &letters).turns_any() {
            return None;
        }
        let part = Part::of(premises).keeping(letters);
        self.weigh_by_part(link, worked_out, part, exact)
    }

    /// What it is worth to first or second order, by what the premises say to that order.
    ///
    /// A premise that says less of what is small than products of it says nothing then, so that what fails may hold.
    pub(super) fn weigh_to_order(&mut self, link: &Link<'_>, worked_out: &Sides) -> Option<Held> {
        let small = self.small_here();
        if small.is_empty() {
            return None;
        }
        let (mut laws, mut exact, mut premises) = (Facts::default(), true, vec![]);
        for (equation, source) in self.premises() {
            let atoms = &mut self.reading.system.atoms;
            let equation = laws.normal(atoms, &equation).ok()?;
            let value = small.truncated(atoms, equation.numerator());
            exact &= !value.is_zero() || equation.is_zero();
            if !value.is_zero() {
                let source = Source::ToOrder(Box::new(source), small.premise());
                premises.push((Fraction::from(value), source));
            }
        }
        let atoms = &self.reading.system.atoms;
        let relevant = relevant(atoms, premises.clone(), &worked_out.sides);
        let by_relevant = relevant.and_then(|relevant| {
            let exact = exact && relevant.exact;
            self.weigh_by_part(link, worked_out, Part::of(relevant.premises), exact)
        });
        by_relevant.or_else(|| self.weigh_by_part(link, worked_out, Part::of(premises), exact))
    }

    /// What it is worth by a part of the premises; `exact` where what fails by them fails by all.
    fn weigh_by_part(
        &mut self,
        link: &Link<'_>,
        worked_out: &Sides,
        part: Part,
        exact: bool,
    ) -> Option<Held> {
        let mut kept = std::mem::take(self.facts.needed_mut());
        let known = kept.iter().position(|known| known.is_as(&part));
        let mut part = known.map_or(part, |n| kept.remove(n));
        let facts = part.take(&mut self.reading.system.atoms);
        let all = std::mem::replace(&mut self.facts, facts);
        let residuals = self.residuals(&worked_out.sides);
        let held =
            residuals.map(|residuals| self.weigh_residuals(link, worked_out.clone(), &residuals));
        part.keep(std::mem::replace(&mut self.facts, all));
        if kept.len() < MOST_KEPT {
            kept.push(part);
        }
        *self.facts.needed_mut() = kept;
        let held = held.ok().filter(|held| !held.beyond)?;
        (exact || held.standing == Standing::Entailed).then_some(held)
    }

    /// What follows of a part of the premises follows of all of them.
    fn proof_by_few_premises(&mut self, sides: &[(Fraction, Fraction)]) -> Option<Proof> {
        if self.facts.parts_mut().is_empty() {
            *self.facts.parts_mut() = self.parts_of_premises();
        }
        let mut parts = std::mem::take(self.facts.parts_mut());
        let all = std::mem::take(&mut self.facts);
        let proof = parts.iter_mut().find_map(|part| {
            self.facts = part.take(&mut self.reading.system.atoms);
            let proof = self.proof(sides);
            part.keep(std::mem::take(&mut self.facts));
            proof
        });
        self.facts = all;
        *self.facts.parts_mut() = parts;
        proof
    }

    /// Whether a premise says where things are or how fast they move, and nothing of what accelerates them.
    fn tells_places(&self, equation: &Fraction) -> bool {
        let atoms = &self.reading.system.atoms;
        let mut variables = equation.variables().into_iter();
        variables.all(|v| atoms.atom(v).place != Place::Acceleration)
    }

    /// A proof by the facts that each pair is equal.
    fn proof(&mut self, sides: &[(Fraction, Fraction)]) -> Option<Proof> {
        let residuals = self.residuals(sides).ok()?;
        let small = self.small_here();
        let atoms = &mut self.reading.system.atoms;
        let follows = residuals.iter().all(Zero::is_zero);
        follows.then(|| prove(&mut self.facts, atoms, sides, &small))?
    }

    /// The premises of places, the short ones, those of one sentence or line, and these with the others.
    fn parts_of_premises(&self) -> Vec<Part> {
        let all = self.premises();
        let short =
            |(equation, _): &&(Fraction, Source)| equation.numerator().len() <= MOST_OF_SHORT;
        let places = |(equation, _): &&(Fraction, Source)| self.tells_places(equation);
        let mut parts: Vec<Vec<_>> = vec![
            all.iter().filter(places).cloned().collect(),
            all.iter().filter(short).cloned().collect(),
        ];
        for (_, source) in &all {
            let own = |(_, other): &&(Fraction, Source)| other == source;
            let alone: Vec<_> = all.iter().filter(own).cloned().collect();
            let with_places = all.iter().filter(|p| own(p) || places(p));
            let with_short = all.iter().filter(|p| own(p) || short(p));
            for part in [
                alone,
                with_places.cloned().collect(),
                with_short.cloned().collect(),
            ] {
                if parts.len() <= MOST_PARTS && !parts.contains(&part) {
                    parts.push(part);
                }
            }
        }
        parts.into_iter().map(Part::of).collect()
    }
}
