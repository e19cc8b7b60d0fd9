//! Names and nouns with what hangs on them.

use super::{listed, ordinal, with_article};
use crate::verify::language::lexicon::{Class, Entry, Lexicon};
use crate::verify::language::phrase::NOUNS;
use crate::verify::language::statement::{NounPhrase, Slot, Term};
use crate::verify::language::traits::Trait;

/// Adjectives that count.
const COUNTS: [&str; 5] = ["two", "three", "four", "five", "six"];

/// Adjectives of a load that acts on a body.
const LOADING: [&str; 5] = ["total", "external", "internal", "only", "no"];

/// Writes with the words of a lexicon.
pub(super) struct Printer<'a> {
    /// The words.
    pub(super) lexicon: &'a Lexicon,
}

impl Printer<'_> {
    /// A list of terms.
    pub(super) fn terms(&self, terms: &[Term]) -> String {
        let shown: Vec<String> = terms.iter().map(|term| self.term(term)).collect();
        listed(&shown)
    }

    fn term(&self, term: &Term) -> String {
        match term {
            Term::Formula(formula) => self.formula(formula),
            Term::Name(name) => self.name(name),
            Term::Member { family, index } => format!("{family} {}", self.formula(index)),
            Term::Phrase(phrase) => self.described(phrase),
            Term::Numbers(numbers) => match numbers.as_slice() {
                [one] => one.to_string(),
                _ => {
                    let shown: Vec<String> = numbers.iter().map(usize::to_string).collect();
                    format!("({})", shown.join(", "))
                }
            },
        }
    }

    /// A name; a word with its article.
    fn name(&self, name: &str) -> String {
        let word =
            name.chars().count() > 2 && name.chars().all(|c| c.is_lowercase() || "- ".contains(c));
        let known = name
            .split(' ')
            .next()
            .is_some_and(|first| self.lexicon.begins(first));
        // "link 1"
        let numbered = name.ends_with(|c: char| c.is_ascii_digit());
        match (word || known) && !numbered {
            true => format!("the {name}"),
            false => name.to_owned(),
        }
    }

    /// Whether a verb stands in the plural behind these subjects.
    pub(super) fn many(&self, subjects: &[Term]) -> bool {
        let plural = |term: &Term| match term {
            Term::Name(name) => {
                let words: Vec<&str> = name.split(' ').collect();
                let found = self.lexicon.find(&words, &[Class::Thing]);
                found.is_some_and(|found| found.entry.name != name && found.entry.ending == *name)
            }
            Term::Phrase(phrase) => {
                let counted = phrase.adjectives.iter().any(|a| COUNTS.contains(a));
                counted || self.entry(phrase).is_some_and(|entry| entry.plural)
            }
            _ => false,
        };
        subjects.len() > 1 || subjects.first().is_some_and(plural)
    }

    fn entry(&self, phrase: &NounPhrase) -> Option<&Entry> {
        let nouns = self.lexicon.entry(phrase.head, &NOUNS);
        nouns.or_else(|| {
            self.lexicon
                .entry(phrase.head, &[Class::Adjective, Class::Adverb])
        })
    }

    /// A phrase as the part of another one.
    pub(super) fn described(&self, phrase: &NounPhrase) -> String {
        let counted = phrase.adjectives.iter().any(|a| COUNTS.contains(a));
        let bare = self.bare(phrase, counted);
        let adverb = self
            .entry(phrase)
            .is_some_and(|entry| entry.class == Class::Adverb);
        match counted || adverb {
            true => bare,
            false => format!("the {bare}"),
        }
    }

    /// A phrase behind "is".
    pub(super) fn predicate(&self, phrase: &NounPhrase, many: bool) -> String {
        let entry = self.entry(phrase);
        let bare = self.bare(phrase, many);
        let class = entry.map(|entry| entry.class);
        if class == Some(Class::Adjective) || phrase.is("any") {
            return bare;
        }
        let one =
            entry.is_some_and(|entry| entry.traits.has(Trait::One)) || class == Some(Class::Thing);
        match (one && !phrase.is("only"), many) {
            (true, true) => bare,
            (true, false) => with_article(&bare),
            (false, _) => format!("the {bare}"),
        }
    }

    /// A phrase as the meaning of a mark.
    pub(super) fn meaning(&self, phrase: &NounPhrase) -> String {
        match phrase.head == "component" && phrase.slot(Slot::Of).is_none() {
            true => self.bare(phrase, true),
            false => format!("the {}", self.bare(phrase, false)),
        }
    }

    /// A phrase without its article.
    pub(super) fn bare(&self, phrase: &NounPhrase, many: bool) -> String {
        let entry = self.entry(phrase);
        let mut words = vec![];
        let mut which: Vec<&Term> = phrase.all(Slot::Which).collect();
        if let [Term::Numbers(numbers)] = which.as_slice()
            && let [number @ 1..=6] = numbers.as_slice()
        {
            words.push(ordinal(*number).to_owned());
            which.clear();
        }
        let said = phrase.adjectives.iter().filter(|a| **a != "also");
        words.extend(said.map(|a| (*a).to_owned()));
        let many = many || which.len() > 1;
        let placed = phrase.head == "fixed" && phrase.slot(Slot::FixedIn).is_some();
        match entry {
            _ if placed => {}
            Some(entry) if many && !entry.plural && !entry.ending.is_empty() => {
                words.push(entry.ending.clone());
            }
            _ => words.push(phrase.head.to_owned()),
        }
        if !which.is_empty() {
            let shown: Vec<String> = which.iter().map(|term| self.term(term)).collect();
            words.push(listed(&shown));
        }
        let hanging: Vec<(Slot, Term)> = phrase
            .slots
            .iter()
            .filter(|(s, _)| *s != Slot::Which)
            .cloned()
            .collect();
        let loaded = phrase.adjectives.iter().any(|a| LOADING.contains(a))
            && phrase.slot(Slot::Upon).is_none();
        let slots = self.slots(entry, &hanging, loaded);
        match words.is_empty() {
            true => slots.trim_start().to_owned(),
            false => format!("{}{slots}", words.join(" ")),
        }
    }

    /// What hangs on a noun or a verb, each part with a space before it. On a load, "of" is said as "on".
    pub(super) fn slots(
        &self,
        entry: Option<&Entry>,
        slots: &[(Slot, Term)],
        loaded: bool,
    ) -> String {
        let mut text = String::new();
        let mut at = 0;
        let mut any = vec![];
        while let Some((slot, _)) = slots.get(at) {
            let terms = self.together(&slots[at..]);
            at += terms.len();
            if *slot == Slot::ForAny {
                any.extend(terms.iter().map(|term| self.term(term)));
                continue;
            }
            let mut adverbs = terms.iter().filter_map(|term| self.adverb(term)).peekable();
            if adverbs.peek().is_some() {
                text.extend(adverbs);
                continue;
            }
            let upon = entry.is_some_and(|entry| entry.preposition(Slot::Upon).is_some());
            let asked = if loaded && upon && *slot == Slot::Of {
                Slot::Upon
            } else {
                *slot
            };
            let preposition = self.preposition(entry, asked);
            text.push_str(&self.hung(&preposition, &terms));
        }
        if !any.is_empty() {
            text.push_str(&format!(", for any {}", listed(&any)));
        }
        text
    }

    /// The preposition of a slot; none before an object.
    fn preposition(&self, entry: Option<&Entry>, slot: Slot) -> String {
        if let Some(own) = entry.and_then(|entry| entry.preposition(slot)) {
            return match own {
                "object" => String::new(),
                _ => self.lexicon.words_of(own),
            };
        }
        let mut all = self.lexicon.entries().iter();
        let usual =
            all.find(|e| e.class == Class::Preposition && e.slots.iter().any(|(_, s)| *s == slot));
        usual.map_or_else(String::new, |entry| entry.name.to_owned())
    }

    /// Terms behind their preposition. Particles in place of bodies have it each for itself.
    fn hung(&self, preposition: &str, terms: &[&Term]) -> String {
        let space = if preposition.is_empty() { "" } else { " " };
        let particle = |term: &Term| match term {
            Term::Phrase(phrase) if phrase.head == "particle" => {
                let part = phrase.slot(Slot::Of).filter(|of| self.stands_for(of))?;
                Some((part.clone(), phrase.clone()))
            }
            _ => None,
        };
        if !terms.iter().any(|term| particle(term).is_some()) {
            let shown: Vec<String> = terms
                .iter()
                .map(|term| self.in_slot(preposition, term))
                .collect();
            return format!(" {preposition}{space}{}", listed(&shown));
        }
        let one = |term: &&Term| match particle(term) {
            None => format!("{preposition}{space}{}", self.term(term)),
            Some((part, phrase)) => {
                let centre = match phrase.slot(Slot::At) {
                    Some(Term::Phrase(centre)) if centre.slot(Slot::Of) == Some(&part) => {
                        format!(" at its {}", centre.head)
                    }
                    Some(other) => format!(" at {}", self.term(other)),
                    None => String::new(),
                };
                format!(
                    "{preposition}{space}{} as a particle{centre}",
                    self.term(&part)
                )
            }
        };
        let shown: Vec<String> = terms.iter().map(one).collect();
        format!(" {}", shown.join(" and "))
    }

    /// A body, and no size of one.
    fn stands_for(&self, term: &Term) -> bool {
        !matches!(term, Term::Phrase(phrase) if self.lexicon.entry(phrase.head, &[Class::Noun]).is_some())
    }

    /// A term in a slot: sizes stand without an article, "of mass `$m$`".
    fn in_slot(&self, preposition: &str, term: &Term) -> String {
        match term {
            Term::Phrase(phrase) if preposition == "of" && phrase.slots.len() == 1 => {
                match phrase.slot(Slot::Which) {
                    Some(Term::Formula(_)) => self.bare(phrase, false),
                    _ => self.term(term),
                }
            }
            _ => self.term(term),
        }
    }

    /// The first of some slots with those behind it that stand behind one preposition.
    fn together<'t>(&self, slots: &'t [(Slot, Term)]) -> Vec<&'t Term> {
        let mut terms: Vec<&Term> = vec![];
        for (slot, term) in slots {
            let fits = slots.first().is_some_and(|(first, _)| first == slot)
                && terms.last().is_none_or(|last| {
                    let adverbs = self.adverb(last).is_some() == self.adverb(term).is_some();
                    let measured = *slot == Slot::At && matches!(last, Term::Phrase(_));
                    adverbs && !measured
                });
            if !fits {
                break;
            }
            terms.push(term);
        }
        terms
    }

    /// The words of an adverb with what it needs, a space before them.
    pub(super) fn adverb(&self, term: &Term) -> Option<String> {
        let Term::Phrase(phrase) = term else {
            return None;
        };
        let entry = self.lexicon.entry(phrase.head, &[Class::Adverb])?;
        let close = entry.name.starts_with("with") || !entry.slots.is_empty();
        let comma = if close { " " } else { ", " };
        let object = self.slots(Some(entry), &phrase.slots, false);
        Some(format!("{comma}{}{object}", entry.name))
    }
}
