//! What is said of letters that mean something else in each of several parts of the document: it is said in each part.

use super::statement::{Declaration, Extent, Formula, Statement, Term};

/// "On lines 1 to 9 `$J$` is …, from line 10 on `$J$` is …; `$a$` is an entry of `$J$`": a is one of each there.
pub(crate) fn say_in_parts(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut said = vec![];
    for declaration in &declarations {
        match parts_of(declaration, &declarations) {
            Some(parts) => said.extend(parts.into_iter().map(|extent| Declaration {
                extent,
                ..declaration.clone()
            })),
            None => said.push(declaration.clone()),
        }
    }
    said
}

/// The parts in which a letter that a sentence speaks of has its meanings, where it has several and none everywhere.
fn parts_of(declaration: &Declaration, all: &[Declaration]) -> Option<Vec<Extent>> {
    let Statement::Is { subjects, .. } = &declaration.statement else {
        return None;
    };
    if declaration.extent != Extent::Document {
        return None;
    }
    let terms = declaration.statement.terms().into_iter();
    let mut mentioned = terms.filter_map(|term| match term {
        Term::Formula(letter) => Some(letter).filter(|_| !subjects.contains(term)),
        _ => None,
    });
    mentioned.find_map(|letter| parts_of_letter(letter, all))
}

fn parts_of_letter(letter: &Formula, all: &[Declaration]) -> Option<Vec<Extent>> {
    let mut parts: Vec<Extent> = vec![];
    for declaration in all {
        let Statement::Is { subjects, .. } = &declaration.statement else {
            continue;
        };
        let own = |s: &Term| matches!(s, Term::Formula(told) if told.source == letter.source);
        match &declaration.extent {
            _ if !subjects.iter().any(own) => {}
            Extent::Document => return None,
            extent if parts.contains(extent) => {}
            extent => parts.push(extent.clone()),
        }
    }
    (parts.len() > 1).then_some(parts)
}
