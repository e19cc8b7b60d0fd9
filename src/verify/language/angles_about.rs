//! Angles about an axis, from a direction to the vector between two points: where the second point is.

use super::heads::MASS_CENTRE;
use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;
use std::collections::BTreeMap;

/// "`$\theta$` is the angle about z from x to `$r$`", where r is the position of P from O, a letter is its magnitude, and the
/// body of P turns about z: P is placed from O by that magnitude, along x turned about z by the angle. An angle may begin at
/// a vector that is told so. Where another angle of the vector is told, the first is an azimuth, and nothing is said.
pub(super) fn place_by_angles(declarations: &mut [Declaration], macros: &Macros) {
    let mut told: BTreeMap<String, String> = BTreeMap::new();
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

/// The vector of an angle, along what it lies, and what is said of the points.
fn placed(
    statement: &Statement,
    declarations: &[Declaration],
    told: &BTreeMap<String, String>,
    macros: &Macros,
) -> Option<(String, String, Statement)> {
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
    let magnitude = magnitude(&vector, declarations)?;
    let about = written(about)?;
    let from = written(from)?;
    let from = told.get(&from).cloned().unwrap_or(from);
    let angle = &angle.source;
    let direction = format!(
        "\\left(\\cos\\left({angle}\\right)\\left({from}\\right)+\\sin\\left({angle}\\right)\\left({about}\\right)\\times\\left({from}\\right)\\right)"
    );
    let way = formula(&format!("{magnitude}{direction}"), false, macros)?;
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
    let holds = |declaration: &Declaration| match &declaration.statement {
        Statement::Is { subjects, what } if subjects.contains(point) => {
            let holder = match what.head {
                MASS_CENTRE => Slot::Of,
                _ => Slot::FixedIn,
            };
            what.all(holder).cloned().collect()
        }
        _ => vec![],
    };
    let bodies: Vec<Term> = declarations.iter().flat_map(holds).collect();
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
fn written(term: &Term) -> Option<String> {
    match term {
        Term::Formula(formula) => Some(formula.source.clone()),
        Term::Name(name) => (name.chars().count() == 1).then(|| name.clone()),
        _ => None,
    }
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
