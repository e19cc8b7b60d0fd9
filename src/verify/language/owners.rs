//! Whose something is: a point has no mass centre and no mass, but the body has to which it belongs.

use super::acting::tell_where_forces_act;
use super::heads::{CONTACT_FORCE, FORCE, MASS, MOMENT, WEIGHT};
use super::kinds::name;
use super::listed::tell_listed_moments;
use super::loaded_bodies::{give_weights_to_loaded, name_loaded_bodies};
use super::other_loads::tell_other_moments;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::the_axis::tell_the_axis;
use super::traits::{self, Trait};
use super::{is_bodily, is_body};
use crate::notation::ast::Kind;
use crate::notation::document::Row;
use std::collections::BTreeMap;

/// Nouns of what belongs to a body.
const BELONGING: [&str; 8] = [
    "point",
    "apex",
    "end",
    "corner",
    "middle",
    "frame",
    "vector",
    "unit vector",
];

/// "O is the apex of the cone, and G is its mass centre": that of the cone.
pub(crate) fn give_to_bodies(declarations: &mut [Declaration]) {
    let mut owners: BTreeMap<String, Term> = BTreeMap::new();
    for (point, body) in declarations.iter().filter_map(owner) {
        owners.entry(point).or_insert(body);
    }
    for declaration in declarations {
        let mut lost = false;
        if let Statement::Is { what, .. } | Statement::Premise(what) = &mut declaration.statement {
            lost |= give(what, &owners);
        }
        for term in declaration.statement.terms_mut() {
            if let Term::Phrase(phrase) = term {
                lost |= give(phrase, &owners);
            }
        }
        if lost {
            *declaration = declaration.clone().not_understood();
        }
    }
}

/// Gives what only bodies have to the body to which the thing belongs; whether it is a letter of which no sentence tells that.
fn give(what: &mut NounPhrase, owners: &BTreeMap<String, Term>) -> bool {
    let centre = what.head == "mass centre";
    let of_bodies = is_bodily(what.head) || what.head == MASS || centre;
    let mut lost = false;
    for (slot, term) in &mut what.slots {
        if let Term::Phrase(inner) = term {
            lost |= give(inner, owners);
            continue;
        }
        if !of_bodies || *slot != Slot::Of {
            continue;
        }
        match name(term).and_then(|point| owners.get(&point)) {
            Some(body) => term.clone_from(body),
            None => lost |= centre && is_vector(term),
        }
    }
    lost
}

/// Whether a term is a letter of a vector: small, or with a mark.
fn is_vector(term: &Term) -> bool {
    let Term::Formula(formula) = term else {
        return false;
    };
    let calligraphic = match &formula.row {
        Row::Expression(node) => {
            matches!(&node.kind, Kind::Symbol(symbol) if symbol.style.calligraphic)
        }
        _ => false,
    };
    let marked = |c: char| c == '\\' || c.is_lowercase();
    !calligraphic && formula.source.starts_with(marked)
}

/// What something does to a body at a point, or what one thing does to another, is a force of that.
fn tell_touching(declarations: &mut [Declaration]) {
    fn tell(load: &mut NounPhrase) {
        let has = |slot| load.slot(slot).is_some();
        if load.head == CONTACT_FORCE && (has(Slot::At) || has(Slot::Of) && has(Slot::Upon)) {
            load.head = FORCE;
        }
        for (_, term) in &mut load.slots {
            if let Term::Phrase(inner) = term {
                tell(inner);
            }
        }
    }
    for declaration in declarations {
        if let Statement::Is { what, .. } | Statement::Premise(what) = &mut declaration.statement {
            tell(what);
        }
        for term in declaration.statement.terms_mut() {
            if let Term::Phrase(phrase) = term {
                tell(phrase);
            }
        }
    }
}

/// "the total moment of the external forces on the body about C": the total moment on it; and what is said of a vector is not
/// said of the body that the sentence names before.
pub(crate) fn say_of_loads(declarations: &mut Vec<Declaration>) {
    tell_the_axis(declarations);
    name_loaded_bodies(declarations);
    give_weights_to_loaded(declarations);
    share_agents(declarations);
    tell_where_forces_act(declarations);
    tell_touching(declarations);
    tell_listed_moments(declarations);
    tell_other_moments(declarations);
    let mut letter: Option<(String, Term)> = None;
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let vector = matches!(what.head, "unit vector" | "vector");
        if let ([Term::Name(thing)], Some((text, about)), true) =
            (subjects.as_slice(), &letter, vector)
            && thing.starts_with(char::is_lowercase)
            && *text == declaration.text
        {
            *subjects = vec![about.clone()];
        }
        let named = what
            .slots
            .iter()
            .rev()
            .find(|(_, t)| matches!(t, Term::Formula(_)));
        letter = named.map(|(_, about)| (declaration.text.clone(), about.clone()));
        take_directions(what);
        let of_forces = match what.slot(Slot::Of) {
            Some(Term::Phrase(forces)) if what.head == MOMENT && is_all_forces(forces) => {
                forces.slots.clone()
            }
            _ => continue,
        };
        what.slots.retain(|(slot, _)| *slot != Slot::Of);
        what.slots.extend(of_forces);
    }
}

