//! The step of a body of any axes with its angular momentum, and products of its Jacobian with one vector.
//!
//! Beside ω = ω₀ + h Σ α goes L = I ω₀ + h Σ k with the same weights, k = M + L × ω and α = I⁻¹ k. The tensor is applied
//! once in a step instead of once in a stage, in the step and in its derivatives: δα = I⁻¹ (δk − δI α).

use super::algebra::{
    Full, Tensor, Turn, Vector, applied, between, cross, dot, minus, plus, plus_cross, plus_times,
    pulled, symmetric, times, turned,
};
use super::stages::{Moment, PARTS, Pulled, WEIGHTS, mean};
use crate::motion::registers::Arithmetic;

/// What a stage leaves behind for its derivatives.
#[derive(Clone, Copy)]
struct Stage<T> {
    omega: Vector<T>,
    momentum: Vector<T>,
    /// M + L × ω, and I⁻¹ times it.
    net: Vector<T>,
    acceleration: Vector<T>,
    moment: Moment<T>,
    /// ω h/2.
    half: Vector<T>,
    /// Attitude p since the start of the step, and h ṗ = p (h/2) ω.
    turn: Turn<T>,
    turned: Turn<T>,
}

/// A step by its stages.
pub(super) struct Step<T> {
    tensor: Full<T>,
    step: f64,
    stages: [Stage<T>; 4],
    /// The turn of the step before it is made unit, 1/|.|² of it, and the mean acceleration.
    end: Turn<T>,
    unit: T,
    mean: Vector<T>,
}

/// The change of a stage.
#[derive(Clone, Copy)]
struct Change<T> {
    net: Vector<T>,
    acceleration: Vector<T>,
    half: Vector<T>,
    turned: Turn<T>,
}

/// A direction of the input after θ.
pub(super) struct Direction<T> {
    pub(super) theta: Vector<T>,
    pub(super) omega: Vector<T>,
    pub(super) torque: Vector<T>,
    pub(super) inertia: [T; 6],
    pub(super) span: T,
}

