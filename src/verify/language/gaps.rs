//! What a clause leaves out or only points at: the verb of the one before, "it", a description behind a name.

use super::implied::of_letters;
use super::phrase::NOUNS;
use super::reader::{Read, Reader};
use super::statement::{Slot, Statement, Term};
use super::words::Kind;

impl Reader<'_> {
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
        let scalar = matches!(what.head, "magnitude" | "component");
        let letter = match scalar {
            true => what.slot(Slot::Of).cloned(),
            false => told.first().cloned(),
        };
        let owner = what.slot(Slot::Of).cloned();
        let mut subjects = vec![];
        self.term(&mut subjects)?;
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

    /// Whether "and" begins a sentence without its verb: "and `$p$` its small disturbance".
    pub(crate) fn at_gap(&self) -> bool {
        let letter = self.at_formula() && ["the", "a", "an"].contains(&self.word_at(1));
        self.word_at(1) == "its" || letter
    }

    /// The thing that "it" means: what the clause before is about, or the thing whose quantity it said a letter to be.
    pub(crate) fn meant_by_it(&self) -> Option<Term> {
        match self.owner.as_slice() {
            [letter @ Term::Formula(_)] => self.thing.clone().or(Some(letter.clone())),
            [Term::Formula(_), ..] => self.thing.clone(),
            // "its mass centre is G, and the load on it …"
            [Term::Phrase(place)] => {
                let thing = self.thing.clone();
                thing.filter(|thing| place.slot(Slot::Of) == Some(thing))
            }
            [named @ (Term::Name(_) | Term::Member { .. })] => Some(named.clone()),
            _ => None,
        }
    }

    /// Whether what follows says what the thing is that was named last: "O, a point fixed in N".
    pub(crate) fn at_apposition(&self, terms: &[Term]) -> bool {
        let named = matches!(terms.last(), Some(Term::Name(_) | Term::Formula(_)));
        let next = self.tokens.get(self.at + 1);
        let article = next.is_some_and(|next| {
            next.kind == Kind::Word && matches!(next.text.as_str(), "a" | "an")
        });
        named && self.kind() == Some(Kind::Comma) && article
    }
}
