//! Decides each line of a document: true by an exact proof, false by numbers that anyone can put in, or open.
//!
//! A line is lowered to fractions of polynomials in the document's variables. The laws of `mechanics` and the
//! premises of the document form a triangular set; a line is proved when its difference, with all of them put in, is
//! the zero polynomial, and refuted by a small exact world where it is not.
//!
//! `letters` and `words` say what a document means, `values` what a formula is worth, `theory` what holds, `lines` what
//! becomes of each line, and `repair` what a false one should have been; `check` goes through them from top to bottom,
//! and `meanings` chooses between the readings that a document leaves open.

mod check;
mod letters;
mod lines;
mod meanings;
mod names;
mod reason;
mod repair;
mod spelling;
mod theory;
mod values;
mod verdict;
mod words;

pub use meanings::check;
pub use values::quantity::{Quantity, Shape};
pub use verdict::{
    Convention, Counterexample, Diagnosis, Finding, FromProse, Passed, Report, Role, Summary,
    Verdict,
};
