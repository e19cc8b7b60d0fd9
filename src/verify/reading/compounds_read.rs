//! Formulas of several letters that sentences say to be quantities: "`$2m$` is the mass of the hub".

use crate::notation::ast::{Factor, Kind, Node};
use crate::verify::language::statement::{Declaration, Formula, Term};
use crate::verify::reading::builder::{Builder, place_in};
use crate::verify::reading::names::{name_of, name_of_formula, node_of, reach_of};
use crate::verify::term::letters::{Meaning, loosely, spelled};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

impl Builder<'_> {
    /// Whether a formula is worked out from what its letters are, and names nothing.
    pub(super) fn is_worked_out(&self, formula: &Formula, declaration: &Declaration) -> bool {
        let Some(node) = node_of(formula) else {
            return false;
        };
        let worked = |f: &Factor| matches!(f.node.kind, Kind::Number(_) | Kind::Function(..));
        match &node.kind {
            // "`$-X$` is the velocity of P": so X is told.
            Kind::Negate(inner) if matches!(inner.kind, Kind::Symbol(_)) => {
                self.quantity_of(&Formula::of(inner), declaration).is_some()
            }
            Kind::Number(_)
            | Kind::Negate(_)
            | Kind::Sum(_)
            | Kind::Quotient(..)
            | Kind::Function(..) => true,
            Kind::Product(factors) if factors.iter().any(worked) => true,
            // "`$s z$`": so much along an axis.
            Kind::Product(factors) if factors.last().is_some_and(|f| self.is_axis(&f.node)) => true,
            _ => !self.names_of_axes(node, declaration).is_empty(),
        }
    }

    fn is_axis(&self, node: &Node) -> bool {
        let name = name_of_formula(&Formula::of(node));
        self.axes.get(&name).is_some()
    }

    /// What a formula is said to be: the meaning of a letter, or a premise of what is worked out.
    pub(super) fn tell(
        &mut self,
        formula: &Formula,
        quantity: Quantity,
        declaration: &Declaration,
    ) {
        match self.is_worked_out(formula, declaration) {
            true => self.hold_formula_is(formula, &quantity, declaration),
            false => self.denote(formula, Meaning::Quantity(quantity), declaration),
        }
    }

    /// The value of a formula is that of a quantity.
    pub(super) fn hold_formula_is(
        &mut self,
        formula: &Formula,
        quantity: &Quantity,
        declaration: &Declaration,
    ) {
        // "`$x\hat x$`": a letter and its own unit vector are two.
        if let Some(node) = node_of(formula) {
            self.reading.letters.keep_apart(std::slice::from_ref(node));
        }
        let known = self.system().value_of(quantity).ok();
        let value = match quantity {
            Quantity::Position { .. } => self.place_value(formula, declaration),
            Quantity::Component { of, .. } if matches!(**of, Quantity::Position { .. }) => {
                self.place_value(formula, declaration)
            }
            _ => self.value_with_new_letters(formula, declaration),
        };
        match value.zip(known) {
            Some((value, known)) => self.hold_equal(&value, &known, declaration),
            None => self.say_unused(declaration),
        }
    }

    /// The value of a formula, whose letters of which nothing is said are new ones.
    fn value_with_new_letters(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Value> {
        for letter in symbols_in(&node_of(formula)?.clone()) {
            if self.is_untold_everywhere(&letter, declaration) {
                self.scalar(&letter, declaration);
            }
        }
        self.formula_value(formula, declaration)
    }

    /// Whether no sentence tells what a letter is.
    fn is_untold_everywhere(&mut self, letter: &Formula, declaration: &Declaration) -> bool {
        let named = name_of_formula(letter);
        let told = self.declarations.iter().any(|d| {
            let mut subjects = d.statement.subjects().iter().filter_map(name_of);
            subjects.any(|subject| subject == named)
        });
        !told && !self.is_told(letter, declaration)
    }

    /// The place that a formula tells: its letters of which nothing is said, and of which no rate is written, are constant.
    pub(super) fn place_value(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<Value> {
        self.reading
            .letters
            .keep_apart(std::slice::from_ref(node_of(formula)?));
        self.tell_letters_of_place(formula, declaration)?;
        self.formula_value(formula, declaration)
    }

    /// The letters of a place or a size of which nothing is said are numbers, and constant where no rate of them is written.
    pub(super) fn tell_letters_of_place(
        &mut self,
        formula: &Formula,
        declaration: &Declaration,
    ) -> Option<()> {
        let node = node_of(formula)?.clone();
        let axes = self.names_of_axes(&node, declaration);
        for letter in symbols_in(&node) {
            let names_axis = axes.iter().any(|(axis, _)| axis.source == letter.source);
            if names_axis || self.is_told_by_itself(&letter, declaration) {
                continue;
            }
            let size = self.scalar(&letter, declaration);
            if let Some(size) = size.filter(|_| !self.has_rate(&Term::Formula(letter))) {
                self.make_constant(&size);
            }
        }
        Some(())
    }

    /// Whether a letter is told, and not only another one that is written with a mark: x beside a unit vector x.
    fn is_told_by_itself(&mut self, letter: &Formula, declaration: &Declaration) -> bool {
        let at = place_in(&reach_of(&declaration.extent));
        let node = node_of(letter);
        let names = node.map(|node| (spelled(node), loosely(node)));
        let other = names.is_some_and(|(spelled, loose)| {
            let letters = &self.reading.letters;
            let found = letters.find(&spelled, &loose, &at, 1);
            found.is_some() && letters.find_lone(&spelled, &loose, &at, 1).is_none()
        });
        !other && self.is_told(letter, declaration)
    }
}

/// The letters of a formula, each as a formula.
pub(super) fn symbols_in(node: &Node) -> Vec<Formula> {
    match &node.kind {
        Kind::Symbol(_) => vec![Formula::of(node)],
        _ => node.children().flat_map(symbols_in).collect(),
    }
}
