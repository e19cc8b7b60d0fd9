//! Run time against error: references that are right to rounding, problems, and the methods held against them.

mod double;
mod reference;

pub use double::Double;
pub use reference::reference;
