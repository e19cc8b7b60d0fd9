//! Matrices of few entries, as solvers take them.

use nalgebra::{DMatrix, Dim, Matrix, RawStorage};

/// A matrix in compressed sparse columns: of column `c` the entries number `starts[c]` to `starts[c + 1]`, their rows rising.
///
/// ```
/// use nalgebra::{Matrix2, RowVector2};
/// use polhode::optimise::Blocks;
/// let mut blocks = Blocks::default();
/// blocks.add(0, 0, &Matrix2::new(1.0, 2.0, 3.0, 0.0));
/// blocks.add(2, 1, &RowVector2::new(4.5, 6.0));
/// // What stands at one place is added up.
/// blocks.add(2, 1, &RowVector2::new(0.5, 0.0));
/// let csc = blocks.csc(3, 3);
/// assert_eq!((csc.starts, csc.row_indices), (vec![0, 2, 5, 6], vec![0, 1, 0, 1, 2, 2]));
/// // The zero of a block stands: the pattern does not depend on the values.
/// assert_eq!(csc.values, [1.0, 3.0, 2.0, 0.0, 5.0, 6.0]);
/// ```
#[derive(Clone, Debug, PartialEq)]
pub struct Csc {
    /// How many rows there are.
    pub rows: usize,
    /// How many columns there are.
    pub columns: usize,
    /// Where each column begins, and the number of entries.
    pub starts: Vec<usize>,
    /// The row of each entry.
    pub row_indices: Vec<usize>,
    /// The entries.
    pub values: Vec<f64>,
}

/// A matrix under construction, from dense blocks.
#[derive(Clone, Debug, Default, PartialEq)]
pub struct Blocks {
    /// Row, column and value, in the order in which they were added.
    entries: Vec<(usize, usize, f64)>,
}

impl Blocks {
    /// Adds a block whose first entry stands at this row and column. What stands at one place is added up.
    pub fn add<R: Dim, C: Dim>(
        &mut self,
        row: usize,
        column: usize,
        block: &Matrix<f64, R, C, impl RawStorage<f64, R, C>>,
    ) {
        for c in 0..block.ncols() {
            for r in 0..block.nrows() {
                self.entries.push((row + r, column + c, block[(r, c)]));
            }
        }
    }

    /// The matrix of this size; what stands outside is left out.
    pub fn csc(&self, rows: usize, columns: usize) -> Csc {
        let mut of_column = vec![vec![]; columns];
        for (row, column, value) in &self.entries {
            if let (true, Some(entries)) = (*row < rows, of_column.get_mut(*column)) {
                entries.push((*row, *value));
            }
        }
        let mut csc = Csc {
            rows,
            columns,
            starts: vec![0],
            row_indices: vec![],
            values: vec![],
        };
        for mut entries in of_column {
            entries.sort_by_key(|(row, _)| *row);
            for same in entries.chunk_by(|(a, _), (b, _)| a == b) {
                csc.row_indices.push(same[0].0);
                csc.values.push(same.iter().map(|(_, value)| value).sum());
            }
            csc.starts.push(csc.values.len());
        }
        csc
    }
}

impl From<&Csc> for DMatrix<f64> {
    fn from(csc: &Csc) -> Self {
        let mut dense = Self::zeros(csc.rows, csc.columns);
        for column in 0..csc.columns {
            for entry in csc.starts[column]..csc.starts[column + 1] {
                dense[(csc.row_indices[entry], column)] += csc.values[entry];
            }
        }
        dense
    }
}
