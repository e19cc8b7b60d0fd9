//! How frames turn and points move.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::derivation::nouns::Key;
use crate::verify::derivation::plan::Subject;
use crate::verify::derivation::story::Story;
use crate::verify::derivation::{Law, Subject as About};
use crate::verify::model::system::{FrameId, Vector};
use num_traits::Zero;

impl Story {
    /// The angular velocity of each frame as a sum along its chain.
    pub(super) fn tell_frames(&mut self) {
        let mut claims = vec![];
        for (frame, _) in self.plan.frames.clone() {
            let ground = self.letters.reading.system.ground;
            let sum = self.letters.system().angular_velocity(frame, ground);
            if let Some(known) = self.vector(Key::Turn(frame)) {
                claims.extend(Self::claims(&known, &sum));
            }
        }
        self.step(Law::AngularVelocities, claims);
        self.end(About::Frames);
    }

    /// The angular velocity of the frame of a body, in letters.
    pub(super) fn omega(&mut self, frame: FrameId) -> Vector {
        if frame == self.letters.reading.system.ground {
            return Vector::zeros();
        }
        let ground = self.letters.reading.system.ground;
        match self.vector(Key::Turn(frame)) {
            Some(known) => known.entries,
            None => self.letters.system().angular_velocity(frame, ground),
        }
    }

    /// The velocity of the mass centre.
    pub(super) fn tell_motion(&mut self, subject: &Subject) {
        if !self.moves(subject) {
            return;
        }
        let Some(known) = self.vector(Key::Velocity(subject.body)) else {
            return;
        };
        let (law, value) = match self.arm(subject) {
            Some((omega, way)) => (Law::PointOfBody, mechanics::cross(&omega, &way)),
            None => {
                let ground = self.letters.reading.system.ground;
                let centre = self.letters.reading.system.bodies[subject.body].centre;
                (
                    Law::Velocity,
                    self.letters.system().velocity(centre, ground),
                )
            }
        };
        self.step(law, Self::claims(&known, &value));
    }

    /// The acceleration of the mass centre.
    pub(super) fn tell_acceleration(&mut self, subject: &Subject) {
        if let Some(velocity) = self.velocity(subject)
            && let Some(known) = self.vector(Key::Acceleration(subject.body))
        {
            let rate = self.rate(&velocity);
            self.step(Law::Acceleration, Self::claims(&known, &rate));
        }
    }

    /// Whether the mass centre moves.
    pub(super) fn moves(&self, subject: &Subject) -> bool {
        let system = &self.letters.reading.system;
        let centre = &system.points[system.bodies[subject.body].centre];
        !centre.fixed_in.contains(&system.ground)
    }

    /// The angular velocity of a body with a fixed point, and the way from there to the mass centre, in letters.
    fn arm(&mut self, subject: &Subject) -> Option<(Vector, Vector)> {
        let system = &self.letters.reading.system;
        let frame = system.bodies[subject.body].frame?;
        if !subject.pivoted {
            return None;
        }
        let centre = system.bodies[subject.body].centre;
        let way = system.position(centre, subject.about);
        let way = match self.is_written(&way) {
            true => way,
            false => self.vector(Key::Way(subject.body))?.entries,
        };
        Some((self.omega(frame), way))
    }

    /// The velocity of the mass centre in letters.
    pub(super) fn velocity(&mut self, subject: &Subject) -> Option<Vector> {
        if !self.moves(subject) {
            return Some(Vector::zeros());
        }
        let known = self.vector(Key::Velocity(subject.body))?;
        if self.is_written(&known.entries) {
            return Some(known.entries);
        }
        let (omega, way) = self.arm(subject)?;
        let value = mechanics::cross(&omega, &way);
        self.is_written(&value).then_some(value)
    }

    /// The mass of a body in letters: of a whole the sum of those of its parts.
    pub(super) fn mass(&mut self, subject: &Subject) -> Option<Fraction> {
        for part in self.letters.reading.system.wholes(subject.body) {
            let own = self.letters.reading.system.mass(part);
            if self.letters.printed(&own).is_none() {
                self.scalar(Key::Mass(part))?;
            }
        }
        let mass = self.letters.reading.system.mass(subject.body);
        let written = self.letters.printed(&mass).is_some() && !mass.is_zero();
        written.then_some(mass)
    }
}
