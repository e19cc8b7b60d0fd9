//! How far a long run is, and whether the user has had enough.

use crate::scene::Scene;
use indicatif::{ProgressBar, ProgressStyle};
use std::sync::atomic::{AtomicBool, Ordering};
use std::time::{Duration, Instant};

/// A run shorter than this shows nothing.
const PATIENCE: Duration = Duration::from_millis(500);
/// Parts that the bar shows of one body.
const PARTS: u64 = 1000;

/// A bar on standard error, if that is a terminal and the run is long.
pub(super) struct Progress {
    bar: Option<ProgressBar>,
    begun: Instant,
    bodies: u64,
    done: u64,
    duration: f64,
    calls: u64,
}

impl Progress {
    pub(super) fn new(scene: &Scene) -> Self {
        Self {
            bar: None,
            begun: Instant::now(),
            bodies: scene.bodies(),
            done: 0,
            duration: scene.run.duration,
            calls: 0,
        }
    }

    /// A body has ended.
    pub(super) fn body(&mut self) {
        self.done += 1;
        self.show(self.done * PARTS);
    }

    /// The body under way has come to a time.
    pub(super) fn within(&mut self, time: f64) {
        let part = (time / self.duration * PARTS as f64) as u64;
        self.show(self.done * PARTS + part.min(PARTS));
    }

    fn show(&mut self, parts: u64) {
        // To look at the clock for each of a million rows would be most of the work.
        self.calls += 1;
        if !self.calls.is_multiple_of(256) && self.bodies * PARTS > parts {
            return;
        }
        if self.bar.is_none() && self.begun.elapsed() > PATIENCE {
            let bar = ProgressBar::new(self.bodies * PARTS);
            let style = ProgressStyle::with_template("{wide_bar} {percent} %, {eta} left");
            self.bar = Some(match style {
                Ok(style) => bar.with_style(style),
                Err(_) => bar,
            });
        }
        if let Some(bar) = &self.bar {
            bar.set_position(parts);
        }
    }

    pub(super) fn end(&mut self) {
        if let Some(bar) = self.bar.take() {
            bar.finish_and_clear();
        }
    }
}

static INTERRUPTED: AtomicBool = AtomicBool::new(false);

/// From now on Ctrl-C asks the run to end well; the second one ends the process.
pub(super) fn listen() {
    let asked = || {
        if INTERRUPTED.swap(true, Ordering::Relaxed) {
            std::process::exit(130);
        }
    };
    if let Err(error) = ctrlc::set_handler(asked) {
        eprintln!("warning: Ctrl-C will lose what is not written yet: {error}");
    }
}

/// Whether Ctrl-C was pressed.
pub(super) fn interrupted() -> bool {
    INTERRUPTED.load(Ordering::Relaxed)
}
