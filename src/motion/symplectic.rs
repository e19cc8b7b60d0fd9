//! What the geometric steps share: a free turn between two halves of the torque, repeated to a higher order.

use crate::mechanics::apply;
use crate::motion::{Number, Quaternion, State, System, TorqueLaw};
use nalgebra::Vector3;

/// A way to turn a free body for one step. The angular momentum in space stays as it was, whatever the turn.
pub(crate) trait FreeFlow {
    /// The turn of a step, a unit quaternion p: the attitude becomes q p, and a body with the angular
    /// momentum `momentum` (body axes) has p⁻¹ `momentum` p then.
    fn turn<T: Number, L: TorqueLaw<T>>(
        &self,
        system: &System<T, L>,
        momentum: &Vector3<T>,
        step: T,
    ) -> Quaternion<T>;
}

/// Attitude and angular momentum in body axes.
struct Place<T> {
    attitude: Quaternion<T>,
    momentum: Vector3<T>,
}

/// The steps `weights · step` one after another, each the free turn between two half kicks of the torque. `order` is
/// that of the whole, to which a torque that depends on ω is taken.
pub(crate) fn compose<T: Number, L: TorqueLaw<T>>(
    flow: &impl FreeFlow,
    (order, weights): (usize, &[f64]),
    system: &System<T, L>,
    time: T,
    state: &State<T>,
    step: T,
) -> State<T> {
    let mut place = Place {
        attitude: state.attitude,
        momentum: apply(system.inertia(), &state.angular_velocity),
    };
    let mut now = time;
    for weight in weights {
        let span = step * T::of(*weight);
        let half = span * T::of(0.5);
        kick(&mut place, system, now, half, order);
        let turn = flow.turn(system, &place.momentum, span);
        place = Place {
            attitude: place.attitude * turn,
            momentum: turn.to_body(&place.momentum),
        };
        now += span;
        kick(&mut place, system, now, half, order);
    }
    State {
        attitude: place.attitude.normalised(),
        angular_velocity: apply(system.inverse(), &place.momentum),
    }
}

/// The torque for `span` at a fixed time and attitude. One that depends on ω is taken by the implicit midpoint rule,
/// iterated until it is symmetric to the order.
fn kick<T: Number, L: TorqueLaw<T>>(
    place: &mut Place<T>,
    system: &System<T, L>,
    time: T,
    span: T,
    order: usize,
) {
    let again = if system.law().needs_angular_velocity() {
        order
    } else {
        0
    };
    let mut change = Vector3::from_element(T::zero());
    for _ in 0..=again {
        let middle = place.momentum + change * T::of(0.5);
        let state = State {
            attitude: place.attitude,
            angular_velocity: apply(system.inverse(), &middle),
        };
        change = system.torque(time, &state) * span;
    }
    place.momentum += change;
}
