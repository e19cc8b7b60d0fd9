//! A covector of the result of a step, on its way back through the stages.

use super::algebra::{
    Turn, Vector, applied, before, between, cross, dot, minus, plus, plus_times, pulled, times,
    turned, turned_back,
};
use super::moments::{ByTurn, Moment};
use super::stages::{Stage, Stages, weighed};
use super::tensor::Tensor;
use crate::motion::registers::Arithmetic;

/// A covector of the result times the Jacobian.
#[derive(Clone, Copy)]
pub(super) struct Pulled<T> {
    pub(super) theta: Vector<T>,
    pub(super) omega: Vector<T>,
    pub(super) torque: Vector<T>,
    pub(super) inertia: [T; 6],
    pub(super) span: T,
    /// Of the torque at each stage, in its axes.
    pub(super) torques: [Vector<T>; 4],
}

/// A covector of the rates of a stage, over the stage's weight: of the turn's over 2 and of the acceleration; and what the stage
/// after adds of −δI v. What is `None` is 0.
#[derive(Clone, Copy)]
struct Way<T> {
    turn: Option<Turn<T>>,
    acceleration: Option<Vector<T>>,
    momentum: Vector<T>,
}

/// What it is of the stage's velocity and moment and of a change of the tensor.
#[derive(Clone, Copy)]
struct Source<T> {
    /// Of the stage's turn by the moment alone, over 2; what is `None` is 0.
    turn: Option<Turn<T>>,
    velocity: Vector<T>,
    moment: Vector<T>,
    /// Of −δI a.
    inertial: Vector<T>,
    /// Of −δI v: moment × v.
    momentum: Vector<T>,
}

impl<T: Arithmetic, I: Tensor<T>, D: ByTurn<T>> Stages<T, I, Moment<T, D>> {
    /// A covector (of θ', of ω') of the result times the columns below `N` of the Jacobian; what is `None` is 0.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn pulled_back<const N: usize>(
        &self,
        of_theta: Option<Vector<T>>,
        of_omega: Option<Vector<T>>,
    ) -> Pulled<T> {
        let number = |value: f64| self.square.constant(value);
        let zero = number(0.0);
        let (mut theta, mut omega) = ([zero; 3], [zero; 3]);
        let mut result = Way {
            turn: None,
            acceleration: None,
            momentum: [zero; 3],
        };
        // On the way all is too large by the square of the turn's length, and nothing waits for the division.
        let unit = number(1.0) / self.square;
        if let Some(of) = of_theta {
            let of = turned(self.end, of);
            // Of a turn beforehand, which goes through to the end.
            theta = times(before(self.end, of), unit);
            result.turn = Some(times(of, number(0.5 * self.start.step)));
        } else if D::IS_ANY {
            result.turn = Some([zero; 4]);
        }
        if let Some(of) = of_omega {
            omega = of;
            result.acceleration = Some(times(of, self.square));
        }
        let factor = unit * number(2.0 / (3.0 * self.start.step));
        let (sources, turn) = self.sources(&result);
        if let (true, Some([_, axis @ ..])) = (D::IS_ANY, turn) {
            theta = times(axis, factor);
        }
        let [a, b, c, d] = &sources;
        let velocity = weighed([a.velocity, b.velocity, c.velocity, d.velocity]);
        let momentum = weighed([a.momentum, b.momentum, c.momentum, d.momentum]);
        let velocity = self.tensor.start(velocity, momentum);
        let sixth = unit * number(self.start.step / 6.0);
        let torque = times(self.by_torque(&sources), sixth);
        let third = sixth * number(2.0);
        let mut span = zero;
        if N > 15 {
            let gained = self.by_length(velocity, &sources) * factor;
            let spread = dot(omega, self.sum) * number(2.0 / (3.0 * self.start.step));
            span = (gained - spread) * number(1.0 / self.start.step);
        }
        Pulled {
            theta,
            omega: plus_times(omega, velocity, unit * number(1.0 / 3.0)),
            torque,
            inertia: match N {
                ..10 => [zero; 6],
                _ => times(self.by_inertia(&sources, momentum), factor),
            },
            span,
            torques: [
                times(a.moment, sixth),
                times(b.moment, third),
                times(c.moment, third),
                times(d.moment, sixth),
            ],
        }
    }

    /// Through all stages, from the last to the first; and the covector of the turn at the start, as of those of the stages by their
    /// weights, which are 6 together.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sources(&self, result: &Way<T>) -> ([Source<T>; 4], Option<Turn<T>>) {
        let [first, second, third, fourth] = &self.stages;
        let d = self.source(3, result);
        let into_third = result.before(result, fourth.half, &d);
        let c = self.source(2, &into_third);
        let into_second = result.before(&into_third, third.half, &c);
        let b = self.source(1, &into_second);
        // The second stage has twice the weight of the first.
        let into_first = result.before(&into_second, second.velocity, &b.doubled());
        let a = self.source(0, &into_first);
        let into_start = result.before(&into_first, first.half, &a);
        let mut turn = None;
        if let (Some(p), Some(q), Some(r), Some(s), Some(own)) = (
            into_start.turn,
            into_first.turn,
            into_second.turn,
            into_third.turn,
            result.turn,
        ) {
            let two = self.square.constant(2.0);
            turn = Some(plus_times(plus(plus(p, q), s), minus(r, own), two));
        }
        ([a, b, c, d], turn)
    }

    /// Back through stage `i`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn source(&self, i: usize, way: &Way<T>) -> Source<T> {
        let stage = &self.stages[i];
        let zero = [self.square.constant(0.0); 3];
        let direct = match (i, way.turn) {
            (0, Some([_, x, y, z])) => [x, y, z],
            (_, Some(of)) => between(stage.turn, of),
            (_, None) => zero,
        };
        let Some(of) = way.acceleration else {
            return Source {
                turn: None,
                velocity: direct,
                moment: zero,
                inertial: zero,
                momentum: zero,
            };
        };
        let (moment, inertial) = I::sources(self.tensor.inverse(of), way.momentum);
        let place = (stage.velocity, stage.momentum);
        let mut velocity = self.tensor.back(direct, place, of, moment);
        if let Some(by_velocity) = stage.moment.by_velocity {
            velocity = plus(velocity, pulled(by_velocity, moment));
        }
        Source {
            turn: stage.moment.by_turn.back(moment),
            velocity,
            moment,
            inertial,
            momentum: cross(moment, stage.velocity),
        }
    }

    /// The covector of an added torque, in the axes in which it is given.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn by_torque(&self, [a, b, c, d]: &[Source<T>; 4]) -> Vector<T> {
        let Some(axes) = self.start.axes else {
            return weighed([a.moment, b.moment, c.moment, d.moment]);
        };
        let [_, second, third, fourth] = &self.stages;
        let moments = [
            a.moment,
            second.seen_at_start(b.moment),
            third.seen_at_start(c.moment),
            fourth.seen_at_start(d.moment),
        ];
        applied(axes, weighed(moments))
    }

    /// The covector of the tensor. Each v is that of the start and an a, so that besides the first v only the a are met.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn by_inertia(&self, [a, b, c, d]: &[Source<T>; 4], momentum: Vector<T>) -> [T; 6] {
        let two = self.square.constant(2.0);
        let [first, second, third, fourth] = &self.stages;
        let mut inertia = [self.square.constant(0.0); 6];
        less_tensor(&mut inertia, d.inertial, fourth.acceleration);
        less_tensor(&mut inertia, times(c.inertial, two), third.acceleration);
        less_tensor(&mut inertia, times(b.inertial, two), second.acceleration);
        less_tensor(&mut inertia, momentum, first.velocity);
        less_tensor(&mut inertia, a.inertial, first.acceleration);
        inertia
    }

    /// The covector of the logarithm of the step's length, where it is not written out.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn by_length(&self, velocity: Vector<T>, sources: &[Source<T>; 4]) -> T {
        let mut parts = [[self.square]; 4];
        for ((part, source), stage) in parts.iter_mut().zip(sources).zip(&self.stages) {
            *part = [dot(source.moment, stage.moment.by_length)];
        }
        let [sum] = weighed(parts);
        sum + dot(velocity, self.stages[0].velocity)
    }
}

