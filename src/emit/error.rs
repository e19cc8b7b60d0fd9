//! Why no code can be written.

use crate::emit::{Column, KnownInertia, Language, Precision, Quantity, Request};
use crate::mechanics::{ImpossibleInertia, possible_body};
use std::fmt;

/// Why no code can be written.
#[derive(Clone, Debug, PartialEq)]
#[non_exhaustive]
pub enum EmitError {
    /// A tensor that no body has.
    Inertia(ImpossibleInertia),
    /// A column that the Jacobian of the quantity has not.
    NoColumn(Column),
    /// A name that is no name of a function in the language.
    Name(String),
    /// Numbers of the code are too large or too small for the precision.
    OutOfRange,
    /// Single precision in a language that has none.
    NoSingle,
}

impl fmt::Display for EmitError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Inertia(error) => error.fmt(f),
            Self::NoColumn(column) => {
                let name = match column {
                    Column::Attitude => "attitude",
                    Column::AngularVelocity => "angular velocity",
                    Column::Torque => "torque",
                    Column::Inertia => "inertia",
                    Column::Dt => "dt",
                };
                write!(
                    f,
                    "there is no derivative in {name} here: ask for a Jacobian that has it, and for inertia of which something is not known"
                )
            }
            Self::Name(name) => write!(
                f,
                "`{name}` can't be the name of a function: take letters, digits and underscores, a letter first, and no word of the language"
            ),
            Self::OutOfRange => write!(
                f,
                "the inertia or its inverse is out of range: ask for double precision, or take units in which it is of a middling size"
            ),
            Self::NoSingle => write!(
                f,
                "single precision is for Rust and C: leave the precision out"
            ),
        }
    }
}

impl std::error::Error for EmitError {}

/// Refuses a request that can't be met.
pub(super) fn refuse(request: &Request) -> Result<(), EmitError> {
    if let KnownInertia::Tensor(tensor) = &request.known {
        possible_body(tensor).map_err(EmitError::Inertia)?;
    }
    let is_known = matches!(request.known, KnownInertia::Tensor(_));
    let has = |column: &Column| {
        request.of.columns().contains(column) && !(is_known && *column == Column::Inertia)
    };
    if is_known && request.of == Quantity::Regressor {
        return Err(EmitError::NoColumn(Column::Inertia));
    }
    if let Some(column) = request.columns.iter().find(|column| !has(column)) {
        return Err(EmitError::NoColumn(*column));
    }
    let single = request.precision == Precision::Single;
    if single && !matches!(request.language, Language::Rust | Language::C) {
        return Err(EmitError::NoSingle);
    }
    match &request.name {
        Some(name) if !is_name(name) => Err(EmitError::Name(name.clone())),
        _ => Ok(()),
    }
}

/// Whether a function can have this name, in every language.
fn is_name(name: &str) -> bool {
    let first = name.chars().next().is_some_and(|c| c.is_ascii_alphabetic());
    let rest = name.chars().all(|c| c.is_ascii_alphanumeric() || c == '_');
    first && rest && !RESERVED.split_whitespace().any(|word| word == name)
}

/// The words of Rust, C and Python that look like names, and the names that the code itself uses.
const RESERVED: &str = "\
    abstract alignas alignof and as assert async auto await become bool box break case char class const constexpr continue crate \
    def default del do double dyn elif else enum except extern false final finally float fn for from gen global goto if impl \
    import in inline int is lambda let long loop macro main match mod move mut nonlocal not nullptr or override pass priv pub \
    raise ref register restrict return self short signed sizeof static static_assert struct super switch thread_local trait \
    true try type typedef typeof typeof_unqual union unsafe unsigned unsized use virtual void volatile where while with yield \
    differs printf sqrt sin cos sqrtf sinf cosf math sum max map abs zip isinstance inertia omega alpha torque attitude dt moment \
    regressor jacobian attitude_after omega_after";
