//! The laws of attitude: a matrix that turns and stays a rotation, a quaternion that turns and stays a unit, and
//! components on space axes.
//!
//! The matrix is a polynomial in the quaternion, and the quaternion keeps |q|² = 1, from which the square of its scalar
//! part is put in. So both keep their relations exactly.

use crate::algebra::{Fraction, Variable};
use crate::mechanics;
use crate::verify::theory::law::{Axes, Setting, inertia, vector};
use crate::verify::values::atoms::{Atom, Atoms, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use nalgebra::{Matrix3, Vector3, Vector4};
use num_traits::{One, Zero};

/// What a document means by its matrix and its quaternion.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq, Hash, PartialOrd, Ord)]
pub(crate) struct Convention {
    /// The matrix takes components in space to components in the body.
    pub matrix_to_body: bool,
    /// The quaternion takes components in space to components in the body.
    pub quaternion_to_body: bool,
    /// The components of the angular velocity are those on space axes.
    pub rate_in_space: bool,
}

/// The law of a component of the attitude matrix or of the quaternion; `None` for the quaternion itself.
pub(crate) fn attitude(
    atoms: &mut Atoms,
    setting: Setting,
    quantity: Quantity,
    (component, order): (u8, u8),
) -> Option<(&'static str, Fraction)> {
    if setting.attitude_given && quantity == Quantity::Attitude {
        return None;
    }
    let entity = atoms.quantity(quantity);
    if order > 1 {
        let lower = atoms.part(entity, component, 1);
        let (name, mut value) = crate::verify::theory::law::law(atoms, setting, lower)?;
        for _ in 1..order {
            value = atoms.derivative(&value);
        }
        return Some((name, value));
    }
    let at = usize::from(component);
    match (quantity, order) {
        (Quantity::Attitude, 0) => {
            let turned = mechanics::rotation(&to_space(atoms, setting));
            let value = if setting.attitude.matrix_to_body {
                turned.transpose()
            } else {
                turned
            };
            Some(("rotation", value[(at / 3, at % 3)].clone()))
        }
        (Quantity::Attitude, _) => Some((
            "attitude",
            matrix_rate(atoms, setting)[(at / 3, at % 3)].clone(),
        )),
        (Quantity::Quaternion, 1) => {
            Some(("attitude", quaternion_rate(atoms, setting)[at].clone()))
        }
        _ => None,
    }
}

/// Whether a rate has a law of its own, and not the rate of the law one order lower.
pub(crate) fn has_own_rate(quantity: Quantity, order: u8) -> bool {
    matches!(quantity, Quantity::Attitude | Quantity::Quaternion) && order == 1
}

/// The components of the matrix as written, body to space or the reverse.
fn written(atoms: &mut Atoms) -> Matrix3<Fraction> {
    let entity = atoms.quantity(Quantity::Attitude);
    Matrix3::from_fn(|r, c| atoms.value(entity, (3 * r + c) as u8, 0))
}

/// The matrix from components in the body to components in space.
pub(crate) fn body_to_space(atoms: &mut Atoms, setting: Setting) -> Matrix3<Fraction> {
    let matrix = written(atoms);
    if setting.attitude.matrix_to_body {
        matrix.transpose()
    } else {
        matrix
    }
}

fn quaternion(atoms: &mut Atoms) -> Vector4<Fraction> {
    let entity = atoms.quantity(Quantity::Quaternion);
    Vector4::from_fn(|i, _| atoms.value(entity, i as u8, 0))
}

/// The quaternion from components in the body to components in space.
fn to_space(atoms: &mut Atoms, setting: Setting) -> Vector4<Fraction> {
    let written = quaternion(atoms);
    if setting.attitude.quaternion_to_body {
        mechanics::quaternion_conjugate(&written)
    } else {
        written
    }
}

/// The angular velocity that turns what the attitude is of: the axes used, or the body seen from space.
fn turning(atoms: &mut Atoms, setting: Setting) -> Vector3<Fraction> {
    vector(atoms, turning_quantity(setting), 0)
}

fn turning_quantity(setting: Setting) -> Quantity {
    match setting.axes {
        Axes::Body | Axes::Space => Quantity::AngularVelocity,
        Axes::Turning => Quantity::FrameRate,
    }
}

/// Ṙ = R \[ω\]× for ω on body axes and R from body to space, and the same law in the other readings.
fn matrix_rate(atoms: &mut Atoms, setting: Setting) -> Matrix3<Fraction> {
    let (matrix, omega) = (written(atoms), turning(atoms, setting));
    let Convention {
        matrix_to_body,
        rate_in_space,
        ..
    } = setting.attitude;
    let omega = if matrix_to_body { -omega } else { omega };
    if matrix_to_body == rate_in_space {
        mechanics::attitude_rate(&matrix, &omega)
    } else {
        mechanics::product(&mechanics::skew(&omega), &matrix)
    }
}

/// The angular velocity of an attitude that is written out, \[ω\]× = RᵀṘ, and its rates; `None` for other quantities.
pub(crate) fn rate_of_matrix(
    atoms: &mut Atoms,
    setting: Setting,
    quantity: Quantity,
    (component, order): (u8, u8),
) -> Option<(&'static str, Fraction)> {
    if quantity != turning_quantity(setting) {
        return None;
    }
    let matrix = body_to_space(atoms, setting);
    let rate = matrix.map(|entry| atoms.derivative(&entry));
    let skew = match setting.attitude.rate_in_space {
        true => mechanics::product(&rate, &matrix.transpose()),
        false => mechanics::product(&matrix.transpose(), &rate),
    };
    let at = usize::from(component);
    let mut value = skew[((at + 2) % 3, (at + 1) % 3)].clone();
    for _ in 0..order {
        value = atoms.derivative(&value);
    }
    Some(("attitude", value))
}

/// q̇ = ½ q ω for ω on body axes and q from body to space, and the same law in the other readings.
fn quaternion_rate(atoms: &mut Atoms, setting: Setting) -> Vector4<Fraction> {
    let (q, omega) = (quaternion(atoms), turning(atoms, setting));
    let Convention {
        quaternion_to_body,
        rate_in_space,
        ..
    } = setting.attitude;
    let omega = if quaternion_to_body { -omega } else { omega };
    if quaternion_to_body == rate_in_space {
        return mechanics::quaternion_rate(&q, &omega);
    }
    let pure = omega.insert_row(0, Fraction::zero());
    mechanics::quaternion_product(&pure, &q).map(|r| r * Fraction::from_ratio(1, 2))
}

/// The name of the law |q|² = 1.
pub(crate) const UNIT: &str = "unit quaternion";

/// What the square of the scalar part is, 1 − x² − y² − z²; `None` for any other variable.
pub(crate) fn square_of_scalar_part(atoms: &mut Atoms, variable: Variable) -> Option<Fraction> {
    let (entity, 0) = number_of_quaternion(atoms, variable)? else {
        return None;
    };
    let square = |x: Fraction| x.clone() * x;
    let parts = [1, 2, 3].map(|i| square(atoms.value(entity, i, 0)));
    Some(parts.into_iter().fold(Fraction::one(), |rest, p| rest - p))
}

/// Which number of the attitude quaternion a variable is.
pub(crate) fn number_of_quaternion(atoms: &Atoms, variable: Variable) -> Option<(Entity, u8)> {
    let Atom::Part {
        entity,
        component,
        order: 0,
    } = *atoms.atom(variable)
    else {
        return None;
    };
    let of_attitude = Owner::Quantity(Quantity::Quaternion, String::new());
    (atoms.info(entity).owner == of_attitude).then_some((entity, component))
}

/// A component on space axes of a vector or a tensor that is known on body axes: R a, or R I Rᵀ.
pub(crate) fn on_space_axes(
    atoms: &mut Atoms,
    setting: Setting,
    base: Entity,
    component: u8,
) -> (&'static str, Fraction) {
    let turn = body_to_space(atoms, setting);
    let at = usize::from(component);
    let value = match atoms.info(base).shape {
        Shape::Symmetric => {
            let tensor = inertia(atoms, setting.products);
            turned_tensor(&turn, &tensor, at)
        }
        Shape::Matrix => {
            let tensor = Matrix3::from_fn(|r, c| atoms.value(base, (3 * r + c) as u8, 0));
            turned_tensor(&turn, &tensor, at)
        }
        _ => {
            let vector = Vector3::from(atoms.vector(base, 0));
            mechanics::apply(&turn, &vector)[at % 3].clone()
        }
    };
    ("components in space", value)
}

fn turned_tensor(turn: &Matrix3<Fraction>, tensor: &Matrix3<Fraction>, at: usize) -> Fraction {
    let turned = mechanics::product(&mechanics::product(turn, tensor), &turn.transpose());
    turned[((at / 3) % 3, at % 3)].clone()
}
