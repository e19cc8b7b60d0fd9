//! What the formulas of sentences are worth.

use crate::algebra::Fraction;
use crate::source::Source as Text;
use crate::verify::language::statement::{Declaration, Formula, Term};
use crate::verify::model::atoms::whole;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, node_of};
use crate::verify::term::known::Known;
use crate::verify::term::letters::{At, Meaning};
use crate::verify::term::lower::Lowering;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

impl Builder<'_> {
    /// The value of a formula in a sentence; letters that no sentence tells of are scalars of their own.
    pub(super) fn formula_value(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Value> {
        let value = self.mentioned_value(formula, declaration)?;
        self.reading.system.trust(&value);
        Some(value)
    }

    /// The value of a formula that a sentence only mentions: it tells nothing of new letters.
    pub(super) fn mentioned_value(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Value> {
        let at = self.place_of(formula, declaration);
        self.value_at(formula, &at, declaration)
    }

    /// The value of a formula that stands at a place.
    pub(super) fn value_at(
        &mut self,
        formula: &Formula,
        at: &At,
        declaration: &Declaration,
    ) -> Option<Value> {
        let node = node_of(formula)?.clone();
        let named = self.names_of_axes(&node, declaration);
        let text = Text::new("", formula.source.clone());
        let mut known = Known::default();
        let mut letters = self.reading.letters.clone();
        for (letter, (frame, axis)) in &named {
            let axis = self.reading.system.axis(*frame, *axis);
            let along = Quantity::Known(Value::vector(&axis, Basis::Itself));
            letters
                .letters
                .extend(self.letter(letter, Meaning::Quantity(along), declaration));
        }
        let mut lowering = Lowering::new(&mut self.reading.system, &letters, &text, at, &mut known);
        let value = lowering.value(&node).ok()?;
        // The letter of an axis that is told as a name may be its vector or a number: it is the one that makes a vector.
        if !named.is_empty() && value.to_vector().is_err() {
            self.say_unused(declaration);
            return None;
        }
        if value.entries.iter().all(Fraction::is_valid) {
            return Some(value);
        }
        self.say_beyond(declaration);
        None
    }

    pub(super) fn scalar(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        self.formula_value(formula, declaration)?.to_scalar().ok()
    }

    /// The number that a term says: a formula, or "the rate $\Omega$".
    pub(super) fn scalar_term(
        &mut self,
        term: &Term,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        match term {
            Term::Numbers(numbers) if numbers.len() == 1 => {
                i64::try_from(numbers[0]).ok().map(whole)
            }
            _ => self.scalar(letter_of(term)?, declaration),
        }
    }
}
