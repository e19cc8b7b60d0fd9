//! The stages of a step, forward, and a covector of the result on its way back through them.

use super::algebra::{
    Tensor, Turn, Vector, applied, between, cross, dot, matrix, plus, plus_times, pulled, splat,
    splat_rows, times, turned,
};
use crate::motion::registers::{Arithmetic, Registers};
use crate::motion::{System, TorqueLaw};

/// The part of the step at which each stage stands.
pub(super) const PARTS: [f64; 4] = [0.0, 0.5, 0.5, 1.0];
/// Weights of the stages in the result.
pub(super) const WEIGHTS: [f64; 4] = [1.0 / 6.0, 1.0 / 3.0, 1.0 / 3.0, 1.0 / 6.0];

/// A torque that is linear in ω.
#[derive(Clone, Copy)]
pub(super) struct Moment<T> {
    pub(super) at_rest: Vector<T>,
    /// Row: component of the torque; column: component of ω.
    pub(super) by_omega: Option<[Vector<T>; 3]>,
    pub(super) by_time: Vector<T>,
}

/// The torques at the start, in the middle and at the end of a step, or `None` if the law gives one that depends on the
/// attitude.
#[inline(always)]
pub(super) fn moments<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    step: f64,
) -> Option<[Moment<f64>; 3]> {
    let moment = |time: f64| {
        let law = system.law().without_attitude(time)?;
        Some(Moment {
            at_rest: (law.at_rest + system.added()).into(),
            by_omega: law.by_angular_velocity.map(|m| m.transpose().data.0),
            by_time: law.by_time.into(),
        })
    };
    Some([
        moment(time)?,
        moment(time + 0.5 * step)?,
        moment(time + step)?,
    ])
}

impl Moment<f64> {
    #[inline(always)]
    pub(super) fn splat<R: Registers>(&self, registers: R) -> Moment<R::Wide> {
        let mut by_omega = None;
        if let Some(rows) = self.by_omega {
            by_omega = Some(splat_rows(registers, rows));
        }
        Moment {
            at_rest: splat(registers, self.at_rest),
            by_omega,
            by_time: splat(registers, self.by_time),
        }
    }
}

/// What a stage leaves behind for its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Stage<T, K> {
    pub(super) omega: Vector<T>,
    /// ω/2.
    pub(super) half: Vector<T>,
    /// What the tensor needs of the gyroscopic moment again.
    pub(super) kept: K,
    pub(super) acceleration: Vector<T>,
    pub(super) moment: Moment<T>,
    /// Attitude since the start of the step, and its rate ½ p ω.
    pub(super) turn: Turn<T>,
    pub(super) turn_rate: Turn<T>,
}

impl<T: Arithmetic, K> Stage<T, K> {
    /// The stage of an angular velocity and of the attitude since the start, `None` for no turn.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        tensor: &impl Tensor<T, Kept = K>,
        moment: &Moment<T>,
        omega: Vector<T>,
        turn: Option<Turn<T>>,
    ) -> Self {
        let (mut net, kept) = tensor.net(moment.at_rest, omega);
        if let Some(by_omega) = moment.by_omega {
            net = plus(net, applied(by_omega, omega));
        }
        let half = times(omega, omega[0].constant(0.5));
        let (zero, one) = (omega[0].constant(0.0), omega[0].constant(1.0));
        Self {
            omega,
            kept,
            acceleration: tensor.inverse(net),
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

    /// The stage after this one, a span (s) from the start of the step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn after(
        &self,
        tensor: &impl Tensor<T, Kept = K>,
        moment: &Moment<T>,
        start: Vector<T>,
        span: f64,
    ) -> Self {
        let (span, one) = (start[0].constant(span), start[0].constant(1.0));
        let omega = plus_times(start, self.acceleration, span);
        let [w, x, y, z] = self.turn_rate;
        let turn = [one.plus_product(w, span), x * span, y * span, z * span];
        Self::new(tensor, moment, omega, Some(turn))
    }
}

#[derive(Clone, Copy)]
pub(super) struct Stages<T, I: Tensor<T>> {
    pub(super) tensor: I,
    pub(super) step: f64,
    pub(super) stages: [Stage<T, I::Kept>; 4],
    /// The turn of the step before it is made unit, 1/|.|² of it, and the means of the rates.
    pub(super) end: Turn<T>,
    pub(super) unit: T,
    pub(super) mean_turn: Turn<T>,
    pub(super) mean: Vector<T>,
}

