//! The angle that words put between the angular momentum and the axis of rotation: its cosine is L·ω/(Lω) = 2T/(Lω).

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};

const AXIS_OF_ROTATION: &[&str] = &[
    "angular velocity",
    "axle",
    "axis of rotation",
    "axis of the rotation",
    "rotation axis",
    "instantaneous axis",
];

impl Checker<'_> {
    /// Decides what a line says of the cosine of such an angle, and takes it in where that is right.
    pub(crate) fn is_angle_of_momentum(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right, ..] = sides else {
            return false;
        };
        let Kind::Function(Function::Cos, argument) = &inner(left).kind else {
            return false;
        };
        let new = self
            .new_symbol(argument)
            .is_some_and(|(_, at)| at.is_none());
        if !new || !self.speaks_of_angle_of_momentum(argument) {
            return false;
        }
        let Some(value) = self.lowering(Frame::Moving).scalar(right) else {
            return false;
        };
        let [momentum, omega] = [Quantity::Momentum, Quantity::AngularVelocity].map(|quantity| {
            let entity = self.theory.atoms.quantity(quantity);
            self.theory.atoms.vector(entity, 0)
        });
        let dot = |a: &[Fraction; 3], b: &[Fraction; 3]| {
            let terms = a.iter().zip(b).map(|(a, b)| a.clone() * b.clone());
            terms.fold(Fraction::from_ratio(0, 1), |sum, term| sum + term)
        };
        let sizes = [&momentum, &omega].map(|vector| {
            let argument = dot(vector, vector);
            let function = Function::Sqrt;
            let length = Atom::Kernel { function, argument };
            variable_fraction(self.theory.atoms.special(length))
        });
        let [length, rate] = sizes;
        let bare = self.bare_rate(&value);
        let own = bare.and_then(|v| self.theory.atoms.entity_of(v));
        self.known.extend(own);
        let rate = bare.map_or(rate, variable_fraction);
        let cosine = dot(&momentum, &omega) / (length * rate);
        let lost = cosine.clone() / value.clone();
        match decide(&mut self.theory, &[Equation::of_scalars(value, cosine)]) {
            Decision::True(_) => self.accept_definition(sides, finding),
            Decision::False(witness) if self.unknown(&sides[1..]).is_none() => {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("the cosine of this angle is L·ω/(Lω)".to_owned());
                finding.counterexample = Some(*witness);
                let lost = self.theory.normal(&lost).to_rational();
                finding.diagnosis = lost.map(|factor| self.lost_in_front(factor, left, right));
                true
            }
            _ => false,
        }
    }

    /// Whether words have such an angle, by words or by letters: in the sentence, or where they name the angle.
    fn speaks_of_angle_of_momentum(&self, angle: &Node) -> bool {
        let mut texts = vec![lowered(&self.sentence)];
        if let Kind::Symbol(symbol) = &inner(angle).kind {
            let named = self.text.named_sentences().iter();
            let naming = named.filter(|s| s.letters.contains(&symbol.name));
            texts.extend(naming.map(|s| lowered(&s.text)));
        }
        texts
            .iter()
            .any(|text| self.is_between_momentum_and_rate(text))
    }

    fn is_between_momentum_and_rate(&self, text: &str) -> bool {
        let Some((_, behind)) = text.split_once("angle") else {
            return false;
        };
        let Some((name, behind)) = behind.split_once("between ") else {
            return false;
        };
        if name.split_whitespace().count() > 2 {
            return false;
        }
        let letter = |quantity: Quantity| {
            let letters = self.reading.quantities.iter();
            let mut names = letters
                .filter(|(_, q)| **q == quantity)
                .map(|(letter, _)| letter.name.to_lowercase());
            let words = || behind.split(|c: char| !c.is_alphanumeric());
            names.any(|name| {
                let marked = ["mathbf", "boldsymbol", "vec", "bm", "mathbfit"];
                words().any(|word| {
                    let mark = word.strip_suffix(name.as_str());
                    mark.is_some_and(|mark| mark.is_empty() || marked.contains(&mark))
                })
            })
        };
        let momentum = behind.contains("angular momentum") || letter(Quantity::Momentum);
        let turning = has_any(behind, AXIS_OF_ROTATION) || letter(Quantity::AngularVelocity);
        momentum && turning
    }

    /// The letter of the angular velocity where it stands bare for a number of its own, which is its size here.
    fn bare_rate(&self, value: &Fraction) -> Option<Variable> {
        let atoms = &self.theory.atoms;
        value.variables().into_iter().find(|&v| {
            let Some(Owner::Symbol(key)) = atoms.owner(v) else {
                return false;
            };
            let letter = key.split(' ').next().unwrap_or_default();
            let of = self.reading.quantities.get(&Letter::plain(letter));
            of == Some(&Quantity::AngularVelocity)
        })
    }
}
