//! The line of a body: the axis of its frame along which a rod lies or a link points.

use crate::algebra::Fraction;
use crate::notation::ast::Kind;
use crate::notation::document::Row;
use crate::verify::language::heads::VERTICAL;
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term, slot};
use crate::verify::model::system::{Axis, BodyId, Line, Turn, Vector};
use crate::verify::reading::axes_read::Vertical;
use crate::verify::reading::body_ends::END;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{name_of, opposite};
use num_traits::Zero;

/// The axis of a frame along which the line of a body is, where no sentence tells it.
pub(super) const ALONG: usize = 2;
/// The line of what turns in a plane by its angle with the vertical.
const PLANAR: Line = Line {
    axis: ALONG,
    reversed: false,
    by_points: false,
};
/// The axis about which it turns in a plane, where no sentence tells it.
const ACROSS: usize = 0;

impl<'a> Builder<'a> {
    /// The unit vector along a body: from its first end to the other.
    pub(super) fn line_of(&mut self, body: BodyId) -> Option<Vector> {
        let frame = self.reading.system.bodies[body].frame?;
        let (axis, reversed) = self.axis_of_line(body)?;
        let line = self.system().axis(frame, axis);
        Some(if reversed { -line } else { line })
    }

    /// The axis of its frame along which a body lies, and whether it goes against that.
    pub(super) fn axis_of_line(&self, body: BodyId) -> Option<(usize, bool)> {
        let told = || {
            self.told_axis_of_shape(body)
                .or_else(|| self.own_line(body))
        };
        let line = self.reading.system.bodies[body].line;
        let line = line.map(|line| (line.axis, line.reversed));
        line.or_else(|| Some((told()?, false)))
    }

    /// A rod whose frame has no axes with names lies along the third one, about which it does not turn as a cone may.
    fn own_line(&self, body: BodyId) -> Option<usize> {
        let turns_about = self.axis_of_turn(body) == Some(ALONG);
        let long = self.is_rod(body) && !turns_about || self.is_cone(body);
        (long && !self.has_named_axes(body)).then_some(ALONG)
    }

    /// How bodies point, and how they turn in a plane by the angle of their line.
    pub(super) fn read_lines(&mut self) {
        self.name_ends();
        for declaration in self.declarations {
            self.read_line_at_zero(declaration);
            self.read_planar_angle(declaration);
        }
    }

    /// "At `$\theta = 0$` link 1 points along `$-y$`": its line is that axis of its own frame, which is turned by θ.
    fn read_line_at_zero(&mut self, declaration: &Declaration) -> Option<()> {
        let Statement::Does {
            subjects,
            verb: "point",
            slots,
        } = &declaration.statement
        else {
            return None;
        };
        let [subject] = subjects.as_slice() else {
            return None;
        };
        let body = self.body(subject)?;
        let frame = self.reading.system.bodies[body].frame?;
        let along = slot(slots, Slot::Along)?;
        let (along, reversed) = match opposite(along) {
            Some(along) => (along, true),
            None => (along.clone(), false),
        };
        let (from, axis) = self.axis_of_frame(&along)?;
        let zero = slots.iter().filter(|(slot, _)| *slot == Slot::At);
        let zero: Vec<Fraction> = zero
            .flat_map(|(_, term)| self.angles_that_are_zero(term, declaration))
            .collect();
        let turns = self.turns_between(frame, from)?;
        if turns.iter().all(|(_, angle)| zero.contains(angle)) {
            self.reading.system.bodies[body].line = Some(Line {
                axis,
                reversed,
                by_points: false,
            });
        }
        Some(())
    }

