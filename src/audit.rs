//! Dynamics code under audit: which rigid-body equation does it really integrate?
//!
//! Give it your acceleration function or your time step and the inertia tensor that the body is meant to have. It runs the
//! function on motions in general position, compares what comes out with the equation and with the ways in which it is often
//! got wrong, and says in words which one it is.
//!
//! ```
//! use nalgebra::{Matrix3, Vector3};
//! use polhode::audit::{self, Finding, Gyroscopic};
//!
//! let inertia = Matrix3::new(0.6, 0.02, -0.03, 0.02, 0.8, 0.05, -0.03, 0.05, 1.0);
//! let inverse = inertia.try_inverse().expect("a body");
//! // Forgotten: −ω × Iω.
//! let audit = audit::acceleration(|_omega, torque| inverse * torque, &inertia)?;
//! assert_eq!(audit.findings(), [Finding::Gyroscopic(Gyroscopic::Missing)]);
//! assert!(audit.to_string().contains("ω × Iω is missing"));
//! # Ok::<(), polhode::motion::MotionError>(())
//! ```
//!
//! A step is audited at its own length: what it does as the length goes to zero tells which equation it integrates, and a
//! free run at its full length tells whether it is stable, with the drift of energy and of the momentum in space as witnesses.
//! See [`step()`].

mod acceleration;
mod finding;
mod limit;
mod model;
mod run;
mod step;

pub use acceleration::acceleration;
pub use finding::{Audit, Finding, Gyroscopic, Turning, Unseen, Where, Witnesses};
pub use step::step;
