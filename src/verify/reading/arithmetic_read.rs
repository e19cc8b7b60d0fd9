//! Letters that are products and quotients of others and of quantities.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::model::atoms::whole;
use crate::verify::reading::builder::Builder;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

impl Builder<'_> {
    /// "`$h$` is the product of `$J$` and `$\Omega$`", "`$k$` is the quotient of `$M$` and the mass of B".
    pub(super) fn read_product(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        let (mut product, mut array) = (whole(1), None);
        for (place, (slot, term)) in what.slots.iter().enumerate() {
            let factor = match (slot, term) {
                (Slot::Of, Term::Formula(factor)) if self.is_told(factor, declaration) => {
                    self.formula_value(factor, declaration)?
                }
                (Slot::Of, Term::Phrase(_)) => {
                    let factor = self.operand(term, declaration)?;
                    self.system().value_of(&factor).ok()?
                }
                _ => return None,
            };
            let Ok(factor) = factor.to_scalar() else {
                let divides = what.head == "quotient" && place > 0;
                (!divides && array.is_none()).then_some(())?;
                array = Some(factor);
                continue;
            };
            match (what.head, place) {
                ("quotient", 1) if !factor.is_zero() => product /= factor,
                ("quotient", 1..) => return None,
                _ => product *= factor,
            }
        }
        let product = match array {
            Some(array) => array.scaled(&product),
            None => Value::scalar(product),
        };
        let product = Quantity::Known(product);
        self.denote(letter, Meaning::Quantity(product), declaration);
        Some(())
    }
}
