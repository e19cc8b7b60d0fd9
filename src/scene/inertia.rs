//! The forms in which a scene gives an inertia tensor.

use crate::mechanics::{Products, inertia, inertia_of_points, parallel_axis};
use crate::motion::Quaternion;
use crate::scene::{Draw, Quantity};
use nalgebra::{Matrix3, Vector3};

/// An inertia as it stands in the file.
#[derive(Clone, Debug, PartialEq)]
pub enum InertiaForm {
    /// Moments and products, in the convention of the group.
    Tensor {
        /// I_xx, I_yy, I_zz, kg m².
        moments: [Quantity; 3],
        /// I_xy, I_xz, I_yz, kg m².
        products: [Quantity; 3],
    },
    /// Principal moments and the turn from principal to body axes.
    Principal {
        /// The moments, kg m².
        moments: [Quantity; 3],
        /// A quaternion, scalar first.
        axes: [Quantity; 4],
    },
    /// A homogeneous solid about its mass centre or a point beside it.
    Shape {
        /// The solid.
        shape: Shape,
        /// kg.
        mass: Quantity,
        /// From the mass centre to the point that the body turns about, m.
        offset: [Quantity; 3],
    },
    /// Point masses.
    Points {
        /// The points.
        points: Vec<Point>,
        /// About the origin of the positions instead of the mass centre.
        about_origin: bool,
    },
    /// The tensor of a robot's link, along its axes, whatever the convention of the group.
    Link(Matrix3<f64>),
}

/// A point mass.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Point {
    /// kg.
    pub mass: Quantity,
    /// Body axes, m.
    pub position: [Quantity; 3],
}

/// A homogeneous solid with its axis along z. Lengths in m.
#[derive(Clone, Copy, Debug, PartialEq)]
pub enum Shape {
    /// Edges along x, y, z.
    Box([Quantity; 3]),
    /// Radius.
    Sphere(Quantity),
    /// Radius, height. A rod is a cylinder.
    Cylinder(Quantity, Quantity),
    /// Radius of the base, height.
    Cone(Quantity, Quantity),
    /// Semi-axes along x, y, z.
    Ellipsoid([Quantity; 3]),
    /// Edges along x, y, without thickness.
    Plate([Quantity; 2]),
}

impl InertiaForm {
    /// The tensor of one member; whether a body can have it is not looked at here.
    pub fn tensor(&self, convention: Products, draw: &mut Draw) -> Matrix3<f64> {
        match self {
            Self::Tensor { moments, products } => {
                let moments = all(moments, draw);
                inertia(moments, all(products, draw), convention)
            }
            Self::Principal { moments, axes } => {
                let diagonal = Matrix3::from_diagonal(&Vector3::from(all(moments, draw)));
                let turn = Quaternion::new(all(axes, draw));
                if turn == Quaternion::identity() {
                    return diagonal;
                }
                let axes = turn.normalised().matrix();
                let tensor = axes * diagonal * axes.transpose();
                // Both halves the same, to the last bit.
                Matrix3::from_fn(|r, c| tensor[(r.min(c), r.max(c))])
            }
            Self::Shape {
                shape,
                mass,
                offset,
            } => {
                let mass = mass.draw(draw);
                let about_centre = Matrix3::from_diagonal(&(shape.gyration(draw) * mass));
                parallel_axis(&about_centre, &mass, &Vector3::from(all(offset, draw)))
            }
            Self::Points {
                points,
                about_origin,
            } => {
                let points: Vec<_> = points
                    .iter()
                    .map(|point| {
                        let mass = point.mass.draw(draw);
                        (mass, Vector3::from(all(&point.position, draw)))
                    })
                    .collect();
                of_points(points, *about_origin)
            }
            Self::Link(tensor) => *tensor,
        }
    }

    /// Whether every member has the same tensor.
    pub fn is_fixed(&self) -> bool {
        let fixed = |list: &[Quantity]| list.iter().all(Quantity::is_fixed);
        match self {
            Self::Tensor { moments, products } => fixed(moments) && fixed(products),
            Self::Principal { moments, axes } => fixed(moments) && fixed(axes),
            Self::Shape {
                shape,
                mass,
                offset,
            } => shape.is_fixed() && mass.is_fixed() && fixed(offset),
            Self::Points { points, .. } => points
                .iter()
                .all(|point| point.mass.is_fixed() && fixed(&point.position)),
            Self::Link(_) => true,
        }
    }
}

/// The tensor about the mass centre or the origin. Positions are taken from the mass centre first: a difference of two
/// large tensors would lose a small body that is far away.
fn of_points(mut points: Vec<(f64, Vector3<f64>)>, about_origin: bool) -> Matrix3<f64> {
    if !about_origin {
        let mass: f64 = points.iter().map(|(m, _)| m).sum();
        let centre = points
            .iter()
            .fold(Vector3::zeros(), |sum, (m, r)| sum + r * (m / mass));
        for (_, position) in &mut points {
            *position -= centre;
        }
    }
    inertia_of_points(&points)
}

/// One number of each.
pub(crate) fn all<const N: usize>(quantities: &[Quantity; N], draw: &mut Draw) -> [f64; N] {
    quantities.map(|quantity| quantity.draw(draw))
}

impl Shape {
    /// Squares of the radii of gyration about x, y, z through the mass centre, m².
    fn gyration(&self, draw: &mut Draw) -> Vector3<f64> {
        // From the mean squares of the coordinates, which are the moments' own halves.
        let [x, y, z] = match self {
            Self::Box(size) => all(size, draw).map(|a| a * a / 12.0),
            Self::Sphere(radius) => {
                let r = radius.draw(draw);
                [r * r / 5.0; 3]
            }
            Self::Cylinder(radius, height) => {
                let (r, h) = (radius.draw(draw), height.draw(draw));
                [r * r / 4.0, r * r / 4.0, h * h / 12.0]
            }
            Self::Cone(radius, height) => {
                let (r, h) = (radius.draw(draw), height.draw(draw));
                [0.15 * r * r, 0.15 * r * r, 3.0 / 80.0 * h * h]
            }
            Self::Ellipsoid(semi_axes) => all(semi_axes, draw).map(|a| a * a / 5.0),
            Self::Plate(size) => {
                let [a, b] = all(size, draw);
                [a * a / 12.0, b * b / 12.0, 0.0]
            }
        };
        Vector3::new(y + z, z + x, x + y)
    }

    fn is_fixed(&self) -> bool {
        match self {
            Self::Box(size) | Self::Ellipsoid(size) => size.iter().all(Quantity::is_fixed),
            Self::Sphere(radius) => radius.is_fixed(),
            Self::Cylinder(radius, height) | Self::Cone(radius, height) => {
                radius.is_fixed() && height.is_fixed()
            }
            Self::Plate(size) => size.iter().all(Quantity::is_fixed),
        }
    }
}
