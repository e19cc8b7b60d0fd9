//! Problems of least squares for the crate `argmin`.

use super::least_squares::{Found, LeastSquares};
use super::older::{OlderMatrix, OlderVector, newer_vector, older_matrix, older_vector};
use argmin::core::{CostFunction, Error, Gradient, Hessian, Jacobian, Operator};
use nalgebra::{DMatrix, DVector};

impl<F: Fn(&DVector<f64>) -> Found> LeastSquares<F> {
    /// The parameters as argmin takes them: `executor.configure(|state| state.param(start))`.
    pub fn start(&self) -> OlderVector<f64> {
        older_vector(&self.parameters())
    }

    fn at<R>(
        &self,
        parameters: &OlderVector<f64>,
        take: impl FnOnce(&DVector<f64>, &DMatrix<f64>) -> R,
    ) -> Result<R, Error> {
        self.go_to(newer_vector(parameters));
        let none = || Error::msg("the residuals have no value at these parameters");
        self.of_found(take).ok_or_else(none)
    }
}

/// ½ |r|², infinite where there is no value: no step goes there.
impl<F: Fn(&DVector<f64>) -> Found> CostFunction for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Output = f64;

    fn cost(&self, parameters: &Self::Param) -> Result<f64, Error> {
        self.go_to(newer_vector(parameters));
        Ok(self.value().unwrap_or(f64::INFINITY))
    }
}

/// Jᵀ r.
impl<F: Fn(&DVector<f64>) -> Found> Gradient for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Gradient = OlderVector<f64>;

    fn gradient(&self, parameters: &Self::Param) -> Result<Self::Gradient, Error> {
        self.at(parameters, |r, jacobian| older_vector(&jacobian.tr_mul(r)))
    }
}

/// JᵀJ: what is left of the Hessian where the residuals are small.
impl<F: Fn(&DVector<f64>) -> Found> Hessian for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Hessian = OlderMatrix<f64>;

    fn hessian(&self, parameters: &Self::Param) -> Result<Self::Hessian, Error> {
        self.at(parameters, |_, jacobian| {
            older_matrix(&jacobian.tr_mul(jacobian))
        })
    }
}

/// r.
impl<F: Fn(&DVector<f64>) -> Found> Operator for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Output = OlderVector<f64>;

    fn apply(&self, parameters: &Self::Param) -> Result<Self::Output, Error> {
        self.at(parameters, |r, _| older_vector(r))
    }
}

/// J.
impl<F: Fn(&DVector<f64>) -> Found> Jacobian for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Jacobian = OlderMatrix<f64>;

    fn jacobian(&self, parameters: &Self::Param) -> Result<Self::Jacobian, Error> {
        self.at(parameters, |_, jacobian| older_matrix(jacobian))
    }
}
