//! "At `$\theta = 0$` G lies below O", of what turns by θ about a horizontal axis while no sentence names axes: the second axis
//! of the frame is the horizontal one and the third points up, as for all that moves in a vertical plane.

use super::angles_about::direction_of;
use super::at_zero_placed::turn;
use super::heads::{UNIT_VECTOR, VERTICALLY_ABOVE};
use super::planar::names_axes;
use super::planar_axes::{ACROSS, UPRIGHT, axis, tells_distance, vertical};
use super::statement::{Declaration, Formula, Slot, Statement, Term, slot};

/// What is said to be below or above something where an angle is zero.
struct Below {
    at: usize,
    point: Term,
    from: Term,
    side: &'static str,
    zero: Formula,
}

/// "z points down", of an axis by its name.
pub(super) fn tell_axes_that_point_down(declarations: &mut [Declaration]) {
    let axes = declarations.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" => subjects.clone(),
        _ => vec![],
    });
    let axes: Vec<Term> = axes.collect();
    for declaration in declarations {
        if let Some(([axis @ Term::Name(_)], [])) = declaration.statement.does("hang")
            && axes.contains(axis)
        {
            declaration.statement = Statement::one_is(axis.clone(), vertical("downward"));
        }
    }
}

/// Places each such point along the vertical, and names the axes of the frame by it.
pub(super) fn name_level_axes(declarations: &mut Vec<Declaration>) {
    let all = declarations.iter().enumerate();
    let Some(below) = all.filter_map(|(at, d)| below(at, &d.statement)).next() else {
        return;
    };
    let turn = declarations
        .iter()
        .find_map(|d| level_turn(&d.statement, &below.zero));
    let Some((about, base)) = turn else { return };
    if names_axes(declarations, Some(&base)) {
        return;
    }
    let level = |d: &Declaration| is_level(&d.statement, &about);
    let distance = |d: &Declaration| match tells_distance(&d.statement) {
        Some((of, from, letter)) if *of == below.point && *from == below.from => {
            Some(letter.clone())
        }
        _ => None,
    };
    let found = declarations.iter().enumerate();
    let found: Vec<(usize, Term)> = found
        .filter_map(|(at, d)| Some((at, distance(d)?)))
        .collect();
    let (Some(named), [(told, distance)]) = (declarations.iter().position(level), found.as_slice())
    else {
        return;
    };
    if let (Statement::Is { what, .. }, Term::Phrase(across)) = (
        &mut declarations[named].statement,
        axis(ACROSS, Some(&base)),
    ) {
        *what = *across;
    }
    let said = declarations[below.at].clone();
    let along = Term::Phrase(Box::new(vertical(below.side)));
    declarations[below.at].statement = Statement::Does {
        subjects: vec![below.point],
        verb: "lie",
        slots: vec![
            (Slot::At, distance.clone()),
            (Slot::From, below.from),
            (Slot::Along, along),
            (Slot::At, Term::Formula(below.zero)),
        ],
    };
    let upright = Statement::one_is(axis(UPRIGHT, Some(&base)), vertical("upward"));
    declarations.push(said.saying(upright));
    declarations.remove(*told);
}

fn below(at: usize, statement: &Statement) -> Option<Below> {
    let (subjects, slots) = statement.does("lie")?;
    let ([point], [_, _]) = (subjects, slots) else {
        return None;
    };
    let Term::Formula(zero) = slot(slots, Slot::At).filter(|at| at.is_condition())? else {
        return None;
    };
    let Term::Phrase(place) = slot(slots, Slot::With)? else {
        return None;
    };
    let side = match place.head {
        "below" => "downward",
        VERTICALLY_ABOVE => "upward",
        _ => return None,
    };
    Some(Below {
        at,
        point: point.clone(),
        from: place.slot(Slot::Of)?.clone(),
        side,
        zero: zero.clone(),
    })
}

/// The direction about which something turns by an angle that is zero under a condition, and against what.
fn level_turn(statement: &Statement, zero: &Formula) -> Option<(Term, Term)> {
    let (_, base) = turn(statement, zero)?;
    let (_, slots) = statement.does("turn")?;
    let about = direction_of(slot(slots, Slot::About)?);
    Some((about.clone(), base.clone()))
}

/// "n is a horizontal unit vector"
fn is_level(statement: &Statement, vector: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } => {
            let level = what.head == UNIT_VECTOR && what.is("horizontal");
            level && subjects.as_slice() == std::slice::from_ref(vector)
        }
        _ => false,
    }
}
