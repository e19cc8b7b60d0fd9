//! Facts about functions that no polynomial is: their squares, and one function at equal arguments.

use crate::algebra::{
    Combination, Fraction, Kernel, Polynomial, Rational, Reason, Variable, difference,
};
use crate::notation::ast::Function;
use crate::verify::theory::Theory;
use crate::verify::theory::attitude_law::{UNIT, square_of_scalar_part};
use crate::verify::theory::certify::Elimination;
use crate::verify::theory::ledger::{Relation, ratio};
use crate::verify::values::atoms::{Atom, variable_fraction};
use crate::verify::values::figures::is_pi;
use num_traits::{One, Zero};
use std::ops::{Add, Mul, Neg, Sub};

/// Products of terms for which the powers of a kernel are still put in.
const MOST_PRODUCTS: usize = 20_000;

impl Theory {
    /// Puts the relations of kernels in: s² = 1 − c², r² = x.
    pub(crate) fn kernels_reduced(&mut self, fraction: Fraction) -> Fraction {
        let mut value = fraction;
        for variable in value.numerator().variables() {
            let Some(square) = self.kernel_square(variable) else {
                continue;
            };
            let degree = value.numerator().degree_in(variable);
            if degree < 2 {
                continue;
            }
            let growth = square.numerator().len().max(square.denominator().len());
            let products = growth.saturating_pow(degree / 2);
            if value.numerator().len().saturating_mul(products) > MOST_PRODUCTS {
                self.exhausted = true;
                return value;
            }
            let (mut sum, mut power) = (Fraction::zero(), Fraction::one());
            for half in 0..=degree / 2 {
                if half > 0 {
                    power *= square.clone();
                }
                let even = Fraction::from(value.numerator().coefficient_of(variable, 2 * half));
                let odd = Fraction::from(value.numerator().coefficient_of(variable, 2 * half + 1));
                sum += (even + odd * variable_fraction(variable)) * power.clone();
            }
            value = sum / Fraction::from(value.denominator().clone());
        }
        value
    }

    /// The square of a kernel in terms of others.
    pub(crate) fn kernel_square(&mut self, variable: Variable) -> Option<Fraction> {
        if !self.left_out.contains(UNIT)
            && let Some(square) = square_of_scalar_part(&mut self.atoms, variable)
        {
            return Some(square);
        }
        let Atom::Kernel { function, argument } = self.atoms.atom(variable).clone() else {
            return None;
        };
        match function {
            Function::Sin => {
                let cos = self.kernel(Function::Cos, argument);
                Some(Fraction::one() - cos.clone() * cos)
            }
            Function::Sqrt => Some(argument),
            _ => None,
        }
    }

    /// The variable of a kernel as a fraction.
    pub(crate) fn kernel(&mut self, function: Function, argument: Fraction) -> Fraction {
        match function {
            Function::Sin if argument.is_zero() => return Fraction::zero(),
            Function::Cos if argument.is_zero() => return Fraction::one(),
            _ => {}
        }
        variable_fraction(self.atoms.special(Atom::Kernel { function, argument }))
    }

    /// A kernel with every rule put into its argument; `None` where that leaves it as it is.
    pub(crate) fn reduced_kernel(
        &mut self,
        variable: Variable,
        function: Function,
        argument: &Fraction,
    ) -> Option<Fraction> {
        let own = variable_fraction(variable);
        if let Some(known) = self.solution.normals.get(variable) {
            return Some(known.clone()).filter(|known| *known != own);
        }
        let reduced = self.normal(argument);
        if reduced == *argument {
            return None;
        }
        let value = self.kernel_value(function, reduced);
        if !self.exhausted {
            self.solution.normals.insert(variable, value.clone());
        }
        Some(value)
    }

    /// A kernel, or its value at an angle where that is known.
    fn kernel_value(&mut self, function: Function, argument: Fraction) -> Fraction {
        match (function, self.known_angle(&argument)) {
            (Function::Sin, Some((sine, _))) => sine,
            (Function::Cos, Some((_, cosine))) => cosine,
            _ => self.kernel(function, argument),
        }
    }

