//! What kind of body the letters of a document speak of: one on principal axes, one with wheels in it.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Document;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, axes, inner};
use crate::verify::values::quantity::Quantity;

impl Reading {
    /// Whether products of inertia are written, I_xy or I_12.
    pub(crate) fn writes_products(&self) -> bool {
        let inertia = |(_, q): &(&Letter, &Quantity)| **q == Quantity::Inertia;
        let letters = self.quantities.iter().filter(inertia);
        let indices = letters.filter_map(|(letter, _)| self.usage.subscripts.get(letter));
        let mut pairs = indices.flatten().filter_map(|s| axes(s));
        pairs.any(|(r, c)| r != c)
    }

    /// The letter of which only products of inertia are written, P_12 and P_13 beside I_11 and I_22.
    pub(crate) fn products_apart(&mut self) {
        let moments = self.quantities.values().any(|q| *q == Quantity::Inertia);
        if !moments || self.writes_products() {
            return;
        }
        let pairs = |letter: &Letter| {
            let met = self.usage.subscripts.get(letter);
            let pair = |s: &String| {
                let unprimed = s.replace('\'', "");
                axes(&unprimed).is_some_and(|(row, column)| row != column)
            };
            met.is_some_and(|met| met.len() > 1 && met.iter().all(pair))
        };
        let free = |letter: &Letter| {
            let used = self.usage.get(letter);
            used.vector + used.naked + used.component == 0
                && !self.quantities.contains_key(letter)
                && !self.components.contains_key(letter)
        };
        let mut letters = self.usage.letters().map(|(letter, _)| letter);
        let found = letters.find(|l| pairs(l) && free(l)).cloned();
        if let Some(letter) = found {
            self.quantities.insert(letter, Quantity::Inertia);
        }
    }

    /// Whether the moments I_11, I_22, I_33 or A, B, C are written, and nowhere a product or the word for one.
    pub(crate) fn writes_only_diagonal(&self) -> bool {
        let inertia = |(_, q): &(&Letter, &Quantity)| **q == Quantity::Inertia;
        let letters = self.quantities.iter().filter(inertia);
        let indices = letters.filter_map(|(letter, _)| self.usage.subscripts.get(letter));
        let entries = indices.flatten().filter_map(|s| axes(s));
        let mut diagonal = entries.map(|(r, c)| r == c).collect::<Vec<_>>();
        let named = self
            .components
            .values()
            .filter(|(q, _)| *q == Quantity::Inertia);
        diagonal.extend(named.map(|(_, component)| *component < 3));
        !diagonal.is_empty() && diagonal.into_iter().all(|d| d) && !self.speaks_of_products
    }

    /// Whether the inertia is written as a matrix of two rows: all turning is in the plane of the first two axes.
    pub(crate) fn tensors_are_plane(&self) -> bool {
        let plane = |letter: &Letter| self.usage.squares.get(letter) == Some(&2);
        let mut quantities = self.quantities.iter();
        quantities.any(|(letter, q)| *q == Quantity::Inertia && plane(letter))
    }

    /// Beside an ω, an Ω with components that the words call the speeds of wheels is a list of them.
    pub(crate) fn wheel_speeds(&mut self) {
        let letter = Letter::plain("Omega");
        if self.has_wheel_speeds(&letter) && self.usage.get(&letter).component > 0 {
            self.usage.letters.entry(letter).or_default().vector += 1;
        }
    }

    /// Whether a letter is that of the speeds of wheels.
    pub(crate) fn has_wheel_speeds(&self, letter: &Letter) -> bool {
        letter.name == "Omega"
            && self.speaks_of_wheels
            && self.has("omega")
            && self.apart.contains(letter)
            && !self.quantities.contains_key(letter)
    }
}

/// Whether a product of inertia stands somewhere as an integral or a sum, `P = ∫ xy dm`, whatever it is called.
pub(crate) fn integrates_a_product(document: &Document) -> bool {
    let mut sides = document.lines().flat_map(|line| &line.sides);
    sides.any(|side| match &inner(side).kind {
        Kind::Negate(inside) => is_product_integral(inner(inside)),
        _ => is_product_integral(inner(side)),
    })
}

fn is_product_integral(node: &Node) -> bool {
    let (Kind::Integral { integrand, .. }
    | Kind::IndexedSum {
        body: integrand, ..
    }) = &node.kind
    else {
        return false;
    };
    let integrand = match &inner(integrand).kind {
        Kind::Negate(inside) => inner(inside),
        _ => inner(integrand),
    };
    let Kind::Product(factors) = &integrand.kind else {
        return false;
    };
    let coordinate = |name: &str| {
        factors.iter().any(|factor| {
            matches!(&factor.node.kind, Kind::Symbol(s) if s.name == name && s.superscripts.is_empty())
        })
    };
    let among = ["x", "y", "z"].into_iter().filter(|name| coordinate(name));
    among.count() == 2
}
