//! The axis of a shape: of its frame, a direction that its frame carries, or the way between points of it.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::premises::Facts;
use crate::verify::language::heads::NORMAL;
use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::model::atoms::fraction;
use crate::verify::model::system::{BodyId, FrameId, Line, PointId, Turn, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::shapes_read::{is_rod, is_shape};
use num_traits::Zero;
use std::collections::BTreeSet;

impl<'a> Builder<'a> {
    /// The number of the axis of a body's frame about which its shape is round: the third where no sentence tells it.
    pub(super) fn told_axis_of_shape(&self, body: BodyId) -> Option<usize> {
        let system = &self.reading.system;
        let frame = system.bodies[body].frame?;
        let mut said = self.said_axes_of_shape(body);
        let told = said.find_map(|(term, _)| self.axis_of_frame(term));
        let shared = |f: usize, axis: usize| {
            let turned = &system.frames[frame];
            turned.parent == Some(f) && turned.turn.axis() == Some(axis)
        };
        told.filter(|&(f, axis)| f == frame || shared(f, axis))
            .map(|(_, axis)| axis)
    }

    /// A direction by its letter about which sentences say that a shape is round, or along which it lies; one alone.
    pub(super) fn said_direction_of_shape(
        &self,
        body: BodyId,
    ) -> Option<(&'a Term, &'a Declaration)> {
        let mut said = self.said_axes_of_shape(body);
        let first = said.next()?;
        let letter = matches!(first.0, Term::Formula(_)) && self.axis_of_frame(first.0).is_none();
        (letter && said.all(|(other, _)| other == first.0)).then_some(first)
    }

    /// What sentences say to be the axis of a shape.
    fn said_axes_of_shape(
        &self,
        body: BodyId,
    ) -> impl Iterator<Item = (&'a Term, &'a Declaration)> {
        let rod = self.is_rod(body);
        let own = move |term: &Term| self.body(term) == Some(body);
        let said = self.declarations.iter();
        said.filter_map(move |d| {
            let axis = match &d.statement {
                Statement::Is { subjects, what } => {
                    let of = what.slot(Slot::Of).is_some_and(own);
                    let subject = subjects.first();
                    match what.head {
                        "axis" => subject.filter(|_| of && what.slot(Slot::Which).is_none()),
                        // "a thin rod along the second axis of B"
                        head if is_shape(head) => {
                            let along = what.slot(Slot::Along);
                            along.filter(|_| subjects.iter().any(own))
                        }
                        "orthogonal" => subject.filter(|_| what.all(Slot::With).any(own)),
                        NORMAL => subject.filter(|_| what.all(Slot::Of).any(own)),
                        "symmetric" => {
                            let about = what.slot(Slot::About);
                            about.filter(|_| subjects.iter().any(own))
                        }
                        _ => None,
                    }
                }
                Statement::Does {
                    subjects,
                    verb: "lie",
                    slots,
                } if rod => slot(slots, Slot::Along).filter(|_| subjects.iter().any(own)),
                _ => None,
            };
            Some((axis?, d))
        })
    }

    /// A direction that the frame of a body carries.
    pub(super) fn direction_in_body(
        &mut self,
        body: BodyId,
        along: &Term,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let frame = self.reading.system.bodies[body].frame?;
        if let Term::Formula(letter) = along
            && let Some((way, said)) = self.directed_elsewhere(letter)
        {
            self.tell_letters_of_place(&way, said)?;
        }
        let direction = self.direction(along, declaration, Some(frame))?;
        self.is_carried(&direction, frame).then_some(direction)
    }

    /// The lengths of rods that have ends are told before anything is placed by the same letters.
    pub(super) fn tell_lengths_of_rods(&mut self) {
        for body in 0..self.reading.system.bodies.len() {
            let ends = !self.reading.system.bodies[body].ends.is_empty();
            if let Some((what, said)) = self.said_to_be(body, is_rod).filter(|_| ends) {
                self.size_of_shape(body, what, "length", said);
            }
        }
    }

    /// Tells how a rod lies by its points. Where sentences place both of its ends, and its frame turns otherwise, it is not
    /// known.
    pub(super) fn lay_by_points(&mut self, body: BodyId) -> Option<()> {
        let lies = self.tell_line_by_points(body).is_some();
        let elsewhere = self.has_placed_ends(body) && self.told_axis_of_shape(body).is_none();
        if elsewhere && !lies {
            return self.turn_with_ends(body);
        }
        Some(())
    }

    /// A rod of which sentences place both ends in a plane of the frame that its own one turns against, and tell no other
    /// turn: it turns about the normal of this plane by the angle of which the way between its ends has the cosine and
    /// the sine.
    fn turn_with_ends(&mut self, body: BodyId) -> Option<()> {
        let frame = self.reading.system.bodies[body].frame?;
        let parent = self.reading.system.frames[frame].parent?;
        if !self.is_free_against(frame, parent) || self.has_named_axes(body) {
            return None;
        }
        let way = self.way_between_ends(body)?;
        let axes = [0, 1, 2].map(|axis| self.system().axis(parent, axis));
        let normal = (0..3).find(|&axis| way.dot(&axes[axis]).is_zero())?;
        let variables = way.iter().flat_map(Fraction::variables);
        let atoms = &self.reading.system.atoms;
        let angles: BTreeSet<Variable> = variables
            .filter_map(|v| atoms.angle_of(v)?.as_variable())
            .collect();
        for angle in angles {
            for angle in [fraction(angle), -fraction(angle)] {
                self.reading.system.frames[frame].turn = Turn::Angle(normal, Box::new(angle));
                if let Some((axis, reversed)) = self.axis_along(frame, &way) {
                    self.reading.system.bodies[body].line = Some(Line {
                        axis,
                        reversed,
                        by_points: true,
                    });
                    return Some(());
                }
            }
        }
        self.reading.system.frames[frame].turn = Turn::Free;
        None
    }

    /// The way from the first end of a rod to the other, in lengths of the rod, where both stand.
    fn way_between_ends(&mut self, body: BodyId) -> Option<Vector> {
        let (what, declaration) = self.said_to_be(body, is_rod)?;
        let length = self.size_of_shape(body, what, "length", declaration)?;
        let ends = self.reading.system.bodies[body].ends.iter();
        let ends: Option<Vec<PointId>> = ends.map(|end| self.points.get(end).copied()).collect();
        match ends?.as_slice() {
            &[first, last] => Some(self.reading.system.position(last, first) / length),
            _ => None,
        }
    }

    /// Along which axis of its frame a rod lies, by the places of its ends and its middle: the way between them has the
    /// length that is told, and the frame carries it.
    pub(super) fn tell_line_by_points(&mut self, body: BodyId) -> Option<()> {
        let known = &self.reading.system.bodies[body];
        let frame = known.frame?;
        if let Some(line) = known.line {
            return line.by_points.then_some(());
        }
        if !self.is_rod(body) || self.told_axis_of_shape(body).is_some() || self.has_ends(body) {
            return None;
        }
        let places = self.places_on_line(body);
        let ((first, from), rest) = places.split_first()?;
        let (last, to) = rest.last()?;
        let (what, declaration) = self.said_to_be(body, is_rod)?;
        let length = self.size_of_shape(body, what, "length", declaration)?;
        let way = self.reading.system.position(*last, *first)
            / (length.clone() * (to.clone() - from.clone()));
        let (axis, reversed) = self.axis_along(frame, &way)?;
        for (place, at) in rest {
            let own = self.reading.system.position(*place, *first);
            let told = &way * (length.clone() * (at.clone() - from.clone()));
            self.vanishes(&(own - told)).then_some(())?;
        }
        self.reading.system.bodies[body].line = Some(Line {
            axis,
            reversed,
            by_points: true,
        });
        Some(())
    }

    /// The points of a rod that stand, and how far from its middle each is: in lengths of it.
    fn places_on_line(&self, body: BodyId) -> Vec<(PointId, Fraction)> {
        let known = &self.reading.system.bodies[body];
        let ends = known.ends.iter().zip([-1, 1]);
        let ends = ends.filter_map(|(name, side)| {
            let half = Fraction::from_ratio(side, 2);
            Some((*self.points.get(name)?, half))
        });
        let stands = (known.centre != 0).then(|| (known.centre, Fraction::zero()));
        ends.chain(stands).collect()
    }

    /// The axis of a frame that a vector is, and whether it is against that.
    fn axis_along(&mut self, frame: FrameId, way: &Vector) -> Option<(usize, bool)> {
        for axis in 0..3 {
            let unit = self.system().axis(frame, axis);
            if self.vanishes(&(way - &unit)) {
                return Some((axis, false));
            }
            if self.vanishes(&(way + &unit)) {
                return Some((axis, true));
            }
        }
        None
    }

    /// Whether a vector does not change as seen from a frame.
    fn is_carried(&mut self, vector: &Vector, frame: FrameId) -> bool {
        let rate = self.system().rate_seen_from(frame, vector);
        self.vanishes(&rate)
    }

    pub(super) fn vanishes(&mut self, vector: &Vector) -> bool {
        let atoms = &mut self.reading.system.atoms;
        let mut facts = Facts::default();
        let zero = |of: &Fraction| facts.normal(atoms, of).is_ok_and(|f| f.is_zero());
        vector.iter().all(zero)
    }
}
