//! Exact algebra: polynomials over ℚ in packed monomials, fractions of them, and proofs by multiplying out.
//!
//! A polynomial is a scalar like any other: run an equation of `mechanics` on it and the result is its normal form.

mod bound;
mod certificate;
mod combination;
mod composition;
mod divide;
mod fraction;
mod groebner;
mod interval;
mod linear;
mod monomial;
mod polynomial;
mod print;
mod proof;
mod rational;
mod reduce;
mod substitute;
mod work;

pub use bound::{Bound, enclosure};
pub use certificate::Certificate;
pub use combination::Budget;
pub use composition::{TooLarge, compose, compose_by};
pub use fraction::Fraction;
pub use interval::Interval;
pub use linear::{LinearError, LinearSolution, solve_linear};
pub use monomial::{Monomial, Variable};
pub use polynomial::Polynomial;
pub use print::{Letter, Place, Printer, Style};
pub use proof::{
    Argument, Combination, Fact, Fault, Goal, Kernel, Proof, Ratio, Reason, difference, rate,
};
pub use rational::Rational;
pub use reduce::{Reduction, reduce, reduce_where};
pub use substitute::PseudoDivision;
pub use work::products_of_terms;
