//! Things of one noun that have names, where sentences speak of them together: "P is a ball. Q is a ball. The body consists of
//! the rod and the balls."

use super::counted_by_name::named_things;
use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Words before a noun by which all of its things are meant.
const ALL: [&str; 4] = ["two", "three", "four", "both"];

/// Words before a noun in the singular by which each of its things is meant.
const EACH: [&str; 2] = ["each", "every"];

/// Puts the names of things where sentences speak of all of them by their noun.
pub(crate) fn name_groups(declarations: &mut [Declaration]) {
    for (noun, names) in groups(declarations) {
        let group = Group { noun, names };
        for declaration in declarations.iter_mut() {
            if group.is_meant(&declaration.text) {
                group.put_names(&mut declaration.statement);
            }
        }
    }
}

/// Things of one noun.
struct Group {
    noun: &'static str,
    names: Vec<Term>,
}

/// The nouns of which sentences name several things.
fn groups(declarations: &[Declaration]) -> Vec<(&'static str, Vec<Term>)> {
    let mut found: Vec<(&'static str, Vec<Term>)> = vec![];
    for declaration in declarations {
        let Statement::Is { what, .. } = &declaration.statement else {
            continue;
        };
        let known = found.iter().any(|(noun, _)| *noun == what.head);
        if known || !is_body(what.head) {
            continue;
        }
        let names = named_things(what.head, declarations);
        if names.len() > 1 {
            found.push((what.head, names));
        }
    }
    found
}

impl Group {
    /// Whether a sentence speaks of all, and not of one by its noun.
    fn is_meant(&self, text: &str) -> bool {
        let text = text.to_lowercase();
        let words: Vec<&str> = text
            .split(|c: char| !c.is_alphabetic() && c != '-')
            .collect();
        let plural = format!("{}s", self.noun);
        let each = |pair: &[&str]| EACH.contains(&pair[0]) && pair[1] == self.noun;
        words.contains(&plural.as_str()) || words.windows(2).any(each)
    }

    /// "the balls", "both balls"
    fn are(&self, term: &Term) -> bool {
        match term {
            Term::Phrase(all) => {
                let own = all.head == self.noun && all.slots.is_empty();
                own && all.adjectives.iter().all(|said| ALL.contains(said))
            }
            term => {
                name(term).is_some_and(|name| name.strip_suffix('s').unwrap_or(&name) == self.noun)
            }
        }
    }

    fn put_names(&self, statement: &mut Statement) {
        match statement {
            Statement::Is { subjects, what } if what.head != self.noun => self.put_among(subjects),
            Statement::Does {
                verb: "consist",
                slots,
                ..
            } => self.put_in_slots(slots),
            Statement::Premise(NounPhrase { slots, .. }) => self.put_in_slots(slots),
            _ => {}
        }
    }

    fn put_among(&self, subjects: &mut Vec<Term>) {
        if let Some(at) = subjects.iter().position(|subject| self.are(subject)) {
            subjects.splice(at..=at, self.names.iter().cloned());
        }
    }

    fn put_in_slots(&self, slots: &mut Vec<(Slot, Term)>) {
        if let Some(at) = slots.iter().position(|(_, term)| self.are(term)) {
            let slot = slots[at].0;
            let names = self.names.iter().map(|name| (slot, name.clone()));
            slots.splice(at..=at, names);
        }
    }
}
