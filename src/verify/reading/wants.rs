//! What a sentence of which nothing was made waits for: a name that no sentence explains, another sentence, a direction.

use crate::verify::language::statement::{Declaration, Slot, Statement, Term};
use crate::verify::language::wants::Wants;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{name_of, node_of};
use crate::verify::reading::shapes_read::is_shape;
use crate::verify::term::letters::spelled;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// Slots that hold things.
const OF_THINGS: [Slot; 10] = [
    Slot::On,
    Slot::RelativeTo,
    Slot::About,
    Slot::From,
    Slot::At,
    Slot::To,
    Slot::FixedIn,
    Slot::Through,
    Slot::Along,
    Slot::Of,
];

impl Builder<'_> {
    /// Says of each sentence of which nothing was made what would help, where that is known.
    pub(super) fn say_what_unused_want(&mut self, known: &BTreeMap<String, Wants>) {
        let unused = self.reading.unused.iter();
        let unused: BTreeSet<String> = unused.map(|unused| unused.sentence.clone()).collect();
        if unused.is_empty() {
            return;
        }
        let is_unused = |d: &Declaration| unused.contains(d.sentence());
        let mut tellers: HashMap<String, Vec<&Declaration>> = HashMap::new();
        for declaration in self.declarations {
            for name in told_in(&declaration.statement) {
                tellers.entry(name).or_default().push(declaration);
            }
        }
        let wanting = self.declarations.iter().rev().filter(|d| is_unused(d));
        let wanted = wanting.filter_map(|d| {
            let wants = self.wanted_by(d, &tellers, is_unused)?;
            Some((d.sentence(), wants))
        });
        let wanted: BTreeMap<&str, Wants> = wanted.collect();
        for unused in &mut self.reading.unused {
            let known = known.get(&unused.sentence).cloned();
            unused.wants = known.or_else(|| wanted.get(unused.sentence.as_str()).cloned());
        }
    }

    fn wanted_by(
        &self,
        declaration: &Declaration,
        tellers: &HashMap<String, Vec<&Declaration>>,
        is_unused: impl Fn(&Declaration) -> bool,
    ) -> Option<Wants> {
        let statement = &declaration.statement;
        for (slot, thing) in things_in(statement) {
            let Some(name) = name_of(thing).filter(|_| !self.is_known(thing)) else {
                continue;
            };
            let mut others = tellers.get(&name).into_iter().flatten();
            match others.find(|d| d.text != declaration.text) {
                None => return Some(what_is(*slot, name)),
                Some(other) if is_unused(other) => {
                    return Some(Wants::Sentence(other.sentence().to_owned()));
                }
                Some(_) => {}
            }
        }
        self.told_otherwise(declaration)
            .or_else(|| self.wanted_by_shape(statement))
    }

    /// Whether a letter or a name stands for something.
    fn is_known(&self, term: &Term) -> bool {
        let letter = match term {
            Term::Formula(formula) => node_of(formula),
            _ => None,
        };
        let mut letters = self.reading.letters.letters.iter();
        let means = |node| letters.any(|letter| letter.spelled == spelled(node));
        let names = |name: String| {
            self.frames.contains_key(&name)
                || self.points.contains_key(&name)
                || self.bodies.contains_key(&name)
                || self.axes.get(&name).is_some()
        };
        letter.is_some_and(means) || name_of(term).is_none_or(names)
    }

    /// Another sentence that says what the letter of this one is.
    fn told_otherwise(&self, declaration: &Declaration) -> Option<Wants> {
        let Statement::Is { subjects, .. } = &declaration.statement else {
            return None;
        };
        let [Term::Formula(letter)] = subjects.as_slice() else {
            return None;
        };
        let node = node_of(letter)?;
        let mut told = self.reading.letters.letters.iter();
        let told = told.find(|l| l.spelled == spelled(node) && l.sentence != declaration.text)?;
        Some(Wants::Alone(told.sentence.trim_end_matches('.').to_owned()))
    }

    /// A shape has to lie along an axis.
    fn wanted_by_shape(&self, statement: &Statement) -> Option<Wants> {
        let Statement::Is { subjects, what } = statement else {
            return None;
        };
        let body = subjects.first().and_then(|term| self.body(term))?;
        let shaped = is_shape(what.head) && self.reading.system.bodies[body].inertia.is_none();
        shaped.then(|| Wants::Direction(what.head.to_owned()))
    }
}

/// The letters and short names of things that a sentence names besides its subject.
fn things_in(statement: &Statement) -> impl Iterator<Item = &(Slot, Term)> {
    let slots = statement.slots().flatten();
    slots.filter(|(slot, term)| OF_THINGS.contains(slot) && is_short(term))
}

/// What is missing in a slot.
fn what_is(slot: Slot, name: String) -> Wants {
    match slot {
        Slot::On | Slot::RelativeTo | Slot::FixedIn => Wants::Frame(name),
        Slot::From | Slot::At | Slot::Through => Wants::Point(name),
        _ => Wants::Name(name),
    }
}

/// A lone letter, or a name that is no noun.
fn is_short(term: &Term) -> bool {
    match term {
        Term::Formula(formula) => {
            node_of(formula).is_some_and(|node| node.children().next().is_none())
        }
        Term::Name(name) => {
            name.chars().next().is_some_and(char::is_uppercase) && !name.contains(' ')
        }
        _ => false,
    }
}

/// The names of which a sentence says something, or which it gives to something: "a disc of mass `$m$`".
fn told_in(statement: &Statement) -> impl Iterator<Item = String> {
    let slots = statement.slots().flatten();
    let given = slots.filter(|(slot, _)| *slot == Slot::Which);
    let given = given.map(|(_, term)| term);
    statement.subjects().iter().chain(given).filter_map(name_of)
}
