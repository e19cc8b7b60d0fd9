//! Rods of which a sentence says where they point when an angle is zero: "The rod hangs from O at `$\theta=0$`", of a rod that
//! turns by θ. It always lies along that axis of what turns.

use super::at_zero::turns_by;
use super::heads::{MASS_CENTRE, UNIT_VECTOR, VERTICAL, VERTICALLY_ABOVE};
use super::hung_ends::{is_only_end, place_other_ends};
use super::planar_axes::{axis, vertical};
use super::reader::formula;
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term, slot};
use super::traits::{Trait, has};
use super::turned_lines::{Direction, direction};
use crate::notation::Macros;

/// A rod at the zero of an angle: which way it points then, and from which of its ends.
struct Hung {
    rod: Term,
    from: Option<Term>,
    towards: Term,
    /// The condition, where it is not said to be so always.
    zero: Option<Formula>,
}

/// Lays each such rod along an axis of what turns.
pub(super) fn lay_hung_rods(declarations: &mut Vec<Declaration>, macros: &Macros) {
    name_rod_lines(declarations);
    let mut at = 0;
    while at < declarations.len() {
        let hung = hung(&declarations[at].statement, declarations, macros);
        match hung.and_then(|hung| laid(&hung, declarations)) {
            Some((rod, slots)) => {
                declarations.remove(at);
                // Where it begins says which end that is.
                declarations.retain(|d| !is_only_end(&d.statement, &rod, &slots));
                place_other_ends(&rod, &slots, declarations);
                for declaration in declarations.iter_mut() {
                    if let Some(what) = shape_of(&rod, &mut declaration.statement) {
                        what.slots.extend(slots.clone());
                        break;
                    }
                }
            }
            None => at += 1,
        }
    }
}

/// What a statement says of a rod at the zero of an angle.
fn hung(statement: &Statement, all: &[Declaration], macros: &Macros) -> Option<Hung> {
    let hung = match statement {
        Statement::Does {
            subjects,
            verb,
            slots,
        } => hung_by_verb(subjects, verb, slots, all)?,
        Statement::Is { subjects, what } if what.head == VERTICAL => Hung {
            rod: subjects.first()?.clone(),
            from: None,
            towards: along_vertical(sense_of(what)?),
            zero: Some(condition(&what.slots)?),
        },
        Statement::Is { subjects, what } if what.head == "angle" => {
            hung_by_angle(subjects, what, all, macros)?
        }
        _ => return None,
    };
    let hung = of_its_rod(hung, all);
    // Where a vector is along the rod its sentence tells the place.
    let told_by_vector = all.iter().any(|d| match &d.statement {
        Statement::Is { what, .. } => {
            what.head == UNIT_VECTOR && what.slot(Slot::Along) == Some(&hung.rod)
        }
        _ => false,
    });
    let mut shapes = all.iter().filter(|_| !told_by_vector);
    shapes
        .any(|d| is_rod(&hung.rod, &d.statement))
        .then_some(hung)
}

fn sense_of(vertical: &NounPhrase) -> Option<&'static str> {
    match (vertical.is("upward"), vertical.is("downward")) {
        (true, false) => Some("upward"),
        (false, true) => Some("downward"),
        _ => None,
    }
}

/// "The pendulum hangs down", of a body with one rod among its parts: that does.
fn of_its_rod(hung: Hung, all: &[Declaration]) -> Hung {
    let parts = all.iter().find_map(|d| match d.statement.does("consist")? {
        ([whole], parts) if *whole == hung.rod => Some(parts),
        _ => None,
    });
    let parts = parts.into_iter().flatten().map(|(_, part)| part);
    let mut rods = parts.filter(|part| all.iter().any(|d| is_rod(part, &d.statement)));
    match (rods.next(), rods.next()) {
        (Some(rod), None) => Hung {
            rod: rod.clone(),
            ..hung
        },
        _ => hung,
    }
}

/// "The rod hangs from O", "the rod lies along x from O", "G lies below O", each at the zero of an angle.
fn hung_by_verb(
    subjects: &[Term],
    verb: &str,
    slots: &[(Slot, Term)],
    all: &[Declaration],
) -> Option<Hung> {
    let [subject] = subjects else { return None };
    let from = slot(slots, Slot::From).cloned();
    let known =
        |(slot, _): &(Slot, Term)| matches!(slot, Slot::From | Slot::At | Slot::Along | Slot::With);
    let one_condition = slots.iter().filter(|(s, _)| *s == Slot::At).count() < 2;
    let zero = condition(slots);
    if !slots.iter().all(known)
        || !one_condition
        || slot(slots, Slot::At).is_some() != zero.is_some()
    {
        return None;
    }
    match (verb, slot(slots, Slot::Along), slot(slots, Slot::With)) {
        ("hang", None, None) => Some(Hung {
            rod: subject.clone(),
            from,
            towards: along_vertical("downward"),
            zero: Some(zero?),
        }),
        ("point" | "lie", Some(along), None) => {
            let (along, behind) = without_start(along);
            let from = from.or(behind);
            (zero.is_some() || from.is_some()).then(|| Hung {
                rod: subject.clone(),
                from,
                towards: along,
                zero,
            })
        }
        ("lie", None, Some(Term::Phrase(place))) => {
            let towards = match place.head {
                "below" => along_vertical("downward"),
                VERTICALLY_ABOVE => along_vertical("upward"),
                _ => return None,
            };
            let end = place.slot(Slot::Of)?;
            Some(Hung {
                rod: rod_between(end, subject, all)?,
                from: Some(end.clone()),
                towards,
                zero: Some(zero?),
            })
        }
        _ => None,
    }
}

