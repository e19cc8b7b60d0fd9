//! Axes of bodies and points about which bodies turn, in the plain form.

use super::heads::{NORMAL, SIZES};
use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use super::terms::say_besides;
use super::traits::{Trait, has};
use std::collections::BTreeSet;

/// "The axis of the cylinder is the second axis of B", "it lies along that": that axis of B is the axis of the cylinder.
pub(crate) fn turn_to_frames(declarations: &mut [Declaration]) {
    tell_parallel_axes(declarations);
    for declaration in declarations {
        let said = match &declaration.statement {
            Statement::Is { subjects, what } => match subjects.as_slice() {
                [own] if is_numbered_axis(what) => {
                    said_of_axis(own, &Term::Phrase(Box::new(what.clone())))
                }
                _ => None,
            },
            statement => match statement.does("lie") {
                Some(([own], [(Slot::Along, axis)])) => {
                    said_of_axis(own, axis).or_else(|| said_of_axis(axis, own))
                }
                _ => None,
            },
        };
        if let Some(statement) = said {
            declaration.statement = statement;
        }
    }
}

/// "The axis of the cylinder is parallel to x", "it points along x": the cylinder is round about x.
fn tell_parallel_axes(declarations: &mut [Declaration]) {
    let round = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } if has(what.head, Trait::Round) => subjects.clone(),
        _ => vec![],
    };
    let round: Vec<Term> = declarations.iter().flat_map(round).collect();
    for declaration in declarations {
        let said = match &declaration.statement {
            Statement::Premise(own) if own.adjectives == ["parallel"] => {
                match own.slots.as_slice() {
                    [(Slot::Of, body), (Slot::With, axis)] => Some((own, body, axis)),
                    _ => None,
                }
            }
            statement => match statement.does("point") {
                Some(([Term::Phrase(own)], [(Slot::Along, axis)])) => match own.slots.as_slice() {
                    [(Slot::Of, body)] => Some((&**own, body, axis)),
                    _ => None,
                },
                _ => None,
            },
        };
        if let Some((own, body, axis)) = said
            && own.head == "axis"
            && round.contains(body)
        {
            let about = vec![(Slot::About, axis.clone())];
            declaration.statement =
                Statement::one_is(body.clone(), NounPhrase::new("symmetric", about));
        }
    }
}

/// "the axis of the cylinder" and "the second axis of B" in the plain order.
fn said_of_axis(own: &Term, axis: &Term) -> Option<Statement> {
    let Term::Phrase(own) = own else {
        return None;
    };
    let [(Slot::Of, body)] = own.slots.as_slice() else {
        return None;
    };
    let thing = name(body).is_some_and(|name| name.starts_with(char::is_lowercase));
    let line = own.head == "axis" || own.head == NORMAL;
    (line && thing && is_axis_of_frame(axis))
        .then(|| Statement::one_is(axis.clone(), (**own).clone()))
}

/// "the second axis of B", or the name of an axis.
fn is_axis_of_frame(term: &Term) -> bool {
    match term {
        Term::Phrase(axis) => is_numbered_axis(axis),
        Term::Name(name) => name.chars().count() == 1,
        Term::Formula(_) => true,
        _ => false,
    }
}

/// "the second axis of B"
fn is_numbered_axis(what: &NounPhrase) -> bool {
    what.head == "axis" && what.slot(Slot::Which).is_some()
}

/// "`$u$` is normal to `$n$`" is said of two directions; of bodies and planes it is a noun. A flat body that is round is
/// symmetric about its normal.
pub(crate) fn tell_normals(declarations: &mut [Declaration]) {
    let discs: Vec<Term> = declarations.iter().flat_map(round_and_flat).collect();
    for declaration in declarations {
        if let Some(told) = symmetric_about_normal(&declaration.statement, &discs) {
            declaration.statement = told;
            continue;
        }
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let letters = subjects.iter().all(|s| matches!(s, Term::Formula(_)));
        let [(Slot::Of, of)] = what.slots.as_slice() else {
            continue;
        };
        if what.head != NORMAL || !letters {
            continue;
        }
        let each_other = matches!(of, Term::Phrase(p) if p.head == "other");
        match (each_other, subjects.as_slice()) {
            (true, [one, other]) => {
                what.slots = vec![(Slot::With, other.clone())];
                what.head = "orthogonal";
                *subjects = vec![one.clone()];
            }
            (true, _) => *declaration = declaration.clone().not_understood(),
            (false, _) if matches!(of, Term::Formula(_)) || is_axis_of_frame(of) => {
                what.slots = vec![(Slot::With, of.clone())];
                what.head = "orthogonal";
            }
            _ => {}
        }
    }
}

