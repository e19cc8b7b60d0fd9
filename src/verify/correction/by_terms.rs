//! Whether a changed line may hold, told from the one term that is changed.
//!
//! Sides are sums: what is left of their difference is what each term adds to it. With one term changed all others add the
//! same, and only that one is worked out anew.

use crate::algebra::Fraction;
use crate::notation::ast::{DerivativeStyle, Kind, Line, Node, Number, Symbol};
use crate::source::Span;
use crate::verify::correction::slips::Change;
use crate::verify::standing::judge::Judge;
use num_rational::BigRational;
use num_traits::Zero;

/// A term of a side, and what it adds to the difference of the sides.
struct Term<'l> {
    node: &'l Node,
    negative: bool,
    adds: Fraction,
}

/// The terms of a false line.
pub(super) struct Terms<'l> {
    terms: Vec<Term<'l>>,
    sides: [(Span, Fraction); 2],
    /// What is left of the difference of the sides.
    left_over: Fraction,
}

impl<'l> Terms<'l> {
    /// Those of a line of two sides that are numbers; `None` where they do not add up to what is left of it.
    pub(super) fn of(judge: &mut Judge<'_>, line: &'l Line) -> Option<Self> {
        let [left, right] = line.sides.as_slice() else {
            return None;
        };
        let left_over = judge.left_over(line)?;
        let mut found = Self {
            terms: vec![],
            sides: [left, right].map(|side| (side.span, Fraction::zero())),
            left_over,
        };
        let mut all = Fraction::zero();
        for (at, side) in [left, right].into_iter().enumerate() {
            for (node, negative) in terms(side) {
                let negative = negative != (at == 1);
                let adds = signed(judge.term(node)?, negative);
                all += adds.clone();
                let whole = &mut found.sides[at].1;
                *whole = whole.clone() + adds.clone();
                let term = Term {
                    node,
                    negative,
                    adds,
                };
                found.terms.push(term);
            }
        }
        (all == found.left_over).then_some(found)
    }

    /// Whether the line may hold with a change at some bytes of it; `None` where its terms don't tell.
    pub(super) fn may_hold(
        &self,
        judge: &mut Judge<'_>,
        place: Span,
        change: &Change,
    ) -> Option<bool> {
        match change {
            Change::Times(of, [over, under]) => {
                let terms = self.terms.iter().map(|term| (term.node.span, &term.adds));
                let sides = self.sides.iter().map(|(span, adds)| (*span, adds));
                let mut all = terms.chain(sides);
                let (_, adds) = all.find(|(span, _)| span == of)?;
                let more = adds.clone() * Fraction::from_ratio(over - under, *under);
                Some((self.left_over.clone() + more).is_zero())
            }
            _ => {
                let holds = |span: Span| span.start <= place.start && place.end <= span.end;
                let term = self.terms.iter().find(|term| holds(term.node.span))?;
                let mut node = term.node.clone();
                put(&mut node, place, change)?;
                let adds = signed(judge.term(&node)?, term.negative);
                let others = self.left_over.clone() - term.adds.clone();
                Some((others + adds).is_zero())
            }
        }
    }
}

/// The terms of a side, and whether each is taken away.
fn terms(side: &Node) -> Vec<(&Node, bool)> {
    match &side.kind {
        Kind::Sum(terms) => terms.iter().map(|t| (&t.node, t.negative)).collect(),
        _ => vec![(side, false)],
    }
}

fn signed(value: Fraction, negative: bool) -> Fraction {
    if negative { -value } else { value }
}

/// Makes a change to the symbol at some bytes; `None` where it stands in what may be read in another way with it.
fn put(node: &mut Node, place: Span, change: &Change) -> Option<()> {
    match &mut node.kind {
        Kind::Symbol(own) if node.span == place => {
            let own = own.clone();
            node.kind = changed(own, node.span, change)?;
            Some(())
        }
        Kind::Sum(_) | Kind::Product(_) | Kind::Negate(_) | Kind::Group(..) => {
            let holds =
                |child: &&mut Node| child.span.start <= place.start && place.end <= child.span.end;
            let child = node.children_mut().into_iter().find(holds)?;
            put(child, place, change)
        }
        // A dot is over whatever letter stands under it.
        Kind::TimeDerivative { operand, .. } if matches!(change, Change::Symbol(_)) => {
            put(operand, place, change)
        }
        _ => None,
    }
}

/// A symbol, changed.
fn changed(own: Symbol, span: Span, change: &Change) -> Option<Kind> {
    if let Change::Symbol(other) = change {
        return Some(Kind::Symbol(other.clone()));
    }
    let is_plain = own.superscripts.is_empty() && own.primes == 0 && !own.resultant;
    let is_plain = is_plain && !own.variation && own.style == Default::default();
    let node = Box::new(Node {
        kind: Kind::Symbol(own),
        span,
    });
    match change {
        _ if !is_plain => None,
        Change::Dotted => Some(Kind::TimeDerivative {
            operand: node,
            order: 1,
            style: DerivativeStyle::Dots,
            frame: None,
        }),
        Change::Squared => {
            let two = Kind::Number(Number {
                value: BigRational::from_integer(2.into()),
                decimals: None,
                exponent: 0,
            });
            Some(Kind::Power(node, Box::new(Node { kind: two, span })))
        }
        Change::Symbol(_) | Change::Times(..) => None,
    }
}
