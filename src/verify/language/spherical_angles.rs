//! Lines that are told by two angles: by that with an upright axis, and by that of what they cast on the plane across it.

use super::heads::{POSITIVE_ABOUT, UNIT_VECTOR, VERTICAL};
use super::kinds::{is_said_to_be_body, name};
use super::planar_axes::{axis, turns_by};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::leave_out;
use super::turned_lines::{Direction, direction};
use crate::notation::Macros;

/// What runs between two points and may be spoken of without them.
const RUNS: [&str; 8] = [
    "rod", "string", "thread", "cord", "wire", "cable", "rope", "arm",
];

/// The angle between an upright direction and the line from one point to another.
struct Polar {
    upright: Direction,
    by: Formula,
    line: Term,
    ends: [Term; 2],
    said: usize,
}

/// The angle from an axis across the upright one to where the line points in the plane, and whether it is counted about the
/// upright axis or against that.
struct Azimuth {
    from: usize,
    by: Formula,
    forwards: bool,
    said: usize,
}

/// "`$\theta$` is the angle between z and the line from O to P; `$\phi$` is the angle from x to its projection on the plane of x
/// and y, counted about z": a frame turns about z by φ, another one in it by θ, and P lies along the axis of that.
pub(super) fn place_by_spherical_angles(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let polars = (0..declarations.len()).filter_map(|at| polar(at, declarations));
    let told = polars.filter_map(|polar| {
        let all = 0..declarations.len();
        let mut azimuths = all.filter_map(|at| azimuth(at, &polar, declarations));
        let azimuth = azimuths.next().filter(|_| azimuths.next().is_none())?;
        let told = statements(&polar, &azimuth, declarations, macros)?;
        Some((told, [polar.said, azimuth.said]))
    });
    let mut told: Vec<(Vec<Statement>, [usize; 2])> = told.collect();
    let (Some((told, used)), true) = (told.pop(), told.is_empty()) else {
        return;
    };
    let own = declarations[used[0]].clone();
    leave_out(declarations, &used);
    declarations.extend(told.into_iter().map(|statement| own.saying(statement)));
}

/// The letter and the noun of an angle that a sentence tells.
fn angle(statement: &Statement) -> Option<(&Formula, &NounPhrase)> {
    match statement {
        Statement::Is { subjects, what } if what.head == "angle" => match subjects.as_slice() {
            [Term::Formula(letter)] => Some((letter, what)),
            _ => None,
        },
        _ => None,
    }
}

fn polar(said: usize, declarations: &[Declaration]) -> Option<Polar> {
    let (by, what) = angle(&declarations[said].statement)?;
    let ends: Vec<&Term> = match what.slots.as_slice() {
        [(Slot::Between, one), (Slot::Between, other)]
        | [(Slot::RelativeTo, one), (Slot::To, other)] => vec![one, other],
        _ => return None,
    };
    let &[one, other] = ends.as_slice() else {
        return None;
    };
    let pairs = [(one, other), (other, one)].into_iter();
    let mut fits = pairs.filter_map(|(upright, line)| {
        let upright = direction(upright, declarations)?;
        Some(Polar {
            by: by.clone(),
            ends: ends_of(line, declarations)?,
            line: line.clone(),
            upright,
            said,
        })
    });
    fits.next()
}

/// The points from which and to which a line runs: "the axis from O to P", or a unit vector that is told so.
fn ends_of(line: &Term, declarations: &[Declaration]) -> Option<[Term; 2]> {
    let between =
        |way: &NounPhrase| Some([way.slot(Slot::From)?.clone(), way.slot(Slot::To)?.clone()]);
    if let Term::Phrase(way) = line {
        return between(way).filter(|_| way.head == "axis");
    }
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == UNIT_VECTOR => {
            between(what).filter(|_| subjects.contains(line))
        }
        _ => None,
    })
}

fn azimuth(said: usize, polar: &Polar, declarations: &[Declaration]) -> Option<Azimuth> {
    let (by, what) = angle(&declarations[said].statement)?;
    let from = direction(what.slot(Slot::RelativeTo)?, declarations)?;
    let Term::Phrase(part) = what.slot(Slot::To)? else {
        return None;
    };
    let upright = &polar.upright;
    let level = from.frame == upright.frame && from.number != upright.number && !from.reversed;
    if said == polar.said || !level || part.head != "part" || !is_cast_by(part, polar, declarations)
    {
        return None;
    }
    let planes: Vec<&Term> = [Slot::On, Slot::In]
        .iter()
        .flat_map(|s| part.all(*s))
        .collect();
    let [Term::Phrase(plane)] = planes.as_slice() else {
        return None;
    };
    if !is_across(plane, upright, declarations) {
        return None;
    }
    let sense = what.slots.iter().find_map(|(_, term)| match term {
        Term::Phrase(sense) if sense.head == POSITIVE_ABOUT => sense.slot(Slot::Of),
        _ => None,
    });
    let about = direction(sense.or(what.slot(Slot::About))?, declarations)?;
    let own = about.frame == upright.frame && about.number == upright.number;
    own.then(|| Azimuth {
        from: from.number,
        by: by.clone(),
        forwards: !about.reversed,
        said,
    })
}

