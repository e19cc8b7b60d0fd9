//! Lines with a sign that is left open: one of the two signs is meant.

use crate::notation::ast::{Kind, Node};
use crate::verify::language::messages;
use crate::verify::standing::chains::Link;
use crate::verify::standing::hold::{Held, Sides};
use crate::verify::standing::judge::Judge;
use num_traits::Zero;
use std::collections::BTreeSet;

impl Judge<'_> {
    /// A number is one of two where the product of its differences from both vanishes. `None` for a link without an open sign.
    pub(super) fn hold_either(&mut self, link: &Link<'_>) -> Option<Held> {
        let open = open_signs(&link.left) + open_signs(&link.right);
        if open == 0 {
            return None;
        }
        if open > 1 {
            return Some(Held::open(messages::OPEN_SIGNS));
        }
        let (mut unknown, mut product) = (vec![], None);
        for minus in [false, true] {
            let mut signed = link.clone();
            sign(signed.left.to_mut(), minus);
            sign(signed.right.to_mut(), minus);
            let sides = match self.sides(&signed, &BTreeSet::new()) {
                Ok(sides) => sides,
                Err(trouble) => return Some(self.hold_sides(link, Err(trouble))),
            };
            let [(left, right)] = &*sides.sides else {
                return Some(Held::open(messages::OPEN_SIGNS));
            };
            let difference = left.clone() - right.clone();
            unknown.extend(sides.unknown);
            product = Some(match product {
                None => difference,
                Some(other) => other * difference,
            });
        }
        unknown.sort();
        unknown.dedup();
        let sides = product.map(|product| (product, Zero::zero()));
        let product = Sides {
            sides: sides.into_iter().collect(),
            unknown,
            settles: None,
        };
        Some(self.weigh(link, product))
    }
}

/// How many signs are left open in a formula.
fn open_signs(node: &Node) -> usize {
    let own = usize::from(matches!(node.kind, Kind::PlusMinus(_)));
    own + node.children().map(open_signs).sum::<usize>()
}

/// Puts a sign where one is left open.
fn sign(node: &mut Node, minus: bool) {
    if let Kind::PlusMinus(inside) = &mut node.kind {
        let inside = inside.clone();
        node.kind = match minus {
            true => Kind::Negate(inside),
            false => inside.kind,
        };
    }
    for child in node.children_mut() {
        sign(child, minus);
    }
}
