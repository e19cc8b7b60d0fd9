//! The command `polhode`.

use std::process::ExitCode;

fn main() -> ExitCode {
    polhode::cli::run()
}
