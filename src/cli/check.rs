//! `polhode check`.

use crate::cli::output::PageForm as Form;
use crate::cli::{certificates, declare, input, output};
use crate::diagnostic::Severity;
use crate::notation::{self, document::Format};
use crate::report::{Checked, Failure, html, json, terminal};
use crate::verify::{self, Sheet};
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

  polhode check --declare meaning.txt notes.tex
  polhode check --meaning notes.md
  polhode check --format html --out notes.html notes.md

Sentences in the front matter, under `polhode:`, say what a document means; then its lines are judged by
them alone. polhode help language has the sentences.

Exit code: 0 every line is proved or accepted, 1 a line is refuted, 2 an input can't be read,
3 nothing is refuted but a line is undecided or unreadable, or a sentence that declares something is not understood.

What can be written, and what it is read as: polhode help notation")]
pub(super) struct Options {
    /// Documents (.md, .rst, .tex, .ipynb, .txt), or - for standard input
    #[arg(required = true, value_name = "FILE")]
    files: Vec<PathBuf>,
    /// Text for the terminal, JSON for programs, or a page
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
    /// Sentences that say what the documents mean, one a line; beside those in their front matter
    #[arg(long, value_name = "FILE")]
    declare: Vec<PathBuf>,
    /// Print what the documents are taken to mean, as sentences for their front matter, and no verdicts
    #[arg(long)]
    meaning: bool,
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
    let inputs = || options.files.iter().chain(&options.declare);
    if let Some(out) = &options.out
        && inputs().any(|file| same(file, out))
    {
        eprintln!(
            "error: {} is an input; --out would overwrite it",
            input::name(out)
        );
        return 2;
    }
    let (sheets, mut failures) = declare::sheets(&options.declare);
    let mut checked = vec![];
    if failures.is_empty() {
        for path in &options.files {
            match input::read(path) {
                Ok(text) => {
                    let (one, wrong) = check(path, &text, options.kind, &sheets, color);
                    checked.push(one);
                    failures.extend(wrong);
                }
                Err(error) => failures.push(declare::failure(path, &error.to_string())),
            }
        }
    }
    // What has a place was drawn there.
    for failure in failures.iter().filter(|failure| failure.place.is_none()) {
        eprintln!("error: {}: {}", failure.path, failure.message);
    }
    if let Some(folder) = &options.certificate {
        match certificates::deliver(&checked, folder) {
            0 => {}
            failed => return failed,
        }
    }
    let text = match written(options, &checked, &failures) {
        Ok(text) => text,
        Err(error) => return output::failed(&error.to_string()),
    };
    match output::deliver(&text, options.out.as_deref(), color) {
        0 if failures.iter().any(|failure| failure.place.is_none()) => 2,
        0 if options.meaning && options.format == Form::Text && failures.is_empty() => 0,
        0 if options.meaning && options.format == Form::Text => 3,
        0 => code(&checked, &failures),
        failed => failed,
    }
}

/// The report in the form that was asked for.
fn written(
    options: &Options,
    checked: &[Checked],
    failures: &[Failure],
) -> serde_json::Result<String> {
    let drawn = checked
        .iter()
        .map(|checked| terminal::check(checked, options.verbose));
    match options.format {
        Form::Text if options.meaning => Ok(declare::meaning(checked)),
        Form::Text => Ok(drawn.collect::<Vec<_>>().join("\n")),
        Form::Json => json::check(checked, failures),
        Form::Html => Ok(html::check(checked)),
    }
}

/// Checks one document: by what is declared of it, or as its words have it where nothing is. Also returns the sentences
/// that were not understood.
fn check(
    path: &Path,
    text: &str,
    kind: Option<Kind>,
    sheets: &[Sheet],
    color: ColorChoice,
) -> (Checked, Vec<Failure>) {
    let format = match kind {
        Some(kind) => kind.format(),
        None if path.as_os_str() == "-" => Format::Markdown,
        None => Format::of_path(path),
    };
    let said = sheets.iter().flat_map(|sheet| &sheet.sentences);
    let said: Vec<&str> = said.map(|sentence| sentence.text.as_str()).collect();
    let name = input::name(path);
    let (document, diagnostics) = notation::read_declared(&name, text, format, &said);
    let declared = verify::declarations(&document, sheets);
    let misunderstood = declare::misunderstood(&document, sheets, &declared, color);
    let report = match declared.is_empty() {
        true => verify::check(&document),
        false => verify::check_declared(&document, &declared),
    };
    let mut checked = Checked {
        document,
        diagnostics,
        report,
    };
    declare::warn_of_unused(&mut checked, sheets, &declared, color);
    (checked, misunderstood)
}

/// Whether two paths name one existing file.
fn same(one: &Path, other: &Path) -> bool {
    match (fs::canonicalize(one), fs::canonicalize(other)) {
        (Ok(one), Ok(other)) => one == other,
        _ => false,
    }
}

/// 1 where a line is refuted, 3 where one is open or a sentence is not understood, 0 otherwise.
fn code(checked: &[Checked], misunderstood: &[Failure]) -> u8 {
    let summaries: Vec<_> = checked.iter().map(|c| c.report.summary()).collect();
    let mut diagnostics = checked.iter().flat_map(|c| &c.diagnostics);
    if summaries.iter().any(|s| s.refuted > 0) {
        1
    } else if summaries.iter().any(|s| s.undecided + s.unreadable > 0)
        || diagnostics.any(|d| d.severity == Severity::Error)
        || !misunderstood.is_empty()
    {
        3
    } else {
        0
    }
}
