//! Frames that turn about the vertical and are inclined against it: by the angle of one axis, about another that stays level.

use super::heads::{CONSTANT, CONTACT_POINT, MASS_CENTRE, UNIT_VECTOR, VERTICAL};
use super::kinds::name;
use super::planar_axes::{axes_of, axis, turns_by};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::leave_out;
use crate::notation::Macros;

/// An inclined frame, which of its axes stays level, which one the angle tells, and the letter of that.
struct Inclined {
    frame: Term,
    upright: Term,
    level: usize,
    tilted: usize,
    angle: Formula,
    /// The sentence of the turn about the vertical.
    turn: usize,
    /// The sentences that say no more than that.
    used: Vec<usize>,
}

/// "A turns relative to N about the vertical z at the rate `$\Omega$`. `$e_1$` is horizontal. The angle between `$e_3$` and z is
/// `$\alpha$`. `$e_2$` is the unit vector from the point of contact to G": a level frame turns about z, and A is turned
/// against it about `$e_1$` by α, to that side where `$e_2$` points upward.
pub(super) fn incline_frames(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let all = (0..declarations.len()).find_map(|at| inclined(at, declarations));
    let Some(inclined) = all else { return };
    let own = declarations[inclined.turn].clone();
    let Some(told) = statements(&inclined, declarations, macros) else {
        return;
    };
    put_level(&mut declarations[inclined.turn].statement, &inclined.frame);
    leave_out(declarations, &inclined.used);
    declarations.extend(told.into_iter().map(|said| own.saying(said)));
}

fn level(frame: &Term) -> Term {
    let name = name(frame).unwrap_or_default();
    Term::Name(format!("level {name}"))
}

/// The turn about the vertical is that of the level frame.
fn put_level(statement: &mut Statement, frame: &Term) {
    if let Statement::Is { subjects, .. } | Statement::Does { subjects, .. } = statement {
        *subjects = vec![level(frame)];
    }
}

/// How the level frame and the inclined one lie.
fn statements(
    inclined: &Inclined,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<Vec<Statement>> {
    let Inclined {
        frame,
        upright,
        level: about,
        tilted,
        angle,
        ..
    } = inclined;
    let other = 6 - about - tilted;
    points_up(frame, other, declarations)?;
    // Turned forwards, the axis behind the tilted one goes down.
    let source = match *about % 3 + 1 == *tilted {
        true => format!("-{}", angle.source),
        false => angle.source.clone(),
    };
    let by = Term::Formula(formula(&source, false, macros)?);
    let base = level(frame);
    let Term::Phrase(third) = axis(*tilted, Some(&base)) else {
        return None;
    };
    let letter = Term::Formula(angle.clone());
    let constant = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head == CONSTANT && subjects.contains(&letter),
        _ => false,
    });
    let constant =
        (!constant).then(|| Statement::one_is(letter, NounPhrase::new(CONSTANT, vec![])));
    let turn = turns_by(frame, &base, axis(*about, Some(&base)), by);
    let frames = Statement::one_is(base, NounPhrase::new("frame", vec![]));
    let told = [frames, Statement::one_is(upright.clone(), *third), turn];
    Some(told.into_iter().chain(constant).collect())
}

