//! The stages of a step, forward.
//!
//! Time is counted in half steps: v = ω h/2, a = α h²/4 and the moment M h²/4 obey the same equations, and the stages stand 1, 1
//! and 2 after the start. What is left of the products with the length of the step and with the weights is two sums.

use super::algebra::{
    Turn, Vector, applied, dot, plus, plus_times, splat, splat_rows, times, turned,
};
use super::tensor::Tensor;
use crate::motion::registers::{Arithmetic, Registers};
use crate::motion::{System, TorqueLaw};

/// A torque that is linear in v, in half steps.
#[derive(Clone, Copy)]
pub(super) struct Moment<T> {
    pub(super) at_rest: Vector<T>,
    /// Row: component of the torque; column: component of v.
    pub(super) by_velocity: Option<[Vector<T>; 3]>,
    /// h times the derivative of what is at rest in the length h of the step.
    pub(super) by_step: Vector<T>,
}

/// The length of a step as a divisor: a step of no length is to rounding a very short one.
#[inline(always)]
pub(super) fn some_length(step: f64) -> f64 {
    if step == 0.0 { 1e-100 } else { step }
}

/// The torques at the start, in the middle and at the end of a step, or `None` if the law gives one that depends on the
/// attitude.
#[inline(always)]
pub(super) fn moments<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    step: f64,
) -> Option<[Moment<f64>; 3]> {
    let half = 0.5 * step;
    let moment = |part: f64| {
        let law = system.law().without_attitude(time + part * step)?;
        let at_rest = (law.at_rest + system.added()) * (half * half);
        Some(Moment {
            at_rest: at_rest.into(),
            by_velocity: law
                .by_angular_velocity
                .map(|m| (m.transpose() * half).data.0),
            by_step: (at_rest * 2.0 + law.by_time * (part * step * half * half)).into(),
        })
    };
    Some([moment(0.0)?, moment(0.5)?, moment(1.0)?])
}

impl Moment<f64> {
    #[inline(always)]
    pub(super) fn splat<R: Registers>(&self, registers: R) -> Moment<R::Wide> {
        let mut by_velocity = None;
        if let Some(rows) = self.by_velocity {
            by_velocity = Some(splat_rows(registers, rows));
        }
        Moment {
            at_rest: splat(registers, self.at_rest),
            by_velocity,
            by_step: splat(registers, self.by_step),
        }
    }
}

/// What a stage leaves behind for its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Stage<T, K> {
    pub(super) velocity: Vector<T>,
    /// v/2.
    pub(super) half: Vector<T>,
    pub(super) momentum: K,
    pub(super) net: K,
    pub(super) acceleration: Vector<T>,
    pub(super) moment: Moment<T>,
    /// Attitude p since the start of the step, and its rate p v/2.
    pub(super) turn: Turn<T>,
    pub(super) turn_rate: Turn<T>,
}

impl<T: Arithmetic, K: Copy> Stage<T, K> {
    /// The first stage.
    #[inline(always)]
    pub(super) fn first(
        tensor: &impl Tensor<T, Momentum = K>,
        moment: &Moment<T>,
        velocity: Vector<T>,
    ) -> Self {
        Self::new(tensor, moment, (velocity, tensor.momentum(velocity)), None)
    }

    /// The stage so many half steps after `start`, by the rates of this one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn after<I: Tensor<T, Momentum = K>>(
        &self,
        tensor: &I,
        moment: &Moment<T>,
        start: &Self,
        span: f64,
    ) -> Self {
        let (span, one) = (self.half[0].constant(span), self.half[0].constant(1.0));
        let place = (
            plus_times(start.velocity, self.acceleration, span),
            I::onward(start.momentum, self.net, span),
        );
        let [w, x, y, z] = times(self.turn_rate, span);
        Self::new(tensor, moment, place, Some([one + w, x, y, z]))
    }

    /// The stage of a velocity with its momentum and of the attitude since the start, `None` for no turn.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(
        tensor: &impl Tensor<T, Momentum = K>,
        moment: &Moment<T>,
        (velocity, momentum): (Vector<T>, K),
        turn: Option<Turn<T>>,
    ) -> Self {
        let mut given = moment.at_rest;
        if let Some(by_velocity) = moment.by_velocity {
            given = plus(given, applied(by_velocity, velocity));
        }
        let (acceleration, net) = tensor.acceleration(given, velocity, momentum);
        let half = times(velocity, velocity[0].constant(0.5));
        let (zero, one) = (half[0].constant(0.0), half[0].constant(1.0));
        Self {
            velocity,
            momentum,
            net,
            acceleration,
            moment: *moment,
            turn: match turn {
                Some(turn) => turn,
                None => [one, zero, zero, zero],
            },
            turn_rate: match turn {
                Some(turn) => turned(turn, half),
                None => [zero, half[0], half[1], half[2]],
            },
            half,
        }
    }
}

#[derive(Clone, Copy)]
pub(super) struct Stages<T, I: Tensor<T>> {
    pub(super) tensor: I,
    pub(super) step: f64,
    pub(super) stages: [Stage<T, I::Momentum>; 4],
    /// The turn of the step before it is made unit, and |.|² of it.
    pub(super) end: Turn<T>,
    pub(super) square: T,
    /// The accelerations added up by their weights.
    pub(super) sum: Vector<T>,
}

impl<T: Arithmetic, I: Tensor<T>> Stages<T, I> {
    /// The stages of a step from an angular velocity under the torques at its start, in its middle and at its end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        tensor: I,
        omega: Vector<T>,
        step: f64,
        [at_start, midway, at_end]: &[Moment<T>; 3],
    ) -> Self {
        let start = times(omega, omega[0].constant(0.5 * step));
        let first = Stage::first(&tensor, at_start, start);
        let second = first.after(&tensor, midway, &first, 1.0);
        let third = second.after(&tensor, midway, &first, 1.0);
        let fourth = third.after(&tensor, at_end, &first, 2.0);
        Self::of(tensor, step, [first, second, third, fourth])
    }

    /// The step of its stages.
    #[inline(always)]
    pub(super) fn of(tensor: I, step: f64, stages: [Stage<T, I::Momentum>; 4]) -> Self {
        let [a, b, c, d] = &stages;
        let turns = [a.turn_rate, b.turn_rate, c.turn_rate, d.turn_rate];
        let third = a.velocity[0].constant(1.0 / 3.0);
        let [w, x, y, z] = times(weighed(turns), third);
        let end = [third.constant(1.0) + w, x, y, z];
        let accelerations = [
            a.acceleration,
            b.acceleration,
            c.acceleration,
            d.acceleration,
        ];
        Self {
            tensor,
            step,
            stages,
            end,
            square: dot(end, end),
            sum: weighed(accelerations),
        }
    }

    /// The state after the step from `attitude` and `omega`.
    #[inline(always)]
    pub(super) fn state(&self, [w, a, b, c]: Turn<T>, omega: Vector<T>) -> (Turn<T>, Vector<T>) {
        let [s, x, y, z] = self.end;
        let whole = plus_times(turned([w, a, b, c], [x, y, z]), [w, a, b, c], s);
        let size = w.constant(1.0) / dot(whole, whole).root();
        let after = plus_times(omega, self.sum, w.constant(2.0 / (3.0 * self.step)));
        (times(whole, size), after)
    }
}

/// The sum of what the stages give, by their weights 1, 2, 2, 1.
#[inline(always)]
pub(super) fn weighed<T: Arithmetic, const N: usize>([a, b, c, d]: [[T; N]; 4]) -> [T; N] {
    plus_times(plus(a, d), plus(b, c), a[0].constant(2.0))
}
