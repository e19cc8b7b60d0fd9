//! Velocities and accelerations of a point in frames that a document names, `{}^N\vec v` and `{}^B\vec a`, and the angular
//! velocity of one frame in the other turned round, `{}^B\vec\omega^N = -{}^N\vec\omega^B`.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axis, inner};
use crate::verify::lines::points::Law;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::subscript::{between, is_of_the_body};
use crate::verify::values::value::Value;

/// Words of a frame that turns, from which motion is seen.
const MOVING_FRAMES: &[&str] = &[
    "rotating frame",
    "rotating system",
    "rotating axes",
    "moving frame",
    "turning frame",
    "observer",
    "turntable",
];

impl Checker<'_> {
    /// The angular velocity of the axes at rest in those that turn.
    pub(crate) fn turned_round(&mut self, symbol: &Symbol) -> Option<Law> {
        let quantity = *self.reading.quantities.get(&Letter::of(symbol))?;
        let turning = [Quantity::AngularVelocity, Quantity::AngularAcceleration];
        if !turning.contains(&quantity) || !self.is_new(symbol) {
            return None;
        }
        let (first, second) = between(symbol)?;
        let mut other = symbol.clone();
        match symbol.superscripts.len() {
            2 => other.superscripts = vec![second, first],
            _ => other.subscripts = vec![format!("{second}/{first}")],
        }
        if !is_of_the_body(&other, &self.reading) {
            return None;
        }
        let own = self.theory.atoms.quantity(quantity);
        let own = Value::column(self.theory.atoms.vector(own, 0));
        let entity = self.entity_named(symbol)?;
        Some(Law::new("frames turned round", entity, own.negated()))
    }

    /// The velocity or acceleration of the one point whose position is spoken of, in a frame that the document's
    /// derivatives are taken in.
    pub(crate) fn in_named_frame(&mut self, symbol: &Symbol) -> Option<Law> {
        if !symbol.style.vector {
            return None;
        }
        let quantity = self.reading.quantities.get(&Letter::of(symbol));
        let order = match (quantity, symbol.name.as_str()) {
            (Some(Quantity::Velocity), _) | (None, "v") => 1,
            (Some(Quantity::Acceleration), _) | (None, "a") => 2,
            _ => return None,
        };
        let frame = match (symbol.superscripts.as_slice(), symbol.subscripts.as_slice()) {
            // `\mathbf v'` beside v: what is seen from the frame that turns.
            ([], []) if symbol.primes == 1 => {
                (self.speaks_of_turning() && self.text.says(MOVING_FRAMES)).then_some(Frame::Moving)
            }
            ([label], []) => self.reading.frames.of_derivatives(label),
            ([], [label]) => self.frame_of_motion(label),
            _ => None,
        }?;
        self.rate_of_only_position(symbol, order, frame)
    }

    /// `\mathbf v` beside `\mathbf v'`: the same seen from space.
    pub(crate) fn beside_a_prime(&mut self, symbol: &Symbol, met: &[&Symbol]) -> Option<Law> {
        let order = match symbol.name.as_str() {
            "v" => 1,
            "a" => 2,
            _ => return None,
        };
        let bare = |s: &Symbol| s.subscripts.is_empty() && s.superscripts.is_empty();
        let primed = |s: &&&Symbol| s.name == symbol.name && s.primes == 1 && bare(s);
        let primed = met.iter().find(primed)?;
        if symbol.primes > 0 || !symbol.style.vector || !bare(symbol) {
            return None;
        }
        self.in_named_frame(primed)?;
        self.rate_of_only_position(symbol, order, Frame::Space)
    }

    fn rate_of_only_position(&mut self, symbol: &Symbol, order: u8, frame: Frame) -> Option<Law> {
        if !self.is_new(symbol) || !self.has_one_position() {
            return None;
        }
        let position = self.theory.atoms.quantity(Quantity::Position);
        let value = match frame {
            Frame::Moving => Value::column(self.theory.atoms.vector(position, order)),
            Frame::Space => {
                let mut value = Value::column(self.theory.atoms.vector(position, 0));
                for _ in 0..order {
                    value = self.lowering(Frame::Space).space_rate(&value);
                }
                value
            }
        };
        Some(Law::new("kinematics", self.entity_named(symbol)?, value))
    }

    fn speaks_of_turning(&self) -> bool {
        let turns = [Quantity::FrameRate, Quantity::AngularVelocity];
        turns
            .into_iter()
            .any(|quantity| self.reading.speaks_of(quantity))
    }

    /// The frame that a label under velocities or accelerations means: one that derivatives are taken in, or one of two,
    /// of which one turns and the other does not.
    fn frame_of_motion(&self, label: &str) -> Option<Frame> {
        let frames = &self.reading.frames;
        let labels = ["v", "a"].map(|name| self.reading.usage.subscripts.get(&Letter::plain(name)));
        let other = |frame: Frame| {
            let mut labels = labels.iter().flatten().copied().flatten();
            labels.any(|other| frames.of_text(other).is_some_and(|other| other != frame))
        };
        let by_pair = || frames.of_text(label).filter(|frame| other(*frame));
        let speaks = || self.text.says(&["frame", "axes", "observer"]);
        let relative = matches!(label, "rel" | "rot" | "relative" | "rotating");
        if relative && self.speaks_of_turning() && speaks() {
            return Some(Frame::Moving);
        }
        frames
            .of_derivatives(label)
            .or_else(|| by_pair().filter(|_| axis(label).is_none() && speaks()))
    }

    /// The velocity without a label in `v = {}^N dr/dt = …`: the rate of the only position, seen from space.
    pub(crate) fn rate_of_position(&mut self, symbol: &Symbol, sides: &[Node]) -> Option<Law> {
        let velocity =
            self.reading.quantities.get(&Letter::of(symbol)) == Some(&Quantity::Velocity);
        let bare = symbol.subscripts.is_empty() && symbol.superscripts.is_empty();
        if !velocity || !bare || !symbol.style.vector || !self.has_one_position() {
            return None;
        }
        let rate = |side: &Node| match &inner(side).kind {
            Kind::TimeDerivative {
                operand,
                frame: Some(label),
                ..
            } => {
                let position = matches!(&inner(operand).kind, Kind::Symbol(s)
                    if self.reading.quantities.get(&Letter::of(s)) == Some(&Quantity::Position));
                position && self.reading.frames.of_label(label) == Some(Frame::Space)
            }
            _ => false,
        };
        if !sides.get(1).is_some_and(rate) || !self.is_new(symbol) {
            return None;
        }
        let position = self.theory.atoms.quantity(Quantity::Position);
        let position = Value::column(self.theory.atoms.vector(position, 0));
        let value = self.lowering(Frame::Space).space_rate(&position);
        Some(Law::new("kinematics", self.entity_named(symbol)?, value))
    }

    /// Whether one vector is a position, and nothing tells it from others of its letter.
    fn has_one_position(&self) -> bool {
        let mut positions = self.reading.quantities.iter();
        let mut positions = positions
            .by_ref()
            .filter(|(_, q)| **q == Quantity::Position);
        let (Some((letter, _)), None) = (positions.next(), positions.next()) else {
            return false;
        };
        let usage = &self.reading.usage;
        let labels = usage.subscripts.get(letter).into_iter().flatten();
        let marked = usage.superscripts.get(letter).into_iter().flatten();
        labels.into_iter().all(|s| axis(s).is_some()) && marked.into_iter().all(Vec::is_empty)
    }
}
