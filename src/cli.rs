//! The command line: arguments, files in, text out, exit codes.

use clap::{CommandFactory, Parser, Subcommand};
use std::process::ExitCode;

mod bench;
mod certificates;
mod chart;
mod check;
mod declare;
mod derive;
mod explain;
mod grade;
mod help;
mod input;
mod output;
mod plot;
mod run;
mod stress;

/// Checks derivations in rigid-body rotation, and gives exact, fast Jacobians of the same equations.
#[derive(Debug, Parser)]
#[command(
    name = "polhode",
    version,
    arg_required_else_help = true,
    disable_help_subcommand = true
)]
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
    Grade(grade::Options),
    Run(run::Options),
    Explain(explain::Options),
    Plot(plot::Options),
    Bench(bench::Options),
    Stress(stress::Options),
    Help(help::Options),
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
        Command::Bench(options) => bench::run(options, color),
        Command::Check(options) => check::run(options, color),
        Command::Grade(options) => grade::run(options, color),
        Command::Derive(options) => derive::run(options, color),
        Command::Explain(options) => explain::run(options, color),
        Command::Help(options) => help::run(options, Arguments::command(), color),
        Command::Run(options) => run::run(options, color),
        Command::Plot(options) => plot::run(options, color),
        Command::Stress(options) => stress::run(options, color),
    };
    ExitCode::from(code)
}
