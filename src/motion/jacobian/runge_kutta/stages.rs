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

/// What a stage leaves behind for its derivatives, `D` of its moment.
#[derive(Clone, Copy)]
pub(super) struct Stage<T, K, D> {
    pub(super) velocity: Vector<T>,
    /// v/2.
    pub(super) half: Vector<T>,
    pub(super) momentum: K,
    pub(super) net: K,
    pub(super) acceleration: Vector<T>,
    pub(super) moment: D,
    /// Attitude p since the start of the step, and its rate p v/2.
    pub(super) turn: Turn<T>,
    pub(super) turn_rate: Turn<T>,
}

/// Where a stage stands: its velocity with its momentum, and the attitude since the start, `None` for no turn.
#[derive(Clone, Copy)]
pub(super) struct Reached<T, K> {
    pub(super) velocity: Vector<T>,
    momentum: K,
    pub(super) turn: Option<Turn<T>>,
}

impl<T: Arithmetic, K: Copy> Reached<T, K> {
    /// The first stage.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn start(tensor: &impl Tensor<T, Momentum = K>, velocity: Vector<T>) -> Self {
        Self {
            velocity,
            momentum: tensor.momentum(velocity),
            turn: None,
        }
    }
}

impl<T: Arithmetic, K: Copy, D: Copy> Stage<T, K, D> {
    /// Where the rates of this stage lead, so many half steps after `start`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn leading<I: Tensor<T, Momentum = K>>(
        &self,
        start: &Self,
        place: Place,
    ) -> Reached<T, K> {
        let (span, one) = (
            self.half[0].constant(place.half_steps()),
            self.half[0].constant(1.0),
        );
        let [w, x, y, z] = times(self.turn_rate, span);
        Reached {
            velocity: plus_times(start.velocity, self.acceleration, span),
            momentum: I::onward(start.momentum, self.net, span),
            turn: Some([one + w, x, y, z]),
        }
    }

    /// The stage there, of a moment and what is kept of it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        tensor: &impl Tensor<T, Momentum = K>,
        reached: Reached<T, K>,
        (value, moment): (Vector<T>, D),
    ) -> Self {
        let Reached {
            velocity,
            momentum,
            turn,
        } = reached;
        let (acceleration, net) = tensor.acceleration(value, velocity, momentum);
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

impl<T: Arithmetic, K: Copy, D: Copy> Stage<T, K, Moment<T, D>> {
    /// The stage there, with all derivatives of its moment.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at(
        tensor: &impl Tensor<T, Momentum = K>,
        moments: &impl Moments<T, ByTurn = D>,
        place: Place,
        reached: Reached<T, K>,
    ) -> Self {
        let moment = moments.at(place, reached.turn, reached.velocity);
        Self::new(tensor, reached, (moment.value, moment))
    }
}

/// A step by its stages, `D` what each keeps of its moment.
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

impl<T: Arithmetic, I: Tensor<T>, D: Copy> Stages<T, I, Moment<T, D>> {
    /// The stages of a step, with all derivatives of their moments.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(tensor: I, moments: &impl Moments<T, ByTurn = D>, start: Start<T>) -> Self {
        let place = Reached::start(&tensor, start.velocity());
        let first = Stage::at(&tensor, moments, Place::Start, place);
        let place = first.leading::<I>(&first, Place::Middle);
        let second = Stage::at(&tensor, moments, Place::Middle, place);
        let place = second.leading::<I>(&first, Place::Middle);
        let third = Stage::at(&tensor, moments, Place::Middle, place);
        let place = third.leading::<I>(&first, Place::End);
        let fourth = Stage::at(&tensor, moments, Place::End, place);
        Self::of(tensor, start, [first, second, third, fourth])
    }
}

impl<T: Arithmetic, I: Tensor<T>, D: Copy> Stages<T, I, D> {
    /// The step of its stages.
    #[cfg_attr(not(debug_assertions), inline(always))]
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

    /// Attitude and angular velocity at stage `i`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn place(&self, i: usize) -> (Turn<T>, Vector<T>) {
        let (stage, start) = (&self.stages[i], self.start.attitude);
        let [s, x, y, z] = stage.turn;
        let attitude = plus_times(turned(start, [x, y, z]), start, s);
        let fast = stage.velocity[0].constant(2.0 / self.start.step);
        (attitude, times(stage.velocity, fast))
    }

    /// The state after the step.
    #[cfg_attr(not(debug_assertions), inline(always))]
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
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn velocity(&self) -> Vector<T> {
        times(self.omega, self.omega[0].constant(0.5 * self.step))
    }
}

/// The sum of what the stages give, by their weights 1, 2, 2, 1.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn weighed<T: Arithmetic, const N: usize>([a, b, c, d]: [[T; N]; 4]) -> [T; N] {
    plus_times(plus(a, d), plus(b, c), a[0].constant(2.0))
}
