//! What is said to turn in a part of the document alone, where no other sentence turns it: it turns so everywhere.

use super::reader::formula;
use super::statement::{Declaration, Extent, Formula, Slot, Statement, Term};
use crate::notation::Macros;

/// "On lines 1 to 9 B turns relative to N about z by the angle `$\theta$`": so B turns, and an angle of its own is θ there.
pub(super) fn turn_in_parts(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let mut own_letters = vec![];
    for at in 0..declarations.len() {
        let declaration = &declarations[at];
        let turned =
            turned(&declaration.statement).filter(|frame| is_turned_once(declarations, frame));
        let Some(frame) = turned.filter(|_| declaration.extent != Extent::Document) else {
            continue;
        };
        let own = |letter: &Formula| own_letter(declarations, at, letter, frame, macros);
        let letters: Vec<(Formula, Formula)> = angles(&declaration.statement)
            .filter_map(|letter| Some((letter.clone(), own(letter)?)))
            .collect();
        let extent = std::mem::replace(&mut declarations[at].extent, Extent::Document);
        for (letter, own) in letters {
            for term in declarations[at].statement.terms_mut() {
                put_in(term, &letter, &own);
            }
            own_letters.push(Declaration {
                statement: Statement::Same {
                    subjects: vec![Term::Formula(letter)],
                    others: vec![Term::Formula(own)],
                },
                extent: extent.clone(),
                ..declarations[at].clone()
            });
        }
    }
    declarations.extend(own_letters);
}

/// Writes another letter for one, also in what hangs on a noun.
fn put_in(term: &mut Term, letter: &Formula, other: &Formula) {
    match term {
        Term::Formula(formula) if formula.source == letter.source => *formula = other.clone(),
        Term::Phrase(phrase) => {
            let hanging = phrase.slots.iter_mut();
            hanging.for_each(|(_, term)| put_in(term, letter, other));
        }
        _ => {}
    }
}

/// The frame or body that a sentence says to turn.
fn turned(statement: &Statement) -> Option<&Term> {
    let turns = statement.does("turn").map(|(subjects, _)| subjects);
    match (turns, statement) {
        (Some([frame]), _) => Some(frame),
        (None, Statement::Is { subjects, what }) if what.slot(Slot::About).is_some() => subjects
            .first()
            .filter(|_| what.head == "frame" && subjects.len() == 1),
        _ => None,
    }
}

fn is_turned_once(declarations: &[Declaration], frame: &Term) -> bool {
    let turns = declarations.iter().filter_map(|d| turned(&d.statement));
    turns.filter(|other| *other == frame).count() == 1
}

/// The letters of angles and rates by which something turns.
fn angles(statement: &Statement) -> impl Iterator<Item = &Formula> {
    let slots = statement.slots().flatten();
    let told = slots.filter(|(slot, _)| matches!(slot, Slot::By | Slot::At));
    told.flat_map(|(_, term)| match term {
        Term::Formula(letter) => vec![letter],
        Term::Phrase(angle) => {
            let slots = angle.slots.iter();
            let letters = slots.filter_map(|(_, term)| match term {
                Term::Formula(letter) => Some(letter),
                _ => None,
            });
            letters.collect()
        }
        _ => vec![],
    })
}

/// A letter for an angle whose own one is spoken of in other parts as well.
fn own_letter(
    declarations: &[Declaration],
    at: usize,
    letter: &Formula,
    frame: &Term,
    macros: &Macros,
) -> Option<Formula> {
    let elsewhere = |d: &Declaration| {
        let mut spoken = d.statement.formulas().into_iter();
        d.extent != declarations[at].extent && spoken.any(|f| f.source == letter.source)
    };
    let label = match frame {
        Term::Name(name) => name,
        Term::Formula(name) => &name.source,
        _ => return None,
    };
    let source = format!("{}_{{\\text{{{label}}}}}", letter.source);
    let plain = declarations.iter().any(elsewhere) && !letter.source.contains('_');
    plain.then(|| formula(&source, false, macros)).flatten()
}
