//! An earlier result of the same scene, taken over as far as it goes.
//!
//! Its rows are copied but for the last, from which the run goes on: that row must come again to the last byte. Steps
//! are taken again from the start of the body that was under way, without its rows: a motion could be taken up only
//! where a step ended, and a result has the output times alone.

use crate::cli::run::csv::{head, quoted};
use crate::cli::run::writer::Form;
use crate::scene::{Outcome, Row, Run, Scene, Seam};
use std::fs::File;
use std::io::{self, BufRead, BufReader, Read, Seek, SeekFrom, Write};
use std::{error, fmt, path::Path};

/// The longest line of a result: a name, quoted, and its numbers.
const LONGEST: u64 = 4096;

/// An earlier result (CSV) of a scene.
pub(super) struct Earlier {
    file: BufReader<File>,
    /// Bytes that are copied.
    kept: u64,
    /// Bytes after them that must come again.
    again: u64,
    /// Where to go on.
    pub(super) from: Seam,
}

/// The rows of one body in a result.
struct Rows {
    body: u64,
    /// How each begins.
    prefix: String,
    count: u64,
    /// The bytes of the last.
    last: std::ops::Range<u64>,
    /// Whether that one is the end of the motion.
    complete: bool,
}

/// That a row came out otherwise than it stands in an earlier result.
#[derive(Debug)]
pub(super) struct Disagrees;

impl fmt::Display for Disagrees {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("a row of the earlier result comes out otherwise")
    }
}

impl error::Error for Disagrees {}

impl Earlier {
    /// Reads through an earlier result of a scene.
    ///
    /// # Errors
    /// A file that can't be read, or that is no result of this scene.
    pub(super) fn open(path: &Path, scene: &Scene) -> io::Result<Self> {
        if !path.metadata()?.is_file() {
            return Err(io::Error::other("is no regular file"));
        }
        let mut file = BufReader::new(File::open(path)?);
        let trajectory = scene.run.outputs.trajectory;
        let mut lines = Lines {
            file: &mut file,
            read: 0,
            count: 0,
        };
        if lines.next()?.as_deref().map(str::trim_end) != Some(head(trajectory).as_str()) {
            return Err(foreign(1));
        }
        let start = lines.read;
        let last = last_rows(&mut lines, scene)?;
        let (kept, again, from) = match last {
            Some(rows) => {
                let (body, row) = (rows.body, rows.count - 1);
                let bytes = rows.last;
                (bytes.start, bytes.end - bytes.start, Seam { body, row })
            }
            None => (start, 0, Seam::default()),
        };
        Ok(Self {
            file,
            kept,
            again,
            from,
        })
    }

    /// Copies what is kept, and goes on in `form`.
    pub(super) fn go_on(mut self, form: Box<dyn Form>, out: &mut dyn Write) -> io::Result<Resumed> {
        self.file.seek(SeekFrom::Start(0))?;
        io::copy(&mut self.file.by_ref().take(self.kept), out)?;
        Ok(Resumed {
            form,
            earlier: self,
        })
    }
}

/// The rows of the body from which a run goes on: the last of the result, or the first that ends before the run does. The
/// result of a shorter run has many of those; what stands after the first comes anew.
fn last_rows(lines: &mut Lines<'_>, scene: &Scene) -> io::Result<Option<Rows>> {
    let mut names = names(scene);
    let duration = scene.run.duration.to_string();
    let (mut before, mut last): (Option<Rows>, Option<Rows>) = (None, None);
    let mut short = None;
    let mut start = lines.read;
    while let Some(line) = lines.next()? {
        if !last
            .as_ref()
            .is_some_and(|rows| line.starts_with(&rows.prefix))
        {
            let body = last.as_ref().map_or(0, |rows| rows.body + 1);
            if short.is_none() && last.as_ref().is_some_and(|rows| !rows.complete) {
                short = Some((before.take(), last.take()));
            }
            let rows = Rows::of(names.next(), body, &line, start);
            before = last.replace(rows.ok_or_else(|| foreign(lines.count))?);
        }
        if let Some(rows) = &mut last {
            rows.take(&line, start..lines.read, &duration);
        }
        start = lines.read;
    }
    let (before, last) = short.unwrap_or((before, last));
    // What a body that was stopped had come to is a row of a trajectory, and no final state.
    let usable = |rows: &Rows| rows.complete || scene.run.outputs.trajectory;
    Ok(last.filter(usable).or(before))
}

