//! Places of a body that the sentence about its shape tells: its middle, its ends.

use super::heads::{MASS_CENTRE, POSITION};
use super::kinds::name;
use super::laid_rods::lay_rods;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use super::traits::{Trait, has};
use crate::notation::Macros;
use crate::notation::ast::Kind;
use crate::notation::document::Row;

/// Places that a thing has.
const PLACES: [&str; 5] = ["middle", "centre", "mass centre", "end", "origin"];

/// "S is the mass centre of the satellite and the centre of the ball": it is both.
fn part_places(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let ([place], true) = (subjects.as_slice(), PLACES.contains(&what.head)) else {
            return vec![];
        };
        let (mut told, mut first) = (vec![], true);
        what.slots.retain(|said| {
            let other = match said {
                (Slot::Of, Term::Phrase(other)) if !first => Some(other),
                _ => None,
            };
            first &= said.0 != Slot::Of;
            let other = other.filter(|other| PLACES.contains(&other.head));
            told.extend(other.map(|other| Statement::one_is(place.clone(), (**other).clone())));
            other.is_none()
        });
        told
    });
}

/// "The rod is a uniform rod with its middle at G and the ends A and B": what G, A and B are.
pub(crate) fn tell_places(declarations: &mut Vec<Declaration>) {
    part_places(declarations);
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
    let points = || place.all(Slot::At).chain(place.all(Slot::Which));
    // Of several things one point is the place of each.
    let several = place.all(Slot::Of).count() > 1;
    let of_each = points().count() == 1 && place.all(Slot::Of).any(|of| of == thing);
    let others = place.slots.iter().all(|(slot, own)| match slot {
        Slot::At | Slot::Which => name(own).is_some(),
        Slot::Of => own == thing || several && of_each,
        _ => false,
    });
    if slot != Slot::With || !PLACES.contains(&place.head) || !others {
        return None;
    }
    let points: Vec<Statement> = points()
        .map(|point| {
            let of = vec![(Slot::Of, thing.clone())];
            Statement::one_is(point.clone(), NounPhrase::new(place.head, of))
        })
        .collect();
    (!points.is_empty()).then_some(points)
}

/// "The rod goes from O to P": these are its ends. A vector that does so is the position of P from O.
pub(crate) fn tell_reach(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Some(([body], [(Slot::From, from), (Slot::To, to)])) =
            declaration.statement.does("extend")
        {
            declaration.statement = match body {
                Term::Formula(vector) if is_marked_vector(vector) => {
                    let slots = vec![(Slot::Of, to.clone()), (Slot::From, from.clone())];
                    Statement::one_is(body.clone(), NounPhrase::new(POSITION, slots))
                }
                _ => are_ends(from, to, body),
            };
        }
    }
}

/// "a uniform thin rod of length `$l$` from A along z": its mass centre is half of that from A. "a thin rod from A to B": these
/// are its ends.
pub(crate) fn begin_rods(declarations: &mut Vec<Declaration>, macros: &Macros) {
    lay_rods(declarations, macros);
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let ([rod], true, Some(from)) = (
            subjects.as_slice(),
            has(what.head, Trait::Slender),
            what.slot(Slot::From).cloned(),
        ) else {
            return vec![];
        };
        let along = what.slot(Slot::Along).cloned();
        let told = match (along, what.slot(Slot::To).cloned(), what.size("length")) {
            (None, Some(to), _) => vec![are_ends(&from, &to, rod)],
            (Some(along), None, Some(Term::Formula(length))) => {
                let half = format!("\\frac{{{}}}{{2}}", length.source);
                let Some(half) = formula(&half, false, macros) else {
                    return vec![];
                };
                let slots = vec![
                    (Slot::At, Term::Formula(half)),
                    (Slot::From, from),
                    (Slot::Along, along),
                ];
                let centre = NounPhrase::new(MASS_CENTRE, vec![(Slot::Of, rod.clone())]);
                vec![Statement::Does {
                    subjects: vec![Term::Phrase(Box::new(centre))],
                    verb: "lie",
                    slots,
                }]
            }
            _ => return vec![],
        };
        what.slots
            .retain(|(slot, _)| !matches!(slot, Slot::From | Slot::To));
        let along = what
            .slots
            .iter_mut()
            .filter(|(slot, _)| *slot == Slot::Along);
        along.for_each(|(_, along)| take_forwards(along, macros));
        told
    });
}

/// A rod lies along an axis whichever way it reaches from its end.
fn take_forwards(along: &mut Term, macros: &Macros) {
    match along {
        Term::Phrase(axis) => axis.adjectives.retain(|adjective| *adjective != "negative"),
        Term::Formula(opposite) => {
            let forwards = opposite.source.trim().strip_prefix('-');
            let simple = forwards.filter(|rest| !rest.contains(['+', '-']));
            if let Some(axis) = simple.and_then(|rest| formula(rest.trim(), false, macros)) {
                *along = Term::Formula(axis);
            }
        }
        _ => {}
    }
}

/// Whether a letter carries the mark of a vector.
pub(super) fn is_marked_vector(letter: &Formula) -> bool {
    match &letter.row {
        Row::Expression(node) => matches!(&node.kind, Kind::Symbol(s) if s.style.vector),
        _ => false,
    }
}

fn are_ends(from: &Term, to: &Term, body: &Term) -> Statement {
    Statement::Is {
        subjects: vec![from.clone(), to.clone()],
        what: NounPhrase::new("end", vec![(Slot::Of, body.clone())]),
    }
}
