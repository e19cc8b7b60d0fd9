//! Where points are, and how they move.

use crate::verify::model::system::{FrameId, Point, PointId, System, Vector};

impl System {
    /// A new point.
    pub(crate) fn add_point(
        &mut self,
        name: &str,
        placed: Option<(PointId, Vector)>,
        fixed_in: Vec<FrameId>,
    ) -> PointId {
        self.points.push(Point {
            name: name.to_owned(),
            placed,
            fixed_in,
        });
        self.points.len() - 1
    }

    /// The origin: the point from which all others are placed, fixed in the inertial frame.
    pub(crate) fn origin(&mut self) -> PointId {
        if self.points.is_empty() {
            self.add_point("", None, vec![self.ground]);
        }
        0
    }

    /// The position of a point from the origin.
    fn way_from_origin(&self, point: PointId) -> Vector {
        let (mut sum, mut at) = (Vector::zeros(), point);
        while let Some((from, way)) = &self.points[at].placed {
            // Points are placed from earlier ones alone, so this ends.
            sum += way.clone();
            at = *from;
        }
        sum
    }

    /// The position of one point from another.
    pub(crate) fn position(&self, of: PointId, from: PointId) -> Vector {
        self.way_from_origin(of) - self.way_from_origin(from)
    }

    /// The velocity of a point relative to a frame: the rate of its position from a point that is fixed there.
    pub(crate) fn velocity(&mut self, of: PointId, frame: FrameId) -> Vector {
        if self.points[of].fixed_in.contains(&frame) {
            return Vector::zeros();
        }
        let way = self.position(of, self.fixed_point(frame));
        self.rate_seen_from(frame, &way)
    }

    /// A point that is fixed in a frame; the origin where none is.
    pub(crate) fn fixed_point(&self, frame: FrameId) -> PointId {
        let fixed = self.points.iter().position(|p| p.fixed_in.contains(&frame));
        fixed.unwrap_or(0)
    }
}
