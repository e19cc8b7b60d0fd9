//! How letters and writings are spelled, by which they are found again.

use crate::notation::ast::{Kind, Node, Operator as Sign, Symbol};
use crate::notation::print;
use crate::verify::term::labels::plain;
use std::collections::BTreeSet;

/// The writing of a formula that stands for something as a whole.
pub(crate) fn spelled(node: &Node) -> String {
    match &node.kind {
        Kind::Product(factors) if factors.iter().all(|f| f.operator == Sign::Juxtaposed) => factors
            .iter()
            .map(|f| spelled(&f.node))
            .collect::<Vec<_>>()
            .join(" "),
        Kind::Group(_, inner) => spelled(inner),
        _ => letter(node, true),
    }
}

/// The same without what only makes letters bold or upright.
pub(crate) fn loosely(node: &Node) -> String {
    match &node.kind {
        Kind::Product(_) => spelled(node),
        Kind::Group(_, inner) => loosely(inner),
        _ => letter(node, false),
    }
}

/// A letter as one word, and anything else in LaTeX.
fn letter(node: &Node, exactly: bool) -> String {
    let labelled = raised_label(node);
    let symbol = match &node.kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => labelled.as_ref(),
    };
    symbol.map_or_else(|| print::latex(node), |symbol| spell(symbol, exactly))
}

/// `h^b` as a letter with a label: a document may show by other lines that it is one, and a sentence alone does not.
fn raised_label(node: &Node) -> Option<Symbol> {
    let Kind::Power(base, exponent) = &node.kind else {
        return None;
    };
    let (Kind::Symbol(base), Kind::Symbol(label)) = (&base.kind, &exponent.kind) else {
        return None;
    };
    let lone = Symbol {
        name: label.name.clone(),
        ..Symbol::default()
    };
    let mut labelled = base.clone();
    labelled.superscripts.push(label.name.clone());
    (*label == lone && label.name.len() == 1 && base.primes == 0).then_some(labelled)
}

/// A symbol with its marks and labels, as one word.
pub(crate) fn spell(symbol: &Symbol, exactly: bool) -> String {
    let style = symbol.style;
    let mut word = symbol.name.clone();
    let mut mark = |is: bool, name: &str| {
        if is {
            word.push('~');
            word.push_str(name);
        }
    };
    mark(style.hat, "hat");
    mark(style.tilde, "tilde");
    mark(style.other, "other");
    mark(style.calligraphic, "cal");
    mark(symbol.variation, "delta");
    if exactly {
        mark(style.vector, "vector");
        mark(style.tensor, "tensor");
        mark(style.bar, "bar");
    }
    for label in &symbol.subscripts {
        word.push('_');
        word.push_str(&plain(label));
    }
    for label in &symbol.superscripts {
        word.push('^');
        word.push_str(&plain(label));
    }
    for _ in 0..symbol.primes {
        word.push('\'');
    }
    word
}

/// The same with those that carry labels as they are written.
pub(crate) fn letters_and_names(node: &Node) -> BTreeSet<String> {
    let mut names = letter_names(node);
    if let Some(labelled) = labelled_letter(node) {
        names.insert(labelled);
    }
    names.extend(node.children().flat_map(letters_and_names));
    names
}

/// A letter with labels, as it is written without marks.
pub(crate) fn labelled_letter(node: &Node) -> Option<String> {
    match &node.kind {
        Kind::Symbol(s) if !s.subscripts.is_empty() || !s.superscripts.is_empty() => {
            Some(loosely(node))
        }
        _ => None,
    }
}

/// The letters of a formula without marks and labels.
pub(crate) fn letter_names(node: &Node) -> BTreeSet<String> {
    let mut names = BTreeSet::new();
    if let Kind::Symbol(symbol) = &node.kind {
        names.insert(symbol.name.clone());
    }
    names.extend(node.children().flat_map(letter_names));
    names
}
