//! Planes that slope while no sentence names axes: the first axis of the inertial frame points down along the plane, the third
//! one stands on it, and what rolls there turns about the second one, forward where it rolls down.

use super::flat_bodies::{is_told_to_turn, turning_about};
use super::heads::{
    ANGULAR_MOMENTUM, ANGULAR_VELOCITY, CONTACT_FORCE, DOWNHILL, FORCE, FRICTION,
    MOMENT_OF_INERTIA, NORMAL, NORMAL_FORCE, UPHILL, WEIGHT,
};
use super::kinds::{name, rename};
use super::places::is_marked_vector;
use super::planar::names_axes;
use super::planar_axes::{ACROSS, TOWARDS, UPRIGHT, axis};
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, Touched, slot};
use super::traits::{Trait, has};

/// What is a plane by its noun, where no sentence introduces it.
const PLANE: &str = "plane";

/// Quantities of what rolls that have a sense, by their nouns.
const TURNING: [&str; 3] = [ANGULAR_VELOCITY, "angular acceleration", ANGULAR_MOMENTUM];

/// The forces on what rolls by itself.
const OF_ROLLING: [&str; 5] = [WEIGHT, FRICTION, NORMAL_FORCE, CONTACT_FORCE, FORCE];

/// Says of such a plane what it is, how the axes lie to it, and about which one things turn that roll on it.
pub(crate) fn lay_slopes(declarations: &mut Vec<Declaration>) {
    let Some(at) = declarations.iter().position(tells_slope) else {
        return;
    };
    for term in declarations
        .iter_mut()
        .flat_map(|d| d.statement.terms_mut())
    {
        rename(term, PLANE, PLANE);
    }
    let Some(plane) = slope(&declarations[at].statement).cloned() else {
        return;
    };
    let others = declarations
        .iter()
        .filter_map(|d| slope(&d.statement))
        .any(|other| *other != plane);
    let Some(ground) = inertial_frame(declarations).filter(|_| !others) else {
        return;
    };
    if declarations
        .iter()
        .any(|d| moves(&d.statement, &plane, &ground))
    {
        return;
    }
    let told = declarations[at].clone();
    let mut added = introduce_plane(&plane, &ground, declarations);
    if !names_axes(declarations, Some(&ground)) && !declarations.iter().any(tells_lie) {
        let of_plane = |head| NounPhrase::new(head, vec![(Slot::Of, plane.clone())]);
        let own = |number| axis(number, Some(&ground));
        added.push(Statement::one_is(own(TOWARDS), of_plane(DOWNHILL)));
        added.push(Statement::one_is(own(UPRIGHT), of_plane(NORMAL)));
        let rolling = rolling_on(&plane, declarations);
        let across = own(ACROSS);
        for body in &rolling {
            added.extend(turn(body, &ground, &across, declarations));
        }
        declarations.retain(|d| !tells_level_axis(&d.statement, &rolling));
        tell_senses(&rolling, &across, declarations);
        tell_friction(&plane, declarations);
    }
    declarations.extend(added.into_iter().map(|statement| told.saying(statement)));
}

/// Whether it tells the angle of a plane with the horizontal everywhere.
fn tells_slope(declaration: &Declaration) -> bool {
    declaration.extent == Extent::Document && slope(&declaration.statement).is_some()
}

/// The plane of which a sentence tells the angle with the horizontal.
fn slope(statement: &Statement) -> Option<&Term> {
    let level = |term: &Term| matches!(term, Term::Phrase(p) if p.head == "horizontal");
    let plane = match statement {
        Statement::Is { what, .. } if what.head == "angle" => {
            let ends: Vec<&Term> = what.all(Slot::Between).collect();
            let [one, other] = ends.as_slice() else {
                return None;
            };
            match (level(one), level(other)) {
                (true, false) => Some(*other),
                (false, true) => Some(*one),
                _ => None,
            }
        }
        Statement::Is { what, .. } if what.head == "inclination" => what.slot(Slot::Of),
        statement => match statement.does("incline")? {
            ([plane], _) => Some(plane),
            _ => None,
        },
    }?;
    let named = match plane {
        Term::Phrase(bare) if bare.head == PLANE && bare.slots.is_empty() => PLANE.to_owned(),
        term => name(term)?,
    };
    (named == PLANE || has(&named, Trait::Ground)).then_some(plane)
}

