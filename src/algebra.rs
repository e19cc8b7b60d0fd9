//! Exact algebra: polynomials over ℚ in packed monomials, fractions of them, and proofs by multiplying out.
//!
//! A polynomial is a scalar like any other: run an equation of `mechanics` on it and the result is its normal form.

mod certificate;
mod fraction;
mod monomial;
mod polynomial;
mod print;
mod rational;

pub use certificate::Certificate;
pub use fraction::Fraction;
pub use monomial::{Monomial, Variable};
pub use polynomial::Polynomial;
pub use print::{Letter, Place, Printer, Style};
pub use rational::Rational;
