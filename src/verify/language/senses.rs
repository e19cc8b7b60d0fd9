//! The sense in which something along an axis is counted: "along z, positive towards `-z`" is along `-z`.

use super::heads::{OPPOSITE_TO, POSITIVE_ABOUT, POSITIVE_TOWARDS};
use super::kinds::name;
use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;

/// Ways to say in which direction something is positive.
const SENSES: [&str; 3] = [POSITIVE_TOWARDS, POSITIVE_ABOUT, OPPOSITE_TO];

/// Turns the axis of what is counted the other way along it; a sense along another direction stays as it is said.
pub(super) fn tell_senses(declarations: &mut [Declaration], macros: &Macros) {
    for declaration in declarations {
        // An angle is counted from one line to another.
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head != "angle"
        {
            tell_sense(what, macros);
        }
    }
}

fn tell_sense(what: &mut NounPhrase, macros: &Macros) -> Option<()> {
    let (sense, towards) = sense_in(what)?;
    let (wanted, negative) = direction(&towards)?;
    let axis = axis_in(what)?;
    let (own, reversed) = direction(axis)?;
    if own != wanted {
        return None;
    }
    if (sense == OPPOSITE_TO) == (negative == reversed) {
        let other = match reversed {
            true => own,
            false => format!("-{own}"),
        };
        *axis = Term::Formula(formula(&other, false, macros)?);
    }
    leave_sense(what);
    Some(())
}

/// The sense that is said anywhere in a phrase, and the direction of it.
fn sense_in(what: &NounPhrase) -> Option<(&'static str, Term)> {
    what.slots.iter().find_map(|(_, term)| match term {
        Term::Phrase(sense) if SENSES.contains(&sense.head) => {
            Some((sense.head, sense.slot(Slot::Of)?.clone()))
        }
        Term::Phrase(inner) => sense_in(inner),
        _ => None,
    })
}

fn leave_sense(what: &mut NounPhrase) {
    let sense = |term: &Term| matches!(term, Term::Phrase(s) if SENSES.contains(&s.head));
    what.slots.retain(|(_, term)| !sense(term));
    for (_, term) in &mut what.slots {
        if let Term::Phrase(inner) = term {
            leave_sense(inner);
        }
    }
}

/// The axis along which, or about which, what a phrase names is counted.
fn axis_in(what: &mut NounPhrase) -> Option<&mut Term> {
    let said = |wanted: Slot| {
        let one = |(slot, term): &(Slot, Term)| *slot == wanted && direction(term).is_some();
        what.slots.iter().position(one)
    };
    if let Some(at) = said(Slot::Along).or_else(|| said(Slot::About)) {
        return Some(&mut what.slots[at].1);
    }
    let inner = what.slots.iter_mut().filter(|(slot, _)| *slot == Slot::Of);
    inner
        .filter_map(|(_, term)| match term {
            Term::Phrase(inner) => axis_in(inner),
            _ => None,
        })
        .next()
}

/// A direction by the letter or the name of an axis, and whether it goes against that.
fn direction(term: &Term) -> Option<(String, bool)> {
    let own = match term {
        Term::Formula(letter) => letter.source.trim().to_owned(),
        term => name(term)?,
    };
    Some(match own.strip_prefix('-') {
        Some(letter) => (letter.trim().to_owned(), true),
        None => (own, false),
    })
}
