//! The stages of a step, forward, and a covector of the result on its way back through them.

use super::algebra::{
    Tensor, Turn, Vector, applied, between, dot, plus, pulled, splat, splat_rows, times, turned,
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

/// What a stage leaves behind for the way back.
#[derive(Clone, Copy)]
pub(super) struct Stage<T> {
    /// ω/2.
    pub(super) half: Vector<T>,
    pub(super) acceleration: Vector<T>,
    /// The derivative of the net moment in ω, row by component of the moment.
    pub(super) slope: [Vector<T>; 3],
    /// The torque's own rate in time.
    pub(super) by_time: Vector<T>,
    pub(super) by_inertia: ByInertia<T>,
    /// Attitude since the start of the step, and its rate ½ p ω.
    pub(super) turn: Turn<T>,
    pub(super) turn_rate: Turn<T>,
}

/// The derivative of the net moment in the tensor, −(δI α + ω × δI ω), which is minus the
/// [`regressor()`](crate::mechanics::regressor()).
#[derive(Clone, Copy)]
pub(super) struct ByInertia<T> {
    /// −α.
    pub(super) against: Vector<T>,
    /// ω_y ω_z and cyclic.
    pub(super) products: Vector<T>,
    /// The columns of xy, xz and yz.
    pub(super) off: [Vector<T>; 3],
}

impl<T: Arithmetic> ByInertia<T> {
    #[inline(always)]
    fn new([x, y, z]: Vector<T>, [a, b, c]: Vector<T>) -> Self {
        let zero = x.constant(0.0);
        let [yz, zx, xy] = [y * z, z * x, x * y];
        let [xx, yy, zz] = [x * x, y * y, z * z];
        let against = [zero - a, zero - b, zero - c];
        Self {
            against,
            products: [yz, zx, xy],
            off: [
                [zx - b, against[0] - yz, yy - xx],
                [against[2] - xy, xx - zz, yz - a],
                [zz - yy, xy - c, against[1] - zx],
            ],
        }
    }

    /// A covector of the moment times it.
    #[inline(always)]
    fn pulled_back(&self, [x, y, z]: Vector<T>) -> [T; 6] {
        let ([a, b, c], [yz, zx, xy]) = (self.against, self.products);
        let [p, q, r] = [yz * x, zx * y, xy * z];
        let [d, e, f] = applied(self.off, [x, y, z]);
        [a * x + (r - q), b * y + (p - r), c * z + (q - p), d, e, f]
    }

    /// The moment of a change of the tensor.
    #[inline(always)]
    pub(super) fn along(&self, [xx, yy, zz, xy, xz, yz]: [T; 6]) -> Vector<T> {
        let ([a, b, c], [p, q, r]) = (self.against, self.products);
        let [d, e, f] = pulled(self.off, [xy, xz, yz]);
        [
            a * xx + p * (yy - zz) + d,
            b * yy + q * (zz - xx) + e,
            c * zz + r * (xx - yy) + f,
        ]
    }
}

impl<T: Arithmetic> Stage<T> {
    /// The stage of an angular velocity and of the attitude since the start, `None` for no turn.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(
        tensor: &impl Tensor<T>,
        moment: &Moment<T>,
        omega: Vector<T>,
        turn: Option<Turn<T>>,
    ) -> Self {
        let mut net = plus(moment.at_rest, tensor.gyroscopic(omega));
        let mut slope = tensor.slope(omega);
        if let Some(by_omega) = moment.by_omega {
            net = plus(net, applied(by_omega, omega));
            for r in 0..3 {
                slope[r] = plus(slope[r], by_omega[r]);
            }
        }
        let acceleration = tensor.inverse(net);
        let half = times(omega, omega[0].constant(0.5));
        let (zero, one) = (omega[0].constant(0.0), omega[0].constant(1.0));
        Self {
            acceleration,
            slope,
            by_time: moment.by_time,
            by_inertia: ByInertia::new(omega, acceleration),
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
    fn after(
        &self,
        tensor: &impl Tensor<T>,
        moment: &Moment<T>,
        start: Vector<T>,
        span: f64,
    ) -> Self {
        let span = start[0].constant(span);
        let omega = plus(start, times(self.acceleration, span));
        let [w, x, y, z] = times(self.turn_rate, span);
        Self::new(tensor, moment, omega, Some([w + w.constant(1.0), x, y, z]))
    }
}

#[derive(Clone, Copy)]
pub(super) struct Stages<T, I> {
    pub(super) tensor: I,
    pub(super) step: f64,
    pub(super) stages: [Stage<T>; 4],
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
        let stages = [first, second, third, fourth];
        let [a, b, c, d] = &stages;
        let mean_turn = mean([a.turn_rate, b.turn_rate, c.turn_rate, d.turn_rate]);
        let accelerations = [
            a.acceleration,
            b.acceleration,
            c.acceleration,
            d.acceleration,
        ];
        let [w, x, y, z] = times(mean_turn, start[0].constant(step));
        let one = w.constant(1.0);
        let end = [one + w, x, y, z];
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
        let turned = turned([w, a, b, c], [x, y, z]);
        let whole = plus(turned, times([w, a, b, c], s));
        let size = w.constant(1.0) / dot(whole, whole).root();
        let gained = times(self.mean, w.constant(self.step));
        (times(whole, size), plus(omega, gained))
    }
}

/// The mean of the stages by their weights.
#[inline(always)]
pub(super) fn mean<T: Arithmetic, const N: usize>([a, b, c, d]: [[T; N]; 4]) -> [T; N] {
    let inner = plus(b, c);
    let sum = plus(plus(a, plus(inner, inner)), d);
    times(sum, sum[0].constant(1.0 / 6.0))
}

/// A covector of the result times the Jacobian: what stands in the columns after those of θ.
#[derive(Clone, Copy)]
pub(super) struct Pulled<T> {
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
        let mut result = Way {
            turn: None,
            omega: of_omega,
        };
        if let Some(theta) = of_theta {
            result.turn = Some(times(turned(self.end, theta), self.unit));
        }
        let mut sums = Pulled {
            omega: match of_omega {
                Some(omega) => omega,
                None => [zero; 3],
            },
            torque: [zero; 3],
            inertia: [zero; 6],
            span: zero,
        };
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
            of_moment = Some(of);
            of_omega = sum(Some(pulled(stage.slope, of)), of_omega);
        }
        if let Some(of) = of_omega {
            sums.omega = plus(sums.omega, of);
        }
        if let (true, Some(of)) = (N > 6, of_moment) {
            sums.torque = plus(sums.torque, of);
        }
        if let (true, Some(of)) = (N > 9, of_moment) {
            sums.inertia = plus(sums.inertia, stage.by_inertia.pulled_back(of));
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
            sums.span = sums.span + moved * part;
            if let Some(of) = of_moment {
                sums.span = sums.span + dot(of, stage.by_time) * part;
            }
        }
        let direct = result.scaled(self.step * WEIGHTS[i - 1]);
        let onward = stage_of.scaled(self.step * PARTS[i]);
        Way {
            turn: sum(direct.turn, onward.turn),
            omega: sum(direct.omega, onward.omega),
        }
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
}

#[inline(always)]
fn sum<T: Arithmetic, const N: usize>(a: Option<[T; N]>, b: Option<[T; N]>) -> Option<[T; N]> {
    match (a, b) {
        (Some(a), Some(b)) => Some(plus(a, b)),
        (None, only) | (only, None) => only,
    }
}
