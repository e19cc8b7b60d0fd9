//! A place that turns with the body, as a line tells whose other side is only ω × r: `\mathbf v = \boldsymbol\omega\times\mathbf r`.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::verify::letters::reading::Reading;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::values::quantity::Quantity;
use crate::verify::words::text::Text;

/// Words for what moves in a body that turns.
const RELATIVE: &[&str] = &[
    "relative velocity",
    "relative motion",
    "relative to the",
    "relative to a ",
    "coriolis",
    "slide",
    "sliding",
    "crawl",
    "moves along",
    "bead",
];
/// Words for what turns.
const TURNS: &[&str] = &["rigid", "body", "wheel", "disc", "disk", "rotor"];
/// Words for what it carries round.
const CARRIED: &[&str] = &[
    "rigid",
    "of the body",
    "fixed in",
    "fixed to",
    "attached to",
    "embedded in",
];

impl Reading {
    /// The vector that a line has turn at ω, where no line says how it changes beside that.
    pub(crate) fn place_carried_round(&self, document: &Text) -> Option<Symbol> {
        let carried = document.says(CARRIED);
        let turns = carried || document.says(TURNS);
        if !turns || document.says(RELATIVE) || self.speaks_of(Quantity::FrameRate) {
            return None;
        }
        let place = document.lines().find_map(|line| {
            let (last, others) = line.sides.split_last()?;
            let place = self.arm_of_turn(last)?;
            others
                .iter()
                .any(|side| self.is_velocity(side, place) || carried && is_rate(side, place))
                .then_some(place)
        })?;
        let own = |side: &Node| matches!(&inner(side).kind, Kind::Symbol(s) if s == place);
        let mut all = document.lines().flat_map(|line| &line.sides);
        all.all(|side| !own(side) && !self.changes_beside(side, place))
            .then(|| place.clone())
    }

    /// The r of a side that is ω × r alone.
    fn arm_of_turn<'n>(&self, side: &'n Node) -> Option<&'n Symbol> {
        let Kind::Product(factors) = &inner(side).kind else {
            return None;
        };
        let [omega, place] = factors.as_slice() else {
            return None;
        };
        match (&inner(&omega.node).kind, &inner(&place.node).kind) {
            (Kind::Symbol(omega), Kind::Symbol(arm))
                if place.operator == Operator::Cross
                    && omega.subscripts.is_empty()
                    && self.stands_for(omega) == Some(Quantity::AngularVelocity)
                    && arm.style.vector
                    && matches!(self.stands_for(arm), None | Some(Quantity::Position)) =>
            {
                Some(arm)
            }
            _ => None,
        }
    }

    fn stands_for(&self, symbol: &Symbol) -> Option<Quantity> {
        self.quantities.get(&Letter::of(symbol)).copied()
    }

    fn is_velocity(&self, side: &Node, place: &Symbol) -> bool {
        matches!(&inner(side).kind, Kind::Symbol(symbol)
            if self.stands_for(symbol) == Some(Quantity::Velocity) && symbol.subscripts == place.subscripts)
    }

    /// Whether a sum has the rate of a place beside ω × that place.
    fn changes_beside(&self, node: &Node, place: &Symbol) -> bool {
        let here = match &node.kind {
            Kind::Sum(terms) => {
                terms.iter().any(|term| is_rate(&term.node, place))
                    && terms
                        .iter()
                        .any(|term| self.arm_of_turn(&term.node) == Some(place))
            }
            _ => false,
        };
        here || node
            .children()
            .any(|child| self.changes_beside(child, place))
    }
}

/// Whether a node is a rate of a place.
fn is_rate(node: &Node, place: &Symbol) -> bool {
    matches!(&inner(node).kind, Kind::TimeDerivative { operand, .. }
        if matches!(&inner(operand).kind, Kind::Symbol(s) if s == place))
}
