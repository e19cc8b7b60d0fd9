//! The letters of axes, and the frame that components are worked with on.

use crate::notation::ast::Kind;
use crate::verify::language::heads::VERTICAL;
use crate::verify::language::statement::{
    Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term,
};
use crate::verify::model::system::{FrameId, Vector};
use crate::verify::reading::axes_by_custom::{labelled_alike, places_of_axes, same_label};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::frames_read::CUSTOMARY;
use crate::verify::reading::incline_read::Lie;
use crate::verify::reading::names::{UNIT_VECTOR, name_of, node_of, opposite, written};
use crate::verify::term::letters::{Letter, Meaning};
use crate::verify::term::quantity::Quantity;
use std::collections::BTreeMap;

/// Axes by their names. One that two frames have in common is an axis of both.
#[derive(Clone, Debug, Default)]
pub(super) struct NamedAxes(BTreeMap<String, Vec<(FrameId, usize)>>);

impl NamedAxes {
    /// The axis of a name, of the frame of which it was said last.
    pub(super) fn get(&self, name: &str) -> Option<&(FrameId, usize)> {
        self.0.get(name)?.last()
    }

    /// Which axis of a frame has a name.
    pub(super) fn of(&self, name: &str, frame: FrameId) -> Option<usize> {
        let mut all = self.0.get(name)?.iter();
        all.find(|(of, _)| *of == frame).map(|(_, axis)| *axis)
    }

    /// Each name with each of its axes.
    pub(super) fn iter(&self) -> impl Iterator<Item = (&String, &(FrameId, usize))> {
        let all = self.0.iter();
        all.flat_map(|(name, axes)| axes.iter().map(move |axis| (name, axis)))
    }

    /// The names of axes that only one frame has.
    fn of_one_frame(&self) -> BTreeMap<String, (FrameId, usize)> {
        let named = self.0.iter();
        let single = named.filter(|(_, axes)| axes.iter().all(|axis| *axis == axes[0]));
        single.map(|(name, axes)| (name.clone(), axes[0])).collect()
    }

    fn insert(&mut self, name: String, frame: FrameId, axis: usize) {
        self.0.entry(name).or_default().push((frame, axis));
    }
}

/// The axis of a frame that is vertical.
#[derive(Clone, Copy, Debug)]
pub(super) struct Vertical {
    pub(super) frame: FrameId,
    pub(super) axis: usize,
    pub(super) points_down: bool,
}

/// Where up is, and how the plane of the document lies.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Bearings {
    pub(super) vertical: Option<Vertical>,
    pub(super) lie: Lie,
}

