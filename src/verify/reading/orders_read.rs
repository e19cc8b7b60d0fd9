//! What is small, and to which order lines hold in it.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::small::Small;
use crate::verify::language::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::reach_of;
use crate::verify::reading::references_read::DISTURBANCE;
use num_traits::Zero;

impl Builder<'_> {
    /// Whether what is said is so of all, or needed by no line: that letters are small says nothing where it is said of lines to
    /// which order they hold.
    pub(super) fn says_nothing_new(&self, subjects: &[Term], what: &NounPhrase) -> bool {
        let time = |term: &Term| matches!(term, Term::Phrase(time) if time.head == "time");
        match what.head {
            DISTURBANCE => what.slots.is_empty(),
            "function" => what.slots.iter().all(|(_, of)| time(of)),
            "right-handed" => true,
            "small" => subjects.iter().all(|s| self.is_of_told_order(s)),
            _ => false,
        }
    }

    /// Whether a sentence says to which order in a letter lines hold.
    pub(super) fn is_of_told_order(&self, letter: &Term) -> bool {
        let order = |slot: &Slot| matches!(slot, Slot::In | Slot::InSecondOrder);
        self.declarations.iter().any(|d| match &d.statement {
            Statement::LineHolds { slots, .. } => {
                let mut letters = slots.iter().filter(|(slot, _)| order(slot));
                letters.any(|(_, term)| term == letter)
            }
            _ => false,
        })
    }

    /// "Line 15 holds to first order in `$p$`": says whether it is a sentence of this form.
    pub(super) fn read_order_of_lines(
        &mut self,
        lines: &Extent,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> bool {
        let order = |slot: &Slot| match slot {
            Slot::In => Some(1),
            Slot::InSecondOrder => Some(2),
            _ => None,
        };
        let small = slots.iter();
        let small = small.filter_map(|(slot, term)| Some((order(slot)?, term)));
        let (orders, letters): (Vec<u32>, Vec<Term>) = small.map(|(o, t)| (o, t.clone())).unzip();
        let Some(order) = orders.into_iter().max() else {
            return false;
        };
        // The letters mean what they mean on these lines.
        let there = match lines {
            Extent::Document => declaration.clone(),
            lines => Declaration {
                extent: lines.clone(),
                ..declaration.clone()
            },
        };
        let mut variables = vec![];
        for formula in formulas(&letters) {
            let value = self.formula_value(formula, &there);
            let entries = value.map_or_else(Vec::new, |value| value.entries);
            let own: Option<Vec<Variable>> = entries
                .iter()
                .filter(|entry| !entry.is_zero())
                .map(Fraction::as_variable)
                .collect();
            match own.filter(|own| !own.is_empty()) {
                Some(own) => variables.extend(own),
                None => self.say_unused(declaration),
            }
        }
        if variables.is_empty() {
            self.say_unused(declaration);
        }
        let reach = reach_of(&there.extent);
        for letter in &variables {
            self.system().atoms.set_small(*letter);
        }
        let small = Small::new(variables, order);
        self.reading.sizes.small.push((reach, small));
        true
    }
}
