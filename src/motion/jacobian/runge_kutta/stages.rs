//! The stages of a step, forward.
//!
//! Time is counted in half steps: v = ω h/2, a = α h²/4 and the moment M h²/4 obey the same equations, and the stages stand 1, 1
//! and 2 after the start. What is left of the products with the length of the step and with the weights is two sums.

use super::algebra::{Turn, Vector, dot, plus, plus_times, times, turned};
use super::moments::{Moment, Moments, Place};
use super::tensor::Tensor;
use crate::motion::registers::Arithmetic;

/// A step before it is taken.
#[derive(Clone, Copy)]
pub(super) struct Start<T> {
    pub(super) attitude: Turn<T>,
    pub(super) omega: Vector<T>,
    pub(super) step: f64,
    /// The matrix of the attitude, if an added torque stands in space.
    pub(super) axes: Option<[Vector<T>; 3]>,
}

/// What a stage leaves behind for its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Stage<T, K, D> {
    pub(super) velocity: Vector<T>,
    /// v/2.
    pub(super) half: Vector<T>,
    pub(super) momentum: K,
    pub(super) net: K,
    pub(super) acceleration: Vector<T>,
    pub(super) moment: Moment<T, D>,
    /// Attitude p since the start of the step, and its rate p v/2.
    pub(super) turn: Turn<T>,
    pub(super) turn_rate: Turn<T>,
}

impl<T: Arithmetic, K: Copy, D: Copy> Stage<T, K, D> {
    /// The first stage.
    #[inline(always)]
    pub(super) fn first(
        tensor: &impl Tensor<T, Momentum = K>,
        moments: &impl Moments<T, ByTurn = D>,
        velocity: Vector<T>,
    ) -> Self {
        let moment = moments.at(Place::Start, None, velocity);
        Self::new(tensor, moment, (velocity, tensor.momentum(velocity)), None)
    }

    /// The stage so many half steps after `start`, by the rates of this one.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn after<I: Tensor<T, Momentum = K>>(
        &self,
        tensor: &I,
        moments: &impl Moments<T, ByTurn = D>,
        start: &Self,
        place: Place,
    ) -> Self {
        let (span, one) = (
            self.half[0].constant(place.half_steps()),
            self.half[0].constant(1.0),
        );
        let velocity = plus_times(start.velocity, self.acceleration, span);
        let momentum = I::onward(start.momentum, self.net, span);
        let [w, x, y, z] = times(self.turn_rate, span);
        let turn = Some([one + w, x, y, z]);
        let moment = moments.at(place, turn, velocity);
        Self::new(tensor, moment, (velocity, momentum), turn)
    }

    /// The stage of a velocity with its momentum and of the attitude since the start, `None` for no turn.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(
        tensor: &impl Tensor<T, Momentum = K>,
        moment: Moment<T, D>,
        (velocity, momentum): (Vector<T>, K),
        turn: Option<Turn<T>>,
    ) -> Self {
        let (acceleration, net) = tensor.acceleration(moment.value, velocity, momentum);
        let half = times(velocity, velocity[0].constant(0.5));
        let (zero, one) = (half[0].constant(0.0), half[0].constant(1.0));
        Self {
            velocity,
            momentum,
            net,
            acceleration,
            moment,
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
pub(super) struct Stages<T, I: Tensor<T>, D> {
    pub(super) tensor: I,
    pub(super) start: Start<T>,
    pub(super) stages: [Stage<T, I::Momentum, D>; 4],
    /// The turn of the step before it is made unit, and |.|² of it.
    pub(super) end: Turn<T>,
    pub(super) square: T,
    /// The accelerations added up by their weights.
    pub(super) sum: Vector<T>,
}

impl<T: Arithmetic, I: Tensor<T>, D: Copy> Stages<T, I, D> {
    /// The stages of a step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(tensor: I, moments: &impl Moments<T, ByTurn = D>, start: Start<T>) -> Self {
        let first = Stage::first(&tensor, moments, start.velocity());
        let second = first.after(&tensor, moments, &first, Place::Middle);
        let third = second.after(&tensor, moments, &first, Place::Middle);
        let fourth = third.after(&tensor, moments, &first, Place::End);
        Self::of(tensor, start, [first, second, third, fourth])
    }

    /// The step of its stages.
    #[inline(always)]
    pub(super) fn of(tensor: I, start: Start<T>, stages: [Stage<T, I::Momentum, D>; 4]) -> Self {
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
            start,
            stages,
            end,
            square: dot(end, end),
            sum: weighed(accelerations),
        }
    }

    /// The state after the step.
    #[inline(always)]
    pub(super) fn state(&self) -> (Turn<T>, Vector<T>) {
        let ([w, ..], [s, x, y, z]) = (self.start.attitude, self.end);
        let turned = turned(self.start.attitude, [x, y, z]);
        let whole = plus_times(turned, self.start.attitude, s);
        let size = w.constant(1.0) / dot(whole, whole).root();
        let gained = w.constant(2.0 / (3.0 * self.start.step));
        let after = plus_times(self.start.omega, self.sum, gained);
        (times(whole, size), after)
    }
}

impl<T: Arithmetic> Start<T> {
    /// ω in half steps.
    #[inline(always)]
    pub(super) fn velocity(&self) -> Vector<T> {
        times(self.omega, self.omega[0].constant(0.5 * self.step))
    }
}

/// The sum of what the stages give, by their weights 1, 2, 2, 1.
#[inline(always)]
pub(super) fn weighed<T: Arithmetic, const N: usize>([a, b, c, d]: [[T; N]; 4]) -> [T; N] {
    plus_times(plus(a, d), plus(b, c), a[0].constant(2.0))
}
