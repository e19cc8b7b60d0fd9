//! The compound pendulum: `I_O\ddot\theta = -mgd\sin\theta` for a body that swings about a fixed horizontal axis, with θ
//! from the vertical and d from the axis to the mass centre.

use crate::algebra::Fraction;
use crate::notation::ast::{Function, Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::two_points::CENTRES;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::lines::defined_squares::is_two;
use crate::verify::lines::points::Law;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::has_any;
use num_traits::Zero;

/// The name of the law.
pub(crate) const LAW: &str = "the weight about the axis";
/// Words of a body that hangs.
const HANGS: &[&str] = &["pendulum", "swing", "pivot"];
/// Words of the angle of a body that hangs.
const FROM_REST: &[&str] = &[
    "vertical",
    "swing angle",
    "angle of swing",
    "angle of the swing",
    "swung through",
    "swings through",
    "deflection",
    "position of rest",
    "rest position",
    "equilibrium",
    "hanging position",
    "lowest position",
];
/// Words for the mass centre.
const CENTRE: &[&str] = &[
    "mass cent",
    "centre of mass",
    "center of mass",
    "centre of gravity",
    "center of gravity",
];

impl Checker<'_> {
    /// Takes the law in before the first line that it could be.
    pub(crate) fn take_pendulum(&mut self, sides: &[Node]) -> Option<()> {
        let swung = sides.iter().find_map(swung)?;
        let taken = self.theory.premises().iter().any(|p| p.name == LAW);
        if taken || !self.text.says(HANGS) || !self.says_of(&swung, FROM_REST) {
            return None;
        }
        let mut met: Vec<&Symbol> = sides.iter().flat_map(symbols).collect();
        met.dedup();
        let reading = &self.reading;
        let of = |quantity: Quantity| {
            let has = |s: &&&Symbol| {
                let letter = Letter::of(s);
                let part = reading.components.get(&letter).map(|(of, _)| of);
                reading.quantities.get(&letter).or(part) == Some(&quantity)
            };
            met.iter().find(has).copied()
        };
        let (inertia, mass) = (of(Quantity::Inertia)?, of(Quantity::Mass)?);
        let bare = |s: &&&Symbol| s.subscripts.is_empty() && s.name == "g";
        let gravity = *met.iter().find(bare)?;
        let parts = [inertia, mass, gravity, &swung];
        let mut others = met.iter().filter(|s| !parts.contains(s));
        let distance = *others.next()?;
        if others.any(|s| *s != distance)
            || !self.says_of(distance, &["distance"])
            || !self.says_of(distance, CENTRE)
        {
            return None;
        }
        let central = inertia
            .subscripts
            .iter()
            .any(|s| CENTRES.contains(&s.as_str()));
        let named = [inertia, mass, distance, gravity].map(|s| self.entity_named(s));
        // Both points are fixed in the body.
        if let Some(arm) = named[2] {
            self.theory.atoms.info_mut(arm).constant = true;
        }
        let [inertia, mass, gravity, arm, angle] =
            [inertia, mass, gravity, distance, &swung].map(|s| self.value_of(s, sides[0].span));
        let (mass, arm, angle) = (mass?, arm?, angle?);
        let about_axis = match central {
            true => inertia? + mass.clone() * arm.clone() * arm.clone(),
            false => inertia?,
        };
        let entity = self.entity_named(&swung)?;
        let acceleration = self.theory.atoms.value(entity, 0, 2);
        let sine = self.lowering(Frame::Moving).kernel(Function::Sin, angle)?;
        let premise = Premise {
            name: LAW.to_owned(),
            residuals: vec![about_axis * acceleration + mass * gravity? * arm * sine],
            preferred: vec![self.theory.atoms.part(entity, 0, 2)],
            definition: false,
        };
        if self.theory.assume(premise) == Taken::Solved {
            self.keep(LAW, true);
            self.known.insert(entity);
            self.known.extend(named.into_iter().flatten());
        }
        Some(())
    }

    /// Whether a sentence has a symbol, and words with it.
    fn says_of(&self, symbol: &Symbol, words: &[&str]) -> bool {
        let mark = format!("⟨{}⟩", symbol.name);
        let mut said = self.text.named_sentences().iter();
        said.any(|sentence| sentence.text.contains(&mark) && has_any(&sentence.text, words))
    }
}

impl Checker<'_> {
    /// The new symbol whose square stands in `\ddot\theta + \omega_0^2\theta = 0`.
    pub(crate) fn frequency_in_equation(&mut self, sides: &[Node]) -> Option<Law> {
        let swung = sides.iter().find_map(swung)?;
        let squared = sides.iter().find_map(squared)?;
        if sides.len() != 2 || !self.is_new(&squared) {
            return None;
        }
        let law = self.frequency_of_swings(&squared, &swung)?;
        match self.grows_in_equation(sides, &squared, &swung) {
            true => Some(law.negated()),
            false => Some(law),
        }
    }

    /// Whether a line has ẍ = κ²x, of which the solutions grow.
    fn grows_in_equation(&mut self, sides: &[Node], squared: &Symbol, swung: &Symbol) -> bool {
        let [left, right] = sides else { return false };
        let (Some(rate), Some(x)) = (self.entity_named(squared), self.entity_named(swung)) else {
            return false;
        };
        let mut lowering = self.lowering(Frame::Moving);
        let (Some(left), Some(right)) = (lowering.scalar(left), lowering.scalar(right)) else {
            return false;
        };
        let rest = left - right;
        let rest = rest.numerator();
        let [rate, own] = [rate, x].map(|e| self.theory.atoms.part(e, 0, 0));
        let second = self.theory.atoms.part(x, 0, 2);
        let inertia = Fraction::from(rest.coefficient_of(second, 1));
        let spring = Fraction::from(rest.coefficient_of(rate, 2).coefficient_of(own, 1));
        if inertia.is_zero() {
            return false;
        }
        let ratio = (spring / inertia).to_rational();
        ratio.is_some_and(|ratio| ratio < 0.into())
    }
}

/// A symbol whose square stands in a node.
pub(crate) fn squared(node: &Node) -> Option<Symbol> {
    if let Kind::Power(base, exponent) = &node.kind
        && let Kind::Symbol(symbol) = &inner(base).kind
        && is_two(inner(exponent))
    {
        return Some(symbol.clone());
    }
    node.children().find_map(squared)
}

/// The angle whose second rate stands in a node.
pub(crate) fn swung(node: &Node) -> Option<Symbol> {
    if let Kind::TimeDerivative {
        operand, order: 2, ..
    } = &node.kind
        && let Kind::Symbol(symbol) = &inner(operand).kind
    {
        return Some(symbol.clone());
    }
    node.children().find_map(swung)
}
