//! The words of the language, read from `lexicon.txt`.

use super::forms::{
    first_word, forms_of, in_lower_case, in_plural, on_first, with_ed, with_irregular, with_s,
};
use super::statement::Slot;
use super::traits::{Trait, Traits};
use foldhash::HashMap;
use std::borrow::Cow;
use std::cmp::Reverse;
use std::sync::LazyLock;

/// The words that come with the crate.
const WORDS: &str = include_str!("lexicon.txt");

/// Words longer than this are not compared with others: nobody mistypes one.
const LONGEST_GUESSED: usize = 30;

/// What kind of word an entry is.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Class {
    /// "about", "relative to".
    Preposition,
    /// A quantity or a value.
    Noun,
    /// A point, a frame, an axis: something that has a place.
    Place,
    /// A body or a part of one.
    Thing,
    /// "uniform".
    Adjective,
    /// "without slipping".
    Adverb,
    /// "turn".
    Verb,
    /// "is placed".
    Passive,
    /// "tilde": a mark on letters.
    Mark,
    /// "braces": a custom of notation.
    Custom,
    /// "entry by entry": a fixed meaning of a mark or a custom.
    Meaning,
    /// A noun for "the point where …": its name is the verb, its plural the noun.
    Where,
}

impl Class {
    /// All of them.
    pub(crate) const ALL: [Self; 12] = [
        Self::Preposition,
        Self::Noun,
        Self::Place,
        Self::Thing,
        Self::Adjective,
        Self::Adverb,
        Self::Verb,
        Self::Passive,
        Self::Mark,
        Self::Custom,
        Self::Meaning,
        Self::Where,
    ];
}

/// How a form of an entry is inflected.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Inflection {
    /// As it stands in the lexicon.
    Base,
    /// A noun in the plural, a verb behind one thing: "turns".
    Ending,
    /// "turned".
    Participle,
}

/// A word, or several that belong together.
#[derive(Clone, Debug)]
pub(crate) struct Entry {
    /// What kind of word it is.
    pub(crate) class: Class,
    /// The first form.
    pub(crate) name: &'static str,
    /// How its first form is inflected: the plural of a noun, "turns" of a verb.
    pub(crate) ending: String,
    /// The participle of a verb.
    pub(crate) participle: String,
    /// Whether the noun is named in the plural: "principal moments".
    pub(crate) plural: bool,
    /// The prepositions that it takes, by their first form with hyphens, and the slots that they fill.
    pub(crate) slots: Vec<(&'static str, Slot)>,
    /// Its flags.
    pub(crate) traits: Traits,
}

impl Entry {
    /// Whether it means what acts on bodies.
    pub(crate) fn is_load(&self) -> bool {
        self.class == Class::Noun && self.slot("on") == Some(Slot::Upon)
    }

    /// Whether it is a noun that says what quantity a letter is, and no more than that.
    pub(crate) fn only_names(&self) -> bool {
        self.class == Class::Noun && !self.traits.has(Trait::Tells)
    }
}

/// A way to write an entry.
#[derive(Clone, Debug)]
struct Form {
    /// Its words in lower case, with a space between them.
    text: Cow<'static, str>,
    /// How many words it has.
    length: usize,
    entry: usize,
    inflection: Inflection,
}

/// An entry found in a sentence.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Found<'a> {
    /// The entry.
    pub(crate) entry: &'a Entry,
    /// How many words it takes.
    pub(crate) length: usize,
    /// How it is inflected.
    pub(crate) inflection: Inflection,
}

/// The words that the language knows.
#[derive(Clone, Debug)]
pub struct Lexicon {
    entries: Vec<Entry>,
    /// The forms by their first words, those of more words first.
    forms: HashMap<Cow<'static, str>, Vec<Form>>,
    /// What the prepositions that were read fill, by their names with hyphens.
    prepositions: HashMap<String, Option<Slot>>,
    groups: HashMap<&'static str, Vec<(&'static str, Slot)>>,
}

impl Default for Lexicon {
    fn default() -> Self {
        let mut lexicon = Self {
            entries: vec![],
            forms: HashMap::default(),
            prepositions: HashMap::default(),
            groups: HashMap::default(),
        };
        for line in WORDS.lines() {
            lexicon.add(line);
        }
        let all = lexicon.forms.values_mut();
        all.for_each(|forms| forms.sort_by_key(|form| Reverse(form.length)));
        lexicon
    }
}

