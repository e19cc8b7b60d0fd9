//! Residuals and their Jacobian, as one problem for any solver.

use super::evaluated::{Evaluated, Valued};
use nalgebra::{DMatrix, DVector};

/// Residuals and their Jacobian.
pub(super) type Residuals = (DVector<f64>, DMatrix<f64>);

impl Valued for Residuals {
    fn cost(&self) -> f64 {
        self.0.norm_squared() / 2.0
    }

    fn gradient(&self) -> DVector<f64> {
        self.1.tr_mul(&self.0)
    }
}

/// A problem of least squares: the parameters that make ½ |r|² least.
///
/// Residuals and Jacobian are computed together, once at each point, by a function that returns `None` where there is no value:
/// solvers turn back from there.
/// The feature `levenberg-marquardt` makes this a `LeastSquaresProblem`, the feature `argmin` a `CostFunction` with
/// `Gradient`, `Hessian` (JᵀJ, as Gauss and Newton take it), `Jacobian` and `Operator`.
///
/// ```
/// use nalgebra::{DMatrix, DVector, dmatrix, dvector};
/// use polhode::optimise::LeastSquares;
/// // A line through three points.
/// let problem = LeastSquares::new(dvector![0.0, 0.0], |x| {
///     let slopes = dmatrix![0.0, 1.0; 1.0, 1.0; 2.0, 1.0];
///     Some((&slopes * x - dvector![1.0, 3.1, 4.9], slopes))
/// });
/// problem.go_to(problem.parameters() + problem.gauss_newton_step().ok_or("parallel columns")?);
/// assert!((problem.parameters() - dvector![1.95, 1.05]).norm() < 1e-12);
/// # Ok::<(), &str>(())
/// ```
#[derive(Clone, Debug)]
pub struct LeastSquares<F>(Evaluated<F, Residuals>);

impl<F: Fn(&DVector<f64>) -> Option<Residuals>> LeastSquares<F> {
    /// The problem of a function that returns residuals and Jacobian, at a start.
    pub fn new(start: DVector<f64>, residuals: F) -> Self {
        Self(Evaluated::new(start, residuals))
    }

    /// Goes to other parameters.
    pub fn go_to(&self, parameters: DVector<f64>) {
        self.0.go_to(parameters);
    }
}

impl<F> LeastSquares<F> {
    /// Where it is: at the start, at the parameters that were asked for last, or at the solution when `levenberg-marquardt`
    /// is done.
    pub fn parameters(&self) -> DVector<f64> {
        self.0.parameters()
    }

    /// What `take` makes of residuals and Jacobian there.
    pub(super) fn found<R>(
        &self,
        take: impl FnOnce(&DVector<f64>, &DMatrix<f64>) -> R,
    ) -> Option<R> {
        self.0.found(|(r, jacobian)| take(r, jacobian))
    }

    /// ½ |r|² there.
    pub fn value(&self) -> Option<f64> {
        self.0.found(Valued::cost)
    }

    /// Cost and gradient, or the wall where there is no value.
    #[cfg(feature = "argmin")]
    pub(super) fn with_wall(&self) -> Option<(f64, DVector<f64>)> {
        self.0.with_wall()
    }

    /// What `take` makes of residuals and Jacobian at the last point that had them.
    #[cfg(feature = "levenberg-marquardt")]
    pub(super) fn found_last<R>(&self, take: impl FnOnce(&DVector<f64>) -> R) -> Option<R> {
        self.0.found_last(|(r, _)| take(r))
    }

    /// What to add to the parameters by Gauss and Newton: −J⁺ r. `None` where the columns of J depend on one another.
    pub fn gauss_newton_step(&self) -> Option<DVector<f64>> {
        self.found(|r, jacobian| {
            let normal = jacobian.tr_mul(jacobian).cholesky()?;
            Some(-normal.solve(&jacobian.tr_mul(r)))
        })?
    }

    /// The covariance of the parameters at a minimum: s² (JᵀJ)⁻¹ with s² = |r|²/(m − n), m residuals and n parameters, if all
    /// residuals have one variance. `None` where they don't determine the parameters.
    pub fn covariance(&self) -> Option<DMatrix<f64>> {
        self.found(|r, jacobian| {
            let freedom = r.len().checked_sub(jacobian.ncols()).filter(|n| *n > 0)?;
            let normal = jacobian.tr_mul(jacobian).cholesky()?;
            Some(normal.inverse() * (r.norm_squared() / freedom as f64))
        })?
    }
}
