//! What the dots of a line mean that carry no frame: rates on the axes used, or rates seen from space.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::line::Read;
use crate::verify::values::atoms::Owner;
use crate::verify::values::lower::Trouble;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::spatial::all_in_space;
use crate::verify::values::symbol::{ANY_POINT, Meaning};
use crate::verify::words::book::has_any;
use crate::verify::words::prose::Said;

/// How words say that a vector stands by its components on the body's axes.
const ON_BODY: &[&str] = &[
    "on body axes",
    "in body axes",
    "on the body axes",
    "in the body axes",
    "in body components",
    "body components",
    "on axes fixed in the body",
];
/// Words of a frame that does not turn.
const SPACE: &[&str] = &[
    "inertial",
    "in space",
    "from space",
    "space frame",
    "space axes",
    "fixed frame",
    "fixed axes",
    "non-rotating",
    "laborator",
    "newtonian",
    "absolute",
];

impl Checker<'_> {
    /// "The momentum on body axes, ⟨h = Jω⟩": its dot is the rate of these components, where no other frame is spoken of
    /// and a line adds ω × to the dot.
    pub(crate) fn note_momentum_on_body(&mut self, sentence: &str, span: Span) {
        let told = self.dots.is_none()
            && sentence.contains("momentum")
            && has_any(sentence, ON_BODY)
            && !self.text.says(SPACE);
        if told
            && self
                .document
                .lines()
                .any(|line| self.writes_transport(&line.sides))
        {
            self.take(Said::DotsOnBody, span);
        }
    }

    /// The readings of a line, the likelier first.
    pub(crate) fn readings(&mut self, sides: &[Node]) -> Result<Vec<Read>, Trouble> {
        let spatial = all_in_space(sides, &self.reading);
        let mut first = self.read_on(sides, Frame::Moving, spatial)?;
        first.to_order = self.keep_order(&mut first.equations);
        let turning = |checker: &mut Self| sides.iter().any(|side| checker.has_rate_of_axis(side));
        if first.ambiguous && (self.tells_rates_apart(sides) || turning(self)) {
            let mut seen = self.read(sides, Frame::Space)?;
            seen.to_order = self.keep_order(&mut seen.equations);
            return Ok(vec![seen]);
        }
        let on_axes = match self.dots {
            Some(frame) => frame == Frame::Moving,
            None => {
                self.writes_transport(sides)
                    || sides.iter().any(|side| self.adds_rate_of_wheels(side))
            }
        };
        if !first.ambiguous || on_axes {
            return Ok(vec![first]);
        }
        let mut second = match self.read(sides, Frame::Space) {
            // Where it makes no sense seen from space, it is not meant so: ∂M/∂\dot ω.
            Err(_) if self.dots.is_none() => return Ok(vec![first]),
            read => read?,
        };
        second.to_order = self.keep_order(&mut second.equations);
        if self.dots == Some(Frame::Space) {
            return Ok(vec![second]);
        }
        Ok(match self.names_velocity(sides) {
            true => vec![second, first],
            false => vec![first, second],
        })
    }

    /// `\vec v = d\vec r/dt`: the velocity of a point is seen from space.
    pub(crate) fn names_velocity(&mut self, sides: &[Node]) -> bool {
        let [left, right, ..] = sides else {
            return false;
        };
        let mut quantity = |node: &Node| match &inner(node).kind {
            Kind::Symbol(symbol) => {
                let entity = self.entity_named(symbol)?;
                match &self.theory.atoms.info(entity).owner {
                    Owner::Quantity(quantity, variant) => Some((*quantity, variant.clone())),
                    Owner::Symbol(_) => None,
                }
            }
            _ => None,
        };
        let Kind::TimeDerivative { operand, .. } = &inner(right).kind else {
            return false;
        };
        let velocity = matches!(quantity(left), Some((Quantity::Velocity, point)) if matches!(point.as_str(), "" | ANY_POINT));
        velocity && matches!(quantity(operand), Some((Quantity::Position, _)))
    }

    /// Whether the rate of a unit vector of the axes, or of the place of a particle, stands in a node: it is seen from
    /// space, or it would be zero.
    fn has_rate_of_axis(&mut self, node: &Node) -> bool {
        if let Kind::TimeDerivative { operand, .. } = &node.kind
            && let Kind::Symbol(symbol) = &inner(operand).kind
        {
            return self.reading.particle.as_ref() == Some(symbol)
                || matches!(self.meaning_of(symbol), Meaning::UnitVector(_));
        }
        let mut children = node.children();
        children.any(|child| self.has_rate_of_axis(child))
    }

    /// Whether the rate of the momentum of wheels is a term of a sum: there it is what their motors do, seen from the
    /// body that carries them.
    fn adds_rate_of_wheels(&mut self, node: &Node) -> bool {
        let Kind::Sum(terms) = &node.kind else {
            let mut children = node.children();
            return children.any(|child| self.adds_rate_of_wheels(child));
        };
        let wheels = Owner::Quantity(Quantity::RelativeMomentum, String::new());
        terms.iter().any(|term| {
            let Kind::TimeDerivative {
                operand,
                frame: None,
                ..
            } = &inner(&term.node).kind
            else {
                return self.adds_rate_of_wheels(&term.node);
            };
            let entities = self.entities([&**operand]);
            matches!(inner(operand).kind, Kind::Symbol(_))
                && entities
                    .iter()
                    .all(|e| self.theory.atoms.info(*e).owner == wheels)
        })
    }

    /// Whether a rate without a frame stands beside that of the same vector on the axes used: it is seen from space.
    fn tells_rates_apart(&self, sides: &[Node]) -> bool {
        let (mut labelled, mut bare) = (vec![], vec![]);
        for side in sides {
            self.rates_of_symbols(side, None, &mut |symbol, frame| match frame {
                Some(Frame::Moving) => labelled.push(symbol.clone()),
                Some(_) => {}
                None => bare.push(symbol.clone()),
            });
        }
        bare.iter().any(|symbol| labelled.contains(symbol))
    }

    fn rates_of_symbols(
        &self,
        node: &Node,
        within: Option<Frame>,
        found: &mut dyn FnMut(&Symbol, Option<Frame>),
    ) {
        let within = match &node.kind {
            Kind::InFrame(_, label) => self.reading.frames.of_label(label).or(within),
            _ => within,
        };
        if let Kind::TimeDerivative { operand, frame, .. } = &node.kind
            && let Kind::Symbol(symbol) = &inner(operand).kind
        {
            let own = frame
                .as_ref()
                .and_then(|label| self.reading.frames.of_label(label));
            found(symbol, own.or(within));
        }
        node.children()
            .for_each(|child| self.rates_of_symbols(child, within, found));
    }

    /// Whether ω × stands beside the dot of a momentum, `ḣ + ω × Jω`: who writes what the turning of the axes adds writes
    /// the rate on the axes. In `\dot L = Jω̇ + ω × Jω` it stands across from the dot, which is then seen from space.
    fn writes_transport(&self, sides: &[Node]) -> bool {
        sides.iter().any(|side| self.transports_within(side))
            || sides.windows(2).any(|pair| {
                let mut terms = Signs::default();
                self.signs(&pair[0], false, &mut terms);
                self.signs(&pair[1], true, &mut terms);
                terms.agree()
            })
    }

    fn transports_within(&self, node: &Node) -> bool {
        let here = matches!(node.kind, Kind::Sum(_)) && {
            let mut terms = Signs::default();
            self.signs(node, false, &mut terms);
            terms.agree()
        };
        here || node.children().any(|child| self.transports_within(child))
    }

    fn signs(&self, node: &Node, negative: bool, terms: &mut Signs) {
        match &inner(node).kind {
            Kind::Sum(sum) => sum
                .iter()
                .for_each(|term| self.signs(&term.node, negative != term.negative, terms)),
            Kind::Negate(inside) => self.signs(inside, !negative, terms),
            Kind::TimeDerivative {
                operand,
                frame: None,
                ..
            } if self.is_of(operand, &[Quantity::Momentum, Quantity::RelativeMomentum]) => {
                terms.rates[usize::from(negative)] = true;
            }
            Kind::Product(factors) => {
                let Some(first) = factors.first() else { return };
                let crossed = factors.iter().any(|f| f.operator == Operator::Cross);
                let turns = match &inner(&first.node).kind {
                    Kind::Skew(of) => self.is_of(of, &[Quantity::AngularVelocity]),
                    _ => crossed && self.is_of(&first.node, &[Quantity::AngularVelocity]),
                };
                terms.turns[usize::from(negative)] |= turns;
            }
            _ => {}
        }
    }

    fn is_of(&self, node: &Node, quantities: &[Quantity]) -> bool {
        matches!(&inner(node).kind, Kind::Symbol(symbol)
            if self.reading.quantities.get(&Letter::of(symbol)).is_some_and(|q| quantities.contains(q)))
    }
}

/// Whether rates of momenta, and terms ω ×, stand in a sum with a plus and with a minus.
#[derive(Default)]
struct Signs {
    rates: [bool; 2],
    turns: [bool; 2],
}

impl Signs {
    fn agree(&self) -> bool {
        (0..2).any(|sign| self.rates[sign] && self.turns[sign])
    }
}
