//! One problem, and every solver finds the same.

use argmin::core::{CostFunction, Executor, Gradient, Hessian, Jacobian, Operator, State};
use argmin::solver::gaussnewton::GaussNewton;
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::newton::Newton;
use argmin::solver::quasinewton::LBFGS;
use argmin::solver::trustregion::{Dogleg, TrustRegion};
use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector, dmatrix, dvector};
use polhode::optimise::{LeastSquares, OlderVector};

/// Rosenbrock's valley: r = (10 (y − x²), 1 − x), least at (1, 1).
fn valley(x: &DVector<f64>) -> Option<(DVector<f64>, DMatrix<f64>)> {
    let r = dvector![10.0 * (x[1] - x[0] * x[0]), 1.0 - x[0]];
    (x[0] < 1e3).then_some((r, dmatrix![-20.0 * x[0], 10.0; -1.0, 0.0]))
}

type Valley = LeastSquares<fn(&DVector<f64>) -> Option<(DVector<f64>, DMatrix<f64>)>>;

fn problem() -> Valley {
    LeastSquares::new(dvector![-1.2, 1.0], valley)
}

fn assert_found(found: &OlderVector<f64>) {
    assert!(
        (found - OlderVector::from_vec(vec![1.0, 1.0])).norm() < 1e-5,
        "{found}"
    );
}

#[test]
fn by_levenberg_and_marquardt() {
    let (problem, report) = LevenbergMarquardt::new().minimize(problem());
    assert!(report.termination.was_successful());
    assert!((problem.parameters() - dvector![1.0, 1.0]).norm() < 1e-9);
    assert!(problem.value().expect("a value") < 1e-18);
    // As many residuals as parameters leave nothing to tell the variance by.
    assert_eq!(problem.covariance(), None);
}

/// The solver's own problem and its start.
macro_rules! solved {
    ($solver:expr, $iterations:expr, $point:ident) => {{
        let problem = problem();
        let start = problem.start();
        let run = Executor::new(problem, $solver)
            .configure(|state| state.param(start).max_iters($iterations))
            .run()
            .expect("a run");
        run.state().$point().expect("a point").clone()
    }};
}

#[test]
fn by_the_solvers_of_argmin() {
    assert_found(&solved!(GaussNewton::<f64>::new(), 10, get_best_param));
    assert_found(&solved!(
        TrustRegion::new(Dogleg::<f64>::new()),
        100,
        get_best_param
    ));
    // Newton's method alone never asks for the cost.
    assert_found(&solved!(Newton::<f64>::new(), 20, get_param));
    let search = MoreThuenteLineSearch::new();
    assert_found(&solved!(LBFGS::new(search, 5), 100, get_best_param));
}

#[test]
fn what_argmin_is_told_is_the_derivative() {
    let (problem, at) = (problem(), OlderVector::from_vec(vec![0.3, -0.7]));
    let r = problem.apply(&at).expect("residuals");
    let jacobian = problem.jacobian(&at).expect("a Jacobian");
    assert!((problem.cost(&at).expect("a cost") - r.norm_squared() / 2.0).abs() < 1e-15);
    assert_eq!(
        problem.gradient(&at).expect("a gradient"),
        jacobian.tr_mul(&r)
    );
    assert_eq!(
        problem.hessian(&at).expect("a Hessian"),
        jacobian.tr_mul(&jacobian)
    );
    // Where there is no value, a solver turns back: the cost is without bound.
    let beyond = OlderVector::from_vec(vec![2e3, 0.0]);
    assert!(problem.cost(&beyond).expect("a cost").is_infinite());
    assert!(problem.gradient(&beyond).is_err());
}
