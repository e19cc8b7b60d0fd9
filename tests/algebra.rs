//! The scalars, exact algebra, and the equations of rotation on all of them.

mod algebra {
    #[cfg(feature = "verify")]
    mod agreement;
    #[cfg(feature = "verify")]
    mod certificates;
    #[cfg(feature = "verify")]
    mod laws;
    #[cfg(feature = "verify")]
    mod mechanics;
    #[cfg(feature = "verify")]
    mod principal_axes;
    mod scalars;
}
