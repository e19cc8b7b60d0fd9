//! Run time against error: references that are right to rounding, problems, and the methods held against them.

mod calibrate;
mod contender;
mod double;
mod ensemble;
mod measure;
mod problem;
mod reference;
mod rival;
mod stability;

pub use calibrate::calibrate;
pub use contender::{CONTENDERS, Contender};
pub use double::Double;
pub use ensemble::{EnsembleTime, ensemble};
pub use measure::{Point, floor, measure, time_to};
pub use problem::{Problem, problems, problems_of};
pub use reference::reference;
pub use stability::{Axis, Cell, axes, cells, held};
