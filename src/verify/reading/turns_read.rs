//! Turns that are told by angles: Euler angles, angles from the other side, and turns of a part of the document.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::heads::KEEPS_DIRECTION;
use crate::verify::language::statement::{Declaration, Extent, Slot, Statement, Term, slot};
use crate::verify::model::system::{Axis, FrameId, Turn};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::contact_read::CONTACT_POINT;
use crate::verify::reading::frames_read::Said;
use crate::verify::reading::names::{EULER_ANGLES, along_of, is_letter, name_of, told};
use crate::verify::term::value::{Basis, Value};

impl Builder<'_> {
    /// Angles in an order: frames between, each turned about one axis.
    pub(super) fn read_euler_angles(&mut self, declaration: &Declaration) {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return;
        };
        if what.head != EULER_ANGLES {
            return;
        }
        let order: Option<Vec<usize>> = what
            .all(Slot::InOrder)
            .map(|term| self.number_of_axis(term))
            .collect();
        // The first turn is about an axis of both kinds.
        let later = what.all(Slot::InOrder).skip(1);
        let (fixed, turning): (Vec<&Term>, Vec<&Term>) =
            later.partition(|axis| is_fixed_axis(axis));
        if !fixed.is_empty() && !turning.is_empty() {
            return self.say_unused(declaration);
        }
        let frame = what.slot(Slot::Of).and_then(|term| self.frame(term));
        let (Some(order), Some(frame)) = (order, frame) else {
            return self.say_unused(declaration);
        };
        let relative = what
            .slot(Slot::RelativeTo)
            .and_then(|term| self.frame(term));
        let relative = relative.unwrap_or(self.reading.system.ground);
        let mut angles = vec![];
        for subject in subjects {
            let Term::Formula(formula) = subject else {
                continue;
            };
            angles.extend(self.scalar(&formula.clone(), declaration));
        }
        let mut order = order;
        // Turns about axes that stay are turns about those that turn, from the last one to the first.
        if !fixed.is_empty() {
            order.reverse();
            angles.reverse();
        }
        let turned = &self.reading.system.frames[frame];
        if order.len() != angles.len() || !(1..=3).contains(&order.len()) {
            return self.say_unused(declaration);
        }
        if turned.parent == Some(relative) && turned.turn == Turn::Free {
            return self.chain_of_angles(frame, relative, &order, &angles);
        }
        let said: Vec<(usize, Fraction)> = order.into_iter().zip(angles).collect();
        if self.turns_between(frame, relative) != Some(said) {
            self.say_unused(declaration);
        }
    }

    /// The turns about axes by angles that lead from a frame to another, which is above it.
    pub(super) fn turns_between(
        &self,
        frame: FrameId,
        above: FrameId,
    ) -> Option<Vec<(usize, Fraction)>> {
        let (mut turns, mut at) = (vec![], frame);
        while at != above {
            let turned = &self.reading.system.frames[at];
            let Turn::Angle(axis, angle) = &turned.turn else {
                return None;
            };
            turns.push((*axis, (**angle).clone()));
            at = turned.parent?;
        }
        turns.reverse();
        Some(turns)
    }

    pub(super) fn chain_of_angles(
        &mut self,
        frame: FrameId,
        relative: FrameId,
        order: &[usize],
        angles: &[Fraction],
    ) {
        let name = self.reading.system.frames[frame].name.clone();
        let (mut parent, last) = (relative, order.len() - 1);
        for step in 0..last {
            let between = format!("{name}{}", "'".repeat(last - step));
            parent = self.system().add_frame(
                &between,
                Some(parent),
                Turn::Angle(order[step], Box::new(angles[step].clone())),
            );
        }
        let turned = &mut self.reading.system.frames[frame];
        turned.parent = Some(parent);
        turned.turn = Turn::Angle(order[last], Box::new(angles[last].clone()));
    }

    /// "A is a frame that turns relative to N about z": the axis is the same on both.
    pub(super) fn read_turning_frame(&mut self, declaration: &Declaration) {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return;
        };
        if what.head != "frame" || what.slot(Slot::About).is_none() {
            return;
        }
        let relative = what.slot(Slot::RelativeTo).and_then(name_of);
        let slots: Vec<(Slot, Term)> = what.slots.clone();
        for subject in subjects {
            let Some(frame) = self.frame(subject) else {
                continue;
            };
            let said = Said {
                relative: relative.clone(),
                slots: &slots,
                declaration,
            };
            if self.reading.system.frames[frame].turn == Turn::Free {
                self.turn_frame(frame, &said);
            }
        }
    }

    /// A frame that turns at a rate, of which an angle is told from the other side.
    pub(super) fn told_by_angle(
        &mut self,
        frame: FrameId,
        relative: FrameId,
        axis: usize,
        angle: &Fraction,
        declaration: &Declaration,
    ) -> bool {
        let (child, angle) = match self.reading.system.frames[relative].parent {
            Some(parent) if parent == frame => (relative, -angle.clone()),
            _ if self.reading.system.frames[frame].parent == Some(relative) => {
                (frame, angle.clone())
            }
            _ => return false,
        };
        let Turn::Rate(Axis::Number(about), rate) = self.reading.system.frames[child].turn.clone()
        else {
            return false;
        };
        if about != axis {
            return false;
        }
        self.reading.system.frames[child].turn = Turn::Angle(axis, Box::new(angle.clone()));
        let change = self.system().atoms.derivative(&angle);
        self.hold(change - *rate, declaration);
        true
    }

    /// Whether an axis of a third frame does not stay where it is on the frame against which another one turns: by an angle about
    /// such an axis nothing turns.
    pub(super) fn moves_on(&mut self, about: &Term, relative: FrameId, said: &Said<'_>) -> bool {
        let named = name_of(about).is_some_and(|name| self.axes.get(&name).is_some());
        let along = match named {
            true => self.direction(about, said.declaration, None),
            false => None,
        };
        let rate = along.and_then(|along| {
            let axis = Value::vector(&along, Basis::Itself);
            let rate = self.system().rate_of_value(&axis, relative).ok()?;
            rate.to_vector().ok()
        });
        rate.is_some_and(|rate| !self.vanishes(&rate))
    }

    /// A turn by an angle about a vector, where no sentence says that the axes lie otherwise when the angle is zero.
    pub(super) fn turn_by_angle_about(
        &mut self,
        frame: FrameId,
        relative: FrameId,
        about: &Term,
        angle: &Fraction,
        said: &Said<'_>,
    ) -> Option<Turn> {
        let mut others = self.declarations.iter();
        if others.any(|d| self.relates_axes(d, frame, relative)) {
            return None;
        }
        // How a frame "is turned" tells where it is: the axis of that may be another one at another time.
        let placed = said.declaration.text.contains("turned");
        if placed && self.may_move(about) {
            return None;
        }
        let anchor = self.reading.system.anchor(frame);
        let along = self.direction(about, said.declaration, Some(anchor))?;
        let work = self.reading.system.work;
        let along = mechanics::apply(&self.system().rotation(anchor, work), &along);
        Some(Turn::About(Box::new(along), Box::new(angle.clone())))
    }

    /// Whether a direction is a letter of which no sentence says where it is fixed or along what it is.
    fn may_move(&self, about: &Term) -> bool {
        match about {
            Term::Formula(letter) if is_letter(letter) => {
                self.said_fixed(letter).is_none() && self.directed_elsewhere(letter).is_none()
            }
            _ => false,
        }
    }

    /// A turn that holds for a part of the document: ω is along the axis, with the rate that is told.
    pub(super) fn hold_turn(
        &mut self,
        frame: FrameId,
        relative: FrameId,
        about: &Term,
        angle: Option<Fraction>,
        rate: Option<Fraction>,
        declaration: &Declaration,
    ) {
        let Some(along) = self.direction(about, declaration, Some(relative)) else {
            return self.say_unused(declaration);
        };
        let omega = self.system().angular_velocity(frame, relative);
        let rate = match (rate, angle) {
            (Some(rate), _) => Some(rate),
            (None, Some(angle)) => Some(self.system().atoms.derivative(&angle)),
            (None, None) => None,
        };
        match rate {
            Some(rate) => {
                for k in 0..3 {
                    let equation = omega[k].clone() - rate.clone() * along[k].clone();
                    self.hold(equation, declaration);
                }
            }
            None => {
                let across = mechanics::cross(&omega, &along);
                for k in 0..3 {
                    self.hold(across[k].clone(), declaration);
                }
            }
        }
    }
}

