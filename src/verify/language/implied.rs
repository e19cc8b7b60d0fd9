//! What a noun leaves to the words around it: whose it is, which one, and what is meant by several.

use super::lexicon::Class;
use super::reader::{Read, Reader, is_glue};
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

/// Nouns for what only vectors have.
const OF_VECTORS: [&str; 3] = ["component", "magnitude", "direction"];

/// Whether a noun names a number that belongs to a vector.
pub(super) fn is_scalar(what: &NounPhrase) -> bool {
    matches!(what.head, "magnitude" | "component")
}

/// Whether "its" before a noun means a letter, and not the thing whose quantity this is.
pub(crate) fn of_letters(noun: &str) -> bool {
    OF_LETTERS.contains(&noun)
}

/// Places that belong to the body that a sentence speaks of, where it says no other: "the moment on the hub about the mass
/// centre".
pub(crate) const OWNED: [&str; 3] = ["mass centre", "symmetry axis", "spin axis"];

/// Nouns whose letter says which one is meant.
pub(super) const INDEXED: [&str; 6] = ["component", "entry", "row", "column", "axis", "axes"];

impl Reader<'_> {
    /// "`$r$` is the position of P; `$v$` is its velocity": a letter has a magnitude, and the thing has a velocity.
    pub(crate) fn belongs_to_thing(&self, phrase: &mut NounPhrase, owned: bool) -> Read<()> {
        if owned {
            self.belongs_to_vector(phrase);
        }
        let Some(thing) = self.before.thing.as_ref().filter(|_| owned) else {
            return Ok(());
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
            return Ok(());
        }
        let mut owners = 0;
        for (slot, term) in &mut phrase.slots {
            let of_thing = |p: &NounPhrase| p.slot(Slot::Of) == Some(thing);
            let names_quantity = match term {
                Term::Formula(_) => true,
                Term::Phrase(p) => of_thing(p) || p.head == "axes",
                _ => false,
            };
            if *slot == Slot::Of && names_quantity {
                *term = thing.clone();
                owners += 1;
            }
        }
        match owners > 1 {
            true => Err(self.error("it is not said whose", "name the things")),
            false => Ok(()),
        }
    }

    /// "`$l$` is the magnitude of `$L$`, and `$l_z$` is its component along z": of the vector, for a magnitude has none.
    fn belongs_to_vector(&self, phrase: &mut NounPhrase) {
        let of_scalar = self.before.what.last().filter(|what| is_scalar(what));
        let vector = of_scalar.and_then(|what| what.slot(Slot::Of));
        let (Some(vector), true) = (vector, OF_VECTORS.contains(&phrase.head)) else {
            return;
        };
        for (slot, term) in &mut phrase.slots {
            if *slot == Slot::Of {
                term.clone_from(vector);
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

/// "`$p$` and `$q$` are the rates of `$a$` and `$b$`", "the angular momenta of the body about O and about G", "the moments of
/// inertia about the axes through O along `$x$` and `$z$`": what hangs on a noun, or on the axes that it is about, as often
/// as there are subjects is said of each in turn.
pub(crate) fn each_of_its_own(subjects: Vec<Term>, what: NounPhrase) -> Vec<Statement> {
    let letters = subjects.iter().all(|t| matches!(t, Term::Formula(_)));
    let count = subjects.len();
    if count < 2 || !letters || !is_parted(&what, count) {
        return vec![Statement::Is { subjects, what }];
    }
    let one = |(number, subject): (usize, Term)| Statement::Is {
        subjects: vec![subject],
        what: in_turn(&what, number, count),
    };
    subjects.into_iter().enumerate().map(one).collect()
}

/// Whether something hangs on a noun, or on its axes, so many times.
fn is_parted(what: &NounPhrase, count: usize) -> bool {
    PARTED.iter().any(|&slot| hangs_in_turn(what, slot, count))
        || axes_of(what).is_some_and(|axes| is_parted(axes, count))
}

/// Whether a slot has so many terms, one for each subject.
fn hangs_in_turn(what: &NounPhrase, slot: Slot, count: usize) -> bool {
    let terms: Vec<&Term> = what.all(slot).collect();
    let letters = terms.iter().all(|t| matches!(t, Term::Formula(_)));
    let things = terms.iter().all(|t| !matches!(t, Term::Phrase(_)));
    terms.len() == count && (slot != Slot::Of || letters || things)
}

/// The axes that something is about.
fn axes_of(what: &NounPhrase) -> Option<&NounPhrase> {
    match what.slot(Slot::About)? {
        Term::Phrase(axes) if axes.head == "axes" => Some(axes),
        _ => None,
    }
}

/// What is said of one of the subjects.
fn in_turn(what: &NounPhrase, number: usize, count: usize) -> NounPhrase {
    let mut own = what.clone();
    for slot in PARTED {
        if hangs_in_turn(what, slot, count) {
            let mut place = 0..count;
            own.slots
                .retain(|(s, _)| *s != slot || place.next() == Some(number));
        }
    }
    if let Some(axes) = axes_of(what).filter(|axes| is_parted(axes, count)) {
        let axis = NounPhrase {
            head: "axis",
            ..in_turn(axes, number, count)
        };
        let about = own.slots.iter_mut().find(|(slot, _)| *slot == Slot::About);
        about
            .into_iter()
            .for_each(|(_, term)| *term = Term::Phrase(Box::new(axis.clone())));
    }
    own
}

/// What may be of each subject in turn.
const PARTED: [Slot; 8] = [
    Slot::Which,
    Slot::Of,
    Slot::About,
    Slot::RelativeTo,
    Slot::On,
    Slot::Along,
    Slot::Through,
    Slot::From,
];
