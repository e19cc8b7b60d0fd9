//! The angular velocity of the axes where words give it by an expression and no letter stands for it: "the unit vectors
//! turn with the angular velocity ⟨Ω **k**⟩".

use crate::algebra::Fraction;
use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::Letter;
use crate::verify::theory::law::Axes;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::words::book::{has_any, lowered};

/// What turns.
const AXES: &[&str] = &[
    "axes",
    "unit vectors",
    "base vectors",
    "basis",
    "frame",
    "triad",
];
/// What stands right before the expression.
const TURNING: &[&str] = &["turn", "turns", "rotate", "rotates", "revolve", "revolves"];
const RATES: &[&str] = &[
    "with",
    "with the angular velocity",
    "with an angular velocity",
    "with angular velocity",
    "at the angular velocity",
];
/// The name of the premise.
const NAME: &str = "the angular velocity of the axes by the words";

/// Whether a sentence ends with words that give the axes an angular velocity.
fn gives_rate_of_axes(sentence: &str) -> bool {
    let clause = sentence.rsplit(['.', ';', '⟩']).next().unwrap_or_default();
    let clause = clause.trim_end();
    let subject = RATES.iter().find_map(|rate| {
        let before = clause.strip_suffix(rate)?.trim_end();
        let verb = before.split_whitespace().next_back()?;
        let subject = before
            .strip_suffix(verb)
            .filter(|_| TURNING.contains(&verb));
        subject.map(str::trim_end)
    });
    subject.is_some_and(|subject| {
        let words: Vec<&str> = subject
            .rsplit(',')
            .next()
            .unwrap_or_default()
            .split(' ')
            .collect();
        let near = words[words.len().saturating_sub(4)..].join(" ");
        has_any(&near, AXES) && !near.contains("body")
    })
}

impl Checker<'_> {
    /// Gives the axes the angular velocity that words and an expression give them.
    pub(crate) fn turning_axes(&mut self, node: &Node) {
        if !gives_rate_of_axes(&lowered(&self.sentence))
            || self.reading.speaks_of(Quantity::FrameRate)
            || self.reading.euler_angles.is_some()
        {
            return;
        }
        let value = self.lowering(Frame::Moving).value(node);
        let Some(value) = value.ok().filter(|value| value.is_vector()) else {
            return;
        };
        // Axes that turn with the ω of the body are attached to it.
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        if value.entries == self.theory.atoms.vector(omega, 0) {
            return;
        }
        self.theory.set(|setting| setting.axes = Axes::Turning);
        let rate = self.theory.atoms.quantity(Quantity::FrameRate);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(rate, c, 0));
        let whole: [Fraction; 3] = self.theory.atoms.vector(rate, 0);
        let residuals = whole.into_iter().zip(&value.entries);
        let taken = self.theory.assume(Premise {
            name: NAME.to_owned(),
            residuals: residuals.map(|(own, given)| own - given.clone()).collect(),
            preferred: parts.to_vec(),
            definition: true,
        });
        if taken == Taken::Solved {
            self.tell(node.span, NAME.to_owned());
        }
    }

    /// Unit vectors along, around and up turn with the angle that the second one is called by, where it moves and nothing
    /// else turns.
    pub(crate) fn turns_round(&mut self) {
        let Some(axes) = self.reading.round_axes.clone() else {
            return;
        };
        let angle = axes.angle();
        let turns = [Quantity::FrameRate, Quantity::AngularVelocity];
        let others = turns.into_iter().any(|q| self.reading.speaks_of(q));
        if others || !self.reading.usage.get(&Letter::of(&angle)).moving {
            return;
        }
        let Meaning::Whole(angle) = self.meaning_of(&angle) else {
            return;
        };
        self.known.insert(angle);
        let speed = self.theory.atoms.value(angle, 0, 1);
        self.theory.set(|setting| setting.axes = Axes::Turning);
        let rate = self.theory.atoms.quantity(Quantity::FrameRate);
        let parts = [0, 1, 2].map(|c| self.theory.atoms.part(rate, c, 0));
        let mut whole: [Fraction; 3] = self.theory.atoms.vector(rate, 0);
        whole[2] = whole[2].clone() - speed;
        self.theory.assume(Premise {
            name: NAME.to_owned(),
            residuals: whole.to_vec(),
            preferred: parts.to_vec(),
            definition: true,
        });
    }
}
