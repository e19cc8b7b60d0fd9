//! What a method costs on this machine.

use crate::diagnostic::Diagnostic;
use crate::motion::{Frame, System, Torque};
use crate::scene::{Member, Run, Way, plan, read, size};
use crate::source::Source;
use nalgebra::Vector3;
use std::fmt;

/// Bounds of a step for which costs are known.
pub const BOUNDS: [f64; 5] = [1e-3, 1e-6, 1e-9, 1e-12, 1e-15];

/// Nanoseconds for each radian that a body turns, by bound of a step; and of the closed forms for each evaluation.
///
/// Written as TOML by its `Display`, and read by [`Costs::read`]. The defaults were measured by `polhode bench` on one core of an x86-64 server; what the plan uses are their ratios.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Costs {
    /// Taylor series.
    pub taylor: [f64; 5],
    /// Taylor series under a torque that is given in space, whose direction they carry along.
    pub taylor_space: [f64; 5],
    /// DOP853.
    pub dop853: [f64; 5],
    /// DOP853 under a torque that is given in space.
    pub dop853_space: [f64; 5],
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
            taylor: [115.0, 170.0, 200.0, 275.0, 320.0],
            taylor_space: [190.0, 290.0, 370.0, 520.0, 640.0],
            dop853: [72.0, 112.0, 210.0, 450.0, 1010.0],
            dop853_space: [100.0, 204.0, 450.0, 1000.0, 2440.0],
            free: [310.0, 100.0],
            spin: 30.0,
            rk4: 57.0,
        }
    }
}

impl Costs {
    /// The costs that a file of `polhode bench --costs` holds.
    ///
    /// # Errors
    /// What is wrong with it, each with its place; at least one.
    ///
    /// ```
    /// use polhode::{scene::Costs, source::Source};
    /// let written = Costs::default().to_string();
    /// assert_eq!(Costs::read(&Source::new("costs.toml", written)), Ok(Costs::default()));
    /// ```
    pub fn read(source: &Source) -> Result<Self, Vec<Diagnostic>> {
        read::costs(source)
    }

    /// The ways of stepping that meet the tolerance of a run, with their costs in s: Taylor, DOP853.
    pub fn candidates(&self, member: &Member, run: &Run) -> [(Way, f64); 2] {
        let ways = plan::ways(member, run);
        ways.map(|way| (way, self.seconds(member, run, &way)))
    }

    /// Nanoseconds for each radian by a way of stepping with error control; 0 for others.
    pub(crate) fn per_radian(&self, law: &Torque, way: &Way) -> f64 {
        let (costs, tolerance) = match (way, in_space(law)) {
            (Way::Taylor { tolerance }, false) => (&self.taylor, tolerance),
            (Way::Taylor { tolerance }, true) => (&self.taylor_space, tolerance),
            (Way::Dop853 { tolerance }, false) => (&self.dop853, tolerance),
            (Way::Dop853 { tolerance }, true) => (&self.dop853_space, tolerance),
            _ => return 0.0,
        };
        between(costs, *tolerance)
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
            Way::Taylor { .. } | Way::Dop853 { .. } => {
                self.per_radian(&member.torque, way) * angle.max(1.0)
            }
            Way::Rk4 { step } => self.rk4 * (run.duration / step).ceil(),
        }
    }
}

impl fmt::Display for Costs {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        writeln!(
            f,
            "# ns for each radian that a body turns, by the bound of a step: {BOUNDS:?}"
        )?;
        writeln!(f, "taylor = {:?}", self.taylor)?;
        writeln!(f, "taylor_space = {:?}", self.taylor_space)?;
        writeln!(f, "dop853 = {:?}", self.dop853)?;
        writeln!(f, "dop853_space = {:?}", self.dop853_space)?;
        writeln!(
            f,
            "# ns to set a free body up, and to evaluate it once more"
        )?;
        writeln!(f, "free = {:?}", self.free)?;
        writeln!(f, "# ns to evaluate a spin, and for a step of RK4")?;
        writeln!(f, "spin = {:?}\nrk4 = {:?}", self.spin, self.rk4)
    }
}

/// Whether a law is given in space.
fn in_space(law: &Torque) -> bool {
    matches!(
        law,
        Torque::Gravity { .. }
            | Torque::Constant {
                frame: Frame::Space,
                ..
            }
            | Torque::Sinusoid {
                frame: Frame::Space,
                ..
            }
    )
}

/// The angle (rad) that a body turns, or that its torque turns: what the number of steps follows.
pub fn angle(member: &Member, duration: f64) -> f64 {
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
