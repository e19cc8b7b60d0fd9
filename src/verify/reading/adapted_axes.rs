//! Axes that no sentence names are laid along the vectors about which frames turn: that is no loss, and short.

use crate::algebra::{Fraction, Place};
use crate::verify::language::statement::{Declaration, Extent, Slot, Statement, Term, slot};
use crate::verify::language::terms::Doing;
use crate::verify::model::atoms::{Key, Motion, fraction};
use crate::verify::model::system::{FrameId, Turn};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{along_of, name_of};
use std::collections::BTreeSet;

/// The axis that is laid along the vector.
const ALONG: usize = 2;
/// The axis across the two vectors of a frame that others turn about.
const ACROSS: usize = 1;

impl Builder<'_> {
    /// "A turns relative to N about `$k$`, a unit vector fixed in N": where no sentence says how the axes of N lie, the
    /// third one is along k. "B turns relative to A about `$n$`, a unit vector fixed in A": where of the axes of A only
    /// the third one is told, the first one is in the plane of this one and of n.
    pub(super) fn adapt_axes(&mut self) {
        // Frames turn against earlier ones alone: the axes of those are laid first.
        for relative in 0..self.reading.system.frames.len() {
            for declaration in self.declarations {
                if let Some((frame, vector)) = self.turn_about_vector(declaration, relative) {
                    self.adapt_axes_to(&vector, frame, relative, declaration);
                }
            }
        }
    }

    /// Lays the third axis of the frame against which another turns along the vector about which it does.
    fn adapt_axes_to(
        &mut self,
        vector: &Term,
        frame: FrameId,
        relative: FrameId,
        declaration: &Declaration,
    ) {
        let turns = self.turns_about_vector_alone(relative);
        let angle = turns.then(|| self.angle_with_third(relative, vector));
        match angle {
            None | Some(None) if self.may_lie_freely(relative) => {
                self.name_axis(vector, relative, ALONG, declaration);
            }
            Some(angle) => {
                let tilted = self.add_tilted(relative, angle);
                self.reading.system.frames[frame].parent = Some(tilted);
                self.name_axis(vector, tilted, ALONG, declaration);
            }
            None => {}
        }
    }

    /// What turns against a frame about a vector that is fixed there, where the axes of what turns may lie in any way.
    fn turn_about_vector(
        &self,
        declaration: &Declaration,
        relative: FrameId,
    ) -> Option<(FrameId, Term)> {
        let (subjects, slots) = turn(&declaration.statement)?;
        let [subject] = subjects else { return None };
        let vector = along_of(slot(slots, Slot::About)?).clone();
        let relative_to = slot(slots, Slot::RelativeTo)?;
        let against = self.frame(relative_to).filter(|&f| f == relative);
        let (frame, relative) = (self.frame(subject)?, against?);
        let new = name_of(&vector).is_some_and(|name| self.axes.get(&name).is_none());
        let turned = self.reading.system.frames[frame].parent == Some(relative);
        let fits = new
            && turned
            && declaration.extent == Extent::Document
            && self.is_unit_vector_fixed_in(&vector, relative_to)
            && (self.is_unnamed(frame) && self.turns_about_vector_alone(frame));
        fits.then_some((frame, vector))
    }

    fn is_unnamed(&self, frame: FrameId) -> bool {
        self.axes.iter().all(|(_, (of, _))| *of != frame)
    }

    /// Whether all that sentences say of how a frame lies is that it turns about a vector.
    fn turns_about_vector_alone(&self, frame: FrameId) -> bool {
        let parent = self.reading.system.frames[frame].parent;
        let only_along = |(_, (of, axis)): (&String, &(FrameId, usize))| {
            let parents = Some(*of) == parent && *axis == ALONG;
            *of != frame || parents
        };
        let own = |declaration: &Declaration| self.turns(declaration, frame);
        // A frame that turns about z may be said once more to do so, at a rate.
        let turns = self.declarations.iter().filter(|d| own(d));
        let turns = turns.map(|d| {
            let (_, slots) = turn(&d.statement)?;
            let about = slot(slots, Slot::About).map(along_of).and_then(name_of);
            Some((about?, slot(slots, Slot::RelativeTo).and_then(name_of)))
        });
        let turns: Option<BTreeSet<_>> = turns.collect();
        turns.is_some_and(|turns| turns.len() == 1)
            && self.axes.iter().all(only_along)
            && self.may_lie_freely_but_for(frame, own)
    }

    /// Whether a sentence says that a frame turns.
    fn turns(&self, declaration: &Declaration, frame: FrameId) -> bool {
        let mut turned = turn(&declaration.statement).into_iter();
        turned.any(|(subjects, _)| subjects.iter().any(|s| self.frame(s) == Some(frame)))
    }

    /// A frame fixed in another, turned against it about its second axis by the angle of a vector with the third one, or
    /// by one of which nothing is told.
    fn add_tilted(&mut self, frame: FrameId, told: Option<Fraction>) -> FrameId {
        let name = format!("{}'", self.reading.system.frames[frame].name);
        let key = Key::new(format!("\\theta^{{{name}}}"));
        let atoms = &mut self.reading.system.atoms;
        let untold = fraction(atoms.variable(key, Place::Parameter, Motion::Constant));
        let angle = told.unwrap_or(untold);
        let turn = Turn::Angle(ACROSS, Box::new(angle));
        self.system().add_frame(&name, Some(frame), turn)
    }

    /// The frame against which another is turned, where it is fixed in the one that a sentence names.
    pub(super) fn nearest_fixed_in(&self, relative: FrameId, frame: FrameId) -> FrameId {
        let frames = &self.reading.system.frames;
        let atoms = &self.reading.system.atoms;
        let fixed = |parent: &FrameId| {
            let Turn::Angle(_, angle) = &frames[*parent].turn else {
                return false;
            };
            let variables = angle.variables();
            let mut motions = variables.iter().map(|v| &atoms.atom(*v).motion);
            frames[*parent].parent == Some(relative)
                && motions.all(|motion| matches!(motion, Motion::Constant))
        };
        frames[frame].parent.filter(fixed).unwrap_or(relative)
    }
}

impl Builder<'_> {
    /// "The angle between `$n$` and z is `$\\theta$`", where both are fixed in one frame of which z is the third axis.
    fn angle_with_third(&mut self, frame: FrameId, vector: &Term) -> Option<Fraction> {
        let parent = self.reading.system.frames[frame].parent;
        let third = |term: &Term| {
            let axis = self.axis_of_frame(term);
            axis.is_some_and(|(of, axis)| axis == ALONG && (of == frame || Some(of) == parent))
        };
        let (angle, declaration) = self.declarations.iter().find_map(|d| {
            let Statement::Is { subjects, what } = &d.statement else {
                return None;
            };
            let between: Vec<&Term> = what.all(Slot::Between).collect();
            let both = match between.as_slice() {
                [one, other] => *one == vector && third(other) || *other == vector && third(one),
                _ => false,
            };
            let told = what.head == "angle" && both && d.extent == Extent::Document;
            subjects.first().filter(|_| told).map(|angle| (angle, d))
        })?;
        let angle = self.scalar_term(angle, declaration)?;
        self.make_constant(&angle);
        Some(angle)
    }
}

/// What turns by a sentence, and what hangs on that.
fn turn(statement: &Statement) -> Option<Doing<'_>> {
    match statement {
        Statement::Is { subjects, what } if what.head == "frame" => {
            let turns = what.slot(Slot::About).is_some();
            turns.then_some((subjects, &what.slots))
        }
        _ => statement.does("turn"),
    }
}
