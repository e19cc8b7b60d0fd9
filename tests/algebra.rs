//! The scalars, exact algebra, and the equations of rotation on all of them.

mod algebra {
    #[cfg(feature = "verify")]
    mod agreement;
    mod bodies;
    #[cfg(feature = "verify")]
    mod certificates;
    mod equations;
    #[cfg(feature = "verify")]
    mod intervals;
    #[cfg(feature = "verify")]
    mod laws;
    #[cfg(feature = "verify")]
    mod mechanics;
    #[cfg(feature = "verify")]
    mod monomials;
    #[cfg(feature = "verify")]
    mod polynomials;
    #[cfg(feature = "verify")]
    mod principal_axes;
    #[cfg(feature = "verify")]
    mod print;
    mod scalars;
    mod shapes;
    #[cfg(feature = "verify")]
    mod surds;
}
