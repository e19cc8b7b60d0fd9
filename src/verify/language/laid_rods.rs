//! Rods that lie along an axis from one of their ends: where their middle and their other end are.

use super::heads::{MASS_CENTRE, POSITION, UNIT_VECTOR};
use super::kinds::name;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::told_sizes::told_size;
use super::traits::{Trait, has};
use crate::notation::Macros;

/// The noun of a point at which a rod ends.
const END: &str = "end";

/// "The handle lies along z from A", where A is an end of it: its other end is its length from there, and its mass centre half
/// of that if it is uniform.
pub(super) fn lay_rods(declarations: &mut Vec<Declaration>, macros: &Macros) {
    point_along_rods(declarations);
    end_rods(declarations);
    let mut at = 0;
    while at < declarations.len() {
        if let Some(rod) = laid(&declarations[at].statement, declarations) {
            lay(&rod, at, declarations, macros);
        }
        at += 1;
    }
}

/// A direction that a sentence tells by two points.
struct Way {
    along: Term,
    from: Term,
    to: Term,
    /// Whether nothing else is left of the sentence once a rod lies so.
    of_axis: bool,
}

/// "`$u$` is the unit vector from A to G", from an end of a rod to its mass centre or to its other end: the rod lies along u
/// from A. For an axis that points so that is all.
fn point_along_rods(declarations: &mut Vec<Declaration>) {
    let rods = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if has(what.head, Trait::Slender) => Some(subjects),
        _ => None,
    });
    let rods: Vec<Term> = rods.flatten().cloned().collect();
    for at in 0..declarations.len() {
        let Some(way) = way(&declarations[at].statement, declarations) else {
            continue;
        };
        let own = |rod: &&Term| {
            let named = is_named_by(rod, &way);
            let of_rod = |point: &Term| match way.of_axis {
                true => ends(rod, declarations).any(|end| end == point),
                false => is_called_end(point, rod, declarations),
            };
            let from = named || of_rod(&way.from);
            from && (named || of_rod(&way.to) || is_centre(&way.to, rod, declarations))
        };
        let Some(rod) = rods.iter().find(own).cloned() else {
            continue;
        };
        let mut slots = vec![
            (Slot::Along, way.along.clone()),
            (Slot::From, way.from.clone()),
        ];
        if is_named_by(&rod, &way) {
            slots.push((Slot::To, way.to.clone()));
        }
        let lies = Statement::Does {
            subjects: vec![rod],
            verb: "lie",
            slots,
        };
        match way.of_axis {
            true => declarations[at].statement = lies,
            false => declarations.push(declarations[at].saying(lies)),
        }
    }
}

fn way(statement: &Statement, declarations: &[Declaration]) -> Option<Way> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let [along] = subjects.as_slice() else {
        return None;
    };
    let of_axis = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head == "axes" && subjects.contains(along),
        _ => false,
    });
    let (from, to) = match what.head {
        UNIT_VECTOR => (what.slot(Slot::From)?, what.slot(Slot::To)?),
        // What an axis points along is no distance.
        POSITION if of_axis => {
            let from = what
                .slot(Slot::RelativeTo)
                .or_else(|| what.slot(Slot::From));
            (from?, what.slot(Slot::Of)?)
        }
        _ => return None,
    };
    Some(Way {
        along: along.clone(),
        from: from.clone(),
        to: to.clone(),
        of_axis,
    })
}

/// Whether a rod is called by the points of the way of an axis, as AB is from A to B.
fn is_named_by(rod: &Term, way: &Way) -> bool {
    if !way.of_axis {
        return false;
    }
    let named = |one: &Term, other: &Term| Some(format!("{}{}", name(one)?, name(other)?));
    let rod = name(rod);
    rod.is_some() && (rod == named(&way.from, &way.to) || rod == named(&way.to, &way.from))
}

/// "The beam lies along `$e$` from A to B": these are its ends.
fn end_rods(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for at in 0..declarations.len() {
        let Some(([rod], slots)) = declarations[at].statement.does("lie") else {
            continue;
        };
        let [along, from, to] = [Slot::Along, Slot::From, Slot::To].map(|slot| {
            let mut own = slots.iter().filter(|(own, _)| *own == slot);
            own.next().map(|(_, term)| term.clone())
        });
        let (Some(along), Some(from), Some(to), 3) = (along, from, to, slots.len()) else {
            continue;
        };
        if !is_rod(rod, declarations) {
            continue;
        }
        let rod = rod.clone();
        let new: Vec<Term> = [from.clone(), to]
            .into_iter()
            .filter(|end| ends(&rod, declarations).all(|own| own != end))
            .collect();
        told.extend(new.into_iter().map(|end| {
            let of = NounPhrase::new(END, vec![(Slot::Of, rod.clone())]);
            declarations[at].saying(Statement::one_is(end, of))
        }));
        declarations[at].statement = Statement::Does {
            subjects: vec![rod],
            verb: "lie",
            slots: vec![(Slot::Along, along), (Slot::From, from)],
        };
    }
    declarations.extend(told);
}

