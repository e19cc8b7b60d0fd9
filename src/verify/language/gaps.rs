//! What a clause leaves out or only points at: the verb of the one before, "it", a description behind a name.

use super::implied::{is_scalar, of_letters};
use super::lexicon::{Class, Entry, Inflection};
use super::phrase::{NOUNS, ORDINALS};
use super::reader::{Read, Reader};
use super::statement::{NounPhrase, Slot, Statement, Term};
use super::words::{Kind, Token};

impl Reader<'_> {
    /// "the first and the third axis": what stands between two numbers.
    pub(super) fn take_joint_before_ordinal(&mut self) {
        let start = self.at;
        let joined = self.take_separator() && {
            self.take("the");
            ORDINALS.contains(&self.word())
        };
        if !joined {
            self.at = start;
        }
    }

    /// "and `$p$` its small disturbance", "and `$g$` the acceleration of gravity": the verb is the one before, and so is
    /// whose it is. Says whether there is one.
    pub(crate) fn gap(&mut self, statements: &mut Vec<Statement>) -> Read<bool> {
        let start = self.at;
        let told = match statements.last() {
            Some(Statement::Is { subjects, what }) if self.take_separator() && self.at_gap() => {
                Some((subjects, what))
            }
            _ => None,
        };
        let Some((told, what)) = told else {
            self.at = start;
            return Ok(false);
        };
        // A magnitude has no components: they are of what it is the magnitude of.
        let letter = match is_scalar(what) {
            true => what.slot(Slot::Of).cloned(),
            false => told.first().cloned(),
        };
        let owner = what.slot(Slot::Of).cloned();
        let mut subjects = vec![];
        self.term(&mut subjects)?;
        while self.those_behind() && self.take_separator() {
            self.term(&mut subjects)?;
        }
        let before = alike_at_end(statements.iter());
        if let Some(those) = self.that_of(&subjects, &before)? {
            statements.extend(those);
            self.renamed_behind(&subjects, statements)?;
            return Ok(true);
        }
        let its = self.take_any(&["its"]);
        let mut what = self.phrase()?;
        if its {
            let owner = match of_letters(what.head) {
                true => letter,
                false => owner,
            };
            what.slots.extend(owner.map(|owner| (Slot::Of, owner)));
        }
        // "`$v$` is the velocity and `$p$` the momentum of P": what hangs on the last one hangs on both.
        if let Some(Statement::Is { what: first, .. }) = statements.last_mut()
            && first.slots.is_empty()
            && !its
            && self
                .lexicon
                .entry(first.head, &NOUNS)
                .is_some_and(|noun| noun.slot("of").is_some())
        {
            first.slots.clone_from(&what.slots);
        }
        let said = subjects.clone();
        statements.push(Statement::Is { subjects, what });
        self.renamed_behind(&said, statements)?;
        Ok(true)
    }

    /// "that of the rotor", "those about G": what the noun before says, with other things hanging on it.
    pub(crate) fn that_of(
        &mut self,
        subjects: &[Term],
        before: &[NounPhrase],
    ) -> Read<Option<Vec<Statement>>> {
        let start = self.at;
        let last = before.last();
        let entry = last.and_then(|last| self.lexicon.entry(last.head, &NOUNS));
        let (true, Some(entry)) = (self.take_any(&["that", "those"]), entry) else {
            self.at = start;
            return Ok(None);
        };
        let mut slots = vec![];
        self.slots(entry, &mut slots)?;
        if slots.is_empty() {
            self.at = start;
            return Ok(None);
        }
        let each: Vec<NounPhrase> = before.iter().map(|what| hanging_on(what, &slots)).collect();
        let is = |(subjects, what): (Vec<Term>, &NounPhrase)| Statement::Is {
            subjects,
            what: what.clone(),
        };
        match each.as_slice() {
            [first, rest @ ..] if rest.iter().all(|other| other == first) => {
                Ok(Some(vec![is((subjects.to_vec(), first))]))
            }
            _ if each.len() == subjects.len() => {
                let own = subjects.iter().map(|subject| vec![subject.clone()]);
                Ok(Some(own.zip(&each).map(is).collect()))
            }
            _ => Err(self.error("it is not said which of several is meant", "name it")),
        }
    }

    /// Whether "and" begins a sentence without its verb: "and `$p$` its small disturbance".
    pub(crate) fn at_gap(&self) -> bool {
        let nouns = ["the", "a", "an", "that"];
        let letter = self.at_formula() && nouns.contains(&self.word_at(1));
        self.word_at(1) == "its" || letter || self.those_behind()
    }

    /// Whether a list of formulas comes next, and "those" behind it: "`$p$`, `$q$` those of `$v$`".
    fn those_behind(&self) -> bool {
        let listed = |token: &&Token| {
            matches!(token.kind, Kind::Formula | Kind::Plain | Kind::Comma) || token.lower == "and"
        };
        let rest = self.tokens.get(self.at..).unwrap_or_default();
        let list = rest.iter().take_while(listed).count();
        let names_them = rest.get(list).is_some_and(|token| token.lower == "those");
        list > 0 && names_them && is_one_list(&rest[..list])
    }

    /// "The third of them", behind what was said of the axes of B: the third axis of B.
    pub(crate) fn one_of_them(&mut self) -> Option<Term> {
        let [Term::Phrase(axes)] = self.owner.as_slice() else {
            return None;
        };
        let article = usize::from(self.word() == "the");
        let number = ORDINALS.iter().position(|o| *o == self.word_at(article))?;
        let of_them = self.word_at(article + 1) == "of" && self.word_at(article + 2) == "them";
        if axes.head != "axes" || !of_them {
            return None;
        }
        let which = (Slot::Which, Term::Numbers(vec![number + 1]));
        let slots = std::iter::once(which).chain(axes.slots.clone());
        let axis = NounPhrase::new("axis", slots.collect());
        self.at += article + 3;
        Some(Term::Phrase(Box::new(axis)))
    }

    /// The thing that "it" means: what the clause before is about, or the thing whose quantity it said a letter to be.
    pub(crate) fn meant_by_it(&self) -> Option<Term> {
        // A thing does not stand to itself in what it is said to do.
        let joins = |t: &Token| matches!(t.kind, Kind::Comma | Kind::Semicolon) || t.lower == "and";
        if !self.tokens[..self.at].iter().any(joins) {
            return None;
        }
        match self.owner.as_slice() {
            // What acts is a load, and only a letter is a quantity.
            [letter @ Term::Formula(_)]
                if self.word_at(1).starts_with("act") || self.is_quantity_behind() =>
            {
                Some(letter.clone())
            }
            [letter @ Term::Formula(_)] => self.before.thing.clone().or(Some(letter.clone())),
            [Term::Formula(_), ..] => self.before.thing.clone(),
            // "its mass centre is G, and the load on it …"
            [Term::Phrase(place)] => {
                let thing = self.before.thing.clone();
                thing.filter(|thing| place.slot(Slot::Of) == Some(thing))
            }
            [named @ (Term::Name(_) | Term::Member { .. })] => Some(named.clone()),
            _ => None,
        }
    }

    /// Whether a preposition comes next that begins as another word does: "relative to".
    pub(crate) fn hangs_on_more(&self) -> bool {
        let words = [Class::Noun, Class::Place, Class::Thing, Class::Adjective];
        let preposition = self.find(&[Class::Preposition]);
        let shorter = |length| self.find(&words).is_some_and(|found| found.length < length);
        preposition.is_some_and(|found| shorter(found.length))
    }

    /// Whether "it" is said to be a quantity: "it is the position of P from C".
    fn is_quantity_behind(&self) -> bool {
        let article = usize::from(self.word_at(2) == "the");
        let noun = self
            .lexicon
            .find(self.following(2 + article), &[Class::Noun]);
        let reminds = matches!(self.word_at(2), "that" | "those");
        self.word_at(1) == "is" && (reminds || noun.is_some())
    }

    /// Whether what follows says what the thing is that was named last: "O, a point fixed in N".
    pub(crate) fn at_apposition(&self, terms: &[Term]) -> bool {
        let named = matches!(terms.last(), Some(Term::Name(_) | Term::Formula(_)));
        let next = self.tokens.get(self.at + 1);
        let article = next.is_some_and(|next| {
            next.kind == Kind::Word && matches!(next.text.as_str(), "a" | "an")
        });
        named && self.kind() == Some(Kind::Comma) && article && !self.lists_indefinite()
    }

    /// "a rotor, a gimbal and a case": what was named last has no name of its own, and the list goes on to its end.
    fn lists_indefinite(&self) -> bool {
        let indefinite = |t: &Token| t.kind == Kind::Word && matches!(t.text.as_str(), "a" | "an");
        let plain = |t: &Token| t.kind == Kind::Word && t.lower == t.text;
        let before = self.tokens[..self.at].iter().rev().take(LONGEST_LISTED);
        let begun = before.take_while(|t| plain(t)).any(indefinite);
        let rest = self.tokens[self.at..].iter();
        let rest: Vec<&Token> = rest.take_while(|t| t.kind != Kind::Semicolon).collect();
        let closed = |pair: &[&Token]| pair[0].lower == "and" && indefinite(pair[1]);
        begun && rest.windows(2).any(closed)
    }
}

