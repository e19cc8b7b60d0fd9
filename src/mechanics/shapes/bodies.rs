//! The bodies, each described once.

use crate::mechanics::determinant;
use crate::mechanics::shapes::chart::{Chart, Monomial, ONE, Unit};
use crate::mechanics::shapes::range::{Part, Range};
use crate::scalar::Field;
use nalgebra::{Matrix3, Vector3};

/// What kind of body the sizes are those of. A form reads its sizes in the order of the table.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Form {
    /// Edges along x, y, z, as many as sizes; a rod has one, along z.
    Rod,
    Plate,
    Box,
    /// Two or three equal edges.
    SquarePlate,
    Cube,
    /// About z, of a height or flat.
    Round(Wall, Part, Height),
    /// A round body stretched to two semi-axes.
    Elliptic(Height),
    /// About z, narrowing to its tip. `Wall::Thin` is the lateral surface alone.
    Cone(Wall, Part),
    /// On a rectangle, narrowing to its tip.
    Pyramid,
    Paraboloid,
    /// The arc is that of the angle from the z-axis: a half for the whole ball, a quarter for its upper half.
    Ball(Wall, Part),
    Ellipsoid(Part),
    Triangle,
    Tetrahedron,
}

/// What lies between axis and rim.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Wall {
    /// Everything.
    Solid,
    /// Nothing: the rim alone.
    Thin,
    /// What is outside of an inner radius.
    Thick,
}

/// Whether a body extends along z.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(super) enum Height {
    Given,
    Flat,
}

/// The body of mass 1; nothing where there are too few sizes.
pub(super) fn unit<T: Field>(form: Form, sizes: &[T], pi: &T) -> Option<Unit<T>> {
    let sizes = &mut sizes.iter().cloned();
    Some(match form {
        Form::Rod => block([None, None, Some(sizes.next()?)]),
        Form::Plate => block([Some(sizes.next()?), Some(sizes.next()?), None]),
        Form::Box => block([sizes.next()?, sizes.next()?, sizes.next()?].map(Some)),
        Form::SquarePlate => {
            let edge = sizes.next()?;
            block([Some(edge.clone()), Some(edge), None])
        }
        Form::Cube => {
            let edge = sizes.next()?;
            block([edge.clone(), edge.clone(), edge].map(Some))
        }
        Form::Round(wall, part, height) => {
            round(wall.radii(sizes)?, part.arc(pi), height.range(sizes)?)
        }
        Form::Elliptic(height) => {
            let (a, b) = (sizes.next()?, sizes.next()?);
            let disc = round(one(Wall::Solid), Part::Whole.arc(pi), height.range(sizes)?);
            disc.stretched(&Vector3::new(a.clone(), b.clone(), T::one()), a * b)
        }
        Form::Cone(wall, part) => cone(wall, part.arc(pi), &sizes.next()?, &sizes.next()?),
        Form::Pyramid => pyramid([sizes.next()?, sizes.next()?], &sizes.next()?),
        Form::Paraboloid => paraboloid(Part::Whole.arc(pi), &sizes.next()?, &sizes.next()?),
        Form::Ball(wall, part) => ball(wall.radii(sizes)?, part, pi),
        Form::Ellipsoid(part) => {
            let axes = Vector3::new(sizes.next()?, sizes.next()?, sizes.next()?);
            let volume = axes.iter().fold(T::one(), |v, a| v * a.clone());
            ball(one(Wall::Solid), part, pi).stretched(&axes, volume)
        }
        Form::Triangle => {
            let mut corner = || Some(Vector3::new(sizes.next()?, sizes.next()?, T::zero()));
            triangle(&corner()?, &corner()?, &corner()?)
        }
        Form::Tetrahedron => {
            let mut corner = || Some(Vector3::new(sizes.next()?, sizes.next()?, sizes.next()?));
            tetrahedron([corner()?, corner()?, corner()?, corner()?])
        }
    })
}

impl Wall {
    fn radii<T: Field>(self, sizes: &mut impl Iterator<Item = T>) -> Option<Range<T>> {
        Some(match self {
            Self::Solid => Range::Segment(T::zero(), sizes.next()?),
            Self::Thin => Range::Pinned(sizes.next()?),
            Self::Thick => Range::Segment(sizes.next()?, sizes.next()?),
        })
    }
}

/// The radii of a body of radius 1.
fn one<T: Field>(wall: Wall) -> Range<T> {
    match wall {
        Wall::Thin => Range::Pinned(T::one()),
        Wall::Solid | Wall::Thick => Range::Segment(T::zero(), T::one()),
    }
}

impl Height {
    fn range<T: Field>(self, sizes: &mut impl Iterator<Item = T>) -> Option<Range<T>> {
        match self {
            Self::Given => sizes.next().map(|height| about_zero(Some(height))),
            Self::Flat => Some(about_zero(None)),
        }
    }
}

/// A length with its middle at 0, or 0 alone.
fn about_zero<T: Field>(length: Option<T>) -> Range<T> {
    match length {
        Some(length) => {
            let half = length / T::int(2);
            Range::Segment(-half.clone(), half)
        }
        None => Range::Pinned(T::zero()),
    }
}

/// The first, second or third parameter.
const P: Monomial = [[1, 0], [0, 0], [0, 0]];
const Q: Monomial = [[0, 0], [1, 0], [0, 0]];
const R: Monomial = [[0, 0], [0, 0], [1, 0]];

