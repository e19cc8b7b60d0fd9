//! Problems for the crate `argmin`.

use super::least_squares::{LeastSquares, Residuals};
use super::objective::{Cost, Objective};
use super::older::{OlderMatrix, OlderVector, newer_vector, older_matrix, older_vector};
use argmin::core::{CostFunction, Error, Gradient, Hessian, Jacobian, Operator};
use nalgebra::{DMatrix, DVector};

/// An error where there is no value.
fn valued<R>(found: Option<R>) -> Result<R, Error> {
    found.ok_or_else(|| Error::msg("the function has no value at these parameters"))
}

impl<F: Fn(&DVector<f64>) -> Option<Residuals>> LeastSquares<F> {
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
        valued(self.found(take))
    }
}

/// ½ |r|², above all before where there is no value: no step goes there.
impl<F: Fn(&DVector<f64>) -> Option<Residuals>> CostFunction for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Output = f64;

    fn cost(&self, parameters: &Self::Param) -> Result<f64, Error> {
        self.go_to(newer_vector(parameters));
        Ok(self.with_wall().map_or(f64::INFINITY, |(cost, _)| cost))
    }
}

/// Jᵀ r.
impl<F: Fn(&DVector<f64>) -> Option<Residuals>> Gradient for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Gradient = OlderVector<f64>;

    fn gradient(&self, parameters: &Self::Param) -> Result<Self::Gradient, Error> {
        self.go_to(newer_vector(parameters));
        valued(
            self.with_wall()
                .map(|(_, gradient)| older_vector(&gradient)),
        )
    }
}

/// JᵀJ: what is left of the Hessian where the residuals are small.
impl<F: Fn(&DVector<f64>) -> Option<Residuals>> Hessian for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Hessian = OlderMatrix<f64>;

    fn hessian(&self, parameters: &Self::Param) -> Result<Self::Hessian, Error> {
        self.at(parameters, |_, jacobian| {
            older_matrix(&jacobian.tr_mul(jacobian))
        })
    }
}

/// r.
impl<F: Fn(&DVector<f64>) -> Option<Residuals>> Operator for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Output = OlderVector<f64>;

    fn apply(&self, parameters: &Self::Param) -> Result<Self::Output, Error> {
        self.at(parameters, |r, _| older_vector(r))
    }
}

/// J.
impl<F: Fn(&DVector<f64>) -> Option<Residuals>> Jacobian for LeastSquares<F> {
    type Param = OlderVector<f64>;
    type Jacobian = OlderMatrix<f64>;

    fn jacobian(&self, parameters: &Self::Param) -> Result<Self::Jacobian, Error> {
        self.at(parameters, |_, jacobian| older_matrix(jacobian))
    }
}

impl<F> Objective<F> {
    /// The parameters as argmin takes them: `executor.configure(|state| state.param(start))`.
    pub fn start(&self) -> OlderVector<f64> {
        older_vector(&self.parameters())
    }
}

/// The cost, above all before where there is no value: no step goes there.
impl<F: Fn(&DVector<f64>) -> Option<Cost>> CostFunction for Objective<F> {
    type Param = OlderVector<f64>;
    type Output = f64;

    fn cost(&self, parameters: &Self::Param) -> Result<f64, Error> {
        self.go_to(newer_vector(parameters));
        Ok(self.with_wall().map_or(f64::INFINITY, |(cost, _)| cost))
    }
}

/// The gradient.
impl<F: Fn(&DVector<f64>) -> Option<Cost>> Gradient for Objective<F> {
    type Param = OlderVector<f64>;
    type Gradient = OlderVector<f64>;

    fn gradient(&self, parameters: &Self::Param) -> Result<Self::Gradient, Error> {
        self.go_to(newer_vector(parameters));
        valued(
            self.with_wall()
                .map(|(_, gradient)| older_vector(&gradient)),
        )
    }
}
