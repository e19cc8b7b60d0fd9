//! Inclined planes: along which axis they fall, which axis stands on them, and how the vertical lies to them.

use crate::verify::language::heads::{DOWNHILL, NORMAL, TOWARDS, UPHILL, VERTICAL};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::system::{Turn, Vector};
use crate::verify::reading::axes_read::Vertical;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, name_of, opposite};

/// How a plane lies in the inertial frame, by the numbers of its axes.
#[derive(Clone, Copy, Debug, Default)]
pub(super) struct Lie {
    /// The axis along which it falls, and whether that axis points down.
    falls: Option<(usize, bool)>,
    /// The axis that stands on it, and whether that axis points out of it.
    normal: Option<(usize, bool)>,
}

impl Lie {
    /// The number of the axis that stands on the plane.
    pub(super) fn normal(self) -> Option<usize> {
        self.normal.map(|(axis, _)| axis)
    }
}

/// What no sentence need introduce as a plane.
const INCLINE: &str = "incline";

/// Whether a noun says how a plane lies.
pub(crate) fn tells_lie(what: &NounPhrase) -> bool {
    let level = |end: &Term| matches!(end, Term::Phrase(phrase) if is_level(phrase));
    match what.head {
        DOWNHILL | UPHILL | NORMAL => true,
        "angle" => what.all(Slot::Between).any(level),
        _ => false,
    }
}

/// "the horizontal", "a horizontal plane".
fn is_level(phrase: &NounPhrase) -> bool {
    phrase.head == "horizontal" || phrase.is("horizontal")
}