/// "The force and the moment of the hub are the only loads on the wheel": each is of the hub.
fn share_agents(declarations: &mut [Declaration]) {
    let loads = letters_of_loads(declarations);
    for declaration in declarations {
        let Statement::Premise(premise) = &mut declaration.statement else {
            continue;
        };
        let slots = std::mem::take(&mut premise.slots).into_iter();
        premise.slots = slots.flat_map(|said| at_each_point(said, &loads)).collect();
        let own = premise.slots.clone();
        for ((slot, load), (next, behind)) in premise.slots.iter_mut().zip(own.iter().skip(1)) {
            if let (Slot::With, Slot::With, Term::Phrase(load), Term::Phrase(other)) =
                (*slot, *next, load, behind)
                && matches!((load.head, other.head), (FORCE, MOMENT) | (MOMENT, FORCE))
                && load.slots.is_empty()
                && let Some(agent) = other.slot(Slot::Of)
            {
                load.slots.push((Slot::Of, agent.clone()));
            }
        }
    }
}

/// Letters that sentences say to be loads.
fn letters_of_loads(declarations: &[Declaration]) -> Vec<Term> {
    let loads = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if is_load(what.head) => Some(subjects.clone()),
        _ => None,
    });
    loads.flatten().collect()
}

fn is_load(head: &str) -> bool {
    matches!(head, FORCE | MOMENT | WEIGHT) || traits::has(head, Trait::OfAKind)
}

/// "the forces at P and Q": one at each.
fn at_each_point((slot, load): (Slot, Term), loads: &[Term]) -> Vec<(Slot, Term)> {
    let points = match &load {
        Term::Phrase(load) if slot == Slot::With => load.all(Slot::At).count(),
        _ => 0,
    };
    let Term::Phrase(several) = &load else {
        return vec![(slot, load)];
    };
    let letters = several.all(Slot::Which).count();
    if points < 2 || letters > 0 {
        return vec![(slot, load)];
    }
    let at = |point: &Term| {
        // "the forces at P and Q and the moment of the motor": another load ends the list.
        let named = matches!(point, Term::Phrase(load) if is_load(load.head));
        if named || loads.contains(point) {
            return (slot, point.clone());
        }
        let mut one = (**several).clone();
        one.slots.retain(|(slot, _)| *slot != Slot::At);
        one.slots.push((Slot::At, point.clone()));
        (slot, Term::Phrase(Box::new(one)))
    };
    several.all(Slot::At).map(at).collect()
}

/// "the components of the force on the body along n and t": the components are along these.
fn take_directions(what: &mut NounPhrase) {
    let told = [Slot::Along, Slot::On]
        .iter()
        .any(|slot| what.slot(*slot).is_some());
    if what.head != "component" || told {
        return;
    }
    let mut along = vec![];
    for (_, of) in &mut what.slots {
        if let Term::Phrase(load) = of
            && load.head == FORCE
        {
            let directions = load.slots.iter().filter(|(slot, _)| *slot == Slot::Along);
            along.extend(directions.cloned());
            load.slots.retain(|(slot, _)| *slot != Slot::Along);
        }
    }
    what.slots.extend(along);
}

/// "the external forces on the body"
fn is_all_forces(forces: &NounPhrase) -> bool {
    matches!(forces.head, FORCE | "load")
        && forces.is("external")
        && forces.slot(Slot::Of).is_some()
}

/// A point, and the thing to which the sentence that tells it says that it belongs.
fn owner(declaration: &Declaration) -> Option<(String, Term)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let [point] = subjects.as_slice() else {
        return None;
    };
    let owners: Vec<&Term> = what
        .slots
        .iter()
        .filter_map(|slot| belongs(what, slot))
        .collect();
    match owners.as_slice() {
        [owner] if BELONGING.contains(&what.head) => Some((name(point)?, (*owner).clone())),
        _ => None,
    }
}

/// "of the rod", "fixed in the disc": what belongs to a body by its noun.
fn belongs<'t>(what: &NounPhrase, (slot, of): &'t (Slot, Term)) -> Option<&'t Term> {
    let body = match of {
        Term::Name(name) => name.starts_with(char::is_lowercase),
        Term::Phrase(phrase) => is_body(phrase.head),
        _ => false,
    };
    let fixed = *slot == Slot::FixedIn && BELONGING.contains(&what.head);
    (body && (*slot == Slot::Of || fixed)).then_some(of)
}
