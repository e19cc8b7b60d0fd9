//! Which line says what another line says, without any law.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::grade::meaning::{KeyLines, Meaning};
use crate::grade::remembered::{Asked, Parts, Question, Remembered};
use crate::notation::document::Document;
use crate::source::Span;
use crate::verify::{Apart, Said, Written, written_symbols};
use num_traits::{One, Zero};
use std::collections::HashMap;
use std::sync::Arc;

mod part;

pub(super) use part::Part;

/// Lines of more terms are not kept for the class.
const MOST_TERMS: usize = 500;

/// What a line says, component by component; `None` where that is not worked out.
#[derive(Clone, Debug)]
pub(super) struct Entry {
    pub(super) span: Span,
    pub(super) parts: Option<Arc<[Part]>>,
    /// What the two ends of a chain say.
    pub(super) ends: Arc<[Part]>,
    /// Whether it says what a new letter is.
    pub(super) defines: bool,
    /// Whether it says that by letters of which nothing is told.
    pub(super) by_unknown: bool,
    /// What the letters are that it defines, component by component.
    pub(super) values: Arc<[Fraction]>,
    /// Its number among the lines of the class.
    pub(super) number: Option<usize>,
}

impl Entry {
    /// What no line says by itself.
    pub(super) fn of(parts: Vec<Part>) -> Self {
        Self {
            span: Span::default(),
            parts: Some(parts.into()),
            ends: Arc::default(),
            defines: false,
            by_unknown: false,
            values: Arc::default(),
            number: None,
        }
    }

    /// A part that is an attempt: a component, or one of what its ends say, which are numbered behind these.
    pub(super) fn part(&self, number: usize) -> Option<&Part> {
        let parts = self.components();
        parts.iter().chain(&*self.ends).nth(number)
    }

    /// Its components, as far as they are worked out.
    pub(super) fn components(&self) -> &[Part] {
        self.parts.as_deref().unwrap_or_default()
    }
}

/// The lines of the key and those of a student under one reading.
pub(super) struct Board<'a> {
    apart: Apart<'a>,
    remembered: Remembered,
    /// What laws say of the quantities of the key.
    laws: Vec<Fraction>,
    pub(super) key: Arc<[Entry]>,
    pub(super) own: Vec<Vec<Entry>>,
    /// Whether a student defines a letter of the key in another way.
    pub(super) conflict: bool,
}

/// A document, the lines of it that are looked at, and those that are taken in from the beginning.
#[derive(Clone, Copy)]
pub(super) struct Sheet<'a, 's> {
    pub(super) document: &'a Document,
    pub(super) lines: &'s [Span],
    pub(super) given: &'s [Span],
    /// The symbols that it writes, if it is no key.
    pub(super) written: Option<&'s Written>,
    /// Whether products of inertia are entries in it.
    pub(super) entries: bool,
}

impl Sheet<'_, '_> {
    /// Which of the lines are given.
    pub(super) fn given_of<'l>(&self, said: &'l [Said]) -> Vec<&'l Said> {
        said.iter()
            .filter(|said| self.given.contains(&said.span))
            .collect()
    }

    /// The entries of the lines, in their order.
    fn entries(&self, said: &[Said], mut entry: impl FnMut(&Said) -> Entry) -> Vec<Entry> {
        let known: HashMap<Span, &Said> = said.iter().map(|said| (said.span, said)).collect();
        let lines = self.lines.iter();
        let entries = lines.map(|&span| match known.get(&span) {
            Some(said) => entry(said),
            None => Entry {
                span,
                parts: None,
                ends: Arc::default(),
                defines: false,
                by_unknown: false,
                values: Arc::default(),
                number: None,
            },
        });
        entries.collect()
    }

    /// The entries of the lines of a key, whose components are numbered.
    fn entries_of_key(
        &self,
        apart: &mut Apart<'_>,
        said: &[Said],
        remembered: &Remembered,
    ) -> Arc<[Entry]> {
        let state = apart.state();
        if let Some(known) = state.and_then(|state| remembered.key(state)) {
            return known;
        }
        let changes = apart.changes();
        let mut numbers = 0..;
        let entries = self.entries(said, |said| {
            let mut entry = entry(apart, said);
            entry.parts = entry.parts.map(|parts| {
                let parts = parts.iter().cloned().zip(&mut numbers);
                let numbered = parts.map(|(part, number)| Part {
                    number: Some(number),
                    ..part
                });
                numbered.collect()
            });
            entry
        });
        let entries: Arc<[Entry]> = entries.into();
        if let Some(state) = state.filter(|_| apart.changes() == changes) {
            remembered.keep_key(state, &entries);
        }
        entries
    }
}

