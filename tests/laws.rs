//! Steps under laws of torque of one's own, and their derivatives: a program of its own, as each law makes the kernels anew.

mod motion {
    mod cases;
    mod laws;
}
