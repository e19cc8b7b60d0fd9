//! How bodies move: each step and each exact motion, their derivatives, and what they keep.

mod motion {
    mod cases;
    mod dop853;
    mod double_double;
    mod elliptic;
    mod flow_jacobian;
    mod free_body;
    mod geometric;
    mod numbers_and_limits;
    mod objectivity;
    mod parameters;
    mod quaternions;
    mod rollout;
    mod scales;
    mod sines;
    mod step_jacobian;
    mod step_products;
    mod tableau;
    mod taylor;
    mod turning;
}
