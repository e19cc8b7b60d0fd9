//! From the tree of a formula to what it is worth: a grid of fractions in the document's variables.

pub(super) mod about_point;
pub(super) mod atoms;
pub(super) mod call;
mod coordinates;
pub(super) mod figures;
pub(super) mod greatest;
pub(super) mod hamilton;
pub(super) mod integral;
pub(super) mod kernel;
pub(super) mod lower;
pub(super) mod matrix;
pub(super) mod operators;
pub(super) mod own_symbol;
pub(super) mod partial;
pub(super) mod quantity;
pub(super) mod rate;
pub(super) mod spatial;
pub(super) mod subscript;
pub(super) mod symbol;
pub(super) mod time_integral;
pub(super) mod turned_axes;
pub(super) mod units;
pub(super) mod value;
pub(super) mod variation;
pub(super) mod written_out;