impl Lexicon {
    /// The words that come with the crate, read once.
    pub(crate) fn shared() -> &'static Self {
        static SHARED: LazyLock<Lexicon> = LazyLock::new(Lexicon::default);
        &SHARED
    }

    /// All entries, in the order of the file.
    pub(crate) fn entries(&self) -> &[Entry] {
        &self.entries
    }

    /// The ways to write an entry in its base form, the first one first.
    pub(crate) fn synonyms(&self, entry: &Entry) -> Vec<String> {
        let forms = self.forms.values().flatten();
        let its = forms.filter(|f| {
            f.inflection == Inflection::Base && std::ptr::eq(&self.entries[f.entry], entry)
        });
        let mut its: Vec<&Form> = its.collect();
        its.sort_by_key(|form| {
            let other = !form.text.eq_ignore_ascii_case(entry.name);
            (other, first_word(&form.text), Reverse(form.length))
        });
        its.into_iter().map(|form| form.text.to_string()).collect()
    }

    /// The entry with this first form.
    pub(crate) fn entry(&self, name: &str, classes: &[Class]) -> Option<&Entry> {
        let mut entries = self.entries.iter();
        entries.find(|e| e.name == name && classes.contains(&e.class))
    }

    /// The longest entry of some classes with which words in lower case begin.
    pub(crate) fn find(&self, words: &[&str], classes: &[Class]) -> Option<Found<'_>> {
        let forms = self.forms.get(*words.first()?)?;
        let fits = |form: &&Form| {
            classes.contains(&self.entries[form.entry].class)
                && form.length <= words.len()
                && (form.length == 1 || form.text.split(' ').zip(words).all(|(a, b)| a == *b))
        };
        forms.iter().find(fits).map(|form| Found {
            entry: &self.entries[form.entry],
            length: form.length,
            inflection: form.inflection,
        })
    }

    /// The words of a preposition that is written with hyphens.
    pub(crate) fn words_of(&self, preposition: &str) -> String {
        let same = |e: &&Entry| {
            e.class == Class::Preposition && e.name.split(' ').eq(preposition.split('-'))
        };
        let found = self.entries.iter().find(same);
        found.map_or_else(
            || preposition.replace('-', " "),
            |entry| entry.name.to_owned(),
        )
    }

    /// Whether a form begins with this word in lower case.
    pub(crate) fn begins(&self, word: &str) -> bool {
        self.forms.contains_key(word)
    }

    /// The form of some classes that looks most like a word, if one is near.
    pub(crate) fn nearest(&self, word: &str, classes: &[Class]) -> Option<String> {
        if word.len() > LONGEST_GUESSED {
            return None;
        }
        let forms = self.forms.values().flatten();
        let fitting = forms.filter(|f| classes.contains(&self.entries[f.entry].class));
        let near = fitting.filter_map(|form| {
            let first = first_word(&form.text);
            if 3 * first.len().abs_diff(word.len()) > word.len() {
                return None;
            }
            let apart = strsim::osa_distance(first, word);
            (apart * 3 <= word.chars().count()).then_some((apart, form.length, &form.text))
        });
        near.min().map(|(_, _, text)| text.to_string())
    }

    /// Takes in a line of the file. Lines that say nothing are left out; a test sees to it that the file has none.
    fn add(&mut self, line: &'static str) {
        let line = line.trim();
        let Some((kind, rest)) = line.split_once(' ') else {
            return;
        };
        let (forms, rest) = rest.split_once(':').unwrap_or((rest, ""));
        let (slots, flags) = rest.split_once(';').unwrap_or((rest, ""));
        let traits = Traits::read(flags);
        let plural = kind == "nouns" || traits.has(Trait::Many);
        let class = match kind {
            "group" => {
                self.groups.insert(forms.trim(), self.slots(slots));
                return;
            }
            "where" => Class::Where,
            "prep" => Class::Preposition,
            "noun" | "nouns" => Class::Noun,
            "place" => Class::Place,
            "thing" => Class::Thing,
            "adj" => Class::Adjective,
            "adverb" => Class::Adverb,
            "verb" => Class::Verb,
            "passive" => Class::Passive,
            "mark" => Class::Mark,
            "custom" => Class::Custom,
            "meaning" => Class::Meaning,
            _ => return,
        };
        let first = forms.split(['|', ',']).next().unwrap_or(forms).trim();
        let slots = match class {
            Class::Where => vec![(slots.trim(), Slot::Of)],
            Class::Preposition => slot(slots.trim())
                .map(|s| vec![(first, s)])
                .unwrap_or_default(),
            _ => self.slots(slots),
        };
        if class == Class::Preposition {
            let own = self.prepositions.entry(first.replace(' ', "-"));
            own.or_insert(slots.first().map(|(_, slot)| *slot));
        }
        let entry = Entry {
            class,
            name: first,
            ending: String::new(),
            participle: String::new(),
            plural,
            slots,
            traits,
        };
        self.entries.push(entry);
        for form in forms_of(forms) {
            self.add_form(form);
        }
    }

    fn add_form(&mut self, form: Cow<'static, str>) {
        match form {
            Cow::Borrowed(form) => {
                let (base, irregular) = with_irregular(form);
                self.add_inflected(base.into(), irregular);
            }
            Cow::Owned(form) => {
                let (base, irregular) = with_irregular(&form);
                self.add_inflected(base.to_owned().into(), irregular);
            }
        }
    }

    /// Takes in a form of the last entry with its inflections.
    fn add_inflected(&mut self, base: Cow<'static, str>, irregular: Option<&str>) {
        let Some(last) = self.entries.last_mut() else {
            return;
        };
        let or =
            |regular: fn(&str) -> String| irregular.map_or_else(|| regular(&base), str::to_owned);
        let (ending, participle) = match last.class {
            Class::Noun | Class::Place | Class::Thing if !last.plural => {
                (Some(or(in_plural)), None)
            }
            Class::Verb | Class::Passive => (
                Some(on_first(&base, with_s)),
                Some(or(|base| on_first(base, with_ed))),
            ),
            _ => (None, None),
        };
        if last.ending.is_empty() {
            last.ending = ending.clone().unwrap_or_default();
            last.participle = participle.clone().unwrap_or_default();
        }
        self.insert(base, Inflection::Base);
        if let Some(ending) = ending {
            self.insert(ending.into(), Inflection::Ending);
        }
        if let Some(participle) = participle {
            self.insert(participle.into(), Inflection::Participle);
        }
    }

    fn insert(&mut self, form: Cow<'static, str>, inflection: Inflection) {
        let text = in_lower_case(form);
        if text.is_empty() {
            return;
        }
        let length = 1 + text.bytes().filter(|b| *b == b' ').count();
        let first = match &text {
            Cow::Borrowed(text) => Cow::Borrowed(first_word(text)),
            Cow::Owned(text) => Cow::Owned(first_word(text).to_owned()),
        };
        let entry = self.entries.len() - 1;
        self.forms.entry(first).or_default().push(Form {
            text,
            length,
            entry,
            inflection,
        });
    }

    /// The slots of an entry, groups written out.
    fn slots(&self, text: &'static str) -> Vec<(&'static str, Slot)> {
        let mut slots = vec![];
        for word in text.split_whitespace() {
            if let Some(group) = word.strip_prefix('@') {
                slots.extend(self.groups.get(group).into_iter().flatten());
                continue;
            }
            let (prep, filled) = word.split_once('=').unwrap_or((word, word));
            let own = || self.prepositions.get(filled).copied().flatten();
            slots.extend(slot(filled).or_else(own).map(|slot| (prep, slot)));
        }
        slots
    }
}

