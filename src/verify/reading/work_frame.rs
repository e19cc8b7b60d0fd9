//! The frame on whose axes all components are worked out.

use crate::verify::language::statement::{Slot, Statement, slot};
use crate::verify::model::system::FrameId;
use crate::verify::reading::builder::Builder;
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
            let on = what
                .slot(Slot::On)
                .or(match (what.head, &declaration.statement) {
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
        let work = best.map(|(frame, _)| *frame).or(body);
        let work = work
            .or_else(|| self.frame_of_only_body())
            .unwrap_or(self.reading.system.ground);
        self.reading.system.work = work;
        self.reading.letters.component_frame = match score.is_empty() {
            true => body.unwrap_or(work),
            false => work,
        };
    }
}