impl<'a> Board<'a> {
    pub(super) fn new(meaning: &Meaning, key: Sheet<'a, '_>, own: &[Sheet<'a, '_>]) -> Self {
        let KeyLines {
            worked_out,
            said: of_key,
            laws,
            remembered,
        } = meaning.key_lines(&key);
        let mut apart = Apart::after(key.document, worked_out);
        let of_own: Vec<Vec<Said>> = own
            .iter()
            .map(|sheet| {
                let written = sheet.written.cloned();
                let written = written.unwrap_or_else(|| written_symbols(sheet.document));
                apart.lines(sheet.document, &written, sheet.entries)
            })
            .collect();
        let mut given = key.given_of(of_key);
        apart.settle(&given);
        let defined = own
            .iter()
            .zip(&of_own)
            .flat_map(|(sheet, said)| sheet.given_of(said))
            .filter(|said| said.defines);
        let defined: Vec<&Said> = defined.collect();
        let conflict = defined.iter().any(|said| contradicts(&mut apart, said));
        if !defined.is_empty() {
            given.extend(defined);
            apart.settle(&given);
        }
        let key = key.entries_of_key(&mut apart, of_key, remembered);
        let own = own.iter().zip(&of_own);
        let own = own
            .map(|(sheet, said)| sheet.entries(said, |said| known(&mut apart, said, remembered)))
            .collect();
        Self {
            apart,
            remembered: remembered.clone(),
            laws: laws.clone(),
            key,
            own,
            conflict,
        }
    }

    /// Whether a line alone says this.
    pub(super) fn says(&mut self, entry: &Entry, goal: &Part) -> bool {
        self.answer(Question::Says, entry, goal, |own| own.finds(entry, goal))
    }

    /// An answer on a line and a component of the key, as it was for another student or is found.
    fn answer(
        &mut self,
        what: Question,
        entry: &Entry,
        goal: &Part,
        find: impl FnOnce(&mut Self) -> bool,
    ) -> bool {
        let asked = entry.number.zip(goal.number).and_then(|(line, goal)| {
            let state = self.apart.state()?;
            Some(Asked {
                what,
                state,
                line,
                goal,
            })
        });
        if let Some(answer) = asked.and_then(|asked| self.remembered.answer(asked)) {
            return answer;
        }
        let changes = self.apart.changes();
        let answer = find(self);
        if let Some(asked) = asked.filter(|_| self.apart.changes() == changes) {
            self.remembered.keep_answer(asked, answer);
        }
        answer
    }

    /// The same, worked out.
    fn finds(&mut self, entry: &Entry, goal: &Part) -> bool {
        let parts = entry.components();
        if goal.residual.is_zero() {
            return false;
        }
        if parts.iter().any(|part| part.is_multiple_of(goal)) {
            return true;
        }
        let near = parts.iter().filter(|part| part.shares_variable(goal));
        let near: Vec<&Fraction> = near.map(|part| &part.residual).collect();
        if near.is_empty() || self.apart.are_beside(&near, &goal.residual) {
            return false;
        }
        let from: Vec<Fraction> = near.into_iter().cloned().collect();
        let goal = std::slice::from_ref(&goal.residual);
        self.apart.follow(goal, &from, false) == Some(true)
    }

    /// Whether lines together, with their rates, say these; `None` where it is not worked out.
    pub(super) fn say_together(&mut self, from: &[Entry], goals: &[Part]) -> Option<bool> {
        let mut equations = vec![];
        let mut whole = true;
        for entry in from {
            match &entry.parts {
                Some(parts) => equations.extend(parts.iter().map(|part| part.residual.clone())),
                None => whole = false,
            }
        }
        let goals: Vec<Fraction> = goals.iter().map(|goal| goal.residual.clone()).collect();
        let (goals, equations) = self.apart.by_rule(goals, equations);
        let follow = self.apart.follow(&goals, &equations, true)?;
        (follow || whole).then_some(follow)
    }

    /// Whether it can be seen without working it out that a line and its rates do not say this.
    pub(super) fn is_far_from(&mut self, entry: &Entry, goal: &Part) -> bool {
        self.answer(Question::IsFar, entry, goal, |own| {
            match entry.parts.as_deref() {
                Some([one]) => own.apart.is_far_from(&one.residual, &goal.residual),
                _ => false,
            }
        })
    }

    /// Whether a line of the key speaks of a period or a frequency that a rule tells.
    pub(super) fn is_by_rule(&self, line: usize) -> bool {
        let mut parts = self.key[line].components().iter();
        parts.any(|part| self.apart.is_by_rule(&part.residual))
    }

