//! Instants: what is said of one alone, and what the motion may keep from there.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::Source;
use crate::verify::reading::impacts_read::Strike;
use crate::verify::term::letters::{At, Reach};
use std::collections::BTreeSet;

/// The instants of which something is said.
#[derive(Clone, Debug, Default)]
pub(crate) struct Instants {
    pub(crate) all: Vec<Instant>,
    /// What may be constant by the equations of motion.
    pub(crate) candidates: Vec<Fraction>,
    /// The letters that are values at instants.
    pub(crate) letters: BTreeSet<Variable>,
    /// Those of them that are times.
    pub(crate) times: BTreeSet<Variable>,
    /// Those of them of which nothing was made.
    pub(crate) untied: BTreeSet<Variable>,
    /// How often first integrals were looked for.
    pub(crate) tries: usize,
    /// Whether a sentence or a given line tells something of values that labels take at instants.
    pub(crate) labelled: bool,
    /// Whether sentences tell of both sides of a blow.
    pub(crate) blow: bool,
    /// What strikes what.
    pub(crate) strike: Option<Strike>,
    /// The instant whose values are in force, and how many these are.
    pub(crate) taken: Option<(usize, usize)>,
}

/// One of them.
#[derive(Clone, Debug)]
pub(crate) struct Instant {
    pub(crate) name: String,
    /// The lines that hold then alone.
    pub(crate) lines: Vec<Reach>,
    /// These vanish then.
    pub(crate) values: Vec<(Fraction, Source)>,
}

impl Instants {
    /// The instant of a name; it is a new one if nothing was said of it yet.
    pub(crate) fn named(&mut self, name: &str) -> &mut Instant {
        let known = self.all.iter().position(|instant| instant.name == name);
        let at = known.unwrap_or_else(|| {
            self.all.push(Instant {
                name: name.to_owned(),
                lines: vec![],
                values: vec![],
            });
            self.all.len() - 1
        });
        &mut self.all[at]
    }

    /// The instant at which the line at a place holds, if it does so at one alone.
    pub(crate) fn at(&self, at: &At) -> Option<usize> {
        let holds = |instant: &Instant| instant.lines.iter().any(|lines| lines.covers(at, 0));
        self.all.iter().position(holds)
    }

    /// The instants of which values are told.
    pub(crate) fn told(&self) -> impl Iterator<Item = usize> {
        let all = self.all.iter().enumerate();
        let told = all.filter(|(_, instant)| !instant.values.is_empty());
        told.map(|(at, _)| at).collect::<Vec<_>>().into_iter()
    }
}

/// Words by which an instant is told by what is so then, and not by what begins.
const STATES: [&str; 8] = [
    "is",
    "are",
    "coincide",
    "coincides",
    "agree",
    "agrees",
    "lies",
    "lie",
];

/// Whether the words for an instant tell what is so then.
pub(super) fn tells_state(name: &str) -> bool {
    name.split_whitespace().any(|word| STATES.contains(&word))
}