/// "the second axis of B from O" as the axis and the point.
fn without_start(along: &Term) -> (Term, Option<Term>) {
    let mut along = along.clone();
    let mut start = None;
    if let Term::Phrase(axis) = &mut along
        && axis.slot(Slot::Which).is_some()
    {
        start = axis.slot(Slot::From).cloned();
        axis.slots.retain(|(slot, _)| *slot != Slot::From);
    }
    (along, start)
}

fn along_vertical(sense: &'static str) -> Term {
    Term::Phrase(Box::new(vertical(sense)))
}

/// "`$\theta$` is the angle about z from the downward vertical to the rod", of a rod that turns about z by θ.
fn hung_by_angle(
    subjects: &[Term],
    what: &NounPhrase,
    all: &[Declaration],
    macros: &Macros,
) -> Option<Hung> {
    let ([Term::Formula(letter)], Some(rod)) = (subjects, what.slot(Slot::To)) else {
        return None;
    };
    let about = what.slot(Slot::About)?;
    let known =
        |(slot, _): &(Slot, Term)| matches!(slot, Slot::RelativeTo | Slot::About | Slot::To);
    let zero = formula(&format!("{}=0", letter.source), false, macros)?;
    let turns = what.slots.iter().all(known) && turns_about(rod, about, &zero, all);
    Some(Hung {
        rod: rod.clone(),
        from: None,
        towards: what.slot(Slot::RelativeTo)?.clone(),
        zero: Some(Some(zero).filter(|_| turns)?),
    })
}

/// The rod of which one point is an end and the other one the other end or the mass centre.
fn rod_between(end: &Term, other: &Term, all: &[Declaration]) -> Option<Term> {
    let mut rods = all.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "end" && subjects.contains(end) => {
            what.slot(Slot::Of)
        }
        _ => None,
    });
    let reaches = |rod: &&Term| {
        all.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if matches!(what.head, "end" | MASS_CENTRE) => {
                what.slot(Slot::Of) == Some(*rod) && subjects.contains(other)
            }
            _ => false,
        })
    };
    rods.find(reaches).cloned()
}

/// "`$\theta$` is the angle from y to the line from O to A", where O and A are the ends of a rod and O is fixed: it is that to
/// the rod.
pub(super) fn name_rod_lines(declarations: &mut [Declaration]) {
    let lines: Vec<Option<Term>> = declarations
        .iter()
        .map(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == "angle" => {
                let to = what.slot(Slot::To).or_else(|| what.slot(Slot::Of))?;
                line_of_rod(to, declarations)
            }
            _ => None,
        })
        .collect();
    for (declaration, rod) in declarations.iter_mut().zip(lines) {
        if let (Statement::Is { what, .. }, Some(rod)) = (&mut declaration.statement, rod) {
            let mut to = what.slots.iter_mut();
            let to = to.find(|(slot, _)| matches!(slot, Slot::To | Slot::Of));
            to.into_iter().for_each(|(_, to)| to.clone_from(&rod));
        }
    }
}

/// The rod along which a line leads from the end that is fixed.
fn line_of_rod(line: &Term, all: &[Declaration]) -> Option<Term> {
    let told = match line {
        Term::Phrase(way) if way.head == "axis" => Some(&**way),
        _ => None,
    };
    let way = told.filter(|way| way.slots.len() == 2)?;
    let (from, to) = (way.slot(Slot::From)?, way.slot(Slot::To)?);
    let rod = rod_between(from, to, all).filter(|_| is_fixed(from, all))?;
    let is_long = all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            has(what.head, Trait::Slender) && subjects.contains(&rod)
        }
        _ => false,
    });
    is_long.then_some(rod)
}

