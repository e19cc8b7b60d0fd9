//! Components of a function that words take at a state: "where ⟨f_i⟩ are the components of ⟨f(ω_k)⟩".

use crate::notation::ast::{Kind, Line, Node, Symbol};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::verify::letters::usage::{axis, inner};
use std::collections::BTreeMap;

/// Writes the state behind the components in the section where words say at which the function is taken.
pub(crate) fn take_components_at(document: &mut Document) {
    let heading = |item: &Item| matches!(item, Item::Heading { .. });
    for section in document.items.chunk_by_mut(|_, next| !heading(next)) {
        let taken: BTreeMap<String, Vec<Node>> = section.windows(3).filter_map(said).collect();
        if taken.is_empty() {
            continue;
        }
        let rows = section.iter_mut().filter_map(|item| match item {
            Item::Formula(formula) => Some(&mut formula.rows),
            _ => None,
        });
        for row in rows.flatten() {
            if let Row::Line(line) = row {
                put_in_line(line, &taken);
            }
        }
    }
}

/// A line that says what a component is names it.
fn put_in_line(line: &mut Line, taken: &BTreeMap<String, Vec<Node>>) {
    let named = match line.sides.first().map(|side| &inner(side).kind) {
        Some(Kind::Symbol(symbol)) if is_component(symbol) => Some(symbol.name.clone()),
        _ => None,
    };
    let place = |symbol: &Symbol| {
        let other = is_component(symbol) && named.as_ref() != Some(&symbol.name);
        taken.get(&symbol.name).filter(|_| other)
    };
    for side in &mut line.sides {
        put_at(side, &place);
    }
}

/// The function and the state of such words.
fn said(items: &[Item]) -> Option<(String, Vec<Node>)> {
    let [
        Item::Formula(part),
        Item::Prose { text, .. },
        Item::Formula(whole),
    ] = items
    else {
        return None;
    };
    let text = text.trim().to_lowercase();
    let verb = ["are", "is", "denote", "denotes", "mean", "means"];
    let verb = verb
        .iter()
        .any(|verb| text.starts_with(&format!("{verb} ")));
    let of = ["components of", "component of", "entries of"];
    if !verb || text.len() > 40 || !of.iter().any(|words| text.ends_with(words)) {
        return None;
    }
    let (Kind::Symbol(part), Kind::Call(head, place)) = (&alone(part)?.kind, &alone(whole)?.kind)
    else {
        return None;
    };
    let Kind::Symbol(head) = &inner(head).kind else {
        return None;
    };
    let one = part.name == head.name && part.subscripts.len() == 1 && head.subscripts.is_empty();
    one.then(|| (head.name.clone(), place.clone()))
}

/// The expression that a formula is.
fn alone(formula: &Formula) -> Option<&Node> {
    match formula.rows.as_slice() {
        [Row::Expression(node)] => Some(inner(node)),
        _ => None,
    }
}

fn is_component(symbol: &Symbol) -> bool {
    matches!(symbol.subscripts.as_slice(), [index] if axis(index).is_some() || index == "i")
}

fn put_at<'p>(node: &mut Node, place: &impl Fn(&Symbol) -> Option<&'p Vec<Node>>) {
    match &node.kind {
        // It says itself where.
        Kind::Call(..) | Kind::Derivative { .. } => return,
        Kind::Symbol(symbol) => {
            if let Some(place) = place(symbol) {
                node.kind = Kind::Call(Box::new(node.clone()), place.clone());
            }
            return;
        }
        _ => {}
    }
    let children = node.children_mut().into_iter();
    children.for_each(|child| put_at(child, place));
}
