//! Marks all submissions of a folder and writes what comes of it.

use crate::cli::grade::folder::{HandedIn, Pending};
use crate::cli::grade::journal::{self, Journal, Place, Students, digest, parts};
use crate::cli::grade::lock::Lock;
use crate::cli::grade::names::{Naming, file_stem};
use crate::cli::grade::neighbours;
use crate::cli::grade::roster::Roster;
use crate::cli::grade::telling::Telling;
use crate::cli::{input, output};
use crate::grade::{Graded, Key, Work, mark, not_marked};
use crate::report::grade::told::Detail;
use indicatif::{ProgressBar, ProgressDrawTarget};
use rayon::prelude::*;
use std::fmt::{self, Display};
use std::fs;
use std::io;
use std::panic::{self, AssertUnwindSafe};
use std::path::{Path, PathBuf};

/// What a thread may put on its stack: trees of formulas are walked down.
const STACK: usize = 64 << 20;

/// One part of a class that is marked in several.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) struct Part {
    /// Which one, from 1.
    pub(super) number: usize,
    /// How many there are.
    pub(super) of: usize,
}

/// How many submissions were marked.
pub(super) struct Count {
    pub(super) marked: usize,
    pub(super) waiting: usize,
    /// How many of the roster handed in nothing.
    pub(super) missing: usize,
}

impl Display for Count {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let (marked, waiting) = (self.marked, self.waiting);
        write!(f, "marked {marked}, of which {waiting} wait for a person")?;
        match self.missing {
            0 => Ok(()),
            missing => write!(f, "; {missing} of the roster handed in nothing"),
        }
    }
}

/// What is marked by, and where to.
pub(super) struct Class<'a> {
    pub(super) key: &'a Key,
    pub(super) key_text: &'a str,
    pub(super) out: &'a Path,
    pub(super) telling: Telling,
    pub(super) naming: Naming,
    pub(super) roster: Option<Roster>,
    /// A folder with answers for single students.
    pub(super) answers: Option<PathBuf>,
    /// A worksheet to fill in.
    pub(super) worksheet: Option<PathBuf>,
}

/// What went wrong with a file.
pub(super) fn failed(path: &Path, error: &dyn Display) -> String {
    format!("{}: {error}", input::name(path))
}

