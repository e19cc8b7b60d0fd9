//! Things and quantities: names, formulas, and nouns with what hangs on them.

use super::adjectives::goes_with;
use super::gaps::{counted, is_one_of_several};
use super::hanging::leave_to_load;
use super::heads::FORCE;
use super::implied::OWNED;
use super::lexicon::{Class, Entry, Inflection};
use super::reader::{ARTICLES, Read, Reader};
use super::statement::{NounPhrase, Slot, Term};
use super::traits::Trait;
use super::words::Kind;

/// What may be the head of a phrase.
pub(crate) const NOUNS: [Class; 3] = [Class::Noun, Class::Place, Class::Thing];

/// Ordinals by which axes and entries are called.
pub(crate) const ORDINALS: [&str; 6] = ["first", "second", "third", "fourth", "fifth", "sixth"];

/// Nouns that add nothing to the name of what they are.
const NAMED: [&str; 6] = ["frame", "point", "vector", "tensor", "matrix", "index"];

const WANTED: &str = "a name, a formula or a noun with its article could stand here";

impl<'a> Reader<'a> {
    /// A list of terms: "the hub, the gimbal and the wheel".
    pub(crate) fn terms(&mut self) -> Read<Vec<Term>> {
        self.list(|_, _, _| true)
    }

    /// A list of terms in a slot; it ends where things go over into quantities.
    pub(crate) fn terms_alike(&mut self) -> Read<Vec<Term>> {
        self.list(Self::alike)
    }

    fn list(&mut self, alike: fn(&Self, &Term, &Term) -> bool) -> Read<Vec<Term>> {
        let mut terms = vec![];
        self.term(&mut terms)?;
        loop {
            let start = self.at;
            if self.at_apposition(&terms) || !self.take_separator() || !self.goes_on() {
                self.at = start;
                return Ok(terms);
            }
            let known = terms.len();
            let outer = self.owner.clone();
            if matches!(self.word(), "its" | "their") {
                self.owner.clone_from(&terms);
            }
            let quantity = self.noun_next();
            let read = self.term(&mut terms);
            self.owner = outer;
            match read {
                // "the force on the hub and the moment on it": what is not read here may be a noun beside the first.
                Err(_) if quantity && self.in_predicate => {
                    terms.truncate(known);
                    self.at = start;
                    return Ok(terms);
                }
                read => read?,
            }
            let pair = (terms.get(known.wrapping_sub(1)), terms.get(known));
            if let (Some(a), Some(b)) = pair
                && !alike(self, a, b)
            {
                terms.truncate(known);
                self.at = start;
                return Ok(terms);
            }
        }
    }

    /// Whether a term could begin here; a word that nobody knows is meant as one.
    pub(crate) fn starts_term(&self) -> bool {
        match self.kind() {
            Some(Kind::Formula | Kind::Plain | Kind::Number) => true,
            Some(Kind::Word) => {
                let word = self.word();
                let others = [Class::Noun, Class::Place, Class::Thing, Class::Adjective];
                self.at_name()
                    || ARTICLES.contains(&word)
                    || self.find(&others).is_some()
                    || !(self.lexicon.begins(word) || self.is_glue())
            }
            _ => false,
        }
    }

    /// Whether another member of a list could begin behind a comma or "and".
    fn goes_on(&self) -> bool {
        let other = self.at_gap()
            || self.at_renaming()
            || matches!(self.word(), "respectively" | "no")
            || self.in_predicate && self.at_clause();
        self.starts_term()
            && !other
            && !self.hangs_on_more()
            && self.find(&[Class::Adverb]).is_none()
    }

    /// Whether a quantity comes next, with its article or without.
    pub(crate) fn noun_next(&self) -> bool {
        let article = usize::from(ARTICLES.contains(&self.word()));
        let noun = [Class::Noun, Class::Place, Class::Adjective];
        let adverb = self.find(&[Class::Adverb]).is_some();
        !self.at_renaming()
            && !adverb
            && self.lexicon.find(self.following(article), &noun).is_some()
    }

