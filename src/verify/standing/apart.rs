//! What lines say of each other by algebra and definitions alone, without the laws that make them true.
//!
//! `L_x = I ω_x` and `M_x = I ω̇_x` are both true of one body, and each follows from the other only by a law. Here every
//! quantity keeps a variable of its own and no law of mechanics is put in, so that one line follows from another only if
//! it says the same, in components, in vectors, or with a definition put in.

use crate::algebra::{Fraction, Monomial, Polynomial, Variable};
use crate::notation::ast::{Line, Relation};
use crate::notation::document::{Document, Headings, Item, Row};
use crate::source::Span;
use crate::verify::facts::Source;
use crate::verify::facts::premises::{Extended, Facts};
use crate::verify::language::statement::Declaration;
use crate::verify::model::atoms::{Nature, fraction};
use crate::verify::standing::chains::Chain;
use crate::verify::standing::hold::Sides;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::memory::{Memory, Recall};
use crate::verify::standing::parts::Part;
use crate::verify::standing::prepared::Prepared;
use crate::verify::standing::written::{names_an_instant, without_number, written_symbols};
use crate::verify::term::letters::At;
use num_traits::Zero;
use std::collections::HashMap;

/// No rate of a letter is higher.
const MOST_RATES: usize = 8;

/// What one line says.
#[derive(Clone, Debug)]
pub(crate) struct Said {
    /// The bytes of the line.
    pub(crate) span: Span,
    /// Its left and right sides, component by component; `None` where they are not worked out.
    pub(crate) sides: Option<Vec<(Fraction, Fraction)>>,
    /// Whether it says what a letter is of which nothing was told.
    pub(crate) defines: bool,
}

/// What was worked out with a document, for others to go on from.
#[derive(Clone, Debug)]
pub(crate) struct WorkedOut {
    prepared: Prepared,
    /// What was taken in.
    settled: Vec<(Fraction, Source)>,
    /// The sides of links, if a link has the same on every line.
    sides: Option<Memory<Sides>>,
}

/// Documents under one reading, in which laws say nothing.
pub(crate) struct Apart<'a> {
    pub(super) judge: Judge<'a>,
    facts: Facts,
    /// What was taken in.
    settled: Vec<(Fraction, Source)>,
    /// The sides of links in other documents that go on from the same.
    pub(super) recalled: Option<Recall<Sides>>,
    /// Whether nothing but that was taken in from which it goes on.
    pub(super) is_fresh: bool,
}

impl<'a> Apart<'a> {
    /// A reading by these declarations.
    pub(crate) fn new(document: &'a Document, declarations: &[Declaration]) -> Self {
        let mut prepared = Prepared::new(declarations, written_symbols(document), 0);
        prepared.reading.system.apart = true;
        Self {
            judge: Judge::over(document, Part::default(), prepared),
            facts: Facts::default(),
            settled: vec![],
            recalled: None,
            is_fresh: false,
        }
    }

    /// To go on with from what was worked out with a document, and taken in.
    pub(crate) fn after(document: &'a Document, worked_out: &WorkedOut) -> Self {
        let mut prepared = worked_out.prepared.clone();
        let facts = std::mem::take(&mut prepared.facts);
        let system = &mut prepared.reading.system;
        let sides = worked_out.sides.clone();
        let recalled = sides.map(|sides| Recall::new(sides, system));
        Self {
            judge: Judge::over(document, Part::default(), prepared),
            facts,
            settled: worked_out.settled.clone(),
            recalled,
            is_fresh: true,
        }
    }

    /// What was worked out so far, and all letters besides, with these definitions taken in.
    pub(crate) fn worked_out(mut self, definitions: &[&Said]) -> WorkedOut {
        let (reading, known) = (&mut self.judge.reading, &mut self.judge.known);
        reading.system.set_dimensions(3);
        known.work_out(&reading.letters, &mut reading.system);
        self.settle(definitions);
        let uniform = self.judge.reading.letters.is_uniform();
        let prepared = Prepared {
            reading: self.judge.reading,
            known: self.judge.known,
            facts: self.facts,
            links: None,
        };
        WorkedOut {
            prepared,
            settled: self.settled,
            sides: uniform.then(Memory::default),
        }
    }

