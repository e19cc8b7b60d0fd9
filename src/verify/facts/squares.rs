//! Relations for squares, and what a newly solved variable does to them and to its rates.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::verify::facts::Source;
use crate::verify::facts::images::Image;
use crate::verify::facts::premises::{Facts, MOST_TERMS, OutOfBudget, Rule};
use crate::verify::model::atoms::{Atoms, Nature};
use crate::verify::model::powers::with_one_square;
use num_traits::{One, Zero};

/// No rule tells a higher rate.
const MOST_RATES: usize = 6;

impl Facts {
    /// Takes out the rules for the rates of a variable that is solved for now: they are to be put in anew.
    pub(super) fn rates_of(&mut self, atoms: &Atoms, variable: Variable) -> Vec<Rule> {
        let rates = std::iter::successors(atoms.known_rate(variable), |&v| atoms.known_rate(v));
        let rules = rates
            .take(MOST_RATES)
            .filter_map(|rate| self.rules.remove(&rate));
        let rules: Vec<Rule> = rules.collect();
        if !rules.is_empty() {
            self.images.clear();
        }
        rules
    }

    /// Forgets the values that hold a variable, of which something new is told, or one of its rates.
    pub(super) fn forget_images_with(&mut self, atoms: &Atoms, variable: Variable) {
        let is_new = |mut of: Variable| loop {
            if of == variable {
                return true;
            }
            match atoms.atom(of).rate_of {
                Some(base) => of = base,
                None => return false,
            }
        };
        self.images.retain(|&of, image| match image {
            Image::Free => !is_new(of),
            Image::Known(value) => !is_new(of) && !value.variables().into_iter().any(is_new),
            Image::TooLarge => false,
        });
    }

    /// An equation that tells the square of a variable: n·n = 1.
    pub(super) fn put_square(
        &mut self,
        atoms: &Atoms,
        value: &Polynomial,
        equation: &Polynomial,
        source: &Source,
    ) -> bool {
        let mut variables = value.variables();
        variables.sort_by_key(|&v| (atoms.atom(v).key.order, v));
        for variable in variables.into_iter().rev() {
            let [lower, slope, square] = [0, 1, 2].map(|e| value.coefficient_of(variable, e));
            let told = atoms.atom(variable).square.is_some() || is_kernel(atoms, variable);
            if value.degree_in(variable) != 2 || !slope.is_zero() || told {
                continue;
            }
            let Some(number) = square.is_constant() else {
                continue;
            };
            let told = (-lower).scaled(&(Rational::one() / number));
            let value = Fraction::from(told.clone());
            let (equation, source) = (equation.clone(), source.clone());
            let rule = Rule {
                value,
                equation,
                source,
                time: self.tick(),
                at_instant: self.at_instant,
            };
            self.squares.insert(variable, (told, rule));
            self.forget_images_with(atoms, variable);
            return true;
        }
        false
    }

    /// Takes out the relations for squares that hold a variable that is solved for now: they are to be put in anew.
    pub(super) fn squares_with(&mut self, variable: Variable) -> Vec<Rule> {
        let held = |(of, (square, _)): (&Variable, &(Polynomial, Rule))| {
            (square.degree_in(variable) > 0 || *of == variable).then_some(*of)
        };
        let affected: Vec<Variable> = self.squares.iter().filter_map(held).collect();
        let removed = affected.iter().filter_map(|of| self.squares.remove(of));
        removed.map(|(_, rule)| rule).collect()
    }

    /// The polynomial with known squares put in, where it has any.
    pub(super) fn without_squares(
        &self,
        atoms: &Atoms,
        of: &Polynomial,
    ) -> Result<Option<Polynomial>, OutOfBudget> {
        let square_of = |v: Variable| {
            let told = self.squares.get(&v).map(|(square, _)| square);
            told.or(atoms.atom(v).square.as_ref())
        };
        let mut value = None;
        for _ in 0..32 {
            let Some(next) = with_one_square(value.as_ref().unwrap_or(of), square_of) else {
                return Ok(value);
            };
            if next.len() > MOST_TERMS {
                break;
            }
            value = Some(next);
        }
        Err(OutOfBudget)
    }

    /// The fraction with known squares put in; `None` where it has none.
    pub(super) fn without_known_squares(
        &self,
        atoms: &Atoms,
        value: &Fraction,
    ) -> Result<Option<Fraction>, OutOfBudget> {
        let top = self.without_squares(atoms, value.numerator())?;
        let bottom = match value.is_polynomial() {
            true => None,
            false => self.without_squares(atoms, value.denominator())?,
        };
        if top.is_none() && bottom.is_none() {
            return Ok(None);
        }
        let top = top.unwrap_or_else(|| value.numerator().clone());
        let bottom = bottom.unwrap_or_else(|| value.denominator().clone());
        Fraction::new(top, bottom).ok_or(OutOfBudget).map(Some)
    }
}

/// Whether a variable is a function of others: the sine of an angle, a root.
pub(super) fn is_kernel(atoms: &Atoms, variable: Variable) -> bool {
    matches!(
        atoms.atom(variable).nature,
        Nature::Sine(_) | Nature::Cosine(_) | Nature::Root(_)
    )
}