    /// Whether two members of a list may stand in one slot: no quantity beside a thing, and no relation, which is a clause.
    fn alike(&self, a: &Term, b: &Term) -> bool {
        // "the axis through O along x and the axis through G"
        let axis_behind_letter = b.is_noun("axis") && !matches!(a, Term::Phrase(_));
        if b.is_condition() && !a.is_condition() || axis_behind_letter {
            return false;
        }
        let quantity = |term: &Term| match term {
            Term::Name(_) | Term::Member { .. } => Some(false),
            Term::Phrase(phrase) => Some(self.lexicon.entry(phrase.head, &[Class::Noun]).is_some()),
            Term::Formula(_) | Term::Numbers(_) => None,
        };
        match (quantity(a), quantity(b)) {
            (Some(a), Some(b)) => a == b,
            _ => true,
        }
    }

    /// One term; a formula that is a list gives several.
    pub(crate) fn term(&mut self, terms: &mut Vec<Term>) -> Read<()> {
        match self.kind() {
            Some(Kind::Formula | Kind::Plain) => {
                terms.extend(self.formulas().into_iter().map(Term::Formula));
            }
            Some(Kind::Number) => match self.take_number() {
                Some(number) => terms.push(Term::Numbers(vec![number])),
                None => return Err(self.error("the number is too large", "")),
            },
            _ if self.at_name() => terms.push(self.name()),
            _ if self.word() == "it" && self.meant_by_it().is_some() => {
                terms.extend(self.meant_by_it());
                self.at += 1;
            }
            _ => match self.one_of_them() {
                Some(axis) => terms.push(axis),
                None => terms.push(self.deeper(Self::described)?),
            },
        }
        Ok(())
    }

    /// A name as written.
    pub(crate) fn name(&mut self) -> Term {
        let name = self
            .peek()
            .map_or(String::new(), |token| token.text.clone());
        self.at += 1;
        Term::Name(name.replace(['′', '’'], "'"))
    }

    /// A thing by a noun: its name, a member of a family, or a phrase.
    fn described(&mut self) -> Read<Term> {
        let start = self.at;
        let first = self.word();
        let owned = matches!(first, "its" | "their");
        let article = self.take_any(&ARTICLES);
        if self.at_name() {
            return Ok(self.name());
        }
        let length = self.introduced(0);
        if length > 0 && !owned {
            return Ok(self.body(length));
        }
        let thing = self
            .find(&NOUNS)
            .filter(|found| found.entry.class == Class::Thing);
        let qualifier = thing.filter(|found| self.qualifies(found.length));
        if let Some(found) = thing.filter(|_| !owned && qualifier.is_none()) {
            let whole = found.entry.traits.has(Trait::Part) && self.word_at(found.length) == "of";
            if !whole {
                self.at += found.length;
                return Ok(self.member(found.entry, found.inflection));
            }
        }
        self.at = start;
        let mut owner = match first {
            "its" => self.one_owner(),
            "their" => self.owner.clone(),
            _ => vec![],
        };
        if let Some(found) = qualifier.filter(|_| !owned) {
            self.take_any(&ARTICLES);
            self.at += found.length;
            owner.push(Term::Name(found.entry.name.to_owned()));
        }
        if owned && owner.is_empty() {
            return Err(self.error("it is not said whose", "name the thing"));
        }
        let mut phrase = self.phrase_of(owner)?;
        self.belongs_to_thing(&mut phrase, owned)?;
        self.belongs_to_subject(&mut phrase);
        Ok(match phrase.slots.as_slice() {
            // "frame B" is B, and so is "the inertial frame B" where it hangs on something.
            [(Slot::Of, _), (Slot::Which, named @ Term::Name(_))]
                if qualifier.is_some() && NAMED.contains(&phrase.head) =>
            {
                named.clone()
            }
            [(Slot::Which, named @ (Term::Name(_) | Term::Formula(_)))]
                if article
                    && self.hangs()
                    && self.is_named(&phrase)
                    && !is_fixed_point(&phrase)
                    || NAMED.contains(&phrase.head) && phrase.adjectives.is_empty() =>
            {
                named.clone()
            }
            _ => Term::Phrase(Box::new(phrase)),
        })
    }

