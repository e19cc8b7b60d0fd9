//! What is said of something behind "is", "means" and "lies between".

use super::clause::as_formula;
use super::decide::decide;
use super::in_turn::share_slots;
use super::is_body;
use super::lexicon::{Class, Entry, Inflection};
use super::phrase::NOUNS;
use super::reader::{ARTICLES, Read, Reader};
use super::sign::{is_operator, operating};
use super::statement::{Formula, NotationMeaning, NounPhrase, Slot, Statement, Term};
use super::words::Kind;

/// Other words for "is" before a formula.
const SHORT_FOR: [&str; 5] = [
    "equal to",
    "given by",
    "defined as",
    "defined by",
    "short for",
];

impl<'a> Reader<'a> {
    /// What stands behind "is".
    pub(crate) fn predicate(
        &mut self,
        subjects: &[Term],
        formulas: Option<Vec<Formula>>,
    ) -> Read<Vec<Statement>> {
        self.not_its_own(subjects)?;
        let also = self.take("also");
        let subjects = subjects.to_vec();
        if let Some(statements) = self.renamed(&subjects, formulas.as_deref())? {
            return Ok(statements);
        }
        if let Some(formulas) = &formulas
            && let Some(fixed) = self.take_fixed()
        {
            return Ok(operating(formulas.clone(), &NotationMeaning::Fixed(fixed)));
        }
        let verb = self.find(&[Class::Passive, Class::Verb]);
        if let Some(verb) = verb.filter(|verb| verb.inflection == Inflection::Participle)
            && self
                .find(&[Class::Preposition, Class::Adjective])
                .is_none_or(|f| f.length <= verb.length)
        {
            return self.verb(&subjects, verb);
        }
        if let Some(statement) = self.at_a_point(&subjects) {
            return Ok(vec![statement]);
        }
        if let Some(statement) = self.named_by(&subjects)? {
            return Ok(vec![statement]);
        }
        if let Some(statement) = self.the_only(&subjects)? {
            return Ok(vec![statement]);
        }
        if let Some(statements) = self.one_noun(&subjects)? {
            return Ok(statements);
        }
        let before = std::mem::take(&mut self.before.what);
        if let Some(statements) = self.that_of(&subjects, &before)? {
            return Ok(statements);
        }
        self.before.what = before;
        let (mut what, entry) = self.said()?;
        if let Some(statements) = self.one_each(&subjects, &what)? {
            return Ok(statements);
        }
        if also {
            what.adjectives.insert(0, "also");
        }
        if let Some(formulas) = &formulas
            && formulas
                .iter()
                .all(|formula| is_operator(formula, &what, entry))
            && let Some(fixed) = self.fixed_behind()
        {
            return Ok(operating(formulas.clone(), &NotationMeaning::Fixed(fixed)));
        }
        self.tail(entry, &mut what.slots)?;
        Ok(decide(subjects, formulas, what, entry))
    }

    /// "P is at C", behind "is".
    fn at_a_point(&mut self, subjects: &[Term]) -> Option<Statement> {
        let start = self.at;
        let point = (self.take("at") && self.at_name()).then(|| self.name());
        let Some(point) = point else {
            self.at = start;
            return None;
        };
        Some(Statement::Does {
            subjects: subjects.to_vec(),
            verb: "lie",
            slots: vec![(Slot::At, point)],
        })
    }

    /// "The mass of the rotor is `$m$`", "the mass centre of the rotor is Q", behind "is".
    fn named_by(&mut self, subjects: &[Term]) -> Read<Option<Statement>> {
        let [Term::Phrase(phrase)] = subjects else {
            return Ok(None);
        };
        let what = (**phrase).clone();
        let subjects = match self.at_formula() {
            true => self.all_formulas(),
            false if self.at_name() && self.ends_clause(1) => self.terms()?,
            false => return Ok(None),
        };
        Ok(Some(Statement::Is { subjects, what }))
    }

