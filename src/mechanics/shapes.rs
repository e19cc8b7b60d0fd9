//! Uniform bodies: mass, mass centre and inertia tensor of rods, plates, cylinders, pyramids, balls and their parts, by exact
//! integrals.
//!
//! No result is remembered here. A body is described once: over which ranges its parameters run, where each point
//! lies, and how much mass is there (`Chart`). Its moments ∫ dm, ∫ r dm and ∫ r rᵀ dm are then products of integrals in
//! one variable: powers over a segment, and powers of cosine and sine over an arc. Sizes enter as the ends of a
//! segment or by a linear map. [`Shape`] is the table of bodies by name; [`Moments`] places them, and adds and takes
//! away.
//!
//! ```
//! use nalgebra::{Matrix3, Vector3};
//! use polhode::mechanics::Shape;
//! // A disc of radius 2 m and 3 kg/m² with a hole of radius 1 m that touches its rim.
//! let (disc, pi, density) = (Shape::by_name("disc").ok_or("no disc")?, std::f64::consts::PI, 3.0);
//! let of_radius = |radius: f64| disc.uniform(&density, &[radius], &pi).ok_or("one size");
//! let hole = of_radius(1.0)?.placed(&Matrix3::identity(), &Vector3::new(1.0, 0.0, 0.0));
//! let body = of_radius(2.0)?.minus(&hole);
//! assert!((body.mass - 3.0 * density * pi).abs() < 1e-12);
//! assert!((body.mass_centre().x + 1.0 / 3.0).abs() < 1e-12);
//! # Ok::<(), &str>(())
//! ```

mod bodies;
mod chart;
mod moments;
mod range;
mod table;

pub use moments::Moments;
pub use table::{Shape, Size};
