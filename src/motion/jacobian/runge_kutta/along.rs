//! The change of a step with a direction of its input, stage by stage beside it.

use super::algebra::{
    Turn, Vector, between, dot, minus, plus, plus_cross, plus_times, pulled, times, turned, turning,
};
use super::moments::{ByTurn, Moments, Place, Shift};
use super::stages::{Reached, Stage, Stages, Start, weighed};
use super::tensor::{Tensor, symmetric};
use crate::motion::registers::Arithmetic;

/// A direction of the input.
#[derive(Clone, Copy)]
pub(super) struct Direction<T> {
    pub(super) theta: Vector<T>,
    pub(super) omega: Vector<T>,
    pub(super) torque: Vector<T>,
    pub(super) inertia: [T; 6],
    /// `None` for a length that stays.
    pub(super) span: Option<T>,
}

/// The change of a stage's rates; the last is that of the momentum, δI a alone along principal axes.
#[derive(Clone, Copy)]
struct Change<T> {
    turn_rate: Turn<T>,
    acceleration: Vector<T>,
    net: Vector<T>,
}

/// The change of what a stage's rates come from: of p, `None` in the first stage where no law looks at it, of v and of the momentum.
#[derive(Clone, Copy)]
struct Moved<T> {
    turn: Option<Turn<T>>,
    velocity: Vector<T>,
    momentum: Vector<T>,
}

/// A stage that keeps the change of its moment.
type Along<T, K> = Stage<T, K, Vector<T>>;

/// The step, and the change of (θ', ω') with a direction.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn along<T: Arithmetic, I: Tensor<T>, M: Moments<T>>(
    tensor: I,
    moments: &M,
    start: Start<T>,
    direction: &Direction<T>,
) -> (Stages<T, I, Vector<T>>, [T; 6]) {
    let (number, step) = (|value: f64| start.omega[0].constant(value), start.step);
    let way = Way::new(direction, &start);
    let mut velocity = times(direction.omega, number(0.5 * step));
    if let Some(span) = way.span {
        velocity = plus_times(velocity, start.velocity(), span);
    }
    let own = Moved {
        turn: M::ByTurn::IS_ANY.then_some(way.turn),
        velocity,
        momentum: tensor.changed(velocity, symmetric(way.inertia, start.velocity())),
    };
    // Beside each other, for what a stage leaves behind fills all registers.
    let place = Reached::start(&tensor, start.velocity());
    let first = way.stage(&tensor, moments, Place::Start, place, &own);
    let a = way.change(&tensor, &first, &own);
    let (place, moved) = (
        first.leading::<I>(&first, Place::Middle),
        own.after(&a, Place::Middle),
    );
    let second = way.stage(&tensor, moments, Place::Middle, place, &moved);
    let b = way.change(&tensor, &second, &moved);
    let (place, moved) = (
        second.leading::<I>(&first, Place::Middle),
        own.after(&b, Place::Middle),
    );
    let third = way.stage(&tensor, moments, Place::Middle, place, &moved);
    let c = way.change(&tensor, &third, &moved);
    let (place, moved) = (
        third.leading::<I>(&first, Place::End),
        own.after(&c, Place::End),
    );
    let fourth = way.stage(&tensor, moments, Place::End, place, &moved);
    let d = way.change(&tensor, &fourth, &moved);
    let stages = Stages::of(tensor, start, [first, second, third, fourth]);

    let moved = weighed([a.turn_rate, b.turn_rate, c.turn_rate, d.turn_rate]);
    let turned = match own.turn {
        Some(turn) => turn,
        None => way.turned(stages.end),
    };
    let turned = plus_times(turned, moved, number(1.0 / 3.0));
    let unit = number(2.0) / stages.square;
    let [p, q, r] = times(between(stages.end, turned), unit);
    let mut faster = weighed([
        a.acceleration,
        b.acceleration,
        c.acceleration,
        d.acceleration,
    ]);
    if let Some(span) = way.span {
        faster = minus(faster, times(stages.sum, span));
    }
    let [x, y, z] = plus_times(direction.omega, faster, number(2.0 / (3.0 * step)));
    (stages, [p, q, r, x, y, z])
}

/// A direction in half steps.
struct Way<T> {
    /// Of the turn since the start: θ/2.
    turn: Turn<T>,
    /// In the axes of the stage, or in those of the start where it stands in space.
    torque: Vector<T>,
    in_space: bool,
    inertia: [T; 6],
    /// Of the logarithm of the length, `None` for 0.
    span: Option<T>,
}

impl<T: Arithmetic> Way<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(direction: &Direction<T>, start: &Start<T>) -> Self {
        let (number, step) = (|value: f64| start.omega[0].constant(value), start.step);
        let [x, y, z] = times(direction.theta, number(0.5));
        let torque = times(direction.torque, number(0.25 * step * step));
        let mut span = direction.span;
        if let Some(span) = &mut span {
            *span = *span * number(1.0 / step);
        }
        Self {
            turn: [number(0.0), x, y, z],
            torque: match start.axes {
                Some(axes) => pulled(axes, torque),
                None => torque,
            },
            in_space: start.axes.is_some(),
            inertia: direction.inertia,
            span,
        }
    }

    /// A stage and the change of its moment.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn stage<I: Tensor<T>>(
        &self,
        tensor: &I,
        moments: &impl Moments<T>,
        place: Place,
        reached: Reached<T, I::Momentum>,
        moved: &Moved<T>,
    ) -> Along<T, I::Momentum> {
        let mut torque = self.torque;
        if let (true, Some(turn)) = (self.in_space, reached.turn) {
            torque = between(turn, turning(torque, turn));
        }
        let shift = Shift {
            turn: moved.turn,
            velocity: moved.velocity,
            span: self.span,
            torque,
        };
        let along = moments.along(place, reached.turn, reached.velocity, &shift);
        Stage::new(tensor, reached, along)
    }

    /// The change of a turn with one beforehand, which goes through to the end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn turned(&self, [s, axis @ ..]: Turn<T>) -> Turn<T> {
        let [zero, half @ ..] = self.turn;
        let [x, y, z] = plus_cross(times(half, s), half, axis);
        [zero - dot(half, axis), x, y, z]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn change<I: Tensor<T>>(
        &self,
        tensor: &I,
        stage: &Along<T, I::Momentum>,
        moved: &Moved<T>,
    ) -> Change<T> {
        let (acceleration, net) = tensor.along(
            (stage.velocity, stage.momentum),
            stage.moment,
            moved.velocity,
            moved.momentum,
            symmetric(self.inertia, stage.acceleration),
        );
        let half = times(moved.velocity, stage.half[0].constant(0.5));
        let zero = stage.half[0].constant(0.0);
        Change {
            turn_rate: match moved.turn {
                Some(turn) => plus(turned(turn, stage.half), turned(stage.turn, half)),
                None => [zero, half[0], half[1], half[2]],
            },
            acceleration,
            net,
        }
    }
}

impl<T: Arithmetic> Moved<T> {
    /// That of a stage, by the rates of the stage before.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn after(&self, before: &Change<T>, place: Place) -> Self {
        let span = self.velocity[0].constant(place.half_steps());
        Self {
            turn: Some(match self.turn {
                Some(turn) => plus_times(turn, before.turn_rate, span),
                None => times(before.turn_rate, span),
            }),
            velocity: plus_times(self.velocity, before.acceleration, span),
            momentum: plus_times(self.momentum, before.net, span),
        }
    }
}
