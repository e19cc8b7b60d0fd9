//! The single change that puts a false line right, where there is one: what it is, where, and the line as it should be.
//!
//! `edit` is a change to the text of a line, `slips` the changes that undo what people do wrong, and `search` tries them
//! by the facts that were in force when the line was judged, of which `by_terms` leaves out most at once. It knows no topic: whether a change helps is proved.

mod by_terms;
pub(crate) mod edit;
mod pairs;
pub(crate) mod search;
pub(crate) mod slips;
