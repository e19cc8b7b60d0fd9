//! The moments of laws that are linear in ω and in a vector that stands in space.

use super::super::algebra::{
    Turn, Vector, applied, between, cross, minus, plus, plus_times, pulled, splat, splat_rows,
    turned, turning,
};
use super::{ByTurn, Moment, Moments, Place};
use crate::motion::registers::{Arithmetic, Registers};
use crate::motion::{Frame, LinearTorque, SpaceLoad, System, TorqueLaw};
use nalgebra::Vector3;

/// Moments that do not look at the attitude: at the start, in the middle and at the end.
#[derive(Clone, Copy)]
pub(in super::super) struct Linear<T>([Own<T>; 3]);

#[derive(Clone, Copy)]
struct Own<T> {
    at_rest: Vector<T>,
    by_velocity: Option<[Vector<T>; 3]>,
    by_length: Vector<T>,
}

/// Moments with a torque or a force that stands in space, in the axes of the body at the start of the step and
/// negative, as its derivatives take it.
#[derive(Clone, Copy)]
pub(in super::super) struct Seen<T> {
    own: Linear<T>,
    loads: [Load<T>; 3],
    arm: Option<Vector<T>>,
}

#[derive(Clone, Copy)]
struct Load<T> {
    value: Vector<T>,
    by_length: Vector<T>,
}

/// What a law gives in a step, vectors of space in space axes.
pub(in super::super) enum Parts {
    Linear(Linear<f64>),
    Seen(Seen<f64>),
}

/// The parts of a law in a step, with the torque added to it; `None` if it has none that do.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in super::super) fn parts<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    time: f64,
    step: f64,
) -> Option<Parts> {
    let (middle, end) = (Place::Middle.since(step), Place::End.since(step));
    let [a, b, c] = system.law().linear_at([time, time + middle, time + end])?;
    let (a, b, c) = (part(system, a)?, part(system, b)?, part(system, c)?);
    let own = Linear([
        Own::new(&a, Place::Start, step),
        Own::new(&b, Place::Middle, step),
        Own::new(&c, Place::End, step),
    ]);
    match (a.load, b.load, c.load) {
        (None, None, None) => Some(Parts::Linear(own)),
        (Some(a), Some(b), Some(c)) if a.arm == b.arm && b.arm == c.arm => {
            Some(Parts::Seen(Seen {
                own,
                loads: [
                    Load::new(&a, Place::Start, step),
                    Load::new(&b, Place::Middle, step),
                    Load::new(&c, Place::End, step),
                ],
                arm: a.arm.map(Into::into),
            }))
        }
        _ => None,
    }
}

/// The torque of a law and the one added to it; `None` if a torque and a force stand in space.
#[cfg_attr(not(debug_assertions), inline(always))]
fn part<L: TorqueLaw<f64>>(
    system: &System<f64, L>,
    mut part: LinearTorque,
) -> Option<LinearTorque> {
    let added = system.added();
    match (system.law().added_in(), &mut part.load) {
        (Frame::Body, _) => part.at_rest += added,
        (Frame::Space, Some(load)) if load.arm.is_none() => load.value += added,
        (Frame::Space, None) => {
            part.load = Some(SpaceLoad {
                value: *added,
                by_time: Vector3::zeros(),
                arm: None,
            });
        }
        (Frame::Space, Some(_)) if *added == Vector3::zeros() => {}
        (Frame::Space, Some(_)) => return None,
    }
    Some(part)
}

impl Place {
    /// The derivative of h² times a value in the logarithm of the length h, over h².
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn by_length(self, value: Vector3<f64>, by_time: Vector3<f64>, step: f64) -> Vector3<f64> {
        match self {
            // What stands at the start stays there, and nobody need know its derivative.
            Self::Start => value * 2.0,
            Self::Middle | Self::End => value * 2.0 + by_time * self.since(step),
        }
    }
}

impl Own<f64> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(part: &LinearTorque, place: Place, step: f64) -> Self {
        let scale = 0.25 * step * step;
        let by_length = place.by_length(part.at_rest, part.by_time, step);
        let mut by_velocity = None;
        if let Some(matrix) = part.by_angular_velocity {
            by_velocity = Some((matrix.transpose() * (0.5 * step)).data.0);
        }
        Self {
            at_rest: (part.at_rest * scale).into(),
            by_velocity,
            by_length: (by_length * scale).into(),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn splat<R: Registers>(&self, registers: R) -> Own<R::Wide> {
        let mut by_velocity = None;
        if let Some(rows) = self.by_velocity {
            by_velocity = Some(splat_rows(registers, rows));
        }
        Own {
            at_rest: splat(registers, self.at_rest),
            by_velocity,
            by_length: splat(registers, self.by_length),
        }
    }
}

impl Load<f64> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn new(load: &SpaceLoad, place: Place, step: f64) -> Self {
        let scale = -0.25 * step * step;
        let by_length = place.by_length(load.value, load.by_time, step);
        Self {
            value: (load.value * scale).into(),
            by_length: (by_length * scale).into(),
        }
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn splat<R: Registers>(&self, registers: R) -> Load<R::Wide> {
        Load {
            value: splat(registers, self.value),
            by_length: splat(registers, self.by_length),
        }
    }
}

impl<T: Arithmetic> Load<T> {
    /// As a body sees it at the start of its step.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn seen(&self, axes: [Vector<T>; 3]) -> Self {
        Self {
            value: pulled(axes, self.value),
            by_length: pulled(axes, self.by_length),
        }
    }
}

