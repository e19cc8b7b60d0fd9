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

/// The polynomial without a variable that stands in it by its square alone, and what stands beside the square.
fn alone_in_square(of: &Polynomial, variable: Variable) -> Option<(Polynomial, Polynomial)> {
    let [rest, slope, square] = [0, 1, 2].map(|e| of.coefficient_of(variable, e));
    (of.degree_in(variable) == 2 && slope.is_zero()).then_some((rest, square))
}

/// The square of a variable that stands in an equation by its square alone.
pub(super) fn square_in(equation: &Polynomial, variable: Variable) -> Option<Fraction> {
    let (rest, square) = alone_in_square(equation, variable)?;
    Fraction::new(-rest, square)
}

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
            if atoms.atom(variable).square.is_some() || is_kernel(atoms, variable) {
                continue;
            }
            let Some((rest, square)) = alone_in_square(value, variable) else {
                continue;
            };
            let Some(number) = square.is_constant() else {
                continue;
            };
            let square = Fraction::from((-rest).scaled(&(Rational::one() / number)));
            self.tell_square(atoms, variable, square.clone(), square, equation, source);
            return true;
        }
        false
    }

    /// The square of a variable is a polynomial from now on, and a value in free variables.
    fn tell_square(
        &mut self,
        atoms: &Atoms,
        variable: Variable,
        square: Fraction,
        free: Fraction,
        equation: &Polynomial,
        source: &Source,
    ) {
        let rule = Rule {
            value: square,
            equation: equation.clone(),
            source: source.clone(),
            time: self.tick(),
            at_instant: self.at_instant,
        };
        self.squares.insert(variable, (free, rule));
        self.forget_images_with(atoms, variable);
    }

    /// An equation that tells the square of a length: as it is written, where in free variables it is a fraction.
    pub(super) fn put_square_of_length(
        &mut self,
        atoms: &Atoms,
        value: &Polynomial,
        equation: &Polynomial,
        source: &Source,
    ) -> bool {
        let told = equation.variables().into_iter().find_map(|length| {
            let whole = square_in(equation, length).filter(Fraction::is_polynomial)?;
            let free = square_in(value, length).filter(|_| atoms.is_length(length))?;
            Some((length, whole, free))
        });
        let Some((length, whole, free)) = told else {
            return false;
        };
        self.tell_square(atoms, length, whole, free, equation, source);
        true
    }

    /// Takes out the relations for squares that hold a variable that is solved for now: they are to be put in anew.
    pub(super) fn squares_with(&mut self, variable: Variable) -> Vec<Rule> {
        let held = |(of, (free, rule)): (&Variable, &(Fraction, Rule))| {
            let told = [free, &rule.value];
            let in_it = told.iter().any(|q| q.variables().contains(&variable));
            (in_it || *of == variable).then_some(*of)
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
            let told = self.square(v).map(|rule| rule.value.numerator());
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