    /// "the moment on the hub about the mass centre" is about that of the hub; a letter has no mass centre.
    fn belongs_to_subject(&self, phrase: &mut NounPhrase) {
        if !self.hangs() || !OWNED.contains(&phrase.head) || phrase.slot(Slot::Of).is_some() {
            return;
        }
        let owner = self.owner.first();
        let owner = owner.filter(|owner| !matches!(owner, Term::Formula(_)));
        phrase
            .slots
            .extend(owner.map(|owner| (Slot::Of, owner.clone())));
    }

    /// Whose "its" means: where the clause before is about several things, it is of what these are.
    fn one_owner(&self) -> Vec<Term> {
        match self.owner.as_slice() {
            [_, _, ..] => {
                let of = self.before.what.last().and_then(|what| what.slot(Slot::Of));
                of.cloned().into_iter().collect()
            }
            owner => owner.to_vec(),
        }
    }

    /// A noun with its article, its adjectives and what hangs on it.
    pub(crate) fn phrase(&mut self) -> Read<NounPhrase> {
        let owned = matches!(self.word(), "its" | "their");
        let owner = match self.word() {
            "its" => self.one_owner(),
            "their" => self.owner.clone(),
            _ => vec![],
        };
        let mut phrase = self.phrase_of(owner)?;
        self.belongs_to_thing(&mut phrase, owned)?;
        Ok(phrase)
    }

    fn phrase_of(&mut self, owner: Vec<Term>) -> Read<NounPhrase> {
        let (mut phrase, entry) = self.named()?;
        phrase
            .slots
            .extend(owner.into_iter().map(|owner| (Slot::Of, owner)));
        let entry = self.point_where(&mut phrase)?.unwrap_or(entry);
        self.slots(entry, &mut phrase.slots)?;
        leave_to_load(entry, &mut phrase);
        while let Some(found) = self
            .find(&[Class::Adjective])
            .filter(|f| !f.entry.slots.is_empty() && goes_with(f.entry.name, entry.name))
            && self.find(&[Class::Preposition]).is_none()
        {
            self.at += found.length;
            phrase.adjectives.push(found.entry.name);
            self.slots(found.entry, &mut phrase.slots)?;
            self.slots(entry, &mut phrase.slots)?;
        }
        // "the force on the base at P" is not that of the base.
        let at_point = phrase.head == FORCE && phrase.slot(Slot::At).is_some();
        if phrase.slot(Slot::Of).is_none() && !at_point {
            for (slot, _) in phrase
                .slots
                .iter_mut()
                .filter(|(slot, _)| *slot == Slot::Upon)
            {
                *slot = Slot::Of;
            }
        }
        Ok(phrase)
    }

