//! Where each method holds: error and drift over bodies and motions that are hard.

use crate::bench::{Contender, Point, Problem, measure, reference};
use crate::motion::{Body, FreeBody, MotionError, State, Torque};
use crate::scene::{Member, is_free, size};
use nalgebra::{Matrix3, Vector3};
use std::time::Duration;

/// One way in which a motion gets harder.
#[derive(Clone, Debug, PartialEq)]
pub struct Axis {
    /// A short name.
    pub name: &'static str,
    /// What grows harder.
    pub about: &'static str,
    /// What each case is called, and the case.
    pub cases: Vec<(f64, Problem)>,
}

/// A method in a case.
#[derive(Clone, Debug, PartialEq)]
pub struct Cell {
    /// The axis.
    pub axis: &'static str,
    /// The place on it.
    pub value: f64,
    /// Error and drift.
    pub point: Point,
}

/// The tolerance of methods that have one, and the angle turned in a step of those that have not.
const TOLERANCE: f64 = 1e-13;
const ANGLE: f64 = 0.02;
/// Above this many radians the closed form is the reference, as thirty digits would take too long.
const LONG: f64 = 2e3;

/// The axes; `longest` is the longest duration (s) of that axis.
///
/// # Errors
/// None for these bodies.
pub fn axes(longest: f64) -> Result<Vec<Axis>, MotionError> {
    Ok(vec![
        Axis {
            name: "inertia ratio",
            about: "largest moment over the smallest, free",
            cases: cases(&[1.0, 1e2, 1e4, 1e6, 1e8, 1e10, 1e12], |r| {
                free([1.0 / r, 1.0, 1.0 + 0.5 / r], [1.0, 2.0, -0.3], 5.0)
            })?,
        },
        Axis {
            name: "top ratio",
            about: "largest moment over the smallest, heavy top",
            cases: cases(&[1.5, 1e1, 1e2, 1e3, 1e4], |r| {
                let law = Torque::Gravity {
                    weight: 1.0,
                    arm: Vector3::new(1.0 / r, 0.0, 0.1 / r),
                };
                with([1.0 / r, 1.0, 1.0], [3.0, 0.5, -0.4], law, 2.0)
            })?,
        },
        Axis {
            name: "separatrix",
            about: "spin about the middle axis, this far off it",
            cases: cases(&[1.0, 1e-2, 1e-4, 1e-6, 1e-8, 1e-12, 1e-16], |d| {
                free([2.0, 3.0, 4.0], [0.0, 3.0, 3.0 * d], 5.0)
            })?,
        },
        Axis {
            name: "scale",
            about: "moments of inertia multiplied by this",
            cases: cases(&SCALES, |s| {
                free([0.6 * s, 0.8 * s, s], [3.0, 0.5, -0.9], 5.0)
            })?,
        },
        Axis {
            name: "damped scale",
            about: "moments and damping multiplied by this",
            cases: cases(&SCALES, |s| {
                let law = Torque::Damping {
                    coefficient: 0.1 * s,
                };
                with([0.6 * s, 0.8 * s, s], [3.0, 0.5, -0.9], law, 5.0)
            })?,
        },
        Axis {
            name: "spin",
            about: "angular velocity multiplied by this, in as much less time",
            cases: cases(&SPINS, |s| {
                free([0.6, 0.8, 1.0], [3.0 * s, 0.5 * s, -0.9 * s], 5.0 / s)
            })?,
        },
        Axis {
            name: "damped spin",
            about: "the same, and damping multiplied by this",
            cases: cases(&SPINS, |s| {
                let law = Torque::Damping {
                    coefficient: 0.1 * s,
                };
                let omega = [3.0 * s, 0.5 * s, -0.9 * s];
                with([0.6, 0.8, 1.0], omega, law, 5.0 / s)
            })?,
        },
        Axis {
            name: "duration",
            about: "s, at 3 rad/s, free",
            cases: cases(&within(longest), |t| {
                free([0.6, 0.8, 1.0], [3.0, 0.5, -0.9], t)
            })?,
        },
    ])
}

const SCALES: [f64; 5] = [1e-150, 1e-75, 1.0, 1e75, 1e150];
const SPINS: [f64; 9] = [1e-150, 1e-75, 1e-30, 1e-9, 1.0, 1e9, 1e30, 1e75, 1e150];

fn within(longest: f64) -> Vec<f64> {
    let all = [1.0, 1e1, 1e2, 1e3, 1e4, 1e5, 1e6];
    all.into_iter().filter(|t| *t <= longest).collect()
}

