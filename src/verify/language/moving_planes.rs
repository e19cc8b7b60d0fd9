//! Planks, belts and carts that move without turning while something rolls on them: each is a plane that a frame of its own
//! carries along.

use super::heads::KEEPS_DIRECTION;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};

/// How something moves along.
const MOVES: [&str; 2] = ["move", "slide"];

/// Quantities of how something moves along.
const TRAVELS: [&str; 6] = [
    "displacement",
    "travel",
    "velocity",
    "speed",
    "acceleration",
    "position",
];

/// "The plank is horizontal and slides along x": a frame that does not turn carries it, and a point of it slides along x.
pub(super) fn carry_planes(declarations: &mut Vec<Declaration>) {
    let rolled: Vec<Term> = declarations
        .iter()
        .filter_map(|d| {
            let (_, slots) = d.statement.does("roll")?;
            let on = slot(slots, Slot::On).filter(|on| matches!(on, Term::Name(_)));
            on.cloned().filter(|_| d.extent == Extent::Document)
        })
        .collect();
    for plane in rolled {
        let moves = declarations.iter().any(|d| moves(&d.statement, &plane));
        let level = declarations
            .iter()
            .position(|d| is_level(&d.statement, &plane));
        let (true, Some(level)) = (moves, level) else {
            continue;
        };
        if declarations.iter().any(|d| is_held(&d.statement, &plane)) {
            continue;
        }
        let said = declarations[level].clone();
        declarations.retain(|d| !is_level(&d.statement, &plane));
        let point = carry(declarations, &plane);
        let statements = statements(&plane, point, is_massive(declarations, &plane));
        declarations.extend(statements.into_iter().map(|s| said.saying(s)));
    }
}

/// "the plank", "the horizontal plank"
fn is(term: &Term, thing: &Term) -> bool {
    let horizontal = |phrase: &NounPhrase| match thing {
        Term::Name(name) => phrase.head == name && phrase.slots.is_empty(),
        _ => false,
    };
    term == thing || matches!(term, Term::Phrase(phrase) if horizontal(phrase))
}

/// Whether a sentence tells how a thing moves.
fn moves(statement: &Statement, thing: &Term) -> bool {
    match statement {
        Statement::Does { subjects, verb, .. } => {
            MOVES.contains(verb) && subjects.iter().any(|subject| is(subject, thing))
        }
        Statement::Is { what, .. } => travels(what, thing),
        _ => false,
    }
}

fn travels(what: &NounPhrase, thing: &Term) -> bool {
    let own = TRAVELS.contains(&what.head) && what.slot(Slot::Of) == Some(thing);
    own || what.slots.iter().any(|(_, inner)| match inner {
        Term::Phrase(inner) => travels(inner, thing),
        _ => false,
    })
}

/// "The plank is horizontal", "… is a horizontal board"
fn is_level(statement: &Statement, thing: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } if subjects.as_slice() == std::slice::from_ref(thing) => {
            let level = what.head == "horizontal" || what.is("horizontal");
            level && what.slots.is_empty()
        }
        _ => false,
    }
}

/// Whether a thing is said to be fixed, to turn, or to be a frame.
fn is_held(statement: &Statement, thing: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } => {
            let kind = what.head == "frame" || what.slot(Slot::FixedIn).is_some();
            kind && subjects.contains(thing)
        }
        Statement::Does { subjects, verb, .. } => {
            let other = !MOVES.contains(verb) && *verb != KEEPS_DIRECTION;
            other && subjects.contains(thing)
        }
        _ => false,
    }
}

/// Whether a thing has a mass.
fn is_massive(declarations: &[Declaration], thing: &Term) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let of = what.head == "mass" && what.slot(Slot::Of) == Some(thing);
            of || what.size("mass").is_some() && subjects.contains(thing)
        }
        _ => false,
    })
}

/// What is told of the motion of a thing is that of a point of it.
fn carry(declarations: &mut [Declaration], thing: &Term) -> Term {
    let point = match thing {
        Term::Name(name) => Term::Name(format!("point of {name}")),
        other => other.clone(),
    };
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Does { subjects, verb, .. } if MOVES.contains(verb) => {
                for subject in subjects.iter_mut().filter(|subject| is(subject, thing)) {
                    subject.clone_from(&point);
                }
            }
            Statement::Is { what, .. } => of_point(what, thing, &point),
            _ => {}
        }
    }
    point
}

fn of_point(what: &mut NounPhrase, thing: &Term, point: &Term) {
    let own = TRAVELS.contains(&what.head);
    for (slot, inner) in &mut what.slots {
        match inner {
            of if own && *slot == Slot::Of && of == thing => of.clone_from(point),
            Term::Phrase(inner) => of_point(inner, thing, point),
            _ => {}
        }
    }
}

fn statements(plane: &Term, point: Term, massive: bool) -> Vec<Statement> {
    let mut level = NounPhrase::new("plane", vec![]);
    level.adjectives.push("horizontal");
    let frame = NounPhrase::new("frame", vec![]);
    let carried = NounPhrase::new("point", vec![(Slot::FixedIn, plane.clone())]);
    let keeps = Statement::Does {
        subjects: vec![plane.clone()],
        verb: KEEPS_DIRECTION,
        slots: vec![],
    };
    let frame = (!massive).then(|| Statement::one_is(plane.clone(), frame));
    let rest = [
        keeps,
        Statement::one_is(point, carried),
        Statement::one_is(plane.clone(), level),
    ];
    frame.into_iter().chain(rest).collect()
}
