//! From the tree of a formula to a value with its basis.

pub(crate) mod applied;
pub(crate) mod as_a_whole;
pub(crate) mod at_instants;
pub(crate) mod customs;
pub(crate) mod dimensions;
pub(crate) mod evaluate;
pub(crate) mod functions;
pub(crate) mod indices;
pub(crate) mod integrals;
pub(crate) mod known;
pub(crate) mod labels;
pub(crate) mod letters;
pub(crate) mod lower;
pub(crate) mod matrices;
pub(crate) mod members;
pub(crate) mod operations;
pub(crate) mod products;
pub(crate) mod quantity;
pub(crate) mod quaternions;
pub(crate) mod rates;
pub(crate) mod spelled;
pub(crate) mod symbols;
pub(crate) mod unknown;
pub(crate) mod value;
pub(crate) mod wholes;
pub(crate) mod written;
