//! `polhode grade`.

use crate::cli::{input, output};
use crate::grade::Key;
use crate::notation::document::Format;
use crate::report::grade::{gradebook, told::Detail};
use anstream::ColorChoice;
use clap::{Args, ValueEnum};
use class::{Class, Part};
use names::Naming;
use regex_lite::Regex;
use roster::Roster;
use std::path::{Path, PathBuf};
use telling::{Page, Telling};

mod archive;
mod class;
mod folder;
mod intake;
mod journal;
mod lock;
mod names;
mod neighbours;
mod results;
mod roster;
mod telling;

/// Marks a class of derivations against your own, the key
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode grade --check-key key.md
  polhode grade key.md submissions --out marked --gradebook csv,moodle

The key is a derivation that says in its front matter what it means and what its lines are worth:

  ---
  marks: {\"(2)\": 2, \"(5)\": 3}
  follow_through: full      # full, half or none
  working: required         # required or optional
  shown: [\"(2)\"]            # milestones that need a line of their own
  rounding: 0.5             # a student's sum is rounded to a multiple of this
  most_rules: 2             # laws that a line may use at once which no line before it used; never fewer than the key's own
  polhode:
  - N is an inertial frame.
  ---

A submission is a file, a zip archive or a folder of files; its name is the student. SUBMISSIONS may be a zip archive of
submissions too. polhode help language has the sentences.

Where a platform puts more into names, a pattern finds the student in them:

  polhode grade key.md submissions.zip --out marked --id-pattern '_(\\d+)_' --roster class.csv

The folder that --out names gets results.json, class.html, a page for each student in feedback, and gradebooks.
A run that was stopped goes on where it was when it is started again, and a later run marks only what changed.

A large class can be marked in parts, on several machines that share the folder:

  polhode grade key.md submissions --out marked --shard 1/2
  polhode grade key.md submissions --out marked --shard 2/2
  polhode grade key.md --out marked --merge

Exit code: 0 all work is marked, 3 someone waits for a person, 2 the key or the submissions can't be used")]
pub(super) struct Options {
    /// The instructor's derivation (.md, .rst, .tex, .ipynb, .txt)
    #[arg(value_name = "KEY")]
    key: PathBuf,
    /// A folder, or a zip archive, with a file, an archive or a folder for each student
    #[arg(value_name = "SUBMISSIONS", required_unless_present_any = ["check_key", "merge"])]
    submissions: Option<PathBuf>,
    /// The folder to write into; it is made if it is not there
    #[arg(long, value_name = "DIR", required_unless_present = "check_key")]
    out: Option<PathBuf>,
    /// Prove the key, list what it gives marks for, and mark nothing
    #[arg(long, conflicts_with_all = ["submissions", "out"])]
    check_key: bool,
    /// What students are told
    #[arg(long, value_enum, default_value_t = Feedback::Full)]
    feedback: Feedback,
    /// The forms of the feedback for each student
    #[arg(
        long,
        value_enum,
        value_name = "FORM",
        value_delimiter = ',',
        default_value = "html"
    )]
    feedback_format: Vec<Page>,
    /// A folder of answers for single students: a file ID.txt has sentences, one a line
    #[arg(long, value_name = "DIR")]
    answers: Option<PathBuf>,
    /// A worksheet of a Moodle assignment, as downloaded; worksheet.csv is the same with the grades
    #[arg(long, value_name = "FILE")]
    worksheet: Option<PathBuf>,
    /// Also write gradebooks
    #[arg(long, value_enum, value_name = "FORM", value_delimiter = ',')]
    gradebook: Vec<Gradebook>,
    /// Find the id of a student in the name of a file or folder: the group called id, or the first group, or all that fits
    #[arg(long, value_name = "REGEX")]
    id_pattern: Option<Regex>,
    /// A CSV table of the students: who handed in nothing is listed, who is not in it waits for a person
    #[arg(long, value_name = "FILE")]
    roster: Option<PathBuf>,
    /// Mark only part I of N, for a later --merge
    #[arg(long, value_name = "I/N", value_parser = part, conflicts_with = "merge")]
    shard: Option<Part>,
    /// Put the parts that were marked together
    #[arg(long, conflicts_with_all = ["submissions", "check_key"])]
    merge: bool,
    /// How many submissions to mark at a time [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Feedback {
    /// The marks alone
    Marks,
    /// Also which lines hold
    Place,
    /// Also why not, and how the first wrong line should stand
    Full,
}

