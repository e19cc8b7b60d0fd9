//! How a rigid body moves: its state, the torque on it, steps in time, and the Jacobian of a step.
//!
//! Everything stands in body axes unless it says otherwise: SI units, unit quaternions scalar first and from
//! body to space, the tangent of a [`State`] in the order (θx, θy, θz, ωx, ωy, ωz) with q ⊞ θ = q exp(θ/2).
//!
//! A [`System`] is a body and its [`TorqueLaw`], over any [`Number`]. A [`Scheme`] takes one step of it,
//! and a [`FixedStep`] repeats the step to a given time. Run the same step on dual numbers and it gives its
//! own Jacobian: [`jacobian::by_dual_numbers`].
//!
//! Kernels are inlined by force only where assertions are off: registers need it, and a build with assertions would take
//! five times as long for nothing.
//!
//! ```
//! use nalgebra::{Matrix3, Vector3};
//! use polhode::motion::{FixedStep, Rk4, State, Stepper, System, Torque};
//!
//! let inertia = Matrix3::from_diagonal(&Vector3::new(0.6, 0.8, 1.0));
//! let system = System::new(inertia, Torque::None)?;
//! let start = State::at_rest().turning(Vector3::new(3.0, 0.5, -0.9));
//! let mut run = FixedStep::new(Rk4, system, start, 0.001)?;
//! run.advance_to(1.0)?;
//! assert!((run.state().attitude.norm_squared() - 1.0).abs() < 1e-15);
//! # Ok::<(), polhode::motion::MotionError>(())
//! ```

#[cfg(feature = "batch")]
mod batch;
mod block;
mod body;
mod cayley;
mod dop853;
mod error;
mod free_body;
mod implicit_midpoint;
mod moser_veselov;
mod number;
mod quaternion;
mod registers;
mod rk4;
mod rollout;
mod sines;
mod splitting;
mod state;
mod stepper;
mod symplectic;
mod system;
mod tangent;
mod taylor;
mod torque;

pub mod jacobian;

#[cfg(feature = "batch")]
pub use batch::{Batch, Jacobians};
pub use block::{Block, LANES, Lane, Tensors};
pub use body::Body;
pub use dop853::{Dop853, Dop853Motion};
pub use error::MotionError;
pub use free_body::{FreeBody, FreeMotion};
pub use implicit_midpoint::ImplicitMidpoint;
pub use jacobian::StepJacobian;
pub use moser_veselov::MoserVeselov;
pub use number::Number;
pub use quaternion::Quaternion;
pub use rk4::Rk4;
pub use rollout::{Rollout, RolloutGradient};
pub use splitting::Splitting;
pub use state::{Rates, State};
pub use stepper::{FixedStep, Scheme, Stepper};
pub use system::System;
pub use tangent::{right_jacobian, right_jacobian_inverse};
pub use taylor::{Taylor, TaylorMotion};
pub use torque::{
    Coefficient, Frame, Later, Law, LinearTorque, SmoothLaw, SpaceLoad, Torque, TorqueLaw,
};
