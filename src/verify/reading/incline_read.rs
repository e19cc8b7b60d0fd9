//! Inclined planes: along which axis they fall, and by what angle.

use crate::verify::language::heads::{DOWNHILL, NORMAL};
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::model::system::{Turn, Vector};
use crate::verify::reading::axes_read::Vertical;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, name_of};

impl Builder<'_> {
    /// The vertical where a plane falls along one axis of the inertial frame and another one stands on it. The vertical is
    /// the axis of a frame that is turned back by the angle: of a plane that falls along x with the normal y, the upward
    /// vertical is cos α y − sin α x.
    pub(super) fn read_incline(&mut self) {
        let declarations = self.declarations;
        let Some((angle, declaration)) = declarations.iter().find_map(angle_of_incline) else {
            return;
        };
        let Some(down) = self.axis_that_is(DOWNHILL, &[0]) else {
            return;
        };
        let free: Vec<usize> = (1..3).filter(|axis| *axis != down).collect();
        let normal = self.axis_that_is(NORMAL, &free);
        let Some(normal) = normal.filter(|normal| *normal != down) else {
            return;
        };
        let letter = Term::Formula(angle.clone());
        self.read_size(std::slice::from_ref(&letter), declaration);
        let Some(angle) = self.scalar_term(&letter, declaration) else {
            return;
        };
        let turned = match (normal + 3 - down) % 3 {
            1 => angle,
            _ => -angle,
        };
        let ground = self.reading.system.ground;
        let turn = Turn::Angle(3 - down - normal, Box::new(turned));
        let level = self.system().add_frame("level", Some(ground), turn);
        self.vertical = Some(Vertical {
            frame: level,
            axis: normal,
            points_down: false,
        });
    }

    /// The normal of the inclined plane.
    pub(super) fn normal_of_incline(&mut self) -> Option<Vector> {
        let ground = self.reading.system.ground;
        let vertical = self.vertical.filter(|vertical| vertical.frame != ground)?;
        Some(self.system().axis(ground, vertical.axis))
    }

    /// The axis of the inertial frame that a sentence says to be downhill, or normal to the plane; a letter that names none
    /// yet names the first of the free ones.
    fn axis_that_is(&mut self, noun: &str, free: &[usize]) -> Option<usize> {
        let declarations = self.declarations;
        let (subject, declaration) = declarations.iter().find_map(|declaration| {
            let subject = match &declaration.statement {
                Statement::Is { subjects, what } if what.head == noun => subjects.first()?.clone(),
                // "normal to y", "y is perpendicular to the incline"
                Statement::Is { what, .. } if noun == NORMAL && what.head == "plane" => {
                    what.slot(Slot::With)?.clone()
                }
                Statement::Is { subjects, what }
                    if noun == NORMAL
                        && what.head == "orthogonal"
                        && what.slot(Slot::With).is_some_and(is_incline) =>
                {
                    subjects.first()?.clone()
                }
                _ => return None,
            };
            Some((subject, declaration))
        })?;
        let ground = self.reading.system.ground;
        let known = name_of(&subject).and_then(|name| self.axes.get(&name).copied());
        match known {
            Some((frame, axis)) => (frame == ground).then_some(axis),
            None => {
                let axis = *free.first()?;
                self.name_axis(&subject, ground, axis, declaration);
                Some(axis)
            }
        }
    }
}

/// Whether a term names an inclined plane.
pub(super) fn is_incline(term: &Term) -> bool {
    match term {
        Term::Phrase(phrase) if phrase.head == DOWNHILL => {
            phrase.slot(Slot::Of).is_some_and(is_incline)
        }
        term => name_of(term).is_some_and(|name| matches!(name.as_str(), "incline" | "slope")),
    }
}

/// The angle of an inclined plane with the horizontal, and the sentence that gives it.
pub(super) fn angle_of_incline(declaration: &Declaration) -> Option<(&Formula, &Declaration)> {
    let found = match &declaration.statement {
        Statement::Is { subjects, what } if matches!(what.head, "angle" | "inclination") => {
            let between: Vec<&Term> = what.all(Slot::Between).collect();
            let of = what.slot(Slot::Of).into_iter().chain(between);
            of.into_iter()
                .any(is_incline)
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
            let own = subjects.iter().any(is_incline);
            own.then(|| by.map(|(_, term)| term)).flatten()
        }
        _ => None,
    }?;
    Some((letter_of(found)?, declaration))
}
