//! Frames, points, bodies and families of members, and the variables that their quantities are written in.
//!
//! Every vector is worked with by its components on one frame, the work frame, and every rate of components is the rate
//! seen from it. What another frame sees follows by the transport law.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::model::atoms::{Atoms, Key, Motion, fraction};
use crate::verify::model::common_list::CommonList;
use crate::verify::model::contact::{Contact, Plane, Round};
use crate::verify::model::loads::Load;
use nalgebra::{Matrix3, Vector3};
use num_traits::Zero;

use crate::algebra::Place;

/// Components on the work frame.
pub(crate) type Vector = Vector3<Fraction>;
/// Entries on the work frame.
pub(crate) type Matrix = Matrix3<Fraction>;

/// A frame of the system, by its place in the list.
pub(crate) type FrameId = usize;
/// A point of the system.
pub(crate) type PointId = usize;
/// A body of the system.
pub(crate) type BodyId = usize;
/// A family of like members, numbered by an index.
pub(crate) type FamilyId = usize;

/// An axis about which one frame turns against another.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Axis {
    /// The axis of this number, the same on both frames.
    Number(usize),
    /// A unit vector.
    Along(Box<Vector>),
}

/// How a frame is turned against its parent.
#[derive(Clone, Debug, PartialEq)]
pub(crate) enum Turn {
    /// Not at all, at any time.
    Fixed,
    /// In any way.
    Free,
    /// By an angle about an axis that both frames share.
    Angle(usize, Box<Fraction>),
    /// By an angle about a unit vector, whose components on both frames are the same.
    About(Box<Vector>, Box<Fraction>),
    /// At a rate about an axis.
    Rate(Axis, Box<Fraction>),
}

impl Turn {
    /// The number of the axis that it is about, which both frames share.
    pub(crate) fn axis(&self) -> Option<usize> {
        match self {
            Self::Angle(axis, _) | Self::Rate(Axis::Number(axis), _) => Some(*axis),
            Self::Fixed | Self::Free | Self::About(..) | Self::Rate(Axis::Along(_), _) => None,
        }
    }
}

/// A frame.
#[derive(Clone, Debug)]
pub(crate) struct Frame {
    /// Its name.
    pub(crate) name: String,
    /// The frame that it is turned against; the first frame has none.
    pub(crate) parent: Option<FrameId>,
    /// How.
    pub(crate) turn: Turn,
    /// Whether a sentence speaks of the quaternion of its turn.
    pub(crate) by_quaternion: bool,
}

/// A point.
#[derive(Clone, Debug)]
pub(crate) struct Point {
    /// Its name.
    pub(crate) name: String,
    /// The point that it is placed from, and the way there; the origin has none.
    pub(crate) placed: Option<(PointId, Vector)>,
    /// The frames that it is fixed in.
    pub(crate) fixed_in: Vec<FrameId>,
}

/// A body.
#[derive(Clone, Debug)]
pub(crate) struct Body {
    /// Its name.
    pub(crate) name: String,
    /// The frame fixed in it; `None` for a particle.
    pub(crate) frame: Option<FrameId>,
    /// Its mass centre.
    pub(crate) centre: PointId,
    /// Its mass.
    pub(crate) mass: Fraction,
    /// Its inertia tensor about the base point, once it was asked for.
    pub(crate) inertia: Option<Matrix>,
    /// The point of it about which its tensor is told, where that is not the mass centre.
    pub(crate) base: Option<PointId>,
    /// The bodies that it is made of; empty for one that is a whole.
    pub(crate) parts: Vec<BodyId>,
    /// Wheels that are part of it and do not change its inertia.
    pub(crate) rotors: Option<Rotors>,
    /// Along what it is long.
    pub(crate) line: Option<Line>,
    /// The names of its ends: those that are fixed in space first.
    pub(crate) ends: Vec<String>,
    /// By what it touches planes, if it is round.
    pub(crate) round: Option<Round>,
    /// The index of the family for each of whose members it stands: what is said of it is said of all.
    pub(crate) members: Option<String>,
}

/// Along what a body is long: from its first end to the other.
#[derive(Clone, Copy, Debug, PartialEq)]
pub(crate) struct Line {
    /// The axis of its frame.
    pub(crate) axis: usize,
    /// Whether it goes against that.
    pub(crate) reversed: bool,
    /// Whether the places of its ends or its middle tell it.
    pub(crate) by_points: bool,
}

impl Body {
    /// Whether it is a particle: no frame is fixed in it, and it is no whole of several bodies.
    pub(crate) fn is_particle(&self) -> bool {
        self.frame.is_none() && self.parts.is_empty()
    }
}

/// A family of symmetric wheels that turn about axes fixed in a body.
#[derive(Clone, Debug)]
pub(crate) struct Rotors {
    /// The index of a member.
    pub(crate) index: String,
    /// The unit vector along the axis of a member.
    pub(crate) axis: Vector,
    /// Its rate relative to the body.
    pub(crate) rate: Fraction,
    /// Its moment of inertia about the axis.
    pub(crate) inertia: Fraction,
}

/// The name of the family of the elements over which integrals run.
pub(crate) const ELEMENT: &str = "element";