fn inertial_frame(declarations: &[Declaration]) -> Option<Term> {
    let mut frames = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" && what.is("inertial") => {
            Some(subjects.as_slice())
        }
        _ => None,
    });
    match (frames.next(), frames.next()) {
        (Some([frame]), None) => Some(frame.clone()),
        _ => None,
    }
}

/// Whether a plane moves or turns, or is fixed in something else than the inertial frame.
fn moves(statement: &Statement, plane: &Term, ground: &Term) -> bool {
    let elsewhere = |what: &NounPhrase| {
        let mut frames = what.all(Slot::FixedIn);
        frames.any(|frame| frame != ground)
    };
    match statement {
        Statement::Is { subjects, what } => subjects.contains(plane) && elsewhere(what),
        Statement::Premise(what) => what.head == PLANE && elsewhere(what),
        Statement::Does { subjects, verb, .. } => {
            subjects.contains(plane) && !matches!(*verb, "incline" | "lie")
        }
        _ => false,
    }
}

/// "The slope is fixed in N", and "the slope is inclined …" alone: it is a plane there.
fn introduce_plane(
    plane: &Term,
    ground: &Term,
    declarations: &mut Vec<Declaration>,
) -> Vec<Statement> {
    let said = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => what.head == PLANE && subjects.contains(plane),
        _ => false,
    };
    if declarations.iter().any(said) {
        return vec![];
    }
    let is_fixed = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let there = what.slot(Slot::FixedIn).is_none_or(|frame| frame == ground);
            what.head == "fixed" && subjects.as_slice() == std::slice::from_ref(plane) && there
        }
        Statement::Premise(what) => {
            let there = what
                .slot(Slot::FixedIn)
                .is_some_and(|frame| frame == ground);
            what.head == PLANE && what.adjectives == ["fixed"] && there && what.slots.len() == 1
        }
        _ => false,
    };
    declarations.retain(|d| !is_fixed(d));
    let what = NounPhrase::new(PLANE, vec![(Slot::FixedIn, ground.clone())]);
    vec![Statement::one_is(plane.clone(), what)]
}

/// Whether it tells how axes lie to a plane.
fn tells_lie(declaration: &Declaration) -> bool {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let names = |subject: &Term| !matches!(subject, Term::Phrase(_));
            [DOWNHILL, UPHILL, NORMAL].contains(&what.head) && subjects.iter().any(names)
        }
        _ => false,
    }
}

/// "The axis of the cylinder is horizontal", of what rolls down the plane: it turns about no other.
fn tells_level_axis(statement: &Statement, rolling: &[Term]) -> bool {
    let own = |slots: &[(Slot, Term)]| match slots {
        [(Slot::Of, body)] => rolling.contains(body),
        _ => false,
    };
    match statement {
        Statement::Premise(axis) => {
            axis.head == "axis" && axis.adjectives == ["horizontal"] && own(&axis.slots)
        }
        Statement::Is { subjects, what } if what.head == "horizontal" && what.slots.is_empty() => {
            let axis = |term: &Term| match term {
                Term::Phrase(axis) => axis.head == "axis" && own(&axis.slots),
                _ => false,
            };
            subjects.iter().all(axis)
        }
        _ => false,
    }
}

/// What rolls on a plane, and nothing that sentences turn otherwise.
fn rolling_on(plane: &Term, declarations: &[Declaration]) -> Vec<Term> {
    // What rolls on a plane may move across it as well.
    let down = |d: &&Declaration| d.text.split_whitespace().any(|word| word == "down");
    let rolling = declarations.iter().filter(down).filter_map(|d| {
        let (subjects, slots) = d.statement.does("roll")?;
        let on = slot(slots, Slot::On).or_else(|| slot(slots, Slot::In));
        on.is_none_or(|on| on == plane).then_some(subjects)
    });
    let untold = |body: &&Term| !is_told_to_turn(body, declarations);
    let mut bodies: Vec<Term> = rolling.flatten().filter(untold).cloned().collect();
    bodies.dedup();
    bodies
}

