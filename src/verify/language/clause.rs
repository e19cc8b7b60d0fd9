//! Whole sentences.

use super::gaps::alike_at_end;
use super::in_turn::does_in_turn;
use super::lexicon::{Class, Found};
use super::phrase::NOUNS;
use super::possessions::{alike, place_at, possessions};
use super::reader::{COPULAS, Read, Reader};
use super::sign::operating;
use super::statement::{Extent, Formula, NotationMeaning, NounPhrase, Slot, Statement, Term};
use super::words::Kind;

/// Space has no more dimensions than this: matrices grow with their square.
const MOST_DIMENSIONS: usize = 8;

/// What is said, and of which part of the document.
pub(crate) type Said = (Extent, Statement);

impl<'a> Reader<'a> {
    /// A sentence. It says several things if it has several clauses or speaks of several parts of the document.
    pub(crate) fn sentence(&mut self) -> Read<Vec<Said>> {
        let whole = self.extents()?;
        let mut said: Vec<Said> = vec![];
        let mut spoken_of: Vec<Term> = vec![];
        loop {
            let mut statements = vec![];
            self.in_predicate = false;
            let own = self.extents_of_clause(&whole)?;
            let mut extents = own.unwrap_or_else(|| whole.clone());
            let before = self.conditions()?;
            match self.apart()? {
                Some(several) => statements.extend(several),
                None => {
                    let thing = said.last().and_then(|(_, said)| owner_in(said));
                    self.before.thing = thing.or(self.before.thing.take());
                    self.before.what = alike_at_end(said.iter().map(|(_, said)| said));
                    let subject = self.subject(&mut extents)?;
                    let (subjects, kind) = (subject.terms, subject.kind);
                    statements.extend(subject.said);
                    self.owner = match said.is_empty() {
                        true => subjects.clone(),
                        false => spoken_of,
                    };
                    self.clause(&subjects, &mut statements)?;
                    statements.iter_mut().for_each(|said| said.is_of(kind));
                    spoken_of = subjects;
                }
            }
            for statement in &mut statements {
                self.limit(statement, &before)?;
            }
            if let Some(behind) = self.extents_of_clause(&extents)? {
                extents = behind;
            }
            for statement in statements {
                said.extend(
                    extents
                        .iter()
                        .map(|extent| (extent.clone(), statement.clone())),
                );
            }
            let next = self.take_sign(Kind::Semicolon) && !self.done() || self.take_clause();
            if !next {
                break;
            }
        }
        match self.done() {
            true => Ok(said),
            false => Err(self.unexpected(
                "word that fits",
                "the sentence could end here",
                &[Class::Preposition],
            )),
        }
    }

    /// Sentences of a form of their own.
    fn apart(&mut self) -> Read<Option<Vec<Statement>>> {
        if let Some(statements) = self.of_lines()? {
            return Ok(Some(statements));
        }
        if let Some(statement) = self.rule()? {
            return Ok(Some(vec![statement]));
        }
        if self.take("space has") {
            return self.dimensions().map(|premise| Some(vec![premise]));
        }
        if self.take("no") {
            return self.nothing_acts().map(|premise| Some(vec![premise]));
        }
        Ok(None)
    }

    /// "space has four dimensions".
    fn dimensions(&mut self) -> Read<Statement> {
        let number = match self.take_number() {
            Some(number) => Some(number),
            None => match self.word() {
                "two" => Some(2),
                "three" => Some(3),
                "four" => Some(4),
                _ => None,
            }
            .inspect(|_| self.at += 1),
        };
        let Some(number) = number.filter(|number| (2..=MOST_DIMENSIONS).contains(number)) else {
            let expected = "`three` could stand here, or another number up to 8";
            return Err(self.unexpected("number", expected, &[]));
        };
        if !self.take_any(&["dimensions"]) {
            return Err(self.unexpected("noun", "`dimensions` could stand here", &NOUNS));
        }
        Ok(Statement::Premise(NounPhrase::new(
            "dimension",
            vec![(Slot::Which, Term::Numbers(vec![number]))],
        )))
    }

    /// "No moment acts on the body about G", behind "no".
    fn nothing_acts(&mut self) -> Read<Statement> {
        let (mut phrase, noun) = self.named()?;
        self.slots(noun, &mut phrase.slots)?;
        // What one thing does not exert another may.
        let of_none = phrase.slot(Slot::Of).is_none();
        let verb = self
            .find(&[Class::Verb])
            .filter(|verb| verb.entry.name == "act" && of_none);
        let Some(verb) = verb else {
            return Err(self.unexpected("verb", "`acts on …` could stand here", &[Class::Verb]));
        };
        self.at += verb.length;
        phrase.adjectives.insert(0, "no");
        self.slots(noun, &mut phrase.slots)?;
        self.tail(noun, &mut phrase.slots)?;
        for (slot, _) in &mut phrase.slots {
            if *slot == Slot::Upon {
                *slot = Slot::Of;
            }
        }
        Ok(Statement::Premise(phrase))
    }

