//! "G lies at the distance `$a$` from P along x where `$\theta = 0$`", of what is fixed in a frame that turns by `$\theta$`: it
//! always lies along that axis of this frame, as a frame and the one against which it turns have the same axes where the angle
//! is zero.

use super::at_zero::{number_of, points_at_zero, turns_by};
use super::heads::{MASS_CENTRE, VERTICAL};
use super::planar_axes::axis;
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term, slot};
use super::turned_lines::direction as direction_of;

/// Places points along axes of the frame that carries them, and leaves out that axes are the same where a turn between them
/// is zero.
pub(crate) fn place_at_zero(declarations: &mut Vec<Declaration>) {
    for at in 0..declarations.len() {
        if let Some(told) = placed(&declarations[at].statement, declarations) {
            declarations[at].statement = told;
        }
    }
    let follows = |d: &Declaration| says_axes_are_same(&d.statement, declarations);
    let kept = declarations.iter().filter(|d| !follows(d)).cloned();
    *declarations = kept.collect();
}

/// The place of a point, without its condition.
fn placed(statement: &Statement, all: &[Declaration]) -> Option<Statement> {
    let (subjects, slots) = statement.does("lie")?;
    let [point] = subjects else { return None };
    let (zero, mut slots) = without_condition(slots);
    let [(_, Term::Formula(zero))] = zero.as_slice() else {
        return None;
    };
    let (from, along) = (slot(&slots, Slot::From)?, slot(&slots, Slot::Along)?);
    let mut turns = all.iter().filter_map(|d| turn(&d.statement, zero));
    let (carrier, base) = turns.find(|(carrier, _)| {
        let own = carried_by(carrier, all);
        is_fixed(point, &own, all) && is_fixed(from, &own, all)
    })?;
    let (number, against) = axis_along(along, base, all)?;
    let mut own = NounPhrase::new("axis", vec![]);
    if let Term::Phrase(named) = axis(number, Some(carrier)) {
        own = *named;
    }
    if against {
        own.adjectives.push("negative");
    }
    slots.retain(|(slot, _)| *slot != Slot::Along);
    slots.push((Slot::Along, Term::Phrase(Box::new(own))));
    Some(Statement::Does {
        subjects: vec![point.clone()],
        verb: "lie",
        slots,
    })
}

/// What hangs on a verb.
type Slots = Vec<(Slot, Term)>;

/// The conditions of a sentence, whether they hang on its verb or on the axis that it names, and what else hangs on its verb.
fn without_condition(slots: &[(Slot, Term)]) -> (Slots, Slots) {
    let condition = |(slot, at): &(Slot, Term)| *slot == Slot::At && at.is_condition();
    let (mut conditions, mut others): (Vec<_>, Vec<_>) = slots.iter().cloned().partition(condition);
    for (slot, axis) in &mut others {
        if let (Slot::Along, Term::Phrase(axis)) = (slot, axis) {
            conditions.extend(axis.slots.iter().filter(|said| condition(said)).cloned());
            axis.slots.retain(|said| !condition(said));
        }
    }
    (conditions, others)
}

/// What turns against what by an angle that is zero under a condition.
pub(super) fn turn<'d>(statement: &'d Statement, zero: &Formula) -> Option<(&'d Term, &'d Term)> {
    let ([carrier], _) = statement.does("turn")? else {
        return None;
    };
    Some((carrier, turns_by(statement, carrier, zero)?))
}

/// A frame or a body, and the bodies and frames that are fixed in it.
pub(super) fn carried_by<'d>(carrier: &'d Term, all: &'d [Declaration]) -> Vec<&'d Term> {
    let frames = all.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" => {
            let own = subjects.iter().filter(move |_| what.slots.len() == 1);
            let body = what.slot(Slot::FixedIn);
            own.filter_map(|frame| Some((frame, body?))).collect()
        }
        _ => vec![],
    });
    let others = frames.filter_map(|(frame, body)| match (frame == carrier, body == carrier) {
        (true, _) => Some(body),
        (_, true) => Some(frame),
        _ => None,
    });
    let parts = all.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "fixed" && what.slots.len() == 1 => {
            let own = what.slot(Slot::FixedIn) == Some(carrier) && d.extent == Extent::Document;
            subjects.iter().filter(|_| own).collect()
        }
        _ => vec![],
    });
    let own = std::iter::once(carrier).chain(others);
    own.chain(parts).collect()
}

