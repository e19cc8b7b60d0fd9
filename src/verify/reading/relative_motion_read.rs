//! Velocities and accelerations of points, relative to frames and to other points.

use crate::verify::language::statement::{NounPhrase, Slot};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::term::quantity::Quantity;

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
        let of = self.moving_spot(phrase)?;
        Some(match first {
            true => Quantity::Velocity { of, relative },
            false => Quantity::Acceleration { of, relative },
        })
    }
}
