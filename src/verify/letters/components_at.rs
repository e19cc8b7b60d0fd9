//! Components of a function that words take at a state: "where ⟨f_i⟩ are the components of ⟨f(ω_k)⟩".

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::{Document, Formula, Item, Row};
use crate::verify::letters::usage::{axis, inner};

/// Writes the state behind the components in the section where words say at which the function is taken.
pub(crate) fn take_components_at(document: &mut Document) {
    let said: Vec<(usize, String, Vec<Node>)> = (document.items.windows(3).enumerate())
        .filter_map(|(at, items)| said(items).map(|(name, place)| (at, name, place)))
        .collect();
    for (at, name, place) in said {
        let heading = |item: &Item| matches!(item, Item::Heading { .. });
        let (before, behind) = document.items.split_at_mut(at);
        let opens = before.iter().rposition(heading).unwrap_or_default();
        let closes = behind.iter().position(heading).unwrap_or(behind.len());
        let section = before[opens..].iter_mut().chain(&mut behind[..closes]);
        let rows = section.filter_map(|item| match item {
            Item::Formula(formula) => Some(&mut formula.rows),
            _ => None,
        });
        let lines = rows.flatten().filter_map(|row| match row {
            Row::Line(line) => Some(line),
            _ => None,
        });
        // A line that says what a component is names it.
        let names =
            |side: &Node| matches!(&inner(side).kind, Kind::Symbol(s) if is_component(s, &name));
        for line in lines.filter(|line| !line.sides.first().is_some_and(names)) {
            line.sides
                .iter_mut()
                .for_each(|side| put_at(side, &name, &place));
        }
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

fn is_component(symbol: &Symbol, name: &str) -> bool {
    let single =
        matches!(symbol.subscripts.as_slice(), [index] if axis(index).is_some() || index == "i");
    symbol.name == name && single
}

fn put_at(node: &mut Node, name: &str, place: &[Node]) {
    match &node.kind {
        // It says itself where.
        Kind::Call(..) | Kind::Derivative { .. } => return,
        Kind::Symbol(symbol) if is_component(symbol, name) => {
            node.kind = Kind::Call(Box::new(node.clone()), place.to_vec());
            return;
        }
        _ => {}
    }
    let children = node.children_mut().into_iter();
    children.for_each(|child| put_at(child, name, place));
}
