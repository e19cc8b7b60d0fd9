//! Strings that unwind from a round body in a frame whose axes have names: the point where the string leaves the body tells on
//! which side it is.

use super::heads::{CONTACT_POINT, NORMAL, VERTICAL};
use super::kinds::name;
use super::planar_axes::axis;
use super::reader::formula;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::turned_lines::{Direction, direction};
use super::unwound::{Unwinding, body_with, held_in, pull_there, says_vertical};
use super::wound::winds;
use crate::notation::Macros;

/// Says that the body rolls along the string at the point where the string leaves it, and that this pulls there.
pub(super) fn unwind_beside_axes(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let Some((told, point, side)) = unwinding(declarations) else {
        return;
    };
    let Some(normal) = opposite(&side, declarations, macros) else {
        return;
    };
    let said = declarations[told.at].clone();
    declarations.retain(|d| !is_of_winding(&d.statement, &told));
    for declaration in declarations.iter_mut() {
        pull_there(&mut declaration.statement, &told, &point);
    }
    let plane = vec![(Slot::FixedIn, told.ground.clone()), (Slot::With, normal)];
    let contact = vec![
        (Slot::Of, told.body.clone()),
        (Slot::On, told.string.clone()),
    ];
    let all = [
        Statement::one_is(told.string.clone(), NounPhrase::new("plane", plane)),
        Statement::one_is(point.clone(), NounPhrase::new(CONTACT_POINT, contact)),
        Statement::Does {
            subjects: vec![told.body.clone()],
            verb: "roll",
            slots: vec![(Slot::On, told.string.clone()), (Slot::At, point)],
        },
    ];
    declarations.extend(all.into_iter().map(|statement| said.saying(statement)));
}

/// The only string that unwinds, where it is vertical and held at rest: with the point where it leaves the body, and on which
/// side that is.
fn unwinding(declarations: &[Declaration]) -> Option<(Unwinding, Term, Direction)> {
    let mut wound = declarations.iter().enumerate().filter_map(|(at, d)| {
        let (string, part) = winds(&d.statement)?;
        let whole = d.extent == Extent::Document;
        Some((at, string.clone(), part.clone(), whole))
    });
    let (at, string, part, whole) = wound.next()?;
    let vertical = declarations
        .iter()
        .any(|d| says_vertical(&d.statement, &string));
    if wound.next().is_some() || !whole || !vertical {
        return None;
    }
    let ground = held_in(&string, declarations)?;
    let body = body_with(&part, declarations).filter(|body| *body == part)?;
    let point = declarations
        .iter()
        .find_map(|d| leaving(&d.statement, &string, &body))?;
    let side = declarations
        .iter()
        .find_map(|d| side(&d.statement, &point, declarations))?;
    let upright = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == VERTICAL => {
            direction(subjects.first()?, declarations)
        }
        _ => None,
    })?;
    let beside = side.frame == upright.frame && side.number != upright.number;
    let own = side.frame == ground;
    let told = Unwinding {
        at,
        string,
        part,
        body,
        ground,
        down: false,
    };
    (beside && own).then_some((told, point, side))
}

/// "The string leaves the disc at C", "C is the point where the string leaves the disc"
fn leaving(statement: &Statement, string: &Term, body: &Term) -> Option<Term> {
    match statement {
        Statement::Does {
            subjects,
            verb: "leave" | "touch",
            slots,
        } => {
            let things: Vec<&Term> = subjects
                .iter()
                .chain(slots.iter().map(|(_, t)| t))
                .collect();
            let both = things.contains(&string) && things.contains(&body);
            slot(slots, Slot::At).filter(|_| both).cloned()
        }
        Statement::Is { subjects, what } if what.head == CONTACT_POINT => {
            let things: Vec<&Term> = what.slots.iter().map(|(_, term)| term).collect();
            let both = things.contains(&string) && things.contains(&body);
            subjects.first().filter(|_| both).cloned()
        }
        _ => None,
    }
}

/// The side on which a point is placed: "at the distance `$R$` from G along j", "by `$R j$`".
fn side(statement: &Statement, point: &Term, all: &[Declaration]) -> Option<Direction> {
    let Statement::Does {
        subjects,
        verb: "lie" | "place",
        slots,
    } = statement
    else {
        return None;
    };
    if subjects.as_slice() != std::slice::from_ref(point) {
        return None;
    }
    if let Some(along) = slot(slots, Slot::Along) {
        return direction(along, all);
    }
    let Term::Formula(way) = slot(slots, Slot::By)? else {
        return None;
    };
    let (way, reversed) = match way.source.trim().strip_prefix('-') {
        Some(rest) => (rest, true),
        None => (way.source.trim(), false),
    };
    if way.contains(['+', '-']) {
        return None;
    }
    let axes = all.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" => Some(subjects),
        _ => None,
    });
    let own = axes.flatten().find(|axis| {
        let name = name(axis).unwrap_or_default();
        let rest = way.strip_suffix(&name);
        rest.is_some_and(|rest| !name.is_empty() && !rest.ends_with('\\'))
    })?;
    let own = direction(own, all)?;
    Some(Direction { reversed, ..own })
}

/// What points from the side where the string is to the body.
fn opposite(side: &Direction, all: &[Declaration], macros: &Macros) -> Option<Term> {
    if side.reversed {
        return Some(axis(side.number, Some(&side.frame)));
    }
    let name = side.axis_name(all)?;
    let against = formula(&format!("-{name}"), false, macros)?;
    Some(Term::Formula(against))
}

/// What only says how the string is wound and where it leaves the body.
fn is_of_winding(statement: &Statement, told: &Unwinding) -> bool {
    let own = |subjects: &[Term]| subjects.contains(&told.string);
    match statement {
        Statement::Does { subjects, verb, .. } => {
            own(subjects) && matches!(*verb, "unwind" | "wind" | "hang" | "grip" | "leave")
        }
        Statement::Is { subjects, what } => {
            let plain = matches!(what.head, "massless" | "inextensible" | NORMAL);
            let contact = leaving(statement, &told.string, &told.body).is_some();
            own(subjects) && plain || contact || says_vertical(statement, &told.string)
        }
        _ => false,
    }
}
