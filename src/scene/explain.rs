//! What a plan does and what it leaves out, in words.

use crate::mechanics::Products;
use crate::motion::{Frame, MotionError, Torque};
use crate::scene::sensitivity::looks_away;
use crate::scene::{Group, Member, Method, PlanError, Run, Way, is_free, plan, way};
use nalgebra::Vector3;
use std::{error, fmt};

/// The plan of one group, as a database explains a query.
#[derive(Clone, Debug, PartialEq)]
pub struct Explanation {
    /// The name of the group.
    pub name: String,
    /// Its bodies.
    pub count: u64,
    /// The kind of body: its moments, and what they mean.
    pub body: String,
    /// The kind of torque.
    pub torque: String,
    /// What the scene asks of it.
    pub asks: Vec<&'static str>,
    /// How the motion is computed.
    pub way: Way,
    /// Why so.
    pub why: String,
    /// The time that it will take one core, s, all members together.
    pub seconds: f64,
    /// Work that is not done.
    pub skipped: Vec<Skip>,
}

/// Work that is not done.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct Skip {
    /// What.
    pub what: &'static str,
    /// Why nothing is lost.
    pub why: String,
}

/// Why a group cannot be explained.
#[derive(Clone, Debug, PartialEq)]
pub enum ExplainError {
    /// A body that cannot be.
    Motion(MotionError),
    /// No plan can be made.
    Plan(PlanError),
}

impl fmt::Display for ExplainError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Motion(reason) => reason.fmt(f),
            Self::Plan(reason) => reason.fmt(f),
        }
    }
}

impl error::Error for ExplainError {}

/// Explains the plan of a group by its first member.
///
/// # Errors
/// A body that cannot be; a method that its motion does not allow.
pub fn explain(group: &Group, run: &Run) -> Result<Explanation, ExplainError> {
    let shared = group.shared_body().map_err(ExplainError::Motion)?;
    let member = group
        .member(0, shared.as_ref())
        .map_err(ExplainError::Motion)?;
    let way = way(&member, run).map_err(ExplainError::Plan)?;
    let mut skipped = of_motion(&member, &way);
    skipped.extend(of_body(group, &member, shared.is_some(), &way));
    skipped.extend(of_outputs(&member, run));
    if plan::spares_attitude(&member, run, &way) {
        let why = "only the energy is asked for, and the torque does not look at it; exact";
        skipped.push(skip("attitude", why));
    }
    Ok(Explanation {
        name: group.name.clone(),
        count: group.count,
        body: body(&member),
        torque: torque(&member.torque).to_owned(),
        asks: asks(run),
        why: why(&member, run, &way),
        seconds: run.costs.seconds(&member, run, &way) * group.count as f64,
        way,
        skipped,
    })
}

fn skip(what: &'static str, why: impl Into<String>) -> Skip {
    Skip {
        what,
        why: why.into(),
    }
}

fn body(member: &Member) -> String {
    let m = member.body.moments();
    // To rounding, as a rotation of the tensor leaves it.
    let equal = |a: f64, b: f64| (a - b).abs() <= 8.0 * f64::EPSILON * m.z;
    let kind = if equal(m.x, m.z) {
        "sphere"
    } else if equal(m.x, m.y) || equal(m.y, m.z) {
        "axisymmetric"
    } else {
        "three unequal moments"
    };
    let flat = if m.x + m.y - m.z <= 1e-12 * m.z {
        ", flat"
    } else {
        ""
    };
    format!("{kind}{flat}: {:.6e}, {:.6e}, {:.6e} kg m²", m.x, m.y, m.z)
}

fn torque(law: &Torque) -> &'static str {
    match law {
        law if is_free(law) => "none",
        Torque::None => "none",
        Torque::Constant {
            frame: Frame::Body, ..
        } => "constant in the body",
        Torque::Constant {
            frame: Frame::Space,
            ..
        } => "constant in space",
        Torque::Gravity { .. } => "gravity about a fixed point",
        Torque::Damping { .. } => "damping",
        Torque::Sinusoid {
            frame: Frame::Body, ..
        } => "sinusoid in the body",
        Torque::Sinusoid {
            frame: Frame::Space,
            ..
        } => "sinusoid in space",
    }
}

fn asks(run: &Run) -> Vec<&'static str> {
    let o = &run.outputs;
    let all = [
        (o.last, "final"),
        (o.trajectory, "trajectory"),
        (o.energy, "energy"),
        (o.momentum, "momentum"),
        (o.jacobian, "jacobian"),
    ];
    all.iter()
        .filter(|(asked, _)| *asked)
        .map(|(_, name)| *name)
        .collect()
}

