//! What one parameter of a body runs over, and the integrals of its powers.

use crate::scalar::{Field, Ring};

/// The powers of a parameter: of t itself, `[n, 0]`; of cosine and sine of an angle, `[a, b]`.
pub(super) type Powers = [i32; 2];

/// The range of a parameter.
#[derive(Clone, Debug)]
pub(super) enum Range<T> {
    /// A single value: the body has no extent that way.
    Pinned(T),
    /// From one value to another.
    Segment(T, T),
    /// An angle in radians, and which part of the circle it is.
    Arc(Part, T),
}

/// A part of a circle that starts at angle 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Part {
    Whole,
    Half,
    Quarter,
}

impl Part {
    /// The arc, for this π.
    pub(super) fn arc<T: Field>(self, pi: &T) -> Range<T> {
        let angle = match self {
            Self::Whole => pi.clone() + pi.clone(),
            Self::Half => pi.clone(),
            Self::Quarter => pi.clone() / T::int(2),
        };
        Range::Arc(self, angle)
    }

    /// Cosine and sine at the end. At the start they are 1 and 0.
    fn end(self) -> [i32; 2] {
        match self {
            Self::Whole => [1, 0],
            Self::Half => [-1, 0],
            Self::Quarter => [0, 1],
        }
    }

    /// What `cosᵃ sinᵇ` gains from start to end.
    fn gain(self, [a, b]: Powers) -> i32 {
        let [cosine, sine] = self.end();
        let power = |base: i32, exponent: i32| (0..exponent).fold(1, |p, _| p * base);
        power(cosine, a) * power(sine, b) - power(0, b)
    }
}

impl<T: Field> Range<T> {
    /// What [`Self::integral`] leaves out: the length of a segment.
    pub(super) fn length(&self) -> T {
        match self {
            Self::Segment(from, to) => to.clone() - from.clone(),
            Self::Pinned(_) | Self::Arc(..) => T::one(),
        }
    }

    /// The integral of a power over the range, of a segment per unit of its length.
    ///
    /// So a segment from p to q gives `Σ pᵏ qⁿ⁻ᵏ / (n + 1)` without a difference: nothing cancels in a thin wall, and one
    /// of no thickness is the limit.
    pub(super) fn integral(&self, powers: Powers) -> T {
        let [n, _] = powers;
        match self {
            Self::Pinned(at) => power(at, n),
            Self::Segment(from, to) => {
                let sum = (0..=n).fold(T::zero(), |sum, k| sum + power(from, k) * power(to, n - k));
                sum / T::int(n + 1)
            }
            Self::Arc(part, angle) => over_arc(*part, angle, powers),
        }
    }
}

/// `∫ cosᵃ φ sinᵇ φ dφ` by parts, down to ∫ dφ = `angle`:
///
/// * `(a + b) ∫ cᵃ sᵇ = (a − 1) ∫ cᵃ⁻² sᵇ + [cᵃ⁻¹ sᵇ⁺¹]`, the derivative of the bracket with s² = 1 − c²;
/// * `b ∫ sᵇ = (b − 1) ∫ sᵇ⁻² − [c sᵇ⁻¹]`.
fn over_arc<T: Field>(part: Part, angle: &T, [a, b]: Powers) -> T {
    let lower = |factor: i32, powers: Powers| {
        if factor == 0 {
            T::zero()
        } else {
            T::int(factor) * over_arc(part, angle, powers)
        }
    };
    if a > 0 {
        (lower(a - 1, [a - 2, b]) + T::int(part.gain([a - 1, b + 1]))) / T::int(a + b)
    } else if b > 0 {
        (lower(b - 1, [0, b - 2]) - T::int(part.gain([1, b - 1]))) / T::int(b)
    } else {
        angle.clone()
    }
}

fn power<T: Ring>(base: &T, exponent: i32) -> T {
    (0..exponent).fold(T::one(), |p, _| p * base.clone())
}
