//! What a noun leaves to the words around it: whose it is, which one, and what is meant by several.

use super::lexicon::Class;
use super::reader::{Reader, is_glue};
use super::statement::{NounPhrase, Slot, Statement, Term};
use super::words::Kind;

/// Words before a noun that nobody knows, at most.
const MOST_UNKNOWN: usize = 2;

/// Nouns for what belongs to a letter, and not to the thing whose quantity it is.
const OF_LETTERS: [&str; 9] = [
    "rate",
    "second rate",
    "component",
    "magnitude",
    "direction",
    "value",
    "reference value",
    "first-order change",
    "entry",
];

/// Whether "its" before a noun means a letter, and not the thing whose quantity this is.
pub(crate) fn of_letters(noun: &str) -> bool {
    OF_LETTERS.contains(&noun)
}

/// Places that belong to the body that a sentence speaks of, where it says no other: "the moment on the hub about the mass
/// centre".
pub(crate) const OWNED: [&str; 3] = ["mass centre", "symmetry axis", "spin axis"];

/// Nouns whose letter says which one is meant.
const INDEXED: [&str; 6] = ["component", "entry", "row", "column", "axis", "axes"];

impl Reader<'_> {
    /// "`$r$` is the position of P; `$v$` is its velocity": a letter has a magnitude, and the thing has a velocity.
    pub(crate) fn belongs_to_thing(&self, phrase: &mut NounPhrase, owned: bool) {
        let Some(thing) = self.thing.as_ref().filter(|_| owned) else {
            return;
        };
        let of_letters = self
            .lexicon
            .entry(phrase.head, &[Class::Noun])
            .is_some_and(|noun| {
                noun.slot("in components on").is_none()
                    && noun.slot("at").is_none()
                    && noun.name != "mass"
            });
        if of_letters || OF_LETTERS.contains(&phrase.head) || phrase.head == "disturbance" {
            return;
        }
        for (slot, term) in &mut phrase.slots {
            let of_thing = |p: &NounPhrase| p.slot(Slot::Of) == Some(thing);
            let names_quantity = match term {
                Term::Formula(_) => true,
                Term::Phrase(p) => of_thing(p) || p.head == "axes",
                _ => false,
            };
            if *slot == Slot::Of && names_quantity {
                *term = thing.clone();
            }
        }
    }

    /// Whether a body is named only to say which noun is meant: "the string tension", "the ship frame B".
    pub(crate) fn qualifies(&self, ahead: usize) -> bool {
        let rest = self.following(ahead);
        let noun = self.lexicon.find(rest, &[Class::Noun, Class::Place]);
        let verb = self.lexicon.find(rest, &[Class::Verb]);
        noun.is_some_and(|noun| verb.is_none_or(|verb| verb.length < noun.length))
    }

    /// Whether a noun only says what kind of thing a name or a letter is: "the pivot O", "the speed `$u$`".
    pub(crate) fn is_named(&self, phrase: &NounPhrase) -> bool {
        let kinds = [Class::Noun, Class::Place];
        self.lexicon.entry(phrase.head, &kinds).is_some() && !INDEXED.contains(&phrase.head)
    }

    /// How many words that nobody knows stand before a noun with its name: "the stability axes S". The name says enough.
    pub(crate) fn unknown_before_name(&self) -> Option<usize> {
        let unknown = |ahead: usize| {
            let word = self.word_at(ahead);
            !word.is_empty() && !self.lexicon.begins(word) && !is_glue(word)
        };
        let skipped = (0..MOST_UNKNOWN)
            .take_while(|&ahead| unknown(ahead))
            .count();
        let noun = self
            .lexicon
            .find(self.following(skipped), &[Class::Noun, Class::Place])?;
        let named = self.tokens.get(self.at + skipped + noun.length);
        let name = named.is_some_and(|named| match named.kind {
            Kind::Formula | Kind::Plain => true,
            Kind::Word => named.text.starts_with(char::is_uppercase),
            _ => false,
        });
        let place = noun.entry.name == "frame" || noun.entry.name == "axes";
        (skipped > 0 && (name || place)).then_some(skipped)
    }
}

/// "`$p$` and `$q$` are the rates of `$a$` and `$b$`", "the angular momenta of the body about O and about G": what hangs on
/// a noun as often as there are subjects is said of each in turn.
pub(crate) fn each_of_its_own(subjects: Vec<Term>, what: NounPhrase) -> Vec<Statement> {
    let alike = |terms: &[&Term]| terms.iter().all(|t| matches!(t, Term::Formula(_)));
    let things = |terms: &[&Term]| terms.iter().all(|t| !matches!(t, Term::Phrase(_)));
    let letters: Vec<&Term> = subjects.iter().collect();
    let parted = |slot: Slot| {
        let terms: Vec<&Term> = what.all(slot).collect();
        let several = terms.len() > 1 && terms.len() == subjects.len() && alike(&letters);
        several && (slot != Slot::Of || alike(&terms) || things(&terms))
    };
    let slots: Vec<Slot> = PARTED.into_iter().filter(|slot| parted(*slot)).collect();
    if let Some(several) = about_axes(&subjects, &what) {
        return several;
    }
    if slots.is_empty() {
        return vec![Statement::Is { subjects, what }];
    }
    let one = |(number, subject): (usize, Term)| {
        let mut own = what.clone();
        for slot in &slots {
            let term = what.all(*slot).nth(number).cloned();
            let at = own.slots.iter().position(|(s, _)| s == slot);
            own.slots.retain(|(s, _)| s != slot);
            if let (Some(at), Some(term)) = (at, term) {
                own.slots.insert(at.min(own.slots.len()), (*slot, term));
            }
        }
        Statement::Is {
            subjects: vec![subject],
            what: own,
        }
    };
    subjects.into_iter().enumerate().map(one).collect()
}

/// "the moments of inertia of the body about the axes through O along `$x$` and `$z$`": each about one axis.
fn about_axes(subjects: &[Term], what: &NounPhrase) -> Option<Vec<Statement>> {
    let at = what
        .slots
        .iter()
        .position(|(slot, _)| *slot == Slot::About)?;
    let Term::Phrase(axes) = &what.slots[at].1 else {
        return None;
    };
    let along: Vec<&Term> = axes.all(Slot::Along).collect();
    if axes.head != "axes" || along.len() < 2 || along.len() != subjects.len() {
        return None;
    }
    let one = |(subject, along): (&Term, &Term)| {
        let mut axis = NounPhrase::new("axis", vec![(Slot::Along, along.clone())]);
        let others = axes.slots.iter().filter(|(slot, _)| *slot != Slot::Along);
        axis.slots.extend(others.cloned());
        let mut own = what.clone();
        own.slots[at].1 = Term::Phrase(Box::new(axis));
        Statement::Is {
            subjects: vec![subject.clone()],
            what: own,
        }
    };
    Some(subjects.iter().zip(along).map(one).collect())
}

/// What may be of each subject in turn.
const PARTED: [Slot; 6] = [
    Slot::Of,
    Slot::About,
    Slot::RelativeTo,
    Slot::On,
    Slot::Along,
    Slot::From,
];
