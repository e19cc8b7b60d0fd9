//! A covector of the result of a step, on its way back through the stages.

use super::algebra::{
    Turn, Vector, applied, before, between, cross, dot, plus, plus_times, pulled, times, turned,
    turned_back,
};
use super::stages::{Stages, weighed};
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
    velocity: Vector<T>,
    moment: Vector<T>,
    /// Of −δI a.
    inertial: Vector<T>,
    /// Of −δI v: moment × v.
    momentum: Vector<T>,
}

impl<T: Arithmetic, I: Tensor<T>> Stages<T, I> {
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
            result.turn = Some(times(of, number(0.5 * self.step)));
        }
        if let Some(of) = of_omega {
            omega = of;
            result.acceleration = Some(times(of, self.square));
        }
        let sources = self.sources(&result);
        let [a, b, c, d] = &sources;
        let velocity = weighed([a.velocity, b.velocity, c.velocity, d.velocity]);
        let momentum = weighed([a.momentum, b.momentum, c.momentum, d.momentum]);
        let velocity = self.tensor.start(velocity, momentum);
        let moment = weighed([a.moment, b.moment, c.moment, d.moment]);
        let factor = unit * number(2.0 / (3.0 * self.step));
        let mut span = zero;
        if N > 15 {
            let gained = self.by_length(velocity, &sources) * factor;
            let spread = dot(omega, self.sum) * number(2.0 / (3.0 * self.step));
            span = (gained - spread) * number(1.0 / self.step);
        }
        Pulled {
            theta,
            omega: plus_times(omega, velocity, unit * number(1.0 / 3.0)),
            torque: times(moment, unit * number(self.step / 6.0)),
            inertia: match N {
                ..10 => [zero; 6],
                _ => times(self.by_inertia(&sources, momentum), factor),
            },
            span,
        }
    }

    /// Through all stages, from the last to the first.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sources(&self, result: &Way<T>) -> [Source<T>; 4] {
        let [_, second, third, fourth] = &self.stages;
        let d = self.source(3, result);
        let way = result.before(result, fourth.half, d.velocity, d.momentum);
        let c = self.source(2, &way);
        let way = result.before(&way, third.half, c.velocity, c.momentum);
        let b = self.source(1, &way);
        // The second stage has twice the weight of the first.
        let two = self.square.constant(2.0);
        let [velocity, momentum] = [times(b.velocity, two), times(b.momentum, two)];
        let way = result.before(&way, second.velocity, velocity, momentum);
        [self.source(0, &way), b, c, d]
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
            velocity,
            moment,
            inertial,
            momentum: cross(moment, stage.velocity),
        }
    }

    /// The covector of the tensor. Each v is that of the start and an a, so that besides the first v only the a are met.
    #[inline(always)]
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
    #[inline(always)]
    fn by_length(&self, velocity: Vector<T>, sources: &[Source<T>; 4]) -> T {
        let mut parts = [[self.square]; 4];
        for ((part, source), stage) in parts.iter_mut().zip(sources).zip(&self.stages) {
            let mut grown = stage.moment.by_step;
            if let Some(by_velocity) = stage.moment.by_velocity {
                grown = plus(grown, applied(by_velocity, stage.velocity));
            }
            *part = [dot(source.moment, grown)];
        }
        let [sum] = weighed(parts);
        sum + dot(velocity, self.stages[0].velocity)
    }
}

impl<T: Arithmetic> Way<T> {
    /// The way into the stage before: `self` is that of the result, `after` the one in the stage that follows, which turns by `half`.
    #[inline(always)]
    fn before(
        &self,
        after: &Self,
        half: Vector<T>,
        velocity: Vector<T>,
        momentum: Vector<T>,
    ) -> Self {
        let mut turn = None;
        if let (Some(onto), Some(of)) = (self.turn, after.turn) {
            turn = Some(turned_back(onto, of, half));
        }
        Self {
            turn,
            acceleration: match self.acceleration {
                Some(of) => Some(plus(of, velocity)),
                None => Some(velocity),
            },
            momentum,
        }
    }
}

impl<T: Arithmetic> Pulled<T> {
    /// In the order of the columns.
    #[inline(always)]
    pub(super) fn flat(self) -> [T; 16] {
        let ([a, b, c], [d, e, f], [g, h, i]) = (self.theta, self.omega, self.torque);
        let ([j, k, l, m, n, o], span) = (self.inertia, self.span);
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, span]
    }
}

/// A covector of −δI v on its way back to the entries of δI.
#[inline(always)]
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
