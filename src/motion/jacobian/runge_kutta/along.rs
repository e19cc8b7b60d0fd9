//! The change of a step with a direction of its input, stage by stage beside it.

use super::algebra::{
    Turn, Vector, applied, between, dot, minus, plus, plus_cross, plus_times, times, turned,
};
use super::stages::{Moment, Stage, Stages, weighed};
use super::tensor::{Tensor, symmetric};
use crate::motion::registers::Arithmetic;

/// A direction of the input.
#[derive(Clone, Copy)]
pub(super) struct Direction<T> {
    pub(super) theta: Vector<T>,
    pub(super) omega: Vector<T>,
    pub(super) torque: Vector<T>,
    pub(super) inertia: [T; 6],
    pub(super) span: T,
}

/// The change of a stage's rates; the last is that of the momentum, δI a alone along principal axes.
#[derive(Clone, Copy)]
struct Change<T> {
    turn_rate: Turn<T>,
    acceleration: Vector<T>,
    net: Vector<T>,
}

/// The change of what a stage's rates come from: of p, `None` in the first stage, of v and of the momentum.
#[derive(Clone, Copy)]
struct Moved<T> {
    turn: Option<Turn<T>>,
    velocity: Vector<T>,
    momentum: Vector<T>,
}

/// The step from an angular velocity, and the change of (θ', ω') with a direction.
#[inline(always)]
pub(super) fn along<T: Arithmetic, I: Tensor<T>>(
    tensor: I,
    omega: Vector<T>,
    step: f64,
    [at_start, midway, at_end]: &[Moment<T>; 3],
    direction: &Direction<T>,
) -> (Stages<T, I>, [T; 6]) {
    let number = |value: f64| direction.span.constant(value);
    let start = times(omega, number(0.5 * step));
    let way = Direction {
        torque: times(direction.torque, number(0.25 * step * step)),
        span: direction.span * number(1.0 / step),
        ..*direction
    };
    let velocity = times(direction.omega, number(0.5 * step));
    let velocity = plus_times(velocity, start, way.span);
    let own = Moved {
        turn: None,
        velocity,
        momentum: tensor.changed(velocity, symmetric(way.inertia, start)),
    };
    // Beside each other, for what a stage leaves behind fills all registers.
    let first = Stage::first(&tensor, at_start, start);
    let a = way.change(&tensor, &first, &own);
    let second = first.after(&tensor, midway, &first, 1.0);
    let b = way.change(&tensor, &second, &own.after(&a, 1.0));
    let third = second.after(&tensor, midway, &first, 1.0);
    let c = way.change(&tensor, &third, &own.after(&b, 1.0));
    let fourth = third.after(&tensor, at_end, &first, 2.0);
    let d = way.change(&tensor, &fourth, &own.after(&c, 2.0));
    let stages = Stages::of(tensor, step, [first, second, third, fourth]);

    let moved = weighed([a.turn_rate, b.turn_rate, c.turn_rate, d.turn_rate]);
    // A turn beforehand goes through to the end.
    let ([s, axis @ ..], half) = (stages.end, times(direction.theta, number(0.5)));
    let [x, y, z] = plus_cross(times(half, s), half, axis);
    let turned = [number(0.0) - dot(half, axis), x, y, z];
    let turned = plus_times(turned, moved, number(1.0 / 3.0));
    let unit = number(2.0) / stages.square;
    let [p, q, r] = times(between(stages.end, turned), unit);
    let faster = weighed([
        a.acceleration,
        b.acceleration,
        c.acceleration,
        d.acceleration,
    ]);
    let faster = minus(faster, times(stages.sum, way.span));
    let [x, y, z] = plus_times(direction.omega, faster, number(2.0 / (3.0 * step)));
    (stages, [p, q, r, x, y, z])
}

impl<T: Arithmetic> Direction<T> {
    #[inline(always)]
    fn change<I: Tensor<T>>(
        &self,
        tensor: &I,
        stage: &Stage<T, I::Momentum>,
        moved: &Moved<T>,
    ) -> Change<T> {
        let mut moment = plus_times(self.torque, stage.moment.by_step, self.span);
        if let Some(by_velocity) = stage.moment.by_velocity {
            let velocity = plus_times(moved.velocity, stage.velocity, self.span);
            moment = plus(moment, applied(by_velocity, velocity));
        }
        let (acceleration, net) = tensor.along(
            (stage.velocity, stage.momentum),
            moment,
            moved.velocity,
            moved.momentum,
            symmetric(self.inertia, stage.acceleration),
        );
        let half = times(moved.velocity, self.span.constant(0.5));
        let zero = self.span.constant(0.0);
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
    /// That of a stage so many half steps from the start, by the rates of the stage before.
    #[inline(always)]
    fn after(&self, before: &Change<T>, span: f64) -> Self {
        let span = self.velocity[0].constant(span);
        Self {
            turn: Some(times(before.turn_rate, span)),
            velocity: plus_times(self.velocity, before.acceleration, span),
            momentum: plus_times(self.momentum, before.net, span),
        }
    }
}
