//! Axes of the body with names other than x, y, z and 1, 2, 3: `I_\xi\dot\omega_\xi`, `\omega_a`. Their labels are read as
//! the numbers of the axes.

use crate::notation::ast::Node;
use crate::notation::document::{Document, Item, Row};
use crate::verify::letters::point_labels::formulas_mut;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::axis;
use crate::verify::words::book::lowered;

/// The triads.
const TRIADS: &[[&str; 3]] = &[
    ["xi", "eta", "zeta"],
    ["ξ", "η", "ζ"],
    ["a", "b", "c"],
    ["u", "v", "w"],
];
const TURNING: &[&str] = &["omega", "Omega", "w"];
const BODY: &[&str] = &["I", "J", "Theta", "L", "H", "M"];
/// Words right before the name of an axis.
const BEFORE: &[&str] = &[
    "about",
    "about the",
    "around",
    "around the",
    "axis",
    "axes",
    "along",
    "along the",
];

/// The labels of the axes in their order.
pub(crate) type Labels = [&'static str; 3];

/// Writes numbers for the labels of axes that angular velocities and moments have.
pub(crate) fn number_named_axes(document: &mut Document) -> Option<Labels> {
    let labels = labels(document)?;
    for node in formulas_mut(document) {
        node.change_symbols(&mut |symbol| {
            for index in &mut symbol.subscripts {
                if let Some(number) = numbers(index, &labels) {
                    *index = number;
                }
            }
        });
    }
    name_axes_of_words(document, &labels);
    Some(labels)
}

fn labels(document: &Document) -> Option<Labels> {
    let all = every_symbol(document);
    let has = |names: &[&str], index: &str| {
        let mut own = all.iter().filter(|s| names.contains(&s.name.as_str()));
        own.any(|s| s.subscripts.iter().any(|i| i == index))
    };
    // Beside components on other axes of either name, they are another set.
    let others = all.iter().any(|s| {
        let own = TURNING.contains(&s.name.as_str()) || BODY.contains(&s.name.as_str());
        own && s.subscripts.iter().any(|index| axis(index).is_some())
    });
    let named = |labels: &&Labels| {
        let each = |names: &[&str]| labels.iter().all(|label| has(names, label));
        each(TURNING) && labels.iter().any(|label| has(BODY, label))
    };
    TRIADS.iter().filter(|_| !others).find(named).copied()
}

/// An index of one or two labels in numbers.
fn numbers(index: &str, labels: &Labels) -> Option<String> {
    let place = |label: &str| {
        labels
            .iter()
            .position(|name| *name == label)
            .map(|at| at + 1)
    };
    if let Some(one) = place(index) {
        return Some(one.to_string());
    }
    let index: String = index
        .chars()
        .filter(|c| !c.is_whitespace() && *c != ',')
        .collect();
    labels.iter().find_map(|first| {
        let second = place(index.strip_prefix(first)?)?;
        Some(format!("{}{second}", place(first)?))
    })
}

/// The lone letter behind "about" and "axis" is a name.
fn name_axes_of_words(document: &mut Document, labels: &Labels) {
    let mut behind = false;
    for item in &mut document.items {
        match item {
            Item::Prose { text, .. } => {
                let text = lowered(text);
                let text = text.trim();
                let lists = behind && matches!(text, "," | "and" | ", and" | "or");
                behind = lists || BEFORE.iter().any(|words| text.ends_with(words));
            }
            Item::Formula(formula) if behind && !formula.display => {
                if let [Row::Expression(node)] = formula.rows.as_mut_slice() {
                    rename(node, labels);
                }
            }
            _ => behind = false,
        }
    }
}

fn rename(node: &mut Node, labels: &Labels) {
    node.change_symbols(&mut |symbol| {
        let axes = ["x", "y", "z"];
        let bare = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
        let place = labels
            .iter()
            .position(|name| *name == symbol.name)
            .filter(|_| bare);
        if let Some(at) = place {
            axes[at].clone_into(&mut symbol.name);
        }
    });
}

/// The label of an axis in an index of numbers, as the document writes it.
pub(crate) fn written(index: &str, labels: &Labels) -> String {
    let label = |c: char| {
        let at = c.to_digit(10).and_then(|digit| digit.checked_sub(1));
        let label = at.and_then(|at| labels.get(at as usize));
        label.map_or_else(
            || c.to_string(),
            |label| match label.len() {
                1 => (*label).to_owned(),
                _ if label.is_ascii() => format!("\\{label}"),
                _ => (*label).to_owned(),
            },
        )
    };
    index.chars().map(label).collect::<Vec<_>>().join(" ")
}
