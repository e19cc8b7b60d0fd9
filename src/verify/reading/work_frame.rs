//! The frame on whose axes all components are worked out.

use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::contact_read::CONTACT_POINT;
use crate::verify::reading::names::PRINCIPAL_MOMENTS;
use std::collections::BTreeMap;

impl Builder<'_> {
    /// The frames that turn by an angle about an axis that they share with their parent.
    pub(super) fn easy_links(&self) -> Vec<FrameId> {
        let mut easy = vec![];
        for declaration in self.declarations {
            match &declaration.statement {
                Statement::Does {
                    subjects,
                    verb: "turn",
                    slots,
                } => {
                    let about = slot(slots, Slot::About);
                    for frame in subjects.iter().filter_map(|s| self.frame(s)) {
                        let parent = self.reading.system.frames[frame].parent.unwrap_or(frame);
                        if about
                            .is_some_and(|about| self.shared_axis(about, frame, parent).is_some())
                        {
                            easy.push(frame);
                        }
                    }
                }
                Statement::Is { what, .. } if what.head == "Euler angles" => {
                    easy.extend(what.slot(Slot::Of).and_then(|term| self.frame(term)));
                }
                _ => {}
            }
        }
        easy
    }

    /// The frame that is worked in where no sentence speaks of components.
    fn frame_without_components(&self, body: Option<FrameId>) -> FrameId {
        let rolling = self.rolling();
        let rolling = rolling.filter_map(|body| self.reading.system.bodies[body].frame);
        let mut calm = rolling.filter_map(|frame| {
            let calm = self.without_spin(frame);
            (calm != frame).then_some(calm)
        });
        body.map(|frame| self.without_spin(frame))
            .or_else(|| self.frame_of_only_body())
            .or_else(|| calm.next())
            .unwrap_or(self.reading.system.ground)
    }

    /// The frame against which a body that rolls turns about its axis of symmetry: there the spin is not seen.
    fn without_spin(&self, frame: FrameId) -> FrameId {
        let parent = self.reading.system.frames[frame].parent;
        let other = parent.filter(|&parent| parent != self.reading.system.ground);
        let own = |term: &Term| self.frame(term) == Some(frame);
        let said = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } if what.head == "symmetric" => {
                let about = what.slot(Slot::About).cloned();
                about.filter(|_| subjects.iter().any(own))
            }
            _ => None,
        };
        let axes: Vec<Term> = self.declarations.iter().filter_map(said).collect();
        let bodies = &self.reading.system.bodies;
        let rolls = self.rolling().any(|body| bodies[body].frame == Some(frame));
        let spins = self.declarations.iter().any(|d| {
            let turn = d.statement.does("turn");
            turn.is_some_and(|(subjects, slots)| {
                let about = slot(slots, Slot::About);
                subjects.iter().any(own) && about.is_some_and(|about| axes.contains(about))
            })
        });
        other.filter(|_| spins && rolls).unwrap_or(frame)
    }

    /// The frame from which all that have components are reached by the fewest free turns.
    pub(super) fn choose_work_frame(&mut self) {
        let mut score: BTreeMap<FrameId, usize> = BTreeMap::new();
        let mut body = None;
        for declaration in self.declarations {
            let what = match &declaration.statement {
                Statement::Is { what, .. } | Statement::Premise(what) => what,
                _ => continue,
            };
            if what.head == "frame"
                && what.slot(Slot::FixedIn).is_some()
                && body.is_none()
                && let Statement::Is { subjects, .. } = &declaration.statement
            {
                body = subjects.first().and_then(|s| self.frame(s));
            }
            let weight = match what.head {
                "component" | PRINCIPAL_MOMENTS | "axes" | "principal axes" => 3,
                _ => 1,
            };
            // What a body touches is no frame of components.
            let on = what.slot(Slot::On).filter(|_| what.head != CONTACT_POINT);
            let on = on.or(match (what.head, &declaration.statement) {
                ("axes" | "axis", _) => what.slot(Slot::Of),
                ("symmetric", Statement::Is { subjects, .. }) => subjects
                    .first()
                    .filter(|body| self.has_axis(body, what.slot(Slot::About))),
                _ => None,
            });
            if let Some(frame) = on.and_then(|term| self.frame(term)) {
                *score.entry(frame).or_default() += weight;
            }
        }
        let easy = self.easy_links();
        let cost = |candidate: FrameId| -> usize {
            score
                .iter()
                .map(|(&f, s)| s * self.reading.system.distance(candidate, f, &easy))
                .sum()
        };
        let best = score.iter().min_by_key(|(frame, score)| {
            (
                cost(**frame),
                std::cmp::Reverse(**score),
                body != Some(**frame),
                **frame,
            )
        });
        let best = best.map(|(frame, _)| *frame);
        let work = best.unwrap_or_else(|| self.frame_without_components(body));
        self.reading.system.work = work;
        self.reading.letters.component_frame = match score.is_empty() {
            true => body.unwrap_or(work),
            false => work,
        };
    }
}
