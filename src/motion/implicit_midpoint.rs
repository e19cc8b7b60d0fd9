//! The implicit midpoint rule on the group of rotations.

use crate::motion::{
    Number, Quaternion, Scheme, State, System, TorqueLaw, cayley,
    symplectic::{FreeFlow, compose},
};
use nalgebra::Vector3;

/// The implicit midpoint rule on the group, of order 2, with half of the torque before and half after.
///
/// m' − m = h m̄ × I⁻¹m̄ with m̄ = (m + m')/2, and the attitude turns by the Cayley transform of h I⁻¹m̄, so that the
/// angular momentum in space stays. Of a free body it keeps energy and momentum to rounding; it is
/// reversible, and Poisson only to second order (Austin, Krishnaprasad and Wang, J. Comput. Phys. 107 (1993)).
/// Where a step turns so far that the equation has no solution nearby, the state is not a number.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub struct ImplicitMidpoint;

impl<L> Scheme<L> for ImplicitMidpoint {
    fn order(&self) -> usize {
        2
    }

    fn step<T: Number>(&self, system: &System<T, L>, time: T, state: &State<T>, step: T) -> State<T>
    where
        L: TorqueLaw<T>,
    {
        compose(self, (2, &[1.0]), system, time, state, step)
    }
}

impl FreeFlow for ImplicitMidpoint {
    fn turn<T: Number, L: TorqueLaw<T>>(
        &self,
        system: &System<T, L>,
        momentum: &Vector3<T>,
        step: T,
    ) -> Quaternion<T> {
        // With c = h I⁻¹m̄ / 2: m̄ = m + m̄ × c.
        cayley::turn(system.inertia(), &(momentum * (step * T::of(0.5))), false)
    }
}
