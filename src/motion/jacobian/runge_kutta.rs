//! The Jacobian of the classical Runge–Kutta step, backwards through its four stages.
//!
//! Six rows go back through the stages instead of sixteen columns forward. What symmetry knows is written
//! down: under a torque that does not look at the attitude the step commutes with turns of space, so
//! ∂θ'/∂θ is the turn of the step and ∂ω'/∂θ is 0. A change δI of the tensor acts as the moment
//! −(δI α + ω × δI ω), so the inverse is never differentiated and repeated moments are nothing special.
//!
//! Under a torque that looks at the attitude a turn of the start is felt in every stage, and the way back takes a covector of the
//! attitude along. Of the law no more is asked than its torque and the derivatives of that at the four stages.
//!
//! The way back is written once, over plain arithmetic: in registers that hold the rows of one Jacobian, in registers
//! that hold the same row of many bodies, and for a single covector. Everything is inlined into the code for the machine
//! at hand; without optimisation the largest functions are not, for their values would not fit on the stack together.

pub(super) mod algebra;
mod alone;
mod along;
mod back;
mod block;
mod moments;
mod products;
mod rows;
mod stages;
pub(super) mod tensor;

pub(crate) use block::block_with_jacobian;
pub(crate) use products::{Felt, felt, jvp, vjp};
pub(crate) use rows::step_with_jacobian;
