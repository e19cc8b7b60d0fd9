//! Bodies that move in a plane: they turn about what stands on it, and what is round does so about its axis of symmetry.

use super::flat_bodies::{is_inertial, is_told_to_turn, turning_about};
use super::heads::{ANGULAR_VELOCITY, DOWNHILL, NORMAL, UPHILL, VERTICAL};
use super::kinds::name;
use super::places::is_marked_vector;
use super::planar_axes::axis;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::traits::{Trait, has};
use super::turned_lines::{Direction, direction};

/// What a body does that moves in a plane.
const MOTIONS: [&str; 3] = ["roll", "move", "slide"];

/// What turns about its own axis by its name.
const GEARS: [&str; 4] = ["gear", "pinion", "sun", "planet"];

/// Gives each body of which no sentence says how it turns the turn across the plane in which it moves: the plane is named, or
/// it is that of the way along which the body rolls and the normal of what it rolls on, or the body has an angular velocity
/// along a level axis.
pub(super) fn turn_across_planes(declarations: &mut Vec<Declaration>) {
    let mut told: Vec<Declaration> = vec![];
    let mut seen: Vec<Term> = vec![];
    for declaration in declarations.iter() {
        let Statement::Does { subjects, verb, .. } = &declaration.statement else {
            continue;
        };
        if !MOTIONS.contains(verb) || declaration.extent != Extent::Document {
            continue;
        }
        for body in subjects {
            let known = seen.contains(body) || is_told_to_turn(body, declarations);
            let across = across(body, declarations).map(|across| {
                let about = axis(across.number, Some(&across.frame));
                (across.frame, about)
            });
            let across = across.or_else(|| of_mesh(body, declarations));
            let Some((frame, about)) = across.filter(|_| !known) else {
                continue;
            };
            seen.push(body.clone());
            let one = std::slice::from_ref(body);
            let [turn, symmetric] = turning_about(one, frame, about);
            told.push(declaration.saying(turn));
            told.extend(is_round(body, declarations).then(|| declaration.saying(symmetric)));
        }
    }
    declarations.extend(told);
}

/// The one axis of an inertial frame about which a body turns, by all that sentences say.
fn across(body: &Term, all: &[Declaration]) -> Option<Direction> {
    if !is_rigid(body, all) {
        return None;
    }
    let told = all.iter().filter(|d| d.extent == Extent::Document);
    let told: Vec<Direction> = told
        .filter_map(|d| {
            of_plane(&d.statement, body, all)
                .or_else(|| of_way(d, body, all))
                .or_else(|| of_spin(&d.statement, body, all))
        })
        .filter(|across| is_inertial(&across.frame, all))
        .collect();
    let (first, others) = told.split_first()?;
    let same = |other: &Direction| other.number == first.number && other.frame == first.frame;
    others.iter().all(same).then(|| Direction {
        frame: first.frame.clone(),
        ..*first
    })
}

/// Whether sentences say that something is a body with an extent: it has a shape, or it rolls.
fn is_rigid(body: &Term, all: &[Declaration]) -> bool {
    let rolling = all.iter().any(|d| rolls(&d.statement, body));
    rolling || has_kind(body, Trait::Shape, all)
}

fn rolls(statement: &Statement, body: &Term) -> bool {
    let rolling = statement.does("roll");
    rolling.is_some_and(|(subjects, _)| subjects.contains(body))
}

/// Whether a body is round about its own axis.
fn is_round(body: &Term, all: &[Declaration]) -> bool {
    let rolls = all.iter().any(|d| rolls(&d.statement, body));
    let round = |kind: &Trait| match kind {
        Trait::Flat => has_kind(body, Trait::Round, all) && has_kind(body, Trait::Flat, all),
        kind => rolls && has_kind(body, *kind, all),
    };
    let kinds = [Trait::Flat, Trait::Round, Trait::Rim, Trait::Wheel];
    let ball = has_kind(body, Trait::Ball, all);
    !ball && kinds.iter().any(round)
}

fn has_kind(body: &Term, kind: Trait, all: &[Declaration]) -> bool {
    let named = name(body).is_some_and(|name| has(&name, kind));
    named
        || all.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => has(what.head, kind) && subjects.contains(body),
            _ => false,
        })
}

/// "The wheel moves in the plane of x and y", "… in the plane normal to z"
fn of_plane(statement: &Statement, body: &Term, all: &[Declaration]) -> Option<Direction> {
    let (subjects, slots) = statement.does("move")?;
    let Some(Term::Phrase(plane)) = slot(slots, Slot::In).filter(|_| subjects.contains(body))
    else {
        return None;
    };
    let spanned: Vec<&Term> = plane.all(Slot::Of).collect();
    match (plane.head, spanned.as_slice(), plane.slot(Slot::With)) {
        ("plane", [one, other], None) => third(one, other, all),
        ("plane", [], Some(normal)) => direction(normal, all),
        _ => None,
    }
}

