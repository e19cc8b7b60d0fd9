//! The single change that puts a false line right, where there is one: what it is, where, and the line as it should be.
//!
//! `edit` is a change to the text of a line, `slips` the changes that undo what people do wrong, and `search` tries them
//! by the facts that were in force when the line was judged. It knows no topic: whether a change helps is proved.

pub(crate) mod edit;
pub(crate) mod search;
pub(crate) mod slips;
