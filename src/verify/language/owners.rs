//! Whose something is: a point has no mass centre and no mass, but the body has to which it belongs.

use super::heads::MASS;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::{is_bodily, is_body};

/// Nouns of points.
const POINTS: [&str; 5] = ["point", "apex", "end", "corner", "middle"];

/// "O is the apex of the cone, and G is its mass centre": that of the cone.
pub(crate) fn give_to_bodies(declarations: &mut [Declaration]) {
    let owners: Vec<(String, Term)> = declarations.iter().filter_map(owner).collect();
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        let of_bodies = is_bodily(what.head) || what.head == MASS || what.head == "mass centre";
        for (_, of) in what
            .slots
            .iter_mut()
            .filter(|(slot, _)| of_bodies && *slot == Slot::Of)
        {
            let point = name(of);
            if let Some((_, body)) = owners.iter().find(|(own, _)| Some(own) == point.as_ref()) {
                of.clone_from(body);
            }
        }
    }
}

/// A point, and the thing to which the sentence that tells it says that it belongs.
fn owner(declaration: &Declaration) -> Option<(String, Term)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let [point] = subjects.as_slice() else {
        return None;
    };
    let owners: Vec<&Term> = what
        .slots
        .iter()
        .filter_map(|slot| belongs(what, slot))
        .collect();
    match owners.as_slice() {
        [owner] if POINTS.contains(&what.head) => Some((name(point)?, (*owner).clone())),
        _ => None,
    }
}

/// "of the rod", "fixed in the disc": what belongs to a body by its noun.
fn belongs<'t>(what: &NounPhrase, (slot, of): &'t (Slot, Term)) -> Option<&'t Term> {
    let body = match of {
        Term::Name(name) => name.starts_with(char::is_lowercase),
        Term::Phrase(phrase) => is_body(phrase.head),
        _ => false,
    };
    let fixed = *slot == Slot::FixedIn && what.head == "point";
    (body && (*slot == Slot::Of || fixed)).then_some(of)
}
