//! Lines that sentences call given: what they set a letter to is known as if a sentence said it.

use crate::notation::document::{Document, Item, Row};
use crate::verify::language::statement::{Declaration, DeclaredRole, Extent, Formula, Statement};
use crate::verify::reading::definitions_read::{definition_in, is_written_as};
use crate::verify::reading::names::reach_of;
use crate::verify::term::letters::At;

/// The declarations, and the formulas of the lines that are given and set a letter of which no sentence tells.
pub(crate) fn with_given_lines(
    document: &Document,
    declarations: Vec<Declaration>,
) -> Vec<Declaration> {
    let given = declarations.iter().filter(|d| d.extent == Extent::Document);
    let set: Vec<Declaration> = given
        .filter_map(|d| match &d.statement {
            Statement::Role {
                lines,
                role: DeclaredRole::Given,
            } => Some((d, lines)),
            _ => None,
        })
        .flat_map(|(d, lines)| {
            let own = formulas_on(document, lines).into_iter();
            own.map(|formula| d.saying(Statement::Holds(formula)))
        })
        .filter(|d| is_new(&d.statement, &declarations))
        .collect();
    [declarations, set].concat()
}

/// The formulas of the lines of a document in a part of it.
fn formulas_on(document: &Document, lines: &Extent) -> Vec<Formula> {
    let reach = reach_of(lines);
    let mut found = vec![];
    for item in &document.items {
        let Item::Formula(formula) = item else {
            continue;
        };
        for row in &formula.rows {
            let Row::Line(line) = row else { continue };
            let place = document.place(line.span.start);
            let at = At {
                cell: place.cell,
                line: place.line,
                ..At::default()
            };
            if reach.covers(&at, 0) {
                found.push(Formula {
                    source: document.source.slice(line.span).to_owned(),
                    row: row.clone(),
                });
            }
        }
    }
    found
}

/// Whether a formula sets a letter that is the subject of no sentence but one that says it to be constant.
fn is_new(statement: &Statement, declarations: &[Declaration]) -> bool {
    let Statement::Holds(formula) = statement else {
        return false;
    };
    let Some((left, _)) = definition_in(formula) else {
        return false;
    };
    let letter = Formula::of(left);
    let tells = |d: &Declaration| match &d.statement {
        Statement::Is { what, .. } if what.head == "constant" => false,
        Statement::Role { .. } => false,
        said => said
            .subjects()
            .iter()
            .any(|term| is_written_as(term, &letter)),
    };
    !declarations.iter().any(tells)
}
