//! What is said of one instant: values of letters then, what is zero or at rest then, and lines that hold then alone.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Relation};
use crate::notation::document::Row;
use crate::verify::Role;
use crate::verify::facts::{START, Source};
use crate::verify::language::heads::{INITIAL_VALUE, INSTANT, START_OF_MOTION};
use crate::verify::language::is_quantity;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::LineRole;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::instants::tells_state;
use crate::verify::reading::loads_read::AT_REST;
use crate::verify::reading::names::node_of;
use crate::verify::term::letters::{Reach, spelled};
use crate::verify::term::quantity::Quantity;
use num_traits::Zero;

/// The noun of a letter that has the value of another one at an instant.
const VALUE: &str = "value";

/// The adjective of what is so at the start.
const INITIAL: &str = "initial";

impl Builder<'_> {
    /// A letter that is the value of a quantity at an instant is constant: not one of which something is so then.
    pub(super) fn name_values_at_instants(&mut self, declarations: &[Declaration]) {
        for declaration in declarations.iter().filter(|d| is_of_instant(d)) {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let says_what_it_is = is_quantity(what.head) && !is_trait(what);
            if !says_what_it_is || matches!(what.head, AT_REST | "fixed") {
                continue;
            }
            for subject in subjects {
                if let Term::Formula(letter) = subject
                    && is_number(letter)
                    && !self.is_told_otherwise(letter)
                {
                    self.denote_number(letter, declaration);
                }
            }
        }
    }

    /// What has a value at an instant is not constant by custom.
    pub(super) fn let_values_change(&mut self, declarations: &[Declaration]) {
        for declaration in declarations.iter().filter(|d| is_of_instant(d)) {
            for letter in letters_then(&declaration.statement) {
                if is_number(&letter)
                    && let Some(value) = self.scalar(&letter, declaration)
                    && let Some(letter) = value.as_variable()
                {
                    self.system().atoms.let_change(letter);
                }
            }
        }
    }

    /// Whether a sentence that holds always says what a letter is.
    fn is_told_otherwise(&self, letter: &Formula) -> bool {
        let writing = node_of(letter).map(spelled);
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if !is_trait(what) => subjects
                .iter()
                .any(|s| matches!(s, Term::Formula(own) if node_of(own).map(spelled) == writing)),
            _ => false,
        })
    }

    /// What sentences say of instants.
    pub(super) fn read_instants(&mut self, declarations: &[Declaration]) {
        for declaration in declarations.iter().filter(|d| is_of_instant(d)) {
            let read = self.read_at_instant(declaration);
            read.unwrap_or_else(|| self.say_unused(declaration));
        }
    }

    fn read_at_instant(&mut self, declaration: &Declaration) -> Option<()> {
        let (name, condition) = instant_of_statement(&declaration.statement)?;
        let mut values = match &declaration.statement {
            Statement::Is { subjects, what } => match what.head {
                "zero" => self.zeros(subjects, declaration)?,
                AT_REST | "fixed" => self.rates_at_rest(subjects, &what.slots)?,
                VALUE | INITIAL_VALUE => self.differences_of_values(subjects, what, declaration)?,
                _ => self.differences(subjects, what, declaration)?,
            },
            Statement::Does { subjects, verb, .. } if *verb != "hold" => {
                self.rates_at_rest(subjects, &[])?
            }
            Statement::Does { subjects, .. } => {
                let each = subjects.iter().map(|s| self.sides_less(s, declaration));
                each.collect::<Option<Vec<_>>>()?.concat()
            }
            _ => return None,
        };
        if let Some(condition) = condition {
            values.extend(self.sides_less(&condition, declaration)?);
        }
        if name == START {
            values.iter().for_each(|value| self.changes_evenly(value));
        }
        let source = Self::source_of(declaration);
        let values = values.into_iter().map(|value| (value, source.clone()));
        let instant = self.reading.instants.named(&name);
        instant.values.extend(values);
        Some(())
    }

    /// "`$v_0$` is the value of `$v$` at `$t=0$`": the one less the other.
    fn differences_of_values(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Vec<Fraction>> {
        let of: Vec<&Term> = what.all(Slot::Of).collect();
        if of.len() != subjects.len() {
            return None;
        }
        let mut all = vec![];
        for (letter, of) in subjects.iter().zip(of) {
            let quantity = self.operand(of, declaration)?;
            all.push(self.less(letter, &quantity, declaration)?);
        }
        Some(all)
    }

    /// "`$v_1$` is the speed of P at the start": the letter less the quantity.
    fn differences(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Vec<Fraction>> {
        let [letter] = subjects else { return None };
        let mut what = what.clone();
        what.slots
            .retain(|(slot, term)| instant_of(*slot, term).is_none());
        what.adjectives.retain(|adjective| *adjective != INITIAL);
        let quantity = self.quantity(&what, declaration)?;
        Some(vec![self.less(letter, &quantity, declaration)?])
    }

    /// A number less the letter that it is at an instant.
    fn less(
        &mut self,
        letter: &Term,
        quantity: &Quantity,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        let own = self.operand(letter, declaration)?;
        let own = self.system().value_of(&own).ok()?.to_scalar().ok()?;
        let then = self.system().value_of(quantity).ok()?.to_scalar().ok()?;
        let atoms = &mut self.system().atoms;
        if !atoms.derivative(&own).is_zero() {
            return None;
        }
        let is_time = then == atoms.time();
        let instants = &mut self.reading.instants;
        instants.letters.extend(own.as_variable());
        instants.times.extend(own.as_variable().filter(|_| is_time));
        Some(then - own)
    }

    /// What changes evenly, or with an even rate, does so from its value at the start.
    fn changes_evenly(&mut self, value: &Fraction) {
        let atoms = &mut self.system().atoms;
        let (time, rate) = (atoms.time(), atoms.derivative(value));
        let second = atoms.derivative(&rate);
        let half = Fraction::from_ratio(1, 2);
        let even = value.clone() - time.clone() * rate + half * time.clone() * time * second;
        self.reading.instants.candidates.push(even);
    }

    /// "`$\theta$` and the speed of P are zero at the start."
    fn zeros(&mut self, subjects: &[Term], declaration: &Declaration) -> Option<Vec<Fraction>> {
        let mut all = vec![];
        for subject in subjects {
            let quantity = self.operand(subject, declaration)?;
            all.extend(self.system().value_of(&quantity).ok()?.entries);
        }
        Some(all)
    }

    /// Bodies and points are at rest in the inertial frame.
    fn rates_at_rest(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
    ) -> Option<Vec<Fraction>> {
        let ground = self.reading.system.ground;
        let mut frames = slots
            .iter()
            .filter(|(slot, _)| matches!(slot, Slot::FixedIn | Slot::RelativeTo));
        if frames.any(|(_, frame)| self.frame(frame) != Some(ground)) {
            return None;
        }
        let mut all = vec![];
        for subject in subjects {
            let point = match (self.body(subject), self.point(subject)) {
                (Some(body), _) => {
                    let frame = self.reading.system.bodies[body].frame?;
                    let spin = self.system().angular_velocity(frame, ground);
                    all.extend(spin.iter().cloned());
                    self.centre_of(body)
                }
                (None, Some(point)) => point,
                (None, None) => return None,
            };
            let velocity = self.system().velocity(point, ground);
            all.extend(velocity.iter().cloned());
        }
        all.retain(|rate| !rate.is_zero());
        Some(all)
    }

    /// The sides of an equation, one less the next, component by component.
    fn sides_less(&mut self, formula: &Term, declaration: &Declaration) -> Option<Vec<Fraction>> {
        let Term::Formula(Formula {
            row: Row::Line(line),
            ..
        }) = formula
        else {
            return None;
        };
        let equal = |(relation, _): &(Relation, _)| *relation == Relation::Equal;
        if !line.relations.iter().all(equal) {
            return None;
        }
        let sides = line.sides.iter();
        let values = sides.map(|side| self.mentioned_value(&Formula::of(side), declaration));
        let values: Vec<_> = values.collect::<Option<_>>()?;
        let custom = self.reading.letters.component_frame;
        let mut all = vec![];
        for pair in values.windows(2) {
            let [left, right] = pair else { continue };
            let (left, right) = self.system().compared(left, right, custom).ok()?;
            let entries = left.entries.into_iter().zip(right.entries);
            all.extend(entries.map(|(left, right)| left - right));
        }
        Some(all)
    }

    /// Time is counted from the start.
    pub(super) fn begin_time(&mut self) {
        let time = self.system().atoms.time();
        let instants = &mut self.reading.instants;
        let start = instants.all.iter_mut().filter(|i| i.name == START);
        start.for_each(|start| {
            start
                .values
                .push((time.clone(), Source::Instant(START.into())))
        });
    }

    /// Whether another sentence says something of an instant.
    fn speaks_of_instant(&self, name: &str) -> bool {
        let mut said = self.declarations.iter().map(|d| &d.statement);
        said.any(|said| instant_of_statement(said).is_some_and(|(own, _)| own == name))
    }

    /// "Lines 3 to 9 hold at `$t=0$`", "at `$\\varphi=0$`": what they say is said of that instant, and so is the relation that
    /// tells it. What holds at a time is given.
    pub(super) fn lines_hold_at(
        &mut self,
        lines: &Reach,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let found = slots
            .iter()
            .find_map(|(slot, term)| instant_of(*slot, term));
        let (name, condition) = found?;
        // "at the instant when A coincides with B": what is so then is not worked with.
        if condition.is_none() && tells_state(&name) && !self.speaks_of_instant(&name) {
            return None;
        }
        let told = name == START || slots.iter().any(|(_, term)| is_time_told(term));
        let values = match condition.filter(|_| !told) {
            Some(condition) => self.sides_less(&condition, declaration)?,
            None => vec![],
        };
        let source = Self::source_of(declaration);
        let instant = self.reading.instants.named(&name);
        instant
            .values
            .extend(values.into_iter().map(|value| (value, source.clone())));
        instant.lines.push(lines.clone());
        let role = LineRole::new(lines.clone(), Some(Role::Given));
        self.reading.roles.extend(told.then_some(role));
        Some(())
    }
}

/// "at `$t = t_1$`": what holds there is told. What holds at `$\\varphi = 0$` is a claim.
fn is_time_told(term: &Term) -> bool {
    let Term::Formula(Formula {
        row: Row::Line(line),
        ..
    }) = term
    else {
        return false;
    };
    let time = |side: &Node| matches!(&side.kind, Kind::Symbol(symbol) if symbol.name == "t");
    line.sides.first().is_some_and(time)
}

/// Whether a sentence says something of one instant alone, and what.
pub(super) fn is_of_instant(declaration: &Declaration) -> bool {
    instant_of_statement(&declaration.statement).is_some()
}

/// The instant of which a statement speaks, and the relation that tells it where it is no time.
fn instant_of_statement(statement: &Statement) -> Option<(String, Option<Term>)> {
    match statement {
        Statement::Is { what, .. } => {
            let said = what.slots.iter().find_map(|(s, t)| instant_of(*s, t));
            let initial = what.is(INITIAL) || what.head == INITIAL_VALUE;
            said.or_else(|| initial.then(|| (START.to_owned(), None)))
        }
        // "The rod is released from rest."
        Statement::Does {
            verb: "start" | "release",
            slots,
            ..
        } => match slots.as_slice() {
            [(Slot::From, Term::Phrase(rest))] if rest.head == "rest" => {
                Some((START.to_owned(), None))
            }
            _ => None,
        },
        Statement::Does {
            verb: "hold",
            slots,
            ..
        } => slots.iter().find_map(|(s, t)| instant_of(*s, t)),
        _ => None,
    }
}

/// The instant that a slot names: "at `$t=0$`", "at the start", "at `$t_1$`", "at `$\theta = 0$`".
pub(super) fn instant_of(slot: Slot, term: &Term) -> Option<(String, Option<Term>)> {
    if slot != Slot::At {
        return None;
    }
    match term {
        Term::Formula(formula) => {
            let written: String = formula.source.split_whitespace().collect();
            let relation =
                (term.is_condition() && !is_time_relation(&written)).then(|| term.clone());
            let names = term.is_condition() || is_instant(formula);
            names.then_some((written, relation))
        }
        Term::Phrase(phrase) if phrase.head == START_OF_MOTION => Some((START.to_owned(), None)),
        Term::Phrase(phrase) if phrase.head == INSTANT => match phrase.slot(Slot::Which)? {
            Term::Name(words) => Some((words.clone(), None)),
            Term::Formula(formula) => Some((formula.source.clone(), None)),
            _ => None,
        },
        _ => None,
    }
}

/// "`$t=0$`", "`$t=t_1$`"
fn is_time_relation(written: &str) -> bool {
    written.starts_with("t=")
}

/// `t_0`, `t'`: a letter for an instant.
fn is_instant(formula: &Formula) -> bool {
    let symbol = node_of(formula).map(|node| &node.kind);
    matches!(symbol, Some(Kind::Symbol(s)) if s.name == "t" && (!s.subscripts.is_empty() || s.primes > 0))
}

/// The letters of which a statement tells values at an instant.
fn letters_then(statement: &Statement) -> Vec<Formula> {
    let formula = |term: &Term| match term {
        Term::Formula(formula) => Some(formula.clone()),
        _ => None,
    };
    let told: Vec<&Term> = match statement {
        Statement::Is { subjects, what } if what.head == "zero" => subjects.iter().collect(),
        Statement::Is { what, .. } if matches!(what.head, VALUE | INITIAL_VALUE) => {
            what.all(Slot::Of).collect()
        }
        Statement::Does {
            subjects,
            verb: "hold",
            ..
        } => subjects.iter().collect(),
        _ => vec![],
    };
    let first = |formula: Formula| match &formula.row {
        Row::Line(line) => line.sides.first().map(Formula::of),
        _ => Some(formula),
    };
    told.into_iter()
        .filter_map(formula)
        .filter_map(first)
        .collect::<Vec<_>>()
}

/// Whether a letter is written as a number is, and not as a vector.
fn is_number(letter: &Formula) -> bool {
    let symbol = node_of(letter).map(|node| &node.kind);
    matches!(symbol, Some(Kind::Symbol(s)) if !s.style.vector && !s.style.tensor && !s.style.hat)
        || matches!(symbol, Some(Kind::Call(..)))
}

/// What is said of a letter without telling what it is.
fn is_trait(what: &NounPhrase) -> bool {
    matches!(
        what.head,
        "constant" | "positive" | "zero" | "nonzero" | "small"
    )
}
