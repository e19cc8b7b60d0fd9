//! Pages whose truth is known apart from the verifier: lines of many families, worlds, mistakes, styles.

pub(crate) mod energy;
pub(crate) mod expr;
pub(crate) mod family;
pub(crate) mod mistake;
pub(crate) mod moving_centre;
pub(crate) mod page;
pub(crate) mod parse;
pub(crate) mod points;
pub(crate) mod random;
pub(crate) mod rewrite;
pub(crate) mod slopes;
pub(crate) mod style;
pub(crate) mod symbol;
pub(crate) mod tensors;
pub(crate) mod world;
