//! Numbers of steps that are written where a power stands: `\omega^{n+1}`, the value after the step from `\omega^n`.
//!
//! No vector has a power with an unknown exponent, so `n + 1` over one counts steps, and then so does n over any other
//! symbol. It is put where such numbers stand elsewhere, under the symbol.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::raised::raised;
use crate::verify::letters::usage::inner;
use std::collections::BTreeSet;

/// Letters that count steps.
const COUNTERS: &[&str] = &["n", "k", "i", "j", "m", "s"];
/// Letters that stand for vectors and attitudes without a mark.
const STEPPED: &[&str] = &["omega", "Omega", "w", "L", "H", "h", "q", "Q", "R", "Pi"];

/// Puts numbers of steps that stand where powers do under their symbols.
pub(crate) fn lower_steps(document: &mut Document) {
    let mut counters = BTreeSet::new();
    document
        .lines()
        .flat_map(|line| &line.sides)
        .for_each(|side| note(side, &mut counters));
    if !counters.is_empty() {
        formulas_mut(document).for_each(|node| lower(node, &counters));
    }
}

/// Notes the n of an `n + 1` over a vector.
fn note(node: &Node, counters: &mut BTreeSet<String>) {
    let label = |symbol: &Symbol| symbol.superscripts.iter().find_map(|label| in_label(label));
    let found = match &node.kind {
        Kind::Symbol(symbol) => label(symbol).map(|step| (symbol, step)),
        _ => stepped(node),
    };
    if let Some((symbol, step)) = found
        && (symbol.style.vector || STEPPED.contains(&symbol.name.as_str()))
        && step.ends_with(|c: char| c.is_ascii_digit())
    {
        counters.insert(step[..1].to_owned());
    }
    node.children().for_each(|child| note(child, counters));
}

fn lower(node: &mut Node, counters: &BTreeSet<String>) {
    let counted = |step: &String| counters.contains(&step[..1]);
    if let Some(step) = stepped(node).map(|(_, step)| step).filter(counted)
        && let Kind::Power(base, _) = &mut node.kind
    {
        base.change_symbols(&mut |symbol| symbol.subscripts.push(step.clone()));
        node.kind = base.kind.clone();
    }
    if let Kind::Symbol(symbol) = &mut node.kind {
        for label in std::mem::take(&mut symbol.superscripts) {
            match in_label(&label).filter(counted) {
                Some(step) => symbol.subscripts.push(step),
                None => symbol.superscripts.push(label),
            }
        }
    }
    node.children_mut()
        .into_iter()
        .for_each(|child| lower(child, counters));
}

/// A symbol and the number of a step over it.
fn stepped(node: &Node) -> Option<(&Symbol, String)> {
    let (symbol, exponent) = raised(node)?;
    Some((symbol, step(inner(exponent))?))
}

/// The number of a step that a label is: `(k)`, `(k+1)`, `n`.
fn in_label(label: &str) -> Option<String> {
    let step: String = label.split_whitespace().collect();
    let step = step.trim_matches(['(', ')']);
    let (counter, gone) = (step.get(..1)?, step.get(1..)?);
    let number = gone.strip_prefix(['+', '-']);
    let digits = number.is_some_and(|n| !n.is_empty() && n.bytes().all(|b| b.is_ascii_digit()));
    (COUNTERS.contains(&counter) && (gone.is_empty() || digits)).then(|| step.to_owned())
}

/// `n`, `n+1`, `k-1`, `n+1/2`.
fn step(node: &Node) -> Option<String> {
    match &node.kind {
        Kind::Symbol(symbol) => {
            let bare = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
            let counts = bare && COUNTERS.contains(&symbol.name.as_str());
            counts.then(|| symbol.name.clone())
        }
        Kind::Sum(terms) => {
            let [first, second] = terms.as_slice() else {
                return None;
            };
            let sign = if second.negative { '-' } else { '+' };
            Some(format!(
                "{}{sign}{}",
                step(&first.node)?,
                number(&second.node)?
            ))
        }
        _ => None,
    }
}

fn number(node: &Node) -> Option<String> {
    match &inner(node).kind {
        Kind::Number(number) => Some(number.value.to_string()),
        Kind::Quotient(above, below) => Some(format!("{}/{}", number(above)?, number(below)?)),
        _ => None,
    }
}