    /// Article, adjectives, noun, and which one: "the constant rate `$\Omega$`". An adjective that no noun follows is
    /// the head itself: "constant".
    pub(crate) fn named(&mut self) -> Read<(NounPhrase, &'a Entry)> {
        let article = self.word();
        self.take_any(&ARTICLES);
        let mut adjectives: Vec<&'a Entry> = vec![];
        let mut slots = vec![];
        let (entry, inflection) = loop {
            let noun = self.find(&NOUNS);
            let adjective = self.find(&[Class::Adjective]);
            let longer = |n: usize| {
                adjective.is_none_or(|a| a.length < n || (a.length == n && !self.noun_behind(n)))
            };
            let noun = noun.filter(|noun| longer(noun.length) && !self.at_numbered_line());
            if let Some(noun) = noun {
                self.at += noun.length;
                break (noun.entry, noun.inflection);
            }
            if let Some(adjective) = adjective {
                self.at += adjective.length;
                let says = adjective.entry.name != "whole";
                adjectives.extend(says.then_some(adjective.entry));
            } else if let Some(n) = ORDINALS.iter().position(|o| *o == self.word()) {
                self.at += 1;
                slots.push((Slot::Which, Term::Numbers(vec![n + 1])));
                self.take_joint_before_ordinal();
            } else if let Some(skipped) = self.unknown_before_name() {
                self.at += skipped;
            } else {
                let unknown = self.kind() == Some(Kind::Word)
                    && !self.lexicon.begins(self.word())
                    && !self.is_glue();
                match adjectives.pop().filter(|_| !unknown) {
                    Some(last) => break (last, Inflection::Base),
                    None => return Err(self.unexpected("noun", WANTED, &NOUNS)),
                }
            }
        };
        let mut phrase = NounPhrase {
            head: counted(entry.name, &slots),
            adjectives: adjectives.iter().map(|entry| entry.name).collect(),
            slots,
        };
        if adjectives.is_empty() && is_one_of_several(article, entry, inflection) {
            phrase.adjectives.push("one");
        }
        if entry.class != Class::Adjective {
            let many = entry.plural || inflection == Inflection::Ending;
            self.apposition(&mut phrase, many)?;
        }
        Ok((phrase, entry))
    }

    /// Whether a noun or an adjective follows behind some words.
    pub(super) fn noun_behind(&self, ahead: usize) -> bool {
        let rest = self.following(ahead);
        let described = [Class::Noun, Class::Place, Class::Thing, Class::Adjective];
        self.lexicon.find(rest, &described).is_some()
    }

    /// Which one is meant: "component `$j$`", "the axes x and y", "entry (2, 3)".
    fn apposition(&mut self, phrase: &mut NounPhrase, many: bool) -> Read<()> {
        let mut which = vec![];
        if self.take_sign(Kind::Open) {
            which = self.in_brackets()?;
            loop {
                let start = self.at;
                if !many || !self.take_separator() || !self.take_sign(Kind::Open) {
                    self.at = start;
                    break;
                }
                which.extend(self.in_brackets()?);
            }
        } else if self.at_index() {
            self.term(&mut which)?;
            loop {
                let start = self.at;
                if !many || !self.take_separator() || !self.at_index() || self.at_gap() {
                    self.at = start;
                    break;
                }
                self.term(&mut which)?;
            }
        } else if self.kind() == Some(Kind::Quoted) {
            which.extend(self.peek().map(|token| Term::Name(token.text.clone())));
            self.at += 1;
        }
        phrase
            .slots
            .extend(which.into_iter().map(|term| (Slot::Which, term)));
        Ok(())
    }

    /// "2, 3)" behind its bracket: the numbers of one entry, or a list.
    fn in_brackets(&mut self) -> Read<Vec<Term>> {
        let which = self.terms()?;
        if !self.take_sign(Kind::Close) {
            return Err(self.unexpected("closing bracket", "close the bracket", &[]));
        }
        let number = |term: &Term| match term {
            Term::Numbers(numbers) => numbers.first().copied(),
            _ => None,
        };
        let numbers: Vec<usize> = which.iter().filter_map(number).collect();
        Ok(match numbers.len() == which.len() {
            true => vec![Term::Numbers(numbers)],
            false => which,
        })
    }

    /// Whether a formula, a number or a name comes next.
    fn at_index(&self) -> bool {
        matches!(
            self.kind(),
            Some(Kind::Formula | Kind::Plain | Kind::Number)
        ) || self.at_name()
    }
}

/// "the fixed point O" says more than the name does.
fn is_fixed_point(phrase: &NounPhrase) -> bool {
    phrase.head == "point" && phrase.is("fixed")
}
