//! Many bodies side by side: a program of its own, as its kernels are compiled for each kind of registers.
#![cfg(feature = "batch")]

mod motion {
    mod batch;
    mod cases;
}
