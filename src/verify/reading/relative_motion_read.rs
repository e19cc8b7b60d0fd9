//! Velocities and accelerations of points, relative to frames and to other points.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::model::system::{FrameId, Turn};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::name_of;
use crate::verify::term::quantity::{Quantity, Spot};

impl Builder<'_> {
    /// The velocity or the acceleration of a point. That relative to another point is the rate of the way from there, as the
    /// frame sees it.
    pub(super) fn motion_of_point(
        &self,
        phrase: &NounPhrase,
        relative: FrameId,
    ) -> Option<Quantity> {
        let first = phrase.head == "velocity";
        if let Some(about) = phrase.slot(Slot::About) {
            let from = self.point(about)?;
            let of = self.spot(phrase.slot(Slot::Of)?)?;
            let rate = |of: Quantity| Quantity::Rate {
                of: of.boxed(),
                seen: relative,
            };
            let way = Quantity::Position { of, from };
            return Some(if first { rate(way) } else { rate(rate(way)) });
        }
        let whole = || self.spot_of_frame(phrase.slot(Slot::Of)?, relative);
        let of = self.moving_spot(phrase).or_else(whole)?;
        Some(match first {
            true => Quantity::Velocity { of, relative },
            false => Quantity::Acceleration { of, relative },
        })
    }

    /// A point of a frame that does not turn against another one: all of them move alike.
    fn spot_of_frame(&self, term: &Term, relative: FrameId) -> Option<Spot> {
        let frame = *self.frames.get(&name_of(term)?)?;
        let system = &self.reading.system;
        let turned = &system.frames[frame];
        let keeps = turned.parent == Some(relative) && turned.turn == Turn::Fixed;
        let point = system.fixed_point(frame);
        let own = system.points[point].fixed_in.contains(&frame);
        (keeps && own).then_some(Spot::Point(point))
    }

    /// "P moves relative to A along z at the rate `$v$`": that is its velocity.
    pub(super) fn hold_rate_along(
        &mut self,
        subjects: &[Term],
        way: &Term,
        rate: &Term,
        frame: FrameId,
        declaration: &Declaration,
    ) -> Option<()> {
        let rate = match rate {
            Term::Phrase(rate) if matches!(rate.head, "rate" | "speed") => {
                rate.slot(Slot::Which)?
            }
            rate => rate,
        };
        let Term::Formula(rate) = rate else {
            return None;
        };
        let rate = self.scalar(&rate.clone(), declaration)?;
        let axis = self.axis_vector(way, declaration)?;
        for mover in subjects {
            let point = self.moving_point(mover, frame)?;
            let velocity = self.system().velocity(point, frame);
            self.hold_zero(&(velocity - axis.clone() * rate.clone()), declaration);
            self.hold_smooth_force(mover, &axis, declaration)?;
        }
        Some(())
    }
}
