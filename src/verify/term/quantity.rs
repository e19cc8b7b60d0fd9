//! The quantities of mechanics as functions on the system: of what, about what, seen from where, on which axes.

use crate::algebra::{Fraction, Place};
use crate::mechanics;
use crate::verify::model::atoms::{Key, Law, Motion, fraction};
use crate::verify::model::bodies::Velocities;
use crate::verify::model::contact::Carried;
use crate::verify::model::inertial_loads::Inertial;
use crate::verify::model::system::{
    BodyId, FamilyId, FrameId, KeptApart, PointId, System, Vector, component_text,
};
use crate::verify::term::value::{Basis, Trouble, Value, Valued};

/// The law of what is told by a rule.
pub(crate) const BY_RULE: &str = "period";

/// A place: a point, or a member of a family.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Spot {
    Point(PointId),
    Member(FamilyId, String),
    /// The point of a body that is at a place now.
    Carried(Carried),
}

/// A thing with mass: a body, or a member of a family.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Whole {
    Body(BodyId),
    Member(FamilyId, String),
}

/// What a letter denotes.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Quantity {
    Position {
        of: Spot,
        from: PointId,
    },
    Velocity {
        of: Spot,
        relative: FrameId,
    },
    Acceleration {
        of: Spot,
        relative: FrameId,
    },
    AngularVelocity {
        of: FrameId,
        relative: FrameId,
    },
    Mass(Whole),
    Inertia {
        of: Whole,
        about: PointId,
    },
    Momentum {
        of: Whole,
        relative: FrameId,
    },
    AngularMomentum {
        of: Whole,
        about: PointId,
        relative: FrameId,
        velocities: Velocities,
    },
    KineticEnergy {
        of: Whole,
        relative: FrameId,
        rotation: bool,
    },
    Force(Whole),
    ExternalForce(FamilyId, String),
    /// The volume of a member, and its mass by that.
    Volume(FamilyId, String),
    Density(FamilyId, String),
    /// The force of a turning frame, or its moment about a point.
    InertialForce {
        kind: Inertial,
        of: Whole,
        frame: FrameId,
        about: Option<PointId>,
    },
    Moment {
        of: BodyId,
        about: PointId,
    },
    /// A force by its letter, at a place, and its moment about a point.
    MomentOf {
        force: Box<Quantity>,
        at: Spot,
        about: PointId,
    },
    /// The rate of another quantity, seen from a frame; of an array entry by entry.
    Rate {
        of: Box<Quantity>,
        seen: FrameId,
    },
    /// The component of a vector along a unit vector; of a tensor the moment about it.
    Along {
        of: Box<Quantity>,
        axis: Box<Quantity>,
    },
    /// The part of a vector along another one, or what is left of it across.
    Part {
        of: Box<Quantity>,
        axis: Box<Quantity>,
        across: bool,
    },
    /// A component of a vector on the axes of a frame.
    Component {
        of: Box<Quantity>,
        axis: usize,
        on: FrameId,
    },
    /// An entry of a tensor on the axes of a frame, with the sign of the convention.
    Entry {
        of: Box<Quantity>,
        row: usize,
        column: usize,
        on: FrameId,
        integral: bool,
    },
    /// The distance of a place from an axis through a point.
    Distance {
        of: Spot,
        from: PointId,
        axis: Box<Quantity>,
    },
    Magnitude(Box<Quantity>),
    /// The axis of a frame.
    Axis(FrameId, usize),
    /// The matrix that takes components on one frame to components on another.
    Rotation {
        from: FrameId,
        to: FrameId,
    },
    CrossProductMatrix(Box<Quantity>),
    Identity,
    /// A vector of which no more is known than the frame that carries it, if one does.
    Vector {
        text: String,
        carried: Option<FrameId>,
    },
    UnitVector {
        text: String,
        carried: Option<FrameId>,
    },
    /// A scalar by its letter.
    Scalar {
        text: String,
        constant: bool,
    },
    /// A constant of the member of a family.
    MemberScalar {
        text: String,
        index: String,
    },
    /// A unit vector of the member of a family.
    MemberVector {
        text: String,
        carried: Option<FrameId>,
        index: String,
    },
    /// Components on a frame in place of the vector.
    On(Box<Quantity>, FrameId),
    /// The column of the components of a vector on two axes of a frame.
    Pair(Box<Quantity>, FrameId, [usize; 2]),
    /// Something already worked out.
    Known(Value),
    /// The same by a rule, as a period: what a line says of it is more than what its letter means.
    ByRule(Value),
    Scaled(Box<Quantity>, Fraction),
    Sum(Vec<Quantity>),
}

