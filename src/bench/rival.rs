//! The same motion as a user writes it down for the solvers of `ode_solvers`.

use crate::mechanics::{adjugate, apply, cross, determinant};
use crate::motion::{Quaternion, State, Torque, TorqueLaw};
use crate::scene::Member;
use nalgebra::{Matrix3, Vector3};
use ode_solvers::dop_shared::{IntegrationError, OutputType};
use ode_solvers::{Dop853, Dopri5, SVector, System};
use std::hint::black_box;

/// ω, then q with the scalar first.
type Vector7 = SVector<f64, 7>;

struct Equations {
    inertia: Matrix3<f64>,
    inverse: Matrix3<f64>,
    torque: Torque,
    /// A constant torque besides, body axes.
    added: Vector3<f64>,
}

impl System<f64, Vector7> for Equations {
    fn system(&self, time: f64, y: &Vector7, dy: &mut Vector7) {
        let state = unpack(y);
        let omega = state.angular_velocity;
        let moment = self.torque.torque(time, &state) + self.added
            - cross(&omega, &apply(&self.inertia, &omega));
        let alpha = apply(&self.inverse, &moment);
        let rate = state.attitude.rate(&omega).components();
        for i in 0..3 {
            dy[i] = alpha[i];
        }
        for i in 0..4 {
            dy[3 + i] = rate[i];
        }
    }
}

fn unpack(y: &Vector7) -> State<f64> {
    State {
        attitude: Quaternion::new([y[3], y[4], y[5], y[6]]),
        angular_velocity: Vector3::new(y[0], y[1], y[2]),
    }
}

fn setting(member: &Member) -> (Equations, Vector7) {
    let inertia = *member.body.inertia();
    let equations = Equations {
        inverse: adjugate(&inertia) / determinant(&inertia),
        inertia,
        torque: member.torque,
        added: Vector3::zeros(),
    };
    let q = member.start.attitude.components();
    let w = member.start.angular_velocity;
    let start = Vector7::from_column_slice(&[w.x, w.y, w.z, q[0], q[1], q[2], q[3]]);
    (equations, start)
}

/// The end of a motion by DOP853 of `ode_solvers`, its quaternion made unit.
pub(crate) fn dop853(member: &Member, duration: f64, tolerance: f64) -> Option<State<f64>> {
    let (equations, start) = setting(member);
    solved(equations, start, duration, tolerance)
}

/// The size of a forward difference, of numbers about 1.
const SHIFT: f64 = 1e-7;

/// The same, and the columns of its Jacobian in (θ, ω, torque, inertia), each by one more run.
pub(crate) fn differences(member: &Member, duration: f64, tolerance: f64) -> Option<State<f64>> {
    let end = dop853(member, duration, tolerance)?;
    for column in 0..15 {
        let (mut equations, mut start) = setting(member);
        match column {
            0..3 => {
                let theta = Vector3::from_fn(|r, _| if r == column { SHIFT } else { 0.0 });
                let turned = member.start.attitude * Quaternion::exp(&theta);
                start.as_mut_slice()[3..].copy_from_slice(&turned.components());
            }
            3..6 => start[column - 3] += SHIFT,
            6..9 => equations.added[column - 6] = SHIFT,
            _ => {
                let (r, c) = [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)][column - 9];
                let mut inertia = equations.inertia;
                inertia[(r, c)] += SHIFT;
                inertia[(c, r)] = inertia[(r, c)];
                equations.inverse = adjugate(&inertia) / determinant(&inertia);
                equations.inertia = inertia;
            }
        }
        let moved = solved(equations, start, duration, tolerance)?;
        black_box(end.difference(&moved) / SHIFT);
    }
    Some(end)
}

/// The steps after which a run is given up: two hundred times what it should take.
fn most_steps(start: &Vector7, duration: f64) -> u32 {
    let angle = Vector3::new(start[0], start[1], start[2]).norm() * duration;
    (1e5 + 1e3 * angle) as u32
}

fn solved(
    equations: Equations,
    start: Vector7,
    duration: f64,
    tolerance: f64,
) -> Option<State<f64>> {
    let (t, sparse) = (tolerance, OutputType::Sparse);
    // Its own defaults, but for the output: with dense output in one interval it extrapolates its first step.
    let mut solver = Dop853::from_param(
        equations,
        0.0,
        duration,
        duration,
        start,
        t,
        t,
        0.9,
        0.0,
        0.333,
        6.0,
        duration,
        0.0,
        most_steps(&start, duration),
        1000,
        sparse,
    );
    end(solver.integrate().map(|_| ()), solver.y_out())
}

/// The end of a motion by the method of Dormand and Prince of order 5.
pub(crate) fn dopri5(member: &Member, duration: f64, tolerance: f64) -> Option<State<f64>> {
    let (equations, start) = setting(member);
    let (t, sparse) = (tolerance, OutputType::Sparse);
    let mut solver = Dopri5::from_param(
        equations,
        0.0,
        duration,
        duration,
        start,
        t,
        t,
        0.9,
        0.04,
        0.2,
        10.0,
        duration,
        0.0,
        most_steps(&start, duration),
        1000,
        sparse,
    );
    end(solver.integrate().map(|_| ()), solver.y_out())
}

fn end(done: Result<(), IntegrationError>, states: &[Vector7]) -> Option<State<f64>> {
    done.ok()?;
    let state = unpack(states.last()?);
    Some(State {
        attitude: state.attitude.normalised(),
        ..state
    })
}