    /// What is said of some subjects, verb after verb.
    fn clause(&mut self, subjects: &[Term], statements: &mut Vec<Statement>) -> Read<()> {
        let formulas: Option<Vec<Formula>> = subjects.iter().map(as_formula).collect();
        if self.done() || self.kind() == Some(Kind::Semicolon) {
            return match formulas {
                Some(formulas) => {
                    statements.extend(formulas.into_iter().map(Statement::Holds));
                    Ok(())
                }
                None => Err(self.unexpected("verb", "a verb could stand here", &[Class::Verb])),
            };
        }
        if let Some(formulas) = &formulas
            && (self.under_condition() || self.timed())
        {
            statements.push(self.holds(formulas.clone())?);
            return Ok(());
        }
        loop {
            statements.extend(self.said_of(subjects)?);
            self.appositions(subjects, formulas.as_deref(), statements)?;
            self.renamed_behind(subjects, statements)?;
            while self.gap(statements)? {}
            let start = self.at;
            let separated = self.take_separator();
            let is = matches!(statements.last(), Some(Statement::Is { .. }));
            if separated && is && self.at_adjective() {
                statements.extend(self.predicate(subjects, formulas.clone())?);
                return Ok(());
            }
            let verb = self.find(&[Class::Verb]).is_some() || COPULAS.contains(&self.word());
            if !separated || !verb {
                if separated && self.at != start && !self.done() {
                    self.at = start;
                }
                return Ok(());
            }
        }
    }

    /// Takes "and" or a comma before another clause: "…, and `$H$` is its magnitude".
    fn take_clause(&mut self) -> bool {
        let start = self.at;
        let next = self.take_separator() && {
            self.take("where");
            self.at_clause() || self.word() == "no"
        };
        if !next {
            self.at = start;
        }
        next
    }

    /// ", also written `$c$`" behind what is said of some subjects, or behind the letters that these are said to be.
    pub(crate) fn renamed_behind(
        &mut self,
        subjects: &[Term],
        statements: &mut Vec<Statement>,
    ) -> Read<()> {
        let start = self.at;
        if self.take_separator() && self.at_renaming() && self.take("also written") {
            let letter = |term: &Term| matches!(term, Term::Formula(_));
            let others = match statements.last() {
                Some(Statement::Is { subjects: told, .. }) if told.iter().all(letter) => told,
                _ => subjects,
            };
            let others = others.to_vec();
            statements.push(Statement::Same {
                subjects: self.terms()?,
                others,
            });
        } else {
            self.at = start;
        }
        Ok(())
    }

    /// Whether another writing follows: "also written `$c$`".
    pub(crate) fn at_renaming(&self) -> bool {
        self.word() == "also" && self.word_at(1) == "written"
    }

    /// Whether an adjective comes next that is said of what stands before: "and not zero".
    fn at_adjective(&self) -> bool {
        let negated = usize::from(self.word() == "not");
        let found = self
            .lexicon
            .find(self.following(negated), &[Class::Adjective]);
        found.is_some_and(|found| self.ends_clause(negated + found.length))
    }

    /// Whether nothing, or another clause, follows some words.
    pub(crate) fn ends_clause(&self, ahead: usize) -> bool {
        let next = self.tokens.get(self.at + ahead);
        next.is_none_or(|next| {
            matches!(next.kind, Kind::Comma | Kind::Semicolon) || next.lower == "and"
        })
    }

    /// Whether it is said when or how nearly a formula holds.
    pub(crate) fn under_condition(&self) -> bool {
        let hold = self.lexicon.entry("hold", &[Class::Verb]);
        let said = self.find(&[Class::Preposition]);
        said.is_some_and(|said| hold.is_some_and(|hold| hold.slot(said.entry.name).is_some()))
    }

    /// "`$u = 0$` at `$t = 0$`": what is said of formulas that hold somewhere.
    pub(crate) fn holds(&mut self, formulas: Vec<Formula>) -> Read<Statement> {
        let mut slots = vec![];
        if let Some(hold) = self.lexicon.entry("hold", &[Class::Verb]) {
            self.slots(hold, &mut slots)?;
            self.tail(hold, &mut slots)?;
        }
        Ok(Statement::Does {
            subjects: formulas.into_iter().map(Term::Formula).collect(),
            verb: "hold",
            slots,
        })
    }

