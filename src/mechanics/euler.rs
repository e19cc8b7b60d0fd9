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

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mechanics::{Products, inertia, inertia_rate};

    #[test]
    fn components_are_the_transport_of_momentum() {
        let rate = Vector3::new(3, -1, 4);
        let (momentum, turn) = (Vector3::new(6, 2, -9), Vector3::new(-2, 7, 5));
        let lines = moment_components(&rate, &momentum, &turn);
        assert_eq!(Vector3::from(lines), transport(&rate, &turn, &momentum));
    }

    /// The lecture's lines with every product of inertia, typed in by hand: the thing to compare with.
    #[test]
    fn the_full_tensor_gives_the_hand_expanded_components() {
        let ([a, b, c], [d, e, f]) = ([11, 13, 17], [2, 3, 5]);
        let (w, o) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
        let m = moment(&inertia([a, b, c], [d, e, f], Products::Integrals), &w, &o);
        let x = a * o.x - d * o.y - e * o.z - (b - c) * w.y * w.z - e * w.x * w.y
            + d * w.x * w.z
            + f * (w.z * w.z - w.y * w.y);
        let y = b * o.y - d * o.x - f * o.z - (c - a) * w.z * w.x - d * w.y * w.z
            + f * w.x * w.y
            + e * (w.x * w.x - w.z * w.z);
        let z = c * o.z - e * o.x - f * o.y - (a - b) * w.x * w.y - f * w.x * w.z
            + e * w.y * w.z
            + d * (w.y * w.y - w.x * w.x);
        assert_eq!(m, Vector3::new(x, y, z));
    }

    /// The moment is one vector whatever the axes: with İ and Ω × L, any Ω gives the same as Ω = ω.
    #[test]
    fn the_moment_does_not_depend_on_how_the_axes_turn() {
        let body = inertia([11, 13, 17], [2, 3, 5], Products::Entries);
        let (omega, alpha) = (Vector3::new(7, -4, 9), Vector3::new(-6, 8, 1));
        for turn in [Vector3::zeros(), Vector3::new(3, 1, -2), omega] {
            let change = inertia_rate(&body, &omega, &turn);
            let seen = alpha - cross(&turn, &omega);
            assert_eq!(
                moment_in_axes(&body, &change, &omega, &seen, &turn),
                moment(&body, &omega, &alpha)
            );
        }
    }
}
