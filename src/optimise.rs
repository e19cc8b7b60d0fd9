//! Jacobians for optimisation: a guide, and what solvers need.
//!
//! # Which tangent space
//!
//! An attitude is no vector, and its derivative is taken in a perturbation θ. polhode perturbs on the body side,
//! q ⊞ θ = q exp(θ/2), before and after a step. A perturbation φ on the space side is exp(φ/2) q, φ = R θ with R the
//! rotation matrix of q: columns in θ are those in φ times R. A tangent of a [`State`](crate::motion::State) is (θ, ω), six
//! numbers, ω in body axes; [`perturbed`](crate::motion::State::perturbed) takes a state along a tangent,
//! [`difference`](crate::motion::State::difference) finds the tangent between two states, and both have their own derivatives
//! ([`difference_with_jacobians`](crate::motion::State::difference_with_jacobians)).
//!
//! # The derivative of a step, and of many
//!
//! [`step_with_jacobian`](crate::motion::Scheme::step_with_jacobian) gives ∂(θ', ω')/∂(θ, ω, torque, inertia, dt), as many
//! columns as are asked for, and the blocks by name: [`by_state`](crate::motion::StepJacobian::by_state),
//! [`by_torque`](crate::motion::StepJacobian::by_torque) and so on. [`crate::motion::jacobian`] has the conventions of each.
//!
//! | what is sought | what to take | what it costs |
//! | --- | --- | --- |
//! | the gradient of one cost in all torques | [`Rollout::gradient`](crate::motion::Rollout::gradient), [`Objective`] | no matrix: one product a step, backwards |
//! | and in damping, weight, arm, phase | [`Rollout::gradient_by_parameters`](crate::motion::Rollout::gradient_by_parameters) | the torque of each step on dual numbers besides |
//! | residuals of a fit of the inertia | [`Rollout::by_inertia`](crate::motion::Rollout::by_inertia) | one small product a step |
//! | of a fit of the start or a torque besides | [`from_start`] of [`Rollout::jacobians`](crate::motion::Rollout::jacobians) | a larger one |
//! | of a fit of damping, weight, arm, phase | [`Rollout::by_parameters`](crate::motion::Rollout::by_parameters) | each step on dual numbers besides |
//! | a motion with constraints | [`Nodes::defects`] | a banded matrix, as [`Csc`] for solvers |
//!
//! # A body that can exist
//!
//! An optimiser tries tensors that no body has. [`possible_inertia`](crate::mechanics::possible_inertia) takes six
//! log-Cholesky parameters instead: every real vector is a body, and the derivative of the tensor in them comes with it.
//! [`inertial_parameters`](crate::mechanics::inertial_parameters) does the same for mass, centre and tensor, ten numbers, where the
//! law has them: under gravity the arm is m c and the weight is g. Where a torque is not known either, only ratios of the moments
//! can be told.
//!
//! Where there is no motion at all, because a step is too long for it, the function that one hands to [`LeastSquares`] or
//! [`Objective`] returns `None`, and the solver turns back and tries a shorter step.
//!
//! # From gyroscope data to an inertia tensor
//!
//! ```
//! use nalgebra::{DMatrix, DVector, Vector3};
//! use polhode::mechanics::possible_inertia;
//! use polhode::motion::{Rk4, Rollout, State, System, Torque};
//! use polhode::optimise::LeastSquares;
//!
//! let start = State::at_rest().turning(Vector3::new(1.0, 0.5, -0.9));
//! let torques: Vec<_> = (0..40).map(|k| Vector3::new(0.3, (0.2 * k as f64).sin(), -0.2)).collect();
//! let run = |parameters: &DVector<f64>| {
//!     let tensor = possible_inertia(&parameters.fixed_rows::<6>(0).into_owned()).0;
//!     Rollout::new(Rk4, System::new(tensor, Torque::None)?, start, 0.02, &torques)
//! };
//! let truth = DVector::from_vec(vec![-0.6, -0.2, 0.3, 0.05, -0.04, 0.1]);
//! let measured = run(&truth)?;
//!
//! // What the guess misses, and its derivative: that of ω in the inertia times that of the inertia in the guess.
//! let residuals = |guess: &DVector<f64>| {
//!     let rollout = run(guess).ok()?;
//!     let (_, by_guess) = possible_inertia(&guess.fixed_rows::<6>(0).into_owned());
//!     let (mut missed, mut jacobian) = (DVector::zeros(120), DMatrix::zeros(120, 6));
//!     let states = rollout.states().iter().zip(measured.states()).skip(1);
//!     for (k, ((state, seen), by_inertia)) in states.zip(rollout.by_inertia()).enumerate() {
//!         let off = state.angular_velocity - seen.angular_velocity;
//!         missed.fixed_rows_mut::<3>(3 * k).copy_from(&off);
//!         let slopes = by_inertia.fixed_rows::<3>(3) * by_guess;
//!         jacobian.fixed_rows_mut::<3>(3 * k).copy_from(&slopes);
//!     }
//!     Some((missed, jacobian))
//! };
//! let guess = DVector::from_vec(vec![-0.5, -0.1, 0.2, 0.0, 0.0, 0.0]);
//! let problem = LeastSquares::new(guess, residuals);
//! for _ in 0..8 {
//!     let change = problem.gauss_newton_step().ok_or("the data do not determine the tensor")?;
//!     problem.go_to(problem.parameters() + change);
//! }
//! assert!((problem.parameters() - truth).norm() < 1e-9);
//! # Ok::<(), Box<dyn std::error::Error>>(())
//! ```
//!
//! # Solvers
//!
//! With the feature `levenberg-marquardt` the same problem goes to that crate, which finds its way from a worse start:
//! `LevenbergMarquardt::new().minimize(LeastSquares::new(guess, residuals))`. With the feature `argmin` it is a problem for the
//! solvers of that crate, from Gauss and Newton to L-BFGS, and so is an [`Objective`]; `problem.start()` is the first parameter. Both crates stand on
//! another nalgebra than this one, and no matrix has to be copied by hand. [`LeastSquares::covariance`] says how well the
//! parameters are known.
//!
//! Three programs in `examples/` go on from here, each a screenful: `identify_inertia` fits noisy data and states its
//! covariance, `slew` turns a satellite with the least effort by multiple shooting and quadratic programs of `clarabel`, `lqr`
//! holds a body on an unstable spin.
//!
//! # Derivatives of one's own
//!
//! [`crate::jacobian`] tells whether a Jacobian written by hand is right, and what is wrong with it; [`crate::audit`] does the same
//! for a whole time step. For a program in another language, `polhode derive --as c --of step-jacobian` writes the code.

#[cfg(feature = "argmin")]
mod argmin;
mod evaluated;
mod least_squares;
#[cfg(feature = "levenberg-marquardt")]
mod levenberg_marquardt;
mod objective;
#[cfg(any(feature = "argmin", feature = "levenberg-marquardt"))]
mod older;
mod shooting;
mod sparse;

pub use least_squares::LeastSquares;
pub use objective::Objective;
#[cfg(any(feature = "argmin", feature = "levenberg-marquardt"))]
pub use older::{OlderMatrix, OlderVector};
pub use shooting::Nodes;
pub use sparse::{Blocks, Csc};

use crate::motion::StepJacobian;

/// The derivatives of each step in the start and the parameters of the first one, from those of each step in its own: each is
/// chained to all before it by [`then`](StepJacobian::then).
pub fn from_start<const N: usize>(
    steps: impl IntoIterator<Item = StepJacobian<N>>,
) -> impl Iterator<Item = StepJacobian<N>> {
    let chain = |before: &mut Option<StepJacobian<N>>, step: StepJacobian<N>| {
        let whole = before.map_or(step, |before| before.then(&step));
        *before = Some(whole);
        *before
    };
    steps.into_iter().scan(None, chain)
}
