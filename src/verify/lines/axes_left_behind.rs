//! Axes that a line lets the body turn ahead of: `\bm\omega = \bm\Omega + \sigma\bm e_3` after words of axes carried by the body.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::theory::law::Axes;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use num_traits::Zero;

impl Checker<'_> {
    /// Axes are not attached to the body where a line says by how much it turns relative to them: with Ω = ω it would
    /// say that this, which it names, vanishes.
    pub(crate) fn leave_axes_behind(&mut self, sides: &[Node]) {
        let [left, right] = sides else { return };
        let chosen = self.document.front_matter.axes.is_some();
        if chosen || self.theory.setting.axes != Axes::Body || !self.has_frame_rate() {
            return;
        }
        let lone = matches!(inner(left).kind, Kind::Symbol(_));
        let sum = matches!(inner(right).kind, Kind::Sum(_));
        if !(lone && sum && self.turns(left) && self.turns(right)) {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        let rests: Vec<Fraction> = read.residuals().map(|e| self.theory.normal(e)).collect();
        let atoms = &self.theory.atoms;
        let own = |v: &u32| matches!(atoms.owner(*v), Some(Owner::Symbol(_)));
        let differs = rests.iter().any(|rest| !rest.is_zero());
        if differs && rests.iter().all(|rest| rest.variables().iter().all(own)) {
            self.axes_turn_apart();
        }
    }

    /// Whether the angular velocity of the body or that of the axes stands in a side.
    fn turns(&mut self, side: &Node) -> bool {
        let entities = self.entities([side]);
        let mut owners = entities.iter().map(|e| &self.theory.atoms.info(*e).owner);
        owners.any(|owner| {
            matches!(
                owner,
                Owner::Quantity(Quantity::AngularVelocity | Quantity::FrameRate, _)
            )
        })
    }
}
