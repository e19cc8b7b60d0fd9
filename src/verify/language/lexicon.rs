//! The words of the language, read from `lexicon.txt`.

use super::forms::{alternatives, in_plural, on_first, parted, with_ed, with_s};
use super::statement::Slot;
use super::traits::{Trait, Traits};
use std::collections::BTreeMap;
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
    words: Vec<String>,
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
    forms: BTreeMap<String, Vec<Form>>,
    groups: BTreeMap<&'static str, &'static str>,
}

impl Default for Lexicon {
    fn default() -> Self {
        let mut lexicon = Self {
            entries: vec![],
            forms: BTreeMap::new(),
            groups: BTreeMap::new(),
        };
        for line in WORDS.lines() {
            lexicon.add(line);
        }
        for forms in lexicon.forms.values_mut() {
            forms.sort_by_key(|form| std::cmp::Reverse(form.words.len()));
        }
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
        let mut names: Vec<String> = its.map(|form| form.words.join(" ")).collect();
        names.sort_by_key(|name| !name.eq_ignore_ascii_case(entry.name));
        names
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
                && form.words.len() <= words.len()
                && form.words.iter().zip(words).all(|(a, b)| a == b)
        };
        forms.iter().find(fits).map(|form| Found {
            entry: &self.entries[form.entry],
            length: form.words.len(),
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
            let first = form.words.first()?;
            if 3 * first.len().abs_diff(word.len()) > word.len() {
                return None;
            }
            let apart = strsim::osa_distance(first, word);
            (apart * 3 <= word.chars().count()).then_some((apart, form.words.len(), &form.words))
        });
        near.min().map(|(_, _, words)| words.join(" "))
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
                self.groups.insert(forms.trim(), slots.trim());
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
        for form in parted(forms).into_iter().flat_map(alternatives) {
            self.add_form(&form);
        }
    }

    /// Takes in a form of the last entry with its inflections.
    fn add_form(&mut self, form: &str) {
        let entry = self.entries.len() - 1;
        let mut parts = form.split(',').map(str::trim);
        let base = parts.next().unwrap_or_default();
        let irregular = parts.next();
        self.insert(base, Inflection::Base);
        let last = &mut self.entries[entry];
        match last.class {
            Class::Noun | Class::Place | Class::Thing if !last.plural => {
                let ending = irregular.map_or_else(|| in_plural(base), str::to_owned);
                if last.ending.is_empty() {
                    last.ending.clone_from(&ending);
                }
                self.insert(&ending, Inflection::Ending);
            }
            Class::Verb | Class::Passive => {
                let ending = on_first(base, with_s);
                let participle = irregular.map_or_else(|| on_first(base, with_ed), str::to_owned);
                if last.ending.is_empty() {
                    last.ending.clone_from(&ending);
                    last.participle.clone_from(&participle);
                }
                self.insert(&ending, Inflection::Ending);
                self.insert(&participle, Inflection::Participle);
            }
            _ => {}
        }
    }

    fn insert(&mut self, form: &str, inflection: Inflection) {
        let words: Vec<String> = form.split_whitespace().map(str::to_lowercase).collect();
        let Some(first) = words.first() else { return };
        let entry = self.entries.len() - 1;
        self.forms.entry(first.clone()).or_default().push(Form {
            words,
            entry,
            inflection,
        });
    }

    /// The slots of an entry, groups written out.
    fn slots(&self, text: &'static str) -> Vec<(&'static str, Slot)> {
        let mut slots = vec![];
        for word in text.split_whitespace() {
            if let Some(group) = word.strip_prefix('@') {
                slots.extend(
                    self.groups
                        .get(group)
                        .map_or(vec![], |text| self.slots(text)),
                );
                continue;
            }
            let (prep, filled) = word.split_once('=').unwrap_or((word, word));
            let same = |e: &&Entry| {
                e.class == Class::Preposition && e.name.split(' ').eq(filled.split('-'))
            };
            let own = || self.entries.iter().find(same)?.slots.first();
            let filled = slot(filled).or_else(|| own().map(|s| s.1));
            slots.extend(filled.map(|slot| (prep, slot)));
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
