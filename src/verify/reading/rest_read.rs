//! What is at rest in a frame: bodies that have it for their own, and frames that do not turn against it.

use crate::verify::language::statement::{Extent, NounPhrase, Slot, Statement};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::name_of;

impl Builder<'_> {
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

    /// "K is a frame fixed in N", "A and B are frames fixed in the body": one does not turn against the other.
    pub(super) fn hold_fixed_frames(&mut self) {
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
            for formula in formulas(subjects) {
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

    /// The frames that something is fixed in, or of the bodies that it is fixed in.
    fn frames_of(&self, what: &NounPhrase) -> impl Iterator<Item = FrameId> {
        what.all(Slot::FixedIn).filter_map(|term| {
            let body = || self.reading.system.bodies[self.body(term)?].frame;
            self.frame(term).or_else(body)
        })
    }
}
