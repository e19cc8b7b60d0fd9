//! Angles about an axis, from a direction to the vector between two points: where the second point is.

use super::heads::{MASS_CENTRE, VERTICAL};
use super::planar_axes::{axes_of, tells_distance};
use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use super::turned_lines::direction;
use crate::notation::Macros;
use std::collections::BTreeMap;

/// "`$\theta$` is the angle about z from x to `$r$`", where r is the position of P from O, a letter is its magnitude or the
/// distance of these points, and the body of P turns about z: P is placed from O by that magnitude, along x turned about z by the angle. An angle may begin at
/// a vector that is told so. Where another angle of the vector is told, the first is an azimuth, and nothing is said.
pub(super) fn place_by_angles(declarations: &mut [Declaration], macros: &Macros) {
    let mut told: BTreeMap<String, Turned> = BTreeMap::new();
    let mut before = usize::MAX;
    while told.len() != before {
        before = told.len();
        for at in 0..declarations.len() {
            if let Some((vector, direction, placed)) =
                placed(&declarations[at].statement, declarations, &told, macros)
                && !told.contains_key(&vector)
            {
                told.insert(vector, direction);
                declarations[at].statement = placed;
            }
        }
    }
}

/// A direction across an axis, and that to which it turns about the axis by a right angle.
#[derive(Clone)]
struct Turned {
    along: String,
    across: String,
}

impl Turned {
    fn by(&self, angle: &str) -> Self {
        let Self { along, across } = self;
        let sum = |one: &str, sign: &str, other: &str| {
            let terms = format!(
                "\\cos\\left({angle}\\right)\\left({one}\\right){sign}\\sin\\left({angle}\\right)\\left({other}\\right)"
            );
            format!("\\left({terms}\\right)")
        };
        Self {
            along: sum(along, "+", across),
            across: sum(across, "-", along),
        }
    }
}

/// The vector of an angle, along what it lies, and what is said of the points.
fn placed(
    statement: &Statement,
    declarations: &[Declaration],
    told: &BTreeMap<String, Turned>,
    macros: &Macros,
) -> Option<(String, Turned, Statement)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(angle)], "angle") = (subjects.as_slice(), what.head) else {
        return None;
    };
    let ends = [Slot::RelativeTo, Slot::To, Slot::About].map(|slot| what.slot(slot));
    let ([Some(from), Some(Term::Formula(to)), Some(about)], 3) = (ends, what.slots.len()) else {
        return None;
    };
    let vector = to.source.clone();
    let (point, origin) = position(&vector, declarations)?;
    let planar = turns_about(&point, about, declarations);
    if !planar || angles_to(&vector, declarations) != 1 {
        return None;
    }
    let distance = || distance(&point, &origin, declarations);
    let magnitude = magnitude(&vector, declarations).or_else(distance)?;
    let start = match written(from, declarations) {
        Some(letter) if told.contains_key(&letter) => told.get(&letter).cloned()?,
        Some(along) => Turned {
            across: across(about, from, &along, declarations)?,
            along,
        },
        None => return None,
    };
    let direction = start.by(&angle.source);
    let way = formula(&format!("{magnitude}{}", direction.along), false, macros)?;
    let slots = vec![(Slot::From, origin), (Slot::By, Term::Formula(way))];
    let placed = Statement::Does {
        subjects: vec![point],
        verb: "place",
        slots,
    };
    Some((vector, direction, placed))
}

/// Whether all turning of what a point is fixed in, or is the mass centre of, is told to be about an axis.
fn turns_about(point: &Term, axis: &Term, declarations: &[Declaration]) -> bool {
    let bodies = holders(point, declarations);
    let turning = declarations
        .iter()
        .filter_map(|d| d.statement.does("turn"))
        .filter(|(subjects, _)| subjects.iter().any(|turns| bodies.contains(turns)));
    let mut axes = turning
        .map(|(_, slots)| slot(slots, Slot::About))
        .peekable();
    let along = |about: &Term| direction_of(about) == axis;
    axes.peek().is_some() && axes.all(|about| about.is_some_and(along))
}

/// What a point is fixed in, or is the mass centre of, with the frames that are fixed there and the bodies of such frames.
fn holders(point: &Term, declarations: &[Declaration]) -> Vec<Term> {
    let said = || {
        declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => Some((subjects, what)),
            _ => None,
        })
    };
    let own = said().filter(|(subjects, _)| subjects.contains(point));
    let held = own.flat_map(|(_, what)| match what.head {
        MASS_CENTRE => what.all(Slot::Of),
        _ => what.all(Slot::FixedIn),
    });
    let held: Vec<Term> = held.cloned().collect();
    let frames = said().filter(|(_, what)| what.head == "frame");
    let beside = frames.flat_map(|(frames, what)| {
        let bodies: Vec<&Term> = what.all(Slot::FixedIn).collect();
        let all = frames.iter().chain(bodies);
        let all: Vec<Term> = all.cloned().collect();
        match all.iter().any(|one| held.contains(one)) {
            true => all,
            false => vec![],
        }
    });
    let beside: Vec<Term> = beside.collect();
    [held, beside].concat()
}

