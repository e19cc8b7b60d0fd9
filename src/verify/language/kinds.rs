//! What kind of thing a name is, as other sentences show it: "the mass centre G of the body" says what G is.

use super::bodies::singular;
use super::heads::{POSITION, UNIT_VECTOR};
use super::lexicon::{Class, Lexicon};
use super::single_moments::axes_in;
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use super::traits::Trait;
use super::{is_body, is_thing};
use crate::notation::ast::Kind;
use crate::notation::document::Row;
use std::collections::BTreeSet;

/// "The top is a rigid body" and then "the body", "D is a disc" and then "the disc", "B is a frame" and then "the frame": of
/// the only thing that is said to be one it is another name.
pub(crate) fn name_the_only_one(declarations: &mut [Declaration], lexicon: &Lexicon) {
    let said = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { what, .. } => lexicon.entry(what.head, &[Class::Thing]),
        _ => None,
    });
    let mut nouns: BTreeSet<&'static str> = said.map(|entry| entry.name).collect();
    nouns.extend(["body", "frame"]);
    for noun in nouns {
        let only = only_one(declarations, noun);
        let Some(only) = only.filter(|only| !are_apart(declarations, noun, only)) else {
            continue;
        };
        for declaration in declarations.iter_mut() {
            for term in declaration.statement.terms_mut() {
                rename(term, noun, &only);
            }
        }
    }
}

/// The only thing that is said to be what a noun means, by another name.
fn only_one(declarations: &[Declaration], noun: &str) -> Option<String> {
    let is_one = |what: &NounPhrase| match noun {
        "body" => what.head != "particle" && is_body(what.head),
        "frame" => what.head == noun && !what.is("inertial"),
        _ => what.head == noun,
    };
    let mut things = BTreeSet::new();
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &declaration.statement
            && is_one(what)
        {
            things.extend(subjects.iter().filter_map(name));
        }
    }
    let only = things.pop_first().filter(|_| things.is_empty());
    only.filter(|only| only != noun)
}

/// Whether two names are those of two things: one sentence speaks of both, or says what kind of thing the first is.
fn are_apart(declarations: &[Declaration], one: &str, other: &str) -> bool {
    let speaks = |d: &Declaration, of: &str| {
        let mut terms = d.statement.terms().into_iter();
        terms.any(|term| name(term).is_some_and(|name| name == of))
    };
    let tells = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let own = |term: &Term| name(term).is_some_and(|name| name == one);
            is_thing(what.head) && subjects.iter().any(own)
        }
        _ => false,
    };
    // What only a part of the document speaks of is no body of the whole.
    let of_a_part = one == "body" && is_of_a_part(declarations, other);
    let everywhere = |d: &Declaration| d.extent == Extent::Document;
    let mut all = declarations.iter();
    all.any(|d| {
        let both = speaks(d, other) || of_a_part && everywhere(d);
        both && speaks(d, one) || tells(d)
    })
}

/// Whether sentences say of a part of the document alone what kind of thing something is.
fn is_of_a_part(declarations: &[Declaration], thing: &str) -> bool {
    let kinds = declarations.iter().filter(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let own = |term: &Term| name(term).is_some_and(|name| name == thing);
            is_body(what.head) && subjects.iter().any(own)
        }
        _ => false,
    });
    let mut kinds = kinds.peekable();
    kinds.peek().is_some() && kinds.all(|d| d.extent != Extent::Document)
}

pub(super) fn rename(term: &mut Term, from: &str, to: &str) {
    let bare = |phrase: &NounPhrase| phrase.slots.is_empty() && phrase.adjectives.is_empty();
    match term {
        Term::Name(name) if name == from => to.clone_into(name),
        Term::Phrase(phrase) if phrase.head == from && bare(phrase) => {
            *term = Term::Name(to.to_owned());
        }
        Term::Phrase(phrase) => {
            for (_, inner) in &mut phrase.slots {
                rename(inner, from, to);
            }
        }
        _ => {}
    }
}

