//! Frames and points that no sentence introduces: a letter that is told "for any frames X and Y" names them by its labels.

use crate::verify::language::statement::{Declaration, NounPhrase, Statement, Term};
use crate::verify::reading::any_read::{any_things, stands_for_point};
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
        let any = any_things(&declaration.statement).unwrap_or_default();
        let letters = any.iter().flat_map(|name| name.chars());
        let wild: Vec<char> = letters.filter(|c| c.is_uppercase()).collect();
        if wild.is_empty() {
            continue;
        }
        let subjects = formulas(declaration.statement.subjects());
        for template in subjects.filter_map(node_of).map(spelled) {
            for (place, name) in written.like(&template, &wild) {
                if known.insert(name.to_string()) {
                    let of_point = stands_for_point(&declaration.statement, &place.to_string());
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
