//! Lines that sentences call given: what they set a letter to is known as if a sentence said it.

use crate::notation::document::{Document, Row};
use crate::verify::language::statement::{Declaration, DeclaredRole, Extent, Formula, Statement};
use crate::verify::reading::definitions_read::{definition_in, is_subject};
use crate::verify::reading::names::reach_of;
use crate::verify::term::letters::{At, Reach};

/// The declarations, and the formulas of the lines that are given and set a letter of which no sentence tells.
pub(crate) fn with_given_lines(
    document: &Document,
    mut declarations: Vec<Declaration>,
) -> Vec<Declaration> {
    let given: Vec<(&Declaration, Reach)> = declarations.iter().filter_map(given).collect();
    if given.is_empty() {
        return declarations;
    }
    let held: Vec<Reach> = declarations.iter().filter_map(held_in_part).collect();
    let mut set = vec![];
    for row in document.rows() {
        let Row::Line(line) = row else { continue };
        let place = document.place_of_row(line.span.start);
        let at = At {
            cell: place.cell,
            line: place.line,
            ..At::default()
        };
        let formula = Formula {
            source: document.source.slice(line.span).to_owned(),
            row: row.clone(),
        };
        // What holds at a time or in a case alone is not known elsewhere.
        if held.iter().any(|reach| reach.covers(&at, 0)) {
            continue;
        }
        if let Some((role, _)) = given.iter().find(|(_, reach)| reach.covers(&at, 0))
            && let Some((letter, _)) = definition_in(&formula)
            && !is_subject(&declarations, &Formula::of(letter))
        {
            set.push(role.saying(Statement::Holds(formula)));
        }
    }
    declarations.extend(set);
    declarations
}

/// The lines that a sentence calls given.
fn given(declaration: &Declaration) -> Option<(&Declaration, Reach)> {
    match &declaration.statement {
        Statement::Role {
            lines,
            role: DeclaredRole::Given,
        } if declaration.extent == Extent::Document => Some((declaration, reach_of(lines))),
        _ => None,
    }
}

/// The lines of which a sentence says when, in what case or how nearly they hold.
fn held_in_part(declaration: &Declaration) -> Option<Reach> {
    match &declaration.statement {
        Statement::LineHolds { lines, slots } if !slots.is_empty() => Some(match lines {
            Extent::Document => reach_of(&declaration.extent),
            lines => reach_of(lines),
        }),
        _ => None,
    }
}