/// A frame whose turn about the vertical a sentence tells, where others tell of its axes.
fn inclined(turn: usize, declarations: &[Declaration]) -> Option<Inclined> {
    let (subjects, slots) = match &declarations[turn].statement {
        Statement::Is { subjects, what } if what.head == "frame" => (subjects, &what.slots),
        Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } => (subjects, slots),
        _ => return None,
    };
    let ([frame], true) = (
        subjects.as_slice(),
        slots.iter().any(|(slot, _)| *slot == Slot::At),
    ) else {
        return None;
    };
    let (_, upright) = slots.iter().find(|(slot, _)| *slot == Slot::About)?;
    is_upward(upright, declarations).then_some(())?;
    let axes = axes_of(frame, declarations).filter(|axes| axes.len() == 3)?;
    let number = |term: &Term| {
        let called = name(term)?;
        let at = axes
            .iter()
            .position(|axis| name(axis).as_ref() == Some(&called))?;
        Some(at + 1)
    };
    let flat = level_axis(declarations);
    let mut said = declarations.iter().enumerate();
    let (leaning, tilted, angle) = said.find_map(|(at, d)| match &d.statement {
        Statement::Is { subjects, what } if what.head == "angle" && what.slots.len() == 2 => {
            let ends: Vec<&Term> = what.all(Slot::Between).collect();
            let (&[one, other], [Term::Formula(angle)]) = (ends.as_slice(), subjects.as_slice())
            else {
                return None;
            };
            let axis = [(one, other), (other, one)]
                .into_iter()
                .find_map(|(axis, end)| (end == upright).then(|| number(axis)).flatten());
            Some((at, axis?, angle.clone()))
        }
        _ => None,
    })?;
    let about = match &flat {
        Some((_, level)) => number(level)?,
        None => level_by_contact(axes, tilted, declarations)?,
    };
    (about != tilted).then(|| Inclined {
        frame: frame.clone(),
        upright: upright.clone(),
        level: about,
        tilted,
        angle,
        turn,
        used: flat
            .map(|(at, _)| at)
            .into_iter()
            .chain([leaning])
            .collect(),
    })
}

/// The sentence that says that one axis is horizontal, and which.
fn level_axis(declarations: &[Declaration]) -> Option<(usize, &Term)> {
    let mut said = declarations.iter().enumerate();
    said.find_map(|(at, d)| match &d.statement {
        Statement::Is { subjects, what } if what.head == "horizontal" => {
            match subjects.as_slice() {
                [axis] => Some((at, axis)),
                _ => None,
            }
        }
        _ => None,
    })
}

/// A body that is symmetric about the inclined axis touches a level plane with its lowest point: the axis that leads from there
/// to its mass centre is the steepest one across the inclined axis, and the third stays level.
fn level_by_contact(axes: &[Term], tilted: usize, declarations: &[Declaration]) -> Option<usize> {
    let called = name(axes.get(tilted - 1)?)?;
    let own = |term: &Term| name(term).as_ref() == Some(&called);
    let is = |head: &str, of: Slot, d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if what.head == head => {
            Some((subjects.clone(), what.slot(of)?.clone()))
        }
        _ => None,
    };
    let said = |head, of| declarations.iter().filter_map(move |d| is(head, of, d));
    let body = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "symmetric" => {
            let about = what.slots.iter().all(|(slot, _)| *slot == Slot::About);
            let own = about && what.all(Slot::About).any(own);
            subjects.first().filter(|_| own).cloned()
        }
        _ => None,
    })?;
    let mut centres = said(MASS_CENTRE, Slot::Of).filter(|(_, of)| *of == body);
    let (centre, _) = centres.next()?;
    let mut ways = said(UNIT_VECTOR, Slot::To).filter(|(_, to)| centre.contains(to));
    let leads = ways.find_map(|(way, _)| axes.iter().position(|axis| way.contains(axis)))?;
    let other = leads + 1;
    (other != tilted).then(|| 6 - other - tilted)
}

/// Whether a sentence says that a direction is the upward vertical.
fn is_upward(direction: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let vertical = what.head == VERTICAL || what.is(VERTICAL);
            vertical && what.is("upward") && subjects.contains(direction)
        }
        _ => false,
    })
}

/// Whether an axis leads from where a body touches what it lies on to another point, and so upward.
fn points_up(frame: &Term, number: usize, declarations: &[Declaration]) -> Option<()> {
    let axis = axes_of(frame, declarations)?.get(number - 1)?;
    let called = name(axis)?;
    let touches = |point: &Term| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                what.head == CONTACT_POINT && subjects.contains(point)
            }
            _ => false,
        })
    };
    let leads = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == UNIT_VECTOR => {
            let own = matches!(subjects.as_slice(), [one] if name(one).as_ref() == Some(&called));
            own && what.slot(Slot::From).is_some_and(touches) && what.slot(Slot::To).is_some()
        }
        _ => false,
    });
    leads.then_some(())
}