    /// What each line of a document says, with products of inertia as entries or as integrals. A line of running text
    /// that only names an instant says nothing.
    pub(crate) fn lines(&mut self, document: &'a Document, entries: bool) -> Vec<Said> {
        self.judge.reading.letters.customs.integrals = !entries;
        self.judge.document = document;
        self.judge.chain = Chain::default();
        self.judge.words.headings = Headings::default();
        self.judge.at = At::default();
        let written = written_symbols(document);
        self.judge.reading.letters.written.extend(written);
        self.judge.known.forget_symbols();
        let mut said = vec![];
        for item in &document.items {
            match item {
                Item::Heading { level, text, .. } => {
                    self.judge.words.headings.enter(*level, text);
                    self.judge.at.sections = self.judge.words.headings.texts();
                }
                Item::Formula(formula) => {
                    for row in &formula.rows {
                        if let Row::Line(line) = row
                            && (formula.display || !names_an_instant(line))
                        {
                            said.push(self.line(line));
                        }
                    }
                }
                _ => {}
            }
        }
        said
    }

    fn line(&mut self, line: &Line) -> Said {
        let place = self.judge.document.place(line.span.start);
        (self.judge.at.cell, self.judge.at.line) = (place.cell, place.line);
        let links = self.judge.chain.links(&without_number(line));
        let (mut sides, mut defines) = (Some(vec![]), false);
        for link in &links {
            let equal = matches!(link.relation, Relation::Equal | Relation::Defined);
            let worked_out = equal.then(|| self.sides_of(link));
            match (worked_out, &mut sides) {
                (Some(Ok(one)), Some(all)) => {
                    if let Some((letter, left, _)) = &one.settles {
                        self.judge.known.shapes.insert(letter.clone(), left.shape());
                        // What has a shape by a line of this document has none in others.
                        self.recalled = None;
                        defines = true;
                    }
                    all.extend(one.sides);
                }
                _ => sides = None,
            }
        }
        Said {
            span: line.span,
            sides: sides.filter(|sides| !sides.is_empty()),
            defines,
        }
    }

    /// Takes in what is declared for the whole document, and these definitions. To be called when all lines are there.
    pub(crate) fn settle(&mut self, definitions: &[&Said]) {
        let reading = &self.judge.reading;
        let declared = reading.active_premises(&At::default()).into_iter();
        let mut premises = self.same_quantities();
        premises.extend(declared.map(|at| {
            let premise = &reading.premises[at];
            (premise.equation.clone(), premise.source.clone())
        }));
        premises.extend(definitions.iter().flat_map(|said| equations(said)));
        if premises == self.settled && !premises.is_empty() {
            return;
        }
        self.is_fresh = false;
        self.facts = Facts::lawless();
        let atoms = &mut self.judge.reading.system.atoms;
        self.facts.extend_all(atoms, premises.clone());
        self.settled = premises;
    }

    /// Variables to which one law gives one value are one quantity: the `L_x` of `L` and a letter of its own.
    fn same_quantities(&self) -> Vec<(Fraction, Source)> {
        let atoms = &self.judge.reading.system.atoms;
        let mut first: HashMap<(&str, &Polynomial, &Polynomial), Variable> = HashMap::new();
        let mut same = vec![];
        for variable in 0..atoms.len() as Variable {
            let atom = atoms.atom(variable);
            let Some(law) = atom.law.as_ref().filter(|_| atom.rate_of.is_none()) else {
                continue;
            };
            let (above, below) = (law.value.numerator(), law.value.denominator());
            let other = *first.entry((law.name, above, below)).or_insert(variable);
            if other != variable {
                let source = Source::Declared(atoms.latex(variable));
                same.push((fraction(variable) - fraction(other), source));
            }
        }
        same
    }

    /// A value with what is taken in put in; `None` where it grows too large.
    pub(crate) fn normal(&mut self, of: &Fraction) -> Option<Fraction> {
        let atoms = &mut self.judge.reading.system.atoms;
        self.facts.normal(atoms, of).ok()
    }

