//! `polhode check`.

use crate::cli::output::Form;
use crate::cli::{certificates, input, output};
use crate::diagnostic::Severity;
use crate::notation::{self, document::Format};
use crate::report::{Checked, Failure, json, terminal};
use crate::verify;
use anstream::ColorChoice;
use clap::{Args, ValueEnum};
use std::fs;
use std::path::{Path, PathBuf};

/// Checks each line of a derivation: proved, refuted with numbers, or said to be open
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode check notes.md
  pbpaste | polhode check --as tex --format json -

Exit code: 0 every line is proved or accepted, 1 a line is refuted, 2 an input can't be read,
3 nothing is refuted but a line is undecided or unreadable.

What can be written, and what it is read as: polhode help notation")]
pub(super) struct Options {
    /// Documents (.md, .tex, .ipynb, .txt), or - for standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Text for people or JSON for programs
    #[arg(long, value_enum, default_value_t = Form::Text)]
    format: Form,
    /// Write to a file instead of the terminal
    #[arg(long, value_name = "PATH")]
    out: Option<PathBuf>,
    /// Write the proofs into a folder, as texts and as a Python script that checks them again
    #[arg(long, value_name = "DIR")]
    certificate: Option<PathBuf>,
    /// Read every input as this kind of document [default: by the file's ending, Markdown for standard input]
    #[arg(long = "as", value_enum, value_name = "KIND")]
    kind: Option<Kind>,
    /// Also quote the lines that hold and list what was not taken as a line
    #[arg(long)]
    verbose: bool,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Kind {
    Md,
    Tex,
    Ipynb,
    Txt,
}

impl Kind {
    fn format(self) -> Format {
        match self {
            Self::Md => Format::Markdown,
            Self::Tex => Format::Latex,
            Self::Ipynb => Format::Notebook,
            Self::Txt => Format::Text,
        }
    }
}

/// Checks the files and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    if let Some(out) = &options.out
        && options.files.iter().any(|file| same(file, out))
    {
        eprintln!(
            "error: {} is an input; --out would overwrite it",
            input::name(out)
        );
        return 2;
    }
    let (mut checked, mut failures) = (vec![], vec![]);
    for path in &options.files {
        match input::read(path) {
            Ok(text) => checked.push(check(path, &text, options.kind)),
            Err(error) => failures.push(Failure {
                path: input::name(path),
                message: error.to_string(),
            }),
        }
    }
    for failure in &failures {
        eprintln!("error: {}: {}", failure.path, failure.message);
    }
    if let Some(folder) = &options.certificate {
        match certificates::deliver(&checked, folder) {
            0 => {}
            failed => return failed,
        }
    }
    let text = match options.format {
        Form::Text => checked
            .iter()
            .map(|checked| terminal::check(checked, options.verbose))
            .collect::<Vec<_>>()
            .join("\n"),
        Form::Json => match json::check(&checked, &failures) {
            Ok(text) => text,
            Err(error) => {
                eprintln!("error: {error}");
                return 2;
            }
        },
    };
    match output::deliver(&text, options.out.as_deref(), color) {
        0 if failures.is_empty() => code(&checked),
        0 => 2,
        failed => failed,
    }
}

fn check(path: &Path, text: &str, kind: Option<Kind>) -> Checked {
    let format = match kind {
        Some(kind) => kind.format(),
        None if path.as_os_str() == "-" => Format::Markdown,
        None => Format::of_path(path),
    };
    let (document, diagnostics) = notation::read(&input::name(path), text, format);
    let report = verify::check(&document);
    Checked {
        document,
        diagnostics,
        report,
    }
}

/// Whether two paths name one existing file.
fn same(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}

/// 1 where a line is refuted, 3 where one is open, 0 otherwise.
fn code(checked: &[Checked]) -> u8 {
    let summaries: Vec<_> = checked.iter().map(|c| c.report.summary()).collect();
    let mut diagnostics = checked.iter().flat_map(|c| &c.diagnostics);
    if summaries.iter().any(|s| s.refuted > 0) {
        1
    } else if summaries.iter().any(|s| s.undecided + s.unreadable > 0)
        || diagnostics.any(|d| d.severity == Severity::Error)
    {
        3
    } else {
        0
    }
}
