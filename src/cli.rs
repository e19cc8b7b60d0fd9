//! The command line: arguments, files in, text out, exit codes.

use clap::{Parser, Subcommand};
use std::process::ExitCode;

mod certificates;
mod check;
mod derive;
mod explain;
mod input;
mod output;
mod run;

/// Checks derivations in rigid-body rotation, and gives exact, fast Jacobians of the same equations.
#[derive(Debug, Parser)]
#[command(name = "polhode", version, arg_required_else_help = true)]
struct Arguments {
    #[command(subcommand)]
    command: Command,
    /// When to colour what is written to the terminal
    #[arg(long, global = true, value_enum, default_value_t = clap::ColorChoice::Auto)]
    color: clap::ColorChoice,
}

#[derive(Debug, Subcommand)]
enum Command {
    Check(check::Options),
    Derive(derive::Options),
    Explain(explain::Options),
    Run(run::Options),
}

/// Runs the command with the arguments of this process.
pub fn run() -> ExitCode {
    let arguments = Arguments::parse();
    let color = match arguments.color {
        clap::ColorChoice::Auto => anstream::ColorChoice::Auto,
        clap::ColorChoice::Always => anstream::ColorChoice::Always,
        clap::ColorChoice::Never => anstream::ColorChoice::Never,
    };
    let code = match &arguments.command {
        Command::Check(options) => check::run(options, color),
        Command::Derive(options) => derive::run(options, color),
        Command::Explain(options) => explain::run(options, color),
        Command::Run(options) => run::run(options, color),
    };
    ExitCode::from(code)
}