impl Feedback {
    fn detail(self) -> Detail {
        match self {
            Self::Marks => Detail::Marks,
            Self::Place => Detail::Place,
            Self::Full => Detail::Full,
        }
    }
}

#[derive(Clone, Copy, Debug, ValueEnum)]
enum Gradebook {
    Csv,
    Jsonl,
    Gradescope,
    Prairielearn,
    Moodle,
    Canvas,
    Coderunner,
    Points,
}

impl Gradebook {
    fn form(self) -> gradebook::Form {
        match self {
            Self::Csv => gradebook::Form::Csv,
            Self::Jsonl => gradebook::Form::Jsonl,
            Self::Gradescope => gradebook::Form::Gradescope,
            Self::Prairielearn => gradebook::Form::Prairielearn,
            Self::Moodle => gradebook::Form::Moodle,
            Self::Canvas => gradebook::Form::Canvas,
            Self::Coderunner => gradebook::Form::Coderunner,
            Self::Points => gradebook::Form::Points,
        }
    }
}

/// Reads `2/5`.
fn part(text: &str) -> Result<Part, String> {
    let numbers = text
        .split_once('/')
        .and_then(|(i, n)| Some((i.parse().ok()?, n.parse().ok()?)));
    match numbers {
        Some((number, of)) if 1 <= number && number <= of && of <= 100_000 => {
            Ok(Part { number, of })
        }
        _ => Err("write it as 2/5: part 2 of 5".to_owned()),
    }
}

/// Marks the class and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let (key, text) = match key(&options.key) {
        Ok(key) => key,
        Err(code) => return code,
    };
    let Some(out) = options.out.as_deref().filter(|_| !options.check_key) else {
        return output::deliver(&milestones(&key), None, color);
    };
    let roster = match options.roster.as_deref().map(Roster::read).transpose() {
        Ok(roster) => roster,
        Err(error) => return output::failed(&error),
    };
    let class = Class {
        key: &key,
        key_text: &text,
        out,
        telling: options.telling().and_those_in(out),
        naming: Naming::by(options.id_pattern.clone()),
        roster,
        answers: options.answers.clone(),
        worksheet: options.worksheet.clone(),
    };
    let done = match (&options.submissions, options.shard) {
        (None, _) => class.merge(),
        (Some(submissions), None) => class.mark(submissions, options.threads),
        (Some(submissions), Some(part)) => class.mark_part(submissions, part, options.threads),
    };
    match done {
        Ok(count) => match output::deliver(&format!("{count}\n"), None, color) {
            0 if count.waiting > 0 => 3,
            code => code,
        },
        Err(error) => output::failed(&error),
    }
}

impl Options {
    /// What students are told, in each form once.
    fn telling(&self) -> Telling {
        let mut gradebooks: Vec<_> = self.gradebook.iter().map(|form| form.form()).collect();
        gradebooks.sort_unstable();
        gradebooks.dedup();
        let mut pages = self.feedback_format.clone();
        pages.sort_unstable();
        pages.dedup();
        Telling {
            detail: self.feedback.detail(),
            pages,
            gradebooks,
        }
    }
}

/// The key with its text, if it can be used; else says why not and returns the exit code.
fn key(path: &Path) -> Result<(Key, String), u8> {
    let name = input::name(path);
    let text = input::read(path).map_err(|error| output::failed(&format!("{name}: {error}")))?;
    let format = match path.as_os_str() == "-" {
        true => Format::Markdown,
        false => Format::of_path(path),
    };
    let short = path
        .file_name()
        .map_or(name.clone(), |name| name.to_string_lossy().into_owned());
    match Key::read(&short, &text, format) {
        Ok(key) => Ok((key, text)),
        Err(reasons) => {
            for reason in reasons {
                eprintln!("error: {name}: {reason}");
            }
            Err(2)
        }
    }
}

fn milestones(key: &Key) -> String {
    let lines = key
        .milestones()
        .map(|(label, marks)| format!("{label}: {marks}\n"));
    format!("{}{} in all\n", lines.collect::<String>(), key.max())
}
