//! Sentences that speak of all loads of a family: "the thrusts of the rotors and the weight are the only loads", "the moment
//! of the thrusts about G", "the sum of the thrusts".

use super::family_places::family_of;
use super::heads::{FORCE, MOMENT};
use super::is_body;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;

/// The loads of each of a family, which sentences tell by letters.
pub(super) struct LoadsOfFamily {
    pub(super) family: String,
    /// The noun of the sentence.
    pub(super) noun: &'static str,
    /// Force or moment.
    pub(super) class: &'static str,
    /// What exerts them, where that is not the family itself.
    pub(super) agent: Option<Term>,
    pub(super) loads: Vec<Formula>,
    /// The members of their sum.
    pub(super) sum: Vec<String>,
    /// Whether the letters are magnitudes.
    pub(super) magnitudes: bool,
    /// How many there are, where sentences tell of each in turn.
    pub(super) count: usize,
    /// Whether sentences only tell that they act there: nobody says what exerts them.
    pub(super) only_placed: bool,
}

/// The forces of which sentences tell where each acts: "the force `$F$` acts at rotor 1".
pub(super) fn placed_forces(declarations: &[Declaration]) -> Option<LoadsOfFamily> {
    let mut loads = vec![];
    let mut families = vec![];
    for declaration in declarations {
        if let Some(([Term::Phrase(force)], [(Slot::At, at)])) = declaration.statement.does("act")
            && let (FORCE, [(Slot::Which, Term::Formula(letter))]) =
                (force.head, force.slots.as_slice())
        {
            loads.push(letter.clone());
            families.push(noun_of_one(at));
        }
    }
    let first = families.first()?.clone();
    let same = families.iter().all(|family| *family == first);
    (loads.len() > 1).then(|| LoadsOfFamily {
        family: first.filter(|_| same).unwrap_or_default(),
        noun: FORCE,
        class: FORCE,
        agent: None,
        sum: loads.iter().map(|load| load.source.clone()).collect(),
        magnitudes: false,
        count: loads.len(),
        only_placed: true,
        loads,
    })
}

/// The noun of one of a family: "rotor 1".
fn noun_of_one(term: &Term) -> Option<String> {
    match term {
        Term::Member { family, .. } => Some(family.clone()),
        Term::Name(name) => {
            let (noun, _) = name.split_once(' ')?;
            is_body(noun).then(|| noun.to_owned())
        }
        Term::Phrase(phrase) => match phrase.slots.as_slice() {
            [(Slot::Which, _)] if is_body(phrase.head) => Some(phrase.head.to_owned()),
            _ => None,
        },
        _ => None,
    }
}

/// Puts the loads by their letters where sentences speak of all of them.
pub(super) fn put_loads(declarations: &mut [Declaration], told: &[LoadsOfFamily], macros: &Macros) {
    for declaration in declarations {
        if let Some(sum) = sum(&declaration.statement, told, macros) {
            declaration.statement = sum;
            continue;
        }
        match &mut declaration.statement {
            Statement::Is { what, .. } | Statement::Premise(what) => put(what, told),
            _ => {}
        }
    }
}

/// In a phrase, and in what hangs on it. What a sentence says of the moment of loads stands behind these.
fn put(phrase: &mut NounPhrase, told: &[LoadsOfFamily]) {
    let mut slots = vec![];
    for (slot, term) in std::mem::take(&mut phrase.slots) {
        let Term::Phrase(mut inner) = term else {
            slots.push((slot, term));
            continue;
        };
        let whole = inner.slots.clone();
        let hung: Vec<(Slot, Term)> = match phrase.head == MOMENT && slot == Slot::Of {
            true => {
                let outer = |(s, _): &(Slot, Term)| matches!(s, Slot::About | Slot::On);
                let (outer, own) = inner.slots.into_iter().partition(outer);
                inner.slots = own;
                outer
            }
            false => vec![],
        };
        match meant(&inner, told) {
            Some(own) => {
                let each = own.loads.iter().map(|load| {
                    let which = vec![(Slot::Which, Term::Formula(load.clone()))];
                    let load = NounPhrase::new(own.class, which);
                    (slot, Term::Phrase(Box::new(load)))
                });
                slots.extend(each);
                slots.extend(hung);
            }
            None => {
                inner.slots = whole;
                put(&mut inner, told);
                slots.push((slot, Term::Phrase(inner)));
            }
        }
    }
    phrase.slots = slots;
}

