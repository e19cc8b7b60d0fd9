//! One body of a scene, all its numbers drawn.

use crate::motion::{Body, Frame, MotionError, State, Torque};
use crate::scene::{Draw, Group, Quantity, inertia::all};
use nalgebra::Vector3;

/// A body, where it starts, and the torque on it.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Member {
    /// The body.
    pub body: Body,
    /// Its state at time 0.
    pub start: State<f64>,
    /// The law of torque.
    pub torque: Torque,
}

/// A law of torque as it stands in the file.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum TorqueForm {
    /// A free body.
    None,
    /// A constant vector, N m.
    Constant {
        /// Where it is constant.
        frame: Frame,
        /// Its components.
        value: [Quantity; 3],
    },
    /// A heavy top.
    Gravity {
        /// N.
        weight: Quantity,
        /// From the fixed point to the centre of mass, body axes, m.
        arm: [Quantity; 3],
    },
    /// −c ω.
    Damping {
        /// N m s.
        coefficient: Quantity,
    },
    /// A sin(w t + φ).
    Sinusoid {
        /// The axes of the amplitude.
        frame: Frame,
        /// N m.
        amplitude: [Quantity; 3],
        /// rad/s.
        angular_frequency: Quantity,
        /// rad.
        phase: Quantity,
    },
}

impl TorqueForm {
    /// The law for one member.
    pub fn law(&self, draw: &mut Draw) -> Torque {
        match self {
            Self::None => Torque::None,
            Self::Constant { frame, value } => Torque::Constant {
                frame: *frame,
                value: all(value, draw).into(),
            },
            Self::Gravity { weight, arm } => Torque::Gravity {
                weight: weight.draw(draw),
                arm: all(arm, draw).into(),
            },
            Self::Damping { coefficient } => Torque::Damping {
                coefficient: coefficient.draw(draw),
            },
            Self::Sinusoid {
                frame,
                amplitude,
                angular_frequency,
                phase,
            } => Torque::Sinusoid {
                frame: *frame,
                amplitude: Vector3::from(all(amplitude, draw)),
                angular_frequency: angular_frequency.draw(draw),
                phase: phase.draw(draw),
            },
        }
    }
}

impl Group {
    /// The body that all members share, if they share one.
    ///
    /// # Errors
    /// A tensor that no body has.
    pub fn shared_body(&self) -> Result<Option<Body>, MotionError> {
        if self.inertia.is_fixed() {
            let tensor = self.inertia.tensor(self.products, &mut Draw::new(0, 0));
            Body::new(&tensor).map(Some)
        } else {
            Ok(None)
        }
    }

    /// Member `index` (from 0), its body taken from [`shared_body`](Self::shared_body) where there is one.
    ///
    /// # Errors
    /// Drawn numbers that no body has: an impossible tensor, an attitude without direction, what is not finite.
    pub fn member(&self, index: u64, shared: Option<&Body>) -> Result<Member, MotionError> {
        let mut draw = Draw::new(self.seed, index);
        let body = match shared {
            Some(body) => *body,
            None => Body::new(&self.inertia.tensor(self.products, &mut draw))?,
        };
        let attitude = all(&self.attitude, &mut draw);
        let start = State::new(attitude, all(&self.angular_velocity, &mut draw))?;
        Ok(Member {
            body,
            start,
            torque: self.torque.law(&mut draw),
        })
    }

    /// The name of member `index`: the group's own where it is alone.
    pub fn member_name(&self, index: u64) -> String {
        if self.count == 1 {
            self.name.clone()
        } else {
            format!("{}[{index}]", self.name)
        }
    }
}