    /// Whether nothing is told of a variable.
    pub(crate) fn is_unknown(&self, variable: Variable) -> bool {
        self.judge.reading.system.atoms.is_unknown(variable)
    }

    /// Whether it can be seen without working it out that these equations, without their rates, say nothing of a goal.
    ///
    /// An equation is solved for a variable that stands alone in a term, and the goal changes only if that is in it. One
    /// equation makes the goal vanish only if it divides the goal; then no variable has a higher power in it than there.
    /// This holds of free variables, none of which is told by another, and of equations without a number as a term: with
    /// that, one may come to stand alone where another is put in.
    pub(crate) fn are_beside(&self, from: &[&Fraction], goal: &Fraction) -> bool {
        let atoms = &self.judge.reading.system.atoms;
        let goal = goal.numerator();
        let is_free = |v: &Variable| {
            let atom = atoms.atom(*v);
            let plain = matches!(atom.nature, Nature::Quantity | Nature::Unknown);
            plain && atom.square.is_none() && self.facts.square(*v).is_none()
        };
        let rates = |v: &Variable| std::iter::successors(Some(*v), |&v| atoms.known_rate(v));
        let is_tied = |v: &Variable| {
            let mut rates = rates(v).skip(1).take(MOST_RATES);
            rates.any(|rate| self.facts.rule(rate).is_some() || goal.degree_in(rate) > 0)
        };
        let equations = || from.iter().map(|equation| equation.numerator());
        let variables: Vec<Variable> = equations().flat_map(Polynomial::variables).collect();
        let stands_alone = |v: &Variable| {
            let lone = |m: &Monomial| m.degree() == 1 && m.exponent(*v) == 1;
            equations().any(|own| own.terms().iter().any(|(m, _)| lone(m)))
        };
        let has_number = || equations().any(|own| own.terms().iter().any(|(m, _)| m.degree() == 0));
        let untouched = || {
            let mut in_goal = variables.iter().filter(|v| goal.degree_in(**v) > 0);
            !in_goal.any(stands_alone) && !has_number()
        };
        let divides = || match from {
            [one] => variables
                .iter()
                .all(|&v| one.numerator().degree_in(v) <= goal.degree_in(v)),
            _ => true,
        };
        (untouched() || !divides())
            && !variables.iter().any(is_tied)
            && variables.iter().chain(&goal.variables()).all(is_free)
    }

    /// Whether these vanish if those do, with the rates of those or without; `None` where it is not worked out, or where
    /// those contradict each other.
    pub(crate) fn follow(
        &mut self,
        goals: &[Fraction],
        from: &[Fraction],
        rates: bool,
    ) -> Option<bool> {
        let atoms = &mut self.judge.reading.system.atoms;
        let mut facts = self.facts.clone();
        let source = Source::Line(None, 0);
        let mut whole = true;
        for equation in from {
            // A product that vanishes does not say which of its factors does.
            if !facts.normal(atoms, equation).is_ok_and(|e| is_plain(&e)) {
                whole = false;
                continue;
            }
            let put = match rates {
                true => facts.extend(atoms, equation, &source),
                false => facts.put(atoms, equation, &source),
            };
            match put {
                Ok(Extended::Contradicts) => return None,
                Ok(Extended::Unsolved) | Err(_) => whole = false,
                Ok(_) => {}
            }
        }
        let mut all = true;
        for goal in goals {
            all &= facts.normal(atoms, goal).ok()?.is_zero();
        }
        (all || whole).then_some(all)
    }
}

fn equations(said: &Said) -> Vec<(Fraction, Source)> {
    let sides = said.sides.iter().flatten();
    let differences = sides.map(|(left, right)| left.clone() - right.clone());
    let source = || Source::Line(None, 0);
    differences.map(|equation| (equation, source())).collect()
}

/// Whether an equation says what one variable is, whatever the others are; or nothing at all.
fn is_plain(equation: &Fraction) -> bool {
    let value = equation.numerator();
    let plain = |v: &Variable| {
        value.degree_in(*v) == 1 && value.coefficient_of(*v, 1).is_constant().is_some()
    };
    value.is_constant().is_some() || value.variables().iter().any(plain)
}
