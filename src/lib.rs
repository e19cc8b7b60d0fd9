//! Checks derivations in rigid-body rotation, and gives exact, fast Jacobians of the same equations.
//!
//! The rigid-body equation ΣM = (dL/dt)_body + ω × L with L = I ω is written once, as one generic
//! function. Run it on `f64` and it simulates, on dual numbers and it gives Jacobians, on polynomials and
//! it prints the derivation, on a prime field or on exact rationals and it decides whether a line that
//! somebody wrote by hand is true.
//!
//! A step and its Jacobian:
//!
#![doc = concat!("```\n", include_str!("../examples/step_jacobian.rs"), "```")]
//!
//! Each line of a document, with the feature `verify`:
//!
//! ```
//! # #[cfg(feature = "verify")] {
//! use polhode::notation::{document::Format, read};
//! use polhode::verify::{Verdict, check};
//!
//! let text = r"On principal axes $M_x = I_x\dot\omega_x - (I_y - I_z)\omega_y\omega_z$.";
//! let (document, _) = read("notes.md", text, Format::Markdown);
//! assert!(matches!(check(&document).findings[0].verdict, Verdict::Proved(_)));
//! # }
//! ```
//!
//! The modules import in one direction:
//!
//! ```text
//! source ─ diagnostic ─ notation ─┐
//!                                 ├─ algebra ─┐
//! scalar ─────────────────────────┘           ├─ verify ─ grade ─ report ─ cli
//! scalar ─ mechanics ─────────────────────────┘
//!             └─ motion (state, step, Jacobian, batch) ┬ scene ─ bench
//!                                                      └ jacobian, audit (checks of code), emit (code), optimise
//! ```

/// Linear algebra in the version that this crate speaks.
pub use nalgebra;
/// Dual numbers in the version that this crate speaks.
pub use num_dual;

pub mod audit;
pub mod jacobian;
pub mod mechanics;
pub mod motion;
pub mod optimise;
pub mod scalar;

#[cfg(feature = "verify")]
pub mod algebra;
#[cfg(feature = "bench")]
pub mod bench;
#[cfg(feature = "cli")]
pub mod cli;
#[cfg(any(feature = "verify", feature = "scene"))]
pub mod diagnostic;
#[cfg(feature = "emit")]
pub mod emit;
#[cfg(feature = "verify")]
pub mod grade;
#[cfg(feature = "verify")]
pub mod notation;
#[cfg(feature = "verify")]
#[doc(hidden)]
pub mod recent;
#[cfg(feature = "cli")]
pub mod report;
#[cfg(feature = "scene")]
pub mod scene;
#[cfg(any(feature = "verify", feature = "scene"))]
pub mod source;

#[cfg(feature = "verify")]
pub mod verify;