impl<T: Arithmetic, I: Tensor<T>> Stages<T, I> {
    /// The stages of a step from `start` under the torques at its start, in its middle and at its end.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn new(
        tensor: I,
        start: Vector<T>,
        step: f64,
        [at_start, midway, at_end]: &[Moment<T>; 3],
    ) -> Self {
        let first = Stage::new(&tensor, at_start, start, None);
        let second = first.after(&tensor, midway, start, step * PARTS[1]);
        let third = second.after(&tensor, midway, start, step * PARTS[2]);
        let fourth = third.after(&tensor, at_end, start, step * PARTS[3]);
        Self::of(tensor, step, [first, second, third, fourth])
    }

    /// The step of its stages.
    #[inline(always)]
    pub(super) fn of(tensor: I, step: f64, stages: [Stage<T, I::Kept>; 4]) -> Self {
        let [a, b, c, d] = &stages;
        let mean_turn = mean([a.turn_rate, b.turn_rate, c.turn_rate, d.turn_rate]);
        let accelerations = [
            a.acceleration,
            b.acceleration,
            c.acceleration,
            d.acceleration,
        ];
        let [w, x, y, z] = mean_turn;
        let (span, one) = (w.constant(step), w.constant(1.0));
        let end = [one.plus_product(w, span), x * span, y * span, z * span];
        Self {
            tensor,
            step,
            stages,
            end,
            unit: one / dot(end, end),
            mean_turn,
            mean: mean(accelerations),
        }
    }

    /// The state after the step from `attitude` and `omega`.
    #[inline(always)]
    pub(super) fn state(&self, [w, a, b, c]: Turn<T>, omega: Vector<T>) -> (Turn<T>, Vector<T>) {
        let [s, x, y, z] = self.end;
        let whole = plus_times(turned([w, a, b, c], [x, y, z]), [w, a, b, c], s);
        let size = w.constant(1.0) / dot(whole, whole).root();
        let after = plus_times(omega, self.mean, w.constant(self.step));
        (times(whole, size), after)
    }
}

/// The mean of the stages by their weights.
#[inline(always)]
pub(super) fn mean<T: Arithmetic, const N: usize>([a, b, c, d]: [[T; N]; 4]) -> [T; N] {
    let sum = plus_times(plus(a, d), plus(b, c), a[0].constant(2.0));
    times(sum, sum[0].constant(1.0 / 6.0))
}

/// A covector of the result times the Jacobian.
#[derive(Clone, Copy)]
pub(super) struct Pulled<T> {
    pub(super) theta: Vector<T>,
    pub(super) omega: Vector<T>,
    pub(super) torque: Vector<T>,
    pub(super) inertia: [T; 6],
    pub(super) span: T,
}

/// A covector on its way back: of θ' over 2 as one of the attitude, and of ω'; then of the rates of a stage.
#[derive(Clone, Copy)]
struct Way<T> {
    turn: Option<Turn<T>>,
    omega: Option<Vector<T>>,
}