    /// What laws say of the quantities of the key, as a line would.
    pub(super) fn laws(&self) -> Entry {
        let laws = self.laws.iter();
        Entry::of(laws.map(|law| Part::new(law.clone(), None)).collect())
    }

    /// Whether a line of the key says what something is that never changes, such as a moment of inertia.
    pub(super) fn is_constant(&self, line: usize) -> bool {
        let parts = self.key[line].components();
        let constant = |part: &Part| self.apart.is_constant(&part.residual);
        !parts.is_empty() && parts.iter().all(constant)
    }

    /// Whether a line defines a letter to be what a goal says of another one.
    pub(super) fn defines_as(&self, entry: &Entry, goal: &Part) -> bool {
        let Some(head) = goal.head else { return false };
        let head = Fraction::from(Polynomial::variable(head));
        let mut values = entry.values.iter();
        values.any(|value| Part::new(head.clone() - value.clone(), None).is_multiple_of(goal))
    }

    /// Whether letters of which nothing is told stand in a line.
    pub(super) fn has_unknown(&self, entry: &Entry) -> bool {
        let parts = entry.components().iter();
        let mut variables = parts.flat_map(|part| &part.variables);
        variables.any(|&variable| self.apart.is_unknown(variable))
    }
}

/// The entry of a line, if one of the class said the same before; else it is worked out.
fn known(apart: &mut Apart<'_>, said: &Said, remembered: &Remembered) -> Entry {
    let wording = apart.wording(said);
    if let Some(Parts {
        parts,
        ends,
        number,
    }) = wording.as_ref().and_then(|q| remembered.line(q))
    {
        return Entry {
            span: said.span,
            parts,
            ends,
            defines: false,
            by_unknown: false,
            values: Arc::default(),
            number: Some(number),
        };
    }
    let changes = apart.changes();
    let mut entry = entry(apart, said);
    let terms = entry.components().iter().map(|part| part.terms().len());
    let same = apart.changes() == changes && terms.sum::<usize>() <= MOST_TERMS;
    if let Some(wording) = wording.filter(|_| same) {
        entry.number = Some(remembered.keep_line(wording, &entry));
    }
    entry
}

fn entry(apart: &mut Apart<'_>, said: &Said) -> Entry {
    let sides = said.sides.as_ref();
    let by_unknown = said.defines && sides.is_some_and(|sides| tells_unknown(apart, sides));
    let values: Option<Arc<[Fraction]>> = match sides.filter(|_| said.defines) {
        Some(sides) => sides.iter().map(|(left, _)| apart.normal(left)).collect(),
        None => None,
    };
    let values = values.unwrap_or_default();
    let mut part = |(left, right): &(Fraction, Fraction)| {
        let residual = apart.normal(&(left.clone() - right.clone()))?;
        let head = [left, right]
            .into_iter()
            .find_map(|side| single(&apart.normal(side)?));
        Some(Part {
            pace: apart.pace_in(&residual),
            ..Part::new(residual, head)
        })
    };
    Entry {
        span: said.span,
        parts: sides.and_then(|sides| sides.iter().map(&mut part).collect()),
        ends: said.ends.iter().filter_map(part).collect(),
        defines: said.defines,
        by_unknown,
        values,
        number: None,
    }
}

/// Whether a letter of which nothing is told is left where definitions are put in.
fn tells_unknown(apart: &mut Apart<'_>, sides: &[(Fraction, Fraction)]) -> bool {
    sides
        .iter()
        .flat_map(|(left, right)| [left, right])
        .any(|side| {
            let value = apart.normal(side);
            let variables = value.map(|value| value.variables()).unwrap_or_default();
            variables
                .into_iter()
                .any(|variable| apart.is_unknown(variable))
        })
}

/// The variable that a value is, but for its sign.
fn single(value: &Fraction) -> Option<Variable> {
    let [(monomial, number)] = value.numerator().terms() else {
        return None;
    };
    let powers = monomial.powers();
    match powers[..] {
        [(variable, 1)]
            if value.is_polynomial() && (number.is_one() || (-number.clone()).is_one()) =>
        {
            Some(variable)
        }
        _ => None,
    }
}

/// Whether a definition does not fit to what is known, though no new letter stands in it.
fn contradicts(apart: &mut Apart<'_>, said: &Said) -> bool {
    let mut sides = said.sides.iter().flat_map(|sides| &**sides);
    sides.any(|(left, right)| {
        let Some(left_over) = apart.normal(&(left.clone() - right.clone())) else {
            return true;
        };
        let mut variables = left_over.variables().into_iter();
        !left_over.is_zero() && !variables.any(|variable| apart.is_unknown(variable))
    })
}