    /// A function of an argument that has a simpler form: the same function of that.
    pub(crate) fn congruence(&mut self, variable: Variable) -> Option<usize> {
        let Atom::Kernel { function, argument } = self.atoms.atom(variable).clone() else {
            return None;
        };
        let reduced = self.normal(&argument);
        if reduced == argument || !reduced.is_valid() {
            return None;
        }
        let same = Atom::Kernel {
            function,
            argument: reduced.clone(),
        };
        let other_variable = self.atoms.special(same);
        let other = variable_fraction(other_variable);
        let equal = difference(&ratio(&argument), &ratio(&reduced));
        let done = Elimination::of(self, equal.clone())?;
        if !done.rest.is_zero() {
            return None;
        }
        let by = self
            .solution
            .ledger
            .push(equal, Reason::Combination(done.combination()));
        self.note_kernels(&variable_fraction(variable));
        self.note_kernels(&other);
        let value = Polynomial::variable(variable) - Polynomial::variable(other_variable);
        let reason = Reason::Congruence {
            one: variable,
            other: other_variable,
            by,
        };
        let equal = self.solution.ledger.push(value, reason);
        let known = match (function, self.known_angle(&reduced)) {
            (Function::Sin, Some((sine, _))) => sine,
            (Function::Cos, Some((_, cosine))) => cosine,
            (Function::Sin, None) if reduced.is_zero() => Fraction::zero(),
            (Function::Cos, None) if reduced.is_zero() => Fraction::one(),
            _ => return Some(equal),
        };
        self.note_kernels(&known);
        let (value, scale) = (
            known.numerator().clone(),
            known.denominator().is_constant()?,
        );
        let value = value * Polynomial::constant(Rational::from(1) / scale);
        Some(self.value_at_angle(variable, other_variable, value, equal))
    }

    /// A sine or a cosine of an angle at which its value is known.
    fn value_at_angle(
        &mut self,
        variable: Variable,
        at_angle: Variable,
        value: Polynomial,
        equal: usize,
    ) -> usize {
        let known = Polynomial::variable(at_angle) - value.clone();
        let name = "the sine or cosine of a known angle".to_owned();
        let known = self.solution.ledger.push(known, Reason::Premise(name));
        let combination = Combination {
            multiplier: Polynomial::one(),
            cofactors: vec![(equal, Polynomial::one()), (known, Polynomial::one())],
        };
        let value = Polynomial::variable(variable) - value;
        self.solution
            .ledger
            .push(value, Reason::Combination(combination))
    }

    /// The relation of the square of a sine or a root: d·v² − n.
    pub(crate) fn square_relation(&mut self, variable: Variable) -> Option<Relation> {
        let square = self.kernel_square(variable)?;
        self.note_kernels(&variable_fraction(variable));
        self.note_kernels(&square);
        let fact = match self.solution.ledger.squares.get(&variable) {
            Some(&fact) => fact,
            None => {
                let root = Polynomial::variable(variable);
                let value =
                    square.denominator().clone() * root.clone() * root - square.numerator().clone();
                let reason = self.reason_of_square(variable)?;
                let fact = self.solution.ledger.push(value, reason);
                self.solution.ledger.squares.insert(variable, fact);
                fact
            }
        };
        Some(Relation {
            numerator: square.numerator().clone(),
            denominator: square.denominator().clone(),
            fact,
            height: 0,
        })
    }

    fn reason_of_square(&mut self, variable: Variable) -> Option<Reason> {
        let Atom::Kernel { function, argument } = self.atoms.atom(variable).clone() else {
            return Some(Reason::Premise(UNIT.to_owned()));
        };
        Some(match function {
            Function::Sin => Reason::Circle {
                sine: variable,
                cosine: self.kernel(Function::Cos, argument).as_variable()?,
            },
            _ => Reason::Root(variable),
        })
    }

    /// Declares the kernels of a fraction, and those of their arguments.
    pub(crate) fn note_kernels(&mut self, fraction: &Fraction) {
        for variable in fraction.variables() {
            if self.solution.ledger.kernels.contains_key(&variable) {
                continue;
            }
            if is_pi(&self.atoms, variable) {
                let kernel = Kernel {
                    function: "pi",
                    argument: ratio(&Fraction::zero()),
                };
                self.solution.ledger.kernels.insert(variable, kernel);
            }
            if let Atom::Kernel { function, argument } = self.atoms.atom(variable).clone() {
                self.solution.ledger.divide_by(argument.denominator());
                let kernel = Kernel {
                    function: crate::verify::names::function(function),
                    argument: ratio(&argument),
                };
                self.solution.ledger.kernels.insert(variable, kernel);
                self.note_kernels(&argument);
            }
        }
    }
}

/// Sine and cosine of an angle and so many times another, by the addition theorem.
pub(crate) fn turned<T>(total: (T, T), one: &(T, T), turns: i64) -> (T, T)
where
    T: Clone + Add<Output = T> + Sub<Output = T> + Mul<Output = T> + Neg<Output = T>,
{
    let sin = if turns < 0 {
        -one.0.clone()
    } else {
        one.0.clone()
    };
    (0..turns.unsigned_abs()).fold(total, |(s, c), _| {
        (
            s.clone() * one.1.clone() + c.clone() * sin.clone(),
            c * one.1.clone() - s * sin.clone(),
        )
    })
}