/// The loads that a noun means: by the family, by what exerts them, or by a noun of their own.
fn meant<'a>(noun: &NounPhrase, told: &'a [LoadsOfFamily]) -> Option<&'a LoadsOfFamily> {
    let mut own = told.iter().filter(|own| own.are(noun));
    own.next().filter(|_| own.next().is_none())
}

impl LoadsOfFamily {
    /// Whether other loads are of the same kind and family.
    pub(super) fn goes_with(&self, other: &Self) -> bool {
        let family = self.family == other.family && self.agent == other.agent;
        let kind = self.noun == other.noun && self.class == other.class;
        family && kind && self.magnitudes == other.magnitudes
    }

    /// Takes in those of other members.
    pub(super) fn take_in(&mut self, other: Self) {
        if self.loads.len() + other.loads.len() <= self.count {
            self.loads.extend(other.loads);
            self.sum.extend(other.sum);
        }
    }

    fn are(&self, noun: &NounPhrase) -> bool {
        let counted = match noun.adjectives.as_slice() {
            [] => false,
            ["four"] => self.loads.len() == 4,
            ["three"] => self.loads.len() == 3,
            ["two"] => self.loads.len() == 2,
            _ => return false,
        };
        let general = matches!(noun.head, FORCE | MOMENT);
        let class = noun.head == self.noun || noun.head == self.class;
        let named = |(slot, term): &(Slot, Term)| match slot {
            Slot::At => self.only_placed && family_of(term, &self.family).is_some(),
            _ if self.only_placed => false,
            Slot::Of | Slot::Upon => {
                family_of(term, &self.family).is_some() || self.agent.as_ref() == Some(term)
            }
            Slot::About => matches!(term, Term::Phrase(_)),
            _ => false,
        };
        let general = general || self.only_placed;
        let by_noun = noun.slots.is_empty() && (!general || counted);
        let by_family = !noun.slots.is_empty() && noun.slots.iter().all(named);
        let all = self.loads.len() == self.count;
        class && all && (by_noun || by_family)
    }
}

/// "`$F$` is the sum of the thrusts of the rotors", "the total thrust of the rotors", "the magnitude of the sum of …".
fn sum(statement: &Statement, told: &[LoadsOfFamily], macros: &Macros) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(_)], of) = (subjects.as_slice(), of_all(what)?) else {
        return None;
    };
    let all = meant(&of, told)?;
    // Of the magnitude of a sum only lengths along one axis tell without roots.
    if what.head == "magnitude" && !all.magnitudes {
        return None;
    }
    let all = &all.sum;
    let sum = formula(&all.join("+"), false, macros)?;
    Some(Statement::Same {
        subjects: subjects.clone(),
        others: vec![Term::Formula(sum)],
    })
}

/// What is said of a letter of which nothing else is known than that it changes with the time.
pub(super) fn function_of_time() -> NounPhrase {
    let time = Term::Phrase(Box::new(NounPhrase::new("time", vec![])));
    NounPhrase::new("function", vec![(Slot::Of, time)])
}

/// The loads of a sum.
fn of_all(what: &NounPhrase) -> Option<NounPhrase> {
    match (what.head, what.slots.as_slice()) {
        ("magnitude", [(Slot::Of, Term::Phrase(inner))]) => of_all(inner),
        ("sum", [(Slot::Of, Term::Phrase(loads))]) => Some((**loads).clone()),
        _ if what.is("total") && what.adjectives.len() == 1 && !what.slots.is_empty() => {
            let mut loads = what.clone();
            loads.adjectives.clear();
            (loads.head != FORCE && loads.head != MOMENT).then_some(loads)
        }
        _ => None,
    }
}
