//! `polhode run`.

use crate::cli::input;
use crate::diagnostic::Diagnostic;
use crate::report::terminal;
use crate::scene::{self, RunError, Scene, simulate};
use crate::source::Source;
use anstream::{AutoStream, ColorChoice};
use clap::{Args, ValueEnum};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use target::Target;
use writer::Writer;

mod csv;
mod json;
mod progress;
mod target;
mod text;
mod writer;

/// Simulates a scene, with the Jacobian of its end if that is asked for
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode run top.toml
  polhode run top.toml --format csv --out top.csv

Exit code: 0 the run is complete and within its tolerance, 2 the scene can't be run, 3 a body may be off by more than
the tolerance, 130 stopped by Ctrl-C: what is written then is complete up to the time said.")]
pub(super) struct Options {
    /// A scene (.toml), or - for standard input
    #[arg(value_name = "SCENE")]
    scene: PathBuf,
    /// Text for people, JSON or CSV for programs
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    Text,
    Json,
    Csv,
}

/// Reads a scene; says what is wrong with it, and returns the exit code for that.
pub(super) fn load(path: &Path, color: ColorChoice) -> Result<Scene, u8> {
    let name = input::name(path);
    let text = input::read(path).map_err(|error| {
        eprintln!("error: {name}: {error}");
        2
    })?;
    let source = Source::new(name, text);
    scene::read(&source).map_err(|diagnostics| {
        complain(&source, &diagnostics, color);
        2
    })
}

fn complain(source: &Source, diagnostics: &[Diagnostic], color: ColorChoice) {
    let text = terminal::diagnostics(source, diagnostics);
    let mut stream = AutoStream::new(io::stderr().lock(), color);
    // Nothing is left to complain to.
    let _ = stream.write_all(text.as_bytes());
}

/// Runs the scene and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let scene = match load(&options.scene, color) {
        Ok(scene) => scene,
        Err(code) => return code,
    };
    match write(options, &scene) {
        Ok(code) => code,
        Err(RunError::Sink(error)) if error.kind() == io::ErrorKind::BrokenPipe => 0,
        Err(error) => {
            let subject = match &error {
                RunError::Sink(_) => options
                    .out
                    .as_deref()
                    .map_or("standard output".to_owned(), input::name),
                _ => input::name(&options.scene),
            };
            eprintln!("error: {subject}: {error}");
            2
        }
    }
}

fn write(options: &Options, scene: &Scene) -> Result<u8, RunError<io::Error>> {
    let target = Target::open(options.out.as_deref()).map_err(RunError::Sink)?;
    let form: Box<dyn writer::Form> = match options.format {
        Form::Text => Box::new(text::Text::default()),
        Form::Json => Box::new(json::Json::default()),
        Form::Csv => Box::new(csv::Csv::default()),
    };
    let mut writer = Writer::new(form, target, scene);
    progress::listen();
    let complete = simulate(scene, &mut writer)?;
    writer.finish(complete).map_err(RunError::Sink)
}
