//! What is at rest in a frame: bodies that have it for their own, and frames that do not turn against it.

use crate::verify::language::statement::{
    Declaration, Extent, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::system::{Body, BodyId, FrameId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::name_of;

/// What the axes of a frame are called.
const TRIADS: [&str; 2] = ["axes", "axis"];

impl Builder<'_> {
    /// Whether a point is placed from another one that sentences fix where it is.
    pub(super) fn lies_from_beside(&self, subject: &Term) -> bool {
        let points = &self.reading.system.points;
        let Some(own) = self.point(subject).map(|own| &points[own].fixed_in) else {
            return false;
        };
        let fixes = |d: &Declaration, point: &Term| match &d.statement {
            Statement::Is { subjects, what } if d.extent == Extent::Document => {
                let frames = self.frames_fixed(what);
                subjects.contains(point) && frames.iter().any(|frame| own.contains(frame))
            }
            _ => false,
        };
        self.declarations.iter().any(|d| {
            let placed = d.statement.does("place").or(d.statement.does("lie"));
            let from = placed.and_then(|(_, slots)| slot(slots, Slot::From));
            d.statement.subjects().contains(subject)
                && from.is_some_and(|from| self.declarations.iter().any(|d| fixes(d, from)))
        })
    }

    /// A point stays where it is in all frames in which it is fixed, also where it was placed in one of them alone.
    pub(super) fn hold_fixed(&mut self, subject: &Term, declaration: &Declaration) {
        let Some(point) = self.point(subject) else {
            return;
        };
        for frame in self.reading.system.points[point].fixed_in.clone() {
            let system = self.system();
            let way = system.position(point, system.fixed_point(frame));
            let rate = system.rate_seen_from(frame, &way);
            self.hold_zero(&rate, declaration);
        }
    }

    /// "The hub is fixed in N": it has the frame for its own.
    pub(super) fn fix_bodies_in_frames(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let fixed = what.head == "fixed" && declaration.extent == Extent::Document;
            let frame = self.frames_of(what).next();
            let Some(frame) = frame.filter(|_| fixed) else {
                continue;
            };
            let particles = self.particles();
            for body in subjects
                .iter()
                .filter_map(|subject| self.body(subject))
                .collect::<Vec<_>>()
            {
                let known = &mut self.reading.system.bodies[body];
                let particle = particles.contains(&known.name);
                match known.frame {
                    None if !particle => known.frame = Some(frame),
                    Some(own) if own != frame => self.say_unused(declaration),
                    _ => {}
                }
            }
        }
    }

    /// "The rods lie along the axes x and y of B", where these are parts of what B is fixed in: so are they.
    pub(super) fn lay_rods_in_frames(&mut self) {
        for declaration in self.declarations {
            let Some((subjects, slots)) = declaration.statement.does("lie") else {
                continue;
            };
            let along = slot(slots, Slot::Along).and_then(|axis| self.frame_of_axis(axis));
            let Some(frame) = along else {
                continue;
            };
            let rods: Vec<BodyId> = subjects.iter().filter_map(|rod| self.body(rod)).collect();
            for rod in rods {
                let bodies = &self.reading.system.bodies;
                let whole = |b: &Body| b.frame == Some(frame) && b.parts.contains(&rod);
                let part = bodies[rod].frame.is_none() && bodies.iter().any(whole);
                if part && self.is_rod(rod) {
                    self.reading.system.bodies[rod].frame = Some(frame);
                }
            }
        }
    }

    /// The frame of which an axis is said to be, by its name or as "the third axis of B".
    fn frame_of_axis(&self, axis: &Term) -> Option<FrameId> {
        let name = name_of(axis);
        let named = |subject: &Term| name.is_some() && name_of(subject) == name;
        let phrases = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => subjects.iter().any(named).then_some(what),
            _ => None,
        });
        let own = match axis {
            Term::Phrase(phrase) => Some(&**phrase),
            _ => None,
        };
        let mut said = phrases
            .chain(own)
            .filter(|what| TRIADS.contains(&what.head));
        let what = said.next().filter(|_| said.next().is_none())?;
        self.frame(what.slot(Slot::Of)?)
    }

    /// "K is a frame fixed in N", "A and B are frames fixed in the body": one does not turn against the other.
    pub(super) fn hold_fixed_frames(&mut self) {
        self.hold_directions_kept();
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if !matches!(what.head, "frame" | "fixed") {
                continue;
            }
            let others: Vec<FrameId> = self.frames_of(what).collect();
            let own = subjects.iter().filter_map(name_of);
            let own: Vec<FrameId> = own
                .filter_map(|name| self.frames.get(&name).copied())
                .collect();
            for frame in own {
                for &other in others.iter().filter(|&&other| other != frame) {
                    let turns = self.system().angular_velocity(frame, other);
                    self.hold_zero(&turns, declaration);
                }
            }
        }
    }

    /// "`$r$` is fixed in B", of a vector that other sentences tell: seen from B it does not change.
    pub(super) fn hold_fixed_vectors(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if what.head != "fixed" {
                continue;
            }
            let frames: Vec<FrameId> = self.frames_of(what).collect();
            // A point that has its letter in dollars is no vector.
            let vectors = subjects.iter().filter(|term| self.point(term).is_none());
            let vectors: Vec<Term> = vectors.cloned().collect();
            for formula in formulas(&vectors) {
                let value = self.formula_value(formula, declaration);
                let Some(vector) = value.and_then(|value| value.to_vector().ok()) else {
                    self.say_unused(declaration);
                    continue;
                };
                for &frame in &frames {
                    let rate = self.system().rate_seen_from(frame, &vector);
                    self.hold_zero(&rate, declaration);
                }
            }
        }
    }

    /// A frame, and all that are at rest in it: "A and B are frames fixed in the body" carry the same points.
    pub(super) fn at_rest_with(&self, frame: FrameId) -> Vec<FrameId> {
        let mut pairs = vec![];
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && matches!(what.head, "frame" | "fixed")
                && declaration.extent == Extent::Document
            {
                let own = subjects.iter().filter_map(name_of);
                let own = own.filter_map(|name| self.frames.get(&name).copied());
                let others: Vec<FrameId> = self.frames_of(what).collect();
                pairs.extend(own.flat_map(|own| others.iter().map(move |&other| (own, other))));
            }
        }
        let mut all = vec![frame];
        let mut at = 0;
        while let Some(&known) = all.get(at) {
            for &(one, other) in &pairs {
                let next = match known {
                    _ if known == one => other,
                    _ if known == other => one,
                    _ => continue,
                };
                if !all.contains(&next) {
                    all.push(next);
                }
            }
            at += 1;
        }
        all
    }

    /// The frames that something is fixed in, or of the bodies that it is fixed in.
    fn frames_of(&self, what: &NounPhrase) -> impl Iterator<Item = FrameId> {
        what.all(Slot::FixedIn).filter_map(|term| {
            let body = || self.reading.system.bodies[self.body(term)?].frame;
            self.frame(term).or_else(body)
        })
    }
}
