//! What is said to be zero.

use crate::verify::language::heads::WEIGHT;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::components_read::each_component;
use crate::verify::reading::names::is_of_products;
use crate::verify::term::value::Value;

/// The adjective of what vanishes.
pub(super) const ZERO: &str = "zero";

impl Builder<'_> {
    /// "`$a$` and `$b$` are zero."
    pub(super) fn read_zeros(
        &mut self,
        subjects: &[Term],
        declaration: &Declaration,
    ) -> Option<()> {
        for subject in subjects {
            match subject {
                Term::Formula(formula) => {
                    if let Some(value) = self.formula_value(&formula.clone(), declaration) {
                        self.hold_zeros(value, declaration);
                    }
                }
                Term::Phrase(phrase) => self.zero_quantity(phrase, declaration)?,
                _ => return None,
            }
        }
        Some(())
    }

    /// What is said to be zero is what the noun names without that word. A weight that is left out makes neither the mass nor
    /// the gravity zero: where sentences speak of gravity, what is left out of them is not worked with.
    pub(super) fn zero_premise(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        if premise.head == WEIGHT {
            return self.gravity.is_none().then_some(());
        }
        let mut named = premise.clone();
        named.adjectives.retain(|adjective| *adjective != ZERO);
        self.zero_quantity(&named, declaration)
    }

    /// "The total force on B is zero": at all times.
    fn zero_quantity(&mut self, phrase: &NounPhrase, declaration: &Declaration) -> Option<()> {
        if phrase.slot(Slot::At).is_some() {
            return None;
        }
        // Weights bring no momentum in a blow.
        let of_weight = phrase.slot(Slot::Of).is_some_and(|of| of.is_noun(WEIGHT));
        if phrase.head == "impulse" && of_weight && self.reading.instants.blow {
            return Some(());
        }
        if is_of_products(phrase) {
            return self.zero_products(phrase, declaration);
        }
        if let Some(each) = each_component(phrase) {
            let mut each = each.iter();
            return each.try_for_each(|one| self.zero_quantity(one, declaration));
        }
        let quantity = self.quantity(phrase, declaration)?;
        let value = self.system().value_of(&quantity).ok()?;
        self.hold_zeros(value, declaration);
        Some(())
    }

    fn hold_zeros(&mut self, value: Value, declaration: &Declaration) {
        for entry in value.entries {
            self.hold(entry, declaration);
        }
    }
}