/// Whether what is cast on the plane is the line, its end, or what runs along it and is no body of its own.
fn is_cast_by(part: &NounPhrase, polar: &Polar, declarations: &[Declaration]) -> bool {
    let Some(of) = part.slot(Slot::Of) else {
        return false;
    };
    let runs = match of {
        Term::Phrase(thing) => thing.slots.is_empty() && RUNS.contains(&thing.head),
        Term::Name(thing) => RUNS.contains(&thing.as_str()),
        _ => false,
    };
    let alone = runs && !is_said_to_be_body(of, declarations);
    alone || *of == polar.line || *of == polar.ends[1]
}

/// Whether a plane lies across an axis: that of the two others, or a horizontal one where the axis is vertical.
fn is_across(plane: &NounPhrase, upright: &Direction, declarations: &[Declaration]) -> bool {
    let own = |axis: &Direction| axis.frame == upright.frame;
    if plane.is("horizontal") {
        return declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == VERTICAL => {
                let axes = subjects.iter().filter_map(|s| direction(s, declarations));
                axes.into_iter()
                    .any(|a| own(&a) && a.number == upright.number)
            }
            _ => false,
        });
    }
    let axes = plane
        .all(Slot::Of)
        .filter_map(|axis| direction(axis, declarations));
    let axes: Vec<Direction> = axes.collect();
    let beside = |axis: &Direction| own(axis) && axis.number != upright.number;
    plane.head == "plane"
        && axes.len() == 2
        && axes.iter().all(beside)
        && axes[0].number != axes[1].number
}

/// How far one point is from the other, as another sentence says.
fn distance(ends: &[Term; 2], declarations: &[Declaration]) -> Option<Term> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "distance" && what.slots.len() == 2 => {
            let from = what.slot(Slot::RelativeTo).or(what.slot(Slot::From));
            let (of, from) = (what.slot(Slot::Of)?, from?);
            let own = [of, from].into_iter().all(|end| ends.contains(end)) && of != from;
            subjects
                .first()
                .filter(|_| own && subjects.len() == 1)
                .cloned()
        }
        _ => None,
    })
}

fn statements(
    polar: &Polar,
    azimuth: &Azimuth,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<Vec<Statement>> {
    let (up, from) = (polar.upright.number, azimuth.from);
    let [start, end] = &polar.ends;
    let far = distance(&polar.ends, declarations)?;
    // From the upright axis towards the other one, about the third.
    let forwards = from == up % 3 + 1;
    let leant = match (polar.upright.reversed, forwards) {
        (false, true) => polar.by.source.clone(),
        (false, false) => format!("-{}", polar.by.source),
        (true, true) => format!("\\pi-{}", polar.by.source),
        (true, false) => format!("{}-\\pi", polar.by.source),
    };
    let turned = match azimuth.forwards {
        true => azimuth.by.source.clone(),
        false => format!("-{}", azimuth.by.source),
    };
    let level = Term::Name(format!("level {}", name(end)?));
    let leaning = Term::Name(format!("leaning {}", name(end)?));
    let turn = |frame: &Term, from: &Term, about: usize, by: &str| {
        let by = Term::Formula(formula(by, false, macros)?);
        Some(turns_by(frame, from, axis(about, Some(from)), by))
    };
    let away = NounPhrase::new("distance", vec![(Slot::Which, far)]);
    let placed = Statement::Does {
        subjects: vec![end.clone()],
        verb: "lie",
        slots: vec![
            (Slot::At, Term::Phrase(Box::new(away))),
            (Slot::From, start.clone()),
            (Slot::Along, axis(up, Some(&leaning))),
        ],
    };
    let frame = |frame: &Term| Statement::one_is(frame.clone(), NounPhrase::new("frame", vec![]));
    Some(vec![
        frame(&level),
        frame(&leaning),
        turn(&level, &polar.upright.frame, up, &turned)?,
        turn(&leaning, &level, 6 - up - from, &leant)?,
        placed,
    ])
}
