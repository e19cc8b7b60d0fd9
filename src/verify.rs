//! Decides each line of a document: true by an exact proof, false by numbers that anyone can put in, or open.
//!
//! A line is lowered to fractions of polynomials in the document's variables. The laws of `mechanics` and the
//! premises of the document form a triangular set; a line is proved when its difference, with all of them put in, is
//! the zero polynomial, and refuted by a small exact world where it is not.
//!
//! There are two houses. A document whose meaning is declared is judged in the new one ([`check_declared()`]), where each
//! room sees those left of it alone:
//!
//! ```text
//! model ← term ← facts ← reading ← standing ← derivation        language (sentences ⇄ statements) ─→ reading
//! ```
//!
//! `model` holds frames, points, bodies and families with their laws, `term` makes values of formulas, `facts` says
//! what holds and proves, `reading` builds the model from the sentences of `language`, and `standing` says what each line
//! is worth, and `derivation` tells the derivation of a declared system. All other documents are judged in the old house ([`check()`]): there `letters` and `words` say what a document
//! means, `values` what a formula is worth, `theory` what holds, `lines` what becomes of each line, and `repair` what a
//! false one should have been.
//!
#![doc = include_str!("verify/guide.md")]

mod check;
pub(crate) mod correction;
mod declarations;
mod declared;
pub mod derivation;
pub(crate) mod facts;
pub mod language;
mod letters;
mod lines;
mod meanings;
pub(crate) mod model;
mod names;
pub(crate) mod reading;
mod reason;
mod repair;
mod spelling;
pub(crate) mod standing;
pub(crate) mod term;
mod theory;
mod values;
mod verdict;
mod words;

pub use declarations::{Declared, Misunderstood, Sheet, declarations};
pub(crate) use declared::Shared;
pub use declared::{check_declared, judge_declared};
pub use language::wants::Wants;
pub use meanings::check;
pub(crate) use standing::apart::{Apart, Said, Withheld, WorkedOut};
pub(crate) use standing::memory::Wording;
pub(crate) use standing::written::written_symbols;
pub(crate) use term::written::Written;
pub use values::quantity::{Quantity, Shape};
pub use verdict::{
    Answer, Convention, Counterexample, Diagnosis, Finding, FromProse, Meant, Passed, Question,
    Report, Role, Summary, Unused, Verdict,
};