impl Builder<'_> {
    /// The letters of axes.
    pub(super) fn read_axes(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            match what.head {
                "axes" => self.read_triad(subjects, what, declaration),
                "axis" => self.read_one_axis(subjects, what, declaration),
                "vertical" => self.read_vertical(subjects, what, declaration),
                _ => {}
            }
        }
        self.read_axes_by_vectors();
        self.read_verticals_by_vectors();
        self.read_axes_of_symmetry();
        self.adapt_axes();
        self.read_incline();
        self.read_columns_of_two();
        self.reading.letters.customs.named_axes = self.axes.of_one_frame();
    }

    /// "`$n$` is the unit vector along z": a letter of that axis.
    fn read_axes_by_vectors(&mut self) {
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && let [subject] = subjects.as_slice()
                && let Some((frame, axis)) = what
                    .slot(Slot::Along)
                    .filter(|_| what.head == UNIT_VECTOR && declaration.extent == Extent::Document)
                    .and_then(|along| self.axis_said(what, along))
            {
                self.name_axis(subject, frame, axis, declaration);
            }
        }
    }

    /// "along z", "along z of D": the axis of a frame, of the one that is said.
    pub(super) fn axis_said(&self, what: &NounPhrase, along: &Term) -> Option<(FrameId, usize)> {
        match what.slot(Slot::Of).map(|of| self.frame(of)) {
            Some(frame) => Some((frame?, self.number_of_axis_on(along, frame)?)),
            None => self.axis_of_frame(along),
        }
    }

    pub(super) fn read_triad(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let Some(frame) = what.slot(Slot::Of).and_then(|term| self.frame(term)) else {
            return self.say_unused(declaration);
        };
        let on = what.slot(Slot::On).and_then(|on| self.frame(on));
        // "the axes x and z of N", and not as many letters: which is which is not told.
        if subjects.len() > 3 || what.slot(Slot::Which).is_some() {
            return self.say_unused(declaration);
        }
        for (axis, subject) in places_of_axes(subjects) {
            match (on, subject) {
                (Some(on), Term::Formula(letter)) => {
                    self.denote_column(letter, (frame, axis), on, declaration);
                }
                _ => self.name_axis(subject, frame, axis, declaration),
            }
        }
    }

    pub(super) fn read_one_axis(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let frame = what.slot(Slot::Of).and_then(|term| self.frame(term));
        let which = what.slot(Slot::Which);
        let axis = which.and_then(|which| self.number_of_axis_on(which, frame));
        let on = what.slot(Slot::On).and_then(|on| self.frame(on));
        match (frame, axis, subjects, on) {
            // "in components on B"
            (Some(frame), Some(axis), [Term::Formula(letter)], Some(on)) => {
                self.denote_column(letter, (frame, axis), on, declaration);
            }
            (Some(frame), Some(axis), [subject], None) => {
                self.name_axis(subject, frame, axis, declaration);
            }
            _ => {}
        }
    }

    /// An axis of one frame in components on another.
    fn denote_column(
        &mut self,
        letter: &Formula,
        (frame, axis): (FrameId, usize),
        on: FrameId,
        declaration: &Declaration,
    ) {
        let column = Quantity::On(Quantity::Axis(frame, axis).boxed(), on);
        self.denote(letter, Meaning::Quantity(column), declaration);
    }

    /// The vertical axis; the third one of the inertial frame points up where nothing is said.
    pub(super) fn vertical(&self) -> Vertical {
        self.bearings.vertical.unwrap_or(Vertical {
            frame: self.reading.system.ground,
            axis: 2,
            points_down: false,
        })
    }

    /// Whether it is told which axis is vertical; of axes without names it is the third.
    pub(super) fn tells_vertical(&self) -> bool {
        let ground = self.reading.system.ground;
        let unnamed = self.axes.iter().all(|(_, (frame, _))| *frame != ground);
        self.bearings.vertical.is_some() || unnamed || self.has_unit_vector_along_vertical()
    }

    /// "`$k$` is the unit vector along the upward vertical."
    fn has_unit_vector_along_vertical(&self) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == UNIT_VECTOR => {
                what.all(Slot::Along).any(|along| along.is_noun(VERTICAL))
            }
            _ => false,
        })
    }

    /// The unit vector that points up.
    pub(super) fn upward(&mut self) -> Vector {
        let vertical = self.vertical();
        let axis = self.system().axis(vertical.frame, vertical.axis);
        if vertical.points_down { -axis } else { axis }
    }

    pub(super) fn read_vertical(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let ground = self.reading.system.ground;
        let [subject] = subjects else { return };
        if self.body(subject).is_some() || self.is_axis_beside_vertical(subject) {
            return self.say_unused(declaration);
        }
        let axis = self.number_of_axis(subject).unwrap_or(2);
        let own = self.axis_of_frame(subject);
        let own = own.filter(|&(frame, _)| self.is_kept_in(frame, ground));
        let (frame, axis) = own.unwrap_or((ground, axis));
        self.bearings.vertical = Some(Vertical {
            frame,
            axis,
            points_down: what.is("downward"),
        });
        self.name_axis(subject, frame, axis, declaration);
        self.name_axis_besides(subject, (frame, axis), declaration);
    }

    /// Whether a sentence says that a frame is fixed in another one, in which its axes may lie in any way.
    fn is_kept_in(&self, frame: FrameId, other: FrameId) -> bool {
        let fixed = |what: &NounPhrase| {
            what.all(Slot::FixedIn)
                .any(|kept| self.frame(kept) == Some(other))
        };
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "frame" && fixed(what) => {
                subjects.iter().any(|s| self.frame(s) == Some(frame))
            }
            _ => false,
        })
    }

    /// "z is the upward vertical": in formulas z is a number, but where only its unit vector fits.
    fn name_axis_besides(
        &mut self,
        subject: &Term,
        (frame, axis): (FrameId, usize),
        declaration: &Declaration,
    ) {
        let Term::Name(name) = subject else { return };
        // Where it is the axis of a frame that may turn, it is that one.
        let told = self.told_axes(name);
        if !told.is_empty() && !told.contains(&(frame, axis)) {
            return;
        }
        let letter = written(name);
        if let Some(node) = letter.as_ref().and_then(node_of)
            && matches!(node.kind, Kind::Symbol(_))
        {
            let vector = Meaning::Quantity(Quantity::Axis(frame, axis));
            let letter = self.letter(&Formula::of(node), vector, declaration);
            let besides = letter.map(|letter| Letter {
                besides: true,
                ..letter
            });
            self.reading.letters.letters.extend(besides);
        }
    }

    pub(super) fn name_axis(
        &mut self,
        subject: &Term,
        frame: FrameId,
        axis: usize,
        declaration: &Declaration,
    ) {
        if let Some(name) = name_of(subject) {
            self.axes.insert(name, frame, axis);
        }
        if let Term::Formula(formula) = subject
            && node_of(formula).is_some()
        {
            let quantity = Quantity::Axis(frame, axis);
            self.denote(&formula.clone(), Meaning::Quantity(quantity), declaration);
        }
    }

    /// The number of an axis that is the same on both frames.
    pub(super) fn shared_axis(
        &self,
        about: &Term,
        frame: FrameId,
        relative: FrameId,
    ) -> Option<usize> {
        let Some(name) = name_of(about).filter(|_| !about.is_noun(VERTICAL)) else {
            if let Some(own) = self.own_axis_of_shape(about, frame) {
                return Some(own);
            }
            // "the first axis" is that of both, "the first axis of B" that of B
            if let Term::Phrase(axis) = about
                && let ("axis", [(Slot::Which, number @ Term::Numbers(_))]) =
                    (axis.head, axis.slots.as_slice())
            {
                return self.number_of_axis(number);
            }
            let (of, axis) = self.axis_of_frame(about)?;
            return (of == frame || of == relative).then_some(axis);
        };
        let own = [frame, relative].into_iter().find_map(|of| {
            let axis = self.axes.of(&name, of)?;
            Some((of, axis))
        });
        let other = || {
            self.axes
                .get(&name)
                .map(|&at| self.carried_to(&name, at, (frame, relative)))
        };
        match own.or_else(other) {
            // On the other frame the axis may be any; only where it has no name of its own for it is it the same one.
            Some((of, axis)) if of == frame || of == relative => {
                let other = if of == frame { relative } else { frame };
                let there = |(_, place): &(&String, &(FrameId, usize))| **place == (other, axis);
                let mut named = self.axes.iter().filter(there).peekable();
                let frames = &self.reading.system.frames;
                let same = |(n, _): (&String, &(FrameId, usize))| {
                    let own = (n.as_str(), frames[other].name.as_str());
                    same_label(n, &name) || labelled_alike(own, (&name, &frames[of].name))
                };
                let other_known = named.peek().is_some();
                let same = !other_known
                    || named.any(same) && !self.tells_otherwise(&name, other, (frame, relative));
                same.then_some(axis)
            }
            // The axis of a turn lies in both frames: x, y and z of a third one are not meant.
            Some(_)
                if self
                    .axes
                    .iter()
                    .any(|(_, &(of, _))| of == frame || of == relative) =>
            {
                None
            }
            _ => CUSTOMARY
                .iter()
                .find_map(|names| names.iter().position(|n| *n == name)),
        }
    }

    /// Whether a sentence tells that an axis is not the one of its label on another frame.
    fn tells_otherwise(&self, name: &str, other: FrameId, both: (FrameId, FrameId)) -> bool {
        let mut all = self.declarations.iter();
        self.tells_angle_with(name, other)
            || all.any(|d| self.tells_how_axes_lie(d, both.0, both.1))
    }

    /// Whether a sentence tells the angle of an axis with one of a frame: then it need not be one of these.
    fn tells_angle_with(&self, name: &str, frame: FrameId) -> bool {
        let plain = |term: &Term| opposite(term).unwrap_or_else(|| term.clone());
        let of_frame = |term: &Term| self.axis_of_frame(term).is_some_and(|(of, _)| of == frame);
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == "angle" => {
                let between: Vec<Term> = what.all(Slot::Between).map(plain).collect();
                let mut own = between.iter().filter_map(name_of);
                own.any(|own| own == name) && between.iter().any(of_frame)
            }
            _ => false,
        })
    }

    /// An axis of a frame, by its name, or as "the third axis of B".
    pub(super) fn axis_of_frame(&self, term: &Term) -> Option<(FrameId, usize)> {
        match term {
            Term::Phrase(phrase) if phrase.is("negative") => None,
            Term::Phrase(phrase) if phrase.slot(Slot::Along).is_some() => {
                self.axis_of_frame(phrase.slot(Slot::Along)?)
            }
            Term::Phrase(phrase) if phrase.head == "axis" => {
                let which = phrase.slot(Slot::Which)?;
                match phrase.slot(Slot::Of) {
                    Some(frame) => Some((self.frame(frame)?, self.number_of_axis(which)?)),
                    None => self.axes.get(&name_of(which)?).copied(),
                }
            }
            Term::Phrase(phrase) if phrase.head == VERTICAL => {
                let vertical = self.vertical();
                let upward = !phrase.is("downward") && !vertical.points_down;
                let told = upward && phrase.slots.is_empty() && self.tells_vertical();
                told.then_some((vertical.frame, vertical.axis))
            }
            _ => self.axes.get(&name_of(term)?).copied(),
        }
    }

    /// The number of an axis by its name or letter, which on a frame is the one that it has there.
    fn number_of_axis_on(&self, term: &Term, frame: Option<FrameId>) -> Option<usize> {
        let told = || self.axes.of(&name_of(term)?, frame?);
        told().or_else(|| self.number_of_axis(term))
    }

    /// The number of an axis by its name or letter.
    pub(super) fn number_of_axis(&self, term: &Term) -> Option<usize> {
        if let Term::Numbers(numbers) = term {
            return numbers
                .first()
                .map(|n| n.saturating_sub(1))
                .filter(|n| *n < 3);
        }
        if let Term::Phrase(axis) = term
            && axis.head == "axis"
        {
            let which = axis.slot(Slot::Which).or(axis.slot(Slot::Along))?;
            return self.number_of_axis(which);
        }
        let name = name_of(term)?;
        let custom = CUSTOMARY
            .iter()
            .find_map(|names| names.iter().position(|n| *n == name));
        self.axes.get(&name).map(|(_, axis)| *axis).or(custom)
    }
}
