//! The forms in which a scene gives an inertia tensor.

use crate::mechanics::{Products, Shape, inertia, inertia_of_points, parallel_axis};
use crate::motion::Quaternion;
use crate::scene::{Draw, Quantity};
use nalgebra::{Matrix3, Vector3};
use std::f64::consts::PI;

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
    /// A uniform body, along its own axes, about its mass centre or a point beside it.
    Shape {
        /// Which body.
        shape: Shape,
        /// The numbers of its sizes in the order of the table, m. With more or fewer the tensor is not a number.
        sizes: Vec<Quantity>,
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
                sizes,
                mass,
                offset,
            } => {
                let mass = mass.draw(draw);
                let sizes: Vec<_> = sizes.iter().map(|size| size.draw(draw)).collect();
                let moments = shape.moments(&mass, &sizes, &PI);
                let unknown = || Matrix3::from_element(f64::NAN);
                let about_centre = moments.map_or_else(unknown, |body| body.central_inertia());
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
                sizes,
                mass,
                offset,
                ..
            } => fixed(sizes) && mass.is_fixed() && fixed(offset),
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
