//! Loads of one body on another in the lists of both: by the letter that a sentence gives it, and by its opposite.

use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::ast::Kind;
use crate::notation::document::Row;

/// The nouns of what may act at a point.
const LOADS: [&str; 3] = ["force", "moment", "weight"];

/// A load that a sentence names by a letter: "`$T$` is the force of A on B at P".
struct Between {
    letter: String,
    what: NounPhrase,
    of: Term,
    on: Term,
}

/// "The weight and the force `$T$` at P are the only loads on B", "… the force `$-T$` at P … on A": the force of the other one.
pub(super) fn name_by_agents(declarations: &mut [Declaration]) {
    let between: Vec<Between> = declarations.iter().filter_map(told_between).collect();
    for declaration in declarations {
        let Statement::Premise(premise) = &mut declaration.statement else {
            continue;
        };
        let Some(body) = premise.slot(Slot::Of).cloned() else {
            continue;
        };
        if !premise.is("only") {
            continue;
        }
        for (slot, load) in &mut premise.slots {
            let found = (*slot == Slot::With).then(|| by_agent(load, &body, &between));
            if let Some(named) = found.flatten() {
                *load = named;
            }
        }
    }
}

/// "the force `$F$` at A and the force `$G$` at B": what is listed behind a point is the next load, and no point.
pub(super) fn list_next_loads(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Statement::Premise(premise) = &mut declaration.statement
            && premise.is("only")
        {
            let mut slots = vec![];
            for (slot, load) in premise.slots.drain(..) {
                let next = (slot == Slot::With).then(|| loads_in_turn(load.clone()));
                let each = next.unwrap_or_else(|| vec![load]);
                slots.extend(each.into_iter().map(|load| (slot, load)));
            }
            premise.slots = slots;
        }
    }
}

/// A load, and those that hang on it in the place of points.
fn loads_in_turn(load: Term) -> Vec<Term> {
    let Term::Phrase(mut first) = load else {
        return vec![load];
    };
    let is_load = |term: &Term| matches!(term, Term::Phrase(own) if LOADS.contains(&own.head));
    let (next, own) = std::mem::take(&mut first.slots)
        .into_iter()
        .partition(|(slot, term)| *slot == Slot::At && is_load(term));
    first.slots = own;
    let next: Vec<(Slot, Term)> = next;
    let next = next.into_iter().flat_map(|(_, load)| loads_in_turn(load));
    std::iter::once(Term::Phrase(first)).chain(next).collect()
}

/// What a sentence tells of the load of one body on another.
fn told_between(declaration: &Declaration) -> Option<Between> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let [Term::Formula(letter)] = subjects.as_slice() else {
        return None;
    };
    let plain = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::Upon | Slot::At);
    let told = LOADS.contains(&what.head) && what.adjectives.is_empty();
    (told && what.slots.iter().all(plain)).then_some(())?;
    Some(Between {
        letter: letter.source.clone(),
        of: what.slot(Slot::Of)?.clone(),
        on: what.slot(Slot::Upon)?.clone(),
        what: what.clone(),
    })
}

/// The same load by who exerts it on this body.
fn by_agent(load: &Term, body: &Term, between: &[Between]) -> Option<Term> {
    let letter = load.letter()?;
    let (source, opposite) = without_sign(letter);
    let told = between.iter().find(|told| told.letter == source)?;
    let (agent, other) = match opposite {
        false => (&told.of, &told.on),
        true => (&told.on, &told.of),
    };
    (other == body).then(|| {
        let mut named = told.what.clone();
        named.slots.retain(|(slot, _)| *slot == Slot::At);
        named.slots.insert(0, (Slot::Of, agent.clone()));
        Term::Phrase(Box::new(named))
    })
}

/// The letter of a formula, and whether a minus stands before it.
fn without_sign(formula: &Formula) -> (&str, bool) {
    let written = formula.source.trim();
    match &formula.row {
        Row::Expression(node) if matches!(node.kind, Kind::Negate(_)) => {
            (written.trim_start_matches('-').trim_start(), true)
        }
        _ => (written, false),
    }
}
