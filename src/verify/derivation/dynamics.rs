//! Momentum, angular momentum, their rates, and the loads.

use crate::mechanics;
use crate::verify::derivation::Law;
use crate::verify::derivation::nouns::Key;
use crate::verify::derivation::plan::{Load, Subject};
use crate::verify::derivation::story::{Claim, Story};
use crate::verify::language::heads;
use crate::verify::model::system::Vector;

impl Story {
    /// From the momentum to the equations of motion.
    pub(super) fn tell_dynamics(&mut self, subject: &Subject) {
        if !self.is_part(subject) {
            self.tell_momentum(subject);
            self.tell_force(subject);
        }
        if self.turns(subject) {
            self.tell_angular_momentum(subject);
            self.tell_moment(subject);
        }
        self.tell_loads(subject);
        self.tell_equations(subject);
    }

    /// Whether more than a particle is told of.
    pub(super) fn turns(&self, subject: &Subject) -> bool {
        let bodies = &self.letters.reading.system.bodies;
        let body = &bodies[subject.body];
        body.frame.is_some() || !body.parts.is_empty()
    }

    /// p = m v.
    pub(super) fn tell_momentum(&mut self, subject: &Subject) {
        if !self.moves(subject) {
            return;
        }
        let (Some(momentum), Some(known)) = (
            self.momentum(subject),
            self.vector(Key::Momentum(subject.body)),
        ) else {
            return;
        };
        self.step(Law::Momentum, Self::claims(&known, &momentum));
    }

    fn momentum(&mut self, subject: &Subject) -> Option<Vector> {
        let velocity = self.velocity(subject)?;
        let mass = self.mass(subject)?;
        Some(velocity * mass)
    }

    /// The force that the motion needs.
    pub(super) fn tell_force(&mut self, subject: &Subject) {
        if !self.moves(subject) {
            return;
        }
        let Some(momentum) = self.momentum(subject) else {
            return;
        };
        let rate = self.rate(&momentum);
        if let Some(known) = self.vector(Key::Force(subject.body)) {
            self.step(Law::Newton, Self::claims(&known, &rate));
        }
    }

    /// L in the letters of inertia and of angular velocity.
    pub(super) fn tell_angular_momentum(&mut self, subject: &Subject) {
        let Some(value) = self.angular_momentum(subject) else {
            return;
        };
        let whole = self.letters.reading.system.bodies[subject.body]
            .parts
            .is_empty();
        let law = match whole {
            true => Law::AngularMomentum,
            false => Law::SumOfParts,
        };
        if let Some(known) = self.vector(Key::AngularMomentum(subject.body)) {
            self.step(law, Self::claims(&known, &value));
        }
    }

    /// Whether a body is told of as a part of another one.
    fn is_part(&self, subject: &Subject) -> bool {
        let bodies = &self.letters.reading.system.bodies;
        let wholes = self.plan.bodies.iter().map(|whole| &bodies[whole.body]);
        wholes.into_iter().any(|w| w.parts.contains(&subject.body))
    }

    /// The angular momentum of a body about its fixed point or mass centre, in letters.
    pub(super) fn angular_momentum(&mut self, subject: &Subject) -> Option<Vector> {
        let mut sum = Vector::zeros();
        for lettered in [false, true] {
            sum = Vector::zeros();
            for part in self.letters.reading.system.wholes(subject.body) {
                let part = self.subject(part)?;
                sum += self.momentum_of_part(&part, subject, lettered)?;
            }
            sum = sum.map(|entry| self.letters.shortest(&entry));
            if self.is_written(&sum) {
                return Some(sum);
            }
        }
        self.is_written(&sum).then_some(sum)
    }

    /// What a part without parts adds to the angular momentum of a whole about its point.
    fn momentum_of_part(
        &mut self,
        part: &Subject,
        whole: &Subject,
        lettered: bool,
    ) -> Option<Vector> {
        let system = &self.letters.reading.system;
        let (centre, frame) = (
            system.bodies[part.body].centre,
            system.bodies[part.body].frame,
        );
        let pivoted = part.pivoted && part.about == whole.about;
        let point = if pivoted { part.about } else { centre };
        let mut sum = Vector::zeros();
        if let Some(frame) = frame {
            let omega = self.omega(frame);
            let tensor = self.tensor(part, point, lettered)?;
            sum += mechanics::angular_momentum(&tensor, &omega);
        }
        // About the mass centre of the whole, velocities relative to it give the same.
        if point != whole.about {
            let way = self.letters.reading.system.position(centre, whole.about);
            let mass = self.mass(part)?;
            let velocity = self.rate(&way);
            sum += mechanics::cross(&way, &velocity) * mass;
        }
        Some(sum)
    }

