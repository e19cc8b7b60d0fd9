//! What a method costs on this machine.

use crate::motion::{System, Torque};
use crate::scene::{Member, Run, Way, plan, size};
use nalgebra::Vector3;

/// Bounds of a step for which costs are known.
pub const BOUNDS: [f64; 5] = [1e-3, 1e-6, 1e-9, 1e-12, 1e-15];

/// Nanoseconds for each radian that a body turns, by bound of a step; and of the closed forms for each evaluation.
///
/// The defaults were measured by `polhode bench` on one core of an x86-64 server; what the plan uses are their ratios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Taylor series.
    pub taylor: [f64; 5],
    /// DOP853.
    pub dop853: [f64; 5],
    /// To set a free body up, and to evaluate it once more.
    pub free: [f64; 2],
    /// To evaluate a spin.
    pub spin: f64,
    /// A step of RK4.
    pub rk4: f64,
}

impl Default for Costs {
    fn default() -> Self {
        Self {
            taylor: [280.0, 400.0, 480.0, 650.0, 800.0],
            dop853: [115.0, 225.0, 500.0, 1150.0, 2700.0],
            free: [600.0, 100.0],
            spin: 40.0,
            rk4: 60.0,
        }
    }
}

impl Costs {
    /// The ways of stepping that meet the tolerance of a run, with their costs in s: Taylor, DOP853.
    pub fn candidates(&self, member: &Member, run: &Run) -> [(Way, f64); 2] {
        let [taylor, dop853] = plan::bounds(run);
        let ways = [
            Way::Taylor { tolerance: taylor },
            Way::Dop853 { tolerance: dop853 },
        ];
        ways.map(|way| (way, self.seconds(member, run, &way)))
    }

    /// The time for one body, s.
    pub fn seconds(&self, member: &Member, run: &Run, way: &Way) -> f64 {
        let outputs = &run.outputs;
        let rows = if outputs.trajectory || outputs.energy || outputs.momentum {
            1.0 + run.duration / run.output_interval
        } else {
            1.0
        };
        let angle = angle(member, run.duration);
        1e-9 * match way {
            Way::Spin(_) => self.spin * rows,
            Way::Free => self.free[0] + self.free[1] * rows,
            Way::Taylor { tolerance } => between(&self.taylor, *tolerance) * angle.max(1.0),
            Way::Dop853 { tolerance } => between(&self.dop853, *tolerance) * angle.max(1.0),
            Way::Rk4 { step } => self.rk4 * (run.duration / step).ceil(),
        }
    }
}

/// The angle that a body turns, or that its torque turns: what the number of steps follows.
fn angle(member: &Member, duration: f64) -> f64 {
    let system = System::over(*member.body.inertia(), member.torque, Vector3::zeros());
    let alpha = system.rates(0.0, &member.start).angular_acceleration.norm();
    let frequency = match member.torque {
        Torque::Sinusoid {
            angular_frequency, ..
        } => angular_frequency.abs(),
        _ => 0.0,
    };
    let rate = size(&member.start.angular_velocity)
        .max(alpha.sqrt())
        .max(frequency);
    rate * duration
}

/// A cost at a bound, between those that are known, on a logarithmic scale.
fn between(costs: &[f64; 5], bound: f64) -> f64 {
    let place = (-bound.log10() / 3.0 - 1.0).clamp(0.0, 4.0);
    let low = (place as usize).min(3);
    let part = place - low as f64;
    costs[low].powf(1.0 - part) * costs[low + 1].powf(part)
}