impl Class<'_> {
    /// Marks all submissions.
    pub(super) fn mark(&self, submissions: &Path, threads: Option<u16>) -> Result<Count, String> {
        let handed_in = self.handed_in(submissions)?;
        let _lock = Lock::of_class(self.out)?;
        let path = self.out.join("journal.jsonl");
        let students = self.marked(&handed_in, Part { number: 1, of: 1 }, &path, threads)?;
        let missing = self.missing(handed_in.ids());
        neighbours::warn_of_pages(self.out, handed_in.ids());
        drop(handed_in);
        self.finish(&students, missing.as_deref())
    }

    /// Marks every n-th submission, and leaves the results for [`Class::merge`].
    pub(super) fn mark_part(
        &self,
        submissions: &Path,
        part: Part,
        threads: Option<u16>,
    ) -> Result<Count, String> {
        let handed_in = self.handed_in(submissions)?;
        let _lock = Lock::of_part(self.out, part)?;
        let path = self
            .out
            .join(format!("part-{}-of-{}.jsonl", part.number, part.of));
        let students = self.marked(&handed_in, part, &path, threads)?;
        journal::end(&path, self.stamp(), students.len())
            .and_then(|()| students.show(|all| Ok(all.filter(|s| s.queue.is_some()).count())))
            .map_err(|error| failed(&path, &error))
            .map(|waiting| Count {
                marked: students.len(),
                waiting,
                missing: 0,
            })
    }

    /// Puts together what was marked in parts.
    pub(super) fn merge(&self) -> Result<Count, String> {
        let mut journals = vec![];
        let paths = parts(self.out)?;
        let _lock = Lock::of_class(self.out)?;
        for path in paths {
            let journal = Journal::open(&path, self.stamp(), self.key)
                .map_err(|error| failed(&path, &error))?;
            if !journal.is_whole {
                return Err(failed(
                    &path,
                    &"this part is not marked to its end with this key",
                ));
            }
            journals.push(journal);
        }
        let (students, ids) = Students::of_parts(journals.into_iter(), self.out)?;
        neighbours::warn_of_pages(self.out, ids.iter().cloned());
        let missing = self.missing(ids.into_iter());
        self.finish(&students, missing.as_deref())
    }

    fn handed_in(&self, submissions: &Path) -> Result<HandedIn<'_>, String> {
        neighbours::refuse_same(submissions, self.out)?;
        let found = HandedIn::find(submissions, &self.naming);
        let found = found.map_err(|error| failed(submissions, &error))?;
        if found.len() == 0 {
            return Err(failed(submissions, &"there is nothing in it to mark"));
        }
        fs::create_dir_all(self.out).map_err(|error| failed(self.out, &error))?;
        if let Some(answers) = &self.answers {
            neighbours::warn_of_answers(answers, found.ids());
        }
        Ok(found)
    }

    /// What results depend on beside the submissions.
    fn stamp(&self) -> u64 {
        let version = env!("CARGO_PKG_VERSION");
        digest(
            [version, &self.key.name, self.key_text]
                .into_iter()
                .map(str::as_bytes),
        )
    }

    /// Marks each submission of a part, several at a time; what breaks down hurts no other. In the order of their ids, as
    /// which they stand in the journal too when all are marked.
    fn marked(
        &self,
        handed_in: &HandedIn<'_>,
        part: Part,
        path: &Path,
        threads: Option<u16>,
    ) -> Result<Students, String> {
        let journal = Journal::open(path, self.stamp(), self.key).and_then(|mut journal| {
            journal.begin()?;
            Ok(journal)
        });
        let journal = journal.map_err(|error| failed(path, &error))?;
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads.map_or(0, usize::from))
            .stack_size(STACK)
            .build()
            .map_err(|error| error.to_string())?;
        let first = part.number - 1;
        let all = (handed_in.len() + part.of - 1).saturating_sub(first) / part.of;
        let target = ProgressDrawTarget::stderr();
        let bar = ProgressBar::with_draw_target(Some(all as u64), target);
        // A key keeps notes while it is read: each thread has one of its own.
        let own = self.key.clone();
        let marking = Marking {
            out: self.out,
            telling: &self.telling,
            answers: self.answers.as_deref(),
            journal,
        };
        let roster = self.roster.as_ref();
        let hook = panic::take_hook();
        panic::set_hook(Box::new(|_| {}));
        let places = pool.install(|| {
            let each = (0..all).into_par_iter().map_with(own, |key, at| {
                let mut one = handed_in.student(first + at * part.of);
                if let Some(roster) = roster {
                    roster.mark_unknown(&mut one);
                }
                let place = marking.mark(key, &one)?;
                bar.inc(1);
                Ok(place)
            });
            each.collect::<Result<Vec<Place>, String>>()
        });
        panic::set_hook(hook);
        bar.finish_and_clear();
        let students = marking.journal.students(places?);
        journal::replace(path, &students).map_err(|error| failed(path, &error))?;
        Ok(students)
    }

    /// Who is on the roster and handed in nothing; none where there is no roster.
    fn missing(&self, ids: impl Iterator<Item = String>) -> Option<Vec<String>> {
        self.roster.as_ref().map(|roster| roster.missing(ids))
    }
}

/// What the threads share that mark a class: all but the key.
struct Marking<'a> {
    out: &'a Path,
    telling: &'a Telling,
    answers: Option<&'a Path>,
    journal: Journal,
}