impl<T: Arithmetic, I: Tensor<T>> Stages<T, I> {
    /// A covector (of θ', of ω') of the result times the columns below `N` of the Jacobian; what is `None` is 0.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn pulled_back<const N: usize>(
        &self,
        of_theta: Option<Vector<T>>,
        of_omega: Option<Vector<T>>,
    ) -> Pulled<T> {
        let zero = self.unit.constant(0.0);
        let mut sums = Pulled {
            theta: [zero; 3],
            omega: match of_omega {
                Some(omega) => omega,
                None => [zero; 3],
            },
            torque: [zero; 3],
            inertia: [zero; 6],
            span: zero,
        };
        let mut result = Way {
            turn: None,
            omega: of_omega,
        };
        if let Some(theta) = of_theta {
            result.turn = Some(times(turned(self.end, theta), self.unit));
            // ∂θ'/∂θ is the turn of the step backwards.
            sums.theta = times(applied(matrix(self.end), theta), self.unit);
        }
        if N > 15 {
            sums.span = self.along_rates(&result, self.mean_turn, self.mean);
        }
        let fourth = result.scaled(self.step * WEIGHTS[3]);
        let third = self.back::<N>(3, &result, &fourth, &mut sums);
        let second = self.back::<N>(2, &result, &third, &mut sums);
        let first = self.back::<N>(1, &result, &second, &mut sums);
        self.back::<N>(0, &result, &first, &mut sums);
        sums
    }

    /// Back through stage `i`: from a covector of its rates to one of the rates of the stage before.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn back<const N: usize>(
        &self,
        i: usize,
        result: &Way<T>,
        rates: &Way<T>,
        sums: &mut Pulled<T>,
    ) -> Way<T> {
        let stage = &self.stages[i];
        let (mut of_moment, mut of_omega, mut of_turn) = (None, None, None);
        if let Some(of) = rates.turn {
            of_omega = Some(match i {
                0 => [of[1], of[2], of[3]],
                _ => between(stage.turn, of),
            });
            let [w, x, y, z] = turned(of, stage.half);
            let zero = w.constant(0.0);
            of_turn = Some([zero - w, zero - x, zero - y, zero - z]);
        }
        if let Some(of) = rates.omega {
            let of = self.tensor.inverse(of);
            let across = cross(of, stage.omega);
            let onto = match of_omega {
                Some(onto) => onto,
                None => [self.unit.constant(0.0); 3],
            };
            let mut through = (self.tensor).back(onto, stage.omega, stage.kept, of, across);
            if let Some(by_omega) = stage.moment.by_omega {
                through = plus(through, pulled(by_omega, of));
            }
            (of_omega, of_moment) = (Some(through), Some(of));
            if N > 6 {
                sums.torque = plus(sums.torque, of);
            }
            if N > 9 {
                sums.of_tensor(of, stage.acceleration);
                sums.of_tensor(across, stage.omega);
            }
        }
        if let Some(of) = of_omega {
            sums.omega = plus(sums.omega, of);
        }
        let stage_of = Way {
            turn: of_turn,
            omega: of_omega,
        };
        if i == 0 {
            return stage_of;
        }
        let before = &self.stages[i - 1];
        if N > 15 {
            let part = self.unit.constant(PARTS[i]);
            let moved = self.along_rates(&stage_of, before.turn_rate, before.acceleration);
            sums.span = sums.span.plus_product(moved, part);
            if let Some(of) = of_moment {
                let by_time = dot(of, stage.moment.by_time);
                sums.span = sums.span.plus_product(by_time, part);
            }
        }
        let onward = stage_of.scaled(self.step * PARTS[i]);
        onward.plus_times(result, self.step * WEIGHTS[i - 1])
    }

    #[inline(always)]
    fn along_rates(&self, of: &Way<T>, turn: Turn<T>, omega: Vector<T>) -> T {
        let zero = self.unit.constant(0.0);
        let by_turn = match of.turn {
            Some(of) => dot(of, turn),
            None => zero,
        };
        let by_omega = match of.omega {
            Some(of) => dot(of, omega),
            None => zero,
        };
        by_turn + by_turn + by_omega
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

    /// A covector of δI v on its way back to the entries of −δI.
    #[inline(always)]
    pub(super) fn of_tensor(&mut self, [a, b, c]: Vector<T>, [x, y, z]: Vector<T>) {
        let [xx, yy, zz, xy, xz, yz] = self.inertia;
        self.inertia = [
            xx.less_product(a, x),
            yy.less_product(b, y),
            zz.less_product(c, z),
            xy.less_product(a, y).less_product(b, x),
            xz.less_product(a, z).less_product(c, x),
            yz.less_product(b, z).less_product(c, y),
        ];
    }
}

impl<T: Arithmetic> Way<T> {
    #[inline(always)]
    fn scaled(mut self, factor: f64) -> Self {
        if let Some(of) = &mut self.turn {
            *of = times(*of, of[0].constant(factor));
        }
        if let Some(of) = &mut self.omega {
            *of = times(*of, of[0].constant(factor));
        }
        self
    }

    /// This way and `factor` times another; what is 0 in both stays unasked.
    #[inline(always)]
    fn plus_times(self, other: &Self, factor: f64) -> Self {
        Self {
            turn: sum(self.turn, other.turn, factor),
            omega: sum(self.omega, other.omega, factor),
        }
    }
}

/// a + b · factor.
#[inline(always)]
fn sum<T: Arithmetic, const N: usize>(
    a: Option<[T; N]>,
    b: Option<[T; N]>,
    factor: f64,
) -> Option<[T; N]> {
    match (a, b) {
        (Some(a), Some(b)) => Some(plus_times(a, b, b[0].constant(factor))),
        (None, Some(b)) => Some(times(b, b[0].constant(factor))),
        (a, None) => a,
    }
}