impl Entry {
    /// The slot that a preposition, by its first form, fills behind the entry.
    pub(crate) fn slot(&self, preposition: &str) -> Option<Slot> {
        let mut slots = self.slots.iter();
        let same = |name: &str| name.split('-').eq(preposition.split(' '));
        slots.find(|(name, _)| same(name)).map(|(_, slot)| *slot)
    }

    /// The preposition, with hyphens, that fills a slot behind the entry.
    pub(crate) fn preposition(&self, slot: Slot) -> Option<&'static str> {
        let mut slots = self.slots.iter();
        slots.find(|(_, s)| *s == slot).map(|(name, _)| *name)
    }
}

/// The slot of this name.
fn slot(name: &str) -> Option<Slot> {
    Some(match name {
        "of" => Slot::Of,
        "about" => Slot::About,
        "relative-to" => Slot::RelativeTo,
        "seen-from" => Slot::SeenFrom,
        "along" => Slot::Along,
        "on" => Slot::On,
        "fixed-in" => Slot::FixedIn,
        "velocities" => Slot::VelocitiesRelativeTo,
        "by" => Slot::By,
        "at" => Slot::At,
        "through" => Slot::Through,
        "from" => Slot::From,
        "to" => Slot::To,
        "in-order" => Slot::InOrder,
        "between" => Slot::Between,
        "in" => Slot::In,
        "in-second-order" => Slot::InSecondOrder,
        "with" => Slot::With,
        "which" => Slot::Which,
        "for-any" => Slot::ForAny,
        "upon" => Slot::Upon,
        _ => return None,
    })
}