    /// "The only loads on the top are the weight and the force at O", behind "are".
    fn the_only(&mut self, subjects: &[Term]) -> Read<Option<Statement>> {
        let [Term::Phrase(phrase)] = subjects else {
            return Ok(None);
        };
        if !phrase.is("only") {
            return Ok(None);
        }
        let mut premise = (**phrase).clone();
        // "The only loads on the disc are its weight …"
        let on = premise.slots.iter();
        let on = on.filter(|(slot, _)| matches!(slot, Slot::Of | Slot::Upon | Slot::On));
        self.owner = on.map(|(_, term)| term.clone()).collect();
        let terms = self.terms()?;
        let those = terms.into_iter().map(|term| (Slot::With, term));
        premise.slots.extend(those);
        Ok(Some(Statement::Premise(premise)))
    }

    /// "the same as `$b$`", "`$m v$`", "written `$c$`", "between `$0$` and `$1$`": what puts one thing for another.
    fn renamed(
        &mut self,
        subjects: &[Term],
        formulas: Option<&[Formula]>,
    ) -> Read<Option<Vec<Statement>>> {
        let subjects = subjects.to_vec();
        if self.take("the same as") {
            let others = self.terms()?;
            let any = self.rest_for_any()?;
            if any.is_empty() {
                return Ok(Some(vec![Statement::Same { subjects, others }]));
            }
            let short = |(subject, other)| Statement::Is {
                subjects: vec![subject],
                what: shorthand(other, &any),
            };
            return Ok(Some(subjects.into_iter().zip(others).map(short).collect()));
        }
        if self.take("written") {
            return Ok(Some(vec![Statement::Same {
                subjects: self.terms()?,
                others: subjects,
            }]));
        }
        let formulas = formulas.map(<[Formula]>::to_vec);
        if self.take("between") {
            return self.bounds(formulas).map(Some);
        }
        for words in SHORT_FOR {
            if self.take(words) {
                break;
            }
        }
        if self.at_formula() && !matches!(subjects.as_slice(), [Term::Phrase(_)]) {
            return self.formula_for(subjects, formulas).map(Some);
        }
        Ok(None)
    }

    /// The formulas of a list.
    fn all_formulas(&mut self) -> Vec<Term> {
        let mut formulas = self.formulas();
        let mut start = self.at;
        while self.take_separator() && self.at_formula() {
            formulas.extend(self.formulas());
            start = self.at;
        }
        self.at = start;
        formulas.into_iter().map(Term::Formula).collect()
    }

    /// "`$m$` and `$r$` are the mass and the radius of the disc": a noun for each subject, behind the first one. What hangs
    /// on the last hangs on those that have nothing.
    fn one_each(&mut self, subjects: &[Term], first: &NounPhrase) -> Read<Option<Vec<Statement>>> {
        let start = self.at;
        let mut nouns = vec![first.clone()];
        // "the force on the hub and the moment on it"
        let of = first.slot(Slot::Of).or(first.slot(Slot::Upon));
        let of = of.filter(|term| subjects.len() > 1 && !matches!(term, Term::Formula(_)));
        self.before.thing = of.cloned().or(self.before.thing.take());
        while subjects.len() > 1 && self.take_separator() && self.noun_next() {
            nouns.push(self.said()?.0);
        }
        if nouns.len() < 2 {
            self.at = start;
            return Ok(None);
        }
        if nouns.len() != subjects.len() {
            self.at = start;
            return Err(self.error("as many nouns as letters are wanted", "say one by one"));
        }
        let last = nouns.last().map_or(vec![], |noun| noun.slots.clone());
        let mut behind = vec![];
        if let Some(entry) = self.lexicon.entry(first.head, &NOUNS) {
            self.tail(entry, &mut behind)?;
        }
        let one = |(subject, mut what): (&Term, NounPhrase)| {
            // An inertial frame and a frame fixed in the body are each by itself.
            let thing = matches!(what.head, "frame" | "point") || is_body(what.head);
            if !thing {
                share_slots(&mut what, &last);
            }
            what.slots.extend(behind.iter().cloned());
            Statement::Is {
                subjects: vec![subject.clone()],
                what,
            }
        };
        self.take("respectively");
        Ok(Some(subjects.iter().zip(nouns).map(one).collect()))
    }