/// A thing in a list of such takes no more words, with its article.
const LONGEST_LISTED: usize = 4;

/// Whether some words with "and" and commas between them are one list. Behind ", and" a new one begins, unless the members
/// before it are parted by commas as well: "x, y, and z".
pub(super) fn is_one_list(tokens: &[Token]) -> bool {
    let comma = |t: &Token| t.kind == Kind::Comma;
    let ends = |pair: &[Token]| comma(&pair[0]) && pair[1].lower == "and";
    let Some(at) = tokens.windows(2).position(ends) else {
        return true;
    };
    let last = &tokens[at + 2..];
    let joined = |tokens: &[Token]| tokens.iter().any(|t| comma(t) || t.lower == "and");
    tokens[..at].iter().any(comma) && !joined(last)
}

/// What the last clause said each of several letters to be: noun phrases with one head.
pub(super) fn alike_at_end<'s>(
    said: impl DoubleEndedIterator<Item = &'s Statement>,
) -> Vec<NounPhrase> {
    let mut alike: Vec<NounPhrase> = vec![];
    for what in said.rev().map_while(Statement::noun_phrase) {
        if alike.last().is_some_and(|last| last.head != what.head) {
            break;
        }
        alike.push(what);
    }
    alike.reverse();
    alike
}

/// A noun with other things hanging on it, and what hung on it before in the places that these leave.
fn hanging_on(before: &NounPhrase, slots: &[(Slot, Term)]) -> NounPhrase {
    let mut all = slots.to_vec();
    for (slot, term) in &before.slots {
        // Nothing is measured from itself: "B relative to A, and that of A".
        let said = slots.iter().any(|(said, own)| said == slot || own == term);
        if !said && *slot != Slot::Which {
            all.push((*slot, term.clone()));
        }
    }
    NounPhrase {
        slots: all,
        ..before.clone()
    }
}

/// "a force on P" is one of several, "the force on P" is all of them.
pub(super) fn is_one_of_several(article: &str, load: &Entry, inflection: Inflection) -> bool {
    let one = matches!(article, "a" | "an") || article != "the" && inflection == Inflection::Ending;
    one && load.slot("on") == Some(Slot::Upon)
}

/// Axes that are counted, "the first and third axes", are single ones.
pub(super) fn counted(noun: &'static str, which: &[(Slot, Term)]) -> &'static str {
    match noun {
        "axes" if !which.is_empty() => "axis",
        _ => noun,
    }
}
