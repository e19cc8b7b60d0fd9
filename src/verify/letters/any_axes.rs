//! Documents that write vectors and tensors as wholes: what such lines say holds on any axes of the body or on none, so
//! that the axes may be chosen, and principal ones make what is computed short.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::{Document, Item, Row};
use crate::verify::check::Checker;
use crate::verify::letters::attitude_reading::Part;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{axes, axis, symbols};
use crate::verify::values::quantity::Quantity;

/// Names of unit vectors along axes, and of the axes.
const UNITS: &[&str] = &["i", "j", "k", "x", "y", "z"];

impl Reading {
    /// Whether no component, unit vector, grid of numbers or number of a quaternion is written anywhere.
    pub(crate) fn writes_no_components(&self, document: &Document) -> bool {
        let rows = document.items.iter().filter_map(|item| match item {
            Item::Formula(formula) => Some(&formula.rows),
            _ => None,
        });
        let mut nodes = rows.flatten().flat_map(|row| match row {
            Row::Line(line) => line.sides.iter().collect(),
            Row::Expression(node) => vec![node],
            Row::Unreadable { .. } => vec![],
        });
        let inertia = self.quantities.values().any(|q| *q == Quantity::Inertia);
        let one_axis = self.plane || self.fixed_axis.is_some() || self.symmetric;
        let named = one_axis || self.euler_angles.is_some() || !self.components.is_empty();
        inertia && !named && nodes.all(|node| self.is_of_wholes(node))
    }

    fn is_of_wholes(&self, node: &Node) -> bool {
        let whole = symbols(node).into_iter().all(|symbol| {
            let indexed = |s: &String| axis(s).is_some() || axes(s).is_some();
            let component = symbol.subscripts.iter().any(indexed);
            let number = self
                .attitude
                .part(symbol)
                .is_some_and(|part| matches!(part, Part::Number(_)));
            !number
                && !UNITS.contains(&symbol.name.as_str())
                && (!component || self.usage.wholes.is_vector(symbol))
        });
        whole && !holds_grid(node)
    }
}

impl Checker<'_> {
    /// Chooses principal axes.
    pub(crate) fn choose_axes(&mut self) {
        let name = "principal axes, as they may be chosen: the products of inertia vanish";
        self.vanish(name, Quantity::Inertia, &[3, 4, 5]);
        self.scopes.retain(|(scope, _)| scope != name);
    }
}

fn holds_grid(node: &Node) -> bool {
    matches!(
        node.kind,
        Kind::Matrix(_) | Kind::Determinant(_) | Kind::Tuple(_)
    ) || node.children().any(holds_grid)
}
