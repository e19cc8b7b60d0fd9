//! Frames and points that no sentence introduces: a letter that is told "for any frames X and Y" names them by its labels.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::any_read::stands_for_point;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{name_of, node_of};
use crate::verify::term::letters::spelled;
use crate::verify::term::written::WrittenSymbols;
use std::collections::BTreeSet;

/// "A is a frame" for each A that stands, in a label of the document, where a sentence speaks of any frame.
pub(crate) fn named_by_labels(
    declarations: &[Declaration],
    written: &WrittenSymbols,
) -> Vec<Declaration> {
    let mut known = subjects(declarations);
    let mut made = vec![];
    for declaration in declarations {
        let Some((letters, any)) = any_things(&declaration.statement) else {
            continue;
        };
        let wild: Vec<char> = any.iter().filter_map(|name| name.chars().next()).collect();
        for template in letters {
            for (place, name) in written.like(&template, &wild) {
                let thing = wild.iter().position(|c| *c == place).map(|at| &any[at]);
                if known.insert(name.to_string()) {
                    let of_point =
                        thing.is_some_and(|thing| stands_for_point(&declaration.statement, thing));
                    made.push(introduction(name, of_point, declaration));
                }
            }
        }
    }
    made
}

/// The names of what sentences tell something of, as they stand in labels.
fn subjects(declarations: &[Declaration]) -> BTreeSet<String> {
    let subjects = declarations.iter().flat_map(|d| d.statement.subjects());
    let names = subjects.filter_map(name_of);
    names.map(|name| name.replace("~cal", "")).collect()
}

/// The letters that a sentence tells of, spelled, and the names of which it speaks as any.
fn any_things(statement: &Statement) -> Option<(Vec<String>, Vec<String>)> {
    let (subjects, slots) = match statement {
        Statement::Is { subjects, what } => (subjects, &what.slots),
        Statement::Does {
            subjects,
            verb: "take",
            slots,
        } => (subjects, slots),
        _ => return None,
    };
    let any = slots.iter().filter_map(|(slot, term)| match (slot, term) {
        (Slot::ForAny, Term::Name(name)) if is_short(name) => Some(name.clone()),
        _ => None,
    });
    let any: Vec<String> = any.collect();
    let letters = formulas(subjects).filter_map(node_of).map(spelled);
    (!any.is_empty()).then(|| (letters.collect(), any))
}

fn is_short(name: &str) -> bool {
    let mut letters = name.chars();
    letters.next().is_some_and(char::is_uppercase) && letters.next().is_none()
}

fn introduction(name: char, of_point: bool, cause: &Declaration) -> Declaration {
    let head = if of_point { "point" } else { "frame" };
    Declaration {
        statement: Statement::Is {
            subjects: vec![Term::Name(name.to_string())],
            what: NounPhrase::new(head, vec![]),
        },
        ..cause.clone()
    }
}