    /// A verb with what hangs on it.
    fn said_of(&mut self, subjects: &[Term]) -> Read<Vec<Statement>> {
        let formulas: Option<Vec<Formula>> = subjects.iter().map(as_formula).collect();
        if let Some(formulas) = &formulas {
            if self.take_any(&["means", "mean"])
                || self.take("stands for")
                || self.take("stand for")
            {
                return match self.at_formula() || self.done() {
                    true => self.means(formulas),
                    false => self.predicate(subjects, Some(formulas.clone())),
                };
            }
            if self.take("takes functions of") || self.take("take functions of") {
                return self.functions_of(formulas.clone());
            }
            if let Some(fixed) = self.take_fixed() {
                return Ok(operating(formulas.clone(), &NotationMeaning::Fixed(fixed)));
            }
        }
        self.in_predicate = true;
        if self.take("stands for") || self.take("stand for") || self.take_any(&COPULAS) {
            return self.predicate(subjects, formulas);
        }
        let Some(verb) = self.find(&[Class::Verb]) else {
            return Err(self.unexpected(
                "verb",
                "`is` or a verb of the lexicon could stand here",
                &[Class::Verb],
            ));
        };
        if verb.entry.name == "lie" && self.word_at(1) == "between" {
            self.at += 2;
            return self.bounds(formulas);
        }
        self.verb(subjects, verb)
    }

    pub(crate) fn verb(&mut self, subjects: &[Term], verb: Found<'a>) -> Read<Vec<Statement>> {
        self.at += verb.length;
        let mut slots = vec![];
        let object = verb.entry.slot("object");
        if let Some(slot) =
            object.filter(|_| self.starts_term() && self.find(&[Class::Preposition]).is_none())
        {
            let terms = self.terms_alike()?;
            slots.extend(terms.into_iter().map(|term| (slot, term)));
        }
        let index = |subject: &Term| matches!(subject, Term::Formula(_));
        if verb.entry.name == "number" && (slots.is_empty() || !subjects.iter().all(index)) {
            return Err(self.unexpected("noun", "what is numbered could stand here", &NOUNS));
        }
        self.slots(verb.entry, &mut slots)?;
        self.tail(verb.entry, &mut slots)?;
        // "The axes form a left-handed system": that is no whole of which they are the parts.
        let of_axes =
            |(_, part): &(Slot, Term)| matches!(part, Term::Phrase(part) if part.head == "axes");
        if verb.entry.name == "consist" && slots.iter().any(of_axes) {
            return Err(self.unexpected("thing", "a thing could stand here", &[Class::Thing]));
        }
        if verb.entry.name == "stay constant" && slots.is_empty() {
            let constant = NounPhrase::new("constant", vec![]);
            return Ok(vec![Statement::Is {
                subjects: subjects.to_vec(),
                what: constant,
            }]);
        }
        if let ("differ", [Term::Formula(one), Term::Formula(other)]) = (verb.entry.name, subjects)
            && slots.is_empty()
            && let Some(differ) =
                self.formula(&format!("{} \\neq {}", one.source, other.source), false)
        {
            return Ok(vec![Statement::Holds(differ)]);
        }
        if verb.entry.name == "have"
            && let [(Slot::With, Term::Phrase(place)), (Slot::At, at)] = slots.as_slice()
            && self.lexicon.entry(place.head, &[Class::Place]).is_some()
        {
            return Ok(vec![place_at(subjects, place, at)]);
        }
        if verb.entry.name == "have"
            && let Some(said) = possessions(subjects, &slots)
                .or_else(|| alike(subjects, &slots).map(|said| vec![said]))
        {
            return Ok(said);
        }
        Ok(does_in_turn(subjects, verb.entry.name, &slots))
    }
}

/// The thing whose quantity a statement says a letter to be.
fn owner_in(statement: &Statement) -> Option<Term> {
    match statement {
        Statement::Is { what, .. } | Statement::Premise(what) => {
            let of = what.slot(Slot::Of).or(what.slot(Slot::Upon))?;
            (!matches!(of, Term::Formula(_))).then(|| of.clone())
        }
        _ => None,
    }
}

pub(crate) fn as_formula(term: &Term) -> Option<Formula> {
    match term {
        Term::Formula(formula) => Some(formula.clone()),
        _ => None,
    }
}