impl<T: Arithmetic> Step<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        tensor: Full<T>,
        start: Vector<T>,
        step: f64,
        [at_start, midway, at_end]: &[Moment<T>; 3],
    ) -> Self {
        let momentum = symmetric(tensor.entries, start);
        let own = (start, momentum);
        let first = Stage::new(&tensor, at_start, step, own, None);
        let second = first.after(&tensor, midway, step, own, 1);
        let third = second.after(&tensor, midway, step, own, 2);
        let fourth = third.after(&tensor, at_end, step, own, 3);
        let (a, b, c, d) = (&first, &second, &third, &fourth);
        let [w, x, y, z] = mean([a.turned, b.turned, c.turned, d.turned]);
        let mean = mean([
            a.acceleration,
            b.acceleration,
            c.acceleration,
            d.acceleration,
        ]);
        let one = w.constant(1.0);
        let end = [one + w, x, y, z];
        Self {
            tensor,
            step,
            end,
            unit: one / dot(end, end),
            mean,
            stages: [first, second, third, fourth],
        }
    }

    /// The state after the step from `attitude` and `omega`.
    #[inline(always)]
    pub(super) fn state(&self, attitude: Turn<T>, omega: Vector<T>) -> (Turn<T>, Vector<T>) {
        let [s, x, y, z] = self.end;
        let whole = plus_times(turned(attitude, [x, y, z]), attitude, s);
        let size = s.constant(1.0) / dot(whole, whole).root();
        let after = plus_times(omega, self.mean, s.constant(self.step));
        (times(whole, size), after)
    }

    /// The change of (θ', ω') with a direction of the first `N` columns.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn along<const N: usize>(&self, direction: &Direction<T>) -> [T; 6] {
        let mut momentum = symmetric(self.tensor.entries, direction.omega);
        if N > 9 {
            momentum = plus(momentum, symmetric(direction.inertia, self.stages[0].omega));
        }
        let own = (direction.omega, momentum);
        let a = self.change::<N>(0, own, direction, None);
        let b = self.change::<N>(1, own, direction, Some(&a));
        let c = self.change::<N>(2, own, direction, Some(&b));
        let d = self.change::<N>(3, own, direction, Some(&c));
        let moved = mean([a.turned, b.turned, c.turned, d.turned]);
        let faster = mean([
            a.acceleration,
            b.acceleration,
            c.acceleration,
            d.acceleration,
        ]);
        let [s, x, y, z] = self.end;
        let half = times(direction.theta, s.constant(0.5));
        // A turn beforehand goes through to the end.
        let [a, b, c] = plus_cross(times(half, s), half, [x, y, z]);
        let moved = plus(moved, [s.constant(0.0) - dot(half, [x, y, z]), a, b, c]);
        let [a, b, c] = times(between(self.end, moved), self.unit + self.unit);
        let mut omega = plus_times(direction.omega, faster, s.constant(self.step));
        if N > 15 {
            omega = plus_times(omega, self.mean, direction.span);
        }
        let [x, y, z] = omega;
        [a, b, c, x, y, z]
    }

    /// The change of stage `i` after that of the stage before.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn change<const N: usize>(
        &self,
        i: usize,
        (mut omega, mut momentum): (Vector<T>, Vector<T>),
        direction: &Direction<T>,
        before: Option<&Change<T>>,
    ) -> Change<T> {
        let (stage, part) = (&self.stages[i], self.unit.constant(PARTS[i]));
        let span = self.unit.constant(PARTS[i] * self.step);
        let longer = direction.span * part;
        if let Some(change) = before {
            omega = plus_times(omega, change.acceleration, span);
            momentum = plus_times(momentum, change.net, span);
            if N > 15 {
                let before = &self.stages[i - 1];
                omega = plus_times(omega, before.acceleration, longer);
                momentum = plus_times(momentum, before.net, longer);
            }
        }
        let mut net = plus_cross(cross(momentum, stage.omega), stage.momentum, omega);
        if N > 6 {
            net = plus(net, direction.torque);
        }
        if let Some(by_omega) = stage.moment.by_omega {
            net = plus(net, applied(by_omega, omega));
        }
        let mut half = times(omega, self.unit.constant(0.5 * self.step));
        if N > 15 {
            net = plus_times(net, stage.moment.by_time, longer);
            let slower = direction.span * part.constant(0.5);
            half = plus_times(half, stage.omega, slower);
        }
        let mut moment = net;
        if N > 9 {
            moment = minus(moment, symmetric(direction.inertia, stage.acceleration));
        }
        Change {
            net,
            acceleration: self.tensor.inverse(moment),
            half,
            turned: self.turned_on(i, half, before),
        }
    }

    /// The change of h ṗ with that of (h/2) ω and of p.
    #[inline(always)]
    fn turned_on(&self, i: usize, half: Vector<T>, before: Option<&Change<T>>) -> Turn<T> {
        let stage = &self.stages[i];
        let zero = self.unit.constant(0.0);
        match (i, before) {
            (1, Some(first)) => {
                let [_, x, y, z] = stage.turn;
                let moved = times(first.half, zero.constant(PARTS[1]));
                let scalar = dot(moved, stage.half) + dot([x, y, z], half);
                let turned = plus_cross(plus_cross(half, [x, y, z], half), moved, stage.half);
                let [a, b, c] = turned;
                [zero - scalar, a, b, c]
            }
            (_, Some(before)) => {
                let moved = times(before.turned, zero.constant(PARTS[i]));
                plus(turned(moved, stage.half), turned(stage.turn, half))
            }
            (_, None) => [zero, half[0], half[1], half[2]],
        }
    }
}

impl<T: Arithmetic> Stage<T> {
    /// The stage of (ω, L) and of the attitude since the start, `None` for no turn.
    #[inline(always)]
    fn new(
        tensor: &Full<T>,
        moment: &Moment<T>,
        step: f64,
        (omega, momentum): (Vector<T>, Vector<T>),
        turn: Option<Turn<T>>,
    ) -> Self {
        let mut net = plus_cross(moment.at_rest, momentum, omega);
        if let Some(by_omega) = moment.by_omega {
            net = plus(net, applied(by_omega, omega));
        }
        let half = times(omega, omega[0].constant(0.5 * step));
        let (zero, one) = (omega[0].constant(0.0), omega[0].constant(1.0));
        Self {
            omega,
            momentum,
            net,
            acceleration: tensor.inverse(net),
            moment: *moment,
            half,
            turn: match turn {
                Some(turn) => turn,
                None => [one, zero, zero, zero],
            },
            turned: match turn {
                Some(turn) => turned(turn, half),
                None => [zero, half[0], half[1], half[2]],
            },
        }
    }

    /// Stage `i`, which comes after this one.
    #[inline(always)]
    fn after(
        &self,
        tensor: &Full<T>,
        moment: &Moment<T>,
        step: f64,
        (omega, momentum): (Vector<T>, Vector<T>),
        i: usize,
    ) -> Self {
        let (span, part) = (
            omega[0].constant(PARTS[i] * step),
            omega[0].constant(PARTS[i]),
        );
        let place = (
            plus_times(omega, self.acceleration, span),
            plus_times(momentum, self.net, span),
        );
        let [w, x, y, z] = times(self.turned, part);
        let turn = [w + w.constant(1.0), x, y, z];
        Self::new(tensor, moment, step, place, Some(turn))
    }
}

