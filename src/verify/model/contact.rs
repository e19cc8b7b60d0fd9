//! Planes, the round bodies that touch them, and the points of a body that are at a place.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::model::system::{BodyId, FrameId, PointId, System, Vector};
use num_traits::One;

/// The round part by which a body touches a plane; its centre is the mass centre.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Round {
    Sphere {
        radius: Fraction,
    },
    /// The rim of a disc about an axis of the body's frame.
    Rim {
        radius: Fraction,
        axis: usize,
    },
}

/// A plane that a frame carries.
#[derive(Clone, Debug)]
pub(crate) struct Plane {
    /// Its name.
    pub(crate) name: String,
    /// The frame that it is fixed in.
    pub(crate) frame: FrameId,
    /// The unit vector across it, to the side on which bodies are.
    pub(crate) normal: Vector,
}

/// A body that touches a plane, and where.
#[derive(Clone, Debug)]
pub(crate) struct Contact {
    pub(crate) body: BodyId,
    pub(crate) plane: Plane,
    /// The place where they touch.
    pub(crate) point: PointId,
}

/// A point that a frame carries along, by the place where it is now.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Carried {
    /// The frame that carries it.
    pub(crate) frame: FrameId,
    /// A point that the frame carries always.
    pub(crate) base: PointId,
    /// Where it is now.
    pub(crate) at: PointId,
}

impl System {
    /// A plane by its name.
    pub(crate) fn plane(&self, name: &str) -> Option<&Plane> {
        self.planes.iter().find(|plane| plane.name == name)
    }

    /// The way from the mass centre of a round body to the point where it touches a plane below it.
    pub(crate) fn way_to_contact(&mut self, body: BodyId, normal: &Vector) -> Option<Vector> {
        match self.bodies[body].round.clone()? {
            Round::Sphere { radius } => Some(mechanics::lowest_of_sphere(&radius, normal)),
            Round::Rim { radius, axis } => {
                let axis = self.axis(self.bodies[body].frame?, axis);
                let cosine = normal.dot(&axis);
                let sine = self
                    .atoms
                    .root(&(Fraction::one() - cosine.clone() * cosine))?;
                Some(mechanics::lowest_of_disc(&radius, &axis, normal) / sine)
            }
        }
    }

    /// The point of a rigid body that is at a place now.
    pub(crate) fn body_point(&self, body: BodyId, at: PointId) -> Option<Carried> {
        let whole = &self.bodies[body];
        Some(Carried {
            frame: whole.frame?,
            base: whole.centre,
            at,
        })
    }

    /// Its velocity relative to a frame.
    pub(crate) fn carried_velocity(&mut self, of: Carried, relative: FrameId) -> Vector {
        let velocity = self.velocity(of.base, relative);
        let omega = self.angular_velocity(of.frame, relative);
        let place = self.position(of.at, of.base);
        mechanics::velocity_of_body_point(&velocity, &omega, &place)
    }

    /// Its acceleration relative to a frame.
    pub(crate) fn carried_acceleration(&mut self, of: Carried, relative: FrameId) -> Vector {
        let velocity = self.velocity(of.base, relative);
        let acceleration = self.rate_seen_from(relative, &velocity);
        let omega = self.angular_velocity(of.frame, relative);
        let alpha = self.rate_seen_from(relative, &omega);
        let place = self.position(of.at, of.base);
        mechanics::acceleration_of_body_point(&acceleration, &omega, &alpha, &place)
    }
}
