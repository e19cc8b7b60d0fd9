//! One problem, and every solver finds the same.

use argmin::core::{CostFunction, Executor, Gradient, Hessian, Jacobian, Operator, State};
use argmin::solver::gaussnewton::GaussNewton;
use argmin::solver::linesearch::MoreThuenteLineSearch;
use argmin::solver::newton::Newton;
use argmin::solver::quasinewton::LBFGS;
use argmin::solver::trustregion::{Dogleg, TrustRegion};
use levenberg_marquardt::LevenbergMarquardt;
use nalgebra::{DMatrix, DVector, Matrix3, Vector3, Vector6, dmatrix, dvector};
use polhode::motion::{Rk4, Rollout, State as Motion, System, Torque};
use polhode::optimise::{LeastSquares, Objective, OlderVector};

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
}

/// Where there is no value, the cost is that of a parabola from the last point that had one, which ends above all before.
#[test]
fn a_line_search_turns_back_where_there_is_no_value() {
    let (problem, from) = (problem(), OlderVector::from_vec(vec![0.3, -0.7]));
    let (here, downhill) = (
        problem.cost(&from).expect("a cost"),
        -problem.gradient(&from).expect("a gradient"),
    );
    let way = &downhill * (-2e3 / downhill[0]).abs();
    let beyond = &from + &way * downhill[0].signum();
    let (cost, gradient) = (
        problem.cost(&beyond).expect("a cost"),
        problem.gradient(&beyond).expect("a gradient"),
    );
    assert!(cost.is_finite() && cost > here);
    // (f₁ − f₀)/t is the mean of both slopes.
    let [fall, rise] = [-downhill, gradient].map(|g| g.dot(&(&beyond - &from)));
    assert!(((cost - here) / (0.5 * (fall + rise)) - 1.0).abs() < 1e-12);
    assert!(rise > 0.0);
    // What is not a cost has no value.
    assert!(problem.apply(&beyond).is_err() && problem.jacobian(&beyond).is_err());
    // And before the first value there is nothing to turn back to.
    let nowhere = LeastSquares::new(dvector![2e3, 0.0], valley);
    let at = nowhere.start();
    assert!(nowhere.cost(&at).expect("a cost").is_infinite() && nowhere.gradient(&at).is_err());
}

/// ln x has its least square at 1; from 8 the first step of Gauss and Newton ends below zero.
#[test]
fn levenberg_and_marquardt_turn_back_too() {
    let logarithm =
        |x: &DVector<f64>| (x[0] > 0.0).then(|| (dvector![x[0].ln()], dmatrix![1.0 / x[0]]));
    let problem = LeastSquares::new(dvector![8.0], logarithm);
    assert!(8.0 + problem.gauss_newton_step().expect("a step")[0] < 0.0);
    let (problem, report) = LevenbergMarquardt::new().minimize(problem);
    assert!(
        report.termination.was_successful(),
        "{:?}",
        report.termination
    );
    assert!((problem.parameters()[0] - 1.0).abs() < 1e-8);
}

/// Single shooting: what stops a body in 100 steps with the least torque, by the gradient of the whole rollout.
#[test]
fn a_body_is_stopped_by_single_shooting() {
    let inertia = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
    let system = System::new(inertia, Torque::None).expect("a body");
    let spinning = Motion::at_rest().turning(Vector3::new(1.0, 0.5, -0.9));
    let problem = Objective::new(DVector::zeros(300), |x| {
        let torques: Vec<_> = x
            .as_slice()
            .chunks(3)
            .map(Vector3::from_column_slice)
            .collect();
        let rollout = Rollout::new(Rk4, system, spinning, 0.02, &torques).ok()?;
        let omega = rollout.states()[100].angular_velocity;
        let mut costs = vec![Vector6::zeros(); 101];
        costs[100].fixed_rows_mut::<3>(3).copy_from(&(omega * 1e4));
        let by_torques = rollout.gradient(&costs).torques;
        let gradient = DVector::from_iterator(300, by_torques.iter().flatten().copied());
        Some((
            omega.norm_squared() * 5e3 + x.norm_squared() * 0.01,
            gradient + x * 0.02,
        ))
    });
    let start = problem.start();
    let solver = LBFGS::new(MoreThuenteLineSearch::new(), 10)
        .with_tolerance_grad(1e-10)
        .expect("a tolerance");
    let run = Executor::new(problem, solver)
        .configure(|state| state.param(start).max_iters(200))
        .run()
        .expect("a run");
    let torques: Vec<_> = {
        let found = run.state().get_best_param().expect("a point");
        found
            .as_slice()
            .chunks(3)
            .map(Vector3::from_column_slice)
            .collect()
    };
    let end = Rollout::new(Rk4, system, spinning, 0.02, &torques)
        .expect("a motion")
        .states()[100];
    assert!(
        end.angular_velocity.norm() < 1e-4,
        "{}",
        end.angular_velocity
    );
    // A torque that is constant in space stops the angular momentum along a straight line: nothing does it for less.
    let momentum = inertia * spinning.angular_velocity;
    let least = momentum.norm_squared() / (100.0 * 0.02 * 0.02);
    let squares: f64 = torques.iter().map(Vector3::norm_squared).sum();
    assert!(
        (squares / least - 1.0).abs() < 1e-3,
        "{squares} for {least}"
    );
}
