//! Products of the Jacobian with one vector, from either side, without the matrix.

use super::{Back, PARTS, Stage, WEIGHTS};
use crate::mechanics::{apply, regressor};
use crate::motion::Quaternion;
use nalgebra::{SVector, Vector3, Vector6};

impl Back<'_> {
    /// The Jacobian times a direction of the input (θ, ω, torque, inertia, dt): forward through the stages.
    #[inline(always)]
    pub(super) fn along(&self, direction: &SVector<f64, 16>) -> Vector6<f64> {
        let part = |first: usize| direction.fixed_rows::<3>(first).into_owned();
        let (theta, start, torque, span) = (part(0), part(3), part(6), direction[15]);
        let inertia = direction.fixed_rows::<6>(9).into_owned();
        let none = Quaternion::identity() * 0.0;
        let (mut acceleration, mut turn_rate) = (Vector3::zeros(), none);
        let (mut sum, mut turns) = (acceleration, none);
        for (i, stage) in self.stages.iter().enumerate() {
            let (mut omega, mut turn) = (start, none);
            if i > 0 {
                let before = &self.stages[i - 1];
                let part = PARTS[i] * self.step;
                omega += acceleration * part + before.acceleration * (PARTS[i] * span);
                turn = turn_rate * part + before.turn_rate * (PARTS[i] * span);
            }
            let moment = stage.slope * omega + torque + stage.by_time * (PARTS[i] * span)
                - regressor(&stage.omega, &stage.acceleration) * inertia;
            acceleration = apply(self.inverse, &moment);
            turn_rate = turn.rate(&stage.omega) + stage.turn.rate(&omega);
            sum += acceleration * WEIGHTS[i];
            turns = turns + turn_rate * WEIGHTS[i];
        }
        let (unit, mean) = (1.0 / self.end.norm_squared(), self.mean_acceleration());
        let moved = turns * self.step + self.mean * span;
        let turned = (self.end.conjugate() * moved).v * (2.0 * unit);
        let theta = self.end.normalised().to_body(&theta) + turned;
        let omega = start + sum * self.step + mean * span;
        Vector6::new(theta.x, theta.y, theta.z, omega.x, omega.y, omega.z)
    }

    /// A covector of the result (θ', ω') times the Jacobian: backward through the stages, one row.
    #[inline(always)]
    pub(super) fn pulled_back(&self, covector: &Vector6<f64>) -> SVector<f64, 16> {
        let unit = 1.0 / self.end.norm_squared();
        let of_theta = covector.fixed_rows::<3>(0).into_owned();
        let of_end = covector.fixed_rows::<3>(3).into_owned();
        let turned = Quaternion {
            w: 0.0,
            v: of_theta * unit,
        };
        let (mut omega, mut torque, mut inertia) = (of_end, Vector3::zeros(), Vector6::zeros());
        let mut span = (self.end.conjugate() * self.mean).v.dot(&of_theta) * (2.0 * unit)
            + self.mean_acceleration().dot(&of_end);
        let mut chain = Quaternion::identity() * (self.step * WEIGHTS[3]);
        let mut of_acceleration = of_end * (self.step * WEIGHTS[3]);
        for i in (0..4).rev() {
            let stage = &self.stages[i];
            let of_moment = self.inverse.tr_mul(&of_acceleration);
            let direct = stage.turn.conjugate() * self.end * turned * chain;
            let of_omega = stage.slope.tr_mul(&of_moment) + direct.v;
            omega += of_omega;
            torque += of_moment;
            inertia -= regressor(&stage.omega, &stage.acceleration).tr_mul(&of_moment);
            if i == 0 {
                break;
            }
            let of_turn = chain * pure(stage) * -0.5;
            let before = &self.stages[i - 1];
            let back = (self.end.conjugate() * before.turn_rate * of_turn.conjugate()).v;
            span += PARTS[i]
                * (back.dot(&of_theta) * (2.0 * unit)
                    + of_omega.dot(&before.acceleration)
                    + of_moment.dot(&stage.by_time));
            let part = self.step * PARTS[i];
            chain = Quaternion::identity() * (self.step * WEIGHTS[i - 1]) + of_turn * part;
            of_acceleration = of_end * (self.step * WEIGHTS[i - 1]) + of_omega * part;
        }
        let mut result = SVector::<f64, 16>::zeros();
        let theta = self.end.normalised().to_space(&of_theta);
        result.fixed_rows_mut::<3>(0).copy_from(&theta);
        result.fixed_rows_mut::<3>(3).copy_from(&omega);
        result.fixed_rows_mut::<3>(6).copy_from(&torque);
        result.fixed_rows_mut::<6>(9).copy_from(&inertia);
        result[15] = span;
        result
    }
}

/// The angular velocity of a stage as a quaternion.
fn pure(stage: &Stage) -> Quaternion<f64> {
    Quaternion {
        w: 0.0,
        v: stage.omega,
    }
}