/// `r = (p, q, r)`, dV = dp dq dr.
fn block<T: Field>(edges: [Option<T>; 3]) -> Unit<T> {
    let chart = Chart {
        ranges: edges.map(about_zero),
        measure: ONE,
        point: [P, Q, R],
    };
    chart.into()
}

/// `r = (ρ cos φ, ρ sin φ, z)`, dV = ρ dρ dφ dz.
fn round<T: Field>(radii: Range<T>, turn: Range<T>, height: Range<T>) -> Unit<T> {
    let chart = Chart {
        ranges: [radii, turn, height],
        measure: P,
        point: [[[1, 0], [1, 0], [0, 0]], [[1, 0], [0, 1], [0, 0]], R],
    };
    chart.into()
}

/// `r = (t ρ cos φ, t ρ sin φ, t)` from the tip, dV = t² ρ dt dρ dφ; on the surface ρ = 1, dA ∝ t dt dφ.
fn cone<T: Field>(wall: Wall, turn: Range<T>, radius: &T, height: &T) -> Unit<T> {
    let chart = Chart {
        ranges: [Range::Segment(T::zero(), T::one()), turn, one(wall)],
        measure: match wall {
            Wall::Thin => P,
            Wall::Solid | Wall::Thick => [[2, 0], [0, 0], [1, 0]],
        },
        point: [[[1, 0], [1, 0], [1, 0]], [[1, 0], [0, 1], [1, 0]], P],
    };
    let mut cone = tip_up(chart.into(), [radius; 2], height, T::one());
    if wall == Wall::Thin {
        // The slant height is a root.
        cone.content = None;
    }
    cone
}

/// `r = (t p, t q, t)` from the tip, dV = t² dt dp dq.
fn pyramid<T: Field>([along_x, along_y]: [T; 2], height: &T) -> Unit<T> {
    let edge = || about_zero(Some(T::one()));
    let chart = Chart {
        ranges: [edge(), edge(), Range::Segment(T::zero(), T::one())],
        measure: [[0, 0], [0, 0], [2, 0]],
        point: [[[1, 0], [0, 0], [1, 0]], [[0, 0], [1, 0], [1, 0]], R],
    };
    tip_up(chart.into(), [&along_x, &along_y], height, T::one())
}

/// `r = (t ρ cos φ, t ρ sin φ, t²)` from the tip, dV = 2 t³ ρ dt dρ dφ.
fn paraboloid<T: Field>(turn: Range<T>, radius: &T, height: &T) -> Unit<T> {
    let unit = || Range::Segment(T::zero(), T::one());
    let chart = Chart {
        ranges: [unit(), turn, unit()],
        measure: [[3, 0], [0, 0], [1, 0]],
        point: [
            [[1, 0], [1, 0], [1, 0]],
            [[1, 0], [0, 1], [1, 0]],
            [[2, 0], [0, 0], [0, 0]],
        ],
    };
    tip_up(chart.into(), [radius; 2], height, T::int(2))
}

/// A body of height 1 along z from its tip, its base stretched along x and y and its height to these sizes, with the base
/// in z = 0 and the tip above it.
fn tip_up<T: Field>(body: Unit<T>, [x, y]: [&T; 2], height: &T, factor: T) -> Unit<T> {
    let stretch = Vector3::new(x.clone(), y.clone(), -height.clone());
    let shift = Vector3::new(T::zero(), T::zero(), height.clone());
    let volume = x.clone() * y.clone() * height.clone();
    body.image(&Matrix3::from_diagonal(&stretch), &shift, volume * factor)
}

/// `r = (ρ sin θ cos φ, ρ sin θ sin φ, ρ cos θ)`, dV = ρ² sin θ dρ dθ dφ.
fn ball<T: Field>(radii: Range<T>, part: Part, pi: &T) -> Unit<T> {
    let chart = Chart {
        ranges: [radii, part.arc(pi), Part::Whole.arc(pi)],
        measure: [[2, 0], [0, 1], [0, 0]],
        point: [
            [[1, 0], [0, 1], [1, 0]],
            [[1, 0], [0, 1], [0, 1]],
            [[1, 0], [1, 0], [0, 0]],
        ],
    };
    chart.into()
}

/// `r = a + p (b − a) + p q (c − b)`, dA ∝ p dp dq.
fn triangle<T: Field>(a: &Vector3<T>, b: &Vector3<T>, c: &Vector3<T>) -> Unit<T> {
    let unit = || Range::Segment(T::zero(), T::one());
    let chart = Chart {
        ranges: [unit(), unit(), Range::Pinned(T::zero())],
        measure: P,
        point: [P, [[1, 0], [1, 0], [0, 0]], R],
    };
    let upright = Vector3::new(T::zero(), T::zero(), T::one());
    let edges = Matrix3::from_columns(&[b - a, c - b, upright]);
    Unit::from(chart).image(&edges, a, determinant(&edges))
}

/// `r = a + p (b − a) + p q (c − b) + p q r (d − c)`, dV ∝ p² q dp dq dr.
fn tetrahedron<T: Field>([a, b, c, d]: [Vector3<T>; 4]) -> Unit<T> {
    let unit = || Range::Segment(T::zero(), T::one());
    let chart = Chart {
        ranges: [unit(), unit(), unit()],
        measure: [[2, 0], [1, 0], [0, 0]],
        point: [P, [[1, 0], [1, 0], [0, 0]], [[1, 0], [1, 0], [1, 0]]],
    };
    let edges = Matrix3::from_columns(&[&b - &a, &c - &b, d - c]);
    Unit::from(chart).image(&edges, &a, determinant(&edges))
}
