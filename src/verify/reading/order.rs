//! In which order sentences about letters are read: behind those that tell the letters which they speak of.

use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::{CONJUGATE, CONSTANT, SCALAR_PART, SECOND_RATE, VECTOR_PART};
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::reading::definitions_read::definition_in;
use crate::verify::reading::loads_read::acting_force;
use crate::verify::reading::names::{PRINCIPAL_MOMENTS, UNIT_VECTOR, node_of, tells_gravity};
use crate::verify::term::letters::{loosely, spelled};
use foldhash::HashMap;
use std::collections::BTreeSet;

/// The sentences that stand before those about loads.
pub(super) const BEFORE_LOADS: usize = 0;

/// What is said of a letter without telling what it is.
const TRAITS: [&str; 8] = [
    "orthogonal",
    "horizontal",
    "zero",
    "nonzero",
    "positive",
    "negative",
    "small",
    "symmetric",
];

/// Signs of letters, which are read when the letters are known.
const SIGNS: [&str; 2] = ["positive", "negative"];

/// The sentences, each with its stage, in the order in which they are read.
///
/// One that speaks of a letter comes behind all that tell what this letter is. Among those that may be read the stage
/// decides, and then the place. Where letters go round in a circle the first one is read as it stands.
pub(super) fn in_order(declarations: &[Declaration]) -> Vec<(usize, &Declaration)> {
    let mut order = Order::of(declarations);
    let mut sorted = Vec::with_capacity(declarations.len());
    while let Some((stage, n)) = order.next() {
        sorted.extend(declarations.get(n).map(|declaration| (stage, declaration)));
    }
    sorted
}

/// Which sentences wait for which letters.
#[derive(Default)]
struct Order {
    stages: Vec<usize>,
    /// The letters that a sentence tells.
    tells: Vec<Vec<String>>,
    /// How many of the letters that a sentence speaks of are not told yet.
    missing: Vec<usize>,
    /// How many sentences are still to tell a letter.
    untold: HashMap<String, usize>,
    /// The sentences that wait for a letter.
    waiting: HashMap<String, Vec<usize>>,
    ready: BTreeSet<(usize, usize)>,
    blocked: BTreeSet<(usize, usize)>,
}

impl Order {
    fn of(declarations: &[Declaration]) -> Self {
        let mut order = Self::default();
        let told = declarations.iter().filter(|d| !is_constant(d));
        let told: BTreeSet<String> = told.flat_map(|d| told_letters(&d.statement)).collect();
        for declaration in declarations {
            let mut tells = told_letters(&declaration.statement);
            if is_constant(declaration) {
                tells.retain(|letter| !told.contains(letter));
            }
            for letter in &tells {
                *order.untold.entry(letter.clone()).or_default() += 1;
            }
            order.stages.push(stage_of(&declaration.statement));
            order.tells.push(tells);
        }
        for (n, declaration) in declarations.iter().enumerate() {
            let keys = order.awaited(n, &declaration.statement);
            let place = (order.stages[n], n);
            match keys.is_empty() {
                true => order.ready.insert(place),
                false => order.blocked.insert(place),
            };
            order.missing.push(keys.len());
            for key in keys {
                order.waiting.entry(key).or_default().push(n);
            }
        }
        order
    }

    /// The letters that other sentences must tell before this one.
    fn awaited(&self, n: usize, statement: &Statement) -> BTreeSet<String> {
        let mentioned = mentioned_letters(statement);
        let keys = mentioned.into_iter().filter_map(|[exact, loose]| {
            match self.untold.contains_key(&exact) {
                true => Some(exact),
                false => self.untold.contains_key(&loose).then_some(loose),
            }
        });
        keys.filter(|key| !self.tells[n].contains(key)).collect()
    }

    fn next(&mut self) -> Option<(usize, usize)> {
        let next = self.ready.pop_first();
        let (stage, n) = next.or_else(|| self.blocked.pop_first())?;
        for letter in std::mem::take(&mut self.tells[n]) {
            let Some(untold) = self.untold.get_mut(&letter) else {
                continue;
            };
            *untold -= 1;
            if *untold > 0 {
                continue;
            }
            for waiting in self.waiting.remove(&letter).unwrap_or_default() {
                self.missing[waiting] -= 1;
                let place = (self.stages[waiting], waiting);
                if self.missing[waiting] == 0 && self.blocked.remove(&place) {
                    self.ready.insert(place);
                }
            }
        }
        Some((stage, n))
    }
}

