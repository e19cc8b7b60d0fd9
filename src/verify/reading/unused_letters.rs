//! The letters of sentences of which nothing was made.

use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::MASS;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::language::{is_bodily, only_names};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{node_of, nodes_of};
use crate::verify::reading::unused_read::is_load;
use crate::verify::term::letters::{labelled_letter, letter_names};
use std::collections::BTreeSet;

impl Builder<'_> {
    /// The letters of which a sentence that nothing was made of says no more than what they are.
    pub(super) fn letters_left(&self, declaration: &Declaration) -> Option<BTreeSet<String>> {
        let understood = !declaration.is_unread();
        let own = |node: &Node| match understood {
            true => letters_in_node(node),
            false => letter_names(node),
        };
        // A label with the name of a frame is no letter of the quantity that carries it.
        let frames = &self.reading.system.frames;
        let of_frame = |letter: &String| frames.iter().any(|frame| frame.name == *letter);
        letters_named_by(&declaration.statement).map(|nodes| {
            let all = nodes.into_iter().flat_map(own);
            all.filter(|letter| !of_frame(letter)).collect()
        })
    }
}

/// "`$\lambda$` is small."
pub(super) fn is_small(statement: &Statement) -> bool {
    matches!(statement, Statement::Is { what, .. } if what.head == "small" && what.slots.is_empty())
}

/// The letters of a sentence that says what quantities letters are, and no more.
pub(super) fn letters_named_by(statement: &Statement) -> Option<Vec<&Node>> {
    let formulas: Vec<&Formula> = match statement {
        // What bodies have says of several that they are alike, and a load acts whatever its letter is.
        Statement::Is { subjects, what }
            if only_names(what.head)
                && !is_bodily(what.head)
                && what.head != MASS
                && !acts_on_a_body(what)
                || is_small(statement) =>
        {
            subjects.iter().map(in_formula).collect::<Option<_>>()?
        }
        Statement::Unread { letters, .. } if !letters.is_empty() => letters.iter().collect(),
        _ => return None,
    };
    // What is made of several letters, or of none, is told a value by it: that is more than what a letter is.
    let named = |formula: &&Formula| {
        let plain = node_of(formula).is_none_or(|node| letters_in_node(node).len() == 1);
        plain || matches!(statement, Statement::Unread { .. })
    };
    match formulas.iter().all(named) {
        true => formulas.into_iter().map(node_of).collect(),
        false => None,
    }
}

/// Whether a noun is that of a load on a thing.
fn acts_on_a_body(what: &NounPhrase) -> bool {
    is_load(what)
        && [Slot::Of, Slot::Upon]
            .iter()
            .any(|slot| what.slot(*slot).is_some())
}

/// The letters of a formula, those with labels as they are written.
pub(super) fn letters_of(formula: &Formula) -> BTreeSet<String> {
    nodes_of(formula).iter().flat_map(letters_in_node).collect()
}

pub(super) fn letters_in_node(node: &Node) -> BTreeSet<String> {
    match labelled_letter(node) {
        Some(letter) => BTreeSet::from([letter]),
        None if matches!(node.kind, Kind::Symbol(_)) => letter_names(node),
        None => node.children().flat_map(letters_in_node).collect(),
    }
}

pub(super) fn in_formula(subject: &Term) -> Option<&Formula> {
    match subject {
        Term::Formula(formula) => Some(formula),
        _ => None,
    }
}
