//! Reads what people write: a text becomes a [`Document`](document::Document) of headings, prose and
//! formulas, and each formula a typed tree.
//!
//! Reading never fails. What is not understood stands in the tree as an error at its place, and everything
//! around it is read all the same.

pub mod ast;
pub mod document;