/// "the axis through O along z" as its direction.
pub(super) fn direction_of(about: &Term) -> &Term {
    match about {
        Term::Phrase(axis) if axis.head == "axis" => axis.slot(Slot::Along).unwrap_or(about),
        _ => about,
    }
}

/// How many sentences tell an angle to a vector, or between it and something else.
fn angles_to(vector: &str, declarations: &[Declaration]) -> usize {
    let ends = |phrase: &NounPhrase| {
        let other = phrase
            .slots
            .iter()
            .filter(|(slot, _)| !matches!(slot, Slot::RelativeTo | Slot::About));
        phrase.head == "angle"
            && other
                .map(|(_, term)| term)
                .any(|term| matches!(term, Term::Formula(end) if end.source == vector))
    };
    let tells = |d: &&Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let named = |term: &Term| matches!(term, Term::Phrase(phrase) if ends(phrase));
            ends(what) || subjects.iter().any(named)
        }
        _ => false,
    };
    declarations.iter().filter(tells).count()
}

/// A direction as a formula writes it.
fn written(term: &Term, declarations: &[Declaration]) -> Option<String> {
    match term {
        Term::Formula(formula) => Some(formula.source.clone()),
        Term::Name(name) => (name.chars().count() == 1).then(|| name.clone()),
        Term::Phrase(phrase) if phrase.head == VERTICAL => {
            let along = direction(term, declarations)?;
            let axis = axes_of(&along.frame, declarations)?.get(along.number - 1)?;
            let axis = written(axis, declarations)?;
            Some(match along.reversed {
                true => format!("-{axis}"),
                false => axis,
            })
        }
        _ => None,
    }
}

/// What stands across an axis and a direction: the third axis where both are axes of a frame, else by their cross product.
fn across(about: &Term, from: &Term, along: &str, declarations: &[Declaration]) -> Option<String> {
    let axis = || {
        let (about, from) = (
            direction(about, declarations)?,
            direction(from, declarations)?,
        );
        let beside = about.frame == from.frame && about.number != from.number;
        let number = 6 - about.number - from.number;
        let axes = axes_of(&about.frame, declarations).filter(|_| beside)?;
        let forwards = from.number == about.number % 3 + 1;
        let third = written(axes.get(number.checked_sub(1)?)?, declarations)?;
        let reversed = [about.reversed, from.reversed, !forwards];
        let odd = reversed.iter().filter(|turned| **turned).count() % 2 == 1;
        Some(if odd { format!("-{third}") } else { third })
    };
    axis().or_else(|| {
        let about = written(about, declarations)?;
        Some(format!(
            "\\left({about}\\right)\\times\\left({along}\\right)"
        ))
    })
}

/// Of which point from where a vector is the position.
fn position(vector: &str, declarations: &[Declaration]) -> Option<(Term, Term)> {
    let (_, what) = said_of(declarations, "position").find(|(letter, _)| *letter == vector)?;
    let from = what
        .slot(Slot::From)
        .or_else(|| what.slot(Slot::RelativeTo))?;
    Some((what.slot(Slot::Of)?.clone(), from.clone()))
}

/// The letter of the magnitude of a vector.
fn magnitude(vector: &str, declarations: &[Declaration]) -> Option<String> {
    let of = |what: &NounPhrase| match what.slot(Slot::Of) {
        Some(Term::Formula(of)) => of.source == vector,
        _ => false,
    };
    let mut all = said_of(declarations, "magnitude");
    all.find(|(_, what)| of(what))
        .map(|(letter, _)| letter.to_owned())
}

/// The letter of the distance between two points.
fn distance(of: &Term, from: &Term, declarations: &[Declaration]) -> Option<String> {
    let told = declarations.iter().find_map(|d| match &d.statement {
        said @ Statement::Is { .. } => {
            let (one, other, letter) = tells_distance(said)?;
            let ends = [(one, other), (other, one)];
            ends.contains(&(of, from)).then_some(letter)
        }
        _ => None,
    });
    match told? {
        Term::Formula(letter) => Some(letter.source.clone()),
        _ => None,
    }
}

/// The single letters that are said to be what a noun names.
fn said_of<'d>(
    declarations: &'d [Declaration],
    head: &'static str,
) -> impl Iterator<Item = (&'d str, &'d NounPhrase)> {
    declarations.iter().filter_map(move |d| match &d.statement {
        Statement::Is { subjects, what } if what.head == head => match subjects.as_slice() {
            [Term::Formula(letter)] => Some((letter.source.as_str(), what)),
            _ => None,
        },
        _ => None,
    })
}
