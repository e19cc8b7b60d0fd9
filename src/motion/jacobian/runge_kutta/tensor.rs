//! The equation of motion and its derivatives for an inertia tensor of any axes and for one of principal axes.
//!
//! Of any axes, the angular momentum L = I v goes beside v from stage to stage by its own rate k = M − v × L, as do their
//! changes: the tensor is applied once in a step instead of once in a stage, and δa = I⁻¹ (δk − δI a). Along principal axes the
//! differences of the moments are formed once, for the products would lose what a needle's moments have in common.

use super::algebra::{Vector, dot, minus, plus, plus_cross, plus_times};
use crate::motion::registers::Arithmetic;

/// An inertia tensor with its inverse.
pub(super) trait Tensor<T>: Copy {
    /// The angular momentum if it goes beside v, or its rate.
    type Momentum: Copy;

    /// I⁻¹ v.
    fn inverse(&self, v: Vector<T>) -> Vector<T>;

    /// I v.
    fn momentum(&self, v: Vector<T>) -> Self::Momentum;

    /// A momentum a span later.
    fn onward(momentum: Self::Momentum, rate: Self::Momentum, span: T) -> Self::Momentum;

    /// I⁻¹ (M − v × I v), and the rate of the momentum.
    fn acceleration(
        &self,
        moment: Vector<T>,
        v: Vector<T>,
        momentum: Self::Momentum,
    ) -> (Vector<T>, Self::Momentum);

    /// The change of the momentum that [`along`](Self::along) asks for: δ(I v), or δI v alone.
    fn changed(&self, by_v: Vector<T>, by_inertia: Vector<T>) -> Vector<T>;

    /// The change of the acceleration with those of M, of v and of the momentum, and with δI a; and the rate of the change of
    /// the momentum.
    fn along(
        &self,
        place: (Vector<T>, Self::Momentum),
        by_moment: Vector<T>,
        by_v: Vector<T>,
        changed: Vector<T>,
        inertial: Vector<T>,
    ) -> (Vector<T>, Vector<T>);

    /// A covector of M and one of −δI a, from the inverse times one of the acceleration and from what the stage after adds of −δI v.
    fn sources(inverse: Vector<T>, after: Vector<T>) -> (Vector<T>, Vector<T>);

    /// `onto` and a covector of the acceleration, that is one of the moment M − v × I v, times the derivative in v.
    fn back(
        &self,
        onto: Vector<T>,
        place: (Vector<T>, Self::Momentum),
        acceleration: Vector<T>,
        moment: Vector<T>,
    ) -> Vector<T>;

    /// A covector of v at the start with that of −I v there, where I v goes beside v.
    fn start(&self, velocity: Vector<T>, momentum: Vector<T>) -> Vector<T>;
}

/// A tensor of any axes: xx, yy, zz, xy, xz, yz.
#[derive(Clone, Copy)]
pub(super) struct Full<T> {
    pub(super) entries: [T; 6],
    pub(super) inverse: [T; 6],
}

/// A tensor along its principal axes.
#[derive(Clone, Copy)]
pub(super) struct Principal<T> {
    /// (I_y − I_z)/I_x and cyclic.
    pub(super) ratios: Vector<T>,
    pub(super) inverse: Vector<T>,
}

/// A symmetric matrix times a vector.
#[cfg_attr(not(debug_assertions), inline(always))]
pub(in crate::motion::jacobian) fn symmetric<T: Arithmetic>(
    [xx, yy, zz, xy, xz, yz]: [T; 6],
    v: Vector<T>,
) -> Vector<T> {
    [
        dot([xx, xy, xz], v),
        dot([xy, yy, yz], v),
        dot([xz, yz, zz], v),
    ]
}

