//! Sentences with a word that the model has nothing for, and that turns what they say into something else: they tell nothing.

use crate::verify::language::heads::PLAIN_ADVERBS;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Verbs of motions, whose adverbs say how.
const MOTIONS: [&str; 4] = ["turn", "roll", "swing", "precess"];

/// The sentence, or one that was not understood in its place.
pub(super) fn heard_or_unread(declaration: Declaration) -> Declaration {
    match is_misheard(&declaration.statement) {
        true => Declaration::unread(declaration.text),
        false => declaration,
    }
}

fn is_misheard(statement: &Statement) -> bool {
    let slots = match statement {
        Statement::Does { verb, slots, .. } => {
            let strange = |(slot, how): &(Slot, Term)| *slot == Slot::With && !is_plain(how);
            if MOTIONS.contains(verb) && slots.iter().any(strange) {
                return true;
            }
            slots
        }
        Statement::Is { what, .. } | Statement::Premise(what) => &what.slots,
        _ => return false,
    };
    slots.iter().any(|(_, term)| is_reversed(term))
}

/// "clockwise", "without friction" change what a motion is; "without slipping" and "freely" are what the model knows.
fn is_plain(how: &Term) -> bool {
    matches!(how, Term::Phrase(how) if PLAIN_ADVERBS.contains(&how.head))
}

/// "the negative z axis"
fn is_reversed(term: &Term) -> bool {
    let of = |phrase: &NounPhrase| {
        phrase.is("negative") || phrase.slots.iter().any(|(_, term)| is_reversed(term))
    };
    matches!(term, Term::Phrase(phrase) if of(phrase))
}
