//! The implicit equation of the steps whose turn is a Cayley transform.

use crate::mechanics::{adjugate, apply, cross, skew};
use crate::motion::{Number, Quaternion};
use nalgebra::{Matrix3, Vector3};

/// The most Newton steps. From the explicit guess four to six are taken while a step turns by less than a
/// radian; what has not settled after so many has no solution nearby.
const CAP: usize = 40;

/// A change below which the next ones fall as squares, until they are rounding: of single precision too.
const SETTLED: f64 = 1e-4;

/// The turn with the Cayley vector c = tan(angle/2) axis of `I c + c × I c = σ p`: σ is 1, or 1 + |c|² where
/// `stretched`. Not a number where no solution is found.
///
/// The solution is found without derivatives, and these then follow from the implicit-function theorem: one step of
/// Newton's method with the slope at the solution for each order of derivative.
pub(crate) fn turn<T: Number>(
    inertia: &Matrix3<T>,
    p: &Vector3<T>,
    stretched: bool,
) -> Quaternion<T> {
    let equation = Equation {
        inertia: inertia.map(|i| i.real()),
        p: p.map(|c| c.real()),
        stretched,
    };
    let (found, inverse) = equation.solve();
    let full = Equation {
        inertia: *inertia,
        p: *p,
        stretched,
    };
    let (mut c, inverse) = (found.map(T::constant), inverse.map(T::constant));
    for _ in 0..T::DERIVATIVES {
        c -= apply(&inverse, &full.residual(&c));
    }
    Quaternion { w: T::one(), v: c }.normalised()
}

struct Equation<T> {
    inertia: Matrix3<T>,
    p: Vector3<T>,
    stretched: bool,
}

impl<T: Number> Equation<T> {
    fn residual(&self, c: &Vector3<T>) -> Vector3<T> {
        let momentum = apply(&self.inertia, c);
        let left = momentum + cross(c, &momentum);
        if self.stretched {
            left - self.p * (T::one() + c.dot(c))
        } else {
            left - self.p
        }
    }

    /// The inverse of the slope of the residual.
    fn inverse_slope(&self, c: &Vector3<T>) -> Matrix3<T> {
        let momentum = apply(&self.inertia, c);
        let mut slope = self.inertia + skew(c) * self.inertia - skew(&momentum);
        if self.stretched {
            slope -= self.p * c.transpose() * T::of(2.0);
        }
        // Scaled by the trace of the tensor, so that no determinant overflows.
        let scale = T::one() / self.inertia.trace();
        let scaled = slope * scale;
        let minors = adjugate(&scaled);
        let determinant = scaled[(0, 0)] * minors[(0, 0)]
            + scaled[(0, 1)] * minors[(1, 0)]
            + scaled[(0, 2)] * minors[(2, 0)];
        minors * (scale / determinant)
    }

    fn solve(&self) -> (Vector3<T>, Matrix3<T>) {
        let mut c = Vector3::from_element(T::zero());
        let mut before = f64::INFINITY;
        for _ in 0..CAP {
            let inverse = self.inverse_slope(&c);
            let change = apply(&inverse, &self.residual(&c));
            c -= change;
            let size = largest(&change) / (1.0 + largest(&c));
            // Convergence is quadratic: the next change would be below rounding, or rounding is all there is.
            if size < SETTLED && (size < 1e-15 || size >= before) {
                return (c, self.inverse_slope(&c));
            }
            before = size;
        }
        // The root of a negative number marks what has not settled.
        let change = apply(&self.inverse_slope(&c), &self.residual(&c));
        let room = (T::one() + c.dot(&c)) * T::of(SETTLED * SETTLED) - change.dot(&change);
        let mark = room.sqrt() * T::zero();
        let c = c.map(|c| c + mark);
        (c, self.inverse_slope(&c))
    }
}

fn largest<T: Number>(v: &Vector3<T>) -> f64 {
    v.iter().fold(0.0, |m, c| c.magnitude().max(m))
}
