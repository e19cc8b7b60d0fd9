//! Frames that move without a point of which a sentence tells: each has an origin of its own, and nothing tells where that is.

use crate::verify::language::heads::KEEPS_DIRECTION;
use crate::verify::language::messages::origin_of;
use crate::verify::language::statement::{Declaration, Statement, Term};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::name_of;
use crate::verify::reading::points_spoken::Spoken;
use crate::verify::reading::unused_read::MOVING;

impl Builder<'_> {
    /// The origins of frames that move, or that only do not turn, and in which no point is said to be fixed.
    pub(super) fn add_origins(&self, spoken: &mut Vec<Spoken>) {
        for declaration in self.declarations {
            for (name, frame) in self.floating(declaration) {
                let together = self.at_rest_with(frame);
                let bodies = &self.reading.system.bodies;
                let carried = bodies
                    .iter()
                    .any(|body| body.frame.is_some_and(|own| together.contains(&own)));
                let placed = |s: &Spoken| s.fixed_in.iter().any(|own| together.contains(own));
                let rests = together.contains(&self.reading.system.ground);
                if !rests && !carried && !spoken.iter().any(placed) {
                    spoken.push(Spoken {
                        name: origin_of(&name.replace('_', "")),
                        fixed_in: together,
                        ..Spoken::default()
                    });
                }
            }
        }
    }

    /// The frames of which a sentence says that they move, that they keep their direction or that they are inertial as well.
    fn floating(&self, declaration: &Declaration) -> Vec<(String, FrameId)> {
        let subjects: &[Term] = match &declaration.statement {
            Statement::Does { subjects, verb, .. }
                if MOVING.contains(verb) || *verb == KEEPS_DIRECTION =>
            {
                subjects
            }
            statement => inertial(statement),
        };
        let names = subjects.iter().filter_map(name_of);
        names
            .filter_map(|name| Some((name.clone(), *self.frames.get(&name)?)))
            .collect()
    }

    /// Inertial frames move evenly against one another.
    pub(super) fn hold_inertial_frames(&mut self) {
        let ground = self.reading.system.ground;
        for declaration in self.declarations {
            for name in inertial(&declaration.statement).iter().filter_map(name_of) {
                let Some(&frame) = self.frames.get(&name).filter(|&&f| f != ground) else {
                    continue;
                };
                let origin = self.reading.system.fixed_point(frame);
                let velocity = self.system().velocity(origin, ground);
                let change = self.system().rate_seen_from(ground, &velocity);
                self.hold_zero(&change, declaration);
            }
        }
    }
}

/// The subjects of a sentence by which they are inertial frames.
fn inertial(statement: &Statement) -> &[Term] {
    match statement {
        Statement::Is { subjects, what } if what.head == "frame" && what.is("inertial") => subjects,
        _ => &[],
    }
}
