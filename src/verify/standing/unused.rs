//! Lines that wait for a sentence of which nothing was made.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::print::latex;
use crate::verify::Role;
use crate::verify::reading::unused::Written;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::roles::Purpose;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::letters::{letters_and_names, loosely, spelled};
use std::collections::BTreeSet;

impl Judge<'_> {
    /// Whether a line says of letters what a sentence may tell of which nothing was made.
    pub(super) fn waits_for_sentence(&self, line: &Line, purpose: Purpose, held: &[Held]) -> bool {
        if self.reading.unused.is_empty() {
            return false;
        }
        let letters = letters_in(&line.sides);
        let sides: Vec<&Node> = line.sides.iter().collect();
        let has = |standing: Standing| held.iter().any(|h| h.standing == standing);
        let free = |h: &Held| h.standing == Standing::Free && !self.names_entries(h);
        let named = held.iter().any(|h| self.names_entries(h)) || has(Standing::Settles);
        let told = named && self.reading.tells_unused(&letters, &self.at)
            || held.iter().any(free) && self.unused_of(sides.iter().copied()).is_some();
        let unknown: Vec<String> = held.iter().flat_map(|h| h.unknown.clone()).collect();
        let settled = held.iter().filter(|h| h.standing == Standing::Settles);
        let mut settled = settled.filter_map(|h| h.settles.as_ref());
        settled.any(|(letter, ..)| self.reading.is_about_unused(letter, &self.at))
            || told && purpose.role == Role::Define
            || self.reads_by_custom(&sides)
            || self.unread_of(&sides, &unknown).is_some()
    }

    /// `\omega = (p, q, r)`: whether each component says what a new letter is that stands alone there, and says no more.
    fn names_entries(&self, held: &Held) -> bool {
        let atoms = &self.reading.system.atoms;
        let new = |side: &Fraction| side.as_variable().filter(|&v| atoms.is_unknown(v));
        let known = |side: &Fraction| side.variables().iter().all(|&v| !atoms.is_unknown(v));
        let mut seen = BTreeSet::new();
        let mut named = |(left, right): &(Fraction, Fraction)| {
            let letter = match (new(left), new(right)) {
                (Some(letter), None) if known(right) => Some(letter),
                (None, Some(letter)) if known(left) => Some(letter),
                _ => None,
            };
            letter.is_some_and(|letter| seen.insert(letter))
        };
        held.standing == Standing::Free && held.sides.len() > 1 && held.sides.iter().all(&mut named)
    }

    /// Whether a letter that its labels alone make an entry of a tensor stands in formulas, where a sentence of which nothing was made
    /// says what it is.
    fn reads_by_custom(&self, nodes: &[&Node]) -> bool {
        let letters = &self.reading.letters;
        let told = |node: &Node| {
            let found = letters.find(&spelled(node), &loosely(node), &self.at, 0);
            found.is_some() || !self.reading.is_named_in_vain(&latex(node), &self.at)
        };
        nodes.iter().any(|node| match &node.kind {
            Kind::Symbol(symbol) => is_labelled_by_axes(symbol) && !told(node),
            _ => self.reads_by_custom(&node.children().collect::<Vec<_>>()),
        })
    }

    /// A sentence of which nothing was made, and which may tell something of the letters of formulas.
    pub(super) fn unused_of<'n>(&self, nodes: impl IntoIterator<Item = &'n Node>) -> Option<&str> {
        match self.reading.unused.is_empty() {
            true => None,
            false => {
                let nodes: Vec<&Node> = nodes.into_iter().collect();
                let letters = letters_in(nodes.iter().copied());
                let written = self.written(&nodes, &[]);
                self.reading.unused_of(&letters, written, &self.at)
            }
        }
    }

    /// A sentence that was not understood, without which nothing can be said of formulas.
    pub(super) fn unread_of(&self, nodes: &[&Node], unknown: &[String]) -> Option<&str> {
        match self.reading.unused.is_empty() {
            true => None,
            false => self
                .reading
                .unread_of(self.written(nodes, unknown), &self.at),
        }
    }

    fn written<'n>(&'n self, nodes: &'n [&'n Node], unknown: &'n [String]) -> Written<'n> {
        let text = &self.document.source.text;
        Written {
            nodes,
            unknown,
            text,
        }
    }

    /// A sentence that was not understood and may change what anything means.
    pub(super) fn unread_rule(&self) -> Option<&str> {
        self.unread_of(&[], &[])
    }
}

fn letters_in<'n>(nodes: impl IntoIterator<Item = &'n Node>) -> BTreeSet<String> {
    nodes.into_iter().flat_map(letters_and_names).collect()
}

/// `I_{xy}`: two axes, by which it is an entry where no sentence says what it is.
fn is_labelled_by_axes(symbol: &Symbol) -> bool {
    let axes = |label: &String| {
        let mut letters = label.chars();
        label.chars().count() == 2 && letters.all(|l| "xyzXYZ123".contains(l))
    };
    symbol.subscripts.last().is_some_and(axes)
}
