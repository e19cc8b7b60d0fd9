//! What holds at a place of the document: laws, premises and accepted lines, each solved for one variable.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::candidates::best;
use crate::verify::facts::cases::Missing;
use crate::verify::facts::images::Image;
use crate::verify::facts::parts::Part;
use crate::verify::model::atoms::Atoms;
use foldhash::HashMap;
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};

/// Products of more terms than this are not worked out.
pub(super) const MOST_TERMS: usize = 6_000;

/// More premises, with their rates, are not put in.
const MOST_PREMISES: usize = 400;

/// How much is worked out to put in the premises of one place: terms times the terms that are put in for letters.
const MOST_WORK: usize = 2_000_000;

/// So many rates of a premise are put in.
const MOST_RATES: u8 = 2;

/// Rates of premises of more terms than this are not put in.
const MOST_OF_RATE: usize = 400;

/// The answer "this grew beyond what is worked out".
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct OutOfBudget;

/// What a premise says of one variable.
#[derive(Clone, Debug)]
pub(crate) struct Rule {
    /// Its value.
    pub(crate) value: Fraction,
    /// The equation as it was put in: this vanishes.
    pub(crate) equation: Polynomial,
    /// Who says so.
    pub(crate) source: Source,
    /// How many rules there were before it: it is solved by those alone.
    pub(crate) time: usize,
    /// Whether it holds at one instant, so that it has no rate.
    pub(super) at_instant: bool,
}

/// What became of an equation that was put in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Extended {
    /// It holds already.
    Follows,
    /// It tells what a variable is.
    Solved(Variable),
    /// It tells the square of a variable.
    Square,
    /// Nothing can satisfy it together with what holds.
    Contradicts,
    /// It could not be solved for one variable; it is kept out.
    Unsolved,
}

impl Extended {
    /// Whether the rate of the equation may tell more than the rate of what was solved for does.
    fn has_new_rate(self, atoms: &mut Atoms) -> bool {
        let Self::Solved(mut variable) = self else {
            return self == Self::Square;
        };
        for _ in 0..2 {
            match atoms.rate(variable).as_variable() {
                Some(rate) if atoms.atom(rate).law.is_none() => variable = rate,
                _ => return true,
            }
        }
        false
    }
}

/// What holds. Laws stand with the variables; premises are here.
#[derive(Clone, Debug, Default)]
pub(crate) struct Facts {
    pub(super) rules: BTreeMap<Variable, Rule>,
    /// Squares that premises tell: n_z² = 1 − n_x² − n_y², each in free variables and as it is told.
    pub(super) squares: BTreeMap<Variable, (Fraction, Rule)>,
    pub(super) images: HashMap<Variable, Image>,
    /// Parts of the premises, where they were asked for since the last one was put in.
    parts: Vec<Part>,
    /// The premises that goals need, where all of them grew too large.
    needed: Vec<Part>,
    /// How many rules were put in so far.
    time: usize,
    /// How much was worked out so far to put in premises.
    pub(super) work: usize,
    /// Premises that could not be put in: while there are any, what fails by the others may hold.
    pub(super) missing: Missing,
    /// Whether some goal was beyond what is worked out with all of them.
    pub(crate) are_too_many: bool,
    /// Whether laws of mechanics say nothing here, but definitions and mathematics alone.
    pub(super) lawless: bool,
    /// Letters whose laws were turned round: these tell other variables.
    pub(super) turned: BTreeSet<Variable>,
    /// Whether what is put in now holds at one instant alone.
    pub(super) at_instant: bool,
}

impl Facts {
    /// Facts to which no law of mechanics adds anything.
    pub(crate) fn lawless() -> Self {
        Self {
            lawless: true,
            ..Self::default()
        }
    }

    /// The rule for a variable, if a premise has solved for it.
    pub(crate) fn rule(&self, variable: Variable) -> Option<&Rule> {
        self.rules.get(&variable)
    }

    /// The relation for the square of a variable that a premise tells.
    pub(crate) fn square(&self, variable: Variable) -> Option<&Rule> {
        self.squares.get(&variable).map(|(_, rule)| rule)
    }

    /// Whether no premise tells the square of a variable alone.
    pub(crate) fn has_no_squares(&self) -> bool {
        self.squares.is_empty()
    }

    /// The square of a variable in free variables, where a premise tells it.
    pub(crate) fn free_square(&self, variable: Variable) -> Option<&Fraction> {
        self.squares.get(&variable).map(|(free, _)| free)
    }

