//! Symplectic splitting: the free body as turns about fixed axes.

use crate::motion::{
    Number, Quaternion, Scheme, State, System, TorqueLaw,
    symplectic::{FreeFlow, compose},
};
use nalgebra::Vector3;

/// A step of turns about fixed axes of the body, with the torque before and after: symplectic, reversible, of
/// order 2, 4 or 6.
///
/// The angular momentum in space is kept to rounding where no torque acts. The energy error stays bounded, as
/// hᵖ, for as long as the motion lasts. A torque that depends on ω keeps the order and loses the rest.
///
/// ½ m·I⁻¹m is a sum of squares (a·m)², and the body of one square turns uniformly about a. Along principal axes three
/// squares do (McLachlan 1993; Reich 1994); in other axes the products of inertia take one more each, so that
/// nothing is diagonalised and the step is smooth in the tensor. Composed after Suzuki (1990) to order
/// 4 and Kahan and Li (1997) to order 6; Hairer, Lubich, Wanner, *Geometric Numerical Integration*, II.5, V.3.2
/// and VII.5.3.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Splitting {
    order: usize,
}

/// Suzuki's five steps.
const FOURTH: [f64; 5] = [
    0.414_490_771_794_375_7,
    0.414_490_771_794_375_7,
    -0.657_963_087_177_502_9,
    0.414_490_771_794_375_7,
    0.414_490_771_794_375_7,
];

/// Kahan and Li's nine steps.
const SIXTH: [f64; 9] = [
    0.392_161_444_007_314_1,
    0.332_599_136_789_359_44,
    -0.706_246_172_557_639_4,
    0.082_213_596_293_550_8,
    0.798_543_990_934_829_9,
    0.082_213_596_293_550_8,
    -0.706_246_172_557_639_4,
    0.332_599_136_789_359_44,
    0.392_161_444_007_314_1,
];

impl Splitting {
    /// One step of turns: order 2.
    pub const SECOND: Self = Self { order: 2 };
    /// Five of them: order 4.
    pub const FOURTH: Self = Self { order: 4 };
    /// Nine of them: order 6.
    pub const SIXTH: Self = Self { order: 6 };

    fn weights(self) -> &'static [f64] {
        match self.order {
            2 => &[1.0],
            4 => &FOURTH,
            _ => &SIXTH,
        }
    }
}

impl<L> Scheme<L> for Splitting {
    fn order(&self) -> usize {
        self.order
    }

    fn step<T: Number>(&self, system: &System<T, L>, time: T, state: &State<T>, step: T) -> State<T>
    where
        L: TorqueLaw<T>,
    {
        let parts = (self.order, self.weights());
        compose(&Turns, parts, system, time, state, step)
    }
}

struct Turns;

impl FreeFlow for Turns {
    fn turn<T: Number, L: TorqueLaw<T>>(
        &self,
        system: &System<T, L>,
        momentum: &Vector3<T>,
        step: T,
    ) -> Quaternion<T> {
        let b = system.inverse();
        let half = step * T::of(0.5);
        let mut all = Turning {
            turn: Quaternion::identity(),
            momentum: *momentum,
        };
        if system.is_principal() {
            all.about(0, b[(0, 0)], half);
            all.about(1, b[(1, 1)], half);
            all.about(2, b[(2, 2)], step);
            all.about(1, b[(1, 1)], half);
            all.about(0, b[(0, 0)], half);
            return all.turn;
        }
        let (xy, xz, yz) = (b[(0, 1)], b[(0, 2)], b[(1, 2)]);
        let [x, y, z] = [
            b[(0, 0)] - xy - xz,
            b[(1, 1)] - xy - yz,
            b[(2, 2)] - xz - yz,
        ];
        all.between(0, 1, xy, half);
        all.between(0, 2, xz, half);
        all.between(1, 2, yz, half);
        all.about(0, x, half);
        all.about(1, y, half);
        all.about(2, z, step);
        all.about(1, y, half);
        all.about(0, x, half);
        all.between(1, 2, yz, half);
        all.between(0, 2, xz, half);
        all.between(0, 1, xy, half);
        all.turn
    }
}

/// A turn as far as it has come, and the momentum that the body sees there.
struct Turning<T> {
    turn: Quaternion<T>,
    momentum: Vector3<T>,
}

impl<T: Number> Turning<T> {
    /// The body of ½ `inverse` (e·m)² for `span`, e the axis `i`.
    #[inline]
    fn about(&mut self, i: usize, inverse: T, span: T) {
        let (sine, cosine) = (self.momentum[i] * inverse * span * T::of(0.5)).sin_cos();
        let mut axis = Vector3::from_element(T::zero());
        axis[i] = sine;
        self.by(Quaternion { w: cosine, v: axis });
    }

    /// The body of ½ `inverse` ((e + f)·m)² for `span`, e and f the axes `i` and `j`.
    #[inline]
    fn between(&mut self, i: usize, j: usize, inverse: T, span: T) {
        // e + f is √2 long: the turn is √2 times as fast, about a direction that has 1/√2 along each.
        let rate = (self.momentum[i] + self.momentum[j]) * inverse;
        let half = T::of(std::f64::consts::FRAC_1_SQRT_2);
        let (sine, cosine) = (rate * span * half).sin_cos();
        let mut axis = Vector3::from_element(T::zero());
        axis[i] = sine * half;
        axis[j] = sine * half;
        self.by(Quaternion { w: cosine, v: axis });
    }

    #[inline]
    fn by(&mut self, turn: Quaternion<T>) {
        self.momentum = turn.to_body(&self.momentum);
        self.turn = self.turn * turn;
    }
}
