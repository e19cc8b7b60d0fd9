//! Marks a class of derivations against an instructor's own, the key.
//!
//! A line of the key that carries marks is a *milestone*. A line of a student reaches it if it follows from that line by
//! algebra, by taking components, and with definitions put in, but without the laws that make everything true: each is
//! decided exactly, as a check decides lines. Whatever is not decided goes to a person, with the reason.
//!
//! ```
//! use polhode::grade::{Key, Work, mark};
//! use polhode::notation::document::Format;
//!
//! let key = r#"---
//! marks: {"(1)": 2}
//! polhode:
//! - N is an inertial frame.
//! - The rotor is a rigid body.
//! - B is a frame fixed in the rotor.
//! - x, y, z are the axes of B.
//! - G is the mass centre of the rotor.
//! - $\vec\omega$ is the angular velocity of the rotor relative to N.
//! - $I$ is the inertia tensor of the rotor about G.
//! - $\vec L$ is the angular momentum of the rotor about G relative to N.
//! ---
//! The angular momentum is $$\vec L = I\vec\omega. \tag{1}$$
//! "#;
//! let key = Key::read("key.md", key, Format::Markdown).expect("a key that holds");
//! let work = Work::of_text("s017", "mine.md", Format::Markdown, r"So $$I\vec\omega = \vec L.$$");
//! assert_eq!(mark(&key, &work).marks.to_string(), "2");
//! ```
//!
//! The rooms, each of which sees those above it: `result` (what is said of a student), `policy` (what the front matter of
//! a key sets), `matching` (which line says what another says), `remembered` (what lines of the class came to), `meaning`
//! (what is declared of submissions), `key`, `paper` (the lines of one student and what each is
//! worth), `rules` (what a careful marker does), `mark`.

mod key;
mod lookalike;
mod mark;
mod matching;
mod meaning;
mod paper;
mod policy;
mod remembered;
mod result;
mod rules;
mod size;
mod slip;

pub use key::{Difference, Key, Refusal, Told};
pub use mark::{mark, not_marked};
pub use paper::{Text, Work};
pub use policy::{FollowThrough, Marks};
pub use result::{Assumption, Graded, Line, Numbers, Outcome, Place, Reached, Slip};