impl Rows {
    /// None yet of the body with a name, which the first line has to begin with.
    fn of(name: Option<String>, body: u64, line: &str, start: u64) -> Option<Self> {
        let prefix = format!("{},", quoted(&name?));
        line.starts_with(&prefix).then_some(Self {
            body,
            prefix,
            count: 0,
            last: start..start,
            complete: false,
        })
    }

    /// One more, at these bytes.
    fn take(&mut self, line: &str, bytes: std::ops::Range<u64>, duration: &str) {
        let rest = line.get(self.prefix.len()..);
        let time = rest.and_then(|rest| rest.split(',').next());
        self.complete = time == Some(duration);
        self.count += 1;
        self.last = bytes;
    }
}

fn foreign(line: u64) -> io::Error {
    let message = format!("line {line} is of no result of this scene as CSV");
    io::Error::new(io::ErrorKind::InvalidData, message)
}

/// The names of all members.
fn names(scene: &Scene) -> impl Iterator<Item = String> + '_ {
    let groups = scene.groups.iter();
    groups.flat_map(|group| (0..group.count).map(|index| group.member_name(index)))
}

/// The lines of a file, none too long.
struct Lines<'a> {
    file: &'a mut BufReader<File>,
    read: u64,
    count: u64,
}

impl Lines<'_> {
    /// The next line with its end; nothing at the end, or for a last line that has none.
    fn next(&mut self) -> io::Result<Option<String>> {
        let mut line = String::new();
        let length = self.file.by_ref().take(LONGEST).read_line(&mut line)?;
        self.count += 1;
        if length as u64 == LONGEST {
            return Err(foreign(self.count));
        }
        self.read += length as u64;
        Ok(line.ends_with('\n').then_some(line))
    }
}

/// A form whose first bytes must be those of an earlier result.
pub(super) struct Resumed {
    form: Box<dyn Form>,
    earlier: Earlier,
}

/// Compares what is written with what was.
struct Compared<'a> {
    out: &'a mut dyn Write,
    earlier: &'a mut Earlier,
}

impl Write for Compared<'_> {
    fn write(&mut self, bytes: &[u8]) -> io::Result<usize> {
        let again = usize::try_from(self.earlier.again).unwrap_or(usize::MAX);
        let (old, _) = bytes.split_at(bytes.len().min(again));
        let mut before = vec![0; old.len()];
        self.earlier.file.read_exact(&mut before)?;
        if before != old {
            return Err(io::Error::other(Disagrees));
        }
        self.earlier.again -= old.len() as u64;
        self.out.write_all(bytes)?;
        Ok(bytes.len())
    }

    fn flush(&mut self) -> io::Result<()> {
        self.out.flush()
    }
}

impl Resumed {
    fn through(
        &mut self,
        out: &mut dyn Write,
        work: impl FnOnce(&mut dyn Form, &mut dyn Write) -> io::Result<()>,
    ) -> io::Result<()> {
        let earlier = &mut self.earlier;
        work(self.form.as_mut(), &mut Compared { out, earlier })
    }
}

impl Form for Resumed {
    /// The head is copied; the form only learns what is asked for.
    fn open(&mut self, _: &mut dyn Write, run: &Run) -> io::Result<()> {
        self.form.open(&mut io::sink(), run)
    }

    fn begin(&mut self, out: &mut dyn Write, name: &str) -> io::Result<()> {
        self.through(out, |form, out| form.begin(out, name))
    }

    fn row(&mut self, out: &mut dyn Write, row: &Row) -> io::Result<()> {
        self.through(out, |form, out| form.row(out, row))
    }

    fn end(&mut self, out: &mut dyn Write, outcome: &Outcome) -> io::Result<()> {
        self.through(out, |form, out| form.end(out, outcome))
    }

    fn close(&mut self, out: &mut dyn Write) -> io::Result<()> {
        self.through(out, |form, out| form.close(out))
    }
}