    /// "`$\theta$` is the angle between the rod and the downward vertical", of a rod that moves in a vertical plane: it turns
    /// by this angle. To which side is all the same where no axis of the plane has a name.
    fn read_planar_angle(&mut self, declaration: &Declaration) -> Option<()> {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return None;
        };
        let (Term::Formula(letter), "angle") = (subjects.first()?, what.head) else {
            return None;
        };
        let ends: Vec<&Term> = what.all(Slot::Between).collect();
        let &[one, other] = ends.as_slice() else {
            return None;
        };
        let (line, vertical) = line_and_vertical(one, other)?;
        let body = self.body(line).filter(|&body| self.is_rod(body))?;
        let frame = self.reading.system.bodies[body].frame?;
        let ground = self.reading.system.ground;
        let free = self.is_free_against(frame, ground) && !self.has_named_axes(body);
        if !free
            || self.moves_in_another_plane()
            || !self.moves_in_vertical_plane(body)
            || self.names_horizontal_axes()
        {
            return None;
        }
        let down = self.points_down(vertical, body)?;
        let angle = self.scalar(&letter.clone(), declaration)?;
        let upright = match down {
            true => angle + self.system().atoms.pi(),
            false => angle,
        };
        self.reading.system.frames[frame].turn = Turn::Angle(ACROSS, Box::new(upright));
        self.reading.system.bodies[body].line = Some(PLANAR);
        self.bearings.vertical = Some(Vertical {
            frame: ground,
            axis: ALONG,
            points_down: false,
        });
        Some(())
    }

    /// Whether an angle between the line of a body and the vertical is the one by which that turns.
    pub(super) fn turns_by_line(&self, one: &Term, other: &Term, angle: &Fraction) -> bool {
        let line = line_and_vertical(one, other).map(|(line, _)| line);
        let Some(body) = line.and_then(|line| self.body(line)) else {
            return false;
        };
        let system = &self.reading.system;
        let known = &system.bodies[body];
        let turn = known.frame.map(|frame| &system.frames[frame].turn);
        let by = |turn: &Turn| match (turn, angle.as_variable()) {
            (Turn::Angle(ACROSS, own), Some(angle)) => own.variables().contains(&angle),
            _ => false,
        };
        known.line == Some(PLANAR)
            && turn.is_some_and(by)
            && self.moves_in_vertical_plane(body)
            && !self.names_horizontal_axes()
    }

    /// Which way a vertical points: as it is said, or down from where a body hangs and swings.
    fn points_down(&self, vertical: &Term, body: BodyId) -> Option<bool> {
        let Term::Phrase(vertical) = vertical else {
            return None;
        };
        let hangs = self.declarations.iter().any(|d| match &d.statement {
            Statement::Does {
                subjects,
                verb: "hang",
                ..
            } => subjects.iter().any(|s| self.body(s) == Some(body)),
            _ => false,
        });
        let hangs = self.hangs_by_ends(body).or(hangs.then_some(true));
        match (vertical.is("downward"), vertical.is("upward")) {
            (false, false) => hangs,
            (down, _) => Some(down),
        }
    }

    /// Whether a body hangs from its fixed end: that is the upper one, or the other one is the lower.
    fn hangs_by_ends(&self, body: BodyId) -> Option<bool> {
        let first = self.reading.system.bodies[body].ends.first()?;
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == END => {
                let own = what.slot(Slot::Of).and_then(|of| self.body(of)) == Some(body);
                let name = subjects.first().and_then(name_of).filter(|_| own)?;
                let upper = match (what.is("upper"), what.is("lower")) {
                    (false, false) => None,
                    (upper, _) => Some(upper),
                };
                upper.map(|upper| upper == (name == *first))
            }
            _ => None,
        })
    }

    /// Whether the inertial frame has axes with names beside the vertical.
    fn names_horizontal_axes(&self) -> bool {
        let ground = self.reading.system.ground;
        let told = self.bearings.vertical;
        let upright = |axis: usize| told.is_some_and(|v| v.frame == ground && v.axis == axis);
        let odd = told.is_some_and(|v| v.frame != ground || v.axis != ALONG || v.points_down);
        let mut named = self.axes.iter();
        odd || named.any(|(_, &(frame, axis))| frame == ground && !upright(axis))
    }

    /// "The rod swings in a vertical plane", "it turns about a horizontal axis."
    pub(super) fn moves_in_vertical_plane(&self, body: BodyId) -> bool {
        let plain = |term: &Term, head: &str, adjective: &str| match term {
            Term::Phrase(phrase) => {
                let ground = self.reading.system.ground;
                let still = phrase.slots.iter().all(|(slot, term)| match slot {
                    Slot::FixedIn => self.frame(term) == Some(ground),
                    slot => *slot == Slot::Through,
                });
                phrase.head == head && phrase.is(adjective) && still
            }
            _ => false,
        };
        let plane_moves = self.declarations.iter().any(|d| match &d.statement {
            Statement::Does { subjects, .. } => subjects.iter().any(is_plane_or_axis),
            _ => false,
        });
        !plane_moves
            && self.declarations.iter().any(|d| match &d.statement {
                Statement::Does {
                    subjects,
                    verb: "swing" | "turn" | "move" | "fall",
                    slots,
                } => {
                    let own = subjects.iter().any(|s| self.body(s) == Some(body));
                    own && slots.iter().any(|(_, term)| {
                        plain(term, "plane", "vertical") || plain(term, "axis", "horizontal")
                    })
                }
                _ => false,
            })
    }

    /// Whether more than one sentence speaks of a plane in which bodies move: it need not be the same.
    fn moves_in_another_plane(&self) -> bool {
        let in_plane = |d: &&Declaration| match &d.statement {
            Statement::Does { slots, .. } => slots.iter().any(|(_, term)| match term {
                Term::Phrase(plane) => plane.head == "plane" && !plane.is("same"),
                _ => false,
            }),
            _ => false,
        };
        self.declarations.iter().filter(in_plane).count() > 1
    }

    /// Whether a frame turns in a plane about an axis that it shares with the inertial one.
    pub(super) fn turns_in_plane(&self, body: BodyId) -> bool {
        let system = &self.reading.system;
        let frame = system.bodies[body].frame.map(|frame| &system.frames[frame]);
        frame.is_some_and(|frame| {
            let planar = matches!(frame.turn, Turn::Angle(..) | Turn::Rate(Axis::Number(_), _));
            planar && frame.parent == Some(system.ground)
        })
    }

    /// The angles of "`$\theta = 0$`", "`$\alpha = \beta = 0$`".
    fn angles_that_are_zero(&mut self, term: &Term, declaration: &Declaration) -> Vec<Fraction> {
        let line = match term {
            Term::Formula(Formula {
                row: Row::Line(line),
                ..
            }) => line.clone(),
            _ => return vec![],
        };
        let Some((zero, angles)) = line.sides.split_last() else {
            return vec![];
        };
        let is_zero = matches!(&zero.kind, Kind::Number(number) if number.value.is_zero());
        let letters = angles.iter().filter(|_| is_zero).map(Formula::of);
        letters
            .filter_map(|letter| self.scalar(&letter, declaration))
            .collect()
    }
}

/// "the plane", "the vertical plane", "the axis": what something else moves in or about.
fn is_plane_or_axis(term: &Term) -> bool {
    const MOVED_IN: [&str; 2] = ["plane", "axis"];
    match term {
        Term::Phrase(phrase) => MOVED_IN.contains(&phrase.head),
        Term::Name(name) => MOVED_IN.contains(&name.as_str()),
        _ => false,
    }
}

/// Which of two terms is the vertical: the other one comes first.
fn line_and_vertical<'t>(one: &'t Term, other: &'t Term) -> Option<(&'t Term, &'t Term)> {
    let vertical = |term: &Term| matches!(term, Term::Phrase(p) if p.head == VERTICAL);
    match (vertical(one), vertical(other)) {
        (false, true) => Some((one, other)),
        (true, false) => Some((other, one)),
        _ => None,
    }
}