    /// Puts in an equation: this fraction vanishes, always.
    pub(crate) fn extend(
        &mut self,
        atoms: &mut Atoms,
        equation: &Fraction,
        source: &Source,
    ) -> Result<Extended, OutOfBudget> {
        let first = self.put(atoms, equation, source)?;
        let mut rate = self.new_rate(atoms, first, equation, source);
        for _ in 0..2 {
            let Some(equation) = rate.take() else { break };
            let put = self.put(atoms, &equation, source)?;
            match put {
                Extended::Contradicts => return Ok(Extended::Contradicts),
                Extended::Unsolved => self.leave(&equation, source),
                _ => rate = self.new_rate(atoms, put, &equation, source),
            }
        }
        Ok(first)
    }

    /// Puts in many equations with their rates, those first that say plainly what one variable is.
    pub(crate) fn extend_all(&mut self, atoms: &mut Atoms, equations: Vec<(Fraction, Source)>) {
        let mut waiting: Vec<(Fraction, Source, u8)> = equations
            .into_iter()
            .map(|(equation, source)| (equation, source, 0))
            .collect();
        let (mut steps, end) = (0, self.work.saturating_add(MOST_WORK));
        while !waiting.is_empty() && steps < MOST_PREMISES {
            let before = steps;
            let mut left = vec![];
            for (equation, source, order) in std::mem::take(&mut waiting) {
                let normal = self.normal(atoms, &equation);
                let Some(normal) = normal.ok().filter(|_| self.work <= end) else {
                    self.miss(&source);
                    continue;
                };
                let value = normal.numerator();
                if value.is_zero() {
                    continue;
                }
                match best(atoms, value, true) {
                    Some(_) => {
                        steps += 1;
                        self.put_with_rate(atoms, equation, source, order, &mut left);
                    }
                    None => left.push((equation, source, order)),
                }
            }
            waiting = left;
            if steps == before && !waiting.is_empty() {
                // None is plain: the shortest goes first.
                steps += 1;
                let size = |(e, _, order): &(Fraction, Source, u8)| (*order, e.numerator().len());
                let at = (0..waiting.len())
                    .min_by_key(|&i| size(&waiting[i]))
                    .unwrap_or(0);
                let (equation, source, order) = waiting.remove(at);
                self.put_with_rate(atoms, equation, source, order, &mut waiting);
            }
        }
        if let Some((_, source, _)) = waiting.first() {
            self.miss(source);
        }
    }

    /// Puts in an equation, and lets its rate wait.
    fn put_with_rate(
        &mut self,
        atoms: &mut Atoms,
        equation: Fraction,
        source: Source,
        order: u8,
        waiting: &mut Vec<(Fraction, Source, u8)>,
    ) {
        match self.put(atoms, &equation, &source) {
            Ok(Extended::Unsolved) => self.leave(&equation, &source),
            Ok(Extended::Contradicts) | Err(OutOfBudget) => self.miss(&source),
            Ok(put) if order < MOST_RATES => {
                if let Some(rate) = self.new_rate(atoms, put, &equation, &source) {
                    waiting.push((rate, source, order + 1));
                }
            }
            Ok(_) => {}
        }
    }

    /// The rate of an equation that was put in, where it may tell something new; one that is too long is missed.
    fn new_rate(
        &mut self,
        atoms: &mut Atoms,
        put: Extended,
        equation: &Fraction,
        source: &Source,
    ) -> Option<Fraction> {
        if !put.has_new_rate(atoms) {
            return None;
        }
        let rate = atoms.derivative(equation);
        if rate.numerator().len() > MOST_OF_RATE {
            self.miss(source);
            return None;
        }
        (!rate.is_zero()).then_some(rate)
    }

    /// Puts in an equation that holds at one instant: nothing is told of its rate. No more may be put in for all times.
    pub(crate) fn put_at_instant(
        &mut self,
        atoms: &mut Atoms,
        equation: &Fraction,
        source: &Source,
    ) {
        self.at_instant = true;
        let (equation, source) = (equation.clone(), source.clone());
        self.put_with_rate(atoms, equation, source, MOST_RATES, &mut vec![]);
    }

