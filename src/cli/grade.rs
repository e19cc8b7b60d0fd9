//! `polhode grade`.

use crate::cli::{input, output};
use crate::grade::{Graded, Key, mark, not_marked};
use crate::notation::document::Format;
use crate::report;
use anstream::ColorChoice;
use clap::Args;
use folder::Pending;
use rayon::prelude::*;
use std::fs;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};

mod folder;

/// What a thread may put on its stack: trees of formulas are walked down.
const STACK: usize = 64 << 20;

/// Marks a class of derivations against your own, the key
#[derive(Args, Debug)]
#[command(after_help = "\
Example:
  polhode grade --check-key key.md
  polhode grade key.md submissions --out marked

The key is a derivation that says in its front matter what it means and what its lines are worth:

  ---
  marks: {\"(2)\": 2, \"(5)\": 3}
  follow_through: full      # full, half or none
  working: required         # required or optional
  polhode:
  - N is an inertial frame.
  ---

A submission is a file, or a folder of files; its name is the student. polhode help language has the sentences.
The folder that --out names gets results.json.

Exit code: 0 all work is marked, 3 someone waits for a person, 2 the key or the submissions can't be used")]
pub(super) struct Options {
    /// The instructor's derivation (.md, .tex, .ipynb, .txt)
    #[arg(value_name = "KEY")]
    key: PathBuf,
    /// A folder with a file or a folder for each student
    #[arg(value_name = "SUBMISSIONS", required_unless_present = "check_key")]
    submissions: Option<PathBuf>,
    /// The folder to write into; it is made if it is not there
    #[arg(long, value_name = "DIR", required_unless_present = "check_key")]
    out: Option<PathBuf>,
    /// Prove the key, list what it gives marks for, and mark nothing
    #[arg(long, conflicts_with_all = ["submissions", "out"])]
    check_key: bool,
    /// How many submissions to mark at a time [default: as many as there are processors]
    #[arg(long, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    threads: Option<u16>,
}

/// Marks the class and returns the exit code.
pub(super) fn run(options: &Options, color: ColorChoice) -> u8 {
    let key = match key(&options.key) {
        Ok(key) => key,
        Err(code) => return code,
    };
    if options.check_key {
        return output::deliver(&milestones(&key), None, color);
    }
    let (Some(submissions), Some(out)) = (&options.submissions, &options.out) else {
        return 2;
    };
    match class(&key, submissions, out, options) {
        Ok(students) => {
            let waiting = students.iter().filter(|s| s.queue.is_some()).count();
            let text = format!(
                "marked {}, of which {waiting} wait for a person\n",
                students.len()
            );
            match output::deliver(&text, None, color) {
                0 if waiting > 0 => 3,
                code => code,
            }
        }
        Err(error) => output::failed(&error),
    }
}

/// The key, if it can be used; else says why not and returns the exit code.
fn key(path: &Path) -> Result<Key, u8> {
    let name = input::name(path);
    let text = input::read(path).map_err(|error| output::failed(&format!("{name}: {error}")))?;
    let format = match path.as_os_str() == "-" {
        true => Format::Markdown,
        false => Format::of_path(path),
    };
    let short = path
        .file_name()
        .map_or(name.clone(), |name| name.to_string_lossy().into_owned());
    Key::read(&short, &text, format).map_err(|reasons| {
        for reason in reasons {
            eprintln!("error: {name}: {reason}");
        }
        2
    })
}

fn milestones(key: &Key) -> String {
    let lines = key
        .milestones()
        .map(|(label, marks)| format!("{label}: {marks}\n"));
    format!("{}{} in all\n", lines.collect::<String>(), key.max())
}

fn class(
    key: &Key,
    submissions: &Path,
    out: &Path,
    options: &Options,
) -> Result<Vec<Graded>, String> {
    let failed =
        |path: &Path, error: &dyn std::fmt::Display| format!("{}: {error}", input::name(path));
    let pending = folder::pending(submissions).map_err(|error| failed(submissions, &error))?;
    if pending.is_empty() {
        return Err(failed(submissions, &"there is nothing in it to mark"));
    }
    fs::create_dir_all(out).map_err(|error| failed(out, &error))?;
    let students = marked(key, &pending, options.threads)?;
    let text = report::grade::results(key, &students).map_err(|error| error.to_string())?;
    let path = out.join("results.json");
    output::replace(&path, &text).map_err(|error| failed(&path, &error))?;
    Ok(students)
}

/// Marks each submission, several at a time; what breaks down hurts no other.
fn marked(key: &Key, pending: &[Pending], threads: Option<u16>) -> Result<Vec<Graded>, String> {
    let pool = rayon::ThreadPoolBuilder::new()
        .num_threads(threads.map_or(0, usize::from))
        .stack_size(STACK)
        .build()
        .map_err(|error| error.to_string())?;
    let hook = panic::take_hook();
    panic::set_hook(Box::new(|_| {}));
    // A key keeps notes while it is read: each thread has one of its own.
    let own = key.clone();
    let students = pool.install(|| {
        let each = pending.par_iter();
        each.map_with(own, |key, one| marked_one(key, one))
            .collect()
    });
    panic::set_hook(hook);
    Ok(students)
}

fn marked_one(key: &Key, pending: &Pending) -> Graded {
    let work = match pending.read() {
        Ok(work) => work,
        Err(reason) => return not_marked(key, &pending.id, &reason),
    };
    let graded = panic::catch_unwind(AssertUnwindSafe(|| mark(key, &work)));
    graded.unwrap_or_else(|_| {
        not_marked(
            key,
            &pending.id,
            "marking it broke down; please report this",
        )
    })
}
