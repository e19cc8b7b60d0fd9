//! Whether a tensor is one that a body can have.

use crate::mechanics::principal_axes;
use nalgebra::Matrix3;
use std::{error, fmt};

/// Why no body has the tensor.
#[derive(Clone, Copy, Debug, PartialEq)]
#[non_exhaustive]
pub enum ImpossibleInertia {
    /// An entry is infinite or not a number.
    NotFinite {
        /// Its row, from 0.
        row: usize,
        /// Its column, from 0.
        column: usize,
        /// The entry.
        entry: f64,
    },
    /// The entry of this row and column differs from the one across the diagonal.
    NotSymmetric {
        /// The row, from 0.
        row: usize,
        /// The column, from 0.
        column: usize,
        /// The entry, and the one of this column and row.
        entries: [f64; 2],
    },
    /// A principal moment is negative.
    Negative {
        /// The smallest principal moment.
        moment: f64,
    },
    /// A principal moment is zero: all mass lies on one line, and no moment can turn it about that line.
    Zero,
    /// The largest principal moment exceeds the sum of the others.
    Triangle {
        /// The principal moments, ascending.
        moments: [f64; 3],
    },
}

impl fmt::Display for ImpossibleInertia {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::NotFinite { row, column, entry } => {
                let [r, c] = [*row, *column].map(axis);
                write!(f, "the entry {r}{c} of the inertia tensor is {entry}, and has to be finite")
            }
            Self::NotSymmetric {
                row,
                column,
                entries: [above, below],
            } => {
                let [r, c] = [*row, *column].map(axis);
                write!(
                    f,
                    "the inertia tensor is not symmetric: entries {r}{c} = {above} and {c}{r} = {below} differ"
                )
            }
            Self::Negative { moment } => {
                write!(f, "the principal moment of inertia {moment:e} is negative")
            }
            Self::Zero => f.write_str(
                "a principal moment of inertia is zero: the mass lies on a line, whose spin no moment determines",
            ),
            Self::Triangle { moments: [a, b, c] } => write!(
                f,
                "no body has the principal moments {a}, {b}, {c}: the largest exceeds the sum of the others"
            ),
        }
    }
}

impl error::Error for ImpossibleInertia {}

/// The letter of an axis.
fn axis(index: usize) -> &'static str {
    ["x", "y", "z"].get(index).unwrap_or(&"?")
}

/// What rounding in six numbers that came out of a rotation or a file may do, against the largest moment.
const SLACK: f64 = 1e-12;

/// Whether a body can have this inertia tensor: finite, symmetric, its principal moments positive, and the largest at
/// most the sum of the others, as `I₁ + I₂ − I₃ = 2 ∫ z² dm` along principal axes.
///
/// Equality, the flat plate, is possible. A moment that is zero to rounding is refused, as then ω does not follow from
/// L. Rounding is allowed for: 1e-12 of the largest entry.
///
/// # Errors
/// The first of the conditions that fails, in that order.
///
/// ```
/// use nalgebra::{Matrix3, Vector3};
/// use polhode::mechanics::{ImpossibleInertia, possible_body};
/// let tensor = |x, y, z| Matrix3::from_diagonal(&Vector3::new(x, y, z));
/// assert_eq!(possible_body(&tensor(1.0, 2.0, 3.0)), Ok(()));
/// assert_eq!(possible_body(&tensor(1.0, 2.0, 0.0)), Err(ImpossibleInertia::Zero));
/// assert!(possible_body(&tensor(1.0, 2.0, 3.1)).is_err());
/// ```
pub fn possible_body(inertia: &Matrix3<f64>) -> Result<(), ImpossibleInertia> {
    for (row, column) in (0..9).map(|i| (i / 3, i % 3)) {
        let entry = inertia[(row, column)];
        if !entry.is_finite() {
            return Err(ImpossibleInertia::NotFinite { row, column, entry });
        }
    }
    let largest = inertia.amax();
    for (row, column) in [(0, 1), (0, 2), (1, 2)] {
        let (above, below) = (inertia[(row, column)], inertia[(column, row)]);
        if (above / 2.0 - below / 2.0).abs() > SLACK * largest {
            return Err(ImpossibleInertia::NotSymmetric {
                row,
                column,
                entries: [above, below],
            });
        }
    }
    let moments: [f64; 3] = principal_axes(inertia).moments.into();
    let [a, b, c] = moments;
    if a < -SLACK * largest {
        Err(ImpossibleInertia::Negative { moment: a })
    } else if a <= 4.0 * f64::EPSILON * largest {
        Err(ImpossibleInertia::Zero)
    } else if c - b > a + SLACK * c {
        Err(ImpossibleInertia::Triangle { moments })
    } else {
        Ok(())
    }
}