/// Where the rod lies in what turns by the angle: from which end, and along which axis.
fn laid(hung: &Hung, all: &[Declaration]) -> Option<(Term, Vec<(Slot, Term)>)> {
    let towards = direction(&hung.towards, all).or_else(|| numbered(&hung.towards))?;
    let mut carriers = carriers(&hung.rod, all).into_iter();
    let carrier = carriers.find(|carrier| match &hung.zero {
        None => *carrier == towards.frame,
        Some(zero) => {
            let bases = all.iter().map(|d| turns_by(&d.statement, carrier, zero));
            bases.into_iter().any(|base| base == Some(&towards.frame))
        }
    })?;
    let from = match &hung.from {
        Some(from) => from.clone(),
        None => only_end(&hung.rod, all)?,
    };
    let along = axis_of(&carrier, &towards);
    Some((
        hung.rod.clone(),
        vec![(Slot::From, from), (Slot::Along, along)],
    ))
}

/// "the negative second axis of B"
fn numbered(term: &Term) -> Option<Direction> {
    let Term::Phrase(axis) = term else {
        return None;
    };
    match axis.slot(Slot::Which)? {
        Term::Numbers(numbers) if axis.head == "axis" && numbers.len() == 1 => Some(Direction {
            frame: axis.slot(Slot::Of)?.clone(),
            number: *numbers.first()?,
            reversed: axis.is("negative"),
        }),
        _ => None,
    }
}

fn axis_of(carrier: &Term, towards: &Direction) -> Term {
    let mut along = axis(towards.number, Some(carrier));
    if let (true, Term::Phrase(axis)) = (towards.reversed, &mut along) {
        axis.adjectives.push("negative");
    }
    along
}

/// The rod, the body of which it is a part that is fixed in it, and the frames that are fixed in these.
fn carriers(rod: &Term, all: &[Declaration]) -> Vec<Term> {
    let fixed = |head: &'static str| {
        all.iter().filter_map(move |d| match &d.statement {
            Statement::Is { subjects, what }
                if what.head == head && d.extent == Extent::Document =>
            {
                Some((subjects.first()?, what.slot(Slot::FixedIn)?))
            }
            _ => None,
        })
    };
    let wholes = fixed("fixed").filter(|(part, _)| *part == rod);
    let bodies: Vec<&Term> = std::iter::once(rod)
        .chain(wholes.map(|(_, whole)| whole))
        .collect();
    let frames = fixed("frame").filter(|(_, body)| bodies.contains(body));
    let frames = frames.map(|(frame, _)| frame);
    bodies.iter().copied().chain(frames).cloned().collect()
}

/// Whether the rod, or a frame fixed in it, turns by the angle about an axis, and not the other way round.
fn turns_about(rod: &Term, about: &Term, zero: &Formula, all: &[Declaration]) -> bool {
    let Some(about) = direction(about, all) else {
        return false;
    };
    carriers(rod, all).iter().any(|carrier| {
        all.iter().any(|d| {
            let turns = turns_by(&d.statement, carrier, zero).is_some();
            let own = d.statement.does("turn").filter(|_| turns);
            let own = own.and_then(|(_, slots)| direction(slot(slots, Slot::About)?, all));
            own.is_some_and(|own| own.number == about.number && own.reversed == about.reversed)
        })
    })
}

/// The one point that is said to be an end of the rod, or the one of two that is fixed.
fn only_end(rod: &Term, all: &[Declaration]) -> Option<Term> {
    let told = all.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "end" => {
            let own = what.slot(Slot::Of) == Some(rod);
            subjects.iter().filter(move |_| own).collect()
        }
        _ => vec![],
    });
    let ends: Vec<&Term> = told.collect();
    let mut fixed = ends.iter().filter(|end| is_fixed(end, all));
    match (ends.as_slice(), fixed.next(), fixed.next()) {
        ([end], _, _) => Some((*end).clone()),
        ([_, _], Some(end), None) => Some((*end).clone()),
        _ => None,
    }
}

/// Whether a sentence says that a point is fixed in something.
fn is_fixed(point: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            what.slot(Slot::FixedIn).is_some() && subjects.contains(point)
        }
        _ => false,
    })
}

fn condition(slots: &[(Slot, Term)]) -> Option<Formula> {
    slots.iter().find_map(|(slot, at)| match (slot, at) {
        (Slot::At, Term::Formula(zero)) if at.is_condition() => Some(zero.clone()),
        _ => None,
    })
}

pub(super) fn is_rod(rod: &Term, statement: &Statement) -> bool {
    matches!(statement, Statement::Is { subjects, what }
        if has(what.head, Trait::Slender)
            && subjects.as_slice() == [rod.clone()]
            && what.size("length").is_some()
            && what.slot(Slot::From).is_none()
            && what.slot(Slot::Along).is_none())
}

fn shape_of<'s>(rod: &Term, statement: &'s mut Statement) -> Option<&'s mut NounPhrase> {
    match is_rod(rod, statement) {
        true => match statement {
            Statement::Is { what, .. } => Some(what),
            _ => None,
        },
        false => None,
    }
}
