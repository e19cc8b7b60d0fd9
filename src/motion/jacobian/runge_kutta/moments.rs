//! The moment at the stages of a step with its derivatives, by as much as is known of the law.
//!
//! In half steps, as the stages: the moment is M h²/4, a function of v = ω h/2, of the turn p since the start of the step and of
//! its length h. A law that is linear in ω and in a vector that stands in space is written out; any other is run on jets, and
//! nothing but the law.

mod any;
mod linear;

pub(super) use any::Any;
pub(super) use linear::{Linear, Parts, Seen, parts};

use super::algebra::{Turn, Vector, applied, plus, plus_times};
use crate::motion::registers::Arithmetic;

/// Where in the step a stage stands.
#[derive(Clone, Copy)]
pub(super) enum Place {
    Start,
    Middle,
    End,
}

impl Place {
    /// The time since the start, in half steps.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(super) fn half_steps(self) -> f64 {
        f64::from(self as u8)
    }

    /// The time since the start of a step of a given length.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn since(self, step: f64) -> f64 {
        0.5 * self.half_steps() * step
    }
}

/// The moment at a stage and its derivatives.
#[derive(Clone, Copy)]
pub(super) struct Moment<T, D> {
    pub(super) value: Vector<T>,
    /// Row: component of the moment; column: component of v. `None` for zeros.
    pub(super) by_velocity: Option<[Vector<T>; 3]>,
    pub(super) by_turn: D,
    /// In the logarithm of the length of the step, v and p held.
    pub(super) by_length: Vector<T>,
}

/// The change of what a moment is a function of, with a direction of the input; what is `None` is 0.
#[derive(Clone, Copy)]
pub(super) struct Shift<T> {
    pub(super) turn: Option<Turn<T>>,
    pub(super) velocity: Vector<T>,
    /// Of the logarithm of the length.
    pub(super) span: Option<T>,
    /// Of the torque added to the law, in the axes of the stage.
    pub(super) torque: Vector<T>,
}

impl<T: Arithmetic, D: ByTurn<T>> Moment<T, D> {
    /// Its change with that of what it is a function of.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(&self, shift: &Shift<T>) -> Vector<T> {
        let mut change = shift.torque;
        if let Some(span) = shift.span {
            change = plus_times(change, self.by_length, span);
        }
        if let Some(by_velocity) = self.by_velocity {
            change = plus(change, applied(by_velocity, shift.velocity));
        }
        match shift.turn {
            Some(turn) => self.by_turn.along(change, turn),
            None => change,
        }
    }
}

/// Half of the derivative of a moment in the turn p, whose four components vary freely.
pub(super) trait ByTurn<T>: Copy {
    /// Whether there can be any.
    const IS_ANY: bool;

    /// `onto`, and the change of the moment with one of the turn.
    fn along(&self, onto: Vector<T>, turn: Turn<T>) -> Vector<T>;

    /// A covector of the moment as half of one of the turn, `None` for zeros.
    fn back(&self, moment: Vector<T>) -> Option<Turn<T>>;
}

/// What gives the moments of a step.
pub(super) trait Moments<T: Arithmetic> {
    type ByTurn: ByTurn<T>;

    /// The moment at a stage, of no turn where there is `None`.
    fn at(
        &self,
        place: Place,
        turn: Option<Turn<T>>,
        velocity: Vector<T>,
    ) -> Moment<T, Self::ByTurn>;

    /// The moment at a stage, and its change in one direction alone.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(
        &self,
        place: Place,
        turn: Option<Turn<T>>,
        velocity: Vector<T>,
        shift: &Shift<T>,
    ) -> (Vector<T>, Vector<T>) {
        let moment = self.at(place, turn, velocity);
        (moment.value, moment.along(shift))
    }
}

/// The length of a step as a divisor: a step of no length is to rounding a very short one.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(super) fn some_length(step: f64) -> f64 {
    if step == 0.0 { 1e-100 } else { step }
}
