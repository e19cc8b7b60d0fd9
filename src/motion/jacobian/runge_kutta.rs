//! The Jacobian of the classical Runge–Kutta step, backwards through its four stages.
//!
//! Six rows go back through the stages instead of sixteen columns forward. What symmetry knows is written
//! down: under a torque that does not look at the attitude the step commutes with turns of space, so
//! ∂θ'/∂θ is the turn of the step and ∂ω'/∂θ is 0. A change δI of the tensor acts as the moment
//! −(δI α + ω × δI ω), so the inverse is never differentiated and repeated moments are nothing special.

mod matrix;
mod products;

use crate::mechanics::{angular_momentum, apply, cross, skew};
use crate::motion::{Number, Quaternion, State, System, TorqueLaw};
use nalgebra::{Matrix3, SVector, Vector3, Vector6};

/// The columns of a Jacobian, six rows (θ', ω') each.
pub(crate) type Columns<T, const N: usize> = [[T; 6]; N];

/// The step and its Jacobian, or `None` if the law gives a torque that depends on the attitude.
#[inline(always)]
pub(crate) fn step_with_jacobian<const N: usize, T: Number, L: TorqueLaw<T>>(
    system: &System<T, L>,
    time: T,
    state: &State<T>,
    step: T,
) -> Option<(State<T>, Columns<T, N>)> {
    let back = Back::new(system, time, state, step)?;
    Some((back.state(state), back.columns()))
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
struct Stage<T> {
    omega: Vector3<T>,
    acceleration: Vector3<T>,
    /// The derivative of the net moment in ω.
    slope: Matrix3<T>,
    /// The torque's own rate in time.
    by_time: Vector3<T>,
    /// Attitude since the start of the step, and its rate ½ p ω.
    turn: Quaternion<T>,
    turn_rate: Quaternion<T>,
}

struct Back<'a, T> {
    stages: [Stage<T>; 4],
    inverse: &'a Matrix3<T>,
    step: T,
    /// The turn of the step before it is made unit, and the mean of its rate.
    end: Quaternion<T>,
    mean: Quaternion<T>,
}

impl<'a, T: Number> Back<'a, T> {
    /// The stages of a step, or `None` if the law gives a torque that depends on the attitude.
    #[inline(always)]
    fn new<L: TorqueLaw<T>>(
        system: &'a System<T, L>,
        time: T,
        state: &State<T>,
        step: T,
    ) -> Option<Self> {
        let start = state.angular_velocity;
        let first = stage(system, time, start, Quaternion::identity())?;
        let next = |part: f64, before: &Stage<T>| {
            let span = step * T::of(part);
            let omega = start + before.acceleration * span;
            let turn = Quaternion::identity() + before.turn_rate * span;
            stage(system, time + span, omega, turn)
        };
        let second = next(0.5, &first)?;
        let third = next(0.5, &second)?;
        let fourth = next(1.0, &third)?;
        let inner = (second.turn_rate + third.turn_rate) * T::of(WEIGHTS[1]);
        let mean = (first.turn_rate + fourth.turn_rate) * T::of(WEIGHTS[0]) + inner;
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
    fn state(&self, state: &State<T>) -> State<T> {
        State {
            attitude: (state.attitude * self.end.normalised()).normalised(),
            angular_velocity: state.angular_velocity + self.mean_acceleration() * self.step,
        }
    }

    #[inline(always)]
    fn mean_acceleration(&self) -> Vector3<T> {
        let [first, second, third, fourth] = &self.stages;
        (first.acceleration + fourth.acceleration) * T::of(WEIGHTS[0])
            + (second.acceleration + third.acceleration) * T::of(WEIGHTS[1])
    }
}

#[inline(always)]
fn stage<T: Number, L: TorqueLaw<T>>(
    system: &System<T, L>,
    time: T,
    omega: Vector3<T>,
    turn: Quaternion<T>,
) -> Option<Stage<T>> {
    let torque = system.law().without_attitude(time, &omega)?;
    let inertia = system.inertia();
    let momentum = angular_momentum(inertia, &omega);
    let net = torque.torque + system.added() - cross(&omega, &momentum);
    // −δω × L − ω × I δω.
    let turned = |c: usize| cross(&omega, &inertia.column(c).into_owned());
    let gyroscopic = skew(&momentum) - Matrix3::from_columns(&[turned(0), turned(1), turned(2)]);
    Some(Stage {
        acceleration: apply(system.inverse(), &net),
        slope: torque.by_angular_velocity + gyroscopic,
        by_time: torque.by_time,
        turn_rate: turn.rate(&omega),
        omega,
        turn,
    })
}
