//! Rules for marks, labels and customs of notation.

use super::clause::as_formula;
use super::heads::INSTANT;
use super::lexicon::{Class, Entry};
use super::phrase::NOUNS;
use super::reader::{Read, Reader};
use super::statement::{Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term};
use super::traits::Trait;
use super::words::Kind;
use crate::notation::ast::Kind as Tree;
use crate::notation::document::Row;

/// The verbs of a rule.
const MEANS: [&str; 19] = [
    "means", "mean", "is", "are", "has", "have", "hold", "holds", "denotes", "denote", "takes",
    "take", "gives", "give", "enclose", "encloses", "contain", "contains", "stands",
];

/// How a label is called.
pub(crate) const LABELS: [&str; 6] = [
    "label",
    "labels",
    "subscript",
    "subscripts",
    "superscript",
    "superscripts",
];

/// Nouns of which a sentence may say how they are written everywhere.
const CONVENTIONS: [&str; 4] = ["products of inertia", "component", "time", "dimension"];

impl<'a> Reader<'a> {
    /// "A tilde means …", "the label `$b$` means …"; none if the sentence does not begin so.
    pub(crate) fn rule(&mut self) -> Read<Option<Statement>> {
        let start = self.at;
        self.take_any(&["a", "an", "the"]);
        let sign = if self.take_any(&LABELS) {
            self.labels()?
        } else {
            let noun = self.find(&NOUNS).map_or(0, |noun| noun.length);
            match self
                .find(&[Class::Mark, Class::Custom])
                .filter(|sign| sign.length >= noun && !self.speaks_of_body(sign.length))
            {
                Some(found) => {
                    self.at += found.length;
                    let mark = found.entry.class == Class::Mark;
                    let (name, on) = (found.entry.name, self.take("on a rate"));
                    match (mark, on) {
                        (true, false) => Sign::Mark(name),
                        (false, false) => Sign::Custom(name),
                        _ => return Err(self.error("only a label may be one of a rate", "")),
                    }
                }
                None => {
                    self.at = start;
                    return Ok(None);
                }
            }
        };
        if !self.take_any(&MEANS) {
            return Err(self.unexpected("verb", "`means` could stand here", &[Class::Verb]));
        }
        let mut meaning = self.meaning()?;
        if let Some(fixed) = self.fixed_behind() {
            meaning = NotationMeaning::Fixed(fixed);
        }
        Ok(Some(Statement::Notation { sign, meaning }))
    }

    /// Whether a word comes next that rules of notation are made of, or conventions; a sentence that is `told` of a letter
    /// speaks of its components, and makes no convention of them.
    pub(crate) fn at_rule(&self, told: bool) -> bool {
        let convention = self.find(&[Class::Noun]);
        LABELS.contains(&self.word())
            || self
                .find(&[Class::Mark, Class::Custom, Class::Meaning])
                .is_some_and(|sign| !self.speaks_of_body(sign.length))
            || !told && convention.is_some_and(|noun| CONVENTIONS.contains(&noun.entry.name))
    }

    /// Whether the word for a mark is one for a body here: "the bar is a uniform rod".
    pub(crate) fn speaks_of_body(&self, length: usize) -> bool {
        let thing = self.find(&[Class::Thing]);
        let means = ["means", "mean", "denotes", "denote"].contains(&self.word_at(length));
        thing.is_some_and(|thing| thing.length == length) && !means
    }

    pub(crate) fn labels(&mut self) -> Read<Sign> {
        let mut labels = vec![];
        loop {
            match self
                .peek()
                .filter(|t| !matches!(t.kind, Kind::Comma | Kind::Semicolon))
            {
                Some(token) => labels.push(token.text.clone()),
                None => return Err(self.unexpected("label", "the label could stand here", &[])),
            }
            self.at += 1;
            if !self.take_choice() {
                break;
            }
        }
        let on_whole = WHOLES.iter().any(|whole| self.take(whole));
        Ok(Sign::Label { labels, on_whole })
    }

    /// What a mark or a label means.
    pub(crate) fn meaning(&mut self) -> Read<NotationMeaning> {
        let start = self.at;
        if let Some(found) = self.take_fixed() {
            return Ok(NotationMeaning::Fixed(found));
        }
        self.at = start;
        let seen = self
            .find(&[Class::Preposition])
            .filter(|f| f.entry.name == "seen from");
        if seen.is_some()
            && let Some(rate) = self.lexicon.entry("rate", &[Class::Noun])
        {
            let mut slots = vec![];
            self.slots(rate, &mut slots)?;
            return Ok(NotationMeaning::Noun(NounPhrase::new("rate", slots)));
        }
        if self.word() == "at" {
            self.at += 1;
        }
        if let Some(sides) = self.sides_of_event()? {
            return Ok(NotationMeaning::Noun(sides));
        }
        Ok(NotationMeaning::Noun(self.phrase()?))
    }