impl Quantity {
    pub(crate) fn boxed(self) -> Box<Self> {
        Box::new(self)
    }

    /// The law that gives its value, by the name that appears in `uses`.
    fn law(&self) -> &'static str {
        match self {
            Self::Position { .. } | Self::Velocity { .. } | Self::Acceleration { .. } => {
                "kinematics"
            }
            Self::AngularVelocity { .. } => "angular velocity",
            Self::Inertia { .. } | Self::Mass(_) => "inertia",
            Self::Momentum { .. } | Self::AngularMomentum { .. } => "inertia",
            Self::KineticEnergy { .. } => "energy",
            Self::Force(_) | Self::ExternalForce(..) => "newton",
            Self::InertialForce { .. } => "transport",
            Self::Moment { .. } | Self::MomentOf { .. } => "moment",
            Self::Rotation { .. } => "attitude",
            Self::Rate { of, .. }
            | Self::Along { of, .. }
            | Self::Part { of, .. }
            | Self::Component { of, .. }
            | Self::Entry { of, .. }
            | Self::On(of, _)
            | Self::Pair(of, ..)
            | Self::Scaled(of, _) => of.law(),
            Self::ByRule(_) => BY_RULE,
            _ => "definition",
        }
    }

    /// The frame on whose axes it is a component or an array.
    pub(crate) fn frame(&self) -> Option<FrameId> {
        match self {
            Self::Component { on, .. } | Self::Entry { on, .. } | Self::On(_, on) => Some(*on),
            Self::Pair(_, on, _) => Some(*on),
            Self::Scaled(of, _) => of.frame(),
            _ => None,
        }
    }
}

impl System {
    /// The value of a letter: variables with its name, told by the law that gives the quantity.
    pub(crate) fn letter(&mut self, text: &str, quantity: &Quantity) -> Valued {
        let value = self.value_of(quantity)?;
        let is_put_in = match quantity {
            Quantity::Known(_) | Quantity::Sum(_) => true,
            Quantity::ByRule(_) => self.apart == KeptApart::Sums,
            other => other.is_indexed(),
        };
        if is_put_in {
            return Ok(value);
        }
        let is_told = !matches!(quantity.law(), "definition" | "attitude");
        let highest = match self.apart {
            KeptApart::Sums => u32::MAX,
            KeptApart::Variables if is_told => 0,
            KeptApart::Terms | KeptApart::Variables => 1,
        };
        let simple = |e: &Fraction| {
            let mut terms = e.numerator().terms().iter();
            e.numerator().len() <= 1
                && e.is_polynomial()
                && terms.all(|(m, _)| m.degree() <= highest)
        };
        if value.entries.iter().all(simple) {
            return Ok(value);
        }
        let name = quantity.law();
        let columns = value.columns;
        let entries = value.entries.iter().enumerate().map(|(at, entry)| {
            if simple(entry) {
                return entry.clone();
            }
            let text = match (value.is_scalar(), columns) {
                (true, _) => text.to_owned(),
                (_, 1) => component_text(text, at),
                _ => {
                    let (row, column) = value.earlier_place(at);
                    format!("{{{text}}}_{{{}{}}}", row + 1, column + 1)
                }
            };
            let law = Law {
                name,
                value: entry.clone(),
            };
            fraction(self.atoms.determined(&text, place_of(quantity), law))
        });
        let entries = entries.collect();
        Ok(Value { entries, ..value })
    }

    /// The value of a quantity in the variables of the model.
    pub(crate) fn value_of(&mut self, quantity: &Quantity) -> Valued {
        if self.dimensions() != 3 {
            return self.value_in_space(quantity);
        }
        let itself = |vector: Vector| Value::vector(&vector, Basis::Itself);
        Ok(match quantity {
            Quantity::Position { of, from } => itself(self.place(of, *from)),
            Quantity::Velocity { of, relative } => itself(self.velocity_of(of, *relative)),
            Quantity::Acceleration { of, relative } => itself(self.acceleration_of(of, *relative)),
            Quantity::AngularVelocity { of, relative } => {
                itself(self.angular_velocity(*of, *relative))
            }
            Quantity::Magnitude(of) => {
                let vector = self.value_of(of)?.to_vector()?;
                self.root(&vector.dot(&vector))?
            }
            Quantity::Axis(frame, axis) => itself(self.axis(*frame, *axis)),
            Quantity::Rotation { from, to } => self.identity([Basis::On(*to), Basis::On(*from)]),
            Quantity::Identity => self.identity([Basis::Any; 2]),
            Quantity::Known(value) | Quantity::ByRule(value) => value.clone(),
            of_body => return self.value_of_whole(of_body),
        })
    }

