//! Rods that are called by the two points at which they end: "the rod AB" ends at A and at B.

use super::heads::MASS_CENTRE;
use super::kinds::name;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use super::traits::{Trait, has};
use std::collections::BTreeSet;

/// The noun of a point at which a rod ends.
const END: &str = "end";

/// Tells the ends of each rod whose name is that of two points, where a sentence speaks of one of them and none says where the
/// rod ends.
pub(super) fn end_by_names(declarations: &mut Vec<Declaration>) {
    let mut told: Vec<Declaration> = vec![];
    let mut done: BTreeSet<String> = BTreeSet::new();
    for declaration in declarations.iter() {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        if !has(what.head, Trait::Slender) || declaration.extent != Extent::Document {
            continue;
        }
        for rod in subjects {
            let ends = name(rod).and_then(|own| two_points(&own).map(|ends| (own, ends)));
            let Some((own, ends)) = ends else { continue };
            if done.insert(own) && may_end(rod, &ends, declarations) {
                let [one, other] = ends;
                let what = NounPhrase::new(END, vec![(Slot::Of, rod.clone())]);
                let ends = Statement::Is {
                    subjects: vec![Term::Name(one), Term::Name(other)],
                    what,
                };
                told.push(declaration.saying(ends));
            }
        }
    }
    declarations.extend(told);
}

/// Two points by their names in one word: "AB".
fn two_points(own: &str) -> Option<[String; 2]> {
    let mut letters = own.chars();
    let (one, other) = (letters.next()?, letters.next()?);
    let points = [one, other].iter().all(char::is_ascii_uppercase) && one != other;
    (points && letters.next().is_none()).then(|| [one.to_string(), other.to_string()])
}

/// Whether a sentence speaks of one of the points, none says that it is somewhere else on the rod, and none where that ends or
/// how it lies.
fn may_end(rod: &Term, ends: &[String; 2], declarations: &[Declaration]) -> bool {
    let is_one = |term: &Term| name(term).is_some_and(|name| ends.contains(&name));
    let spoken = declarations
        .iter()
        .any(|d| d.statement.terms().into_iter().any(is_one));
    let otherwise = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let own = what.slot(Slot::Of) == Some(rod);
            let inside = [MASS_CENTRE, "middle", "centre"].contains(&what.head);
            let begins = what.slot(Slot::From).is_some() || what.slot(Slot::Along).is_some();
            own && (what.head == END || inside && subjects.iter().any(is_one))
                || begins && subjects.contains(rod)
        }
        Statement::Does {
            subjects,
            verb: "lie" | "extend" | "point" | "hang",
            ..
        } => subjects.contains(rod),
        _ => false,
    });
    spoken && !otherwise
}
