//! Scenes: their files, the plan of a run, its accuracy, and the references that runs are measured against.
#![cfg(feature = "scene")]

mod scene {
    #[cfg(feature = "bench")]
    mod accuracy;
    #[cfg(feature = "bench")]
    mod bench;
    mod explain;
    mod files;
    mod quantities;
    mod spin;
    mod urdf;
}
