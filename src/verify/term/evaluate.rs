//! What quantities of places and wholes are in the variables of the model.

use crate::algebra::{Fraction, Place};
use crate::mechanics;
use crate::verify::model::atoms::{Motion, Nature, fraction, whole};
use crate::verify::model::bodies::Velocities;
use crate::verify::model::inertial_loads::Inertial;
use crate::verify::model::system::{FrameId, Matrix, PointId, System, Vector};
use crate::verify::term::quantity::{Quantity, Spot, Whole};
use crate::verify::term::value::{Basis, Value, Valued, beyond};
use num_traits::{One, Zero};

/// What the answer is of quantities for which there is no law yet.
pub(super) const NOT_WORKED_OUT: &str = "a quantity that is not worked out";

impl System {
    /// The value of a quantity that is made of another one.
    pub(super) fn composed(&mut self, quantity: &Quantity) -> Valued {
        Ok(match quantity {
            Quantity::Rate { of, seen } => {
                let value = self.value_of(of)?;
                self.rate_of_value(&value, *seen)?
            }
            Quantity::Along { of, axis } => {
                let axis = self.value_of(axis)?.to_vector()?;
                let value = self.value_of(of)?;
                Value::scalar(match value.is_matrix() {
                    true => axis.dot(&mechanics::apply(&value.to_matrix()?, &axis)),
                    false => axis.dot(&value.to_vector()?),
                })
            }
            Quantity::Part { of, axis, across } => {
                let axis = self.value_of(axis)?.to_vector()?;
                let vector = self.value_of(of)?.to_vector()?;
                let along = axis.clone() * (axis.dot(&vector) / axis.dot(&axis));
                let part = if *across { vector - along } else { along };
                Value::vector(&part, Basis::Itself)
            }
            Quantity::Component { of, axis, on } => {
                let vector = self.value_of(of)?.to_vector()?;
                let along = self.axis(*on, *axis);
                Value::scalar(along.dot(&vector))
            }
            Quantity::CrossProductMatrix(of) => self.value_of(of)?.cross_product_matrix()?,
            Quantity::On(of, frame) => {
                let mut value = self.value_of(of)?;
                value.basis = [Basis::On(*frame); 2];
                value
            }
            Quantity::Pair(of, frame, axes) => {
                let vector = self.value_of(of)?;
                self.on_two_axes(&vector, (*frame, *axes))?
            }
            Quantity::Scaled(of, factor) => self.value_of(of)?.scaled(factor),
            Quantity::Sum(terms) => {
                let mut sum = Value::scalar(Fraction::zero());
                for term in terms {
                    let value = self.value_of(term)?;
                    sum = self.plus(&sum, &value, self.work)?;
                }
                sum
            }
            measured => return self.measured(measured),
        })
    }

    /// Entries and distances.
    fn measured(&mut self, quantity: &Quantity) -> Valued {
        Ok(match quantity {
            Quantity::Entry {
                of,
                row,
                column,
                on,
                integral,
            } => {
                // A rotation matrix is an array: from components on one frame to those on another.
                if let Quantity::Rotation { from, to } = **of {
                    let (r, c) = (self.axis(to, *row), self.axis(from, *column));
                    return Ok(Value::scalar(r.dot(&c)));
                }
                let tensor = self.value_of(of)?.to_matrix()?;
                let (r, c) = (self.axis(*on, *row), self.axis(*on, *column));
                let entry = r.dot(&mechanics::apply(&tensor, &c));
                Value::scalar(if *integral && row != column {
                    -entry
                } else {
                    entry
                })
            }
            Quantity::Distance { of, from, axis } => {
                let way = self.place(of, *from);
                let axis = self.value_of(axis)?.to_vector()?;
                let across = mechanics::cross(&axis, &way);
                self.root(&across.dot(&across))?
            }
            _ => return beyond(NOT_WORKED_OUT),
        })
    }

    pub(super) fn named_vector(&mut self, text: &str, carried: Option<FrameId>) -> Vector {
        match carried {
            Some(frame) => self.carried_vector(text, frame, None),
            None => self.free_vector(text, Place::Coordinate, None),
        }
    }

    /// A vector of length one: its third component has a square that the others tell.
    pub(super) fn unit_vector(&mut self, text: &str, carried: Option<FrameId>) -> Vector {
        let vector = self.named_vector(text, carried);
        self.of_length_one(&vector);
        vector
    }