/// Whether a point is fixed in one of some things that do not move against each other.
fn is_fixed(point: &Term, things: &[&Term], all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } if subjects.contains(point) => {
            let centre = what.head == MASS_CENTRE;
            let centre = what.all(Slot::Of).filter(|_| centre);
            centre
                .chain(what.all(Slot::FixedIn))
                .any(|of| things.contains(&of))
        }
        _ => false,
    })
}

/// The number of the axis of a frame along which something is, and whether it goes against that.
fn axis_along(along: &Term, base: &Term, all: &[Declaration]) -> Option<(usize, bool)> {
    let own = |along: &Term| match along {
        Term::Phrase(axis) if axis.slot(Slot::Of) == Some(base) => match axis.slot(Slot::Which)? {
            Term::Numbers(numbers) if axis.head == "axis" => numbers.first().copied(),
            _ => None,
        },
        along => all
            .iter()
            .find_map(|d| number_of(&d.statement, along, base)),
    };
    let Term::Phrase(phrase) = along else {
        let told = direction_of(along, all)?;
        return (told.frame == *base).then_some((told.number, told.reversed));
    };
    if phrase.head == "axis" {
        return match (phrase.slot(Slot::Of)?, phrase.slot(Slot::Which)?) {
            (of, Term::Numbers(numbers)) if of == base => numbers
                .first()
                .map(|number| (*number, phrase.is("negative"))),
            (of, along) if of == base => Some((own(along)?, phrase.is("negative"))),
            _ => None,
        };
    }
    if phrase.head != VERTICAL {
        return None;
    }
    let upright = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if what.head == VERTICAL => {
            let up = direction(what)?;
            let ([axis], []) = (subjects.as_slice(), what.slots.as_slice()) else {
                return None;
            };
            Some((own(axis)?, up))
        }
        _ => None,
    };
    let (number, up) = all.iter().find_map(upright)?;
    Some((number, up != direction(phrase)?))
}

/// Whether a vertical points up, if it is said.
fn direction(vertical: &NounPhrase) -> Option<bool> {
    match (vertical.is("upward"), vertical.is("downward")) {
        (true, false) => Some(true),
        (false, true) => Some(false),
        _ => None,
    }
}

/// "The first axis of A and the first axis of N are the same at `$q = 0$`", where A turns relative to N by q.
fn says_axes_are_same(statement: &Statement, all: &[Declaration]) -> bool {
    let told = points_at_zero(statement).or_else(|| same_at_zero(statement));
    let Some((one, other, zero)) = told else {
        return false;
    };
    let same = |own: (&Term, &Term), against: (&Term, &Term)| {
        let all_of = |(term, of): (&Term, &Term)| axes_of(term) == Some(of);
        let [one, other] = [own, against].map(|(term, of)| axis_along(term, of, all));
        one.is_some() && one == other || all_of(own) && all_of(against)
    };
    let mut turns = all.iter().filter_map(|d| turn(&d.statement, zero));
    turns.any(|(carrier, base)| {
        let mut own = carried_by(carrier, all).into_iter();
        own.any(|own| same((one, own), (other, base)) || same((other, own), (one, base)))
    })
}

/// The axes that are said to be the same under a condition, and the condition.
pub(super) fn same_at_zero(statement: &Statement) -> Option<(&Term, &Term, &Formula)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let Some(Term::Formula(zero)) = what.slot(Slot::At).filter(|at| at.is_condition()) else {
        return None;
    };
    match (subjects.as_slice(), what.slots.as_slice(), what.head) {
        ([one, other], [_], "same") => Some((one, other, zero)),
        // "The axes of B are the axes of N at `$q = 0$`", where both name the frame alone.
        ([one], [(Slot::Of, frame), _], "axes") => {
            axes_of(one)?;
            Some((one, frame, zero))
        }
        _ => None,
    }
}

/// The frame of all its axes; a frame stands for them.
fn axes_of(axes: &Term) -> Option<&Term> {
    match axes {
        Term::Phrase(phrase) if phrase.head == "axes" && phrase.slots.len() == 1 => {
            phrase.slot(Slot::Of)
        }
        Term::Phrase(_) => None,
        frame => Some(frame),
    }
}