/// "A is fixed in N", where A is an end of a rod: it is a point of both.
pub(crate) fn fix_ends(declarations: &mut Vec<Declaration>) {
    let mut added = vec![];
    for declaration in declarations.iter() {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let ([end], "fixed", [(Slot::FixedIn, place)]) =
            (subjects.as_slice(), what.head, what.slots.as_slice())
        else {
            continue;
        };
        let rods = declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = what.head == END && subjects.contains(end);
                own.then(|| what.slot(Slot::Of)).flatten()
            }
            _ => None,
        });
        let mut rods = rods.filter(|rod| *rod != place && is_rod(rod, declarations));
        let (Some(rod), None) = (rods.next(), rods.next()) else {
            continue;
        };
        let known = declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                subjects.contains(end) && what.all(Slot::FixedIn).any(|of| of == rod)
            }
            _ => false,
        });
        let point = NounPhrase::new("point", vec![(Slot::FixedIn, rod.clone())]);
        let point = Statement::one_is(end.clone(), point);
        added.extend((!known).then(|| declaration.saying(point)));
    }
    declarations.extend(added);
}

/// Whether a thing is said to be a rod.
fn is_rod(thing: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            has(what.head, Trait::Slender) && subjects.contains(thing)
        }
        _ => false,
    })
}

/// Whether a point is said to be the mass centre of a body.
fn is_centre(point: &Term, body: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            what.head == MASS_CENTRE
                && what.slot(Slot::Of) == Some(body)
                && subjects.contains(point)
        }
        _ => false,
    })
}

/// A rod of a known length that begins at a point.
struct Laid {
    rod: Term,
    from: Term,
    along: Term,
    length: Formula,
}

fn laid(statement: &Statement, declarations: &[Declaration]) -> Option<Laid> {
    let ([rod], slots) = statement.does("lie")? else {
        return None;
    };
    let (from, along) = match slots {
        [(Slot::Along, along), (Slot::From, from)] | [(Slot::From, from), (Slot::Along, along)] => {
            (from, along)
        }
        _ => return None,
    };
    let ends_there = ends(rod, declarations).any(|end| end == from);
    (is_rod(rod, declarations) && ends_there).then_some(())?;
    Some(Laid {
        rod: rod.clone(),
        from: from.clone(),
        along: along.clone(),
        length: told_size("length", rod, declarations)?.clone(),
    })
}

/// The points that are said to be ends of a rod.
fn ends<'d>(rod: &'d Term, declarations: &'d [Declaration]) -> impl Iterator<Item = &'d Term> {
    let told = declarations.iter().filter_map(move |d| match &d.statement {
        Statement::Is { subjects, what } => is_end(what, rod).then_some(subjects),
        _ => None,
    });
    told.flatten()
}

/// Whether a sentence says of a point alone that it is an end of a rod.
fn is_called_end(point: &Term, rod: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            is_end(what, rod) && matches!(subjects.as_slice(), [end] if end == point)
        }
        _ => false,
    })
}

fn is_end(what: &NounPhrase, rod: &Term) -> bool {
    what.head == END && matches!(what.slots.as_slice(), [(Slot::Of, of)] if of == rod)
}

/// Says where the middle and the other end are, in the place of what says that the points are ends.
fn lay(laid: &Laid, at: usize, declarations: &mut Vec<Declaration>, macros: &Macros) {
    let Laid {
        rod,
        from,
        along,
        length,
    } = laid;
    let at_distance = |subject: Term, distance: Formula| Statement::Does {
        subjects: vec![subject],
        verb: "lie",
        slots: vec![
            (Slot::At, Term::Formula(distance)),
            (Slot::From, from.clone()),
            (Slot::Along, along.clone()),
        ],
    };
    for declaration in declarations.iter_mut() {
        let other = match &declaration.statement {
            Statement::Is { subjects, what } => match subjects.as_slice() {
                [point] if is_end(what, rod) && point != from => Some(point.clone()),
                [one, other] if is_end(what, rod) && other == from => Some(one.clone()),
                [one, other] if is_end(what, rod) && one == from => Some(other.clone()),
                [Term::Phrase(end)] if is_end(end, rod) => {
                    Some(Term::Phrase(Box::new(what.clone())))
                }
                _ => None,
            },
            _ => None,
        };
        if let Some(other) = other {
            declaration.statement = at_distance(other, length.clone());
        }
    }
    let said = declarations[at].clone();
    let only = vec![(Slot::Along, along.clone())];
    declarations[at].statement = Statement::Does {
        subjects: vec![rod.clone()],
        verb: "lie",
        slots: only,
    };
    let uniform = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.is("uniform") && subjects.contains(rod),
        _ => false,
    });
    let half = formula(&format!("\\frac{{{}}}{{2}}", length.source), false, macros);
    if let Some(half) = half.filter(|_| uniform) {
        let centre = NounPhrase::new(MASS_CENTRE, vec![(Slot::Of, rod.clone())]);
        declarations.push(said.saying(at_distance(Term::Phrase(Box::new(centre)), half)));
    }
    let begins = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => is_end(what, rod) && subjects.contains(from),
        _ => false,
    };
    declarations.retain(|d| !begins(d));
}
