//! Decides each line of a document: true by an exact proof, false by numbers that anyone can put in, or open.
//!
//! A line is lowered to fractions of polynomials in the document's variables. The laws of `mechanics` and the
//! premises of the document form a triangular set; a line is proved when its difference, with all of them put in, is
//! the zero polynomial, and refuted by a small exact world where it is not.

mod accept;
mod atoms;
mod attitude_law;
mod attitude_layouts;
mod attitude_matrix;
mod attitude_reading;
mod attitude_words;
mod call;
mod carried;
mod certify;
mod check;
mod claim;
mod constants_in_words;
mod convention;
mod convention_slips;
mod custom;
mod data;
mod decide;
mod decimals;
mod define;
mod digits;
mod doubt;
mod edit;
mod entities;
mod euler_rates;
mod figures;
mod forward;
mod frame;
mod given;
mod hamilton;
mod hollow;
mod index;
mod inequality;
mod integral;
mod kept;
mod kernel;
mod kernel_facts;
mod law;
mod ledger;
mod line;
mod lost_terms;
mod lost_vectors;
mod lower;
mod matrix;
mod moments_in_words;
mod more_moments;
mod names;
mod naming;
mod news;
mod numbers;
mod operators;
mod phrases;
mod places;
mod point;
mod premise;
mod primes;
mod prose;
mod quantity;
mod rate;
mod reading;
mod reason;
mod repair;
mod rivals;
mod role;
mod roles_by_law;
mod sequences;
mod shown;
mod sightings;
mod skew_marks;
mod slips;
mod small;
mod solve;
mod spatial;
mod spelling;
mod subscript;
mod symbol;
mod terms;
mod theory;
mod triad;
mod turned_axes;
mod units;
mod usage;
mod value;
mod variety;
mod verdict;
mod vocabulary;
mod wanted;
mod wholes;
mod world;
mod written_out;

pub use check::check;
pub use quantity::{Quantity, Shape};
pub use verdict::{
    Convention, Counterexample, Diagnosis, Finding, FromProse, Passed, Report, Role, Summary,
    Verdict,
};
