//! Letters to which the words give one quantity, and which the document adds to one another: the control torque beside the
//! external one. One of them at most is the whole.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes, axis, inner};
use crate::verify::values::quantity::Quantity;
use num_traits::Signed;
use std::collections::BTreeSet;

impl Reading {
    /// Of moments or momenta that are added to one another, those that a line of its own tells are symbols of the
    /// document, and the others too where several are left.
    pub(crate) fn part_rivals(&mut self, document: &Document) {
        let sums: Vec<BTreeSet<Letter>> = document
            .lines()
            .flat_map(|line| &line.sides)
            .flat_map(sums)
            .collect();
        for quantity in [Quantity::Moment, Quantity::Momentum] {
            let own = |letter: &&Letter| self.quantities.get(*letter) == Some(&quantity);
            let rivals: BTreeSet<Letter> = sums
                .iter()
                .map(|sum| sum.iter().filter(own).cloned().collect::<Vec<_>>())
                .filter(|letters| letters.len() > 1)
                .flatten()
                .collect();
            let told = |letter: &&Letter| self.left_sides.contains(letter);
            let untold = rivals.iter().filter(|l| !told(l)).count();
            let parted = rivals.iter().filter(|l| told(l) || untold > 1);
            for letter in parted.cloned().collect::<Vec<_>>() {
                self.quantities.remove(&letter);
            }
        }
    }

    /// In a document about wheels, of two momenta in `\mathbf H = \mathbf J\boldsymbol\omega + \mathbf h` the one that is added is theirs.
    pub(crate) fn part_stored(&mut self, document: &Document) {
        if !self.speaks_of_wheels {
            return;
        }
        let momentum = |letter: &Letter| self.quantities.get(letter) == Some(&Quantity::Momentum);
        let stored = document.lines().find_map(|line| {
            let [left, right] = line.sides.as_slice() else {
                return None;
            };
            let Kind::Symbol(whole) = &inner(left).kind else {
                return None;
            };
            let whole = Letter::of(whole);
            let mut added = sums(right).into_iter().flatten();
            added.find(|letter| *letter != whole && momentum(&whole) && momentum(letter))
        });
        if let Some(letter) = stored {
            self.quantities.insert(letter, Quantity::RelativeMomentum);
        }
    }

    /// Of two tensors in `\mathbf J = R\,\mathbf I R^T`, the one that is turned to is a symbol of the document.
    pub(crate) fn part_turned_tensor(&mut self, document: &Document) {
        let inertia = |letter: &Letter| self.quantities.get(letter) == Some(&Quantity::Inertia);
        let turned = document.lines().find_map(|line| {
            let [left, right] = line.sides.as_slice() else {
                return None;
            };
            let (Kind::Symbol(new), Kind::Product(factors)) =
                (&inner(left).kind, &inner(right).kind)
            else {
                return None;
            };
            let [matrix, old, back] = factors.as_slice() else {
                return None;
            };
            let undone = match (&inner(&matrix.node).kind, &inner(&back.node).kind) {
                (Kind::Transpose(inside), other) | (other, Kind::Transpose(inside)) => {
                    inner(inside).kind == *other
                }
                _ => false,
            };
            let Kind::Symbol(old) = &inner(&old.node).kind else {
                return None;
            };
            let (new, old) = (Letter::of(new), Letter::of(old));
            (undone && new != old && inertia(&new) && inertia(&old)).then_some(new)
        });
        // Both may be one tensor, on the axes of space and on those of the body.
        if let Some(letter) = turned.filter(|_| self.attitude.matrix.is_none()) {
            self.quantities.remove(&letter);
        }
    }

    /// Of two letters of the inertia in `J = I^{-1}`, the inverse is a symbol of the document.
    pub(crate) fn part_inverse_tensor(&mut self, document: &Document) {
        let inertia = |letter: &Letter| self.quantities.get(letter) == Some(&Quantity::Inertia);
        let inverse = document.lines().find_map(|line| {
            let [left, right] = line.sides.as_slice() else {
                return None;
            };
            let (Kind::Symbol(new), Kind::Power(old, exponent)) =
                (&inner(left).kind, &inner(right).kind)
            else {
                return None;
            };
            let Kind::Symbol(old) = &inner(old).kind else {
                return None;
            };
            let below = matches!(&inner(exponent).kind, Kind::Negate(_))
                || matches!(&inner(exponent).kind, Kind::Number(n) if n.value.is_negative());
            let (new, old) = (Letter::of(new), Letter::of(old));
            (below && new != old && inertia(&new) && inertia(&old)).then_some(new)
        });
        if let Some(letter) = inverse {
            self.quantities.remove(&letter);
        }
    }

    /// A torque that a line sets to the rate of the wheels' momentum, `\mathbf u = -\dot{\mathbf h}`, is the one that they
    /// exert, and no moment from outside.
    pub(crate) fn part_wheel_torques(&mut self, document: &Document) {
        let is = |letter: &Letter, quantity| self.quantities.get(letter) == Some(&quantity);
        let rate_of_wheels = |side: &Node| {
            let side = match &inner(side).kind {
                Kind::Negate(inside) => inner(inside),
                _ => inner(side),
            };
            let Kind::TimeDerivative { operand, .. } = &side.kind else {
                return false;
            };
            matches!(&inner(operand).kind, Kind::Symbol(s)
                if is(&Letter::of(s), Quantity::RelativeMomentum))
        };
        let torques = document
            .lines()
            .filter_map(|line| match line.sides.as_slice() {
                [left, right] if rate_of_wheels(right) => match &inner(left).kind {
                    Kind::Symbol(torque) => Some(Letter::of(torque)),
                    _ => None,
                },
                _ => None,
            });
        let torques: Vec<Letter> = torques.filter(|l| is(l, Quantity::Moment)).collect();
        for letter in torques {
            self.quantities.remove(&letter);
            self.apart.insert(letter);
        }
    }
}

/// Whether the three differences of A, B and C stand in a document, as they do in Euler's equations.
pub(crate) fn has_differences(document: &Document) -> bool {
    let sums: Vec<BTreeSet<Letter>> = document
        .lines()
        .flat_map(|line| &line.sides)
        .flat_map(sums)
        .collect();
    let pairs = [["A", "B"], ["B", "C"], ["A", "C"]];
    pairs
        .iter()
        .all(|pair| sums.contains(&pair.iter().map(|name| Letter::plain(name)).collect()))
}

/// The letters of the terms of each sum in a tree, where a term is a symbol by itself.
fn sums(node: &Node) -> Vec<BTreeSet<Letter>> {
    fn collect(node: &Node, found: &mut Vec<BTreeSet<Letter>>) {
        node.children().for_each(|child| collect(child, found));
        if let Kind::Sum(terms) = &node.kind {
            found.push(terms.iter().filter_map(|term| lone(&term.node)).collect());
        }
    }
    fn lone(node: &Node) -> Option<Letter> {
        match &inner(node).kind {
            Kind::Symbol(symbol) if symbol.subscripts.iter().all(|s| is_label(s)) => {
                Some(Letter::of(symbol))
            }
            _ => None,
        }
    }
    let mut found = vec![];
    collect(node, &mut found);
    found
}

/// Whether a subscript is no index of a component.
fn is_label(subscript: &str) -> bool {
    axis(subscript).is_none() && axes(subscript).is_none()
}
