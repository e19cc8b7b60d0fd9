//! Things of which a quantity is told together: "the kinetic energy of the rod and the disc" is that of a body of which both
//! are parts.

use super::heads::{
    ANGULAR_MOMENTUM, INERTIA_TENSOR, KINETIC_ENERGY, MASS, MASS_CENTRE, MOMENT_OF_INERTIA,
    MOMENTUM, POTENTIAL_ENERGY, TOTAL_ENERGY,
};
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Quantities of a whole that are the sums of those of its parts, and its mass centre.
const OF_WHOLES: [&str; 10] = [
    ANGULAR_MOMENTUM,
    INERTIA_TENSOR,
    KINETIC_ENERGY,
    MASS,
    MOMENT_OF_INERTIA,
    MOMENTUM,
    POTENTIAL_ENERGY,
    TOTAL_ENERGY,
    "Lagrangian",
    MASS_CENTRE,
];

/// Names the bodies of which sentences speak together.
pub(crate) fn join_together(declarations: &mut Vec<Declaration>) {
    name_parts(declarations);
    say_of_each_centre(declarations);
    let mut joined: Vec<Declaration> = vec![];
    let things: Vec<(String, &'static str)> = things(declarations);
    for declaration in declarations.iter_mut() {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        name_each(what, &things);
        // "the mass of P and of Q" may be that of each.
        let of_each = what.head == MASS && !what.is("total");
        if subjects.len() != 1 || !OF_WHOLES.contains(&what.head) || of_each {
            continue;
        }
        let Some((whole, parts)) = told_together(what) else {
            continue;
        };
        let consists = Statement::Does {
            subjects: vec![whole],
            verb: "consist",
            slots: parts,
        };
        if joined.iter().all(|known| known.statement != consists) {
            joined.push(declaration.saying(consists));
        }
    }
    declarations.extend(joined);
}

/// "G is the mass centre of the hub and of the wheel", with the "of" said again: of each of them.
fn say_of_each_centre(declarations: &mut Vec<Declaration>) {
    let alone = |own: &Declaration| {
        let mut others = declarations.iter().filter(|d| d.text == own.text);
        others.all(|d| d.statement == own.statement)
    };
    let parted = declarations.iter().flat_map(|declaration| {
        let each = centres(declaration).filter(|_| alone(declaration));
        each.unwrap_or_else(|| vec![declaration.clone()])
    });
    *declarations = parted.collect();
}

/// One sentence for each body whose mass centre a point is said to be, where the "of" is said again.
fn centres(declaration: &Declaration) -> Option<Vec<Declaration>> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let [subject] = subjects.as_slice() else {
        return None;
    };
    let of_bodies = what.slots.iter().all(|(slot, _)| *slot == Slot::Of);
    if what.head != MASS_CENTRE || !of_bodies || !declaration.text.contains(" and of ") {
        return None;
    }
    let of_one = |slot: &(Slot, Term)| {
        let mut what = what.clone();
        what.slots = vec![slot.clone()];
        declaration.saying(Statement::one_is(subject.clone(), what))
    };
    Some(what.slots.iter().map(of_one).collect())
}

/// "The rotor consists of `$P_1$` and `$P_2$`": these are names. Which of them an index numbers is not worked with.
fn name_parts(declarations: &mut [Declaration]) {
    let particles = |(_, term): &(Slot, Term)| matches!(term, Term::Name(name) if name.trim_end_matches('s').ends_with("particle"));
    let numbers = |d: &Declaration| {
        let counted = d.statement.does("number");
        counted.is_some_and(|(_, slots)| slots.iter().any(particles))
    };
    if declarations.iter().any(numbers) {
        return;
    }
    for declaration in declarations {
        let Statement::Does {
            verb: "consist",
            slots,
            ..
        } = &mut declaration.statement
        else {
            continue;
        };
        for (_, part) in slots {
            if let Term::Formula(letter) = part {
                *part = Term::Name(letter.source.replace(['{', '}'], ""));
            }
        }
    }
}

/// The things that sentences tell what they are, or that have a number: "particle 1".
fn things(declarations: &[Declaration]) -> Vec<(String, &'static str)> {
    let mut things: Vec<(String, &'static str)> = vec![];
    for declaration in declarations {
        let what = match &declaration.statement {
            Statement::Is { what, .. } if super::is_body(what.head) => Some(what.head),
            _ => None,
        };
        for subject in declaration.statement.subjects().iter().filter_map(called) {
            let numbered = subject
                .split_once(' ')
                .filter(|(_, number)| number.chars().all(|c| c.is_ascii_digit()));
            let noun = numbered
                .and_then(|(noun, _)| super::body_noun(noun))
                .or(what);
            let new = things.iter().all(|(known, _)| *known != subject);
            things.extend(noun.filter(|_| new).map(|noun| (subject.clone(), noun)));
        }
    }
    things
}

/// A thing by its name, or by its number.
fn called(thing: &Term) -> Option<String> {
    match thing {
        Term::Member { family, index } => Some(format!("{family} {}", index.source)),
        thing => name(thing),
    }
}

/// "the kinetic energy of the two particles": of each by its name.
fn name_each(what: &mut NounPhrase, things: &[(String, &'static str)]) {
    let Some(at) = what.slots.iter().position(|(slot, term)| {
        *slot == Slot::Of && matches!(term, Term::Phrase(all) if all.adjectives == ["two"] && all.slots.is_empty())
    }) else {
        return;
    };
    let Term::Phrase(all) = &what.slots[at].1 else {
        return;
    };
    let own = things.iter().filter(|(_, noun)| *noun == all.head);
    let names: Vec<(Slot, Term)> = own
        .map(|(name, _)| (Slot::Of, Term::Name(name.clone())))
        .collect();
    if names.len() == 2 {
        what.slots.splice(at..=at, names);
    }
}

/// Puts the whole in the place of its parts, and gives both.
fn told_together(what: &mut NounPhrase) -> Option<(Term, Vec<(Slot, Term)>)> {
    let parts: Vec<(Slot, Term)> = what
        .slots
        .iter()
        .filter(|(slot, _)| *slot == Slot::Of)
        .cloned()
        .collect();
    let names: Option<Vec<String>> = parts.iter().map(|(_, part)| part_name(part)).collect();
    let names = names.filter(|names| names.len() > 1)?;
    let whole = Term::Name(names.join(" and "));
    what.slots.retain(|(slot, _)| *slot != Slot::Of);
    what.slots.insert(0, (Slot::Of, whole.clone()));
    Some((whole, parts))
}

/// A thing, and no letter for a quantity.
fn part_name(part: &Term) -> Option<String> {
    match part {
        Term::Name(_) => name(part),
        Term::Phrase(phrase) if super::is_body(phrase.head) && phrase.slots.is_empty() => {
            Some(phrase.head.to_owned())
        }
        _ => None,
    }
}
