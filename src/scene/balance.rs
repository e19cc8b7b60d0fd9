//! What a motion keeps, and how far a computed one is off it.

use crate::mechanics::{angular_momentum, kinetic_energy};
use crate::motion::{Frame, State, Torque};
use crate::scene::Member;
use nalgebra::Vector3;

/// The conserved quantities of a member at its start.
#[derive(Clone, Copy, Debug)]
pub struct Balance {
    member: Member,
    energy: f64,
    momentum: Vector3<f64>,
}

impl Balance {
    /// The balance from the start of a member.
    pub fn new(member: &Member) -> Self {
        let mut balance = Self {
            member: *member,
            energy: 0.0,
            momentum: Vector3::zeros(),
        };
        balance.energy = balance.energy(&member.start);
        balance.momentum = balance.momentum(&member.start);
        balance
    }

    /// T, and with gravity T + V, in J; V is 0 where the centre of mass is as high as the fixed point.
    pub fn energy(&self, state: &State<f64>) -> f64 {
        let kinetic = kinetic_energy(self.member.body.inertia(), &state.angular_velocity);
        kinetic + self.potential(state)
    }

    fn potential(&self, state: &State<f64>) -> f64 {
        match &self.member.torque {
            Torque::Gravity { weight, arm } => weight * state.attitude.to_space(arm).z,
            _ => 0.0,
        }
    }

    /// The angular momentum in space axes, N m s.
    pub fn momentum(&self, state: &State<f64>) -> Vector3<f64> {
        let momentum = angular_momentum(self.member.body.inertia(), &state.angular_velocity);
        state.attitude.to_space(&momentum)
    }

    /// How far the energy is off its start, against the largest part of it; `None` where the torque takes or gives
    /// energy.
    pub fn energy_drift(&self, state: &State<f64>) -> Option<f64> {
        let conserved = matches!(self.member.torque, Torque::None | Torque::Gravity { .. });
        conserved.then(|| {
            let scale = self.energy.abs().max(self.potential(state).abs());
            relative(self.energy(state) - self.energy, scale)
        })
    }

    /// How far the angular momentum in space is off what the torque made of it, against its size; `None` where the
    /// torque's impulse depends on the motion. Of a top, the vertical component.
    pub fn momentum_drift(&self, time: f64, state: &State<f64>) -> Option<f64> {
        let now = self.momentum(state);
        let off = now - self.momentum;
        let scale = now.norm().max(self.momentum.norm());
        match &self.member.torque {
            Torque::None => Some(relative(off.norm(), scale)),
            Torque::Gravity { .. } => Some(relative(off.z.abs(), scale)),
            Torque::Constant {
                frame: Frame::Space,
                value,
            } => Some(relative((off - value * time).norm(), scale)),
            Torque::Sinusoid {
                frame: Frame::Space,
                amplitude,
                angular_frequency,
                phase,
            } => {
                let half = 0.5 * angular_frequency * time;
                let cardinal = if half == 0.0 { 1.0 } else { half.sin() / half };
                let impulse = amplitude * (time * cardinal * (half + phase).sin());
                Some(relative((off - impulse).norm(), scale))
            }
            _ => None,
        }
    }
}

fn relative(off: f64, scale: f64) -> f64 {
    if scale > 0.0 {
        off.abs() / scale
    } else {
        off.abs()
    }
}
