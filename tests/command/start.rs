//! The command as a user runs it.

use std::path::Path;
use std::process::{Command, Output, Stdio};

/// What comes of `polhode` with these arguments, in a folder.
pub(crate) fn polhode(folder: &Path, arguments: &[&str]) -> Output {
    Command::new(env!("CARGO_BIN_EXE_polhode"))
        .args(arguments)
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("the command starts")
}