impl Builder<'_> {
    /// "S does not turn relative to N."
    pub(super) fn read_kept_direction(&mut self, declaration: &Declaration) {
        if declaration.extent != Extent::Document {
            return;
        }
        for (frame, relative) in self.directions_kept(declaration) {
            match frame.zip(relative) {
                Some((frame, relative)) if self.is_free_against(frame, relative) => {
                    self.reading.system.frames[frame].turn = Turn::Fixed;
                }
                _ => self.say_unused(declaration),
            }
        }
    }

    /// "In this section S does not turn relative to N": there its angular velocity vanishes, whatever else is told elsewhere.
    pub(super) fn hold_directions_kept(&mut self) {
        for declaration in self.declarations {
            if declaration.extent == Extent::Document {
                continue;
            }
            for (frame, relative) in self.directions_kept(declaration) {
                match frame.zip(relative) {
                    Some((frame, relative)) => {
                        let turns = self.system().angular_velocity(frame, relative);
                        self.hold_zero(&turns, declaration);
                    }
                    None => self.say_unused(declaration),
                }
            }
        }
    }

    /// What a sentence says not to turn, and relative to what.
    fn directions_kept(
        &self,
        declaration: &Declaration,
    ) -> Vec<(Option<FrameId>, Option<FrameId>)> {
        let Some((subjects, slots)) = declaration.statement.does(KEEPS_DIRECTION) else {
            return vec![];
        };
        let ground = self.reading.system.ground;
        let relative = told(slot(slots, Slot::RelativeTo), ground, |term| {
            self.frame(term)
        });
        let frames = subjects.iter().map(|subject| self.frame(subject));
        frames.map(|frame| (frame, relative)).collect()
    }

    /// Whether nothing is told yet of how a frame turns against its parent.
    pub(super) fn is_free_against(&self, frame: FrameId, parent: FrameId) -> bool {
        let frame = &self.reading.system.frames[frame];
        frame.parent == Some(parent) && frame.turn == Turn::Free
    }

    /// "The wheel is symmetric about z", of a body that touches a plane, where z is an axis of the frame that the plane is
    /// fixed in and lies in the plane: the body turns about this axis alone.
    pub(super) fn read_axis_in_space(&mut self, declaration: &Declaration) {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return;
        };
        let about = what.slot(Slot::About).map(along_of).and_then(name_of);
        let (true, Some(about)) = (what.head == "symmetric", about) else {
            return;
        };
        let ground = self.reading.system.ground;
        let Some(axis) = self.axes.of(&about, ground) else {
            return;
        };
        for subject in subjects {
            let body = self.body(subject);
            let frame = body.and_then(|body| self.reading.system.bodies[body].frame);
            if let (Some(frame), true, false) =
                (frame, self.touches_plane(subject), self.stands_up(axis))
                && self.axes.of(&about, frame).is_none()
                && self.is_free_against(frame, ground)
            {
                let rate = self.own_rate(frame);
                self.reading.system.frames[frame].turn =
                    Turn::Rate(Axis::Number(axis), Box::new(rate));
            }
        }
    }

    /// Whether a sentence says that a body rolls on something, or touches it.
    fn touches_plane(&self, body: &Term) -> bool {
        let named = |term: &Term| name_of(term) == name_of(body);
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Does {
                subjects,
                verb: "roll",
                ..
            } => subjects.iter().any(named),
            Statement::Is { what, .. } if what.head == CONTACT_POINT => {
                what.all(Slot::Of).any(named)
            }
            _ => false,
        })
    }

    /// Whether an axis of the inertial frame is vertical, or stands on the plane.
    fn stands_up(&self, axis: usize) -> bool {
        let ground = self.reading.system.ground;
        let vertical = self.vertical();
        let upright = vertical.frame == ground && vertical.axis == axis && !self.has_plane_anyhow();
        upright || self.bearings.lie.normal() == Some(axis)
    }
}

/// "the fixed axis x"
fn is_fixed_axis(axis: &Term) -> bool {
    matches!(axis, Term::Phrase(axis) if axis.is("fixed"))
}