/// "No moment acts on the body about its mass centre G" tells what G is, where no sentence of its own does.
pub(crate) fn tell_mass_centres(declarations: &mut Vec<Declaration>) {
    let told: BTreeSet<String> = declarations
        .iter()
        .filter_map(|declaration| match &declaration.statement {
            Statement::Is { subjects, .. } => Some(subjects.iter().filter_map(name)),
            _ => None,
        })
        .flatten()
        .collect();
    let mut found: Vec<Declaration> = vec![];
    for declaration in declarations.iter() {
        let mentioned = declaration.statement.terms().into_iter();
        let mentioned = mentioned.filter_map(as_phrase);
        let premise = match &declaration.statement {
            Statement::Premise(premise) => Some(premise),
            _ => None,
        };
        for centre in mentioned.chain(premise).filter_map(named_centre) {
            let new = subject_name(&centre).is_some_and(|name| !told.contains(&name));
            if new && !found.iter().any(|known| known.statement == centre) {
                found.push(declaration.saying(centre));
            }
        }
    }
    declarations.extend(found);
}

/// A letter with a hat is a unit vector, which only points there.
fn has_hat(term: &Term) -> bool {
    match term {
        Term::Formula(Formula {
            row: Row::Expression(node),
            ..
        }) => matches!(&node.kind, Kind::Symbol(symbol) if symbol.style.hat),
        _ => false,
    }
}

/// "the vector from O to P": the position of P from O. An axis that points from O to P has the length one.
pub(crate) fn name_positions(declarations: &mut [Declaration]) {
    let axes: Vec<Term> = declarations.iter().flat_map(axes_in).collect();
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == "vector"
            && what.slot(Slot::From).is_some()
            && subjects.iter().any(|subject| axes.contains(subject))
        {
            what.head = UNIT_VECTOR;
        }
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == "vector"
            && !subjects.iter().any(has_hat)
            && let (Some(_), Some(to)) = (what.slot(Slot::From), what.slot(Slot::To).cloned())
        {
            what.head = POSITION;
            what.slots.retain(|(slot, _)| *slot != Slot::To);
            what.slots.insert(0, (Slot::Of, to));
        }
    }
}

/// "The rod is a uniform body of length `$l$`": what is called a rod is one. Where nothing else says what the disc is, "the
/// disc is uniform" says it.
pub(crate) fn shape_by_name(declarations: &mut [Declaration], lexicon: &Lexicon) {
    let shaped = |statement: &Statement| match statement {
        Statement::Is { subjects, what } => {
            Some(subjects.clone()).filter(|_| lexicon.entry(what.head, &[Class::Thing]).is_some())
        }
        _ => None,
    };
    let shaped: Vec<Vec<Term>> = declarations
        .iter()
        .filter_map(|d| shaped(&d.statement))
        .collect();
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == "uniform"
            && what.slots.is_empty()
            && !shaped.contains(subjects)
            && let [Term::Name(called)] = subjects.as_slice()
            && let Some(thing) = lexicon.entry(called, &[Class::Thing])
            && thing.traits.has(Trait::Shape)
        {
            what.head = "body";
            what.adjectives.push("uniform");
        }
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == "body"
            && what.is("uniform")
            && let [Term::Name(called)] = subjects.as_slice()
            && let Some(thing) = lexicon.entry(called, &[Class::Thing])
        {
            what.head = thing.name;
        }
    }
}

/// "A is a frame with the axes x, y, z": these are its axes.
pub(crate) fn tell_axes(declarations: &mut Vec<Declaration>) {
    let mut at = 0;
    while at < declarations.len() {
        let axes = take_axes(&mut declarations[at].statement);
        let axes = axes.map(|axes| declarations[at].saying(axes));
        at += 1;
        if let Some(axes) = axes {
            declarations.insert(at, axes);
        }
    }
}

/// The axes of a frame, taken out of what says that it is one.
fn take_axes(statement: &mut Statement) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let axes: Vec<Term> = what.all(Slot::With).cloned().collect();
    let named = axes.iter().all(|axis| name(axis).is_some());
    let [frame] = subjects.as_slice() else {
        return None;
    };
    if what.head != "frame" || !named || axes.len() != 3 {
        return None;
    }
    what.slots.retain(|(slot, _)| *slot != Slot::With);
    Some(Statement::Is {
        subjects: axes,
        what: NounPhrase::new("axes", vec![(Slot::Of, frame.clone())]),
    })
}

