//! The letters in a formula that number axes.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::term::labels::letters_of;
use crate::verify::term::letters::{At, Letter, Letters, spell};
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
        let numbers = |letter: &str| {
            let rule = letters.index(letter, at);
            rule.is_some_and(|rule| rule.axes_of.is_some())
        };
        for letter in letters_of(text, numbers).into_iter().filter(|l| numbers(l)) {
            *found.entry(letter).or_default() += 1;
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

/// The names of axes by which a letter may be labelled.
pub(crate) const LABELS: [[&str; 3]; 3] = [["1", "2", "3"], ["x", "y", "z"], ["X", "Y", "Z"]];

impl Lowering<'_> {
    /// The letter with the numbers that its indices have in this reading of the line, `I_2` for `I_j`, or with the axes, and
    /// whether a sentence says what the index numbers: then it says so of vectors first.
    pub(super) fn by_number(&self, symbol: &Symbol) -> Option<(Letter, bool)> {
        let index = symbol.subscripts.last()?;
        let axes = self.axes_of_indices(index)?;
        let found = LABELS.iter().find_map(|names| {
            let label: String = axes.iter().map(|&axis| names[axis]).collect();
            let other = with_number(symbol, &label);
            let letters = self.letters;
            letters.find(&spell(&other, true), &spell(&other, false), self.at, 0)
        });
        let rule = self.letters.index(index, self.at);
        let said = rule.is_some_and(|rule| rule.axes_of.is_some());
        Some((found.cloned()?, said))
    }

    /// The axes that the letters of a label number.
    fn axes_of_indices(&self, label: &str) -> Option<Vec<usize>> {
        match self.axis_of_letter(label) {
            Some(axis) => Some(vec![axis]),
            None => {
                let letters = letters_of(label, |l| self.axis_of_letter(l).is_some());
                let index = |letter: &String| self.axis_of_letter(letter);
                // Beside an index a number is one: `I_{1k}`.
                let number = |letter: &String| LABELS[0].iter().position(|n| n == letter);
                letters.iter().find_map(index)?;
                let axis = |letter| index(letter).or_else(|| number(letter));
                letters.iter().map(axis).collect()
            }
        }
    }
}
