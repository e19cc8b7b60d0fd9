//! Wheels that an arm carries round another one: the arm is as long as the radii tell, their sum outside and their difference
//! inside.

use super::heads::MASS_CENTRE;
use super::kinds::name;
use super::planar_axes::{axis, tells_distance};
use super::reader::formula;
use super::rolling_inside::roller_on;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::told_sizes::told_size;
use super::traits::{Trait, has};
use crate::notation::Macros;

/// A wheel that rolls on another one, with the centres of both and the arm that is called by these.
struct Planet {
    centre: Term,
    middle: Term,
    arm: Term,
    sun: Term,
    /// How far the centres are apart.
    gap: String,
    at: usize,
}

/// Places the centre of each such wheel along the arm. What it rolls on besides tells how the radii fit.
pub(super) fn place_planets(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let found: Vec<Planet> = (0..declarations.len())
        .filter_map(|at| planet(at, declarations))
        .collect();
    let mut placed: Vec<(Term, String)> = vec![];
    for planet in found {
        let said = declarations[planet.at].clone();
        let first = placed.iter().find(|(centre, _)| *centre == planet.centre);
        let statements = match first {
            Some((_, gap)) => {
                let same = formula(&format!("{gap}={}", planet.gap), true, macros);
                same.map(Statement::Holds).into_iter().collect()
            }
            None => statements(&planet, declarations, macros),
        };
        placed.push((planet.centre.clone(), planet.gap.clone()));
        declarations.extend(statements.into_iter().map(|s| said.saying(s)));
    }
}

fn planet(at: usize, all: &[Declaration]) -> Option<Planet> {
    let declaration = all.get(at).filter(|d| d.extent == Extent::Document)?;
    let (body, sun, side) = roller_on(&declaration.statement)?;
    let centre = centre(body, all)?;
    let middle = middle(sun, all)?;
    let arm = arm(&centre, &middle, all)?;
    let own = told_size("radius", body, all)?;
    let other = told_size("radius", sun, all)?;
    let sign = if side { "-" } else { "+" };
    let told = all.iter().any(|d| {
        let ends = tells_distance(&d.statement);
        let both = ends.is_some_and(|(one, other, _)| {
            [one, other].contains(&&centre) && [one, other].contains(&&middle)
        });
        both || places(&d.statement, &centre)
    });
    (!told).then(|| Planet {
        gap: format!("{}{sign}{}", other.source, own.source),
        centre,
        middle,
        arm,
        sun: sun.clone(),
        at,
    })
}

fn places(statement: &Statement, point: &Term) -> bool {
    match statement {
        Statement::Does {
            subjects,
            verb: "lie" | "place",
            slots,
        } => subjects.contains(point) && slot(slots, Slot::From).is_some(),
        _ => false,
    }
}

fn centre(body: &Term, all: &[Declaration]) -> Option<Term> {
    all.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if matches!(what.head, "centre" | MASS_CENTRE) => {
            (what.slot(Slot::Of) == Some(body)).then(|| subjects.first().cloned())?
        }
        _ => None,
    })
}

/// The centre of a wheel, or the point through which the axis goes about which it turns.
fn middle(sun: &Term, all: &[Declaration]) -> Option<Term> {
    let through = || {
        all.iter().find_map(|d| {
            let (subjects, slots) = d.statement.does("turn")?;
            let Term::Phrase(axis) = slot(slots, Slot::About)? else {
                return None;
            };
            let own = subjects.contains(sun) && axis.head == "axis";
            axis.slot(Slot::Through).filter(|_| own).cloned()
        })
    };
    centre(sun, all).or_else(through)
}

/// The body that is called by two points.
fn arm(one: &Term, other: &Term, all: &[Declaration]) -> Option<Term> {
    let (one, other) = (name(one)?, name(other)?);
    let names = [format!("{one}{other}"), format!("{other}{one}")].map(Term::Name);
    let known = |name: &Term| {
        all.iter().any(|d| match &d.statement {
            Statement::Is { subjects, .. } => subjects.contains(name),
            _ => false,
        })
    };
    names.into_iter().find(known)
}

fn statements(planet: &Planet, all: &[Declaration], macros: &Macros) -> Vec<Statement> {
    let Some(gap) = formula(&planet.gap, false, macros).map(Term::Formula) else {
        return vec![];
    };
    let mut told = vec![];
    if centre(&planet.sun, all).is_none() {
        let of = NounPhrase::new(MASS_CENTRE, vec![(Slot::Of, planet.sun.clone())]);
        told.push(Statement::one_is(planet.middle.clone(), of));
    }
    let rod = all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            has(what.head, Trait::Slender) && subjects.contains(&planet.arm)
        }
        _ => false,
    });
    let lies = all.iter().any(|d| {
        let lies = d.statement.does("lie");
        lies.is_some_and(|(subjects, _)| subjects.contains(&planet.arm))
    });
    if rod && lies {
        let length = NounPhrase::new("length", vec![(Slot::Of, planet.arm.clone())]);
        told.push(Statement::one_is(gap, length));
        return told;
    }
    let fixed = NounPhrase::new("point", vec![(Slot::FixedIn, planet.arm.clone())]);
    told.push(Statement::one_is(planet.middle.clone(), fixed));
    told.push(Statement::Does {
        subjects: vec![planet.centre.clone()],
        verb: "lie",
        slots: vec![
            (Slot::At, gap),
            (Slot::From, planet.middle.clone()),
            (Slot::Along, axis(1, Some(&planet.arm))),
        ],
    });
    told
}
