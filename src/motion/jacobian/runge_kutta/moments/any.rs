//! The moments of a law of any kind, which alone is run on jets.

use super::super::algebra::{Turn, Vector, dot, plus, plus_times, splat, times};
use super::super::alone::firsts;
use super::{ByTurn, Moment, Moments, Place, Shift};
use crate::motion::registers::{Arithmetic, Registers};
use crate::motion::torque::SIDE;
use crate::motion::{Number, Quaternion, SmoothLaw, State, System};
use crate::scalar::Jet;
use nalgebra::Vector3;

/// The derivatives of a stage: of the moment in p, in v and in the logarithm of the length.
type Side = Jet<f64, SIDE>;

/// The derivative of a stage in one direction.
type Along = Jet<f64, 1>;

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
    /// The four rows of the product of the attitude at the start and a turn since then.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn attitude_of_turn(&self) -> [[f64; 4]; 4] {
        let [w, x, y, z] = self.attitude.components();
        [[w, -x, -y, -z], [x, w, -z, y], [y, z, w, -x], [z, -y, x, w]]
    }

    /// The torque at a stage, M: its derivatives in p, in v and in ln h. Apart where no wide registers are to be had: in one
    /// piece with the step, it is what LLVM 22 breaks down at.
    #[cfg_attr(all(feature = "batch", not(debug_assertions)), inline(always))]
    #[cfg_attr(not(feature = "batch"), inline(never))]
    fn torque(&self, place: Place, turn: [f64; 4], velocity: [f64; 3]) -> Vector3<Side> {
        let (pace, since) = (2.0 / self.step, place.since(self.step));
        let (mut attitude, mut omega) = ([Side::of(0.0); 4], [Side::of(0.0); 3]);
        for (component, row) in attitude.iter_mut().zip(self.attitude_of_turn()) {
            component.value = dot(row, turn);
            component.partials[..4].copy_from_slice(&row);
        }
        for (i, omega) in omega.iter_mut().enumerate() {
            omega.value = velocity[i] * pace;
            omega.partials[4 + i] = pace;
            // ω = 2 v/h.
            omega.partials[7] = -omega.value;
        }
        let mut time = Side::of(self.time + since);
        time.partials[7] = since;
        self.system.torque_over(time, &state(attitude, omega))
    }

    /// The torque at a stage and its change with those of p, of v and of ln h.
    #[cfg_attr(all(feature = "batch", not(debug_assertions)), inline(always))]
    #[cfg_attr(not(feature = "batch"), inline(never))]
    fn torque_along(
        &self,
        place: Place,
        (turn, velocity): ([f64; 4], [f64; 3]),
        (turned, faster, longer): ([f64; 4], [f64; 3], f64),
    ) -> Vector3<Along> {
        let (pace, since) = (2.0 / self.step, place.since(self.step));
        let (mut attitude, mut omega) = ([Along::of(0.0); 4], [Along::of(0.0); 3]);
        for (component, row) in attitude.iter_mut().zip(self.attitude_of_turn()) {
            *component = Along::moving(dot(row, turn), dot(row, turned));
        }
        for (i, omega) in omega.iter_mut().enumerate() {
            let change = faster[i] - velocity[i] * longer;
            *omega = Along::moving(velocity[i] * pace, change * pace);
        }
        let time = Along::moving(self.time + since, since * longer);
        self.system.torque_over(time, &state(attitude, omega))
    }
}

#[cfg_attr(not(debug_assertions), inline(always))]
fn state<T: Number>(attitude: [T; 4], angular_velocity: [T; 3]) -> State<T> {
    State {
        attitude: Quaternion::new(attitude),
        angular_velocity: angular_velocity.into(),
    }
}

/// The components of a turn since the start, where `None` is none.
#[cfg_attr(not(debug_assertions), inline(always))]
fn components<R: Registers>(registers: R, turn: Option<Turn<R::Wide>>) -> [f64; 4] {
    match turn {
        Some(turn) => firsts(registers, turn),
        None => [1.0, 0.0, 0.0, 0.0],
    }
}

/// Rows of half the derivative.
#[derive(Clone, Copy)]
pub(in super::super) struct Rows<T>([Turn<T>; 3]);

impl<T: Arithmetic> ByTurn<T> for Rows<T> {
    const IS_ANY: bool = true;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(&self, onto: Vector<T>, turn: Turn<T>) -> Vector<T> {
        let [a, b, c] = self.0;
        let half = [dot(a, turn), dot(b, turn), dot(c, turn)];
        plus_times(onto, half, turn[0].constant(2.0))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn back(&self, [x, y, z]: Vector<T>) -> Option<Turn<T>> {
        let [a, b, c] = self.0;
        Some(plus_times(plus_times(times(a, x), b, y), c, z))
    }
}

impl<R: Registers, L: SmoothLaw> Moments<R::Wide> for Any<'_, R, L> {
    type ByTurn = Rows<R::Wide>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at(
        &self,
        place: Place,
        turn: Option<Turn<R::Wide>>,
        velocity: Vector<R::Wide>,
    ) -> Moment<R::Wide, Rows<R::Wide>> {
        let registers = self.registers;
        let turn = components(registers, turn);
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

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(
        &self,
        place: Place,
        turn: Option<Turn<R::Wide>>,
        velocity: Vector<R::Wide>,
        shift: &Shift<R::Wide>,
    ) -> (Vector<R::Wide>, Vector<R::Wide>) {
        let registers = self.registers;
        let at = (components(registers, turn), firsts(registers, velocity));
        let mut direction = ([0.0; 4], firsts(registers, shift.velocity), 0.0);
        if let Some(turn) = shift.turn {
            direction.0 = firsts(registers, turn);
        }
        if let Some(span) = shift.span {
            direction.2 = registers.first(span);
        }
        let torque = self.torque_along(place, at, direction);
        let scale = 0.25 * self.step * self.step;
        let (mut value, mut change) = ([0.0; 3], [0.0; 3]);
        for i in 0..3 {
            value[i] = torque[i].value * scale;
            change[i] = torque[i].partials[0] * scale;
        }
        let (value, mut change) = (
            splat(registers, value),
            plus(splat(registers, change), shift.torque),
        );
        if let Some(span) = shift.span {
            // The moment grows as the square of the length besides.
            change = plus_times(change, plus(value, value), span);
        }
        (value, change)
    }
}
