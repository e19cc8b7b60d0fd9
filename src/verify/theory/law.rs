//! The laws: each determines some variables from others, by running `mechanics` on fractions of polynomials.

use crate::algebra::{Fraction, Variable};
use crate::mechanics::{self, Products};
use crate::notation::ast::Function;
use crate::verify::theory::attitude_law;
use crate::verify::theory::more_moments::OtherMoments;
use crate::verify::theory::parallel_axes::{self, ParallelAxes};
use crate::verify::values::atoms::{Atom, Atoms, Entity, Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::subscript::step_index;
use crate::verify::values::symbol::MAGNITUDE;
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;

/// The axes on which components are taken.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Axes {
    /// They turn with the body: Ω = ω.
    Body,
    /// They turn with an angular velocity Ω of their own.
    Turning,
    /// They do not turn: Ω = 0.
    Space,
}

/// Which side of the moment equation is taken as known.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Dynamics {
    /// The motion is given, the moment follows.
    Inverse,
    /// The moment is given, the angular acceleration follows.
    Forward,
}

/// What the laws depend on besides the variables.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Setting {
    /// The axes used.
    pub axes: Axes,
    /// The sign convention of the written products of inertia.
    pub products: Products,
    /// The direction in which the moment equation is solved.
    pub dynamics: Dynamics,
    /// Whether the body keeps its shape, so that its inertia changes only with the axes.
    pub rigid: bool,
    /// Whether the body carries wheels with an angular momentum of their own.
    pub gyrostat: bool,
    /// Whether the only force spoken of is the one on the particle; else what it moves is for the document to say.
    pub newton: bool,
    /// Whether the velocity is that of the mass centre, which no position gives.
    pub drifts: bool,
    /// Whether the origin of the moving axes has a velocity that the document speaks of.
    pub origin_moves: bool,
    /// The velocity of the mass centre, where the kinetic energy has a part of it: T = ½ m v_G² + ½ ω·L (König).
    pub translation: Option<Entity>,
    /// The axis and the moment of inertia of the only wheel, where the kinetic energy is that of body and wheel.
    pub wheel_inertia: Option<(u8, Variable)>,
    /// What the kinetic energy of the parts of a body comes to, where a line gives its momentum by these.
    pub energy_of_parts: Option<Entity>,
    /// Moments that act beside the one that is written as the moment.
    pub other_moments: OtherMoments,
    /// Inertia about the mass centre and about another point: tensors, and moments about one axis.
    pub parallel_axes: [Option<ParallelAxes>; 2],
    /// The axis about which the equation of motion is of second order in what is called small, and dropped.
    pub dropped_axis: Option<u8>,
    /// What the attitude matrix and the quaternion take to what.
    pub attitude: attitude_law::Convention,
    /// Whether the document writes the attitude matrix out: the angular velocity then follows from it.
    pub attitude_given: bool,
    /// Whether sines and cosines are made of those of half the angle.
    pub half_angles: bool,
}

/// The inertia tensor in the variables of the document.
pub(crate) fn inertia(atoms: &mut Atoms, products: Products) -> Matrix3<Fraction> {
    let entity = atoms.quantity(Quantity::Inertia);
    tensor(atoms, entity, products)
}

/// A symmetric tensor by its six components.
pub(crate) fn tensor(atoms: &mut Atoms, entity: Entity, products: Products) -> Matrix3<Fraction> {
    let mut entry = |component| atoms.value(entity, component, 0);
    let (moments, products_of) = (
        [entry(0), entry(1), entry(2)],
        [entry(3), entry(4), entry(5)],
    );
    mechanics::inertia(moments, products_of, products)
}

/// A quantity's vector of derivatives of some order.
pub(crate) fn vector(atoms: &mut Atoms, quantity: Quantity, order: u8) -> Vector3<Fraction> {
    let entity = atoms.quantity(quantity);
    Vector3::from(atoms.vector(entity, order))
}

/// The law that determines a variable, and its value by that law; `None` for a free one.
pub(crate) fn law(
    atoms: &mut Atoms,
    setting: Setting,
    variable: Variable,
) -> Option<(&'static str, Fraction)> {
    match atoms.atom(variable).clone() {
        Atom::Part {
            entity,
            component,
            order,
        } => part(atoms, setting, entity, component, order),
        Atom::SpaceRate { of, component } => Some(("transport", atoms.transported(&of, component))),
        Atom::Kernel { .. } | Atom::Opaque { .. } => None,
    }
}

