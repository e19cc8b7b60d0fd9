//! Results of a run on their way to a file, in one of the forms.

use crate::cli::run::progress::{self, Progress};
use crate::cli::run::target::Target;
use crate::scene::{Group, Outcome, Row, Run, Scene, Sink};
use std::io::{self, Write};

/// A form of results. Each call writes what it can say at that time.
pub(super) trait Form {
    /// Before all bodies.
    fn open(&mut self, out: &mut dyn Write, run: &Run) -> io::Result<()>;
    /// A body begins.
    fn begin(&mut self, out: &mut dyn Write, name: &str) -> io::Result<()>;
    /// A row of its trajectory.
    fn row(&mut self, out: &mut dyn Write, row: &Row) -> io::Result<()>;
    /// It ends.
    fn end(&mut self, out: &mut dyn Write, outcome: &Outcome) -> io::Result<()>;
    /// After all bodies.
    fn close(&mut self, out: &mut dyn Write) -> io::Result<()>;
}

/// Writes the results of a scene in a form, and counts what missed the tolerance.
pub(super) struct Writer {
    form: Box<dyn Form>,
    target: Target,
    run: Run,
    opened: bool,
    name: String,
    missed: u64,
    worst: f64,
    first_missed: Option<String>,
    progress: Progress,
    reached: f64,
}

impl Writer {
    pub(super) fn new(form: Box<dyn Form>, target: Target, scene: &Scene) -> Self {
        Self {
            progress: Progress::new(scene),
            reached: 0.0,
            form,
            target,
            run: scene.run.clone(),
            opened: false,
            name: String::new(),
            missed: 0,
            worst: 0.0,
            first_missed: None,
        }
    }

    fn open(&mut self) -> io::Result<()> {
        if !self.opened {
            self.opened = true;
            self.form.open(&mut self.target, &self.run)?;
        }
        Ok(())
    }

    /// Ends the file, says what missed the tolerance and whether the run was stopped, and returns the exit code.
    pub(super) fn finish(mut self, complete: bool) -> io::Result<u8> {
        self.progress.end();
        self.open()?;
        self.form.close(&mut self.target)?;
        self.target.close()?;
        if !complete {
            let (name, reached) = (&self.name, self.reached);
            eprintln!("stopped: what is written is complete up to t = {reached} s of {name:?}");
        }
        if let Some(first) = &self.first_missed {
            let (worst, tolerance) = (self.worst, self.run.tolerance);
            let others = match self.missed {
                1 => String::new(),
                n => format!(" and {} other bodies", n - 1),
            };
            eprintln!(
                "warning: {first:?}{others} may be off by up to {worst:.1e}, more than the tolerance {tolerance:e}"
            );
        }
        Ok(match (complete, &self.first_missed) {
            (false, _) => INTERRUPTED,
            (true, Some(_)) => 3,
            (true, None) => 0,
        })
    }
}

/// What a shell expects of a command that was interrupted: 128 + SIGINT.
const INTERRUPTED: u8 = 130;

impl Sink for Writer {
    type Error = io::Error;

    fn begin(&mut self, group: &Group, index: u64) -> io::Result<()> {
        self.open()?;
        self.name = group.member_name(index);
        self.form.begin(&mut self.target, &self.name)
    }

    fn row(&mut self, row: &Row) -> io::Result<()> {
        self.reached = row.time;
        self.progress.within(row.time);
        self.form.row(&mut self.target, row)
    }

    fn end(&mut self, outcome: &Outcome) -> io::Result<()> {
        if let Some(error) = outcome.error
            && (error > self.run.tolerance || error.is_nan())
        {
            self.missed += 1;
            self.worst = self.worst.max(error);
            if self.first_missed.is_none() {
                self.first_missed = Some(self.name.clone());
            }
        }
        self.reached = outcome.time;
        self.progress.body();
        self.form.end(&mut self.target, outcome)
    }

    fn stop(&self) -> fn() -> bool {
        progress::interrupted
    }
}