fn why(member: &Member, run: &Run, way: &Way) -> String {
    if run.method != Method::Auto {
        return format!("the scene says `method = \"{}\"`", run.method.name());
    }
    match way {
        Way::Spin(spin) if spin.is_rest() => "it is at rest, and no torque moves it".to_owned(),
        Way::Spin(_) => {
            "it spins about a principal axis, and the torque has that axis too".to_owned()
        }
        Way::Free => {
            "no torque: the motion is known in elliptic functions, right to rounding at any time"
                .to_owned()
        }
        Way::Taylor { .. } | Way::Dop853 { .. } | Way::Rk4 { .. } => {
            let [taylor, dop853] = run
                .costs
                .candidates(member, run)
                .map(|(_, seconds)| seconds * 1e6);
            format!(
                "cheapest for this tolerance: Taylor {taylor:.0} µs, DOP853 {dop853:.0} µs a body"
            )
        }
    }
}

/// What the kind of motion makes unnecessary.
fn of_motion(member: &Member, way: &Way) -> Vec<Skip> {
    let mut skips = Vec::new();
    match way {
        Way::Spin(spin) if spin.is_rest() => {
            skips.push(skip("everything", "a sleeping body stays what it is"));
        }
        Way::Spin(_) => {
            skips.push(skip(
                "integration",
                "speed and angle are formulas of the time; exact",
            ));
            skips.push(skip(
                "gyroscopic term",
                "ω × Iω is 0 to the last bit on this axis",
            ));
        }
        Way::Free => {
            skips.push(skip(
                "integration",
                "the closed form is evaluated at the output times alone; exact",
            ));
            skips.push(skip(
                "error control",
                "there are no steps whose errors could add up",
            ));
        }
        _ => {}
    }
    let m = member.body.moments();
    if matches!(way, Way::Taylor { .. } | Way::Dop853 { .. }) && *m == Vector3::from_element(m.x) {
        skips.push(skip(
            "gyroscopic term",
            "the moment differences of a sphere are 0",
        ));
    }
    skips
}

/// What the body makes unnecessary.
fn of_body(group: &Group, member: &Member, shared: bool, way: &Way) -> Vec<Skip> {
    let mut skips = Vec::new();
    let tensor = member.body.inertia();
    let products = [(0, 1), (0, 2), (1, 2)].map(|place| tensor[place] != 0.0);
    if !matches!(way, Way::Rk4 { .. }) {
        skips.push(match products {
            [false, false, false] => skip("products of inertia", "they are 0: the body axes are principal"),
            _ => skip(
                "products of inertia",
                format!("the body is turned to its principal axes once, and back at each output ({} convention in the file)", convention(group.products)),
            ),
        });
    }
    if shared && group.count > 1 {
        let others = group.count - 1;
        skips.push(skip(
            "principal axes",
            format!("found once, and shared by {others} other members"),
        ));
    }
    skips
}

fn convention(products: Products) -> &'static str {
    match products {
        Products::Integrals => "integrals",
        Products::Entries => "entries",
    }
}

/// What nobody asks for.
fn of_outputs(member: &Member, run: &Run) -> Vec<Skip> {
    let mut skips = Vec::new();
    let (o, wrt) = (&run.outputs, &run.wrt);
    if o.trajectory {
        skips.push(skip(
            "trajectory storage",
            "each row is written when it is known",
        ));
    } else {
        skips.push(skip("trajectory", "not asked for"));
    }
    if !(o.trajectory || o.energy || o.momentum) {
        skips.push(skip(
            "output times before the last",
            "only the final state is asked for",
        ));
    }
    if !o.jacobian {
        skips.push(skip("Jacobian", "not asked for"));
        return skips;
    }
    if wrt.attitude && looks_away(member) {
        skips.push(skip(
            "Jacobian in the attitude",
            "the torque does not look at it: the block is the turn of the whole motion, exact",
        ));
    }
    if wrt.dt {
        skips.push(skip(
            "Jacobian in the duration",
            "it is the equation of motion at the end, exact",
        ));
    }
    let columns = [
        (wrt.angular_velocity, "the angular velocity"),
        (wrt.torque, "the torque"),
        (wrt.inertia, "the inertia"),
    ];
    let left: Vec<_> = columns
        .iter()
        .filter(|(asked, _)| !asked)
        .map(|(_, name)| *name)
        .collect();
    if !left.is_empty() {
        skips.push(skip(
            "Jacobian columns",
            format!("not asked for in {}", left.join(", ")),
        ));
    }
    skips
}