    /// "the roll, pitch and yaw rates of the ship": nouns that share their last word.
    fn one_noun(&mut self, subjects: &[Term]) -> Read<Option<Vec<Statement>>> {
        let start = self.at;
        self.take_any(&ARTICLES);
        let mut words = vec![];
        while self.kind() == Some(Kind::Word) && words.len() < subjects.len() {
            words.push(self.word());
            self.at += 1;
            if !self.take_separator() {
                break;
            }
        }
        let last = self.word();
        let lexicon = self.lexicon;
        let noun = |word: &&str| {
            let found = lexicon.find(&[*word, last], &[Class::Noun])?;
            (found.length == 2 && found.inflection == Inflection::Ending).then_some(found.entry)
        };
        let entries: Option<Vec<&Entry>> = words.iter().map(noun).collect();
        let Some(entries) = entries.filter(|e| e.len() > 1 && e.len() == subjects.len()) else {
            self.at = start;
            return Ok(None);
        };
        self.at += 1;
        let mut slots = vec![];
        if let Some(entry) = entries.last() {
            self.slots(entry, &mut slots)?;
            self.tail(entry, &mut slots)?;
        }
        let one = |(subject, entry): (&Term, &Entry)| Statement::Is {
            subjects: vec![subject.clone()],
            what: NounPhrase::new(entry.name, slots.clone()),
        };
        Ok(Some(subjects.iter().zip(entries).map(one).collect()))
    }

    /// "`$p$` is `$m v$`", "`$u$` is `$0$` at `$t = 0$`", behind "is".
    fn formula_for(
        &mut self,
        subjects: Vec<Term>,
        formulas: Option<Vec<Formula>>,
    ) -> Read<Vec<Statement>> {
        let start = self.at;
        let others = self.terms()?;
        let values: Option<Vec<Formula>> = others.iter().map(as_formula).collect();
        if self.under_condition() || self.timed() {
            let plain = self
                .tokens
                .get(start)
                .is_some_and(|t| t.kind == Kind::Plain);
            let pairs = formulas.zip(values);
            let equations = pairs.and_then(|(a, b)| self.equations(&a, &b, plain));
            let Some(equations) = equations else {
                self.at = start;
                return Err(self.error("each letter wants a value of its own", "say one by one"));
            };
            return Ok(vec![self.holds(equations)?]);
        }
        let any = self.rest_for_any()?;
        if !any.is_empty() {
            let short = |(subject, other)| Statement::Is {
                subjects: vec![subject],
                what: shorthand(other, &any),
            };
            if subjects.len() == others.len() {
                return Ok(subjects.into_iter().zip(others).map(short).collect());
            }
        } else if others.len() == 1 {
            let one = |subject| Statement::Same {
                subjects: vec![subject],
                others: others.clone(),
            };
            return Ok(subjects.into_iter().map(one).collect());
        } else if subjects.len() == others.len() {
            return Ok(vec![Statement::Same { subjects, others }]);
        }
        self.at = start;
        Err(self.error("as many formulas as letters are wanted", "say one by one"))
    }

    /// Whether it is said by an adverb when something is so: "before the impact".
    pub(crate) fn timed(&self) -> bool {
        let adverb = self.find(&[Class::Adverb]);
        adverb.is_some_and(|adverb| !adverb.entry.slots.is_empty())
    }

