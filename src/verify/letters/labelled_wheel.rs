//! The momentum of a wheel as a number in a component of the whole: `h_x = A p + h_r` with the letter of that and a label, or
//! `H_x = A p + h` with one of its own that words call a momentum, where no vector of it is written.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::one_axis::wheel_axis;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::text::Text;
use std::collections::BTreeSet;

/// The momentum of a wheel along an axis, as a symbol.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) struct LabelledWheel {
    letter: Letter,
    label: String,
    pub(crate) axis: u8,
}

impl LabelledWheel {
    /// Whether a symbol is that number.
    pub(crate) fn is(&self, symbol: &Symbol) -> bool {
        symbol.subscripts.concat() == self.label
            && !symbol.style.vector
            && Letter::of(symbol) == self.letter
    }

    /// What a line adds to a component of the momentum, and the letter of that.
    fn in_line(sides: &[Node]) -> Option<(Letter, Self)> {
        let [left, right] = sides else { return None };
        let (Kind::Symbol(whole), Kind::Sum(terms)) = (&inner(left).kind, &inner(right).kind)
        else {
            return None;
        };
        let [component] = whole.subscripts.as_slice() else {
            return None;
        };
        let along = axis(component)?;
        let of_whole = Letter::of(whole);
        let mut added = terms
            .iter()
            .filter_map(|term| match &inner(&term.node).kind {
                Kind::Symbol(symbol) => Some(symbol),
                _ => None,
            });
        let (symbol, None) = (added.next()?, added.next()) else {
            return None;
        };
        let letter = Letter::of(symbol);
        let label = symbol.subscripts.concat();
        let apart = match label.is_empty() {
            true => letter != of_whole,
            false => symbol.subscripts.len() == 1 && axis(&label).is_none(),
        };
        let wheel = Self {
            letter,
            label,
            axis: along,
        };
        (apart && !symbol.style.vector).then_some((of_whole, wheel))
    }
}

impl Reading {
    /// Takes a letter that words give the momentum of a wheel for that of the whole, where components by the letter have
    /// the wheel's with a label in them. The wheel lies along the axis that words name, or else the only one in whose
    /// component it stands.
    pub(crate) fn note_labelled_wheel(&mut self, document: &Text) {
        if !self.speaks_of_wheels {
            return;
        }
        let called = |letter: &Letter, quantity| self.votes_for(letter, quantity) > 0;
        let of_wheel = |(whole, wheel): &(Letter, LabelledWheel)| {
            let letter = &wheel.letter;
            let of_wheels = called(letter, Quantity::RelativeMomentum);
            // What words give the wheels stands for their vector, or for the component along their axis.
            let by_words = of_wheels && wheel.label.is_empty();
            let momentum = of_wheels || called(letter, Quantity::Momentum);
            let of_all = letter == whole || called(whole, Quantity::Momentum);
            momentum && of_all && !by_words && self.usage.get(letter).vector == 0
        };
        let met = document
            .lines()
            .filter_map(|line| LabelledWheel::in_line(&line.sides));
        let met: BTreeSet<_> = met.filter(of_wheel).collect();
        let mut met = met.into_iter();
        let (Some((whole, mut wheel)), None) = (met.next(), met.next()) else {
            return;
        };
        let sentences = document.named_sentences().iter();
        let said = sentences.filter_map(|s| wheel_axis(&s.text)).next();
        wheel.axis = said.unwrap_or(wheel.axis);
        self.wheels_apart = true;
        self.wheel_axis = Some(wheel.axis);
        self.quantities.insert(whole, Quantity::Momentum);
        self.labelled_wheel = Some(wheel);
    }
}