impl Marking<'_> {
    /// Marks one submission, unless that was done before and all that was written for the student is there.
    fn mark(&self, key: &Key, one: &Pending) -> Result<Place, String> {
        let mut work = panic::catch_unwind(AssertUnwindSafe(|| one.read()))
            .unwrap_or_else(|_| Err("reading it broke down; please report this".to_owned()));
        if let (Ok(work), Some(folder)) = (&mut work, self.answers) {
            work.answers = answers(folder, &one.id)?;
        }
        let own = of_work(&work, self.telling.detail);
        let is_there = |known: &Graded| {
            let files = self.telling.files(key, known);
            files.iter().all(|file| self.out.join(&file.path).is_file())
        };
        let known = self.journal.known(&one.id, own);
        if let Some((place, _)) = known.filter(|(_, known)| is_there(known)) {
            return Ok(place);
        }
        let keep = |graded: &Graded| {
            let kept = self.journal.append(own, graded);
            kept.map_err(|error| {
                failed(self.out, &format!("the journal can't be written: {error}"))
            })
        };
        let untouched = panic::catch_unwind(AssertUnwindSafe(|| {
            let work = work.as_ref().ok()?;
            self.journal.untouched(&one.id, own, work)
        }));
        if let Some(graded) = untouched.ok().flatten().filter(is_there) {
            return keep(&graded);
        }
        let graded = marked(key, &one.id, work);
        for path in self.telling.outdated(&graded) {
            // It is there only where another run wrote it.
            let _ = fs::remove_file(self.out.join(path));
        }
        for file in self.telling.files(key, &graded) {
            write(
                &self.out.join(&file.path),
                &file.text,
                output::replace_unsynced,
            )?;
        }
        // Pages have the lines; a class of many would not fit with them.
        keep(&Graded {
            lines: vec![],
            ..graded
        })
    }
}

fn marked(key: &Key, id: &str, work: Result<Work, String>) -> Graded {
    let work = match work {
        Ok(work) => work,
        Err(reason) => return not_marked(key, id, &reason),
    };
    let graded = panic::catch_unwind(AssertUnwindSafe(|| mark(key, &work)));
    graded.unwrap_or_else(|_| not_marked(key, id, "marking it broke down; please report this"))
}

/// What staff answered for one student: sentences, one a line, in a file called as the student's pages are.
fn answers(folder: &Path, id: &str) -> Result<Vec<String>, String> {
    let path = folder.join(file_stem(id) + ".txt");
    if !path.exists() {
        return Ok(vec![]);
    }
    let text = input::read(&path).map_err(|error| failed(&path, &error))?;
    let lines = text.lines().map(str::trim);
    let said = lines.filter(|line| !line.is_empty() && !line.starts_with('#'));
    Ok(said.map(str::to_owned).collect())
}

/// A number for what is handed in, answered, and told of it, the same for the same.
fn of_work(work: &Result<Work, String>, detail: Detail) -> u64 {
    let detail = [detail as u8];
    let detail = std::iter::once(&detail[..]);
    match work {
        Err(reason) => digest(detail.chain([reason.as_bytes()])),
        Ok(work) => {
            let texts = work.texts.iter();
            let texts = texts.flat_map(|text| [text.name.as_bytes(), text.text.as_bytes()]);
            let said = work.troubles.iter().chain(&work.answers);
            digest(detail.chain(texts).chain(said.map(String::as_bytes)))
        }
    }
}

fn write(
    path: &Path,
    text: &str,
    replace: impl Fn(&Path, &str) -> io::Result<()>,
) -> Result<(), String> {
    let made = |folder: &Path| fs::create_dir_all(folder).and_then(|()| replace(path, text));
    let done = match (replace(path, text), path.parent()) {
        // The folder is there for most files.
        (Err(error), Some(folder)) if error.kind() == io::ErrorKind::NotFound => made(folder),
        (done, _) => done,
    };
    done.map_err(|error| failed(path, &error))
}
