//! Vectors and matrices in the version of nalgebra that argmin and levenberg-marquardt speak.

use nalgebra::{DMatrix, DVector};
pub use nalgebra_older::{DMatrix as OlderMatrix, DVector as OlderVector};

pub(super) fn older_vector(vector: &DVector<f64>) -> OlderVector<f64> {
    OlderVector::from_column_slice(vector.as_slice())
}

pub(super) fn newer_vector(vector: &OlderVector<f64>) -> DVector<f64> {
    DVector::from_column_slice(vector.as_slice())
}

pub(super) fn older_matrix(matrix: &DMatrix<f64>) -> OlderMatrix<f64> {
    OlderMatrix::from_column_slice(matrix.nrows(), matrix.ncols(), matrix.as_slice())
}