fn part(
    atoms: &mut Atoms,
    setting: Setting,
    entity: Entity,
    component: u8,
    order: u8,
) -> Option<(&'static str, Fraction)> {
    if let Some(base) = atoms.info(entity).in_body {
        let (name, mut value) = attitude_law::on_space_axes(atoms, setting, base, component);
        for _ in 0..order {
            value = atoms.derivative(&value);
        }
        return Some((name, value));
    }
    if let Some(found) = parallel_axes::law(atoms, setting, entity, (component, order)) {
        return Some(found);
    }
    let Owner::Quantity(quantity, variant) = atoms.info(entity).owner.clone() else {
        return None;
    };
    if variant == MAGNITUDE && order == 0 {
        let vector = vector(atoms, quantity, 0);
        let length = atoms.special(Atom::Kernel {
            function: Function::Sqrt,
            argument: vector.dot(&vector),
        });
        return Some(("magnitude", variable_fraction(length)));
    }
    if quantity == Quantity::Energy && order == 0 && step_index(&variant) {
        return energy_of_step(atoms, setting, &variant);
    }
    if !variant.is_empty() && variant != MAGNITUDE {
        return None;
    }
    if quantity == Quantity::Inertia {
        return (order > 0 && setting.rigid)
            .then(|| ("rigid", inertia_rate(atoms, setting, component, order)));
    }
    if matches!(quantity, Quantity::Attitude | Quantity::Quaternion) {
        return attitude_law::attitude(atoms, setting, quantity, (component, order));
    }
    if setting.attitude_given
        && let Some(found) =
            attitude_law::rate_of_matrix(atoms, setting, quantity, (component, order))
    {
        return Some(found);
    }
    if quantity == Quantity::AngularVelocity {
        return angular_acceleration(atoms, setting, component, order);
    }
    if order > 0 {
        let lower = atoms.part(entity, component, order - 1);
        let (name, value) = law(atoms, setting, lower)?;
        return Some((name, atoms.derivative(&value)));
    }
    determined(atoms, setting, quantity, usize::from(component))
}

/// T_k = ½ ω_k · I ω_k, where the angular velocity of that step is written.
fn energy_of_step(
    atoms: &mut Atoms,
    setting: Setting,
    step: &str,
) -> Option<(&'static str, Fraction)> {
    let owner = Owner::Quantity(Quantity::AngularVelocity, step.to_owned());
    let rate = atoms.entity_of_owner(&owner)?;
    let rate = Vector3::from(atoms.vector(rate, 0));
    let momentum = inertia(atoms, setting.products) * rate.clone();
    let half = Fraction::from_ratio(1, 2);
    Some(("energy", half * rate.dot(&momentum)))
}

/// Whether a rate has a law of its own, and not the rate of the law one order lower.
pub(crate) fn has_own_rate(atoms: &Atoms, entity: Entity, order: u8) -> bool {
    match &atoms.info(entity).owner {
        Owner::Quantity(quantity, _) => attitude_law::has_own_rate(*quantity, order),
        Owner::Symbol(_) => false,
    }
}

/// The velocity that momentum and acceleration are of.
fn moving(setting: Setting) -> Quantity {
    match setting.drifts {
        true => Quantity::CentreVelocity,
        false => Quantity::Velocity,
    }
}

