//! Energy, and what does not change.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::derivation::Law;
use crate::verify::derivation::nouns::Key;
use crate::verify::derivation::plan::Subject;
use crate::verify::derivation::story::{Claim, Story};
use crate::verify::derivation::text::Text;
use num_traits::Zero;

impl Story {
    /// The energies of a body whose loads are known, and its first integrals.
    pub(super) fn tell_energy(&mut self, subject: &Subject) {
        if subject.loads.is_none() {
            return;
        }
        self.tell_kinetic_energy(subject);
        if self.tell_potential_energy(subject)
            && let Some((kinetic, _)) = self.scalar(Key::Kinetic(subject.body))
            && let Some((potential, _)) = self.scalar(Key::Potential(subject.body))
            && let Some((total, _)) = self.scalar(Key::Total(subject.body))
        {
            let sum = Text {
                latex: format!("{} + {}", kinetic.latex, potential.latex),
                unicode: format!("{} + {}", kinetic.unicode, potential.unicode),
            };
            self.tell_row(Law::TotalEnergy, total, sum);
        }
        let kept = self.kept(subject);
        self.step(Law::FirstIntegrals, kept);
    }

    /// The potential energy, where there is one.
    fn tell_potential_energy(&mut self, subject: &Subject) -> bool {
        let key = Key::Potential(subject.body);
        if let Some((_, quantity)) = self.nouns.of(key).cloned()
            && let Ok(value) = self.letters.system().value_of(&quantity)
            && let Ok(value) = value.to_scalar()
            && self.letters.printed(&value).is_some()
            && let Some((text, own)) = self.scalar(key)
        {
            self.step(Law::PotentialEnergy, [(text, own, value.clone())]);
            return !value.is_zero();
        }
        false
    }

    pub(super) fn tell_kinetic_energy(&mut self, subject: &Subject) {
        let Some(value) = self.kinetic_energy(subject) else {
            return;
        };
        let parts = self.letters.reading.system.wholes(subject.body);
        let parts: Vec<Subject> = parts.into_iter().filter_map(|b| self.subject(b)).collect();
        let law = match parts.iter().any(|part| self.moves(part) && !part.pivoted) {
            true => Law::Koenig,
            false => Law::KineticEnergy,
        };
        if let Some((text, own)) = self.scalar(Key::Kinetic(subject.body)) {
            self.step(law, [(text, own, value)]);
        }
    }

    /// T in letters, by König's law.
    fn kinetic_energy(&mut self, subject: &Subject) -> Option<Fraction> {
        for lettered in [false, true] {
            let mut sum = Fraction::zero();
            for part in self.letters.reading.system.wholes(subject.body) {
                let part = self.subject(part)?;
                sum += self.energy_of_part(&part, lettered)?;
            }
            let sum = self.letters.shortest(&sum);
            if self.letters.printed(&sum).is_some() {
                return Some(sum);
            }
        }
        None
    }

    fn energy_of_part(&mut self, part: &Subject, lettered: bool) -> Option<Fraction> {
        let system = &self.letters.reading.system;
        let (frame, centre) = (
            system.bodies[part.body].frame,
            system.bodies[part.body].centre,
        );
        let point = if part.pivoted { part.about } else { centre };
        let mut sum = Fraction::zero();
        if let Some(frame) = frame {
            let omega = self.omega(frame);
            let tensor = self.tensor(part, point, lettered)?;
            sum += mechanics::kinetic_energy(&tensor, &omega);
        }
        if point == centre && self.moves(part) {
            let velocity = self.velocity(part)?;
            let mass = self.mass(part)?;
            sum += Fraction::from_ratio(1, 2) * mass * velocity.dot(&velocity);
        }
        Some(sum)
    }

    /// What the facts prove to be constant.
    fn kept(&mut self, subject: &Subject) -> Vec<Claim> {
        let mut claims = vec![];
        let weighs = self.nouns.of(Key::Potential(subject.body)).is_some();
        let energy = match weighs {
            true => Key::Total(subject.body),
            false => Key::Kinetic(subject.body),
        };
        let upward = self.turns(subject).then_some(Key::Upward(subject.body));
        for key in std::iter::once(energy).chain(upward) {
            let Some((_, quantity)) = self.nouns.of(key).cloned() else {
                continue;
            };
            let Ok(value) = self.letters.system().value_of(&quantity) else {
                continue;
            };
            let Ok(value) = value.to_scalar() else {
                continue;
            };
            let rate = self.letters.system().atoms.derivative(&value);
            if rate.is_zero() || !self.letters.vanishes(&rate) {
                continue;
            }
            if let Some((text, _)) = self.scalar(key)
                && let Some(dotted) = text.dotted(1)
            {
                claims.push((dotted, rate, Fraction::zero()));
            }
        }
        claims.extend(self.kept_components(subject));
        claims
    }

    /// Components of the angular momentum that do not change; of a body without moment the length.
    fn kept_components(&mut self, subject: &Subject) -> Vec<Claim> {
        if !self.turns(subject) {
            return vec![];
        }
        let Some(momentum) = self.vector(Key::AngularMomentum(subject.body)) else {
            return vec![];
        };
        let mut claims = vec![];
        for axis in 0..3 {
            let entry = momentum.entries[axis].clone();
            let rate = self.letters.system().atoms.derivative(&entry);
            if !rate.is_zero()
                && self.letters.vanishes(&rate)
                && let Some(dotted) = momentum.texts[axis].dotted(1)
            {
                claims.push((dotted, rate, Fraction::zero()));
            }
        }
        let square = momentum.entries.dot(&momentum.entries);
        let rate = self.letters.system().atoms.derivative(&square);
        if claims.len() < 3 && !rate.is_zero() && self.letters.vanishes(&rate) {
            let squares = momentum.texts.iter().zip(momentum.entries.iter());
            let squares: Vec<&Text> = squares
                .filter(|(_, e)| !e.is_zero())
                .map(|(t, _)| t)
                .collect();
            let sum = |of: &dyn Fn(&Text) -> String| {
                let terms: Vec<String> = squares.iter().map(|text| of(text)).collect();
                terms.join(" + ")
            };
            let left = Text {
                latex: format!("\\frac{{d}}{{dt}}({})", sum(&|t| format!("{}^2", t.latex))),
                unicode: format!("d/dt ({})", sum(&|t| format!("{}²", t.unicode))),
            };
            claims.push((left, rate, Fraction::zero()));
        }
        claims
    }
}
