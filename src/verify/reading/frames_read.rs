//! Frames, and how they turn against one another.

use crate::algebra::Fraction;
use crate::verify::language::messages::number_of_frame;
use crate::verify::language::statement::{Declaration, Slot, Statement, Term, slot};
use crate::verify::model::atoms::whole;
use crate::verify::model::system::{Axis, FrameId, Turn};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{along_of, name_of, opposite};
use crate::verify::reading::parents_read::{carried_by_frames, of_euler_angles, turned_against};
use crate::verify::term::labels::raised;
use crate::verify::term::letters::Reach;
use crate::verify::term::quantity::Quantity;
use num_traits::Zero;
use std::collections::BTreeMap;

/// The names of the axes of a frame that has none of its own.
pub(super) const CUSTOMARY: [[&str; 3]; 3] = [["x", "y", "z"], ["X", "Y", "Z"], ["1", "2", "3"]];

/// The name of the inertial frame, where no sentence says which one it is.
const GROUND: &str = "N";
/// Its name where that is the one of a frame that turns.
const INERTIAL: &str = "inertial";

/// How a frame is said to turn.
pub(super) struct Said<'d> {
    pub(super) relative: Option<String>,
    pub(super) slots: &'d [(Slot, Term)],
    pub(super) declaration: &'d Declaration,
}

