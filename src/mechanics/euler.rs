//! The equation of rotational motion, ΣM = (dL/dt)_xyz + Ω × L with L = I ω, and what follows from it.

use crate::mechanics::linear::apply;
use crate::mechanics::{adjugate, angular_momentum, cross, determinant, momentum_rate, transport};
use crate::scalar::{Field, Ring};
use nalgebra::{Matrix3, Vector3};

/// The moment about the mass centre or a fixed point, in axes of any angular velocity Ω:
/// `ΣM = (dL/dt)_xyz + Ω × L`, in N m.
///
/// All components along the axes xyz. `omega_rate` is the rate of the components of ω along them; the angular
/// acceleration is `omega_rate + Ω × ω`, the same only where Ω is along ω. For `inertia_rate` see
/// [`inertia_rate`](crate::mechanics::inertia_rate); it may be left zero only where the axes leave the tensor constant.
#[inline]
pub fn moment_in_axes<T: Ring>(
    inertia: &Matrix3<T>,
    inertia_rate: &Matrix3<T>,
    omega: &Vector3<T>,
    omega_rate: &Vector3<T>,
    frame_rate: &Vector3<T>,
) -> Vector3<T> {
    let rate = momentum_rate(inertia, inertia_rate, omega, omega_rate);
    transport(&rate, frame_rate, &angular_momentum(inertia, omega))
}

/// The moment that gives a body the angular acceleration α at the angular velocity ω: `ΣM = I α + ω × I ω`, in N m.
///
/// Body axes, Ω = ω, with all products of inertia; about the mass centre or a fixed point.
#[inline]
pub fn moment<T: Ring>(inertia: &Matrix3<T>, omega: &Vector3<T>, alpha: &Vector3<T>) -> Vector3<T> {
    moment_in_axes(inertia, &Matrix3::zeros(), omega, alpha, omega)
}

/// The moment from the components of the angular momentum and their rates, line by line:
/// `ΣM_x = L̇_x − L_y Ω_z + L_z Ω_y` and its two cyclic companions.
#[inline]
pub fn moment_components<T: Ring>(
    momentum_rate: &Vector3<T>,
    momentum: &Vector3<T>,
    frame_rate: &Vector3<T>,
) -> [T; 3] {
    let [x, y, z] = [0, 1, 2].map(|i| momentum[i].clone());
    let [turn_x, turn_y, turn_z] = [0, 1, 2].map(|i| frame_rate[i].clone());
    let [rate_x, rate_y, rate_z] = [0, 1, 2].map(|i| momentum_rate[i].clone());
    [
        rate_x - y.clone() * turn_z.clone() + z.clone() * turn_y.clone(),
        rate_y - z * turn_x.clone() + x.clone() * turn_z,
        rate_z - x * turn_y + y * turn_x,
    ]
}

/// Euler's equations, along principal axes of the body: `ΣM_x = I_x ω̇_x − (I_y − I_z) ω_y ω_z` and cyclic.
///
/// Euler 1758 (E292). `moments` are the principal moments in the order of the axes.
#[inline]
pub fn euler_principal<T: Ring>(
    moments: &Vector3<T>,
    omega: &Vector3<T>,
    alpha: &Vector3<T>,
) -> Vector3<T> {
    Vector3::from_fn(|x, _| {
        let (y, z) = ((x + 1) % 3, (x + 2) % 3);
        let difference = moments[y].clone() - moments[z].clone();
        moments[x].clone() * alpha[x].clone() - difference * omega[y].clone() * omega[z].clone()
    })
}

/// The angular acceleration under a moment: `α = I⁻¹ (M − ω × I ω)`, in rad/s², body axes.
///
/// By adjugate over determinant, so that no pivot branches on a value. The tensor must be regular; one of a body
/// with mass off every line is.
#[inline]
pub fn angular_acceleration<T: Field>(
    inertia: &Matrix3<T>,
    omega: &Vector3<T>,
    moment: &Vector3<T>,
) -> Vector3<T> {
    let net = moment - cross(omega, &angular_momentum(inertia, omega));
    let whole = determinant(inertia);
    apply(&adjugate(inertia), &net).map(|a| a / whole.clone())
}