/// What a sentence says to be flat and round.
fn round_and_flat(declaration: &Declaration) -> Vec<Term> {
    match &declaration.statement {
        Statement::Is { subjects, what }
            if has(what.head, Trait::Round) && has(what.head, Trait::Flat) =>
        {
            subjects.clone()
        }
        _ => vec![],
    }
}

fn symmetric_about_normal(statement: &Statement, discs: &[Term]) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([axis], [(Slot::Of, disc)], NORMAL) =
        (subjects.as_slice(), what.slots.as_slice(), what.head)
    else {
        return None;
    };
    let about = vec![(Slot::About, axis.clone())];
    let told = Statement::one_is(disc.clone(), NounPhrase::new("symmetric", about));
    discs.contains(disc).then_some(told)
}

/// "P is the other end": of the body of whose end the sentence before tells.
pub(crate) fn end_the_same(declarations: &mut [Declaration]) {
    let mut last: Option<Term> = None;
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        if what.head != "end" {
            continue;
        }
        match (what.slot(Slot::Of), &last) {
            (Some(of), _) => last = Some(of.clone()),
            (None, Some(of)) => what.slots.push((Slot::Of, of.clone())),
            (None, None) => {}
        }
    }
}

/// "The rotor turns about O", "A turns relative to N about the axis through O along z" where O is fixed in N: O is fixed in
/// what turns as well.
pub(crate) fn fix_pivots(declarations: &mut Vec<Declaration>) {
    let said = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "point" => Some((subjects, what)),
        _ => None,
    });
    let mut points: BTreeSet<String> = BTreeSet::new();
    let mut fixed: Vec<(String, Term)> = vec![];
    for (subjects, what) in said {
        for point in subjects.iter().filter_map(name) {
            let carriers = what.all(Slot::FixedIn).cloned();
            fixed.extend(carriers.map(|carrier| (point.clone(), carrier)));
            points.insert(point);
        }
    }
    let on_axis = |slots: &[(Slot, Term)], about: &Term| {
        let Term::Phrase(axis) = about else {
            return None;
        };
        let relative = slot(slots, Slot::RelativeTo)?;
        let through = axis.slot(Slot::Through)?;
        let rests = fixed.contains(&(name(through)?, relative.clone()));
        rests.then(|| through.clone())
    };
    say_besides(declarations, |statement| {
        let Some((subjects, slots)) = statement.does("turn") else {
            return vec![];
        };
        let about = slots.iter().filter(|(slot, _)| *slot == Slot::About);
        let pivots = about.filter_map(|(_, at)| match name(at) {
            Some(name) => points.contains(&name).then(|| at.clone()),
            None => on_axis(slots, at),
        });
        let fixed = subjects.iter().map(|body| (Slot::FixedIn, body.clone()));
        let point = NounPhrase::new("point", fixed.collect());
        pivots
            .map(|pivot| Statement::one_is(pivot, point.clone()))
            .collect()
    });
}

/// "`$u$` and `$v$` are the velocities of the mass centres of the hub and the wheel": one for each.
pub(crate) fn part_centres(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut parted = vec![];
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            parted.push(declaration);
            continue;
        };
        let place = what.slots.iter().position(|(slot, of)| {
            *slot == Slot::Of && matches!(of, Term::Phrase(p) if p.head == "mass centre" && p.all(Slot::Of).count() > 1)
        });
        let Some((at, Term::Phrase(centres))) = place.map(|at| (at, &what.slots[at].1)) else {
            parted.push(declaration);
            continue;
        };
        let bodies: Vec<Term> = centres.all(Slot::Of).cloned().collect();
        if bodies.len() != subjects.len() {
            parted.push(declaration.not_understood());
            continue;
        }
        for (subject, body) in subjects.iter().zip(bodies) {
            let mut what = what.clone();
            let centre = NounPhrase::new("mass centre", vec![(Slot::Of, body)]);
            what.slots[at].1 = Term::Phrase(Box::new(centre));
            parted.push(declaration.saying(Statement::one_is(subject.clone(), what)));
        }
    }
    parted
}

/// Whether a noun in the plain form is that of a body.
pub(super) fn is_thing_with_sizes(phrase: &NounPhrase) -> bool {
    is_body(phrase.head) && !phrase.slots.is_empty() && phrase.slots.iter().all(is_size)
}

/// Whether what hangs on a noun is a size of it: "of radius `$r$`".
pub(super) fn is_size((slot, term): &(Slot, Term)) -> bool {
    *slot == Slot::Of && matches!(term, Term::Phrase(size) if SIZES.contains(&size.head))
}