impl<T: Arithmetic, K, D> Stage<T, K, D> {
    /// What stands in the axes of this stage, in those of the start of the step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn seen_at_start(&self, v: Vector<T>) -> Vector<T> {
        before(self.turn, turned(self.turn, v))
    }
}

impl<T: Arithmetic> Source<T> {
    /// Twice what the stage before goes on from.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn doubled(&self) -> Self {
        let two = self.velocity[0].constant(2.0);
        let mut turn = None;
        if let Some(own) = self.turn {
            turn = Some(times(own, two));
        }
        Self {
            turn,
            velocity: times(self.velocity, two),
            momentum: times(self.momentum, two),
            ..*self
        }
    }
}

impl<T: Arithmetic> Way<T> {
    /// The way into the stage before: `self` is that of the result, `after` the one in the stage that follows, which turns by `half`.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn before(&self, after: &Self, half: Vector<T>, source: &Source<T>) -> Self {
        let mut turn = None;
        if let (Some(mut onto), Some(of)) = (self.turn, after.turn) {
            if let Some(own) = source.turn {
                onto = plus(onto, own);
            }
            turn = Some(turned_back(onto, of, half));
        }
        Self {
            turn,
            acceleration: match self.acceleration {
                Some(of) => Some(plus(of, source.velocity)),
                None => Some(source.velocity),
            },
            momentum: source.momentum,
        }
    }
}

impl<T: Arithmetic> Pulled<T> {
    /// In the order of the columns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn flat(self) -> [T; 16] {
        let ([a, b, c], [d, e, f], [g, h, i]) = (self.theta, self.omega, self.torque);
        let ([j, k, l, m, n, o], span) = (self.inertia, self.span);
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, span]
    }
}

/// A covector of −δI v on its way back to the entries of δI.
#[cfg_attr(not(debug_assertions), inline(always))]
fn less_tensor<T: Arithmetic>(onto: &mut [T; 6], [a, b, c]: Vector<T>, [x, y, z]: Vector<T>) {
    let [xx, yy, zz, xy, xz, yz] = *onto;
    *onto = [
        xx.less_product(a, x),
        yy.less_product(b, y),
        zz.less_product(c, z),
        xy.less_product(a, y).less_product(b, x),
        xz.less_product(a, z).less_product(c, x),
        yz.less_product(b, z).less_product(c, y),
    ];
}
