//! The size that is natural for each row and column of a matrix.

use nalgebra::DMatrix;

/// Numbers r and c such that |entry| ≤ r c about, with equality in each row and column; zero for a row or column of zeros.
///
/// Equilibration of Ruiz (2001), *A scaling algorithm to equilibrate both rows and columns norms in matrices*.
pub(super) fn equilibrate(matrix: &DMatrix<f64>) -> (Vec<f64>, Vec<f64>) {
    let (height, width) = matrix.shape();
    let (mut rows, mut columns) = (vec![1.0; height], vec![1.0; width]);
    for _ in 0..24 {
        let scaled = |r: usize, c: usize, rows: &[f64], columns: &[f64]| {
            let entry = matrix[(r, c)].abs();
            if entry > 0.0 {
                entry / rows[r] / columns[c]
            } else {
                0.0
            }
        };
        let tallest: Vec<f64> = (0..height)
            .map(|r| {
                (0..width)
                    .map(|c| scaled(r, c, &rows, &columns))
                    .fold(0.0, f64::max)
            })
            .collect();
        let widest: Vec<f64> = (0..width)
            .map(|c| {
                (0..height)
                    .map(|r| scaled(r, c, &rows, &columns))
                    .fold(0.0, f64::max)
            })
            .collect();
        let grow = |sizes: &mut [f64], by: &[f64]| {
            for (size, factor) in sizes.iter_mut().zip(by) {
                if *factor > 0.0 {
                    *size *= factor.sqrt();
                }
            }
        };
        grow(&mut rows, &tallest);
        grow(&mut columns, &widest);
    }
    for (r, size) in rows.iter_mut().enumerate() {
        if matrix.row(r).iter().all(|entry| *entry == 0.0) {
            *size = 0.0;
        }
    }
    for (c, size) in columns.iter_mut().enumerate() {
        if matrix.column(c).iter().all(|entry| *entry == 0.0) {
            *size = 0.0;
        }
    }
    (rows, columns)
}
