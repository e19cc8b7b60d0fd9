//! What a clause is about, where its subject says more than a name.

use super::gaps::is_one_list;
use super::implied::INDEXED;
use super::lexicon::Class;
use super::reader::{ARTICLES, COPULAS, Read, Reader};
use super::statement::{Extent, NounPhrase, Slot, Statement, Term};
use super::words::{Kind, Token};

/// Things that are called by what they are before their name.
const KINDS: [&str; 2] = ["frame", "point"];

/// What is said of one thing.
const ONE: [&str; 3] = ["is", "was", "denotes"];

/// The subject of a clause behind another has no more words than this.
const LONGEST_SUBJECT: usize = 12;

/// What a clause is about.
pub(super) struct Subject {
    pub(super) terms: Vec<Term>,
    /// What it is called before its name: "the frame B", "point C".
    pub(super) kind: Option<&'static str>,
    /// What the words before its name say of it.
    pub(super) said: Option<Statement>,
}

impl Reader<'_> {
    /// Whether the subject is a letter behind a noun: "The angle `$a$` is …".
    pub(super) fn begins_with_named(&self) -> bool {
        let formula = |t: &Token| matches!(t.kind, Kind::Formula | Kind::Plain);
        let copula = |t: &Token| COPULAS.contains(&t.lower.as_str());
        let mut own = self.tokens.iter().skip(self.at);
        let first = own.find(|t| formula(t) || copula(t));
        ARTICLES.contains(&self.word()) && first.is_some_and(formula)
    }

    /// The subject of a clause; a part of the document may stand behind it.
    pub(super) fn subject(&mut self, extents: &mut Vec<Extent>) -> Read<Subject> {
        let kind = self.kind_of_subject();
        let terms = match self.occurrence(extents)? {
            Some(formula) => vec![Term::Formula(formula)],
            None => self.terms()?,
        };
        let mut subject = Subject::of(terms, kind);
        if let Some(own) = self.extents_of_clause(extents)? {
            *extents = own;
            self.take_sign(Kind::Comma);
        }
        // What acts, or turns, is what its noun says; of what something is the letter says enough.
        if let Some((noun, letters)) = named_letters(&subject.terms)
            && (COPULAS.contains(&self.word()) || noun == "partial derivative")
        {
            subject.terms = letters;
        }
        Ok(subject)
    }

    /// Whether a subject and its verb come next: names and letters with nothing that hangs on them.
    pub(crate) fn at_clause(&self) -> bool {
        // "and radius `$r$`": a size has no article, and what is spoken of has one.
        let size = self.lexicon.find(self.following(0), &[Class::Noun]);
        let letter = |n: usize| {
            let token = self.tokens.get(self.at + n);
            token.is_some_and(|t| matches!(t.kind, Kind::Formula | Kind::Plain))
        };
        if size.is_some_and(|size| letter(size.length)) {
            return false;
        }
        for ahead in 0..LONGEST_SUBJECT {
            let word = self.word_at(ahead);
            if COPULAS.contains(&word) {
                let subject = self.tokens.get(self.at..self.at + ahead);
                let several = |t: &Token| t.kind == Kind::Comma || t.lower == "and";
                let one = |subject: &[Token]| match ONE.contains(&word) {
                    true => !subject.iter().any(several),
                    false => is_one_list(subject),
                };
                return ahead > 0 && subject.is_some_and(one);
            }
            let rest = self.following(ahead);
            let hangs = self.lexicon.find(rest, &[Class::Preposition]).is_some();
            let token = self.tokens.get(self.at + ahead);
            if hangs || token.is_none_or(|t| t.kind == Kind::Semicolon) {
                return false;
            }
        }
        false
    }

    fn kind_of_subject(&self) -> Option<&'static str> {
        let article = usize::from(ARTICLES.contains(&self.word()));
        let following = self.following(article);
        let noun = self.lexicon.find(following, &[Class::Place])?;
        KINDS.contains(&noun.entry.name).then_some(noun.entry.name)
    }
}

impl Subject {
    fn of(terms: Vec<Term>, kind: Option<&'static str>) -> Self {
        let said = |terms: Vec<Term>, kind, what| Self {
            said: Some(Statement::Is {
                subjects: terms.clone(),
                what,
            }),
            terms,
            kind,
        };
        if let Some((named, what)) = called_by_kind(&terms) {
            let kind = Some(what.head);
            return match what.adjectives.is_empty() {
                true => Self {
                    terms: vec![named],
                    kind,
                    said: None,
                },
                false => said(vec![named], kind, what),
            };
        }
        if let Some((letter, what)) = named_axis(&terms) {
            return said(vec![letter], kind, what);
        }
        Self {
            terms,
            kind,
            said: None,
        }
    }
}

/// "The body frame B", "the inertial frame N": the name, and of what kind it is.
fn called_by_kind(subjects: &[Term]) -> Option<(Term, NounPhrase)> {
    let [Term::Phrase(phrase)] = subjects else {
        return None;
    };
    let kind = KINDS.into_iter().find(|kind| *kind == phrase.head)?;
    let only = |(slot, term): &(Slot, Term)| match slot {
        Slot::Which => matches!(term, Term::Name(_) | Term::Formula(_)),
        Slot::Of => matches!(term, Term::Name(_)),
        _ => false,
    };
    let named = phrase.slot(Slot::Which)?.clone();
    let adjectives = phrase.adjectives.clone();
    phrase.slots.iter().all(only).then_some((
        named,
        NounPhrase {
            adjectives,
            ..NounPhrase::new(kind, vec![])
        },
    ))
}

/// "The partial derivatives `$a$` and `$b$`", "the products of inertia `$F$` and `$G$`": the letters, where the noun only
/// says of what kind they are.
fn named_letters(subjects: &[Term]) -> Option<(&'static str, Vec<Term>)> {
    let [Term::Phrase(phrase)] = subjects else {
        return None;
    };
    let written =
        |(slot, term): &(Slot, Term)| *slot == Slot::Which && matches!(term, Term::Formula(_));
    let alone = phrase.adjectives.is_empty() && !phrase.slots.is_empty();
    let letters = phrase.slots.iter().map(|(_, term)| term.clone());
    (alone && !INDEXED.contains(&phrase.head) && phrase.slots.iter().all(written))
        .then(|| (phrase.head, letters.collect()))
}

/// "The third axis `$n$` of B": the letter, and which axis it is.
fn named_axis(subjects: &[Term]) -> Option<(Term, NounPhrase)> {
    let [Term::Phrase(phrase)] = subjects else {
        return None;
    };
    let letter =
        |(slot, term): &&(Slot, Term)| *slot == Slot::Which && matches!(term, Term::Formula(_));
    let named = phrase.slots.iter().find(letter)?.clone();
    let mut what = (**phrase).clone();
    what.slots.retain(|slot| *slot != named);
    let numbered = matches!(what.slot(Slot::Which), Some(Term::Numbers(_)));
    (what.head == "axis" && numbered).then_some((named.1, what))
}
