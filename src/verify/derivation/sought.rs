//! The one quantity that is asked for, and what leads to it.

use crate::verify::derivation::nouns::Key;
use crate::verify::derivation::story::{Claim, Story};
use crate::verify::derivation::text::Text;
use crate::verify::derivation::{Law, Subject as About};

impl Story {
    /// Tells what leads to the quantity that is asked for, and no more.
    pub(super) fn tell_sought(&mut self) {
        use Key::{
            Acceleration, AngularMomentum, Force, Kinetic, Moment, Momentum, Turn, Velocity,
        };
        self.tell_frames();
        let key = self.nouns.key_of_sought();
        let of = key.and_then(|key| {
            let subjects = self.plan.bodies.iter();
            let mut fitting = subjects.filter(|subject| key.is_of(subject.body));
            fitting.next().cloned()
        });
        match (key, of) {
            (Some(Turn(_)), _) => {}
            (Some(Velocity(_)), Some(of)) => self.tell_motion(&of),
            (Some(Acceleration(_)), Some(of)) => {
                self.tell_motion(&of);
                self.tell_acceleration(&of);
            }
            (Some(Momentum(_)), Some(of)) => {
                self.tell_motion(&of);
                self.tell_momentum(&of);
            }
            (Some(Force(_)), Some(of)) => {
                self.tell_motion(&of);
                self.tell_force(&of);
            }
            (Some(AngularMomentum(_)), Some(of)) => self.tell_angular_momentum(&of),
            (Some(Moment(_)), Some(of)) => {
                self.tell_angular_momentum(&of);
                self.tell_moment(&of);
            }
            (Some(Kinetic(_)), Some(of)) => {
                if !of.pivoted {
                    self.tell_motion(&of);
                }
                self.tell_kinetic_energy(&of);
            }
            _ => self.tell_definition(),
        }
        self.end(About::Body(String::new()));
    }

    /// A quantity by what it is.
    fn tell_definition(&mut self) {
        let Some((noun, quantity)) = self.nouns.of(Key::Sought).cloned() else {
            return;
        };
        let free: Vec<String> = ["X", "Y", "Q", "\\Xi"].map(str::to_owned).to_vec();
        let Some(letter) = self.letters.letter(&noun, &quantity, &free) else {
            return;
        };
        self.hear(&letter);
        let Ok(value) = self.letters.system().value_of(&quantity) else {
            return;
        };
        let left = self.letters.value(&letter.latex, &quantity);
        let left = left.map_or(vec![], |left| left.entries);
        let labels = self.plan.labels;
        let text = |at: usize| match value.entries.len() {
            3 => Text::of_component(&letter.latex, labels[at]),
            1 => Text::of_letter(&letter.latex),
            _ => Text::of_component(
                &letter.latex,
                &format!("{}{}", labels[at / 3 % 3], labels[at % 3]),
            ),
        };
        let claims = value.entries.iter().zip(left).enumerate();
        let claims = claims.map(|(at, (value, left))| (text(at), left, value.clone()));
        let claims: Vec<Claim> = claims.collect();
        self.step(Law::Definition, claims);
    }
}
