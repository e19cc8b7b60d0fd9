//! Parts that a sentence lists by name behind their plural: "the robot consists of the motors P and Q", and then "the
//! motors", "the thrust of motor P", "the distance of the motors from G".

use super::bodies::singular;
use super::heads::CONSTANT;
use super::kinds::name;
use super::rigid_wholes::has_frame;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};
use super::traits::is_force;
use crate::notation::ast::{Kind, Node, Symbol};

/// What is said of parts by their plural is said in the terms that the model has.
pub(crate) fn tell_parts_by_plural(declarations: &mut Vec<Declaration>) {
    act_where_said(declarations);
    for parts in listed_parts(declarations) {
        for declaration in declarations.iter_mut() {
            parts.part_list_of_loads(&mut declaration.statement);
            for term in declaration.statement.terms_mut() {
                parts.leave_owner_of_loads(term);
            }
        }
        let told: Vec<Option<Statement>> = declarations
            .iter()
            .map(|d| parts.told_plainly(&d.statement, declarations))
            .collect();
        for (declaration, told) in declarations.iter_mut().zip(told) {
            if let Some(statement) = told {
                declaration.statement = statement;
            }
        }
    }
}

/// The parts of a whole by the noun before their names.
struct Parts {
    plural: String,
    names: Vec<String>,
    /// Whether a frame is fixed in the whole.
    rigid: bool,
}

/// The parts of each whole that have one noun.
fn listed_parts(declarations: &[Declaration]) -> Vec<Parts> {
    let consist = declarations
        .iter()
        .filter_map(|d| d.statement.does("consist"));
    let parts = consist.filter_map(|(wholes, slots)| {
        let [whole] = wholes else {
            return None;
        };
        let names: Option<Vec<String>> = slots
            .iter()
            .map(|(_, part)| match part {
                Term::Name(part) => Some(part.clone()),
                _ => None,
            })
            .collect();
        let names = names.filter(|names| names.len() > 1)?;
        Some(Parts {
            plural: plural_of(&names, declarations)?,
            names,
            rigid: has_frame(whole, declarations),
        })
    });
    parts.collect()
}

/// The plural that sentences use, where one of the parts is said to be one of these.
fn plural_of(names: &[String], declarations: &[Declaration]) -> Option<String> {
    let is_one = |noun: &str| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = subjects.iter().filter_map(name);
                what.head == noun && own.into_iter().any(|own| names.contains(&own))
            }
            _ => false,
        })
    };
    let mut plurals = declarations.iter().flat_map(|d| plurals_in(&d.statement));
    plurals.find(|plural| singular(plural).is_some_and(|noun| is_one(&noun)))
}

/// The names that hang on the nouns of a sentence.
fn plurals_in(statement: &Statement) -> Vec<String> {
    fn collect(term: &Term, found: &mut Vec<String>) {
        match term {
            Term::Name(name) => found.push(name.clone()),
            Term::Phrase(phrase) => phrase.slots.iter().for_each(|(_, t)| collect(t, found)),
            _ => {}
        }
    }
    let mut found = vec![];
    for term in statement.terms() {
        collect(term, &mut found);
    }
    if let Statement::Is { what, .. } = statement {
        what.slots.iter().for_each(|(_, t)| collect(t, &mut found));
    }
    found
}

impl Parts {
    /// "the thrusts of the motors and the moment `$M$`" are two loads of a list, and not the thrusts of both.
    fn part_list_of_loads(&self, statement: &mut Statement) {
        let Statement::Premise(premise) = statement else {
            return;
        };
        let mut besides = vec![];
        for (_, term) in premise.slots.iter_mut().filter(|(s, _)| *s == Slot::With) {
            let Term::Phrase(load) = term else { continue };
            let [(_, Term::Name(first)), ..] = load.slots.as_slice() else {
                continue;
            };
            if is_force(load.head) && *first == self.plural {
                let others = load.slots.split_off(1);
                let (loads, own): (Vec<_>, Vec<_>) = others
                    .into_iter()
                    .partition(|(slot, of)| *slot == Slot::Of && matches!(of, Term::Formula(_)));
                load.slots.extend(own);
                besides.extend(loads.into_iter().map(|(_, load)| (Slot::With, load)));
            }
        }
        premise.slots.extend(besides);
    }

    /// "the thrusts of the motors" are the thrusts, where no others are told.
    fn leave_owner_of_loads(&self, term: &mut Term) {
        if let Term::Phrase(phrase) = term {
            let own = |of: &Term| match of {
                Term::Name(name) => *name == self.plural,
                Term::Phrase(of) => {
                    of.slots.is_empty() && singular(&self.plural).as_deref() == Some(of.head)
                }
                _ => false,
            };
            if is_force(phrase.head) && phrase.slots.len() == 1 {
                phrase.slots.retain(|(_, of)| !own(of));
            }
            for (_, inner) in &mut phrase.slots {
                self.leave_owner_of_loads(inner);
            }
        }
    }

