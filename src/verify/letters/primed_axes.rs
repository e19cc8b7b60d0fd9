//! Axes with primes that are parallel to those without: `I_{x'}` is the moment about x through another point.

use crate::notation::ast::{Node, Symbol};
use crate::notation::document::{Document, Item};
use crate::verify::letters::point_labels::{COORDINATES, formulas_mut};
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::{axes, axis, symbols};
use crate::verify::words::book::has_any;

/// Words of axes that are moved and not turned.
const PARALLEL: &[&str] = &[
    "parallel-axis",
    "parallel axis",
    "parallel axes",
    "steiner",
    "without turning",
];
/// Words of axes that are turned.
const TURNED: &[&str] = &["rotate", "turned", "inclined", "rotation of the axes"];
/// The labels of the mass centre and of the other point.
const CENTRE: &str = "G";
const OTHER: &str = "O";

/// Writes a label for the primes on the indices of inertia, momentum and moment, and none on those of ω, where the words
/// have the axes moved alone.
pub(crate) fn label_primed_axes(document: &mut Document) {
    let mut texts = document.items.iter().filter_map(|item| match item {
        Item::Prose { text, .. } | Item::Heading { text, .. } => Some(text.to_lowercase()),
        _ => None,
    });
    let said = texts.clone().any(|text| has_any(&text, PARALLEL));
    let turned = |text: String| {
        let mut sentences = text.split(". ");
        sentences.any(|s| s.contains("axes") && has_any(s, TURNED))
    };
    let inertia = |s: &&Symbol| matches!(s.name.as_str(), "I" | "J");
    let index = |s: &Symbol, is: fn(&str) -> bool| s.subscripts.iter().any(|i| is(i));
    let related = |sides: &[Node]| {
        let all: Vec<&Symbol> = sides.iter().flat_map(symbols).collect();
        let mass = all.iter().any(|s| matches!(s.name.as_str(), "m" | "M"));
        let mut tensors = all.iter().copied().filter(inertia);
        let primed = tensors.clone().any(|s| index(s, |i| unprimed(i).is_some()));
        let plain = tensors.any(|s| index(s, |i| axis(i).is_some() || axes(i).is_some()));
        mass && primed && plain
    };
    let relates = document.lines().any(|line| related(&line.sides));
    let taken = |s: &&Symbol| s.subscripts.iter().any(|i| i == OTHER || i == CENTRE);
    let taken = every_symbol(document).iter().any(taken);
    if !said || texts.any(turned) || !relates || taken {
        return;
    }
    for node in formulas_mut(document) {
        node.change_symbols(&mut |symbol| {
            if COORDINATES.contains(&symbol.name.as_str()) && symbol.subscripts.is_empty() {
                symbol.primes = 0;
            }
            let tensor = matches!(symbol.name.as_str(), "I" | "J");
            let Some(index) = symbol.subscripts.iter().find_map(|i| unprimed(i)) else {
                if tensor && symbol.subscripts.len() == 1 {
                    symbol.subscripts.push(CENTRE.to_owned());
                }
                return;
            };
            symbol.subscripts.retain(|i| unprimed(i).is_none());
            symbol.subscripts.push(index);
            if tensor || matches!(symbol.name.as_str(), "L" | "H" | "M") {
                symbol.subscripts.push(OTHER.to_owned());
            }
        });
    }
}

/// An index of a component or an entry without the primes on each letter of it.
fn unprimed(index: &str) -> Option<String> {
    let bare: String = index.chars().filter(|c| *c != '\'').collect();
    let primes = index.len() - bare.len();
    let each = primes == bare.len() && primes > 0;
    (each && (axis(&bare).is_some() || axes(&bare).is_some())).then_some(bare)
}
