//! The momentum of a wheel that has the letter of the whole and a label: `h_x = A p + h_r`, where no vector is written.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::letters::one_axis::wheel_axis;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::repair::lines;
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
        symbol.subscripts.as_slice() == [self.label.as_str()]
            && !symbol.style.vector
            && Letter::of(symbol) == self.letter
    }

    /// What a line adds to a component that has the same letter.
    fn in_line(sides: &[Node]) -> Option<Self> {
        let [left, right] = sides else { return None };
        let (Kind::Symbol(whole), Kind::Sum(terms)) = (&inner(left).kind, &inner(right).kind)
        else {
            return None;
        };
        let [component] = whole.subscripts.as_slice() else {
            return None;
        };
        let along = axis(component)?;
        let letter = Letter::of(whole);
        let mut added = terms
            .iter()
            .filter_map(|term| match &inner(&term.node).kind {
                Kind::Symbol(symbol) if Letter::of(symbol) == letter => Some(symbol),
                _ => None,
            });
        let (symbol, None) = (added.next()?, added.next()) else {
            return None;
        };
        match symbol.subscripts.as_slice() {
            [label] if axis(label).is_none() && !symbol.style.vector => Some(Self {
                letter: letter.clone(),
                label: label.clone(),
                axis: along,
            }),
            _ => None,
        }
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
        let met = lines(document).filter_map(|line| LabelledWheel::in_line(&line.sides));
        let met: BTreeSet<LabelledWheel> = met.collect();
        let mut met = met.into_iter();
        let (Some(mut wheel), None) = (met.next(), met.next()) else {
            return;
        };
        let called = |quantity| self.votes_for(&wheel.letter, quantity) > 0;
        let momentum = called(Quantity::RelativeMomentum) || called(Quantity::Momentum);
        if !momentum || self.usage.get(&wheel.letter).vector > 0 {
            return;
        }
        let sentences = document.named_sentences().iter();
        let said = sentences.filter_map(|s| wheel_axis(&s.text)).next();
        wheel.axis = said.unwrap_or(wheel.axis);
        self.wheels_apart = true;
        self.wheel_axis = Some(wheel.axis);
        self.quantities
            .insert(wheel.letter.clone(), Quantity::Momentum);
        self.labelled_wheel = Some(wheel);
    }
}