    /// "The weights are the only loads on the links": on each of them by its name.
    fn with_names(&self, premise: &NounPhrase) -> Option<Statement> {
        let all = |(slot, of): &(Slot, Term)| {
            *slot == Slot::Of && name(of).as_ref() == Some(&self.plural)
        };
        let at = premise.slots.iter().position(all)?;
        let mut named = premise.clone();
        let names = self.names.iter();
        let names = names.map(|name| (Slot::Of, Term::Name(name.clone())));
        named.slots.splice(at..=at, names);
        Some(Statement::Premise(named))
    }

    /// A distance of parts of a rigid body, along which they are placed, is constant.
    fn told_plainly(&self, said: &Statement, all: &[Declaration]) -> Option<Statement> {
        if let Statement::Premise(premise) = said {
            return self.with_names(premise);
        }
        let Statement::Is { subjects, what } = said else {
            return None;
        };
        let ([Term::Formula(letter)], "distance", true) =
            (subjects.as_slice(), what.head, self.rigid)
        else {
            return None;
        };
        let from = what.slot(Slot::RelativeTo)?;
        let of = what.slot(Slot::Of).and_then(name)?;
        let parts = match self.names.iter().find(|name| **name == of) {
            Some(one) => std::slice::from_ref(one),
            None if of == self.plural => &self.names[..],
            None => return None,
        };
        let told = parts
            .iter()
            .all(|part| is_placed_by(part, from, letter, all));
        told.then(|| Statement::Is {
            subjects: subjects.clone(),
            what: NounPhrase::new(CONSTANT, vec![]),
        })
    }
}

/// "The thrust of P is `$F$`. The thrust of P acts at P": the thrust `$F$` acts at P.
fn act_where_said(declarations: &mut Vec<Declaration>) {
    let mut at = 0;
    while at < declarations.len() {
        let Some((noun, of, letter)) = load_of_part(&declarations[at].statement) else {
            at += 1;
            continue;
        };
        let acts = declarations.iter().position(|d| {
            let act = d.statement.does("act");
            act.is_some_and(|(subjects, slots)| match subjects {
                [Term::Phrase(load)] => {
                    let owner = load.slot(Slot::Of).and_then(name);
                    let own = load.head == noun && owner.as_deref() == Some(&of);
                    own && load.slots.len() == 1 && slots.len() == 1
                }
                _ => false,
            })
        });
        if let Some(acts) = acts
            && let Statement::Does { subjects, .. } = &mut declarations[acts].statement
        {
            let load = NounPhrase::new(noun, vec![(Slot::Which, letter)]);
            *subjects = vec![Term::Phrase(Box::new(load))];
            declarations.remove(at);
            continue;
        }
        at += 1;
    }
}

/// A force that is a product of letters, by its noun and whose it is.
fn load_of_part(statement: &Statement) -> Option<(&'static str, String, Term)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([letter @ Term::Formula(formula)], [(Slot::Of, Term::Name(of))]) =
        (subjects.as_slice(), what.slots.as_slice())
    else {
        return None;
    };
    let plain = what.adjectives.is_empty() && is_force(what.head);
    let product = !matches!(formula.node()?.kind, Kind::Symbol(_));
    (plain && product).then(|| (what.head, of.clone(), letter.clone()))
}

/// Whether a sentence places a point from another one by a vector in which a letter stands.
fn is_placed_by(part: &str, from: &Term, letter: &Formula, all: &[Declaration]) -> bool {
    all.iter().any(|d| {
        let placed = d.statement.does("place");
        placed.is_some_and(|(subjects, slots)| {
            let own = subjects
                .iter()
                .any(|s| name(s).is_some_and(|name| name == part));
            let by = match slot(slots, Slot::By) {
                Some(Term::Formula(by)) => stands_in(letter, by),
                _ => false,
            };
            own && by && slot(slots, Slot::From) == Some(from)
        })
    })
}

/// Whether a letter stands in a formula.
fn stands_in(letter: &Formula, formula: &Formula) -> bool {
    fn holds(node: &Node, letter: &Symbol) -> bool {
        let own = matches!(&node.kind, Kind::Symbol(symbol) if symbol == letter);
        own || node.children().any(|child| holds(child, letter))
    }
    let (Some(letter), Some(node)) = (letter.node(), formula.node()) else {
        return false;
    };
    match &letter.kind {
        Kind::Symbol(letter) => holds(node, letter),
        _ => false,
    }
}
