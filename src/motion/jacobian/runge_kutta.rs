//! The Jacobian of the classical Runge–Kutta step, backwards through its four stages.
//!
//! Six rows go back through the stages instead of sixteen columns forward. What symmetry knows is written
//! down: under a torque that does not look at the attitude the step commutes with turns of space, so
//! ∂θ'/∂θ is the turn of the step and ∂ω'/∂θ is 0. A change δI of the tensor acts as the moment
//! −(δI α + ω × δI ω), so the inverse is never differentiated and repeated moments are nothing special.

mod matrix;
mod products;

use crate::mechanics::{angular_momentum, apply, cross, product, skew};
use crate::motion::block::{Block, LANES, Lane};
use crate::motion::{Quaternion, State, System, TorqueLaw};
use nalgebra::{Matrix3, SVector, Vector3, Vector6};

/// The step and its Jacobian, or `None` if the law gives a torque that depends on the attitude.
#[inline(always)]
pub(crate) fn step_with_jacobian<const N: usize, L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
) -> Option<(State<f64>, [[f64; 6]; N])> {
    let back = Back::new(system, time, state, step)?;
    Some((back.state(state), back.columns()))
}

/// Eight steps and the columns of their Jacobians; `false` if the law gives a torque that depends on the attitude.
#[inline(always)]
pub(crate) fn block_with_jacobian<const N: usize, L: TorqueLaw<f64>>(
    system: &impl Fn(usize) -> System<f64, L>,
    time: f64,
    block: &mut Block,
    step: f64,
    columns: &mut [[Lane; 6]; N],
) -> bool {
    let still = Vector3::zeros();
    if system(0).law().without_attitude(time, &still).is_none() {
        return false;
    }
    let mut tape = matrix::EMPTY;
    for lane in 0..LANES {
        let (system, state) = (system(lane), block.get(lane));
        if let Some(back) = Back::new(&system, time, &state, step) {
            block.set(lane, &back.state(&state));
            back.record(&mut tape, columns, lane);
        }
    }
    let inverse = |lane: usize| *system(lane).inverse();
    matrix::rows::<N, 0>(&tape, inverse, step, columns);
    matrix::rows::<N, 1>(&tape, inverse, step, columns);
    matrix::rows::<N, 2>(&tape, inverse, step, columns);
    matrix::rows::<N, 3>(&tape, inverse, step, columns);
    matrix::rows::<N, 4>(&tape, inverse, step, columns);
    matrix::rows::<N, 5>(&tape, inverse, step, columns);
    true
}

/// The step and its Jacobian times a direction of the input.
pub(crate) fn jvp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, 16>,
) -> Option<(State<f64>, Vector6<f64>)> {
    let back = Back::new(system, time, state, step)?;
    Some((back.state(state), back.along(direction)))
}

/// The step and a covector of its result times the Jacobian.
pub(crate) fn vjp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
) -> Option<(State<f64>, SVector<f64, 16>)> {
    let back = Back::new(system, time, state, step)?;
    Some((back.state(state), back.pulled_back(covector)))
}

/// Weights of the stages in the result, and the part of the step at which each stands.
const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];
const PARTS: [f64; 4] = [0.0, 0.5, 0.5, 1.0];

/// What a stage leaves behind for the way back.
struct Stage {
    omega: Vector3<f64>,
    acceleration: Vector3<f64>,
    /// The derivative of the net moment in ω.
    slope: Matrix3<f64>,
    /// The torque's own rate in time.
    by_time: Vector3<f64>,
    /// Attitude since the start of the step, and its rate ½ p ω.
    turn: Quaternion<f64>,
    turn_rate: Quaternion<f64>,
}

struct Back<'a> {
    stages: [Stage; 4],
    inverse: &'a Matrix3<f64>,
    step: f64,
    /// The turn of the step before it is made unit, and the mean of its rate.
    end: Quaternion<f64>,
    mean: Quaternion<f64>,
}

impl<'a> Back<'a> {
    /// The stages of a step, or `None` if the law gives a torque that depends on the attitude.
    #[inline(always)]
    fn new<L: TorqueLaw<f64>>(
        system: &'a System<f64, L>,
        time: f64,
        state: &State<f64>,
        step: f64,
    ) -> Option<Self> {
        let start = state.angular_velocity;
        let first = stage(system, time, start, Quaternion::identity())?;
        let second = stage_after(system, (time, start, step), 0.5, &first)?;
        let third = stage_after(system, (time, start, step), 0.5, &second)?;
        let fourth = stage_after(system, (time, start, step), 1.0, &third)?;
        let inner = (second.turn_rate + third.turn_rate) * WEIGHTS[1];
        let mean = (first.turn_rate + fourth.turn_rate) * WEIGHTS[0] + inner;
        Some(Self {
            end: Quaternion::identity() + mean * step,
            stages: [first, second, third, fourth],
            inverse: system.inverse(),
            step,
            mean,
        })
    }

    /// The state after the step from `state`.
    #[inline(always)]
    fn state(&self, state: &State<f64>) -> State<f64> {
        State {
            attitude: (state.attitude * self.end.normalised()).normalised(),
            angular_velocity: state.angular_velocity + self.mean_acceleration() * self.step,
        }
    }

    #[inline(always)]
    fn mean_acceleration(&self) -> Vector3<f64> {
        let [first, second, third, fourth] = &self.stages;
        (first.acceleration + fourth.acceleration) * WEIGHTS[0]
            + (second.acceleration + third.acceleration) * WEIGHTS[1]
    }
}

#[inline(always)]
fn stage<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    omega: Vector3<f64>,
    turn: Quaternion<f64>,
) -> Option<Stage> {
    let torque = system.law().without_attitude(time, &omega)?;
    let inertia = system.inertia();
    let momentum = angular_momentum(inertia, &omega);
    let net = torque.torque + system.added() - cross(&omega, &momentum);
    // −δω × L − ω × I δω.
    let gyroscopic = skew(&momentum) - product(&skew(&omega), inertia);
    Some(Stage {
        acceleration: apply(system.inverse(), &net),
        slope: torque.by_angular_velocity + gyroscopic,
        by_time: torque.by_time,
        turn_rate: turn.rate(&omega),
        omega,
        turn,
    })
}

/// The stage at `part` of a step, along the rates of the one before.
#[inline(always)]
fn stage_after<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    (time, start, step): (f64, Vector3<f64>, f64),
    part: f64,
    before: &Stage,
) -> Option<Stage> {
    let span = step * part;
    let omega = start + before.acceleration * span;
    let turn = Quaternion::identity() + before.turn_rate * span;
    stage(system, time + span, omega, turn)
}