    /// The last component of a unit vector has a square that the others tell.
    pub(super) fn of_length_one(&mut self, vector: &Vector) {
        let Some(last) = vector[2].as_variable() else {
            return;
        };
        if self.atoms.atom(last).square.is_none() {
            let square = Fraction::one()
                - vector[0].clone() * vector[0].clone()
                - vector[1].clone() * vector[1].clone();
            self.atoms.atom_mut(last).square = Some(square.numerator().clone());
            self.atoms.atom_mut(last).nature = Nature::UnitPart(square.clone());
            if matches!(self.atoms.atom(last).motion, Motion::Free) {
                let rate = self.atoms.derivative(&square) / (whole(2) * fraction(last));
                self.atoms.atom_mut(last).motion = Motion::Rate(rate);
            }
        }
    }

    /// The position of a place from a point.
    pub(crate) fn place(&mut self, of: &Spot, from: PointId) -> Vector {
        match of {
            Spot::Point(point) => self.position(*point, from),
            Spot::Member(family, index) => self.member_position(*family, index, from),
            Spot::Carried(carried) => self.position(carried.at, from),
        }
    }

    pub(super) fn velocity_of(&mut self, of: &Spot, relative: FrameId) -> Vector {
        match of {
            Spot::Point(point) => self.velocity(*point, relative),
            Spot::Member(family, index) => {
                let way = self.member_position(*family, index, self.fixed_point(relative));
                self.rate_seen_from(relative, &way)
            }
            Spot::Carried(carried) => self.carried_velocity(*carried, relative),
        }
    }

    pub(super) fn acceleration_of(&mut self, of: &Spot, relative: FrameId) -> Vector {
        if let Spot::Carried(carried) = of {
            return self.carried_acceleration(*carried, relative);
        }
        let velocity = self.velocity_of(of, relative);
        self.rate_seen_from(relative, &velocity)
    }

    /// The force of a turning frame on a body or a member, or its moment about a point.
    pub(super) fn inertial_load(
        &mut self,
        kind: Inertial,
        of: &Whole,
        frame: FrameId,
        about: Option<PointId>,
    ) -> Vector {
        let (family, index) = match (of, about) {
            (Whole::Body(body), None) => return self.inertial_force(kind, *body, frame),
            (Whole::Body(body), Some(about)) => {
                return self.inertial_moment(kind, *body, frame, about);
            }
            (Whole::Member(family, index), _) => (*family, index),
        };
        let way = self.member_position(family, index, self.fixed_point(frame));
        let rate = self.rate_seen_from(frame, &way);
        let mass = self.member_mass(family, index);
        let force = self.inertial_field(kind, frame, &way, &rate) * mass;
        match about {
            Some(about) => mechanics::cross(&self.member_position(family, index, about), &force),
            None => force,
        }
    }

    pub(super) fn mass_of(&mut self, of: &Whole) -> Fraction {
        match of {
            Whole::Body(body) => self.mass(*body),
            Whole::Member(family, index) => self.member_mass(*family, index),
        }
    }

    pub(super) fn inertia_of(&mut self, of: &Whole, about: PointId) -> Matrix {
        match of {
            Whole::Body(body) => self.inertia(*body, about),
            Whole::Member(family, index) => {
                let way = self.member_position(*family, index, about);
                let mass = self.member_mass(*family, index);
                let none = Matrix::zeros();
                mechanics::parallel_axis(&none, &mass, &way)
            }
        }
    }

    pub(super) fn momentum_of(&mut self, of: &Whole, relative: FrameId) -> Vector {
        match of {
            Whole::Body(body) => self.momentum(*body, relative),
            Whole::Member(family, index) => {
                let spot = Spot::Member(*family, index.clone());
                let mass = self.member_mass(*family, index);
                self.velocity_of(&spot, relative) * mass
            }
        }
    }

    pub(super) fn angular_momentum_of(
        &mut self,
        of: &Whole,
        about: PointId,
        relative: FrameId,
        velocities: Velocities,
    ) -> Vector {
        match of {
            Whole::Body(body) => self.angular_momentum(*body, about, relative, velocities),
            Whole::Member(family, index) => {
                let spot = Spot::Member(*family, index.clone());
                let way = self.place(&spot, about);
                let mut velocity = self.velocity_of(&spot, relative);
                if velocities == Velocities::RelativeToPoint {
                    velocity -= self.velocity(about, relative);
                }
                let mass = self.member_mass(*family, index);
                mechanics::cross(&way, &velocity) * mass
            }
        }
    }

    pub(super) fn kinetic_energy_of(
        &mut self,
        of: &Whole,
        relative: FrameId,
        rotation: bool,
    ) -> Fraction {
        match of {
            Whole::Body(body) => self.kinetic_energy(*body, relative, rotation),
            Whole::Member(family, index) => {
                let velocity = self.velocity_of(&Spot::Member(*family, index.clone()), relative);
                let mass = self.member_mass(*family, index);
                Fraction::from_ratio(1, 2) * mass * velocity.dot(&velocity)
            }
        }
    }
}
