//! What is small, and to which order lines hold in it.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Kind;
use crate::verify::facts::small::Small;
use crate::verify::language::heads::{DISTURBANCE, IDENTITY_MATRIX};
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{node_of, reach_of};
use crate::verify::reading::notation_read::is_one;
use crate::verify::term::labels::plain;
use crate::verify::term::letters::{Meaning, spell, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

/// The noun of terms that are too small to count.
pub(super) const REMAINDER: &str = "remainder";

impl Builder<'_> {
    /// Whether what is said is so of all, or needed by no line: that letters are small says nothing where it is said of lines to
    /// which order they hold.
    pub(super) fn says_nothing_new(&self, subjects: &[Term], what: &NounPhrase) -> bool {
        let time = |term: &Term| matches!(term, Term::Phrase(time) if time.head == "time");
        match what.head {
            DISTURBANCE => what.slots.is_empty(),
            "function" => what.slots.iter().all(|(_, of)| time(of)),
            "right-handed" => true,
            IDENTITY_MATRIX => subjects.iter().all(is_one),
            "transpose" => formulas(subjects).all(|f| is_written_transpose(f, what)),
            // A sign that is left open is one of the two.
            "sign" => formulas(subjects).all(|f| matches!(f.source.trim(), "\\pm" | "\\mp")),
            "small" => subjects.iter().all(|s| self.is_of_told_order(s)),
            _ => false,
        }
    }

    /// Whether a sentence says to which order in a letter lines hold.
    pub(super) fn is_of_told_order(&self, letter: &Term) -> bool {
        self.letters_of_orders().any(|term| term == letter)
    }

    /// In which letters sentences say to which order lines hold.
    pub(super) fn letters_of_orders(&self) -> impl Iterator<Item = &Term> {
        let slots = self.declarations.iter().flat_map(|d| match &d.statement {
            Statement::LineHolds { slots, .. } => slots.as_slice(),
            _ => &[],
        });
        let order = |(slot, _): &&(Slot, Term)| matches!(slot, Slot::In | Slot::InSecondOrder);
        slots.filter(order).map(|(_, term)| term)
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
        let variables = self.small_letters(&letters, &there);
        if variables.is_none() {
            self.say_unused(declaration);
        }
        let small = Small::new(variables.unwrap_or_default(), order);
        let reach = reach_of(&there.extent);
        self.reading.sizes.small.push((reach, small));
        true
    }

    /// The variables of letters that are small; `None` where one of them is none.
    fn small_letters(
        &mut self,
        letters: &[Term],
        declaration: &Declaration,
    ) -> Option<Vec<Variable>> {
        let mut variables = vec![];
        for formula in formulas(letters) {
            let entries = self.formula_value(formula, declaration)?.entries;
            let entries = entries.iter().filter(|entry| !entry.is_zero());
            let own: Vec<Variable> = entries.map(Fraction::as_variable).collect::<Option<_>>()?;
            variables.extend(own);
        }
        for letter in &variables {
            self.system().atoms.set_small(*letter);
        }
        (!variables.is_empty()).then_some(variables)
    }

    /// "`$O(p^2)$` is a remainder of second order in `$p$`": it is left away, and where it stands the first order is meant.
    pub(super) fn read_remainder(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let letters: Vec<Term> = what.all(Slot::Of).cloned().collect();
        let small = Small::new(self.small_letters(&letters, declaration)?, 1);
        for formula in formulas(subjects) {
            let nothing = Quantity::Known(Value::scalar(Zero::zero()));
            self.denote(formula, Meaning::Quantity(nothing), declaration);
            let remainder = (
                reach_of(&declaration.extent),
                spelled(node_of(formula)?),
                small.clone(),
            );
            self.reading.sizes.remainders.push(remainder);
        }
        Some(())
    }
}

/// "`$A^T$` is the transpose of `$A$`".
fn is_written_transpose(formula: &Formula, what: &NounPhrase) -> bool {
    let (Some(written), Some(Term::Formula(of))) = (node_of(formula), what.slot(Slot::Of)) else {
        return false;
    };
    let Some(of) = node_of(of) else {
        return false;
    };
    match &written.kind {
        Kind::Transpose(inner) => spelled(inner) == spelled(of),
        Kind::Symbol(symbol) => {
            let mut own = symbol.clone();
            let raised = own.superscripts.pop();
            let mark = raised.is_some_and(|label| ["T", "top"].contains(&plain(&label).as_str()));
            mark && spell(&own, true) == spelled(of)
        }
        _ => false,
    }
}
