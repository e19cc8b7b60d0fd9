//! Problems of least squares for the crate `levenberg-marquardt`.

use super::least_squares::{LeastSquares, Residuals};
use super::older::{OlderMatrix, OlderVector, newer_vector, older_matrix, older_vector};
use levenberg_marquardt::LeastSquaresProblem;
use nalgebra::DVector;
use nalgebra_older::{Dyn, U1, VecStorage};

/// By how much the residuals of a step that is not to be taken are larger.
const REFUSED: f64 = 1e3;

impl<F: Fn(&DVector<f64>) -> Option<Residuals>> LeastSquaresProblem<f64, Dyn, Dyn>
    for LeastSquares<F>
{
    type ResidualStorage = VecStorage<f64, Dyn, U1>;
    type JacobianStorage = VecStorage<f64, Dyn, Dyn>;
    type ParameterStorage = VecStorage<f64, Dyn, U1>;

    fn set_params(&mut self, parameters: &OlderVector<f64>) {
        self.go_to(newer_vector(parameters));
    }

    fn params(&self) -> OlderVector<f64> {
        older_vector(&self.parameters())
    }

    /// Where there is no value, a multiple of the last residuals: the step is not taken, and the next is shorter.
    fn residuals(&self) -> Option<OlderVector<f64>> {
        let found = self.found(|r, _| older_vector(r));
        found.or_else(|| self.found_last(|r| older_vector(r) * REFUSED))
    }

    fn jacobian(&self) -> Option<OlderMatrix<f64>> {
        self.found(|_, jacobian| older_matrix(jacobian))
    }
}
