//! The discrete Moser–Veselov step with a preprocessed tensor.

mod correction;

use crate::mechanics::{adjugate, apply};
use crate::motion::{
    Number, Quaternion, Scheme, State, System, TorqueLaw, cayley,
    symplectic::{FreeFlow, compose},
    system,
};
use nalgebra::{Matrix3, Vector3};

/// The discrete Moser–Veselov step of a free body, of order 2 or, with a tensor that is corrected beforehand, 4, 6,
/// 8 or 10.
/// With a torque, half before and half after, of order 2.
///
/// Of a free body it keeps energy and momentum to rounding and is reversible: the discrete motion is integrable as
/// the true one is (Moser and Veselov, Commun. Math. Phys. 139 (1991)). The correction of the tensor depends on
/// these invariants alone (Hairer and Vilmart, J. Phys. A 39 (2006)), so that they stay; the step is symplectic
/// without it and to its order with it. The corrections grow as the moments part: a needle of 1e-6 takes short steps. Where a step turns so far that the equation has no solution nearby, the
/// state is not a number.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct MoserVeselov {
    order: usize,
}

impl MoserVeselov {
    /// With the tensor as it is: order 2.
    pub const SECOND: Self = Self { order: 2 };
    /// With the tensor corrected to order 4.
    pub const FOURTH: Self = Self { order: 4 };
    /// With the tensor corrected to order 6.
    pub const SIXTH: Self = Self { order: 6 };
    /// With the tensor corrected to order 8.
    pub const EIGHTH: Self = Self { order: 8 };
    /// With the tensor corrected to order 10.
    pub const TENTH: Self = Self { order: 10 };
}

impl<L> Scheme<L> for MoserVeselov {
    /// The order of a free body.
    fn order(&self) -> usize {
        self.order
    }

    fn step<T: Number>(&self, system: &System<T, L>, time: T, state: &State<T>, step: T) -> State<T>
    where
        L: TorqueLaw<T>,
    {
        compose(self, (2, &[1.0]), system, time, state, step)
    }
}

impl FreeFlow for MoserVeselov {
    fn turn<T: Number, L: TorqueLaw<T>>(
        &self,
        system: &System<T, L>,
        momentum: &Vector3<T>,
        step: T,
    ) -> Quaternion<T> {
        // Tensor and momentum over the trace: powers of moments neither over- nor underflow.
        let trace = system.inertia().trace();
        let scale = T::one() / trace;
        let (inertia, momentum) = (system.inertia() * scale, momentum * scale);
        let inertia = if self.order > 2 {
            let inverse = system.inverse() * trace;
            corrected(self.order / 2 - 1, &inertia, &inverse, &momentum, step)
        } else {
            inertia
        };
        cayley::turn(&inertia, &(momentum * (step * T::of(0.5))), true)
    }
}

/// The tensor of trace 1 with which the step is of order 2 (`count` + 1): its inverse is (1 + s) I⁻¹ + d.
fn corrected<T: Number>(
    count: usize,
    inertia: &Matrix3<T>,
    inverse: &Matrix3<T>,
    momentum: &Vector3<T>,
    step: T,
) -> Matrix3<T> {
    let minors = adjugate(inertia);
    let determinant = inertia[(0, 0)] * minors[(0, 0)]
        + inertia[(0, 1)] * minors[(1, 0)]
        + inertia[(0, 2)] * minors[(2, 0)];
    // With the step first: either is of the size of an angle, whatever the speed.
    let moved = momentum * step;
    let half = T::of(0.5) / determinant;
    let x = moved.dot(&moved) * half;
    let y = moved.dot(&apply(inverse, &moved)) * half;
    let (s, d) = correction::correction(count, [x, y, minors.trace(), determinant]);
    let changed = inverse * (T::one() + s) + Matrix3::from_diagonal_element(d);
    system::inverse(&changed)
}
