//! Letters of axes that no frame names: the axis of symmetry of a body that turns freely, and the vertical.

use crate::verify::language::heads::{AXES, EULER_ANGLES, OF_SYMMETRY, VERTICAL};
use crate::verify::language::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};
use crate::verify::language::traits::{Trait, has};
use crate::verify::model::system::FrameId;
use crate::verify::reading::axes_read::Vertical;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{UNIT_VECTOR, name_of};

/// The axis of its own frame along which a body is symmetric, where nothing else is told of that frame.
const OWN: usize = 2;

impl Builder<'_> {
    /// "The body is symmetric about `$n$`, a unit vector fixed in it": where no sentence says how its frame lies, its third
    /// axis is along n.
    pub(super) fn read_axes_of_symmetry(&mut self) {
        for declaration in self.declarations {
            let Some((letter, body)) = self.symmetry_by_letter(declaration) else {
                continue;
            };
            let named = name_of(&letter).is_some_and(|name| self.axes.get(&name).is_some());
            let frame = self.frame_of_body(&body);
            if let Some(frame) = frame.filter(|&frame| !named && self.may_lie_freely(frame)) {
                self.name_axis(&letter, frame, OWN, declaration);
            }
        }
    }

    /// The letter of a unit vector about which a body is symmetric, and the body.
    fn symmetry_by_letter(&self, declaration: &Declaration) -> Option<(Term, Term)> {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return None;
        };
        if declaration.extent != Extent::Document {
            return None;
        }
        match (subjects.as_slice(), what.head) {
            ([body], "symmetric") => {
                let letter = what.slot(Slot::About).cloned()?;
                let fixed = self.is_unit_vector_fixed_in(&letter, body);
                fixed.then(|| (letter, body.clone()))
            }
            ([letter @ Term::Formula(_)], UNIT_VECTOR) => {
                let body = match axis_of_symmetry(what)? {
                    Some(body) => body.clone(),
                    None => {
                        let only = self.only_body()?;
                        Term::Name(self.reading.system.bodies[only].name.clone())
                    }
                };
                Some((letter.clone(), body))
            }
            _ => None,
        }
    }

    /// Whether sentences say that a letter is a unit vector, and fixed in a body.
    pub(super) fn is_unit_vector_fixed_in(&self, letter: &Term, body: &Term) -> bool {
        let about = |what: &NounPhrase| {
            let mut fixed = what.all(Slot::FixedIn);
            fixed.any(|of| of == body || self.frame_of_body(of) == self.frame_of_body(body))
        };
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = subjects.contains(letter) && d.extent == Extent::Document;
                own.then_some(what)
            }
            _ => None,
        });
        let said: Vec<&NounPhrase> = said.collect();
        let fixed = |what: &NounPhrase| matches!(what.head, UNIT_VECTOR | "fixed") && about(what);
        said.iter().any(|what| what.head == UNIT_VECTOR) && said.iter().any(|what| fixed(what))
    }

    fn frame_of_body(&self, body: &Term) -> Option<FrameId> {
        self.reading.system.bodies[self.body(body)?].frame
    }

    /// Whether nothing that sentences say depends on how a frame lies in its body.
    pub(super) fn may_lie_freely(&self, frame: FrameId) -> bool {
        let named = self.axes.iter().any(|(_, (of, _))| *of == frame);
        !named && self.may_lie_freely_but_for(frame, |_| false)
    }

    /// Whether nothing that sentences say depends on how a frame lies, but for those that are set aside.
    pub(super) fn may_lie_freely_but_for(
        &self,
        frame: FrameId,
        set_aside: impl Fn(&Declaration) -> bool,
    ) -> bool {
        let own = |term: &Term| self.frame(term) == Some(frame);
        let lies = |d: &Declaration| {
            let parts = d.statement.slots().flatten();
            let told = |(slot, term): &(Slot, Term)| {
                matches!(slot, Slot::On | Slot::From | Slot::To) && own(term)
            };
            let turned = match &d.statement {
                Statement::Does {
                    subjects,
                    verb: "turn",
                    ..
                } => subjects.iter().any(own),
                Statement::Is { what, .. } => {
                    let turned = what.head == EULER_ANGLES || what.head == "axes";
                    turned && what.all(Slot::Of).any(own)
                }
                _ => false,
            };
            turned || parts.into_iter().any(told)
        };
        let mut others = self.declarations.iter().filter(|d| !set_aside(d));
        !others.any(lies)
    }

    /// "`$k$` is the unit vector along the upward vertical": a letter of the vertical axis.
    pub(super) fn read_verticals_by_vectors(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let Some(Term::Phrase(vertical)) = what.slot(Slot::Along) else {
                continue;
            };
            let ([subject], UNIT_VECTOR, VERTICAL) =
                (subjects.as_slice(), what.head, vertical.head)
            else {
                continue;
            };
            let down = vertical.is("downward");
            let sense_told = down || vertical.is("upward");
            let known = name_of(subject).is_some_and(|name| self.axes.get(&name).is_some());
            match self.bearings.vertical {
                _ if known || !sense_told => {}
                None => self.read_vertical(subjects, vertical, declaration),
                Some(Vertical {
                    frame,
                    axis,
                    points_down,
                }) if points_down == down => self.name_axis(subject, frame, axis, declaration),
                Some(_) => {}
            }
        }
    }

    /// Whether a sentence only tells the letter of an axis that is known by it.
    pub(super) fn names_known_axis(&self, subjects: &[Term], what: &NounPhrase) -> bool {
        let vertical = |term: &Term| matches!(term, Term::Phrase(p) if p.head == VERTICAL);
        let along =
            what.slot(Slot::Along).is_some_and(vertical) || axis_of_symmetry(what).is_some();
        let known = |term: &Term| name_of(term).is_some_and(|n| self.axes.get(&n).is_some());
        what.head == UNIT_VECTOR && along && subjects.iter().all(known)
    }

    /// Whether a letter names an axis of the frame of a body.
    pub(super) fn has_axis(&self, body: &Term, letter: Option<&Term>) -> bool {
        let axis = letter.and_then(|letter| self.axis_of_frame(letter));
        axis.is_some_and(|(frame, _)| self.frame(body) == Some(frame))
    }

    /// The frame of the only body, where its shape or its symmetry gives it an axis.
    pub(super) fn frame_of_only_body(&self) -> Option<FrameId> {
        let [body] = self.reading.system.bodies.as_slice() else {
            return None;
        };
        let named = |frame: &FrameId| self.axes.iter().any(|(_, (of, _))| of == frame);
        body.frame.filter(|frame| self.is_cone(0) || named(frame))
    }

    /// "The disc turns about its axis": the third axis of its frame, where no axis of that has a name.
    pub(super) fn own_axis_of_shape(&self, about: &Term, frame: FrameId) -> Option<usize> {
        let Term::Phrase(axis) = about else {
            return None;
        };
        let own = |of: &Term| {
            let body = self.body(of)?;
            let known = &self.reading.system.bodies[body];
            let round = self.is_shaped(body, |noun| has(noun, Trait::Round));
            (known.frame == Some(frame) && round).then_some(body)
        };
        let body = match axis.slots.as_slice() {
            [(Slot::Of, of)] if AXES.contains(&axis.head) => own(of)?,
            _ => return None,
        };
        let told = self.told_axis_of_shape(body);
        told.or((!self.has_named_axes(body)).then_some(2))
    }
}

/// "the unit vector along the axis of symmetry of the body": the body, if it says so.
fn axis_of_symmetry(what: &NounPhrase) -> Option<Option<&Term>> {
    match what.slot(Slot::Along)? {
        Term::Phrase(axis) if OF_SYMMETRY.contains(&axis.head) => Some(axis.slot(Slot::Of)),
        _ => None,
    }
}
