//! What holds at a place of a document, and the proofs that follow from it.

mod angles;
pub(crate) mod candidates;
pub(crate) mod cases;
pub(crate) mod images;
pub(crate) mod parts;
pub(crate) mod premises;
pub(crate) mod proof;
pub(crate) mod relevant;
pub(crate) mod roots;
pub(crate) mod small;
pub(crate) mod squares;
pub(crate) mod turned;
pub(crate) mod world;

/// The name of the instant from which time is counted.
pub(crate) const START: &str = "t=0";

/// Who says that something holds.
#[derive(Clone, Debug, PartialEq, Eq, PartialOrd, Ord, Hash)]
pub(crate) enum Source {
    /// A line of the document that was accepted, by its cell in a notebook and its number there or in the file.
    Line(Option<usize>, usize),
    /// A sentence by which the author declares something.
    Declared(String),
    /// What is constant by what holds, with its value at an instant.
    Instant(String),
    /// A law of this name.
    Law(&'static str),
    /// What another source says, to an order in what is small: "to first order".
    ToOrder(Box<Source>, &'static str),
}

impl Source {
    /// The words that `uses` and certificates show.
    pub(crate) fn text(&self) -> String {
        match self {
            Self::Line(_, line) => format!("line {line}"),
            Self::Declared(sentence) => format!("declared: {sentence}"),
            Self::Instant(name) if name == START => "the initial values".to_owned(),
            Self::Instant(name) => format!("the values at {name}"),
            Self::Law(name) => (*name).to_owned(),
            Self::ToOrder(source, order) => format!("{}, {order}", source.text()),
        }
    }
}