/// A covector of a stage's p, ω and L on its way back to the stage before.
struct Way<T> {
    turn: Turn<T>,
    omega: Vector<T>,
    momentum: Vector<T>,
}

impl<T: Arithmetic> Step<T> {
    /// A covector (of θ', of ω') of the result times the first `N` columns of the Jacobian.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn back<const N: usize>(&self, theta: Vector<T>, omega: Vector<T>) -> Pulled<T> {
        let zero = self.unit.constant(0.0);
        let end = times(turned(self.end, theta), self.unit + self.unit);
        let mut sums = Pulled {
            // Of a turn beforehand, which goes through to the end.
            theta: before(self.end, times(end, zero.constant(0.5))),
            omega,
            torque: [zero; 3],
            inertia: [zero; 6],
            span: zero,
        };
        if N > 15 {
            sums.span = dot(omega, self.mean);
        }
        let result = (end, omega);
        let d = self.stage_back::<N>(3, result, None, &mut sums);
        let c = self.stage_back::<N>(2, result, Some(&d), &mut sums);
        let b = self.stage_back::<N>(1, result, Some(&c), &mut sums);
        let a = self.stage_back::<N>(0, result, Some(&b), &mut sums);
        let momentum = plus(plus(a.momentum, b.momentum), plus(c.momentum, d.momentum));
        let start = self.stages[0].omega;
        sums.omega = plus(sums.omega, symmetric(self.tensor.entries, momentum));
        if N > 9 {
            // So far of −δI.
            sums.of_tensor(momentum, times(start, zero.constant(-1.0)));
        }
        sums
    }

    /// Back through stage `i` from the result and from the stage after it.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn stage_back<const N: usize>(
        &self,
        i: usize,
        (end, omega): (Turn<T>, Vector<T>),
        after: Option<&Way<T>>,
        sums: &mut Pulled<T>,
    ) -> Way<T> {
        let stage = &self.stages[i];
        let number = |value: f64| self.unit.constant(value);
        let mut of_turned = times(end, number(WEIGHTS[i]));
        let mut of_acceleration = times(omega, number(WEIGHTS[i] * self.step));
        if let Some(after) = after {
            let span = number(PARTS[i + 1] * self.step);
            of_turned = plus_times(of_turned, after.turn, number(PARTS[i + 1]));
            of_acceleration = plus_times(of_acceleration, after.omega, span);
        }
        let through = self.tensor.inverse(of_acceleration);
        if N > 9 {
            sums.of_tensor(through, stage.acceleration);
        }
        let mut of_net = through;
        if let Some(after) = after {
            let span = number(PARTS[i + 1] * self.step);
            of_net = plus_times(of_net, after.momentum, span);
            if N > 15 {
                let moved = dot(after.omega, stage.acceleration) + dot(after.momentum, stage.net);
                sums.span = sums.span.plus_product(moved, number(PARTS[i + 1]));
            }
        }
        if N > 6 {
            sums.torque = plus(sums.torque, of_net);
        }
        let of_half = match i {
            0 => [of_turned[1], of_turned[2], of_turned[3]],
            _ => between(stage.turn, of_turned),
        };
        if N > 15 {
            let moved = dot(of_half, stage.omega);
            sums.span = sums.span.plus_product(moved, number(0.5));
            let by_time = dot(of_net, stage.moment.by_time);
            sums.span = sums.span.plus_product(by_time, number(PARTS[i]));
        }
        let half = number(0.5 * self.step);
        let mut of_omega = plus_cross(times(of_half, half), of_net, stage.momentum);
        if let Some(by_omega) = stage.moment.by_omega {
            of_omega = plus(of_omega, pulled(by_omega, of_net));
        }
        sums.omega = plus(sums.omega, of_omega);
        let zero = number(0.0);
        let [w, x, y, z] = turned(of_turned, stage.half);
        Way {
            turn: [zero - w, zero - x, zero - y, zero - z],
            omega: of_omega,
            momentum: cross(stage.omega, of_net),
        }
    }
}

/// The vector part of q p⁻¹ for a unit p, and |p|² times that for any other.
#[inline(always)]
fn before<T: Arithmetic>([w, a, b, c]: Turn<T>, [s, x, y, z]: Turn<T>) -> Vector<T> {
    let gained = [
        (w * x).less_product(a, s),
        (w * y).less_product(b, s),
        (w * z).less_product(c, s),
    ];
    plus_cross(gained, [a, b, c], [x, y, z])
}
