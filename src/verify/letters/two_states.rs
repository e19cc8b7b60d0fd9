//! Two states of a body that turns about one axis: in `I_1 ω_1 = I_2 ω_2` the numbers name no axes.
//!
//! What is written with an index in such a document stands before a change or behind it, and wears a label then.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::inner;

/// The letters of the moment of inertia and of the rate.
#[derive(Clone, Debug)]
pub(crate) struct TwoStates {
    inertia: String,
    rate: String,
}

impl TwoStates {
    /// The moment of inertia and the rate before the change, and behind it.
    pub(crate) fn symbols(&self) -> [[Symbol; 2]; 2] {
        ["1", "2"].map(|state| {
            [&self.inertia, &self.rate].map(|name| Symbol {
                name: name.clone(),
                subscripts: vec![label(state)],
                ..Symbol::default()
            })
        })
    }
}

/// Tells two states apart by labels, where a document sets their momenta equal and numbers no axes.
pub(crate) fn tell_states_apart(document: &mut Document) -> Option<TwoStates> {
    let states = document
        .lines()
        .find_map(|line| match line.sides.as_slice() {
            [left, right] => {
                let (before, behind) = (momentum(left)?, momentum(right)?);
                let same = before.inertia == behind.inertia && before.rate == behind.rate;
                let numbered = |side: &Momentum, state: &str| side.state == state;
                let both = numbered(&before, "1") && numbered(&behind, "2")
                    || numbered(&before, "2") && numbered(&behind, "1");
                (same && both).then_some(TwoStates {
                    inertia: before.inertia,
                    rate: before.rate,
                })
            }
            _ => None,
        })?;
    let named = |symbol: &Symbol| [&states.inertia, &states.rate].contains(&&symbol.name);
    let numbers = |symbol: &Symbol| {
        let labels = symbol.subscripts.iter().map(String::as_str);
        !symbol.style.vector && labels.clone().all(|s| matches!(s, "1" | "2")) && labels.count() < 2
    };
    let all = every_symbol(document);
    let third = all.iter().any(|s| s.subscripts.iter().any(|s| s == "3"));
    let told = !third && all.into_iter().filter(|s| named(s)).all(numbers);
    let moves = document
        .lines()
        .flat_map(|line| &line.sides)
        .any(|side| has_rate(side, &states.rate));
    if !told || moves {
        return None;
    }
    for node in formulas_mut(document) {
        node.change_symbols(&mut |symbol| {
            if let [state] = symbol.subscripts.as_slice()
                && matches!(state.as_str(), "1" | "2")
            {
                symbol.subscripts = vec![label(state)];
            }
        });
    }
    Some(states)
}

fn label(state: &str) -> String {
    format!("({state})")
}

struct Momentum {
    inertia: String,
    rate: String,
    state: String,
}

/// `I_1 ω_1`.
fn momentum(side: &Node) -> Option<Momentum> {
    let Kind::Product(factors) = &inner(side).kind else {
        return None;
    };
    let [first, second] = factors.as_slice() else {
        return None;
    };
    let lone = |node: &Node| match &inner(node).kind {
        Kind::Symbol(symbol) => Some((symbol.name.clone(), symbol.subscripts.clone())),
        _ => None,
    };
    let (inertia, state) = lone(&first.node)?;
    let (rate, other) = lone(&second.node)?;
    let letters = ["I", "J", "Theta", "C"].contains(&inertia.as_str())
        && ["omega", "Omega", "w", "n"].contains(&rate.as_str());
    let [state] = state.as_slice() else {
        return None;
    };
    (letters && other.as_slice() == [state.clone()]).then(|| Momentum {
        inertia,
        rate,
        state: state.clone(),
    })
}

/// Whether a rate of the symbols of a letter stands in a node.
fn has_rate(node: &Node, name: &str) -> bool {
    let mut met = matches!(&node.kind, Kind::TimeDerivative { operand, .. }
        if matches!(&inner(operand).kind, Kind::Symbol(s) if s.name == name));
    node.children()
        .for_each(|child| met |= has_rate(child, name));
    met
}
