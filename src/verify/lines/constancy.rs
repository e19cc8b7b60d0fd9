//! Lines that end with "= const".

use crate::notation::ast::{Bracket, DerivativeStyle, Kind, Node, Number, Term};
use num_traits::Zero;

/// `X = const` says that the rate of X is zero. Behind a longer chain the constant is written as the value with a rate
/// that adds nothing, `T = E = E + dE/dt`, so that the chain keeps its relations.
pub(crate) fn keep_their_value(sides: &mut [Node]) {
    let [before @ .., last] = sides else { return };
    if !matches!(&last.kind, Kind::Symbol(s) if s.name == "const" && s.style.upright) {
        return;
    }
    match before {
        [] => {}
        [value] => {
            value.kind = rate(value);
            last.kind = Kind::Number(Number {
                value: Zero::zero(),
                decimals: None,
                exponent: 0,
            });
        }
        [.., value] => {
            let rate = Node {
                kind: rate(value),
                ..last.clone()
            };
            let term = |node| Term {
                negative: false,
                sign: last.span,
                node,
            };
            let sum = Node {
                kind: Kind::Sum(vec![term(value.clone()), term(rate)]),
                ..last.clone()
            };
            // In brackets it is one value, of which no term is looked at alone.
            last.kind = Kind::Group(Bracket::Round, Box::new(sum));
        }
    }
}

fn rate(value: &Node) -> Kind {
    Kind::TimeDerivative {
        operand: Box::new(value.clone()),
        order: 1,
        style: DerivativeStyle::Dots,
        frame: None,
    }
}
