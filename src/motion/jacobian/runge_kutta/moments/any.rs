//! The moments of a law of any kind, which alone is run on jets.

use super::super::algebra::{Turn, Vector, dot, plus, plus_times, splat, times};
use super::super::alone::firsts;
use super::{ByTurn, Moment, Moments, Place};
use crate::motion::registers::{Arithmetic, Registers};
use crate::motion::torque::SIDE;
use crate::motion::{Number, Quaternion, SmoothLaw, State, System};
use crate::scalar::Jet;
use nalgebra::Vector3;

/// The derivatives of a stage: of the moment in p, in v and in the logarithm of the length.
type Side = Jet<f64, SIDE>;

/// The moments of any law in one step of one body.
pub(in super::super) struct Any<'a, R, L> {
    pub(in super::super) registers: R,
    pub(in super::super) system: &'a System<f64, L>,
    /// At the start.
    pub(in super::super) attitude: Quaternion<f64>,
    pub(in super::super) time: f64,
    pub(in super::super) step: f64,
}

impl<R: Registers, L: SmoothLaw> Any<'_, R, L> {
    /// The attitude after a turn since the start: its derivative in the turn is the product with the attitude at the start.
    #[inline(always)]
    fn attitude(&self, turn: [f64; 4]) -> Quaternion<Side> {
        let [w, x, y, z] = self.attitude.components();
        let rows = [[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]];
        let mut components = [Side::of(0.0); 4];
        for (component, row) in components.iter_mut().zip(rows) {
            let [a, b, c, d] = row;
            let [s, i, j, k] = turn;
            *component = Jet {
                value: a * s + b * i + c * j + d * k,
                partials: [a, b, c, d, 0.0, 0.0, 0.0, 0.0],
            };
        }
        Quaternion::new(components)
    }

    /// The torque at a stage, M: its derivatives in p, in v and in ln h. Apart where no wide registers are to be had: in one
    /// piece with the step, it is what LLVM 22 breaks down at.
    #[cfg_attr(feature = "batch", inline(always))]
    #[cfg_attr(not(feature = "batch"), inline(never))]
    fn torque(&self, place: Place, turn: [f64; 4], velocity: [f64; 3]) -> Vector3<Side> {
        let (pace, since) = (2.0 / self.step, place.since(self.step));
        let mut omega = [Side::of(0.0); 3];
        for (i, omega) in omega.iter_mut().enumerate() {
            omega.value = velocity[i] * pace;
            omega.partials[4 + i] = pace;
            // ω = 2 v/h.
            omega.partials[7] = -omega.value;
        }
        let state = State {
            attitude: self.attitude(turn),
            angular_velocity: omega.into(),
        };
        let mut time = Side::of(self.time + since);
        time.partials[7] = since;
        self.system.torque_over(time, &state)
    }
}

/// Rows of half the derivative.
#[derive(Clone, Copy)]
pub(in super::super) struct Rows<T>([Turn<T>; 3]);

impl<T: Arithmetic> ByTurn<T> for Rows<T> {
    const IS_ANY: bool = true;

    #[inline(always)]
    fn along(&self, onto: Vector<T>, turn: Turn<T>) -> Vector<T> {
        let [a, b, c] = self.0;
        let half = [dot(a, turn), dot(b, turn), dot(c, turn)];
        plus_times(onto, half, turn[0].constant(2.0))
    }

    #[inline(always)]
    fn back(&self, [x, y, z]: Vector<T>) -> Option<Turn<T>> {
        let [a, b, c] = self.0;
        Some(plus_times(plus_times(times(a, x), b, y), c, z))
    }
}

impl<R: Registers, L: SmoothLaw> Moments<R::Wide> for Any<'_, R, L> {
    type ByTurn = Rows<R::Wide>;

    #[inline(always)]
    fn at(
        &self,
        place: Place,
        turn: Option<Turn<R::Wide>>,
        velocity: Vector<R::Wide>,
    ) -> Moment<R::Wide, Rows<R::Wide>> {
        let registers = self.registers;
        let turn = match turn {
            Some(turn) => firsts(registers, turn),
            None => [1.0, 0.0, 0.0, 0.0],
        };
        let torque = self.torque(place, turn, firsts(registers, velocity));
        let scale = 0.25 * self.step * self.step;
        let mut value = [0.0; 3];
        let mut rows = [[0.0; SIDE]; 3];
        for i in 0..3 {
            value[i] = torque[i].value * scale;
            for (slope, partial) in rows[i].iter_mut().zip(torque[i].partials) {
                *slope = partial * scale;
            }
        }
        let zero = registers.splat(0.0);
        let (mut by_turn, mut by_velocity, mut by_length) =
            ([[zero; 4]; 3], [[zero; 3]; 3], [zero; 3]);
        for i in 0..3 {
            let [a, b, c, d, x, y, z, length] = rows[i];
            by_turn[i] = splat(registers, [a, b, c, d].map(|half| 0.5 * half));
            by_velocity[i] = splat(registers, [x, y, z]);
            by_length[i] = registers.splat(length);
        }
        let value = splat(registers, value);
        Moment {
            value,
            by_velocity: Some(by_velocity),
            by_turn: Rows(by_turn),
            by_length: plus(plus(value, value), by_length),
        }
    }
}
