//! Rods that are called by their ends: A and B are the ends of the rod AB where sentences speak of these points.

use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use super::traits::{Trait, has};

/// Says so of each rod of which no sentence tells an end.
pub(super) fn end_by_names(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for declaration in declarations.iter() {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let ([rod @ Term::Name(name)], true) =
            (subjects.as_slice(), has(what.head, Trait::Slender))
        else {
            continue;
        };
        let letters: Vec<char> = name.chars().collect();
        let &[first, last] = letters.as_slice() else {
            continue;
        };
        let capitals = first.is_uppercase() && last.is_uppercase() && first != last;
        let ends = [first, last].map(|letter| Term::Name(letter.to_string()));
        let places = ends.iter().all(|end| stands(end, declarations));
        let known = declarations.iter().any(|d| ends_known(&d.statement, rod));
        if capitals && places && !known && declaration.extent == Extent::Document {
            let end = NounPhrase::new("end", vec![(Slot::Of, rod.clone())]);
            told.push(declaration.saying(Statement::Is {
                subjects: ends.to_vec(),
                what: end,
            }));
        }
    }
    declarations.extend(told);
}

/// Whether a sentence places a point, or tells how it moves.
fn stands(point: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Does { subjects, verb, .. } => {
            matches!(*verb, "place" | "lie" | "move" | "slide") && subjects.contains(point)
        }
        Statement::Is { subjects, what } => {
            what.slot(Slot::FixedIn).is_some() && subjects.contains(point)
        }
        _ => false,
    })
}

/// Whether a sentence tells of an end of a rod, or from where it lies.
fn ends_known(statement: &Statement, rod: &Term) -> bool {
    match statement {
        Statement::Is { what, .. } if what.head == "end" => what.slot(Slot::Of) == Some(rod),
        Statement::Is { subjects, what } => {
            let begins = what.slot(Slot::From).is_some() || what.slot(Slot::Along).is_some();
            begins && subjects.contains(rod)
        }
        Statement::Does {
            subjects,
            verb: "lie" | "extend" | "point" | "hang",
            ..
        } => subjects.contains(rod),
        _ => false,
    }
}
