//! Floors and tables are level planes, at rest where no sentence fixes them in something else.

use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use std::collections::BTreeSet;

/// Things that are level planes by their nouns.
const LEVEL: [&str; 2] = ["floor", "table"];

/// What a body does on a plane.
const ON_PLANES: [&str; 3] = ["roll", "slide", "touch"];

/// Says of each floor on which something rolls or slides, and of what is called horizontal there, that it is a level plane,
/// where no sentence says what it is.
pub(crate) fn lay_floors(declarations: &mut Vec<Declaration>) {
    LEVEL
        .iter()
        .for_each(|floor| level_plane(declarations, floor));
    let said = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "horizontal" => name(subjects.first()?),
        _ => None,
    });
    let level: BTreeSet<String> = said.chain(LEVEL.map(str::to_owned)).collect();
    for floor in level.iter().map(String::as_str) {
        let Some(at) = declarations.iter().position(|d| is_moved_on(d, floor)) else {
            continue;
        };
        let mut fixed_in = vec![];
        for term in declarations
            .iter_mut()
            .flat_map(|d| d.statement.terms_mut())
        {
            hoist(term, floor, &mut fixed_in);
        }
        if declarations.iter().any(|d| tells_more(d, floor)) {
            continue;
        }
        let level = declarations.iter().position(|d| is_level(d, floor));
        level.map(|at| declarations.remove(at));
        let fixed = declarations.iter().position(|d| is_fixed(d, floor));
        let slots = match fixed.map(|at| declarations.remove(at).statement) {
            Some(Statement::Is { what, .. }) => what.slots,
            _ => fixed_in.into_iter().take(1).collect(),
        };
        let plane = NounPhrase {
            adjectives: vec!["horizontal"],
            ..NounPhrase::new("plane", slots)
        };
        let at = at.min(declarations.len().saturating_sub(1));
        let told = declarations.get(at).cloned();
        let said = Statement::one_is(Term::Name(floor.to_owned()), plane);
        declarations.extend(told.map(|told| told.saying(said)));
    }
}

/// "The table is a plane fixed in N": a level one, where no sentence says how it lies.
fn level_plane(declarations: &mut [Declaration], floor: &str) {
    let tilts = |d: &Declaration| match &d.statement {
        Statement::Is { what, .. } => {
            let lie = matches!(what.head, "inclination" | "angle");
            lie && what.slots.iter().any(|(_, term)| is(term, floor))
        }
        Statement::Does { subjects, verb, .. } => {
            *verb == "incline" && subjects.iter().any(|subject| is(subject, floor))
        }
        _ => false,
    };
    if declarations.iter().any(tilts) {
        return;
    }
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && matches!(subjects.as_slice(), [subject] if is(subject, floor))
            && what.head == "plane"
            && what.adjectives.is_empty()
            && what.slots.iter().all(|(slot, _)| *slot == Slot::FixedIn)
        {
            what.adjectives.push("horizontal");
        }
    }
}

fn is(term: &Term, floor: &str) -> bool {
    match term {
        Term::Phrase(phrase) => phrase.head == floor,
        term => name(term).as_deref() == Some(floor),
    }
}

/// Whether a sentence speaks of what moves on a floor.
fn is_moved_on(declaration: &Declaration, floor: &str) -> bool {
    match &declaration.statement {
        Statement::Does { verb, slots, .. } if ON_PLANES.contains(verb) => {
            slots.iter().any(|(_, term)| is(term, floor))
        }
        _ => false,
    }
}

/// "a horizontal floor fixed in N" where something rolls: the floor, and in what it is fixed.
fn hoist(term: &mut Term, floor: &str, fixed_in: &mut Vec<(Slot, Term)>) {
    let Term::Phrase(phrase) = term else { return };
    if phrase.head != floor {
        return phrase
            .slots
            .iter_mut()
            .for_each(|(_, inner)| hoist(inner, floor, fixed_in));
    }
    let fixed = |(slot, _): &(Slot, Term)| *slot == Slot::FixedIn;
    // Where something rolls the plane is rough.
    let idle = |said: &&str| matches!(*said, "horizontal" | "rough");
    if phrase.adjectives.iter().all(idle) && phrase.slots.iter().all(fixed) {
        fixed_in.append(&mut phrase.slots);
        *term = Term::Name(floor.to_owned());
    }
}

/// Whether a sentence tells how a floor moves or lies, or is about another thing of that name.
fn tells_more(declaration: &Declaration, floor: &str) -> bool {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let own = subjects.iter().any(|subject| is(subject, floor));
            let angle = what.all(Slot::Between).any(|term| is(term, floor));
            let lie = matches!(what.head, "inclination" | "angle" | "normal");
            let plain = is_level(declaration, floor) || is_fixed(declaration, floor);
            angle || own && !plain || lie && what.all(Slot::Of).any(|term| is(term, floor))
        }
        Statement::Does { subjects, verb, .. } => {
            *verb != "act" && subjects.iter().any(|subject| is(subject, floor))
        }
        _ => false,
    }
}

/// "The floor is horizontal."
fn is_level(declaration: &Declaration, floor: &str) -> bool {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let own = matches!(subjects.as_slice(), [subject] if is(subject, floor));
            own && what.head == "horizontal" && what.slots.is_empty()
        }
        _ => false,
    }
}

/// "The floor is fixed in N."
fn is_fixed(declaration: &Declaration, floor: &str) -> bool {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let own = matches!(subjects.as_slice(), [subject] if is(subject, floor));
            let inside = |(slot, _): &(Slot, Term)| *slot == Slot::FixedIn;
            own && what.head == "fixed" && what.slots.iter().all(inside)
        }
        _ => false,
    }
}
