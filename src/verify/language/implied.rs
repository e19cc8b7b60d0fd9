//! What a noun leaves to the words around it: whose it is, which one, and what is meant by several.

use super::body_words::may_name;
use super::fixed_in::body_of;
use super::lexicon::Class;
use super::reader::{Read, Reader, is_glue};
use super::statement::{NounPhrase, Slot, Term};
use super::traits::Trait;
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

/// What a letter may stand for that is its own: "its reference value".
const OWN: [&str; 3] = ["reference", "value", "own"];

/// Quantities of which a thing may have several.
const SIZES: [&str; 9] = [
    "radius",
    "length",
    "width",
    "thickness",
    "side",
    "diameter",
    "distance",
    "height",
    "mass",
];

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

    /// Whether a line of the document comes next, by its number, and no axis.
    pub(crate) fn at_numbered_line(&self) -> bool {
        let number = self.tokens.get(self.at + 1).map(|token| token.kind);
        matches!(self.word(), "line" | "lines") && number == Some(Kind::Number)
    }

    /// An error where "its" comes next behind the thing itself: nothing is its own mass centre, and so it is of what the
    /// sentence before spoke of.
    pub(crate) fn not_its_own(&self, subjects: &[Term]) -> Read<()> {
        let named = |term: &Term| matches!(term, Term::Name(_) | Term::Formula(_));
        let itself = self.owner == subjects && subjects.iter().any(named);
        let value = OWN.contains(&self.word_at(1));
        match itself && matches!(self.word(), "its" | "their") && !value {
            true => Err(self.error("it is not said whose", "name the thing")),
            false => Ok(()),
        }
    }

    /// How many words that nobody knows stand before a noun with its name: "the stability axes S". The name says enough.
    pub(crate) fn unknown_before_name(&self) -> Option<usize> {
        let unknown = |ahead: usize| {
            let word = self.word_at(ahead);
            let named = !word.is_empty() && !self.lexicon.begins(word) && !is_glue(word);
            named && may_name(word) && body_of(word).is_none()
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
        // The inner radius and the reduced mass are others.
        let sized = noun.entry.traits.has(Trait::Bodily) || SIZES.contains(&noun.entry.name);
        (skipped > 0 && (name && !sized || place)).then_some(skipped)
    }
}
