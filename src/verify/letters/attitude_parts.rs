//! The parts of the quaternion that a line names: `q = (w, \mathbf u)`, `\mathbf u = (x, y, z)^T`, `Λ = (λ_0, λ_1, λ_2, λ_3)`.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::notation::document::Document;
use crate::verify::letters::attitude_reading::{AttitudeReading, Part, spelling};
use crate::verify::letters::usage::{Letter, inner, symbols};

impl AttitudeReading {
    /// Takes in what lines say of the whole, and then of the vector part; `taken` tells letters that stand for something
    /// else.
    pub(crate) fn name_parts(&mut self, document: &Document, taken: &impl Fn(&Letter) -> bool) {
        for line in document.lines() {
            let [left, list] = line.sides.as_slice() else {
                continue;
            };
            let (Kind::Symbol(whole), Some(entries)) = (&inner(left).kind, entries(list)) else {
                continue;
            };
            let free = entries
                .iter()
                .all(|s| !taken(&Letter::of(s)) || self.part(s).is_some());
            match (self.part(whole), entries.as_slice()) {
                _ if !free => {}
                (Some(Part::Whole), [first, second]) => self.name_two(first, second),
                (Some(Part::Whole), [_, _, _, _]) => self.name_four(&entries),
                (Some(Part::Vector), [_, _, _]) => self.name_numbers(&entries, 1),
                (None, [_, _, _, _]) if self.are_its_numbers(&entries) => {
                    self.parts.insert(spelling(whole), Part::Whole);
                }
                _ => {}
            }
        }
    }

    /// Whether the quaternion is a factor beside an `\otimes` somewhere in a formula.
    pub(crate) fn has_circled_product(&self, node: &Node) -> bool {
        let own = |s: &&Symbol| matches!(self.part(s), Some(Part::Whole | Part::Conjugate));
        let circled = match &node.kind {
            Kind::Product(factors) => {
                factors.iter().any(|f| f.operator == Operator::Tensor)
                    && factors.iter().any(|f| symbols(&f.node).iter().any(own))
            }
            _ => false,
        };
        circled || node.children().any(|child| self.has_circled_product(child))
    }

    /// The scalar and the vector part, told apart by the mark of a vector.
    fn name_two(&mut self, first: &Symbol, second: &Symbol) {
        let (scalar, vector) = match (first.style.vector, second.style.vector) {
            (false, true) => (first, second),
            (true, false) => (second, first),
            _ => return,
        };
        self.scalar_last = first.style.vector;
        self.parts.insert(spelling(scalar), Part::Number(0));
        self.parts.insert(spelling(vector), Part::Vector);
    }

    /// The four numbers by letters of their own.
    fn name_four(&mut self, entries: &[&Symbol]) {
        if entries
            .iter()
            .any(|s| self.part(s).is_some() || s.style.vector)
        {
            return;
        }
        // (x, y, z, w) has the scalar last.
        let last = entries.last().is_some_and(|s| s.name == "w");
        self.scalar_last |= last;
        if self.scalar_last {
            self.name_numbers(&entries[..3], 1);
            self.name_numbers(&entries[3..], 0);
        } else {
            self.name_numbers(entries, 0);
        }
    }

    fn name_numbers(&mut self, entries: &[&Symbol], from: u8) {
        for (at, symbol) in entries.iter().enumerate() {
            let part = Part::Number(from + at as u8);
            self.parts.entry(spelling(symbol)).or_insert(part);
        }
    }

    /// Whether these are the four numbers of the quaternion, in the order of the document.
    fn are_its_numbers(&self, entries: &[&Symbol]) -> bool {
        let order = match self.scalar_last {
            true => [1, 2, 3, 0],
            false => [0, 1, 2, 3],
        };
        let mut pairs = entries.iter().zip(order);
        pairs.all(|(symbol, number)| self.part(symbol) == Some(Part::Number(number)))
    }
}

/// The lone symbols of a list, a row or a column.
fn entries(side: &Node) -> Option<Vec<&Symbol>> {
    let nodes: Vec<&Node> = match &inner(side).kind {
        Kind::Transpose(inside) => return entries(inside),
        Kind::Tuple(entries) => entries.iter().collect(),
        Kind::Matrix(rows) => rows.iter().flatten().collect(),
        _ => return None,
    };
    let lone = |node: &'_ Node| matches!(node.kind, Kind::Symbol(_));
    let all = nodes.iter().all(|node| lone(node));
    all.then(|| nodes.into_iter().flat_map(symbols).collect())
}
