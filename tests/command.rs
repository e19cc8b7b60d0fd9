//! The command as a user runs it, and the files that it writes.
#![cfg(feature = "cli")]

mod command {
    mod bad_input;
    mod bad_scenes;
    mod certificate_files;
    mod cli;
    mod declared;
    mod derive;
    mod derive_code;
    mod derive_numbers;
    mod derive_systems;
    mod drawing;
    mod multiply_out;
    mod resume;
    mod run;
    mod start;
    #[cfg(feature = "parquet")]
    mod trajectories;
}
