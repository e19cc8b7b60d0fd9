//! `polhode run`.

use crate::cli::input;
use crate::cli::output::{self, failed};
use crate::diagnostic::Diagnostic;
use crate::report::terminal;
use crate::scene::{self, Costs, RunError, Scene, Seam, simulate_from};
use crate::source::Source;
use anstream::ColorChoice;
use clap::{Args, ValueEnum};
use resume::{Disagrees, Earlier};
use std::io;
#[cfg(feature = "parquet")]
use std::io::IsTerminal;
use std::path::{Path, PathBuf};
use target::Target;
use writer::Writer;

mod csv;
mod json;
#[cfg(feature = "parquet")]
mod parquet;
mod progress;
mod resume;
mod target;
mod text;
mod writer;

/// Simulates a scene, with the Jacobian of its end if that is asked for
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode run top.toml
  polhode run top.toml --format csv --out top.csv
  polhode run top.toml --format csv --out top.csv --resume top.csv

What can be written in a scene: polhode help scene

Exit code: 0 the run is complete and within its tolerance, 2 the scene can't be run, 3 a body may
be off by more than the tolerance, 130 stopped by Ctrl-C: what is written then is complete up to
the time said.")]
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
    /// Plan by the costs of this machine, a file of `polhode bench --costs` [default: those of a common server]
    #[arg(long, value_name = "FILE")]
    costs: Option<PathBuf>,
    /// Go on from an earlier result (CSV) of the same scene that was stopped; the result is that of a run in one piece
    #[arg(long, value_name = "RESULT")]
    resume: Option<PathBuf>,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, ValueEnum)]
enum Form {
    Text,
    Json,
    Csv,
    #[cfg(feature = "parquet")]
    Parquet,
}

impl Form {
    fn writer(self) -> Box<dyn writer::Form> {
        match self {
            Self::Text => Box::new(text::Text::default()),
            Self::Json => Box::new(json::Json::default()),
            Self::Csv => Box::new(csv::Csv::default()),
            #[cfg(feature = "parquet")]
            Self::Parquet => Box::new(parquet::Parquet::default()),
        }
    }
}

/// Reads a scene, and the costs by which it is planned; says what is wrong with them, and returns the exit code for that.
pub(super) fn load(path: &Path, costs: Option<&Path>, color: ColorChoice) -> Result<Scene, u8> {
    let mut scene = parsed(path, scene::read, color)?;
    if let Some(costs) = costs {
        scene.run.costs = parsed(costs, Costs::read, color)?;
    }
    Ok(scene)
}

fn parsed<T>(
    path: &Path,
    read: impl Fn(&Source) -> Result<T, Vec<Diagnostic>>,
    color: ColorChoice,
) -> Result<T, u8> {
    let name = input::name(path);
    let text = input::read(path).map_err(|error| failed(&format!("{name}: {error}")))?;
    let source = Source::new(name, text);
    read(&source).map_err(|diagnostics| {
        complain(&source, &diagnostics, color);
        2
    })
}

fn complain(source: &Source, diagnostics: &[Diagnostic], color: ColorChoice) {
    output::say(&terminal::diagnostics(source, diagnostics), color);
}

/// Runs the scene and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    if let Some(reason) = options.misuse() {
        return failed(reason);
    }
    let scene = match load(&options.scene, options.costs.as_deref(), color) {
        Ok(scene) => scene,
        Err(code) => return code,
    };
    let earlier = match options
        .resume
        .as_deref()
        .map(|path| Earlier::open(path, &scene))
    {
        Some(Err(error)) => {
            let path = options.resume.as_deref().map_or(String::new(), input::name);
            return failed(&format!("{path}: {error}"));
        }
        Some(Ok(earlier)) => Some(earlier),
        None => None,
    };
    progress::listen();
    let written = match write(options, &scene, earlier) {
        Err(RunError::Sink(error)) if error.get_ref().is_some_and(|e| e.is::<Disagrees>()) => {
            eprintln!("warning: {error}: all is computed again");
            write(options, &scene, None)
        }
        written => written,
    };
    match written {
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
            failed(&format!("{subject}: {error}"))
        }
    }
}

impl Options {
    /// What is wrong with the options together.
    fn misuse(&self) -> Option<&'static str> {
        if self.resume.is_some() && self.format != Form::Csv {
            return Some("--resume goes on with a result as CSV: add `--format csv`");
        }
        // What was copied before a row disagrees can be taken back from a file alone.
        if self.resume.is_some() && self.out.is_none() {
            return Some("--resume writes the whole result to a file: add `--out PATH`");
        }
        #[cfg(feature = "parquet")]
        if self.format == Form::Parquet && self.out.is_none() && io::stdout().is_terminal() {
            return Some("Parquet is not for a terminal: add `--out PATH`");
        }
        None
    }
}

fn write(
    options: &Options,
    scene: &Scene,
    earlier: Option<Earlier>,
) -> Result<u8, RunError<io::Error>> {
    let mut target = Target::open(options.out.as_deref()).map_err(RunError::Sink)?;
    let mut form = options.format.writer();
    let mut from = Seam::default();
    if let Some(earlier) = earlier {
        from = earlier.from;
        form = Box::new(earlier.go_on(form, &mut target).map_err(RunError::Sink)?);
    }
    let mut writer = Writer::new(form, target, scene);
    let complete = simulate_from(scene, from, &mut writer)?;
    writer.finish(complete).map_err(RunError::Sink)
}
