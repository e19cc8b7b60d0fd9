//! "`$dL = r\times v\,dm$`": what an element of a body adds to a whole. It says that the whole is the integral.

use crate::notation::ast::{Factor, Kind, Node, Operator};
use crate::verify::model::system::ELEMENT;
use crate::verify::standing::chains::Link;
use crate::verify::standing::judge::Judge;
use crate::verify::term::letters::spelled;
use std::borrow::Cow;

/// What an integral over a body runs over: its mass or its volume.
const MEASURES: [&str; 2] = ["m", "V"];

impl Judge<'_> {
    /// The link of a whole and the integral over its elements, in the place of one of their shares.
    pub(super) fn of_whole<'l>(&self, link: Link<'l>) -> Link<'l> {
        match self.whole_of_share(&link) {
            Some((left, right)) => Link {
                left: Cow::Owned(left),
                relation: link.relation,
                right: Cow::Owned(right),
            },
            None => link,
        }
    }

    fn whole_of_share(&self, link: &Link<'_>) -> Option<(Node, Node)> {
        let mut families = self.reading.system.families.iter();
        families.find(|family| family.name == ELEMENT)?;
        let Kind::Product(share) = &link.left.kind else {
            return None;
        };
        let [sign, whole] = share.as_slice() else {
            return None;
        };
        let own = spelled(&link.left);
        let told = self.reading.letters.find(&own, &own, &self.at, 0);
        let whole = (is_d(sign) && told.is_none()).then(|| whole.node.clone())?;
        let Kind::Product(factors) = &link.right.kind else {
            return None;
        };
        let [integrand @ .., sign, measure] = factors.as_slice() else {
            return None;
        };
        let measured = MEASURES.contains(&spelled(&measure.node).as_str());
        let integrand = (is_d(sign) && measured).then(|| product(integrand, &link.right))??;
        let kind = Kind::Integral {
            integrand: Box::new(integrand),
            variable: Box::new(measure.node.clone()),
            limits: None,
        };
        let span = link.right.span;
        Some((whole, Node { kind, span }))
    }
}

/// Whether a factor is the d of a differential.
fn is_d(factor: &Factor) -> bool {
    let lone = matches!(&factor.node.kind, Kind::Symbol(symbol) if symbol.name == "d");
    lone && factor.operator == Operator::Juxtaposed
}

/// The product of some factors; none if there are none.
fn product(factors: &[Factor], whole: &Node) -> Option<Node> {
    match factors {
        [] => None,
        [only] => Some(only.node.clone()),
        several => Some(Node {
            kind: Kind::Product(several.to_vec()),
            span: whole.span,
        }),
    }
}
