//! The examples of optimisation, run: they find what is true, and say rightly how well they know it.
#![cfg(all(feature = "argmin", feature = "levenberg-marquardt"))]

#[path = "../examples/identify_inertia.rs"]
#[allow(dead_code, unreachable_pub, reason = "it is a program of its own")]
mod identify_inertia;
#[path = "../examples/lqr.rs"]
#[allow(dead_code, unreachable_pub, reason = "it is a program of its own")]
mod lqr;
#[path = "../examples/slew.rs"]
#[allow(dead_code, unreachable_pub, reason = "it is a program of its own")]
mod slew;

mod optimise {
    mod hanging_body;
    mod identification;
    mod regulator;
    mod shooting;
    mod solvers;
}
