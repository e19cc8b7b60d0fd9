//! Jacobians written by hand: mistakes are found and named, and right ones are never blamed.

mod jacobian {
    mod black_box;
    mod causes;
    mod never_blamed;
    mod steps;
}
