//! Values under a root: one of them is chosen so that the root is rational.

use crate::algebra::{Fraction, Polynomial, Variable};
use crate::notation::ast::Function;
use crate::verify::theory::attitude_law::number_of_quaternion;
use crate::verify::theory::world::{Kind, Substance, World};
use crate::verify::values::atoms::Atom;

/// Terms of N D: the square of a length, or of a frequency, has no more.
const MOST_TERMS: usize = 40;

impl<T: Substance> World<'_, T> {
    /// Gives the roots that some fractions lead to their values before anything else is drawn; where relations are kept,
    /// these choose the values.
    pub(crate) fn draw_roots<'f>(&mut self, fractions: impl Iterator<Item = &'f Fraction>) {
        if !self.theory.solution.relations.kept.is_empty() {
            return;
        }
        for variable in self.theory.reached_variables(fractions) {
            let atom = self.theory.atoms.atom(variable).clone();
            if let Atom::Kernel {
                function: Function::Sqrt,
                argument,
            } = atom
            {
                self.make_square(&argument);
            }
        }
    }

    /// Chooses a free variable of N/D such that N D is a square: of `c v + r` it is `v = (t² - r)/c`, and of `s² v² + r`
    /// it is `v = (r/k - k)/(2s)`, as `r + ((r/k - k)/2)² = ((r/k + k)/2)²`.
    fn make_square(&mut self, argument: &Fraction) -> Option<()> {
        if argument.numerator().len() * argument.denominator().len() > MOST_TERMS {
            return None;
        }
        let product = argument.numerator().clone() * argument.denominator().clone();
        let choice = product
            .variables()
            .into_iter()
            .find(|&v| self.is_open(v) && is_pure(&product, v))?;
        let degree = product.degree_in(choice);
        let factor = self.polynomial(&product.coefficient_of(choice, degree))?;
        let rest = self.polynomial(&product.coefficient_of(choice, 0))?;
        // A rule between them may have drawn it meanwhile.
        if self.is_known(choice) || factor.is_zero() {
            return None;
        }
        let drawn = T::draw(Kind::Positive, self.chance());
        let value = if degree == 1 {
            (drawn.clone() * drawn - rest) / factor
        } else {
            let root = factor.root().filter(|root| !root.is_zero())?;
            (rest / drawn.clone() - drawn) / (root.clone() + root)
        };
        let value = match degree == 2 && value.is_negative() {
            true => -value,
            false => value,
        };
        let positive = self.kind(choice) == Kind::Positive;
        if !positive || !(value.is_negative() || value.is_zero()) {
            self.keep(choice, value);
        }
        Some(())
    }

    /// Whether nothing rules a symbol and no value was drawn for it.
    fn is_open(&mut self, variable: Variable) -> bool {
        let part = matches!(self.theory.atoms.atom(variable), Atom::Part { .. });
        part && !self.is_known(variable)
            && number_of_quaternion(&self.theory.atoms, variable).is_none()
            && self.theory.rule(variable).is_none()
    }
}

/// Whether a polynomial is `c v + r` or `c v² + r`.
fn is_pure(polynomial: &Polynomial, variable: Variable) -> bool {
    match polynomial.degree_in(variable) {
        1 => true,
        2 => polynomial.coefficient_of(variable, 1).terms().is_empty(),
        _ => false,
    }
}
