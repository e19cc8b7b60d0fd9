//! What a sentence waits for of which nothing was made.

/// What a sentence waits for of which nothing was made.
#[derive(Clone, Debug, PartialEq, Eq)]
pub enum Wants {
    /// A sentence that says which frame has this name.
    Frame(String),
    /// A sentence that says which point has this name.
    Point(String),
    /// A sentence that says what has this name.
    Name(String),
    /// That something is made of this sentence.
    Sentence(String),
    /// That this sentence, which tells of the same letter, is taken out or agrees.
    Alone(String),
    /// That only one of it and this sentence is said: both cannot hold.
    OneOfTwo(String),
    /// A heading with this text, under which the sentence is said to hold.
    Heading(String),
    /// Another word, or none, in the place of this one before this noun.
    Adjective(String, String),
    /// The axis along which a shape lies, and its sizes: its noun.
    Direction(String),
}
