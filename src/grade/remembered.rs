//! What lines of students came to beside those of the key, kept for the class: many write the same.

use crate::grade::matching::{Entry, Part};
use crate::recent::Recent;
use crate::verify::Wording;
use foldhash::HashMap;
use std::sync::{Arc, Mutex, PoisonError};

/// No more lines are kept.
const MOST_LINES: usize = 1_000;

/// No more answers are kept whether a line says what a line of the key does.
const MOST_ANSWERS: usize = 15_000;

/// What is kept. All who mark a class share it.
#[derive(Clone, Debug, Default)]
pub(super) struct Remembered(Arc<Mutex<Kept>>);

#[derive(Debug)]
struct Kept {
    /// The lines of the key, by the number of the variables.
    key: HashMap<u32, Arc<[Entry]>>,
    lines: Recent<Wording, Parts>,
    /// How many lines were numbered so far.
    numbered: usize,
    answers: Recent<Asked, bool>,
}

impl Default for Kept {
    fn default() -> Self {
        Self {
            key: HashMap::default(),
            lines: Recent::of(MOST_LINES),
            numbered: 0,
            answers: Recent::of(MOST_ANSWERS),
        }
    }
}

/// The components of a line, and its number.
#[derive(Clone, Debug)]
pub(super) struct Parts {
    pub(super) parts: Option<Arc<[Part]>>,
    pub(super) ends: Arc<[Part]>,
    pub(super) number: usize,
}

/// What is asked of a line and a component of the key's: by the number of the variables, and by the numbers of both.
#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) struct Asked {
    pub(super) what: Question,
    pub(super) state: u32,
    pub(super) line: usize,
    pub(super) goal: usize,
}

#[derive(Clone, Copy, Debug, PartialEq, Eq, Hash)]
pub(super) enum Question {
    /// Whether the line alone says it.
    Says,
    /// Whether it can be seen without working it out that it does not, with its rates.
    IsFar,
}

impl Remembered {
    fn with<T>(&self, look: impl FnOnce(&mut Kept) -> T) -> T {
        // Nothing in it is ever half done.
        look(&mut self.0.lock().unwrap_or_else(PoisonError::into_inner))
    }

    pub(super) fn key(&self, state: u32) -> Option<Arc<[Entry]>> {
        self.with(|kept| kept.key.get(&state).cloned())
    }

    pub(super) fn keep_key(&self, state: u32, entries: &Arc<[Entry]>) {
        self.with(|kept| kept.key.insert(state, entries.clone()));
    }

    pub(super) fn line(&self, wording: &Wording) -> Option<Parts> {
        self.with(|kept| kept.lines.get(wording))
    }

    /// Keeps the components of a line, and numbers them.
    pub(super) fn keep_line(&self, wording: Wording, entry: &Entry) -> usize {
        let (parts, ends) = (entry.parts.clone(), entry.ends.clone());
        self.with(|kept| {
            let number = kept.numbered;
            kept.numbered += 1;
            let parts = Parts {
                parts,
                ends,
                number,
            };
            kept.lines.insert(wording, parts, 1);
            number
        })
    }

    pub(super) fn answer(&self, asked: Asked) -> Option<bool> {
        self.with(|kept| kept.answers.get(&asked))
    }

    pub(super) fn keep_answer(&self, asked: Asked, answer: bool) {
        self.with(|kept| kept.answers.insert(asked, answer, 1));
    }
}
