//! What is said of letters that mean something else in each of several parts of the document: it is said in each part.

use super::extent::common;
use super::statement::{Declaration, Extent, Statement, Term};
use std::collections::HashMap;

/// "On lines 1 to 9 `$J$` is …, from line 10 on `$J$` is …; `$a$` is an entry of `$J$`": a is one of each there.
pub(crate) fn say_in_parts(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let parts = parts_of_letters(&declarations);
    if parts.is_empty() {
        return declarations;
    }
    let said = declarations.into_iter();
    let said = said.flat_map(|declaration| match parts_of(&declaration, &parts) {
        Some(parts) => {
            let in_part = |part: &Extent| {
                Some(Declaration {
                    extent: common(&declaration.extent, part)?,
                    ..declaration.clone()
                })
            };
            parts.iter().filter_map(in_part).collect()
        }
        None => vec![declaration],
    });
    said.collect()
}

/// The parts of the document in which letters have their meanings, of those that have several and none everywhere.
fn parts_of_letters(declarations: &[Declaration]) -> HashMap<String, Vec<Extent>> {
    let mut parts: HashMap<String, Vec<Extent>> = HashMap::new();
    for declaration in declarations {
        let Statement::Is { subjects, .. } = &declaration.statement else {
            continue;
        };
        for subject in subjects {
            let Term::Formula(letter) = subject else {
                continue;
            };
            let own = parts.entry(letter.source.clone()).or_default();
            if !own.contains(&declaration.extent) {
                own.push(declaration.extent.clone());
            }
        }
    }
    parts.retain(|_, own| own.len() > 1 && !own.contains(&Extent::Document));
    parts
}

/// The parts of the first letter of which a sentence speaks and that has any; none where the sentence speaks of one of them.
fn parts_of<'p>(
    declaration: &Declaration,
    parts: &'p HashMap<String, Vec<Extent>>,
) -> Option<&'p Vec<Extent>> {
    let Statement::Is { subjects, .. } = &declaration.statement else {
        return None;
    };
    let terms = declaration.statement.terms().into_iter();
    let mut mentioned = terms.filter_map(|term| match term {
        Term::Formula(letter) if !subjects.contains(term) => Some(letter),
        _ => None,
    });
    let parts = mentioned.find_map(|letter| parts.get(&letter.source));
    parts.filter(|parts| !parts.contains(&declaration.extent))
}
