//! Corners of plates and boxes that other sentences place: the one opposite another, and those of which a sentence tells where
//! they lie.

use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;

const CORNER: &str = "corner";

/// "D is the corner of the plate opposite O", "S is a corner of the plate", of which another sentence tells the place: each is
/// a point of the body, and the way to the opposite one goes along all sides.
pub(super) fn place_corners(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let laid: Vec<Corner> = declarations.iter().filter_map(corner_along).collect();
    let mut told = vec![];
    for at in 0..declarations.len() {
        let Some((corner, of, from)) = bare_corner(&declarations[at].statement) else {
            continue;
        };
        let Some(body) = of.or_else(|| only_body(declarations)) else {
            continue;
        };
        let way = match &from {
            Some(from) => {
                let laid = laid.iter().find(|c| c.point == *from && c.body == body);
                let way = laid.and_then(|laid| way_across(laid, declarations, macros));
                if way.is_none() {
                    continue;
                }
                way
            }
            None if is_placed(&corner, &laid, declarations) => None,
            None => continue,
        };
        if let (Some(by), Some(from)) = (way, from) {
            told.push(declarations[at].saying(Statement::Does {
                subjects: vec![corner.clone()],
                verb: "place",
                slots: vec![(Slot::From, from), (Slot::By, by)],
            }));
        }
        let point = NounPhrase::new("point", vec![(Slot::FixedIn, body)]);
        declarations[at].statement = Statement::one_is(corner, point);
    }
    declarations.extend(told);
}

/// A corner from which the sides of a body run along axes.
struct Corner {
    point: Term,
    body: Term,
    along: Vec<Term>,
}

/// "O is the corner of the plate along x and y."
fn corner_along(declaration: &Declaration) -> Option<Corner> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let along: Vec<Term> = what.all(Slot::Along).cloned().collect();
    let ([point], CORNER, false) = (subjects.as_slice(), what.head, along.is_empty()) else {
        return None;
    };
    Some(Corner {
        point: point.clone(),
        body: what.slot(Slot::Of)?.clone(),
        along,
    })
}

/// A corner of which a sentence only says whose it is, and which one it is opposite.
fn bare_corner(statement: &Statement) -> Option<(Term, Option<Term>, Option<Term>)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let known = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::From);
    let ([corner], CORNER) = (subjects.as_slice(), what.head) else {
        return None;
    };
    let (of, from) = (what.slot(Slot::Of).cloned(), what.slot(Slot::From).cloned());
    let one_body = what.all(Slot::Of).count() < 2;
    let bare = one_body
        && what.slots.iter().all(known)
        && what.adjectives.iter().all(|said| *said == "one");
    bare.then(|| (corner.clone(), of, from))
}

/// The only body of whose corners sentences speak.
fn only_body(declarations: &[Declaration]) -> Option<Term> {
    let mut bodies = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { what, .. } if what.head == CORNER => what.slot(Slot::Of),
        _ => None,
    });
    let first = bodies.next()?;
    bodies.all(|other| other == first).then(|| first.clone())
}

/// Whether a sentence tells where a corner lies.
fn is_placed(corner: &Term, laid: &[Corner], declarations: &[Declaration]) -> bool {
    let along = laid.iter().any(|laid| laid.point == *corner);
    let mut places = declarations.iter().filter_map(|d| d.statement.places());
    along || places.any(|(subjects, _)| subjects.contains(corner))
}

/// The way from a corner to the opposite one: "`$a x + b y$`".
fn way_across(corner: &Corner, declarations: &[Declaration], macros: &Macros) -> Option<Term> {
    let parts = corner.along.iter().map(|axis| {
        let Term::Formula(axis_letter) = axis else {
            return None;
        };
        let side = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "side" => {
                let along: Vec<&Term> = what.all(Slot::Along).collect();
                let own = what.slot(Slot::Of) == Some(&corner.body) && along == [axis];
                match subjects.as_slice() {
                    [Term::Formula(side)] if own => Some(side.source.clone()),
                    _ => None,
                }
            }
            _ => None,
        })?;
        Some(format!("({side})\\,{}", axis_letter.source))
    });
    let parts: Vec<String> = parts.collect::<Option<_>>()?;
    formula(&parts.join("+"), false, macros).map(Term::Formula)
}