fn cases(
    values: &[f64],
    case: impl Fn(f64) -> Result<Problem, MotionError>,
) -> Result<Vec<(f64, Problem)>, MotionError> {
    values
        .iter()
        .map(|&value| Ok((value, case(value)?)))
        .collect()
}

fn free(moments: [f64; 3], omega: [f64; 3], duration: f64) -> Result<Problem, MotionError> {
    with(moments, omega, Torque::None, duration)
}

fn with(
    moments: [f64; 3],
    omega: [f64; 3],
    torque: Torque,
    duration: f64,
) -> Result<Problem, MotionError> {
    Ok(Problem {
        name: String::new(),
        about: String::new(),
        member: Member {
            body: Body::new(&Matrix3::from_diagonal(&moments.into()))?,
            start: State::at_rest().turning(omega.into()),
            torque,
        },
        duration,
    })
}

/// All methods in all cases of an axis, method by method; `tick` is called before each.
///
/// # Errors
/// A case whose true motion cannot be computed.
pub fn cells(
    axis: &Axis,
    contenders: &[Contender],
    tick: &mut dyn FnMut(),
) -> Result<Vec<Cell>, MotionError> {
    let mut found = Vec::new();
    for (value, problem) in &axis.cases {
        let truth = truth(problem)?;
        for &contender in contenders {
            tick();
            if !contender.takes(&problem.member) {
                continue;
            }
            let setting = if contender.is_adaptive() {
                TOLERANCE
            } else {
                ANGLE
            };
            found.push(Cell {
                axis: axis.name,
                value: *value,
                point: measure(problem, contender, setting, &truth, Duration::ZERO),
            });
        }
    }
    Ok(found)
}

fn truth(problem: &Problem) -> Result<State<f64>, MotionError> {
    let Problem {
        member, duration, ..
    } = problem;
    // A motion is like one of another size and speed, in which thirty digits do not overflow.
    // By powers of two: rounding would be another body.
    let size_of = power_of_two(member.body.inertia().amax());
    let speed = power_of_two(size(&member.start.angular_velocity));
    let like = Member {
        body: Body::new(&(member.body.inertia() / size_of))?,
        start: member.start.turning(member.start.angular_velocity / speed),
        torque: slowed(&member.torque, size_of, speed),
    };
    let angle = speed * duration;
    let end = if angle > LONG && is_free(&member.torque) {
        FreeBody::new(&like.body, &like.start).at(angle)?
    } else {
        last(&like, angle)?
    };
    Ok(end.turning(end.angular_velocity * speed))
}

/// The law under which a body of inertia less by `size` moves slower by `speed`.
fn slowed(law: &Torque, size: f64, speed: f64) -> Torque {
    let over = |torque: f64| torque / size / speed / speed;
    match *law {
        Torque::None => Torque::None,
        Torque::Constant { frame, value } => Torque::Constant {
            frame,
            value: value.map(over),
        },
        Torque::Gravity { weight, arm } => Torque::Gravity {
            weight: over(weight),
            arm,
        },
        Torque::Damping { coefficient } => Torque::Damping {
            coefficient: coefficient / size / speed,
        },
        Torque::Sinusoid {
            frame,
            amplitude,
            angular_frequency,
            phase,
        } => Torque::Sinusoid {
            frame,
            amplitude: amplitude.map(over),
            angular_frequency: angular_frequency / speed,
            phase,
        },
    }
}

/// The power of two at or below a positive number.
fn power_of_two(x: f64) -> f64 {
    x.log2().floor().exp2()
}

fn last(member: &Member, duration: f64) -> Result<State<f64>, MotionError> {
    let states = reference(member, &[duration])?;
    states.first().copied().ok_or(MotionError::Time {
        asked: duration,
        from: 0.0,
    })
}

/// The values of an axis at which a method keeps the error within `bound`, and those at which it does not.
pub fn held(cells: &[Cell], axis: &str, contender: Contender, bound: f64) -> (Vec<f64>, Vec<f64>) {
    let of = |cell: &&Cell| cell.axis == axis && cell.point.contender == contender;
    let (held, lost): (Vec<&Cell>, Vec<&Cell>) = cells
        .iter()
        .filter(of)
        .partition(|cell| cell.point.error <= bound);
    let values = |cells: Vec<&Cell>| cells.iter().map(|cell| cell.value).collect();
    (values(held), values(lost))
}
