//! Letters that are told apart by their type alone: "a letter of a vector without bold type is its magnitude."

use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::PLAIN_LETTER;
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NotationMeaning, Sign, Statement,
};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::node_of;
use crate::verify::term::letters::{Meaning, spelled};
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// Each letter of a vector that the document writes plain as well, and of which no sentence tells as such, is the
    /// magnitude of that vector.
    pub(super) fn name_magnitudes_by_type(&mut self) {
        let declarations = self.declarations;
        let mut rules = declarations.iter().filter(|d| is_rule_of_type(d));
        if !rules.any(|rule| rule.extent == Extent::Document) {
            return;
        }
        for declaration in declarations {
            let Statement::Is { subjects, .. } = &declaration.statement else {
                continue;
            };
            for vector in formulas(subjects) {
                let Some(plain) = plain_letter(vector) else {
                    continue;
                };
                let Some(node) = node_of(&plain) else {
                    continue;
                };
                let written = self.reading.letters.written.has(&spelled(node));
                if !written || is_spoken_of(&plain, declarations) {
                    continue;
                }
                let of = self.quantity_of(vector, declaration);
                let of = of.filter(|of| self.vector_of(of).is_some());
                if let Some(of) = of {
                    let magnitude = Meaning::Quantity(Quantity::Magnitude(of.boxed()));
                    self.denote(&plain, magnitude, declaration);
                }
            }
        }
    }
}

/// Whether a sentence is the rule for plain letters.
fn is_rule_of_type(declaration: &Declaration) -> bool {
    matches!(
        &declaration.statement,
        Statement::Notation {
            sign: Sign::Custom(PLAIN_LETTER),
            meaning: NotationMeaning::Noun(noun),
        } if noun.head == "magnitude"
    )
}

/// The letter of a vector without its mark.
fn plain_letter(vector: &Formula) -> Option<Formula> {
    let mut node = node_of(vector)?.clone();
    let Kind::Symbol(symbol) = &mut node.kind else {
        return None;
    };
    if !symbol.style.vector || symbol.style.hat || symbol.style.tensor {
        return None;
    }
    symbol.style.vector = false;
    Some(Formula::of(&node))
}

/// Whether a sentence speaks of a letter as it is written.
fn is_spoken_of(letter: &Formula, declarations: &[Declaration]) -> bool {
    fn holds(node: &Node, letter: &str) -> bool {
        spelled(node) == letter || node.children().any(|child| holds(child, letter))
    }
    let Some(letter) = node_of(letter).map(spelled) else {
        return true;
    };
    declarations.iter().any(|d| {
        let formulas = d.statement.formulas();
        let mut nodes = formulas.iter().filter_map(|formula| node_of(formula));
        nodes.any(|node| holds(node, &letter))
    })
}