/// That a body turns about the level axis of the plane, and, if it is no ball, is round about that.
fn turn(body: &Term, ground: &Term, across: &Term, all: &[Declaration]) -> Vec<Statement> {
    let one = std::slice::from_ref(body);
    let [turn, symmetric] = turning_about(one, ground.clone(), across.clone());
    let ball = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => subjects.contains(body) && has(what.head, Trait::Ball),
        _ => false,
    };
    let named = name(body).is_some_and(|name| has(&name, Trait::Ball));
    let round = (!named && !all.iter().any(ball)).then_some(symmetric);
    std::iter::once(turn).chain(round).collect()
}

/// Numbers for how a body turns count forward where it rolls down, unless something is counted up the plane; its moment of
/// inertia is that about the axis of the turn.
fn tell_senses(rolling: &[Term], across: &Term, declarations: &mut [Declaration]) {
    let uphill = |d: &Declaration| match &d.statement {
        Statement::Is { what, .. } if what.head != FRICTION => {
            let up = |term: &Term| matches!(term, Term::Phrase(p) if p.head == UPHILL);
            what.head == UPHILL || what.all(Slot::Along).any(up)
        }
        _ => false,
    };
    let counted_up = declarations.iter().any(uphill);
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let own = what.slot(Slot::Of).is_some_and(|of| rolling.contains(of));
        let told = [Slot::Along, Slot::About, Slot::On].map(|slot| what.slot(slot).is_some());
        if !own || told.contains(&true) || !subjects.iter().all(is_number) {
            continue;
        }
        match what.head {
            head if TURNING.contains(&head) && what.adjectives.is_empty() => match counted_up {
                true => declaration.statement = not_told(subjects),
                false => what.slots.push((Slot::Along, across.clone())),
            },
            MOMENT_OF_INERTIA => what.slots.push((Slot::About, across.clone())),
            _ => {}
        }
    }
}

/// Whether a term is a letter that is not written as one of a vector.
fn is_number(term: &Term) -> bool {
    matches!(term, Term::Formula(letter) if !is_marked_vector(letter))
}

/// That of letters nothing is understood: which way they count may be either.
fn not_told(letters: &[Term]) -> Statement {
    let formulas = letters.iter().filter_map(|letter| match letter {
        Term::Formula(formula) => Some(formula.clone()),
        _ => None,
    });
    Statement::Unread {
        letters: vec![],
        touched: Touched::Written(formulas.collect()),
    }
}

/// The friction on what rolls by itself holds it back: a number for it counts up the plane.
fn tell_friction(plane: &Term, declarations: &mut [Declaration]) {
    let other = |load: &Term| match load {
        Term::Phrase(load) => !OF_ROLLING.contains(&load.head),
        letter => !declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                subjects.contains(letter) && OF_ROLLING.contains(&what.head)
            }
            _ => false,
        }),
    };
    let by_itself = declarations.iter().any(|d| match &d.statement {
        Statement::Premise(premise) if premise.is("only") => !premise.all(Slot::With).any(other),
        _ => false,
    });
    if !by_itself {
        return;
    }
    let pointing: Vec<Term> = declarations
        .iter()
        .filter_map(|d| d.statement.does("point"))
        .flat_map(|(subjects, _)| subjects.to_vec())
        .collect();
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == FRICTION
            && what.slot(Slot::Along).is_none()
            && subjects
                .iter()
                .all(|s| is_number(s) && !pointing.contains(s))
        {
            let up = NounPhrase::new(UPHILL, vec![(Slot::Of, plane.clone())]);
            what.slots.push((Slot::Along, Term::Phrase(Box::new(up))));
        }
    }
}