    /// "the instants just before and just after the impulse"
    fn sides_of_event(&mut self) -> Read<Option<NounPhrase>> {
        let start = self.at;
        self.take_any(&["the"]);
        self.take_any(&["instant", "instants", "moment", "moments", "time", "times"]);
        let mut sides: Vec<(&'static str, Vec<Term>)> = vec![];
        while let Some(adverb) = self.take_side() {
            let open = self.word() == "and";
            let event = match open {
                true => vec![],
                false => vec![Term::Phrase(Box::new(self.phrase()?))],
            };
            sides.push((adverb, event));
            if !self.take_any(&["and"]) {
                break;
            }
        }
        let Some((_, event)) = sides.last().cloned() else {
            self.at = start;
            return Ok(None);
        };
        let which = sides.into_iter().map(|(side, own)| {
            let of = if own.is_empty() { event.clone() } else { own };
            let of = of.into_iter().map(|event| (Slot::Of, event)).collect();
            let side = NounPhrase::new(side, of);
            (Slot::Which, Term::Phrase(Box::new(side)))
        });
        Ok(Some(NounPhrase::new(INSTANT, which.collect())))
    }

    fn take_side(&mut self) -> Option<&'static str> {
        let adverb = self.find(&[Class::Adverb])?;
        let side = ["before", "after"]
            .into_iter()
            .find(|side| adverb.entry.name == *side)?;
        self.at += adverb.length;
        Some(side)
    }

    /// Takes a fixed meaning, if that is all that is said.
    pub(crate) fn take_fixed(&mut self) -> Option<&'static str> {
        let start = self.at;
        let found = self.take_entry(&[Class::Meaning]).or_else(|| {
            self.take_any(&["the"]);
            self.take_entry(&[Class::Meaning])
        });
        match found {
            Some(found)
                if self.done() || self.kind() == Some(Kind::Semicolon) || self.at_extent() =>
            {
                Some(found.entry.name)
            }
            _ => {
                self.at = start;
                None
            }
        }
    }

    /// Takes a fixed meaning behind a noun: "the rate, entry by entry".
    pub(crate) fn fixed_behind(&mut self) -> Option<&'static str> {
        let start = self.at;
        self.take_sign(Kind::Comma);
        let fixed = self.take_fixed();
        if fixed.is_none() {
            self.at = start;
        }
        fixed
    }

    /// "takes functions of `$\psi$` and `$\theta$`", "… of the coordinates and their rates".
    pub(crate) fn functions_of(&mut self, operators: Vec<Formula>) -> Read<Vec<Statement>> {
        let outer = self.owner.clone();
        let mut terms = vec![];
        loop {
            self.term(&mut terms)?;
            self.owner.clone_from(&terms);
            let start = self.at;
            if !self.take_choice() || !self.starts_term() {
                self.at = start;
                break;
            }
        }
        self.owner = outer;
        let letters = terms.iter().map(|term| match term {
            Term::Phrase(rates) if rates.head == "rate" => self.dotted(rates),
            letter => as_formula(letter).map(|letter| vec![letter]),
        });
        let formulas: Option<Vec<Formula>> =
            letters.collect::<Option<Vec<_>>>().map(|l| l.concat());
        let meaning = formulas.map_or_else(
            || {
                let slots = terms.into_iter().map(|term| (Slot::Of, term));
                NotationMeaning::Noun(NounPhrase::new("function", slots.collect()))
            },
            NotationMeaning::FunctionsOf,
        );
        Ok(operating(operators, &meaning))
    }
}

/// What a label may stand on that is no letter.
const WHOLES: [&str; 10] = [
    "on a rate",
    "on rates",
    "on a bracket",
    "on brackets",
    "on square brackets",
    "on round brackets",
    "on parentheses",
    "on braces",
    "at brackets",
    "behind brackets",
];

impl Reader<'_> {
    /// "their rates": the letters with a dot.
    fn dotted(&self, rates: &NounPhrase) -> Option<Vec<Formula>> {
        let of = rates.all(Slot::Of).map(as_formula);
        let dotted = of.map(|letter| self.formula(&format!("\\dot{{{}}}", letter?.source), false));
        dotted.collect()
    }
}

/// One rule for each of some operators.
pub(crate) fn operating(operators: Vec<Formula>, meaning: &NotationMeaning) -> Vec<Statement> {
    let rule = |operator| Statement::Notation {
        sign: Sign::Operator(operator),
        meaning: meaning.clone(),
    };
    operators.into_iter().map(rule).collect()
}

/// Whether a noun said of a formula says what an operator means: it is said of nothing, or the formula is a product, ends
/// with a sign that stands before something, or cannot stand alone.
pub(crate) fn is_operator(formula: &Formula, phrase: &NounPhrase, entry: &Entry) -> bool {
    let operates = match &formula.row {
        Row::Expression(node) => match node.kind {
            Tree::Product(_) | Tree::Error(_) => true,
            // `\omega^\times` and `\omega_\times` are letters with a mark.
            Tree::Skew(_) => {
                let before = formula.source.strip_suffix("\\times").map(str::trim_end);
                before.is_some_and(|vector| !vector.ends_with(['^', '_']))
            }
            _ => false,
        },
        Row::Line(_) | Row::Unreadable { .. } => true,
    };
    entry.traits.has(Trait::Operator) && (operates || phrase.slot(Slot::Of).is_none())
}
