//! Scenes: bodies, the torques on them, and what is to be known of their motion.
//!
//! A scene file is TOML ([`read()`], [`MANUAL`]). Every number of a body may be a distribution, and a group of `count` bodies
//! draws each of its members from it by a seed: the same file gives the same bodies everywhere.
//!
//! ```
//! use polhode::{scene, source::Source};
//! let text = r#"
//! [[body]]
//! name = "T-handle"
//! inertia = { xx = 2.0, yy = 3.0, zz = 4.0 }
//! angular_velocity = [0.0, 3.0, { mean = 0.0, deviation = 1e-3 }]
//! count = 1000
//! [run]
//! duration = 10.0
//! "#;
//! let scene = scene::read(&Source::new("handle.toml", text)).expect("a good scene");
//! assert_eq!(scene.bodies(), 1000);
//! ```

mod accuracy;
mod balance;
mod conditioning;
mod costs;
mod course;
mod explain;
mod inertia;
mod member;
mod plan;
mod quantity;
mod reach;
mod read;
mod sensitivity;
mod simulate;
mod spin;

pub use accuracy::{Estimated, Unsettled, distance, foresee, settle, size};
pub use balance::Balance;
pub use costs::{BOUNDS, Costs, angle};
pub use course::Course;
pub use explain::{ExplainError, Explanation, Skip, explain};
pub use inertia::{InertiaForm, Point};
pub use member::{Member, TorqueForm};
pub use plan::{PlanError, Way, is_free, jacobian_bound, way};
pub use quantity::{Draw, Quantity};
pub use reach::Reach;
pub use read::read;
pub use sensitivity::{Sensitivity, sensitivity};
pub use simulate::{Outcome, Row, RunError, Seam, Sink, simulate, simulate_from};
pub use spin::Spin;

use crate::mechanics::Products;
use crate::source::Span;

/// A scene in which everything that can be written in one is said.
pub const MANUAL: &str = include_str!("scene/manual.toml");

/// What a scene file says.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The bodies, in the order of the file.
    pub groups: Vec<Group>,
    /// What is to be computed.
    pub run: Run,
}

impl Scene {
    /// The number of bodies, members of groups counted singly.
    pub fn bodies(&self) -> u64 {
        self.groups.iter().map(|group| group.count).sum()
    }
}

/// One `[[body]]`: a body, or a group of bodies drawn from the same distributions.
#[derive(Clone, Debug, PartialEq)]
pub struct Group {
    /// The name, unlike every other in the scene.
    pub name: String,
    /// Where its inertia stands in the file.
    pub inertia_place: Span,
    /// The number of members, at least 1.
    pub count: u64,
    /// What the distributions are drawn with.
    pub seed: u64,
    /// The inertia as it was given.
    pub inertia: InertiaForm,
    /// The sign convention of products of inertia, going in and coming out.
    pub products: Products,
    /// Initial attitude, body → space, scalar first; of any length but zero.
    pub attitude: [Quantity; 4],
    /// Initial ω, rad/s, body axes.
    pub angular_velocity: [Quantity; 3],
    /// The law of torque.
    pub torque: TorqueForm,
}

/// What is to be computed, and how well.
#[derive(Clone, Debug, PartialEq)]
pub struct Run {
    /// The span of the motion, s.
    pub duration: f64,
    /// The largest error of the final state: of the attitude in radians, of ω against its size.
    pub tolerance: f64,
    /// The method, or the plan's choice.
    pub method: Method,
    /// The step of a method of fixed step, s.
    pub step: Option<f64>,
    /// What is asked for.
    pub outputs: Outputs,
    /// What the Jacobian is taken in.
    pub wrt: Wrt,
    /// The time between two rows of a trajectory, s.
    pub output_interval: f64,
    /// Whether the error of a motion without closed form is estimated, by a looser run from a start a little off.
    pub estimate_error: bool,
    /// What methods cost, by which the plan chooses.
    pub costs: Costs,
}

impl Run {
    /// A run that asks for the final state alone, without an estimate of its error, by the method that the plan chooses.
    pub fn to_the_end(duration: f64, tolerance: f64) -> Self {
        Self {
            duration,
            tolerance,
            method: Method::Auto,
            step: None,
            outputs: Outputs {
                last: true,
                ..Outputs::NONE
            },
            wrt: Wrt::NONE,
            output_interval: duration,
            estimate_error: false,
            costs: Costs::default(),
        }
    }
}

/// How a motion is computed.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub enum Method {
    /// As the plan thinks best.
    #[default]
    Auto,
    /// By the closed solution of the free body.
    Exact,
    /// By Taylor series of adaptive step.
    Taylor,
    /// By DOP853, error controlled.
    Dop853,
    /// By the classical Runge–Kutta method with a fixed step.
    Rk4,
}

impl Method {
    /// The methods and the names that a scene gives them.
    pub const NAMES: [(&'static str, Self); 5] = [
        ("auto", Self::Auto),
        ("exact", Self::Exact),
        ("taylor", Self::Taylor),
        ("dop853", Self::Dop853),
        ("rk4", Self::Rk4),
    ];

    /// The name that a scene gives it.
    pub fn name(self) -> &'static str {
        let named = Self::NAMES.iter().find(|(_, method)| *method == self);
        named.map_or("auto", |(name, _)| name)
    }
}

/// What a scene asks for.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Outputs {
    /// The final state.
    pub last: bool,
    /// The states at all output times.
    pub trajectory: bool,
    /// The drift of the energy.
    pub energy: bool,
    /// The drift of the angular momentum.
    pub momentum: bool,
    /// The derivative of the final state.
    pub jacobian: bool,
}

impl Outputs {
    /// Nothing.
    pub const NONE: Self = Self {
        last: false,
        trajectory: false,
        energy: false,
        momentum: false,
        jacobian: false,
    };
}

/// What a Jacobian is taken in.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Wrt {
    /// The initial attitude, 3 columns.
    pub attitude: bool,
    /// The initial ω, 3 columns.
    pub angular_velocity: bool,
    /// A constant torque added to the law, 3 columns.
    pub torque: bool,
    /// The inertia, 6 columns.
    pub inertia: bool,
    /// The duration, 1 column.
    pub dt: bool,
}

impl Wrt {
    /// Nothing.
    pub const NONE: Self = Self {
        attitude: false,
        angular_velocity: false,
        torque: false,
        inertia: false,
        dt: false,
    };

    /// Everything.
    pub const ALL: Self = Self {
        attitude: true,
        angular_velocity: true,
        torque: true,
        inertia: true,
        dt: true,
    };
}