impl Builder<'_> {
    /// How the plane of the document lies, and the vertical by it. Of a plane that falls along x with the normal y, at the
    /// angle α, the upward vertical is cos α y − sin α x: an axis of a frame that is turned back by the angle.
    pub(super) fn read_incline(&mut self) {
        let tilted = self.planes_said().filter(|plane| !plane.is("horizontal"));
        if tilted.count() > 1 {
            return;
        }
        let falls = self.axis_that_is(DOWNHILL, &[0]).map(|axis| (axis, true));
        let falls = falls.or_else(|| Some((self.axis_that_is(UPHILL, &[0])?, false)));
        let down = falls.map(|(axis, _)| axis);
        // What turns about the normal of a plane does so about the third axis, as about a vertical.
        let free: Vec<usize> = match down.is_none() && self.turns_about_normal() {
            true => vec![2],
            false => (1..3).filter(|axis| Some(*axis) != down).collect(),
        };
        let normal = self.axis_that_is(NORMAL, &free);
        let normal = normal.filter(|normal| Some(*normal) != down);
        let out = !self.is_downward_normal();
        self.bearings.lie = Lie {
            falls,
            normal: normal.map(|normal| (normal, out)),
        };
        let declarations = self.declarations;
        for declaration in declarations {
            self.read_turned_vertical(declaration);
        }
        let told = declarations.iter().find_map(|d| self.angle_of_incline(d));
        if let (Some((angle, declaration)), Some((down, points_down)), Some(normal)) =
            (told, falls, normal)
        {
            let forward = ((normal + 3 - down) % 3 == 1) == points_down;
            let about = 3 - down - normal;
            self.turn_vertical((normal, about, forward == out), &angle.clone(), declaration);
            if let Some(vertical) = &mut self.bearings.vertical {
                vertical.points_down = !out;
            }
        }
        if self.bearings.vertical.is_none()
            && let Some(axis) = normal
            && self.planes_said().all(|plane| plane.is("horizontal"))
            && self.planes_said().count() == 1
        {
            self.bearings.vertical = Some(Vertical {
                frame: self.reading.system.ground,
                axis,
                points_down: !out,
            });
        }
    }

    /// "H turns relative to N about `$n$`", where `$n$` is the normal of a plane.
    fn turns_about_normal(&self) -> bool {
        let mut all = self.declarations.iter();
        let normal = all.find_map(|d| self.subject_that_is(NORMAL, &d.statement));
        let about = |d: &Declaration| {
            let turned = d.statement.does("turn");
            turned.is_some_and(|(_, slots)| slot(slots, Slot::About) == normal.as_ref())
        };
        normal.is_some() && self.declarations.iter().any(about)
    }

    /// "z is the downward normal of the floor."
    fn is_downward_normal(&self) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } => what.head == NORMAL && what.is("downward"),
            _ => false,
        })
    }

    /// "The upward vertical is turned relative to y about z by the angle `\alpha`."
    fn read_turned_vertical(&mut self, declaration: &Declaration) {
        let Some(([Term::Phrase(vertical)], slots)) = declaration.statement.does("turn") else {
            return;
        };
        if vertical.head != VERTICAL {
            return;
        }
        let read = self.turned_vertical(vertical.is("downward"), slots, declaration);
        read.unwrap_or_else(|| self.say_unused(declaration));
    }

    /// "The downward vertical is turned from `-y` towards x by the angle `\alpha`": as the upward one from y towards `-x`.
    fn turned_vertical(
        &mut self,
        down: bool,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let (from, opposed) = self.direction_of_ground(slot(slots, Slot::RelativeTo)?)?;
        let towards = slots.iter().find_map(|(_, term)| match term {
            Term::Phrase(way) if way.head == TOWARDS => way.slot(Slot::Of),
            _ => None,
        });
        let (about, forward) = match (towards, slot(slots, Slot::About)) {
            (Some(towards), None) => {
                let (towards, reversed) = self.direction_of_ground(towards)?;
                let about = 3usize.checked_sub(from + towards)?;
                (about, ((from + 1) % 3 == towards) == (opposed == reversed))
            }
            (None, Some(about)) => match self.direction_of_ground(about)? {
                (about, false) if !opposed => (about, true),
                _ => return None,
            },
            _ => return None,
        };
        let angle = slot(slots, Slot::By).and_then(letter_of)?.clone();
        if from == about || slots.len() != 3 {
            return None;
        }
        self.turn_vertical((from, about, forward), &angle, declaration);
        let vertical = self.bearings.vertical.as_mut()?;
        vertical.points_down = opposed != down;
        Some(())
    }

    /// An axis of the inertial frame, and whether the direction against it is meant.
    fn direction_of_ground(&self, term: &Term) -> Option<(usize, bool)> {
        let ground = self.reading.system.ground;
        let axis = |term: &Term| match term {
            Term::Phrase(axis) if axis.head == "axis" && axis.adjectives.is_empty() => {
                let name = name_of(axis.slot(Slot::Which)?)?;
                self.axes.of(&name, ground)
            }
            term => self.axes.of(&name_of(term)?, ground),
        };
        match opposite(term) {
            Some(other) => Some((axis(&other)?, true)),
            None => Some((axis(term)?, false)),
        }
    }

    /// The vertical is an axis of the inertial frame turned about another one by an angle, forward or back.
    fn turn_vertical(
        &mut self,
        (from, about, forward): (usize, usize, bool),
        angle: &Formula,
        declaration: &Declaration,
    ) {
        let letter = Term::Formula(angle.clone());
        self.read_size(std::slice::from_ref(&letter), declaration);
        let Some(angle) = self.scalar_term(&letter, declaration) else {
            return;
        };
        let turned = if forward { angle } else { -angle };
        let ground = self.reading.system.ground;
        let turn = Turn::Angle(about, Box::new(turned));
        let level = self.system().add_frame("level", Some(ground), turn);
        self.bearings.vertical = Some(Vertical {
            frame: level,
            axis: from,
            points_down: false,
        });
    }

    /// The normal of the inclined plane.
    pub(super) fn normal_of_incline(&mut self) -> Option<Vector> {
        let (normal, out) = self.bearings.lie.normal?;
        let ground = self.reading.system.ground;
        let axis = self.system().axis(ground, normal);
        Some(if out { axis } else { -axis })
    }

    /// Whether the vertical is told by how a plane lies.
    pub(super) fn is_tilted(&self) -> bool {
        let ground = self.reading.system.ground;
        let vertical = self.bearings.vertical;
        vertical.is_some_and(|vertical| vertical.frame != ground)
    }

    /// Whether a plane is told by its normal while nothing tells how it lies to the vertical.
    pub(super) fn has_plane_anyhow(&self) -> bool {
        self.bearings.lie.normal.is_some() && self.bearings.vertical.is_none()
    }

    /// "down the slope", "along the uphill direction of the ramp", "along the normal of the floor".
    pub(super) fn direction_of_plane(&mut self, phrase: &NounPhrase) -> Option<Vector> {
        if phrase.head == VERTICAL {
            let down = phrase.is("downward");
            let told = self.tells_vertical() && phrase.slots.is_empty();
            let upward = told.then(|| self.upward())?;
            return Some(if down { -upward } else { upward });
        }
        if phrase.head == NORMAL && self.bearings.lie.normal.is_none() {
            let of = phrase.slot(Slot::Of).filter(|_| phrase.slots.len() == 1);
            return of
                .and_then(|of| self.plane(Some(of)))
                .map(|plane| plane.normal);
        }
        let ground = self.reading.system.ground;
        let (axis, along) = match (phrase.head, self.bearings.lie) {
            (DOWNHILL, Lie { falls, .. }) => falls?,
            (UPHILL, Lie { falls, .. }) => falls.map(|(axis, down)| (axis, !down))?,
            (NORMAL, Lie { normal, .. }) => normal?,
            _ => return None,
        };
        let axis = self.system().axis(ground, axis);
        Some(if along { axis } else { -axis })
    }

    /// The axis of the inertial frame that a sentence says to be downhill, or normal to the plane; a letter that names none
    /// yet names the first of the free ones.
    fn axis_that_is(&mut self, noun: &str, free: &[usize]) -> Option<usize> {
        let declarations = self.declarations;
        let (subject, declaration) = declarations.iter().find_map(|declaration| {
            let subject = self.subject_that_is(noun, &declaration.statement)?;
            Some((subject, declaration))
        })?;
        let ground = self.reading.system.ground;
        let known = self.axis_of_frame(&subject);
        match known {
            Some((frame, axis)) => (frame == ground).then_some(axis),
            None => {
                let axis = *free.first()?;
                self.name_axis(&subject, ground, axis, declaration);
                Some(axis)
            }
        }
    }

    /// What a sentence says to be a direction of a plane; of forces it says how they point.
    fn subject_that_is(&self, noun: &str, statement: &Statement) -> Option<Term> {
        let Statement::Is { subjects, what } = statement else {
            return None;
        };
        let subject = subjects.first()?;
        let of_plane = |term: Option<&Term>| term.is_some_and(|term| self.is_incline(term));
        match what.head {
            head if head == noun => (!self.is_force(subject)).then(|| subject.clone()),
            // "normal to y", "y is perpendicular to the incline"
            "plane" if noun == NORMAL => what.slot(Slot::With).cloned(),
            "orthogonal" if noun == NORMAL && of_plane(what.slot(Slot::With)) => {
                Some(subject.clone())
            }
            _ => None,
        }
    }

    /// Whether a term names an inclined plane.
    pub(super) fn is_incline(&self, term: &Term) -> bool {
        match term {
            Term::Phrase(phrase) if matches!(phrase.head, DOWNHILL | UPHILL) => phrase
                .slot(Slot::Of)
                .is_some_and(|term| self.is_incline(term)),
            term => name_of(term)
                .is_some_and(|name| name == INCLINE || self.plane_called(&name).is_some()),
        }
    }

    /// What a sentence says of a plane, by its name.
    pub(super) fn plane_called(&self, name: &str) -> Option<&NounPhrase> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "plane" => {
                let mut names = subjects.iter().filter_map(name_of);
                names.any(|own| own == name).then_some(what)
            }
            _ => None,
        })
    }

    /// What sentences say of planes.
    fn planes_said(&self) -> impl Iterator<Item = &NounPhrase> {
        let said = self.declarations.iter();
        said.filter_map(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == "plane" => Some(what),
            _ => None,
        })
    }

    /// Whether some ends are an inclined plane and the horizontal.
    pub(super) fn are_incline_and_level(&self, ends: &[&Term]) -> bool {
        let level = |term: &&&Term| match term {
            Term::Phrase(phrase) => is_level(phrase),
            _ => false,
        };
        ends.iter().any(|end| self.is_incline(end)) && ends.iter().any(|end| level(&end))
    }

    /// The angle of an inclined plane with the horizontal, and the sentence that gives it.
    fn angle_of_incline<'d>(
        &self,
        declaration: &'d Declaration,
    ) -> Option<(&'d Formula, &'d Declaration)> {
        let found = match &declaration.statement {
            Statement::Is { subjects, what } if matches!(what.head, "angle" | "inclination") => {
                let between: Vec<&Term> = what.all(Slot::Between).collect();
                let own = what.all(Slot::Of).any(|term| self.is_incline(term));
                (own || self.are_incline_and_level(&between))
                    .then(|| subjects.first())
                    .flatten()
            }
            Statement::Does {
                subjects,
                verb: "incline",
                slots,
            } => {
                let by = slots
                    .iter()
                    .find(|(slot, _)| matches!(slot, Slot::By | Slot::At));
                let own = subjects.iter().any(|term| self.is_incline(term));
                own.then(|| by.map(|(_, term)| term)).flatten()
            }
            _ => None,
        }?;
        Some((letter_of(found)?, declaration))
    }
}