/// The quantities that others determine, at order zero.
fn determined(
    atoms: &mut Atoms,
    setting: Setting,
    quantity: Quantity,
    component: usize,
) -> Option<(&'static str, Fraction)> {
    use Quantity::{
        Acceleration, AngularAcceleration, AngularVelocity, CentreVelocity, Energy, Force,
        FrameRate, LinearMomentum, Mass, Moment, Momentum, OriginVelocity, Position, Power,
        RelativeMomentum, Velocity,
    };
    match quantity {
        FrameRate if setting.axes == Axes::Body => Some((
            "body-axes",
            vector(atoms, AngularVelocity, 0)[component].clone(),
        )),
        FrameRate if setting.axes == Axes::Space => Some(("space-axes", Fraction::zero())),
        Momentum => {
            let (inertia, omega) = (
                inertia(atoms, setting.products),
                vector(atoms, AngularVelocity, 0),
            );
            let own = mechanics::angular_momentum(&inertia, &omega)[component].clone();
            Some(match setting.gyrostat {
                true => (
                    "gyrostat",
                    own + vector(atoms, RelativeMomentum, 0)[component].clone(),
                ),
                false => ("inertia", own),
            })
        }
        Moment if setting.dynamics == Dynamics::Inverse => {
            let others = setting.other_moments.sum(atoms, component as u8);
            Some(("moment", space_rate(atoms, Momentum, component) - others))
        }
        OriginVelocity if !setting.origin_moves => Some(("origin at rest", Fraction::zero())),
        Energy => {
            if let Some(whole) = setting.energy_of_parts {
                return Some(("energy", atoms.value(whole, 0, 0)));
            }
            let half = Fraction::from_ratio(1, 2);
            let omega = vector(atoms, AngularVelocity, 0);
            // Of the body alone: what its wheels have beside depends on how they are made.
            let momentum = match setting.gyrostat {
                true => mechanics::angular_momentum(&inertia(atoms, setting.products), &omega),
                false => vector(atoms, Momentum, 0),
            };
            let mut turning = half.clone() * omega.dot(&momentum);
            if let Some((axis, inertia)) = setting.wheel_inertia {
                let stored = vector(atoms, RelativeMomentum, 0);
                let own = stored[usize::from(axis)].clone();
                let own = own.clone() * own / variable_fraction(inertia);
                turning += omega.dot(&stored) + half.clone() * own;
            }
            let Some(centre) = setting.translation else {
                return Some(("energy", turning));
            };
            let square = match atoms.info(centre).shape {
                Shape::Scalar => {
                    let speed = atoms.value(centre, 0, 0);
                    speed.clone() * speed
                }
                _ => {
                    let velocity = Vector3::from(atoms.vector(centre, 0));
                    velocity.dot(&velocity)
                }
            };
            let mass = atoms.quantity(Mass);
            let mass = atoms.value(mass, 0, 0);
            Some(("koenig", half * mass * square + turning))
        }
        Power => {
            let (omega, moment) = (vector(atoms, AngularVelocity, 0), vector(atoms, Moment, 0));
            Some(("energy", moment.dot(&omega)))
        }
        AngularAcceleration => Some((
            "kinematics",
            vector(atoms, AngularVelocity, 1)[component].clone(),
        )),
        Velocity => {
            let origin = vector(atoms, OriginVelocity, 0)[component].clone();
            Some((
                "kinematics",
                origin + space_rate(atoms, Position, component),
            ))
        }
        Acceleration => {
            let velocity = moving(setting);
            Some(("kinematics", space_rate(atoms, velocity, component)))
        }
        Force if setting.newton => {
            let mass = atoms.quantity(Mass);
            let mass = atoms.value(mass, 0, 0);
            let acceleration = match setting.drifts {
                true => space_rate(atoms, CentreVelocity, component),
                false => vector(atoms, Acceleration, 0)[component].clone(),
            };
            Some(("newton", mass * acceleration))
        }
        LinearMomentum => {
            let mass = atoms.quantity(Mass);
            let mass = atoms.value(mass, 0, 0);
            let velocity = moving(setting);
            Some((
                "kinematics",
                mass * vector(atoms, velocity, 0)[component].clone(),
            ))
        }
        _ => None,
    }
}

/// The rate of a quantity seen from space, as a variable that the transport law determines.
fn space_rate(atoms: &mut Atoms, quantity: Quantity, component: usize) -> Fraction {
    let entity = atoms.quantity(quantity);
    let of = Box::new(atoms.vector(entity, 0));
    variable_fraction(atoms.special(Atom::SpaceRate {
        of,
        component: component as u8,
    }))
}

/// ω̇ by the moment equation, where the moment is what is known.
fn angular_acceleration(
    atoms: &mut Atoms,
    setting: Setting,
    component: u8,
    order: u8,
) -> Option<(&'static str, Fraction)> {
    if setting.dynamics == Dynamics::Inverse || order == 0 {
        return None;
    }
    let inertia = inertia(atoms, setting.products);
    let omega = vector(atoms, Quantity::AngularVelocity, 0);
    let written = vector(atoms, Quantity::Moment, 0);
    let others = Vector3::from([0, 1, 2].map(|c| setting.other_moments.sum(atoms, c)));
    let mut moment = written + others;
    if setting.gyrostat {
        let wheels = vector(atoms, Quantity::RelativeMomentum, 0);
        let rate = vector(atoms, Quantity::RelativeMomentum, 1);
        moment -= mechanics::transport(&rate, &omega, &wheels);
    }
    let alpha = mechanics::angular_acceleration(&inertia, &omega, &moment);
    let mut value = alpha[usize::from(component)].clone();
    for _ in 1..order {
        value = atoms.derivative(&value);
    }
    Some(("moment", value))
}

/// İ on the axes used: zero where they turn with the body.
fn inertia_rate(atoms: &mut Atoms, setting: Setting, component: u8, order: u8) -> Fraction {
    if setting.axes == Axes::Body {
        return Fraction::zero();
    }
    let tensor = inertia(atoms, setting.products);
    let omega = vector(atoms, Quantity::AngularVelocity, 0);
    let frame_rate = vector(atoms, Quantity::FrameRate, 0);
    let rate = mechanics::inertia_rate(&tensor, &omega, &frame_rate);
    let (row, column) = INERTIA_ENTRIES[usize::from(component)];
    let mut value = rate[(row, column)].clone();
    if row != column && setting.products == Products::Integrals {
        value = -value;
    }
    for _ in 1..order {
        value = atoms.derivative(&value);
    }
    value
}

/// Row and column of the components of a symmetric tensor, in the order xx, yy, zz, xy, xz, yz.
pub(crate) const INERTIA_ENTRIES: [(usize, usize); 6] =
    [(0, 0), (1, 1), (2, 2), (0, 1), (0, 2), (1, 2)];
