//! The forces that a turning frame adds, on particles and bodies, and their moments.

use crate::mechanics;
use crate::verify::model::system::{BodyId, FrameId, PointId, System, Vector};

/// A force that bodies have as seen from a turning frame.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Inertial {
    Coriolis,
    Centrifugal,
    Euler,
}

impl System {
    /// The force for each kilogram at a place, by the way from a point fixed in the frame and its rate seen from there.
    pub(crate) fn inertial_field(
        &mut self,
        kind: Inertial,
        frame: FrameId,
        way: &Vector,
        rate: &Vector,
    ) -> Vector {
        let (ground, none) = (self.ground, Vector::zeros());
        let omega = self.angular_velocity(frame, ground);
        let change = self.rate_seen_from(frame, &omega);
        let terms = mechanics::relative_acceleration(&none, rate, way, &omega, &change);
        -match kind {
            Inertial::Coriolis => terms.coriolis,
            Inertial::Centrifugal => terms.centripetal,
            Inertial::Euler => terms.euler,
        }
    }

    /// The force on a body, of which its mass centre tells.
    pub(crate) fn inertial_force(
        &mut self,
        kind: Inertial,
        body: BodyId,
        frame: FrameId,
    ) -> Vector {
        let mut sum = Vector::zeros();
        for part in self.wholes(body) {
            let own = self.inertial_force_on_part(kind, part, frame);
            sum += self.each_over_members(part, own);
        }
        sum
    }

    fn inertial_force_on_part(&mut self, kind: Inertial, part: BodyId, frame: FrameId) -> Vector {
        let (centre, mass) = (self.bodies[part].centre, self.bodies[part].mass.clone());
        let way = self.position(centre, self.fixed_point(frame));
        let rate = self.velocity(centre, frame);
        self.inertial_field(kind, frame, &way, &rate) * mass
    }

    /// The moment of these forces about a point, on all elements of a body.
    pub(crate) fn inertial_moment(
        &mut self,
        kind: Inertial,
        body: BodyId,
        frame: FrameId,
        about: PointId,
    ) -> Vector {
        let ground = self.ground;
        let omega = self.angular_velocity(frame, ground);
        let change = self.rate_seen_from(frame, &omega);
        let mut sum = Vector::zeros();
        for part in self.wholes(body) {
            let force = self.inertial_force_on_part(kind, part, frame);
            let centre = self.bodies[part].centre;
            let own = mechanics::cross(&self.position(centre, about), &force);
            sum += self.each_over_members(part, own);
            if let Some(own) = self.bodies[part].frame {
                let inertia = self.inertia(part, centre);
                sum += match kind {
                    Inertial::Coriolis => {
                        let spin = self.angular_velocity(own, frame);
                        mechanics::coriolis_moment(&inertia, &omega, &spin)
                    }
                    Inertial::Centrifugal => mechanics::centrifugal_moment(&inertia, &omega),
                    Inertial::Euler => mechanics::euler_moment(&inertia, &change),
                };
            }
        }
        sum
    }
}
