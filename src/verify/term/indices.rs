//! The letters in a formula that number axes.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::term::letters::{At, Letter, Letters, plain, spell};
use crate::verify::term::lower::Lowering;
use std::collections::BTreeMap;

/// A symbol with a number in place of its last label.
pub(crate) fn with_number(symbol: &Symbol, number: &str) -> Symbol {
    let mut numbered = symbol.clone();
    if let Some(last) = numbered.subscripts.last_mut() {
        number.clone_into(last);
    }
    numbered
}

/// How often each letter that numbers axes stands in a formula.
pub(crate) fn axis_letters(letters: &Letters, at: &At, node: &Node) -> BTreeMap<String, usize> {
    let mut found = BTreeMap::new();
    count(letters, at, node, &mut found);
    found
}

fn count(letters: &Letters, at: &At, node: &Node, found: &mut BTreeMap<String, usize>) {
    let mut label = |text: &str| {
        for letter in plain(text).chars() {
            let letter = letter.to_string();
            if letters
                .index(&letter, at)
                .is_some_and(|rule| rule.axes_of.is_some())
            {
                *found.entry(letter).or_default() += 1;
            }
        }
    };
    match &node.kind {
        Kind::Symbol(symbol) => symbol.subscripts.iter().for_each(|s| label(s)),
        Kind::InFrame(_, frame) => label(&frame.text),
        Kind::IndexedSum { index, body, .. } => {
            let mut inner = BTreeMap::new();
            count(letters, at, body, &mut inner);
            inner.remove(&index.name);
            for (letter, times) in inner {
                *found.entry(letter).or_default() += times;
            }
            return;
        }
        _ => {}
    }
    node.children()
        .for_each(|child| count(letters, at, child, found));
}

impl Lowering<'_> {
    /// The letter with the number that its index has in this reading of the line: `I_2` for `I_j`, and whether a sentence
    /// says what the index numbers: then it says so of vectors first.
    pub(super) fn by_number(&self, symbol: &Symbol) -> Option<(Letter, bool)> {
        let index = symbol.subscripts.last()?;
        let axis = self.axis_of_letter(index)?;
        let other = with_number(symbol, &(axis + 1).to_string());
        let found = self
            .letters
            .find(&spell(&other, true), &spell(&other, false), self.at, 0);
        let said = self.letters.index(index, self.at).is_some();
        Some((found.cloned()?, said))
    }
}
