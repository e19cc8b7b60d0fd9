//! Sentences from which no fact follows: what is denied, and what is left to a line to tell.

use crate::verify::language::statement::{Declaration, Formula, Slot, Statement};
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::node_of;
use crate::verify::term::letters::spelled;
use crate::verify::term::written::{WrittenSymbols, defined};

/// Whether a sentence says that something is not so; what is not zero or not negative is a fact.
pub(super) fn denies(declaration: &Declaration) -> bool {
    match &declaration.statement {
        Statement::Is { what, .. } | Statement::Premise(what) => {
            what.is("not") && !matches!(what.head, "zero" | "negative")
        }
        _ => false,
    }
}

/// "`$e$` is a vector in components on B", where a line says by `:=` which one: the sentence tells no more than that.
pub(super) fn is_left_to_line(said: &Declaration, written: &WrittenSymbols) -> bool {
    let Statement::Is { subjects, what } = &said.statement else {
        return false;
    };
    let on = |slot: &Slot| *slot == Slot::On;
    let plain = what.head == "vector"
        && what.adjectives.is_empty()
        && what.slots.iter().all(|(slot, _)| on(slot));
    let by_line = |letter: &Formula| match node_of(letter) {
        Some(node) => written.has(&defined(&spelled(node))),
        None => false,
    };
    let letters = formulas(subjects).count();
    plain && letters > 0 && letters == subjects.len() && formulas(subjects).all(by_line)
}
