//! Lines that wait for a sentence of which nothing was made.

use crate::notation::ast::{Kind, Line, Node};
use crate::notation::print;
use crate::verify::Role;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::standing::roles::Purpose;
use crate::verify::standing::verdicts::Standing;
use crate::verify::term::letters::letter_names;
use std::collections::{BTreeMap, BTreeSet};

/// Letters that mean what they do by custom, where no sentence says otherwise.
const BY_CUSTOM: [&str; 5] = ["t", "pi", "delta", "epsilon", "varepsilon"];

impl Judge<'_> {
    /// Whether a line says of letters what a sentence may tell of which nothing was made.
    pub(super) fn waits_for_sentence(&self, line: &Line, purpose: Purpose, held: &[Held]) -> bool {
        if self.reading.unused.is_empty() {
            return false;
        }
        let letters = letters_in(&line.sides);
        let has = |standing: Standing| held.iter().any(|h| h.standing == standing);
        let told = has(Standing::Settles) && self.reading.tells_unused(&letters, &self.at)
            || has(Standing::Free) && self.reading.unused_of(&letters, &self.at).is_some();
        let unknown: Vec<String> = held.iter().flat_map(|h| h.unknown.clone()).collect();
        told && purpose.role == Role::Define || self.unread_of(&line.sides, &unknown).is_some()
    }

    /// A sentence of which nothing was made, and which may tell something of the letters of formulas.
    pub(super) fn unused_of<'n>(&self, nodes: impl IntoIterator<Item = &'n Node>) -> Option<&str> {
        match self.reading.unused.is_empty() {
            true => None,
            false => self.reading.unused_of(&letters_in(nodes), &self.at),
        }
    }

    /// A sentence that was not understood, without which nothing can be said of formulas. What other sentences tell of a
    /// letter it does not take back: it matters for letters that are unknown otherwise.
    pub(super) fn unread_of<'n>(
        &self,
        nodes: impl IntoIterator<Item = &'n Node>,
        unknown: &[String],
    ) -> Option<&str> {
        match self.reading.unused.is_empty() {
            true => None,
            false => self.reading.unread_of(&untold_in(nodes, unknown), &self.at),
        }
    }

    /// A sentence that was not understood and may change what any letter means.
    pub(super) fn unread_rule(&self) -> Option<&str> {
        self.reading.unread_of(&BTreeSet::new(), &self.at)
    }
}

fn letters_in<'n>(nodes: impl IntoIterator<Item = &'n Node>) -> BTreeSet<String> {
    nodes.into_iter().flat_map(letter_names).collect()
}

/// The letters of formulas that are unknown or mean what they do by custom, without marks and labels.
fn untold_in<'n>(
    nodes: impl IntoIterator<Item = &'n Node>,
    unknown: &[String],
) -> BTreeSet<String> {
    fn collect(node: &Node, unknown: &mut BTreeMap<&str, bool>, names: &mut BTreeSet<String>) {
        if let Kind::Symbol(symbol) = &node.kind {
            let found = unknown.get_mut(print::latex(node).as_str());
            if found.map(|found| *found = true).is_some()
                || BY_CUSTOM.contains(&symbol.name.as_str())
            {
                names.insert(symbol.name.clone());
            }
        }
        let children = node.children();
        children
            .into_iter()
            .for_each(|child| collect(child, unknown, names));
    }
    let nodes: Vec<&Node> = nodes.into_iter().collect();
    let mut unknown: BTreeMap<&str, bool> = unknown.iter().map(|u| (u.as_str(), false)).collect();
    let mut names = BTreeSet::new();
    nodes
        .iter()
        .for_each(|node| collect(node, &mut unknown, &mut names));
    match unknown.values().all(|found| *found) {
        true => names,
        // One that is written otherwise, as a function of some letters is, may be any of them.
        false => letters_in(nodes),
    }
}