/// The axis beside two others of a frame.
fn third(one: &Term, other: &Term, all: &[Declaration]) -> Option<Direction> {
    let (one, other) = (direction(one, all)?, direction(other, all)?);
    let same = one.frame == other.frame && one.number != other.number;
    same.then(|| Direction {
        number: 6 - one.number - other.number,
        frame: one.frame,
        reversed: false,
    })
}

/// "The wheel rolls along x" on level ground, and "… down the slope" where x points down it and y stands on it.
fn of_way(declaration: &Declaration, body: &Term, all: &[Declaration]) -> Option<Direction> {
    let (subjects, slots) = declaration.statement.does("roll")?;
    if !subjects.contains(body) || has_kind(body, Trait::Ball, all) {
        return None;
    }
    let straight = |word: &str| matches!(word, "down" | "up");
    let along = match slot(slots, Slot::Along) {
        Some(along) => direction(along, all)?,
        None if declaration.text.split_whitespace().any(straight) => {
            said_to_be(&[DOWNHILL, UPHILL], all)?
        }
        None => return None,
    };
    let upright = said_to_be(&[NORMAL], all).or_else(|| said_to_be(&[VERTICAL], all))?;
    let same = upright.frame == along.frame && upright.number != along.number;
    same.then(|| Direction {
        number: 6 - along.number - upright.number,
        frame: along.frame,
        reversed: false,
    })
}

/// The axis that a sentence says to be such a direction.
fn said_to_be(heads: &[&str], all: &[Declaration]) -> Option<Direction> {
    all.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if heads.contains(&what.head) => {
            subjects.iter().find_map(|subject| direction(subject, all))
        }
        _ => None,
    })
}

/// "`$\omega$` is the angular velocity of the wheel along z", of what rolls and no ball, where z is not the vertical.
fn of_spin(statement: &Statement, body: &Term, all: &[Declaration]) -> Option<Direction> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let number = |term: &Term| matches!(term, Term::Formula(letter) if !is_marked_vector(letter));
    let spin = match what.slot(Slot::Of) {
        Some(Term::Phrase(inner)) if what.head == "component" => &**inner,
        _ => what,
    };
    let own = spin.head == ANGULAR_VELOCITY && spin.slot(Slot::Of) == Some(body);
    if !own || !subjects.iter().all(number) || has_kind(body, Trait::Ball, all) {
        return None;
    }
    let along = direction(
        what.slot(Slot::Along).or_else(|| spin.slot(Slot::Along))?,
        all,
    )?;
    let upright = said_to_be(&[NORMAL], all).or_else(|| said_to_be(&[VERTICAL], all))?;
    let level = upright.frame == along.frame && upright.number != along.number;
    level.then_some(along)
}

/// What rolls on another body turns relative to the frame and about the axis of which sentences say so of all that turn.
fn of_mesh(body: &Term, all: &[Declaration]) -> Option<(Term, Term)> {
    let rolls_on_body = |d: &Declaration| {
        let rolling = d.statement.does("roll");
        rolling.is_some_and(|(subjects, slots)| {
            let on = slot(slots, Slot::On).or_else(|| slot(slots, Slot::In));
            subjects.contains(body) && on.is_some_and(|on| is_rim(on, all))
        })
    };
    if !all.iter().any(rolls_on_body) || has_kind(body, Trait::Ball, all) {
        return None;
    }
    let turns = all.iter().filter_map(|d| d.statement.does("turn"));
    let told: Option<Vec<(&Term, &Term)>> = turns
        .map(|(_, slots)| {
            let about = slot(slots, Slot::About)?;
            let along = match about {
                Term::Phrase(axis) if axis.slot(Slot::Through).is_some() => {
                    axis.slot(Slot::Along)?
                }
                about => about,
            };
            Some((slot(slots, Slot::RelativeTo)?, along))
        })
        .collect();
    let mut told = told?.into_iter();
    let first = told.next()?;
    let inertial = is_inertial(first.0, all) && told.all(|other| other == first);
    inertial.then(|| (first.0.clone(), first.1.clone()))
}

/// Whether what something rolls on is round about the axis about which it turns: a wheel, or the inner or outer side of something.
/// On the face of a turntable what rolls turns about another axis.
fn is_rim(on: &Term, all: &[Declaration]) -> bool {
    let wheel = |word: &str| has(word, Trait::Wheel) || GEARS.contains(&word);
    let named = name(on).is_some_and(|name| name.split(' ').any(wheel));
    let side = |side: &NounPhrase| side.is("internal") || side.is("external");
    let surface = matches!(on, Term::Phrase(surface) if surface.head == "surface" && side(surface));
    surface || named || has_kind(on, Trait::Wheel, all)
}