/// Whether a sentence says that letters are constant, which tells what they are only where no other sentence does.
fn is_constant(declaration: &Declaration) -> bool {
    matches!(&declaration.statement, Statement::Is { what, .. } if what.head == CONSTANT)
}

/// The letters that a sentence says something to be, exactly and loosely.
fn told_letters(statement: &Statement) -> Vec<String> {
    if matches!(statement, Statement::Is { what, .. } if TRAITS.contains(&what.head)) {
        return vec![];
    }
    if let Statement::Holds(formula) = statement {
        let defined = definition_in(formula).map(|(letter, _)| keys(letter));
        return defined.into_iter().flatten().collect();
    }
    let (Statement::Is { subjects, .. }
    | Statement::Same { subjects, .. }
    | Statement::Does {
        subjects,
        verb: "take",
        ..
    }) = statement
    else {
        return vec![];
    };
    let letters = subjects.iter().filter_map(|subject| match subject {
        Term::Formula(formula) => node_of(formula),
        _ => None,
    });
    let keys: BTreeSet<String> = letters.flat_map(keys).collect();
    keys.into_iter().collect()
}

/// A letter as written, and with its marks of vectors taken off.
fn keys(node: &Node) -> [String; 2] {
    [exact_key(node), format!("~{}", loosely(node))]
}

pub(crate) fn exact_key(node: &Node) -> String {
    format!("={}", spelled(node))
}

/// The letters that stand in what is said.
pub(crate) fn mentioned_letters(statement: &Statement) -> Vec<[String; 2]> {
    let mut letters = vec![];
    match statement {
        Statement::Is { subjects, what } => {
            in_slots(&what.slots, &mut letters);
            if what.head == CONSTANT || SIGNS.contains(&what.head) {
                subjects.iter().for_each(|t| in_term(t, &mut letters));
            }
        }
        Statement::Does { slots, .. } => in_slots(slots, &mut letters),
        Statement::Holds(formula) => {
            if let Some((_, right)) = definition_in(formula) {
                in_formula(&Formula::of(right), &mut letters);
            }
        }
        Statement::Same { others, .. } => others.iter().for_each(|t| in_term(t, &mut letters)),
        _ => {}
    }
    letters
}

fn in_slots(slots: &[(Slot, Term)], letters: &mut Vec<[String; 2]>) {
    slots.iter().for_each(|(_, term)| in_term(term, letters));
}

fn in_term(term: &Term, letters: &mut Vec<[String; 2]>) {
    match term {
        Term::Formula(formula) => in_formula(formula, letters),
        Term::Phrase(phrase) => in_slots(&phrase.slots, letters),
        _ => {}
    }
}

fn in_formula(formula: &Formula, letters: &mut Vec<[String; 2]>) {
    let Some(node) = node_of(formula) else {
        return;
    };
    letters.push(keys(node));
    let mut nodes: Vec<&Node> = node.children().collect();
    while let Some(node) = nodes.pop() {
        if matches!(node.kind, Kind::Symbol(_)) {
            letters.push(keys(node));
        }
        nodes.extend(node.children());
    }
}

/// Which sentences come first among those that wait for no letter.
fn stage_of(statement: &Statement) -> usize {
    match statement {
        Statement::Does {
            verb: "have components",
            ..
        } => 2,
        Statement::Is { what, .. } => match what.head {
            "position" if what.all(Slot::Of).any(|of| acting_force(of).is_some()) => 2,
            _ if tells_gravity(what) => BEFORE_LOADS,
            "vector" | UNIT_VECTOR | "mass" | "position" => BEFORE_LOADS,
            CONSTANT => 3,
            "positive" => BEFORE_LOADS,
            "negative" => 4,
            "component" | PRINCIPAL_MOMENTS | "Lagrangian" | "moment" | "magnitude" | "rate"
            | SECOND_RATE | "entry" | CONJUGATE | SCALAR_PART | VECTOR_PART => 2,
            "angle" | "total energy" => 2,
            _ => 1,
        },
        Statement::Same { .. } => 4,
        Statement::Means { .. } => 5,
        _ => 1,
    }
}