    /// Letters and their values as equations.
    fn equations(
        &self,
        letters: &[Formula],
        values: &[Formula],
        plain: bool,
    ) -> Option<Vec<Formula>> {
        let one = |(letter, value): (&Formula, &Formula)| {
            self.formula(&format!("{} = {}", letter.source, value.source), plain)
        };
        match values {
            [value] => letters.iter().map(|letter| one((letter, value))).collect(),
            _ if values.len() == letters.len() => letters.iter().zip(values).map(one).collect(),
            _ => None,
        }
    }

    /// ", for any `$v$`" at the end of a sentence.
    fn rest_for_any(&mut self) -> Read<Vec<Term>> {
        let mut slots = vec![];
        if let Some(entry) = self.lexicon.entry("shorthand", &[Class::Noun]) {
            self.tail(entry, &mut slots)?;
        }
        match slots.iter().all(|(slot, _)| *slot == Slot::ForAny) {
            true => Ok(slots.into_iter().map(|(_, term)| term).collect()),
            false => Err(self.error("only `for any …` could stand at the end", "")),
        }
    }

    /// The phrase behind "is": a noun, an adjective, or "fixed in B".
    pub(crate) fn said(&mut self) -> Read<(NounPhrase, &'a Entry)> {
        let placed = self
            .find(&[Class::Preposition])
            .filter(|f| f.entry.name == "fixed in");
        if placed.is_some()
            && let Some(entry) = self.lexicon.entry("fixed", &[Class::Adjective])
        {
            let mut slots = vec![];
            self.slots(entry, &mut slots)?;
            let what = NounPhrase::new(entry.name, slots);
            return Ok((what, entry));
        }
        let what = self.phrase()?;
        let mut classes = NOUNS.to_vec();
        classes.push(Class::Adjective);
        match self.lexicon.entry(what.head, &classes) {
            Some(entry) => Ok((what, entry)),
            None => Err(self.unexpected("noun", "a noun could stand here", &NOUNS)),
        }
    }

    pub(crate) fn means(&mut self, written: &[Formula]) -> Read<Vec<Statement>> {
        let start = self.at;
        let meanings = match written.len() {
            1 => self.formulas(),
            _ => self.all_formulas().iter().filter_map(as_formula).collect(),
        };
        if meanings.len() != written.len() {
            self.at = start;
            return Err(self.unexpected(
                "formula",
                "what the formula stands for could stand here",
                &[],
            ));
        }
        let pairs = written.iter().cloned().zip(meanings);
        let any = self.rest_for_any()?;
        if !any.is_empty() {
            let short = |(written, meaning)| Statement::Is {
                subjects: vec![Term::Formula(written)],
                what: shorthand(Term::Formula(meaning), &any),
            };
            return Ok(pairs.map(short).collect());
        }
        Ok(pairs
            .map(|(written, meaning)| Statement::Means { written, meaning })
            .collect())
    }

    /// "between `$0$` and `$\pi/2$`", behind "between".
    pub(crate) fn bounds(&mut self, formulas: Option<Vec<Formula>>) -> Read<Vec<Statement>> {
        let start = self.at;
        let bounds = self.terms()?;
        let bounds: Option<Vec<Formula>> = bounds.iter().map(as_formula).collect();
        let (Some(subjects), Some([lower, upper])) = (formulas, bounds.as_deref()) else {
            self.at = start;
            return Err(self.error(
                "only a formula has bounds, and they are two formulas",
                "say `$x$ lies between $a$ and $b$`",
            ));
        };
        let one = |subject| Statement::Bounds {
            subject,
            lower: lower.clone(),
            upper: upper.clone(),
        };
        Ok(subjects.into_iter().map(one).collect())
    }
}

/// What stands for something whatever some letters are.
fn shorthand(of: Term, any: &[Term]) -> NounPhrase {
    let any = any.iter().map(|letter| (Slot::ForAny, letter.clone()));
    NounPhrase::new(
        "shorthand",
        std::iter::once((Slot::Of, of)).chain(any).collect(),
    )
}
