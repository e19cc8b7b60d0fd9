//! Checks derivations in rigid-body rotation, and gives exact, fast Jacobians of the same equations.
//!
//! The rigid-body equation ΣM = (dL/dt)_body + ω × L with L = I ω is written once, as one generic
//! function. Run it on `f64` and it simulates, on dual numbers and it gives Jacobians, on polynomials and
//! it prints the derivation, on a prime field or on exact rationals and it decides whether a line that
//! somebody wrote by hand is true.
//!
//! ```text
//! source ─ diagnostic ─ notation ─┐
//!                                 ├─ algebra ─┐
//! scalar ─────────────────────────┘           ├─ verify ─ report ─ cli
//! scalar ─ mechanics ─────────────────────────┘
//!             └─ motion (state, step, Jacobian, batch) ─ scene ─ bench
//! ```

pub mod mechanics;
pub mod motion;
pub mod scalar;

#[cfg(feature = "verify")]
pub mod algebra;
#[cfg(feature = "bench")]
pub mod bench;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(any(feature = "verify", feature = "scene"))]
pub mod diagnostic;
#[cfg(feature = "verify")]
pub mod notation;
#[cfg(feature = "cli")]
pub mod report;
#[cfg(feature = "scene")]
pub mod scene;
#[cfg(any(feature = "verify", feature = "scene"))]
pub mod source;

#[cfg(feature = "verify")]
pub mod verify;