    /// The moment that the motion needs: the rate of L by the transport law, and with L put in.
    pub(super) fn tell_moment(&mut self, subject: &Subject) {
        let Some(value) = self.angular_momentum(subject) else {
            return;
        };
        let Some(momentum) = self.vector(Key::AngularMomentum(subject.body)) else {
            return;
        };
        let Some(known) = self.vector(Key::Moment(subject.body)) else {
            return;
        };
        let mut written = momentum.entries.clone();
        for axis in 0..3 {
            if self.letters.printed(&written[axis]).is_none() {
                written[axis] = value[axis].clone();
            }
        }
        let rate = self.rate(&written);
        self.step(Law::Moment, Self::claims(&known, &rate));
        let rate = self.rate(&value);
        self.step(Law::MomentPutIn, Self::claims(&known, &rate));
    }

    /// The weight and its moment.
    fn tell_loads(&mut self, subject: &Subject) {
        let loads = subject.loads.clone().unwrap_or_default();
        for (number, load) in loads.iter().enumerate() {
            if load.noun.head != heads::WEIGHT {
                continue;
            }
            self.tell_vector(Law::Weight, Key::Load(subject.body, number));
            if !self.turns(subject) {
                continue;
            }
            self.tell_vector(Law::MomentsOfLoads, Key::MomentOfLoad(subject.body, number));
        }
    }

    /// A vector by the value of the quantity.
    fn tell_vector(&mut self, law: Law, key: Key) {
        let Some((_, quantity)) = self.nouns.of(key).cloned() else {
            return;
        };
        let value = self.letters.system().value_of(&quantity);
        if let Ok(value) = value.and_then(|value| value.to_vector())
            && self.is_written(&value)
            && value != Vector::zeros()
            && let Some(known) = self.vector(key)
        {
            self.step(law, Self::claims(&known, &value));
        }
    }

    /// What the loads on a body come to: their sum, and the sum of their moments; `None` where one is not known.
    fn sum_of_loads(&mut self, subject: &Subject, moments: bool) -> Option<Vector> {
        let loads = subject.loads.clone()?;
        let mut sum = Vector::zeros();
        for (number, load) in loads.iter().enumerate() {
            sum += self.load(subject, number, load, moments)?;
        }
        Some(sum)
    }

    fn load(
        &mut self,
        subject: &Subject,
        number: usize,
        load: &Load,
        moment: bool,
    ) -> Option<Vector> {
        if moment && load.noun.head == heads::FORCE && load.at == Some(subject.about) {
            return Some(Vector::zeros());
        }
        if load.noun.head != heads::WEIGHT {
            return None;
        }
        let key = match moment {
            true => Key::MomentOfLoad(subject.body, number),
            false => Key::Load(subject.body, number),
        };
        let (_, quantity) = self.nouns.of(key).cloned()?;
        let value = self.letters.system().value_of(&quantity).ok()?;
        value.to_vector().ok()
    }

    /// What the motion needs is what the loads give.
    fn tell_equations(&mut self, subject: &Subject) {
        if let Some(sum) = self.sum_of_loads(subject, false)
            && let Some(momentum) = self.momentum(subject)
            && self.moves(subject)
        {
            let rate = self.rate(&momentum);
            let claims = self.equations(&rate, &sum);
            self.step(Law::EquationsOfCentre, claims);
        }
        if self.turns(subject)
            && let Some(sum) = self.sum_of_loads(subject, true)
            && let Some(momentum) = self.angular_momentum(subject)
        {
            let rate = self.rate(&momentum);
            let claims = self.equations(&rate, &sum);
            self.step(Law::Equations, claims);
        }
    }

    fn equations(&mut self, needed: &Vector, given: &Vector) -> Vec<Claim> {
        let mut claims = vec![];
        for (needed, given) in needed.iter().zip(given.iter()) {
            let needed = self.letters.shortest(needed);
            if let Some(text) = self.letters.printed(&needed) {
                claims.push((text, needed, given.clone()));
            }
        }
        claims
    }
}