    /// The value of a quantity of a thing with mass.
    fn value_of_whole(&mut self, quantity: &Quantity) -> Valued {
        let itself = |vector: Vector| Value::vector(&vector, Basis::Itself);
        Ok(match quantity {
            Quantity::Mass(of) => Value::scalar(self.mass_of(of)),
            Quantity::Volume(family, index) => Value::scalar(self.member_volume(*family, index)),
            Quantity::Density(family, index) => Value::scalar(self.member_density(*family, index)),
            Quantity::Inertia { of, about } => {
                let tensor = self.inertia_of(of, *about);
                Value::matrix(&tensor, [Basis::Itself; 2])
            }
            Quantity::Momentum { of, relative } => itself(self.momentum_of(of, *relative)),
            Quantity::AngularMomentum {
                of,
                about,
                relative,
                velocities,
            } => itself(self.angular_momentum_of(of, *about, *relative, *velocities)),
            Quantity::KineticEnergy {
                of,
                relative,
                rotation,
            } => Value::scalar(self.kinetic_energy_of(of, *relative, *rotation)),
            Quantity::Force(of) => {
                let momentum = self.momentum_of(of, self.ground);
                itself(self.rate_seen_from(self.ground, &momentum))
            }
            Quantity::ExternalForce(family, index) => itself(self.member_force(*family, index)),
            Quantity::InertialForce {
                kind,
                of,
                frame,
                about,
            } => itself(self.inertial_load(*kind, of, *frame, *about)),
            Quantity::Moment { of, about } => itself(self.total_moment(*of, *about)),
            Quantity::MomentOf { force, at, about } => {
                let force = self.value_of(force)?.to_vector()?;
                let arm = self.place(at, *about);
                itself(mechanics::cross(&arm, &force))
            }
            letter => return self.value_of_letter(letter),
        })
    }

    /// The value of a letter that stands for itself.
    pub(super) fn value_of_letter(&mut self, quantity: &Quantity) -> Valued {
        let itself = |vector: Vector| Value::vector(&vector, Basis::Itself);
        Ok(match quantity {
            Quantity::Vector { text, carried } => itself(self.named_vector(text, *carried)),
            Quantity::UnitVector { text, carried } => itself(self.unit_vector(text, *carried)),
            Quantity::Scalar { text, constant } => {
                let (place, motion) = match constant {
                    true => (Place::Parameter, Motion::Constant),
                    false => (Place::Coordinate, Motion::Free),
                };
                let letter = self.atoms.variable(Key::of_number(text), place, motion);
                if *constant {
                    self.atoms.hold_by_word(letter);
                }
                Value::scalar(fraction(letter))
            }
            Quantity::MemberScalar { text, index } => {
                let key = Key::of_member(text, index);
                Value::scalar(fraction(self.atoms.variable(
                    key,
                    Place::Parameter,
                    Motion::Constant,
                )))
            }
            Quantity::MemberVector {
                text,
                carried,
                index,
            } => {
                let frame = carried.unwrap_or(self.ground);
                let vector = self.carried_vector(text, frame, Some(index));
                self.of_length_one(&vector);
                itself(vector)
            }
            composed => return self.composed(composed),
        })
    }
}

fn place_of(quantity: &Quantity) -> Place {
    match quantity {
        Quantity::Mass(_)
        | Quantity::Inertia { .. }
        | Quantity::Entry { .. }
        | Quantity::Along { .. }
        | Quantity::ByRule(_) => Place::Parameter,
        Quantity::Position { .. } | Quantity::Rotation { .. } | Quantity::Axis(..) => {
            Place::Coordinate
        }
        Quantity::Force(_)
        | Quantity::InertialForce { .. }
        | Quantity::Moment { .. }
        | Quantity::MomentOf { .. } => Place::Acceleration,
        _ => Place::Rate,
    }
}

impl From<Trouble> for String {
    fn from(trouble: Trouble) -> Self {
        match trouble {
            Trouble::Unknown(letter) => format!("nothing says what `{letter}` is"),
            Trouble::IllTyped(message) | Trouble::Beyond(message) => message,
        }
    }
}
