//! Letters that a sentence tells and that were bound to nothing: none of the lines may say what they are.

use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::{INSTANT, JACOBIAN, NATURAL_BASE};
use crate::verify::language::only_names;
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement,
};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{PRODUCTS, node_of};
use crate::verify::reading::oscillations_read::{ANGULAR_FREQUENCY, FREQUENCY, PERIOD};
use crate::verify::reading::unused::array_said;
use crate::verify::term::letters::{loosely, spelled};

/// Nouns of letters that are found as the lines are read.
const READ_ELSEWHERE: [&str; 11] = [
    "component",
    "entry",
    "angle",
    "integral",
    "function",
    JACOBIAN,
    PERIOD,
    FREQUENCY,
    ANGULAR_FREQUENCY,
    NATURAL_BASE,
    INSTANT,
];

impl Builder<'_> {
    /// Says of each sentence that names a quantity by a letter, and that bound the letter to nothing, that nothing was made
    /// of it.
    pub(super) fn say_unbound(&mut self) {
        let unbound = |d: &&Declaration| match &d.statement {
            Statement::Is { subjects, what } if is_of_one_letter(what) => {
                let whole = d.extent == Extent::Document;
                whole && formulas(subjects).any(|letter| self.is_unbound(letter))
            }
            // Which product it is its labels say, of the tensor whose letter has them.
            Statement::Is { subjects, what } if what.head == PRODUCTS => {
                let labelled = |letter: &Formula| {
                    self.is_unbound(letter)
                        && without_label(letter).is_none_or(|l| self.is_unbound(&l))
                };
                formulas(subjects).any(labelled)
            }
            Statement::Is { subjects, .. } => {
                let mut arrays = subjects.iter().filter_map(array_said);
                arrays.any(|letter| self.is_unbound(letter))
            }
            _ => false,
        };
        let unbound: Vec<&Declaration> = self.declarations.iter().filter(unbound).collect();
        unbound.into_iter().for_each(|d| self.say_unused(d));
    }

    /// Whether a letter that is written as one means nothing.
    fn is_unbound(&self, letter: &Formula) -> bool {
        let plain = |node: &&Node| match &node.kind {
            Kind::Symbol(symbol) => symbol.superscripts.is_empty() && !symbol.name.contains('{'),
            _ => false,
        };
        let Some(node) = node_of(letter).filter(plain) else {
            return false;
        };
        let (exact, loose) = (spelled(node), loosely(node));
        let letters = &self.reading.letters.letters;
        let known = letters
            .iter()
            .any(|l| l.spelled == exact || l.loose == loose);
        !known
    }
}

/// A letter without its last label.
fn without_label(letter: &Formula) -> Option<Formula> {
    let node = node_of(letter)?;
    let Kind::Symbol(symbol) = &node.kind else {
        return None;
    };
    let mut symbol = symbol.clone();
    symbol.subscripts.pop()?;
    Some(Formula::of(&Node {
        kind: Kind::Symbol(symbol),
        span: node.span,
    }))
}

/// Whether a noun says what a letter is, and neither an index nor what the motion is worked out for.
fn is_of_one_letter(what: &NounPhrase) -> bool {
    let indexed = what.slot(Slot::Which).is_some() || what.slot(Slot::ForAny).is_some();
    only_names(what.head) && !indexed && !READ_ELSEWHERE.contains(&what.head)
}
