//! Places of a body that the sentence about its shape tells: its middle, its ends.

use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// Places that a thing has.
const PLACES: [&str; 5] = ["middle", "centre", "mass centre", "end", "origin"];

/// "The rod is a uniform rod with its middle at G and the ends A and B": what G, A and B are.
pub(crate) fn tell_places(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| match statement {
        Statement::Is { subjects, what } => {
            let [thing] = subjects.as_slice() else {
                return vec![];
            };
            let mut told: Vec<Statement> = take_origin(what, thing).into_iter().collect();
            told.extend(take_places(&mut what.slots, thing));
            told
        }
        // "The rod lies along x with its middle at G."
        Statement::Does {
            subjects,
            verb: "lie",
            slots,
        } => match subjects.as_slice() {
            [thing] => take_places(slots, thing),
            _ => vec![],
        },
        _ => vec![],
    });
}

fn take_places(slots: &mut Vec<(Slot, Term)>, thing: &Term) -> Vec<Statement> {
    let mut told = vec![];
    slots.retain(|(slot, term)| match place_of(*slot, term, thing) {
        Some(places) => {
            told.extend(places);
            false
        }
        None => true,
    });
    told
}

/// "B is a frame fixed in the body with the origin at O": what O is.
fn take_origin(what: &mut NounPhrase, frame: &Term) -> Option<Statement> {
    let origin = |term: &Term| match term {
        Term::Phrase(p) => p.head == "origin" && p.slots.iter().all(|(_, of)| of == frame),
        _ => false,
    };
    let at = what.slot(Slot::At).cloned();
    let with = what.all(Slot::With).any(origin);
    let (Some(at), true, "frame") = (at, with, what.head) else {
        return None;
    };
    what.slots
        .retain(|(slot, term)| !(*slot == Slot::At || *slot == Slot::With && origin(term)));
    let of = vec![(Slot::Of, frame.clone())];
    name(&at)?;
    Some(Statement::one_is(at, NounPhrase::new("origin", of)))
}

/// "with its middle at G", "with the ends A and B"
fn place_of(slot: Slot, term: &Term, thing: &Term) -> Option<Vec<Statement>> {
    let Term::Phrase(place) = term else {
        return None;
    };
    let others = place.slots.iter().all(|(slot, own)| match slot {
        Slot::At | Slot::Which => name(own).is_some(),
        Slot::Of => own == thing,
        _ => false,
    });
    if slot != Slot::With || !PLACES.contains(&place.head) || !others {
        return None;
    }
    let points = place.all(Slot::At).chain(place.all(Slot::Which));
    let points: Vec<Statement> = points
        .map(|point| {
            let of = vec![(Slot::Of, thing.clone())];
            Statement::one_is(point.clone(), NounPhrase::new(place.head, of))
        })
        .collect();
    (!points.is_empty()).then_some(points)
}

/// "The rod goes from O to P": these are its ends.
pub(crate) fn tell_reach(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Some(([body], [(Slot::From, from), (Slot::To, to)])) =
            declaration.statement.does("extend")
        {
            declaration.statement = Statement::Is {
                subjects: vec![from.clone(), to.clone()],
                what: NounPhrase::new("end", vec![(Slot::Of, body.clone())]),
            };
        }
    }
}