/// Like members of a body: its particles, its wheels.
#[derive(Clone, Debug)]
pub(crate) struct Family {
    /// `particle`, `wheel`, `element`.
    pub(crate) name: String,
    /// The body that they make up or belong to.
    pub(crate) body: Option<BodyId>,
    /// The letters that number them.
    pub(crate) indices: Vec<String>,
    /// The body that stands for each of them, where they move on their own.
    pub(crate) member: Option<BodyId>,
    /// The density of each, where it is the same.
    pub(crate) density: Option<Fraction>,
}

/// Two axes of a frame on which columns of two hold components.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct AxisPair {
    pub(crate) frame: FrameId,
    pub(crate) axes: [usize; 2],
    /// Whether a sentence says so of all columns of two, and not only that what moves does so in the plane of both.
    pub(crate) told: bool,
}

/// All that a document speaks of.
#[derive(Clone, Debug, Default)]
pub(crate) struct System {
    pub(crate) atoms: Atoms,
    pub(crate) frames: CommonList<Frame>,
    pub(crate) points: CommonList<Point>,
    pub(crate) bodies: CommonList<Body>,
    pub(crate) families: CommonList<Family>,
    pub(crate) planes: Vec<Plane>,
    pub(crate) contacts: Vec<Contact>,
    pub(crate) loads: CommonList<Load>,
    /// The inertial frame.
    pub(crate) ground: FrameId,
    /// The frame on which components are worked with.
    pub(crate) work: FrameId,
    /// Where columns of two are, if sentences say so or tell the plane of a motion.
    pub(crate) axis_pair: Option<AxisPair>,
    /// Which quantities keep a variable of their own.
    pub(crate) apart: KeptApart,
}

/// Which quantities keep a variable of their own though a law gives their value: then what a line says can be told from what
/// the laws make of it.
#[derive(Clone, Copy, Debug, Default, PartialEq, Eq)]
pub(crate) enum KeptApart {
    /// Those whose value has several terms.
    #[default]
    Sums,
    /// Those whose value is no number and no single variable, and rates as they are seen from another frame.
    Terms,
    /// Those whose value is no number, and such rates.
    Variables,
}

/// The names of components on numbered axes.
pub(crate) const AXES: [&str; 3] = ["x", "y", "z"];

/// The unit vector along an axis of the work frame.
pub(crate) fn unit(axis: usize) -> Vector {
    Vector::from_fn(|row, _| crate::verify::model::atoms::whole(i64::from(row == axis)))
}

impl System {
    /// How much there is of everything but variables.
    pub(crate) fn extent(&self) -> [usize; 8] {
        let tensors = self.bodies.iter().filter(|body| body.inertia.is_some());
        [
            self.frames.len(),
            self.points.len(),
            self.bodies.len(),
            tensors.count(),
            self.families.len(),
            self.planes.len(),
            self.contacts.len(),
            self.loads.len(),
        ]
    }

    /// Three new components that move freely, or not at all as seen from the work frame.
    pub(crate) fn free_vector(&mut self, text: &str, place: Place, member: Option<&str>) -> Vector {
        Vector::from_fn(|row, _| {
            let key = Key {
                member: member.map(str::to_owned),
                ..Key::new(component_text(text, row))
            };
            fraction(self.atoms.variable(key, place, Motion::Free))
        })
    }

    /// Three new components of a vector that does not change as seen from a frame.
    pub(crate) fn carried_vector(
        &mut self,
        text: &str,
        frame: FrameId,
        member: Option<&str>,
    ) -> Vector {
        let keys = [0, 1, 2].map(|row| Key {
            member: member.map(str::to_owned),
            ..Key::new(component_text(text, row))
        });
        let known = keys.iter().all(|key| self.atoms.find(key).is_some());
        let variables =
            keys.map(|key| self.atoms.variable(key, Place::Parameter, Motion::Constant));
        let vector = Vector::from(variables.map(fraction));
        if !known && frame != self.work {
            let omega = self.angular_velocity(frame, self.work);
            let rates = mechanics::cross(&omega, &vector);
            for (variable, rate) in variables.into_iter().zip(rates.iter()) {
                if !rate.is_zero() {
                    self.atoms.atom_mut(variable).motion = Motion::Rate(rate.clone());
                    self.atoms.atom_mut(variable).place = Place::Coordinate;
                }
            }
        }
        vector
    }

    /// The rate of components, seen from the work frame.
    pub(crate) fn rate(&mut self, of: &Vector) -> Vector {
        of.map(|component| self.atoms.derivative(&component))
    }

    /// The rate of a vector seen from a frame, by the transport law.
    pub(crate) fn rate_seen_from(&mut self, frame: FrameId, of: &Vector) -> Vector {
        let rate = self.rate(of);
        if frame == self.work {
            return rate;
        }
        let omega = self.angular_velocity(self.work, frame);
        mechanics::transport(&rate, &omega, of)
    }
}

/// A component of a vector in LaTeX: `x` of `r_i` is `r_{i,x}`. Behind the third they are numbered.
pub(crate) fn component_text(text: &str, row: usize) -> String {
    let axis = AXES
        .get(row)
        .map_or_else(|| (row + 1).to_string(), |axis| (*axis).to_owned());
    match text.rsplit_once('_') {
        Some((letter, index)) if !index.contains(['{', '}', ' ']) => {
            format!("{letter}_{{{index},{axis}}}")
        }
        Some((letter, index)) if index.starts_with('{') && index.ends_with('}') => {
            let inner = &index[1..index.len() - 1];
            format!("{letter}_{{{inner},{axis}}}")
        }
        _ => format!("{text}_{axis}"),
    }
}
