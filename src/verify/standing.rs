//! What each line is worth by the facts, and the verdict that its role makes of that.

pub(crate) mod apart;
pub(crate) mod between;
pub(crate) mod braces;
pub(crate) mod chains;
pub(crate) mod deny;
pub(crate) mod either;
pub(crate) mod extents;
pub(crate) mod fewer;
pub(crate) mod hold;
pub(crate) mod indices;
pub(crate) mod judge;
pub(crate) mod kept;
pub(crate) mod memory;
pub(crate) mod orders;
pub(crate) mod parts;
pub(crate) mod premises;
pub(crate) mod prepared;
pub(crate) mod purposes;
pub(crate) mod recalled;
pub(crate) mod roles;
pub(crate) mod shown;
pub(crate) mod sides;
pub(crate) mod trial;
pub(crate) mod unused;
pub(crate) mod verdicts;
pub(crate) mod written;