    /// Puts in an equation without its rates.
    pub(crate) fn put(
        &mut self,
        atoms: &mut Atoms,
        equation: &Fraction,
        source: &Source,
    ) -> Result<Extended, OutOfBudget> {
        self.parts.clear();
        self.needed.clear();
        let normal = self.normal(atoms, equation)?;
        let value = normal.numerator().clone();
        if value.is_zero() {
            return Ok(Extended::Follows);
        }
        if value.is_constant().is_some() {
            return Ok(Extended::Contradicts);
        }
        let written = equation.numerator().clone();
        let alone = best(atoms, &value, true);
        if alone.is_none()
            && let Some((length, root)) =
                Self::length_in(atoms, &value).or_else(|| Self::length_in(atoms, &written))
            && let Ok(root) = self.normal(atoms, &root)
        {
            self.tell(atoms, length, root, written, source);
            return self.put_again(atoms, length);
        }
        if alone.is_none()
            && (self.put_square(atoms, &value, &written, source)
                || self.put_square_of_length(atoms, &value, &written, source))
        {
            return Ok(Extended::Square);
        }
        let Some((variable, slope, rest)) = alone.or_else(|| best(atoms, &value, false)) else {
            return Ok(Extended::Unsolved);
        };
        let solved = Fraction::new(-rest, slope.clone()).ok_or(OutOfBudget)?;
        self.tell(atoms, variable, solved, written, source);
        self.tell_sines(atoms, variable, source);
        if let Some(square) = atoms.atom(variable).square.clone() {
            let v = Polynomial::variable(variable);
            let relation = Fraction::from(v.clone() * v - square);
            if self.put(atoms, &relation, source)? == Extended::Contradicts {
                return Ok(Extended::Contradicts);
            }
        }
        self.put_again(atoms, variable)
    }

    /// Puts in anew what told of a variable and its rates before it was solved for.
    fn put_again(
        &mut self,
        atoms: &mut Atoms,
        variable: Variable,
    ) -> Result<Extended, OutOfBudget> {
        let mut again = self.squares_with(variable);
        if !self.at_instant {
            again.extend(self.rates_of(atoms, variable));
        }
        for rule in again {
            let equation = Fraction::from(rule.equation);
            match self.put(atoms, &equation, &rule.source)? {
                Extended::Contradicts => return Ok(Extended::Contradicts),
                Extended::Unsolved => self.leave(&equation, &rule.source),
                _ => {}
            }
        }
        Ok(Extended::Solved(variable))
    }

    /// A rule tells a variable from now on.
    pub(super) fn tell(
        &mut self,
        atoms: &Atoms,
        variable: Variable,
        value: Fraction,
        equation: Polynomial,
        source: &Source,
    ) {
        let rule = Rule {
            value,
            equation,
            source: source.clone(),
            time: self.tick(),
            at_instant: self.at_instant,
        };
        self.rules.insert(variable, rule);
        self.forget_images_with(atoms, variable);
    }

    /// Puts in an equation that is solved for this variable.
    pub(super) fn put_solved(
        &mut self,
        atoms: &mut Atoms,
        equation: &Fraction,
        variable: Variable,
        source: &Source,
    ) -> Option<()> {
        let normal = self.normal(atoms, equation).ok()?;
        let value = normal.numerator();
        let slope = value.coefficient_of(variable, 1);
        let solved = Fraction::new(-value.coefficient_of(variable, 0), slope)?;
        self.tell(
            atoms,
            variable,
            solved,
            equation.numerator().clone(),
            source,
        );
        Some(())
    }

    /// The premises that goals needed so far.
    pub(crate) fn needed_mut(&mut self) -> &mut Vec<Part> {
        &mut self.needed
    }

    /// The parts of the premises that were asked for.
    pub(crate) fn parts_mut(&mut self) -> &mut Vec<Part> {
        &mut self.parts
    }

    pub(super) fn tick(&mut self) -> usize {
        self.time += 1;
        self.time
    }

    /// When what is told of a variable was put in: 0 for a law, `None` where nothing is told.
    pub(crate) fn told_at(&self, atoms: &Atoms, variable: Variable) -> Option<usize> {
        if let Some(rule) = self.rules.get(&variable) {
            return Some(rule.time);
        }
        if atoms.atom(variable).law.is_some() && !self.turned.contains(&variable) {
            return Some(0);
        }
        let of = atoms.atom(variable).rate_of?;
        self.rates_are_told(of).then(|| self.told_at(atoms, of))?
    }

    /// Whether what is told of a variable tells its rate as well.
    pub(super) fn rates_are_told(&self, of: Variable) -> bool {
        self.rules.get(&of).is_none_or(|rule| !rule.at_instant)
    }
}

/// How many terms a fraction has.
pub(super) fn size(of: &Fraction) -> usize {
    of.numerator().len() + of.denominator().len()
}
