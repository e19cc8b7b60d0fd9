//! Work on many bodies, on all threads where there are any.

use std::ops::Range;
use std::time::{Duration, Instant};

/// Bodies that are computed before their results are handed on: at first, and at most.
const FIRST: u64 = 16;
const MOST: u64 = 4096;
/// A share that takes longer than this is not followed by a larger one.
const PATIENCE: Duration = Duration::from_millis(20);

/// A range in shares that grow while they take no time.
pub(super) struct Shares {
    left: Range<u64>,
    size: u64,
    begun: Option<Instant>,
}

impl Shares {
    pub(super) fn new(all: Range<u64>) -> Self {
        Self {
            left: all,
            size: FIRST,
            begun: None,
        }
    }

    /// The next share; the one before it is done.
    pub(super) fn next(&mut self) -> Option<Range<u64>> {
        if self.begun.is_some_and(|begun| begun.elapsed() < PATIENCE) {
            self.size = (2 * self.size).min(MOST);
        }
        self.begun = Some(Instant::now());
        let end = self.left.end.min(self.left.start.saturating_add(self.size));
        let share = self.left.start..end;
        self.left.start = end;
        (!share.is_empty()).then_some(share)
    }
}

/// The results of `work` in the order of the range.
#[cfg(feature = "parallel")]
pub(super) fn map<T: Send>(share: Range<u64>, work: impl Fn(u64) -> T + Send + Sync) -> Vec<T> {
    use rayon::iter::{IntoParallelIterator, ParallelIterator};
    if share.end - share.start > 1 {
        share.into_par_iter().map(work).collect()
    } else {
        share.map(work).collect()
    }
}

/// The results of `work` in the order of the range.
#[cfg(not(feature = "parallel"))]
pub(super) fn map<T>(share: Range<u64>, work: impl Fn(u64) -> T) -> Vec<T> {
    share.map(work).collect()
}