/// "P is a particle of mass `$m$` at E": it lies there.
pub(crate) fn place_particles(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let at: Vec<(Slot, Term)> = what
            .slots
            .iter()
            .filter(|(slot, at)| *slot == Slot::At && !at.is_condition())
            .cloned()
            .collect();
        if what.head != "particle" || at.len() != 1 {
            return vec![];
        }
        what.slots.retain(|said| !at.contains(said));
        vec![Statement::Does {
            subjects: subjects.clone(),
            verb: "lie",
            slots: at,
        }]
    });
}

/// "link 1" is a body of this name where no letter numbers the links.
pub(crate) fn name_numbered(declarations: &mut [Declaration]) {
    let numbered: BTreeSet<String> = declarations
        .iter()
        .flat_map(|d| d.statement.terms())
        .filter_map(|term| match term {
            Term::Member { family, index } if !is_number(index) => Some(family.clone()),
            // "`$i$` numbers the links", "the arm consists of links"
            Term::Name(plural) => singular(plural),
            _ => None,
        })
        .collect();
    let terms = declarations.iter_mut();
    for term in terms.flat_map(|d| d.statement.terms_mut()) {
        name_member(term, &numbered);
    }
    declarations.iter_mut().for_each(count_parts_once);
}

/// "It consists of two links, link 1 and link 2": these are the two.
fn count_parts_once(declaration: &mut Declaration) {
    if let Statement::Does {
        verb: "consist",
        slots,
        ..
    } = &mut declaration.statement
    {
        let mut parts = vec![];
        slots.retain(|part| {
            let new = !parts.contains(part);
            parts.push(part.clone());
            new
        });
    }
}

fn is_number(index: &Formula) -> bool {
    index.source.chars().all(|c| c.is_ascii_digit())
}

fn name_member(term: &mut Term, numbered: &BTreeSet<String>) {
    match term {
        Term::Member { family, index } if is_number(index) && !numbered.contains(family) => {
            *term = Term::Name(format!("{family} {}", index.source));
        }
        Term::Phrase(phrase) => {
            let inner = phrase.slots.iter_mut();
            inner.for_each(|(_, term)| name_member(term, numbered));
        }
        _ => {}
    }
}

/// "B is the frame of the disc": it is fixed in the disc.
pub(crate) fn fix_frames(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && matches!(what.head, "frame" | "point")
            && !what.is("fixed")
            && what.slot(Slot::FixedIn).is_none()
        {
            let of_thing = |(slot, term): &&mut (Slot, Term)| {
                *slot == Slot::Of && matches!(term, Term::Name(_) | Term::Member { .. })
            };
            let own = what.slots.iter_mut().filter(of_thing);
            own.for_each(|(slot, _)| *slot = Slot::FixedIn);
        }
    }
}

/// "The mass centre G of the body", "the body with its mass centre at G": the statement that G is it.
fn named_centre(phrase: &NounPhrase) -> Option<Statement> {
    let called = phrase.slot(Slot::Which).or(phrase.slot(Slot::At))?;
    let of = phrase
        .slot(Slot::Of)
        .filter(|_| phrase.head == "mass centre")?;
    name(called)?;
    Some(Statement::Is {
        subjects: vec![called.clone()],
        what: NounPhrase::new(phrase.head, vec![(Slot::Of, of.clone())]),
    })
}

fn as_phrase(term: &Term) -> Option<&NounPhrase> {
    match term {
        Term::Phrase(phrase) => Some(phrase),
        _ => None,
    }
}

/// Whether a sentence says what kind of body a thing is.
pub(super) fn is_said_to_be_body(thing: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => is_body(what.head) && subjects.contains(thing),
        _ => false,
    })
}

/// A thing by its name, plain or between dollar signs.
pub(super) fn name(term: &Term) -> Option<String> {
    match term {
        Term::Name(name) => Some(name.clone()),
        Term::Formula(formula) => Some(formula.source.clone()),
        _ => None,
    }
}

fn subject_name(statement: &Statement) -> Option<String> {
    match statement {
        Statement::Is { subjects, .. } => name(subjects.first()?),
        _ => None,
    }
}