impl Linear<f64> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(in super::super) fn splat<R: Registers>(&self, registers: R) -> Linear<R::Wide> {
        let [a, b, c] = &self.0;
        Linear([a.splat(registers), b.splat(registers), c.splat(registers)])
    }
}

impl Seen<f64> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(in super::super) fn splat<R: Registers>(&self, registers: R) -> Seen<R::Wide> {
        let [a, b, c] = &self.loads;
        let mut arm = None;
        if let Some(own) = self.arm {
            arm = Some(splat(registers, own));
        }
        Seen {
            own: self.own.splat(registers),
            loads: [a.splat(registers), b.splat(registers), c.splat(registers)],
            arm,
        }
    }
}

impl<T: Arithmetic> Seen<T> {
    /// The loads as a body sees them at the start of its step, by the matrix of its attitude.
    #[cfg_attr(not(debug_assertions), inline(always))]
    pub(in super::super) fn from(&self, axes: [Vector<T>; 3]) -> Self {
        let [a, b, c] = &self.loads;
        Self {
            loads: [a.seen(axes), b.seen(axes), c.seen(axes)],
            ..*self
        }
    }
}

/// That the attitude is not looked at.
#[derive(Clone, Copy)]
pub(in super::super) struct Nothing;

impl<T> ByTurn<T> for Nothing {
    const IS_ANY: bool = false;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(&self, onto: Vector<T>, _: Turn<T>) -> Vector<T> {
        onto
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn back(&self, _: Vector<T>) -> Option<Turn<T>> {
        None
    }
}

impl<T: Arithmetic> Moments<T> for Linear<T> {
    type ByTurn = Nothing;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at(&self, place: Place, _: Option<Turn<T>>, velocity: Vector<T>) -> Moment<T, Nothing> {
        let own = &self.0[place as usize];
        let (mut value, mut by_length) = (own.at_rest, own.by_length);
        if let Some(by_velocity) = own.by_velocity {
            let moment = applied(by_velocity, velocity);
            (value, by_length) = (plus(value, moment), plus(by_length, moment));
        }
        Moment {
            value,
            by_velocity: own.by_velocity,
            by_turn: Nothing,
            by_length,
        }
    }
}

/// How a body sees a vector γ of space: −γ p of the turn p, and where it acts.
#[derive(Clone, Copy)]
pub(in super::super) struct Sight<T> {
    product: Turn<T>,
    arm: Option<Vector<T>>,
}

impl<T: Arithmetic> Sight<T> {
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn of(load: Vector<T>, arm: Option<Vector<T>>, turn: Option<Turn<T>>) -> Self {
        let [x, y, z] = load;
        Self {
            product: match turn {
                Some(turn) => turning(load, turn),
                None => [x.constant(0.0), x, y, z],
            },
            arm,
        }
    }

    /// `onto` and the moment of p⁻¹ γ p.
    #[cfg_attr(not(debug_assertions), inline(always))]
    fn moment(&self, onto: Vector<T>, turn: Option<Turn<T>>) -> Vector<T> {
        let seen = match (turn, self.product) {
            (Some(turn), product) => between(turn, product),
            (None, [_, x, y, z]) => [x, y, z],
        };
        minus(onto, self.acting(seen))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acting(&self, seen: Vector<T>) -> Vector<T> {
        match self.arm {
            Some(arm) => cross(arm, seen),
            None => seen,
        }
    }
}

impl<T: Arithmetic> ByTurn<T> for Sight<T> {
    const IS_ANY: bool = true;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(&self, onto: Vector<T>, turn: Turn<T>) -> Vector<T> {
        let two = turn[0].constant(2.0);
        plus_times(onto, self.acting(between(self.product, turn)), two)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn back(&self, moment: Vector<T>) -> Option<Turn<T>> {
        let seen = match self.arm {
            Some(arm) => cross(moment, arm),
            None => moment,
        };
        Some(turned(self.product, seen))
    }
}

impl<T: Arithmetic> Moments<T> for Seen<T> {
    type ByTurn = Sight<T>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn at(&self, place: Place, turn: Option<Turn<T>>, velocity: Vector<T>) -> Moment<T, Sight<T>> {
        let (own, load) = (
            self.own.at(place, turn, velocity),
            &self.loads[place as usize],
        );
        let by_turn = Sight::of(load.value, self.arm, turn);
        let grown = Sight::of(load.by_length, self.arm, turn);
        Moment {
            value: by_turn.moment(own.value, turn),
            by_velocity: own.by_velocity,
            by_turn,
            by_length: grown.moment(own.by_length, turn),
        }
    }
}
