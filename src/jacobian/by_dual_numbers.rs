//! The right Jacobian by dual numbers, and how well a double can tell each entry.

use super::scale::equilibrate;
use nalgebra::{DMatrix, DVector};
use num_dual::Dual64;

/// Doubles that an input may be off without anybody noticing, in units of the last place.
const UNITS: f64 = 256.0 * f64::EPSILON;

/// Samples of the rounding.
const SAMPLES: usize = 4;

/// A reference and how far a right entry may be from it.
pub(super) struct Reference {
    pub(super) matrix: DMatrix<f64>,
    pub(super) slack: DMatrix<f64>,
}

/// The Jacobian of `f` at a point by dual numbers.
///
/// An entry may be off by the `tolerance` of itself; by what it moves when the inputs are off by a few units in the last
/// place and the seeds are others, as then all intermediate results round otherwise; and by rounding against the scale of
/// its row and column.
pub(super) fn reference(
    f: &impl Fn(&DVector<Dual64>) -> DVector<Dual64>,
    at: &DVector<f64>,
    tolerance: f64,
) -> Reference {
    let (matrix, value) = derivative(f, at, 1.0);
    let (rows, columns) = equilibrate(&matrix);
    let floor = |r: usize, c: usize| match (rows[r] > 0.0, columns[c] > 0.0) {
        (true, true) => rows[r] * columns[c],
        // A row or column of zeros has no scale but that of the values.
        _ if at[c] != 0.0 => (value[r] / at[c]).abs(),
        _ => 0.0,
    };
    let mut slack = DMatrix::from_fn(matrix.nrows(), matrix.ncols(), |r, c| {
        tolerance * matrix[(r, c)].abs() + 64.0 * f64::EPSILON * floor(r, c)
    });
    for sample in 0..SAMPLES {
        let sign = |c: usize| {
            if (c * 7 + sample * 5) % 4 < 2 {
                1.0
            } else {
                -1.0
            }
        };
        let near = DVector::from_fn(at.len(), |c, _| at[c] * (1.0 + sign(c) * UNITS));
        // Factors that are no powers of two round anew.
        let seed = [3.0, 0.7, 11.0, 1.3][sample % 4];
        let (moved, _) = derivative(f, &near, seed);
        for (slack, (a, b)) in slack.iter_mut().zip(moved.iter().zip(matrix.iter())) {
            *slack = slack.max((a - b).abs() * 4.0);
        }
    }
    Reference { matrix, slack }
}

/// The Jacobian from seeds of a given size, and the value.
fn derivative(
    f: &impl Fn(&DVector<Dual64>) -> DVector<Dual64>,
    at: &DVector<f64>,
    seed: f64,
) -> (DMatrix<f64>, DVector<f64>) {
    let columns: Vec<_> = (0..at.len())
        .map(|column| {
            let seeded = DVector::from_fn(at.len(), |i, _| {
                Dual64::new(at[i], if i == column { seed } else { 0.0 })
            });
            f(&seeded)
        })
        .collect();
    let value = columns
        .first()
        .map_or_else(DVector::default, |y| y.map(|d| d.re));
    let matrix = DMatrix::from_fn(value.len(), at.len(), |r, c| columns[c][r].eps / seed);
    (matrix, value)
}
