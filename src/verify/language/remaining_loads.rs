//! "No other load acts on the disc": all that other sentences tell to act on it, with what the sentence itself lists.

use super::heads::{FORCE, MOMENT, WEIGHT};
use super::is_load;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};

/// The noun of what acts at one instant.
const IMPULSE: &str = "impulse";

/// What a load may be called without being another one.
const PLAIN: [&str; 2] = ["normal", "constant"];

/// Verbs of bodies that are held by forces of which no sentence need speak.
const HELD: [&str; 3] = ["hinge", "pin", "pivot"];

/// Puts the loads that other sentences tell into a list that has "the other loads". Where one is told of which it is not
/// said on what it acts, or nothing but the list speaks of loads, it stays as it is.
pub(super) fn list_remaining_loads(declarations: &mut [Declaration]) {
    for at in 0..declarations.len() {
        let Some((body, kind)) = with_others(&declarations[at].statement) else {
            continue;
        };
        let Some(told) = told_loads(&body, kind, at, declarations) else {
            continue;
        };
        if let Statement::Premise(premise) = &mut declarations[at].statement {
            // What the list has of what is told elsewhere would be counted twice.
            if premise.all(Slot::With).any(|own| is_among(own, &told)) {
                continue;
            }
            premise.slots.retain(|(_, load)| !is_other(load));
            let missing: Vec<Term> = told
                .into_iter()
                .filter(|load| !premise.all(Slot::With).any(|own| own == load))
                .collect();
            let missing = missing.into_iter().map(|load| (Slot::With, load));
            premise.slots.extend(missing);
        }
    }
}

/// Whether a listed load is one of those that are told, or one of the same thing.
fn is_among(load: &Term, told: &[Term]) -> bool {
    let told = told.iter().filter_map(|load| match load {
        Term::Phrase(load) => Some(load),
        _ => None,
    });
    let mut told = told.filter(|other| match load {
        Term::Phrase(load) if load.head == WEIGHT || load.is("other") => false,
        Term::Phrase(load) => {
            let same = |slot| load.slot(slot).is_some() && load.slot(slot) == other.slot(slot);
            [Slot::Of, Slot::At, Slot::Which].into_iter().any(same)
        }
        letter => other.slot(Slot::Which) == Some(letter),
    });
    told.next().is_some()
}

/// The body of a list that has "the other loads", and of what kind these are.
fn with_others(statement: &Statement) -> Option<(Term, &'static str)> {
    let Statement::Premise(premise) = statement else {
        return None;
    };
    let other = premise.all(Slot::With).find(|load| is_other(load))?;
    let Term::Phrase(other) = other else {
        return None;
    };
    let plain = premise.is("only")
        && premise
            .slot(Slot::About)
            .or(premise.slot(Slot::Along))
            .is_none();
    plain.then(|| Some((premise.slot(Slot::Of)?.clone(), other.head)))?
}

/// "the other loads"
fn is_other(load: &Term) -> bool {
    matches!(load, Term::Phrase(load) if load.is("other") && load.slots.is_empty())
}

/// The loads on a body that sentences tell besides the one of the list.
fn told_loads(
    body: &Term,
    kind: &str,
    list: usize,
    declarations: &[Declaration],
) -> Option<Vec<Term>> {
    let (mut told, mut supports): (Vec<Term>, Vec<Term>) = (vec![], vec![]);
    for (at, declaration) in declarations.iter().enumerate() {
        let loads = match &declaration.statement {
            _ if at == list => vec![],
            Statement::Does { subjects, verb, .. } if HELD.contains(verb) => {
                match subjects.contains(body) {
                    true => return None,
                    false => vec![],
                }
            }
            Statement::Does {
                subjects,
                verb: "roll" | "slide" | "touch",
                slots,
            } if subjects.contains(body) => {
                supports.extend(slot(slots, Slot::On).cloned());
                vec![]
            }
            Statement::Does {
                subjects,
                verb: "act",
                slots,
            } => acting(subjects, slots, body)?,
            Statement::Is { what, .. } => named(what, body)?,
            Statement::Unread { .. } => return None,
            _ => vec![],
        };
        if !loads.is_empty() && declaration.extent != Extent::Document {
            return None;
        }
        for load in loads {
            if is_of_kind(&load, kind) && !told.contains(&load) {
                told.push(load);
            }
        }
    }
    // Of what it touches a force must be told.
    let untold = |support: &Term| !told.iter().any(|load| is_of(load, support));
    if supports.iter().any(untold) {
        return None;
    }
    name_by_noun(&mut told);
    (!told.is_empty()).then_some(told)
}

/// What alone has its noun is told by that.
fn name_by_noun(told: &mut [Term]) {
    let head = |load: &Term| match load {
        Term::Phrase(load) => Some(load.head),
        _ => None,
    };
    let heads: Vec<&str> = told.iter().filter_map(head).collect();
    for load in told {
        if let Term::Phrase(load) = load {
            let alone = heads.iter().filter(|head| **head == load.head).count() == 1;
            if alone && !matches!(load.head, FORCE | MOMENT | IMPULSE) {
                load.slots.clear();
            }
        }
    }
}

/// Whether a load is one of something that a body touches.
fn is_of(load: &Term, support: &Term) -> bool {
    match load {
        Term::Phrase(load) => {
            let of = load.slot(Slot::Of);
            of == Some(support) || of.is_none() && !matches!(load.head, FORCE | MOMENT | IMPULSE)
        }
        _ => false,
    }
}

/// "The force `$F$` acts on the disc at P": what acts on a body; nothing where it is not said on what it acts.
fn acting(subjects: &[Term], slots: &[(Slot, Term)], body: &Term) -> Option<Vec<Term>> {
    let on = slot(slots, Slot::Upon).or_else(|| slot(slots, Slot::On))?;
    let own = on == body;
    Some(if own { subjects.to_vec() } else { vec![] })
}

/// The loads on a body that a phrase names; none where one may act on it or not.
fn named(what: &NounPhrase, body: &Term) -> Option<Vec<Term>> {
    if !is_load(what.head) {
        let mut all = vec![];
        for (_, term) in &what.slots {
            if let Term::Phrase(inner) = term {
                all.extend(named(inner, body)?);
            }
        }
        return Some(all);
    }
    if what.head == WEIGHT || what.is("total") {
        return Some(vec![]);
    }
    // Where a point is told alone it acts on the body of the list, if that has the point.
    let on = match what.slot(Slot::Upon) {
        Some(on) => on,
        None => what.slot(Slot::At).map(|_| body)?,
    };
    if what.slot(Slot::Of) == Some(body) || what.adjectives.iter().any(|said| !PLAIN.contains(said))
    {
        return None;
    }
    let mut load = what.clone();
    load.slots
        .retain(|(slot, _)| matches!(slot, Slot::Of | Slot::At | Slot::Which));
    let load = Term::Phrase(Box::new(load));
    Some(if on == body { vec![load] } else { vec![] })
}

/// Whether a load is of the kind that a sentence denies any other of.
fn is_of_kind(load: &Term, kind: &str) -> bool {
    let head = match load {
        Term::Phrase(load) => load.head,
        _ => FORCE,
    };
    match kind {
        IMPULSE => head == IMPULSE,
        MOMENT => head == MOMENT,
        FORCE => !matches!(head, MOMENT | IMPULSE),
        _ => head != IMPULSE,
    }
}