impl<T: Arithmetic> Tensor<T> for Full<T> {
    type Momentum = Vector<T>;

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn inverse(&self, v: Vector<T>) -> Vector<T> {
        symmetric(self.inverse, v)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn momentum(&self, v: Vector<T>) -> Vector<T> {
        symmetric(self.entries, v)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn onward(momentum: Vector<T>, rate: Vector<T>, span: T) -> Vector<T> {
        plus_times(momentum, rate, span)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acceleration(
        &self,
        moment: Vector<T>,
        v: Vector<T>,
        momentum: Vector<T>,
    ) -> (Vector<T>, Vector<T>) {
        let net = plus_cross(moment, momentum, v);
        (self.inverse(net), net)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn changed(&self, by_v: Vector<T>, by_inertia: Vector<T>) -> Vector<T> {
        plus(self.momentum(by_v), by_inertia)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(
        &self,
        (v, momentum): (Vector<T>, Vector<T>),
        by_moment: Vector<T>,
        by_v: Vector<T>,
        changed: Vector<T>,
        inertial: Vector<T>,
    ) -> (Vector<T>, Vector<T>) {
        let net = plus_cross(plus_cross(by_moment, momentum, by_v), changed, v);
        (self.inverse(minus(net, inertial)), net)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sources(inverse: Vector<T>, after: Vector<T>) -> (Vector<T>, Vector<T>) {
        (minus(inverse, after), inverse)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn back(
        &self,
        onto: Vector<T>,
        (_, momentum): (Vector<T>, Vector<T>),
        _: Vector<T>,
        moment: Vector<T>,
    ) -> Vector<T> {
        plus_cross(onto, moment, momentum)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn start(&self, velocity: Vector<T>, momentum: Vector<T>) -> Vector<T> {
        minus(velocity, self.momentum(momentum))
    }
}

impl<T: Arithmetic> Tensor<T> for Principal<T> {
    type Momentum = ();

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn inverse(&self, [x, y, z]: Vector<T>) -> Vector<T> {
        let [a, b, c] = self.inverse;
        [a * x, b * y, c * z]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn momentum(&self, _: Vector<T>) {}

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn onward((): (), (): (), _: T) {}

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn acceleration(&self, moment: Vector<T>, [x, y, z]: Vector<T>, (): ()) -> (Vector<T>, ()) {
        let ([a, b, c], [l, m, n]) = (self.ratios, self.inverse(moment));
        let acceleration = [
            l.plus_product(a, y * z),
            m.plus_product(b, z * x),
            n.plus_product(c, x * y),
        ];
        (acceleration, ())
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn changed(&self, _: Vector<T>, by_inertia: Vector<T>) -> Vector<T> {
        by_inertia
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn along(
        &self,
        ([x, y, z], ()): (Vector<T>, ()),
        by_moment: Vector<T>,
        [p, q, r]: Vector<T>,
        changed: Vector<T>,
        inertial: Vector<T>,
    ) -> (Vector<T>, Vector<T>) {
        let [a, b, c] = self.ratios;
        let moment = plus_cross(minus(by_moment, inertial), changed, [x, y, z]);
        let [l, m, n] = self.inverse(moment);
        let acceleration = [
            l.plus_product(a, (y * r).plus_product(z, q)),
            m.plus_product(b, (z * p).plus_product(x, r)),
            n.plus_product(c, (x * q).plus_product(y, p)),
        ];
        (acceleration, inertial)
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn sources(inverse: Vector<T>, after: Vector<T>) -> (Vector<T>, Vector<T>) {
        (inverse, plus(inverse, after))
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn back(
        &self,
        [l, m, n]: Vector<T>,
        ([x, y, z], ()): (Vector<T>, ()),
        [p, q, r]: Vector<T>,
        _: Vector<T>,
    ) -> Vector<T> {
        let [a, b, c] = self.ratios;
        let [p, q, r] = [a * p, b * q, c * r];
        [
            l.plus_product(q, z).plus_product(r, y),
            m.plus_product(p, z).plus_product(r, x),
            n.plus_product(p, y).plus_product(q, x),
        ]
    }

    #[cfg_attr(not(debug_assertions), inline(always))]
    fn start(&self, velocity: Vector<T>, _: Vector<T>) -> Vector<T> {
        velocity
    }
}
