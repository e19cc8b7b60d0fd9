//! The laws that tie what is taken about a moving point P to the mass centre C, with ρ from P to C.
//!
//! H_P = H_C + ρ × m v_C and M_P = M_C + ρ × m a_C, from which M_P = dH_P/dt + v_P × m v_C; or, with the velocities
//! relative to P, H_P = H_C + ρ × m (v_C − v_P). See L. Meirovitch, Methods of Analytical Dynamics, section 4.2.

use crate::notation::ast::{Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::moving_point::{AtPoint, holds_rate_of};
use crate::verify::letters::two_points::CENTRES;
use crate::verify::letters::usage::{Letter, symbols};
use crate::verify::lines::points::Law;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;

/// Words of a point that moves, or may.
const MOVING: &[&str] = &[
    "moving point",
    "point moves",
    "that moves",
    "which moves",
    "any point",
    "arbitrary point",
    "accelerated point",
    "moving reference point",
];

impl Checker<'_> {
    /// Takes in the laws, if the document speaks of such a point.
    pub(crate) fn tie_moving_point(&mut self) {
        let Some(found) = self.reading.moving_point.clone() else {
            return;
        };
        // The point moves in any way.
        self.any_vector = true;
        let written = [&found.centre, &found.other].map(|at| [&at.position, &at.velocity]);
        let written = written.into_iter().flatten().flatten().chain([&found.arm]);
        for symbol in written {
            let entity = self.entity_named(symbol);
            self.known.extend(entity);
        }
        self.tie_velocities(&found.centre, &found.other, &found.arm);
        for at in [&found.centre, &found.other] {
            if let Some(rate) = at.velocity.as_ref().and_then(|v| self.rate_in_space(v)) {
                self.tie("kinematics", at.acceleration.as_ref(), Some(rate));
            }
        }
        let arm = self.vector(&found.arm);
        let mass = self.theory.atoms.quantity(Quantity::Mass);
        let mass = self.theory.atoms.value(mass, 0, 0);
        let shift = |rate: Option<Value>| Some(arm.clone()?.cross(&rate?).ok()?.scaled(&mass));
        let mut velocity = found.centre.velocity.as_ref().and_then(|v| self.vector(v));
        let mut acceleration = found
            .centre
            .acceleration
            .as_ref()
            .and_then(|a| self.vector(a));
        if acceleration.is_none() {
            acceleration = found
                .centre
                .velocity
                .as_ref()
                .and_then(|v| self.rate_in_space(v));
        }
        if found.relative {
            let own = found.other.velocity.as_ref().and_then(|v| self.vector(v));
            velocity = velocity
                .zip(own)
                .and_then(|(v, own)| v.plus(&own, true).ok());
        }
        let [of_momentum, of_moment] = [velocity, acceleration].map(shift);
        let momentum = found.centre.momentum.as_ref().and_then(|m| self.vector(m));
        self.tie_shifted(momentum, &found.other.momentum, of_momentum);
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let moment = Value::column(self.theory.atoms.vector(moment, 0));
        self.tie_shifted(Some(moment), &found.other.moment, of_moment);
    }

    /// Whether a new moment about a point is set to the rate of the momentum about it, and the term that its motion adds
    /// is not the one of the law: M_P = dH_P/dt + v_P × m v_G, with the momentum of absolute velocities.
    pub(crate) fn misses_motion_of_point(&mut self, symbol: &Symbol, right: &Node) -> bool {
        let [label] = symbol.subscripts.as_slice() else {
            return false;
        };
        let of =
            |s: &Symbol, quantity| self.reading.quantities.get(&Letter::of(s)) == Some(&quantity);
        let here = |s: &&Symbol| s.style.vector && s.subscripts == symbol.subscripts;
        let met = symbols(right);
        let momentum = met
            .iter()
            .copied()
            .filter(here)
            .find(|s| of(s, Quantity::Momentum));
        let Some(momentum) = momentum.filter(|_| of(symbol, Quantity::Moment)).cloned() else {
            return false;
        };
        let named = label.len() == 1 && label.starts_with(|c: char| c.is_ascii_uppercase());
        if !named || !self.text.says(MOVING) || !holds_rate_of(right, &momentum) {
            return false;
        }
        let velocity = |s: &&Symbol| matches!(s.name.as_str(), "v" | "V") && s.style.vector;
        let own = met.iter().copied().filter(velocity).find(here).cloned();
        let centre =
            |s: &&Symbol| matches!(s.subscripts.as_slice(), [c] if CENTRES.contains(&c.as_str()));
        let centre = met.iter().copied().filter(velocity).find(centre).cloned();
        let (Some(own), Some(centre)) = (own, centre) else {
            return true;
        };
        let mass = self.theory.atoms.quantity(Quantity::Mass);
        let mass = self.theory.atoms.value(mass, 0, 0);
        let expected = self.rate_in_space(&momentum).and_then(|rate| {
            let [own, centre] = [self.vector(&own)?, self.vector(&centre)?];
            let shift = own.cross(&centre).ok()?.scaled(&mass);
            rate.plus(&shift, false).ok()
        });
        let given = self.lowering(Frame::Space).value(right).ok();
        let rest = expected
            .zip(given)
            .and_then(|(expected, given)| given.plus(&expected, true).ok());
        rest.is_none_or(|rest| !rest.is_zero())
    }

    /// v = dr/dt where positions are written, or else v_C = v_P + dρ/dt.
    fn tie_velocities(&mut self, centre: &AtPoint, other: &AtPoint, arm: &Symbol) {
        if centre.position.is_some() && other.position.is_some() {
            for at in [centre, other] {
                let rate = at.position.as_ref().and_then(|r| self.rate_in_space(r));
                self.tie("kinematics", at.velocity.as_ref(), rate);
            }
            return;
        }
        let own = other.velocity.as_ref().and_then(|v| self.vector(v));
        let rate = self.rate_in_space(arm);
        let whole = own
            .zip(rate)
            .and_then(|(own, rate)| own.plus(&rate, false).ok());
        self.tie("kinematics", centre.velocity.as_ref(), whole);
    }

    fn tie_shifted(&mut self, own: Option<Value>, other: &Option<Symbol>, shift: Option<Value>) {
        let whole = own
            .zip(shift)
            .and_then(|(own, shift)| own.plus(&shift, false).ok());
        self.tie("transfer to another point", other.as_ref(), whole);
    }

    fn tie(&mut self, name: &'static str, symbol: Option<&Symbol>, value: Option<Value>) {
        if let (Some(symbol), Some(value)) = (symbol, value)
            && self.is_new(symbol)
            && let Some(entity) = self.entity_named(symbol)
        {
            self.take_law(Law::new(name, entity, value));
        }
    }

    fn vector(&mut self, symbol: &Symbol) -> Option<Value> {
        let entity = self.entity_named(symbol)?;
        Some(Value::column(self.theory.atoms.vector(entity, 0)))
    }

    fn rate_in_space(&mut self, symbol: &Symbol) -> Option<Value> {
        let value = self.vector(symbol)?;
        Some(self.lowering(Frame::Space).space_rate(&value))
    }
}
