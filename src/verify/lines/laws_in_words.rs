//! What a new symbol is by the words before it and the laws: the vertical component of the angular momentum, the frequency
//! of small swings.

use crate::algebra::{Fraction, Rational, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::Letter;
use crate::verify::lines::points::Law;
use crate::verify::values::atoms::{Atom, Entity, Owner, variable_fraction};
use crate::verify::values::lower::constant;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;
use std::collections::BTreeSet;

/// Names of how often a body swings to and fro.
const FREQUENCIES: &[&str] = &[
    "circular frequency",
    "angular frequency",
    "natural frequency",
    "harmonic",
];

/// Further names, which the equation of motion gives a value where it stands before.
const OF_EQUATIONS: &[&str] = &[
    "libration frequency",
    "oscillation frequency",
    "pendulum frequency",
    "frequency of small",
    "frequency of the small",
    "frequency of oscillation",
    "frequency of the oscillation",
    "frequency of the swing",
];

/// Names of the momentum about what a body is carried round.
const ABOUT_VERTICAL: &[&str] = &[
    "angular momentum about the vertical",
    "angular momentum about the shaft",
    "angular momentum about the spindle",
    "angular momentum about the post",
    "angular momentum along the vertical",
    "angular momentum about the fixed axis",
];

/// The name of the law of small swings.
const OF_SWINGS: &str = "frequency of small swings";

/// Whether a premise is that law.
pub(crate) fn is_of_swings(name: &str) -> bool {
    name.starts_with(OF_SWINGS)
}

/// Whether a sentence in small letters speaks of the frequency of small swings.
pub(crate) fn calls_frequency_of_swings(sentence: &str) -> bool {
    has_any(sentence, FREQUENCIES) || has_any(sentence, OF_EQUATIONS)
}

impl Checker<'_> {
    /// The law that words give the symbol on the left of a line, alone or squared.
    pub(crate) fn law_in_words(&mut self, left: &Node, right: Option<&Node>) -> Option<Law> {
        let (symbol, squared) = match &left.kind {
            Kind::Symbol(symbol) => (symbol, false),
            Kind::Power(base, exponent) => match (&base.kind, &exponent.kind) {
                (Kind::Symbol(symbol), Kind::Number(n))
                    if n.value == num_rational::BigRational::from_integer(2.into()) =>
                {
                    (symbol, true)
                }
                _ => return None,
            },
            _ => return None,
        };
        if let (Meaning::Component(entity, place), Some(right)) = (self.meaning_of(symbol), right) {
            return self.gravity(symbol, (entity, place), right);
        }
        if !self.is_new(symbol) {
            return None;
        }
        if squared {
            self.frequency(symbol)
        } else {
            self.vertical_momentum(symbol)
        }
    }

    /// Whether the words before a line call what it speaks of the vertical component of the momentum.
    pub(crate) fn speaks_of_vertical_momentum(&self) -> bool {
        let sentence = lowered(&self.sentence);
        let about = ABOUT_VERTICAL
            .iter()
            .filter_map(|words| sentence.rfind(words))
            .max();
        if about.is_some_and(|at| !sentence[at..].contains('⟩')) {
            return true;
        }
        let Some((_, behind)) = sentence.rsplit_once("vertical component of ") else {
            return self.speaks_of_part_along_vertical(&sentence);
        };
        let mut articles = ["the ", "its "].iter();
        let bare = articles.find_map(|article| behind.strip_prefix(article));
        let named = bare.unwrap_or(behind);
        // "…, and the energy a third" is of another line.
        let formulas = named.matches('⟩').count();
        formulas == 0 && named.starts_with("angular momentum")
            || formulas == 1 && self.starts_with_momentum(named)
    }

    /// "The component of ⟨L⟩ along the vertical", with no formula behind it.
    fn speaks_of_part_along_vertical(&self, sentence: &str) -> bool {
        let directions = [
            " along the vertical",
            " in the vertical direction",
            " along the upward vertical",
        ];
        let split = |words: &&str| sentence.rsplit_once(*words);
        let Some((before, behind)) = directions.iter().find_map(split) else {
            return false;
        };
        let parts = ["component of ", "projection of ", "part of "];
        let of = parts
            .iter()
            .find_map(|part| Some(before.rsplit_once(part)?.1));
        !behind.contains('⟩')
            && of.is_some_and(|of| {
                let lone = of.matches('⟩').count() == 1 && of.ends_with('⟩');
                of.ends_with("angular momentum") || lone && self.starts_with_momentum(of)
            })
    }

    /// "The vertical component of ⟨L⟩": L·K, with the vertical that words give, or that the first of the body's angles
    /// turns about.
    fn vertical_momentum(&mut self, symbol: &Symbol) -> Option<Law> {
        if !self.speaks_of_vertical_momentum() {
            return None;
        }
        let vertical = match (self.vertical.clone(), self.reading.euler_angles.clone()) {
            (Some(vertical), _) => vertical,
            (None, Some(angles)) => Value::column(self.first_axis(&angles)?.as_slice().to_vec()),
            (None, None) => self.axis_of_drive()?,
        };
        let momentum = self.theory.atoms.quantity(Quantity::Momentum);
        let momentum = Value::column(self.theory.atoms.vector(momentum, 0));
        let entity = self.entity_named(symbol)?;
        let value = momentum.dot(&vertical).ok()?;
        Some(Law::new("component along the vertical", entity, value).said())
    }

    /// The direction in which the only rate that is no rate of an angle stands in the angular velocity: a turntable
    /// carries the body round there.
    fn axis_of_drive(&mut self) -> Option<Value> {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let omega = Value::column(self.theory.atoms.vector(omega, 0));
        let omega = omega.map(|part| self.theory.normal(part));
        let drive = |v: &Variable| match *self.theory.atoms.atom(*v) {
            Atom::Part {
                entity, order: 0, ..
            } => {
                let info = self.theory.atoms.info(entity);
                info.shape == Shape::Scalar && matches!(info.owner, Owner::Symbol(_))
            }
            _ => false,
        };
        let met: BTreeSet<Variable> = omega
            .entries
            .iter()
            .flat_map(Fraction::variables)
            .filter(drive)
            .collect();
        let rate = met.first().copied().filter(|_| met.len() == 1)?;
        let axis = omega.map(|part| part.partial(rate));
        // About an axis of the body, with other rates beside it, it is a spin.
        let numeral = |part: &Fraction| part.to_rational().is_some();
        let others = omega.entries.iter().zip(&axis.entries);
        let mut others = others.filter(|(part, along)| along.is_zero() && !part.is_zero());
        if axis.entries.iter().all(numeral) && others.next().is_some() {
            return None;
        }
        let square = axis.dot(&axis).ok()?.as_scalar()?.clone();
        (self.theory.normal(&square) == constant(Rational::from(1))).then_some(axis)
    }

    /// The components of gravity, which points along the axis that the first of the body's angles turns about, or against
    /// it: as a line that gives one of them has it.
    fn gravity(
        &mut self,
        symbol: &Symbol,
        (entity, place): (Entity, u8),
        right: &Node,
    ) -> Option<Law> {
        let angles = self
            .reading
            .euler_angles
            .clone()
            .filter(|_| symbol.name == "g")?;
        let bare = Symbol {
            name: symbol.name.clone(),
            ..Symbol::default()
        };
        let size = self.entity_named(&bare).filter(|&size| size != entity)?;
        let variable = self.theory.atoms.part(entity, place, 0);
        if self.theory.rule(variable).is_some() {
            return None;
        }
        // The vector turns on the axes of the body, and keeps its length.
        self.theory.atoms.info_mut(size).constant = true;
        let size = self.theory.atoms.value(size, 0, 0);
        let vertical = self.first_axis(&angles)?;
        let written = self
            .lowering(Frame::Moving)
            .value(right)
            .ok()
            .filter(Value::is_scalar)?;
        let along = Value::column(vertical.map(|part| part * size.clone()).as_slice().to_vec());
        let fits = |value: &Value, checker: &mut Self| {
            let rest =
                value.entries.get(usize::from(place))?.clone() - written.entries.first()?.clone();
            Some(checker.theory.normal(&rest).is_zero()).filter(|fits| *fits)
        };
        let value = [along.clone(), along.negated()]
            .into_iter()
            .find(|value| fits(value, self).is_some())?;
        Some(Law::new(
            "gravity along the axis of the first turn",
            entity,
            value,
        ))
    }

    /// Whether a piece of a sentence opens with a formula that is the momentum alone.
    fn starts_with_momentum(&self, text: &str) -> bool {
        let formula = text.split('⟨').next().unwrap_or_default();
        let momentum =
            |letter: &&Letter| self.reading.quantities.get(letter) == Some(&Quantity::Momentum);
        let mut letters = self.reading.quantities.keys().filter(momentum);
        letters.any(|letter| {
            let name = letter.name.to_lowercase();
            let mark = formula.trim().strip_suffix(&name);
            mark.is_some_and(|mark| {
                mark.is_empty()
                    || mark.contains("bf")
                    || mark.contains("vec")
                    || mark.contains("bold")
            })
        })
    }

    /// The square that words call a frequency.
    fn frequency(&mut self, symbol: &Symbol) -> Option<Law> {
        let named = has_any(&lowered(&self.sentence), FREQUENCIES);
        let angle = self.reading.usage.only_angle().filter(|_| named)?;
        let angle = Symbol {
            name: angle.name,
            ..Symbol::default()
        };
        let law = self.frequency_of_swings(symbol, &angle);
        law.map(Law::said)
    }

    /// ω² of q̈ = −ω² q, to which the motion of an angle that an equation of motion rules comes down near zero.
    pub(crate) fn frequency_of_swings(&mut self, symbol: &Symbol, angle: &Symbol) -> Option<Law> {
        let angle = self.entity_named(angle)?;
        let own = matches!(self.theory.atoms.info(angle).owner, Owner::Symbol(_));
        let second = self.theory.atoms.value(angle, 0, 2);
        let second = self.theory.normal(&second);
        let variable = self.theory.atoms.part(angle, 0, 0);
        if !own || second == self.theory.atoms.value(angle, 0, 2) {
            return None;
        }
        let calm = !self.small.insert(angle);
        let near = self.low(&second, 1);
        if !calm {
            self.small.remove(&angle);
        }
        let slope = near.numerator().coefficient_of(variable, 1);
        let slope = Fraction::new(slope, near.denominator().clone())?;
        let swings = near - slope.clone() * variable_fraction(variable);
        if !swings.is_zero() || slope.variables().contains(&variable) || slope.is_zero() {
            return None;
        }
        let entity = self.entity_named(symbol)?;
        let value = Value::scalar(Fraction::zero() - slope);
        Some(Law::new(OF_SWINGS, entity, value).squared())
    }
}
