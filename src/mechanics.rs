//! What is true of a rigid body, over any ring: the equations in the order of the book.
//!
//! Inertia, momentum, the rate of a vector seen from turning axes, and from these ΣM = (dL/dt)_xyz + Ω × L.
//! Each function is the formula of its doc and nothing else. None knows which scalar it runs on, none branches
//! on a value: run them on `f64` and they compute, on polynomials and they prove.
//!
//! For `f64` alone, as they need an order or a logarithm, are [`principal_axes()`], [`possible_body()`], and the parameters of
//! bodies that are possible by construction, [`log_cholesky()`] and [`possible_inertia`].
//!
//! Vectors are columns of components along the axes named in each doc; SI units throughout.
//!
//! ```
//! use nalgebra::Vector3;
//! use polhode::mechanics::{Products, inertia, moment};
//! let body = inertia([2.0, 3.0, 4.0], [0.0, 0.5, 0.0], Products::Integrals);
//! let (omega, alpha) = (Vector3::new(0.0, 0.0, 2.0), Vector3::zeros());
//! // A shaft that spins steadily about z with the product of inertia I_xz wants a moment about y.
//! assert_eq!(moment(&body, &omega, &alpha), Vector3::new(0.0, -2.0, 0.0));
//! ```

mod attitude;
mod contact;
mod energy;
mod euler;
mod inertia;
mod inertial_loads;
mod linear;
mod log_cholesky;
mod momentum;
mod parallel_axis;
mod possible_body;
mod principal_axes;
mod regressor;
mod shapes;
mod spring;
mod transport;

pub use attitude::{
    attitude_rate, quaternion_conjugate, quaternion_product, quaternion_rate, rotation,
};
pub use contact::{
    acceleration_of_body_point, lowest_of_disc, lowest_of_sphere, velocity_of_body_point,
};
pub use energy::{kinetic_energy, power, vis_viva};
pub use euler::{angular_acceleration, euler_principal, moment, moment_components, moment_in_axes};
pub use inertia::{
    Products, inertia, inertia_in_axes, inertia_of_points, inertia_rate, symmetric_inertia,
};
pub use inertial_loads::{centrifugal_moment, coriolis_moment, euler_moment};
pub use linear::{adjugate, apply, cross, determinant, product, skew};
pub use log_cholesky::{
    TenParameters, inertial_parameters, log_cholesky, log_cholesky_of_inertia, possible_inertia,
};
pub use momentum::{angular_momentum, force, moment_about_moving_point, momentum_rate};
pub use parallel_axis::parallel_axis;
pub use possible_body::{ImpossibleInertia, possible_body};
pub use principal_axes::{PrincipalAxes, principal_axes};
pub use regressor::{InertiaParameters, regressor};
pub use shapes::{Moments, Shape, Size};
pub use spring::{spring_energy, spring_force};
pub use transport::{
    RelativeAcceleration, relative_acceleration, transport, transport_derived, transport_in_plane,
    transport_twice, velocity_in_moving_frame, velocity_in_moving_plane,
};