impl Builder<'_> {
    /// Gives each frame its place: the inertial one first, then each behind the one that it turns against.
    pub(super) fn name_frames(&mut self) {
        let declarations = self.declarations;
        let mut names: Vec<String> = vec![];
        let mut inertial: Vec<String> = vec![];
        for declaration in declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if what.head != "frame" {
                continue;
            }
            for name in subjects.iter().filter_map(name_of) {
                match what.is("inertial") {
                    true => inertial.push(name),
                    false => names.push(name),
                }
            }
        }
        // A frame that turns is not the inertial one, however it is called.
        let customary = match names.iter().any(|name| name == GROUND) {
            true if self.is_said_to_turn(GROUND) => INERTIAL,
            _ => GROUND,
        };
        let ground = inertial.first().cloned();
        let ground = ground.unwrap_or_else(|| customary.to_owned());
        let root = self.system().add_frame(&ground, None, Turn::Fixed);
        self.frames.insert(ground, root);
        for other in inertial.into_iter().skip(1) {
            let frame = self.system().add_frame(&other, Some(root), Turn::Fixed);
            self.frames.insert(other, frame);
        }
        // A body turns as the frame does that is fixed in it. What turns has axes of its own, and so has what others turn against.
        let carried: Vec<(String, String)> =
            declarations.iter().filter_map(carried_by_frames).collect();
        let own = |name: String| {
            let frame = carried.iter().find(|(body, _)| *body == name);
            frame.map_or(name, |(_, frame)| frame.clone())
        };
        let parents = turned_against(declarations).into_iter();
        let parents: BTreeMap<String, String> = parents
            .map(|(name, parent)| (own(name), own(parent)))
            .collect();
        let turning = parents.iter().flat_map(|(name, parent)| [name, parent]);
        names.extend(turning.cloned());
        for name in &names {
            self.add_named_frame(name, &parents, &names, 0);
        }
        for (name, frame) in self.frames.clone() {
            // A frame with a label is written so as a label of others: `S_0` is `S0` there.
            let plain = name.replace("~cal", "");
            // One that is called by its number has this for a label above letters.
            let number = number_of_frame(&plain).map(raised);
            let names = [plain.replace('_', ""), plain, name];
            let names = names.into_iter().chain(number).map(|name| (name, frame));
            self.reading.letters.frame_names.extend(names);
        }
        self.same_frames();
    }

    /// Whether a sentence says that a frame is a rotating or moving one.
    fn is_said_to_turn(&self, name: &str) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let turns = what.is("rotating") || what.is("moving");
                let own = |subject: &Term| name_of(subject).as_deref() == Some(name);
                what.head == "frame" && turns && subjects.iter().any(own)
            }
            _ => false,
        })
    }

    fn add_named_frame(
        &mut self,
        name: &str,
        parents: &BTreeMap<String, String>,
        names: &[String],
        depth: usize,
    ) {
        if self.frames.contains_key(name) || depth > names.len() {
            return;
        }
        let parent = parents.get(name).filter(|parent| *parent != name).cloned();
        if let Some(parent) = &parent
            && names.contains(parent)
        {
            self.add_named_frame(parent, parents, names, depth + 1);
        }
        let parent = parent
            .and_then(|p| self.frames.get(&p).copied())
            .unwrap_or(self.reading.system.ground);
        let frame = self.system().add_frame(name, Some(parent), Turn::Free);
        self.frames.insert(name.to_owned(), frame);
    }

    /// Frames that are also written otherwise.
    fn same_frames(&mut self) {
        for declaration in self.declarations {
            let Statement::Same { subjects, others } = &declaration.statement else {
                continue;
            };
            for (subject, other) in subjects.iter().zip(others) {
                let (Some(one), Some(two)) = (name_of(subject), name_of(other)) else {
                    continue;
                };
                let known = self
                    .frames
                    .get(&two)
                    .or_else(|| self.frames.get(&one))
                    .copied();
                let Some(frame) = known else { continue };
                for name in [one, two] {
                    self.reading.letters.frame_names.push((name.clone(), frame));
                    self.reading
                        .letters
                        .frame_names
                        .push((name.replace("~cal", ""), frame));
                    self.frames.insert(name, frame);
                }
            }
        }
    }

    /// How each frame turns; what is said of a part of the document alone becomes a premise there.
    pub(super) fn turn_frames(&mut self) {
        let declarations = self.declarations;
        self.read_axes();
        self.choose_work_frame();
        let (chains, angles): (Vec<_>, Vec<_>) = declarations
            .iter()
            .partition(|declaration| self.is_untold(declaration));
        for declaration in chains {
            self.read_euler_angles(declaration);
        }
        self.read_turns();
        for declaration in declarations {
            self.read_kept_direction(declaration);
            self.read_axis_in_space(declaration);
        }
        for declaration in angles {
            self.read_euler_angles(declaration);
        }
        self.hold_told_attitudes();
        self.read_lines();
    }

    /// Whether a sentence gives Euler angles of a frame that no sentence turns by an angle.
    fn is_untold(&self, declaration: &Declaration) -> bool {
        let Some((of, relative)) = of_euler_angles(declaration) else {
            return false;
        };
        let of = self.frame(&Term::Name(of));
        let ground = self.reading.system.ground;
        let relative = relative.map_or(Some(ground), |name| self.frames.get(&name).copied());
        let parent = of.and_then(|of| self.reading.system.frames[of].parent);
        parent.is_some() && parent == relative
    }

    pub(super) fn turn_frame(&mut self, frame: FrameId, said: &Said<'_>) {
        let system = &self.reading.system;
        let relative = said
            .relative
            .as_ref()
            .and_then(|name| self.frame(&Term::Name(name.clone())));
        if relative.is_none() && said.relative.is_some() {
            return self.say_unused(said.declaration);
        }
        let relative = self.nearest_fixed_in(relative.unwrap_or(system.ground), frame);
        let Some(about) = slot(said.slots, Slot::About).cloned() else {
            return;
        };
        let backwards = opposite(&about);
        let sign = whole(if backwards.is_some() { -1 } else { 1 });
        let about = backwards.unwrap_or(about);
        if let Term::Phrase(axis) = &about
            && let Some(point) = axis.slot(Slot::Through)
        {
            let told = (frame, relative, point.clone(), said.declaration.clone());
            self.through.push(told);
        }
        let whole = crate::verify::reading::names::reach_of(&said.declaration.extent) == Reach::All;
        let of_parent = system.frames[frame].parent == Some(relative);
        let free = system.frames[frame].turn == Turn::Free;
        let [angle, rate] = [Slot::By, Slot::At].map(|how| slot(said.slots, how).cloned());
        let shared = self.shared_axis(along_of(&about), frame, relative);
        // Where an angle is told, the axes are the same in their order where it is zero.
        let in_order = || self.axis_in_order(along_of(&about), frame, relative);
        let shared = shared.or_else(|| angle.as_ref().and_then(|_| in_order()));
        if angle.is_some() && shared.is_none() && self.axis_changes(&about, relative) {
            return self.say_unused(said.declaration);
        }
        let mut number = |term| {
            self.scalar_term(&term, said.declaration)
                .map(|n| n * sign.clone())
        };
        let (angle, rate) = (angle.and_then(&mut number), rate.and_then(&mut number));
        // "N is turned relative to B": B is turned back relative to N.
        if let (true, Some(angle), Some(axis)) = (whole, &angle, shared)
            && self.is_free_against(relative, frame)
        {
            let back = Turn::Angle(axis, Box::new(-angle.clone()));
            self.reading.system.frames[relative].turn = back;
            return;
        }
        if whole && of_parent && free {
            if let Some(turn) = self.turn_of(frame, relative, &about, (angle, rate), shared, said) {
                self.reading.system.frames[frame].turn = turn;
            }
            return;
        }
        if whole
            && let (Some(angle), Some(axis)) = (&angle, shared)
            && self.told_by_angle(frame, relative, axis, angle, said.declaration)
        {
            return;
        }
        self.hold_turn(frame, relative, &about, angle, rate, said.declaration);
    }

    /// Whether the document writes the rate of the axis of a turn against the ground. A turn about an axis that is kept would make
    /// that rate zero and prove whatever stands beside it: the turn is meant from one attitude to another one, about an axis that changes.
    fn axis_changes(&self, about: &Term, relative: FrameId) -> bool {
        relative == self.reading.system.ground && self.writes_rate(about)
    }

    /// How a frame turns by an angle or at a rate.
    fn turn_of(
        &mut self,
        frame: FrameId,
        relative: FrameId,
        about: &Term,
        (angle, rate): (Option<Fraction>, Option<Fraction>),
        shared: Option<usize>,
        said: &Said<'_>,
    ) -> Option<Turn> {
        Some(match (angle, rate, shared) {
            (Some(angle), _, Some(axis)) => Turn::Angle(axis, Box::new(angle)),
            (None, Some(rate), Some(axis)) => Turn::Rate(Axis::Number(axis), Box::new(rate)),
            (None, None, Some(axis)) => {
                Turn::Rate(Axis::Number(axis), Box::new(self.own_rate(frame)))
            }
            (Some(_), _, None) if self.moves_on(about, relative, said) => {
                self.say_unused(said.declaration);
                return None;
            }
            (angle, rate, _) => {
                if let Some(angle) = &angle
                    && let Some(turn) =
                        self.turn_by_angle_about(frame, relative, about, angle, said)
                {
                    return Some(turn);
                }
                // Nothing tells how the axes lie when the angle is zero.
                if angle.is_some() {
                    self.say_unused(said.declaration);
                }
                // It is fixed in both, and how fast they turn against each other is not told yet.
                let nearer = if self.carries_work(frame) {
                    frame
                } else {
                    relative
                };
                let along = self.direction(about, said.declaration, Some(nearer));
                if along.is_none() {
                    self.say_unused(said.declaration);
                }
                let along = along?;
                let rate = match (rate, angle) {
                    (Some(rate), _) => rate,
                    (None, Some(angle)) => self.system().atoms.derivative(&angle),
                    (None, None) => self.own_rate(frame),
                };
                Turn::Rate(Axis::Along(Box::new(along)), Box::new(rate))
            }
        })
    }

    /// Whether the frame on whose axes all is worked out is this one, or turns against it.
    fn carries_work(&self, frame: FrameId) -> bool {
        let frames = &self.reading.system.frames;
        let up = |of: &FrameId| frames[*of].parent;
        let mut chain = std::iter::successors(Some(self.reading.system.work), up);
        chain.any(|of| of == frame)
    }

    /// A rate that has no letter.
    pub(super) fn own_rate(&mut self, frame: FrameId) -> Fraction {
        let text = format!("\\omega_{{{}}}", self.reading.system.frames[frame].name);
        let rate = Quantity::Scalar {
            text,
            constant: false,
        };
        let value = self
            .system()
            .value_of(&rate)
            .ok()
            .and_then(|v| v.to_scalar().ok());
        value.unwrap_or_else(Zero::zero)
    }
}
