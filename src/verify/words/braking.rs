//! A torque that slows a body down: its letter stands for the size of a moment against the turn.

use crate::verify::check::Checker;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::Letter;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::text::Text;

/// Words for what works against the turn.
const AGAINST: &[&str] = &[
    "slowed",
    "slows",
    "brak",
    "retard",
    "decelerat",
    "friction",
    "opposes",
    "opposing",
    "resist",
];

/// Words of a sentence with a torque that drives, or without friction.
const ALONG: &[&str] = &[
    "driv",
    "motor",
    "engine",
    "accelerat",
    "speeds up",
    "speed up",
    "speeding up",
    "spins up",
    "starts",
    "neglect",
    "neglig",
    "frictionless",
    "no friction",
    "without friction",
    "overcome",
];

impl Reading {
    /// Takes the letter of the only moment of a turn about one axis out, where its sentence says that it brakes.
    pub(crate) fn part_brake(&mut self, document: &Text) {
        if !self.flat || !document.says(AGAINST) {
            return;
        }
        let moments = self.components.iter();
        let mut moments = moments.filter(|(_, (quantity, _))| *quantity == Quantity::Moment);
        let (Some((letter, &(_, axis))), None) = (moments.next(), moments.next()) else {
            return;
        };
        let letter = letter.clone();
        let brakes = document
            .sentences()
            .iter()
            .filter(|sentence| {
                let text = lowered(&sentence.named());
                has_any(&text, AGAINST) && !has_any(&text, ALONG)
            })
            .find_map(|sentence| {
                let mut symbols = sentence.symbols();
                let own = symbols.find(|(symbol, _)| Letter::of(symbol) == letter)?;
                Some((own.0.clone(), axis, own.1))
            });
        if brakes.is_some() {
            self.components.remove(&letter);
        }
        self.brake = brakes;
    }
}

impl Checker<'_> {
    /// The moment of a brake is against the turn.
    pub(crate) fn brake_acts(&mut self) {
        let Some((symbol, axis, span)) = self.reading.brake.clone() else {
            return;
        };
        let Some(size) = self.value_of(&symbol, span) else {
            return;
        };
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let moment = self.theory.atoms.part(moment, axis, 0);
        let premise = Premise {
            name: "the torque is against the turn".to_owned(),
            preferred: size.as_variable().into_iter().collect(),
            residuals: vec![variable_fraction(moment) + size],
            definition: false,
        };
        self.take_from_words(premise, span);
    }
}
