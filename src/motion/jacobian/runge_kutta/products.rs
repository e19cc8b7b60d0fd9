//! Products of the Jacobian with one vector, from either side, without the matrix.

use super::algebra::{Tensor, Turn, Vector, applied, between, matrix, plus, pulled, times, turned};
use super::rows::{end, full, principal, stages};
use super::stages::{PARTS, Stages, mean};
use crate::motion::{State, System, TorqueLaw};
use nalgebra::{SVector, Vector6};

/// The step and its Jacobian times a direction of the input, or `None` if the law gives a torque that depends on the
/// attitude.
#[inline(always)]
pub(crate) fn jvp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    direction: &SVector<f64, 16>,
) -> Option<(State<f64>, Vector6<f64>)> {
    if system.is_principal() {
        let stages = stages(principal(system), system, time, state, step)?;
        Some((end(&stages, state), stages.along(&direction.data.0[0])))
    } else {
        let stages = stages(full(system), system, time, state, step)?;
        Some((end(&stages, state), stages.along(&direction.data.0[0])))
    }
}

/// The step and a covector of its result times the Jacobian, or `None` if the law gives a torque that depends on the
/// attitude.
#[inline(always)]
pub(crate) fn vjp<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    state: &State<f64>,
    step: f64,
    covector: &Vector6<f64>,
) -> Option<(State<f64>, SVector<f64, 16>)> {
    if system.is_principal() {
        let stages = stages(principal(system), system, time, state, step)?;
        Some((end(&stages, state), stages.gradient(&covector.data.0[0])))
    } else {
        let stages = stages(full(system), system, time, state, step)?;
        Some((end(&stages, state), stages.gradient(&covector.data.0[0])))
    }
}

impl<I: Tensor<f64>> Stages<f64, I> {
    /// The Jacobian times a direction of the input (θ, ω, torque, inertia, dt): forward through the stages.
    #[inline(always)]
    fn along(&self, direction: &[f64; 16]) -> Vector6<f64> {
        let [a, b, c, omega @ .., dt] = direction;
        let [p, q, r, torque @ ..] = omega;
        let [x, y, z, inertia @ ..] = torque;
        let (start, torque, span) = ([*p, *q, *r], [*x, *y, *z], *dt);
        let none: Turn<f64> = [0.0; 4];
        let (mut acceleration, mut turn_rate) = ([0.0; 3], none);
        let (mut accelerations, mut turn_rates) = ([acceleration; 4], [none; 4]);
        for (i, stage) in self.stages.iter().enumerate() {
            let (mut omega, mut turn) = (start, none);
            if i > 0 {
                let (before, part) = (&self.stages[i - 1], PARTS[i] * self.step);
                let longer = PARTS[i] * span;
                omega = plus(omega, times(acceleration, part));
                omega = plus(omega, times(before.acceleration, longer));
                turn = plus(times(turn_rate, part), times(before.turn_rate, longer));
            }
            let mut moment = plus(torque, stage.by_inertia.along(*inertia));
            moment = plus(moment, times(stage.by_time, PARTS[i] * span));
            moment = plus(moment, applied(stage.slope, omega));
            acceleration = self.tensor.inverse(moment);
            turn_rate = plus(
                turned(turn, stage.half),
                turned(stage.turn, times(omega, 0.5)),
            );
            (accelerations[i], turn_rates[i]) = (acceleration, turn_rate);
        }
        let moved = plus(
            times(mean(turn_rates), self.step),
            times(self.mean_turn, span),
        );
        let turned = times(between(self.end, moved), 2.0 * self.unit);
        let [theta_x, theta_y, theta_z] = plus(self.theta_after([*a, *b, *c]), turned);
        let gained = plus(
            times(mean(accelerations), self.step),
            times(self.mean, span),
        );
        let [x, y, z] = plus(start, gained);
        Vector6::new(theta_x, theta_y, theta_z, x, y, z)
    }

    /// ∂θ'/∂θ is the turn of the step backwards.
    #[inline(always)]
    fn theta_after(&self, theta: Vector<f64>) -> Vector<f64> {
        times(pulled(matrix(self.end), theta), self.unit)
    }

    /// A covector of the result (θ', ω') times the Jacobian: backward through the stages.
    #[inline(always)]
    fn gradient(&self, covector: &[f64; 6]) -> SVector<f64, 16> {
        let [a, b, c, x, y, z] = *covector;
        let pulled = self.pulled_back::<16>(Some([a, b, c]), Some([x, y, z]));
        let theta = times(applied(matrix(self.end), [a, b, c]), self.unit);
        let ([a, b, c], [d, e, f], [g, h, i]) = (theta, pulled.omega, pulled.torque);
        let [j, k, l, m, n, o] = pulled.inertia;
        [a, b, c, d, e, f, g, h, i, j, k, l, m, n, o, pulled.span].into()
    }
}
