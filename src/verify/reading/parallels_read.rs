//! Vectors that lie along others: "`$H$` points along Z", "`$\\omega$` is parallel to z".

use crate::mechanics::cross;
use crate::verify::language::heads::{KEEPS_DIRECTION, MOMENT, POSITION, WITHOUT_FRICTION};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{AxisPair, BodyId, FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::lying_read::axis_of;

impl Builder<'_> {
    /// A vector is its component along an axis; where it points there, this component is its magnitude.
    pub(super) fn read_parallel(
        &mut self,
        subjects: &[Term],
        axis: &Term,
        points: bool,
        declaration: &Declaration,
    ) -> Option<()> {
        let axis = self.axis_vector(axis, declaration)?;
        for subject in subjects {
            let vector = self.vector(subject, declaration)?;
            let letter = self.magnitudes_of(subject).pop().filter(|_| points);
            let along = match letter {
                Some(letter) => self.scalar_term(&letter, declaration)?,
                None => vector.dot(&axis),
            };
            self.hold_zero(&(vector - axis.clone() * along), declaration);
        }
        Some(())
    }

    /// "`$\omega$` is parallel to z."
    pub(super) fn read_parallel_to(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        let read = match slots {
            [(Slot::With | Slot::Along, axis)] => {
                self.read_parallel(subjects, axis, false, declaration)
            }
            _ => None,
        };
        read.unwrap_or_else(|| self.say_unused(declaration));
    }

    /// Where things lie and vectors point.
    pub(super) fn read_direction(
        &mut self,
        subjects: &[Term],
        verb: &str,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        if verb == "point"
            && let Some((letter, axis)) = self.axis_along_letter(subjects, slots)
        {
            return self.read_pointing(&[letter], &[(Slot::Along, axis)], declaration);
        }
        match verb {
            "point" if formulas(subjects).count() == subjects.len() => {
                self.read_pointing(subjects, slots, declaration);
            }
            "point" if are_moments(subjects) => {
                let read = self.loads_point(subjects, slots, declaration);
                read.unwrap_or_else(|| self.say_unused(declaration));
            }
            "point" if self.loads_point(subjects, slots, declaration).is_some() => {}
            "lie" => {
                if let Some(axis) = axis_of(slots) {
                    self.read_lying(subjects, axis, declaration);
                }
                if let [(Slot::At, at)] = slots
                    && self.end_said(slots).is_none()
                {
                    let read = self.read_lying_at(subjects, at, declaration);
                    read.unwrap_or_else(|| self.say_unused(declaration));
                }
                if let [(Slot::In, Term::Phrase(plane))] = slots {
                    let letters = subjects.iter().all(|s| matches!(s, Term::Formula(_)));
                    let read = match !letters && self.are_points(subjects) {
                        true => self.read_points_in_plane(subjects, plane, declaration),
                        false => self.read_lying_in_plane(subjects, plane, declaration),
                    };
                    if read.is_none() && (letters || self.are_points(subjects)) {
                        self.say_unused(declaration);
                    }
                }
            }
            "move" if self.moves_in_plane(subjects, slots, declaration) => {}
            "move" | "slide" if self.move_as_points(subjects) => {
                let read = self.read_moving(subjects, slots, declaration);
                read.unwrap_or_else(|| self.say_unused(declaration));
            }
            _ => {}
        }
    }

    /// "Z points along `$L$`" is said of an axis, and says that the vector points along it.
    pub(super) fn axis_along_letter(
        &self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
    ) -> Option<(Term, Term)> {
        let ([axis @ Term::Name(name)], [(Slot::Along, letter @ Term::Formula(_))]) =
            (subjects, slots)
        else {
            return None;
        };
        let named = self.axes.get(name).is_some() && self.body(axis).is_none();
        named.then(|| (letter.clone(), axis.clone()))
    }

    /// Whether things move as points do: they are points, or bodies of which a sentence says that they do not turn.
    pub(super) fn move_as_points(&self, things: &[Term]) -> bool {
        let keeps_direction = |thing: &Term| {
            self.declarations.iter().any(|d| {
                let said = d.statement.does(KEEPS_DIRECTION);
                said.is_some_and(|(subjects, _)| subjects.contains(thing))
            })
        };
        things.iter().all(|thing| {
            let alone = std::slice::from_ref(thing);
            let whole = self.body(thing).is_some() || self.frame(thing).is_some();
            self.are_points(alone) || whole && keeps_direction(thing)
        })
    }

    /// Whether things are points and no bodies with an extent.
    pub(super) fn are_points(&self, things: &[Term]) -> bool {
        things.iter().all(|thing| {
            let body = self
                .body(thing)
                .map(|body| &self.reading.system.bodies[body]);
            self.point(thing).is_some() && body.is_none_or(|body| body.frame.is_none())
        })
    }

    /// Whether a sentence tells where a point is.
    fn is_position_told(&self, point: &Term) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == POSITION => {
                what.slot(Slot::Of) == Some(point)
            }
            Statement::Does {
                subjects,
                verb: "lie" | "place",
                ..
            } => subjects.contains(point),
            _ => false,
        })
    }

    /// "P moves along z relative to A", "P slides along the axis through O along z", "G moves in the plane of x and y".
    fn read_moving(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let (relative, ways): (Vec<_>, Vec<_>) = slots
            .iter()
            .partition(|(slot, _)| *slot == Slot::RelativeTo);
        let frame = match relative.as_slice() {
            [] => self.reading.system.ground,
            [(_, frame)] => self.frame(frame)?,
            _ => return None,
        };
        // That there is no friction is told with the loads.
        let counted = self.lists_loads();
        let smooth = |term: &Term| counted && term.is_noun(WITHOUT_FRICTION);
        let ways: Vec<_> = ways.into_iter().filter(|(_, t)| !smooth(t)).collect();
        let (slot, way) = match ways.as_slice() {
            [] => return self.move_freely(subjects, frame),
            [way] => way,
            [(Slot::Along, way), (Slot::At, rate)] => {
                return self.hold_rate_along(subjects, way, rate, frame, declaration);
            }
            _ => return None,
        };
        if let (Slot::Along, Term::Phrase(axis)) = (slot, way)
            && axis.slot(Slot::Through).is_some()
        {
            self.read_lying(subjects, axis, declaration);
            return Some(());
        }
        // "P moves on the turntable": where it is is told by its position.
        let thing = self.frame(way).or(self.body(way)).is_some()
            && matches!(slot, Slot::On | Slot::In | Slot::Along);
        if thing && subjects.iter().all(|s| self.is_position_told(s)) {
            return Some(());
        }
        let points = subjects
            .iter()
            .map(|subject| self.moving_point(subject, frame));
        let points: Option<Vec<_>> = points.collect();
        match (slot, way) {
            (Slot::Along, way) => {
                let axis = self.axis_vector(way, declaration)?;
                for (point, mover) in points?.into_iter().zip(subjects) {
                    self.hold_along(point, mover, &axis, frame, declaration)?;
                }
            }
            (Slot::In, Term::Phrase(plane)) => {
                let normal = self.normal_of_plane(plane, declaration)?;
                for point in points? {
                    let across = self.system().velocity(point, frame).dot(&normal);
                    self.hold(across, declaration);
                }
            }
            _ => return None,
        }
        Some(())
    }

    /// A point, or the mass centre of a body of which all points move alike, as it does not turn relative to a frame.
    pub(super) fn moving_point(&mut self, mover: &Term, frame: FrameId) -> Option<PointId> {
        if let Some(point) = self.point(mover) {
            return Some(point);
        }
        let body = self.body(mover);
        let own = match body {
            Some(body) => self.reading.system.bodies[body].frame?,
            None => self.frame(mover)?,
        };
        let omega = self.system().angular_velocity(own, frame);
        let point = match body {
            Some(body) => self.centre_of(body),
            None => self.reading.system.fixed_point(own),
        };
        (omega == Vector::zeros()).then_some(point)
    }

    /// What moves along an axis has no velocity across it, and what is smooth there does not hold it back.
    fn hold_along(
        &mut self,
        point: PointId,
        mover: &Term,
        axis: &Vector,
        frame: FrameId,
        declaration: &Declaration,
    ) -> Option<()> {
        let velocity = self.system().velocity(point, frame);
        self.hold_zero(&cross(axis, &velocity), declaration);
        self.hold_smooth_force(mover, axis, declaration)
    }

    /// "P moves relative to A": nothing holds it there.
    fn move_freely(&mut self, subjects: &[Term], frame: FrameId) -> Option<()> {
        let points: Option<Vec<_>> = subjects.iter().map(|subject| self.point(subject)).collect();
        let system = self.system();
        let mut at_rest = |point| system.velocity(point, frame) == Vector::zeros();
        let moving = !points?.into_iter().any(&mut at_rest);
        moving.then_some(())
    }

    /// "The arm moves in the plane of x and y": no point of it moves across that.
    pub(super) fn moves_in_plane(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> bool {
        let Some((bodies, normal)) = self.plane_of_motion(subjects, slots, declaration) else {
            return false;
        };
        self.pair_axes_of_plane(slots);
        let ground = self.reading.system.ground;
        for body in bodies {
            let (centre, frame) = (self.centre_of(body), self.reading.system.bodies[body].frame);
            let across = self.system().velocity(centre, ground).dot(&normal);
            self.hold(across, declaration);
            if let Some(frame) = frame {
                let omega = self.system().angular_velocity(frame, ground);
                self.hold_zero(&cross(&normal, &omega), declaration);
            }
        }
        true
    }

    /// Columns of two hold components on the axes of the plane of motion, where no sentence says on which.
    fn pair_axes_of_plane(&mut self, slots: &[(Slot, Term)]) {
        let [(Slot::In, Term::Phrase(plane))] = slots else {
            return;
        };
        let pair = self.pair_of(plane.all(Slot::Of).flat_map(one_by_one));
        if let Some((frame, axes)) = pair {
            let told = false;
            let pair = AxisPair { frame, axes, told };
            self.system().axis_pair.get_or_insert(pair);
        }
    }

    /// The bodies that a sentence says to move in a plane, and the normal of this.
    pub(super) fn plane_of_motion(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<(Vec<BodyId>, Vector)> {
        let [(Slot::In, Term::Phrase(plane))] = slots else {
            return None;
        };
        let bodies = self.bodies_named(subjects)?;
        Some((bodies, self.normal_of_plane(plane, declaration)?))
    }

    /// Rigid bodies by their names, and all bodies by "the system".
    fn bodies_named(&self, subjects: &[Term]) -> Option<Vec<BodyId>> {
        let system = &self.reading.system;
        let named: Option<Vec<BodyId>> = subjects.iter().map(|s| self.body(s)).collect();
        let named = match subjects {
            [Term::Name(all)] if all == "system" && named.is_none() => {
                (0..system.bodies.len()).collect()
            }
            _ => named?,
        };
        let parts: Vec<BodyId> = named.into_iter().flat_map(|b| system.wholes(b)).collect();
        let extended = parts.iter().any(|&body| !system.bodies[body].is_particle());
        (extended && !parts.is_empty()).then_some(parts)
    }

    /// What stands on "the plane of x and y", or on "a plane perpendicular to z".
    pub(super) fn normal_of_plane(
        &mut self,
        plane: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Vector> {
        let axes = plane.slots.iter().flat_map(|(_, axis)| one_by_one(axis));
        let axes: Option<Vec<Vector>> = axes
            .map(|axis| self.axis_vector(&axis, declaration))
            .collect();
        let slot = |slot: Slot| plane.all(slot).count() == plane.slots.len();
        match axes?.as_slice() {
            [normal] if plane.head == "plane" && slot(Slot::With) => Some(normal.clone()),
            [x, y] if plane.head == "plane" && slot(Slot::Of) => Some(cross(x, y)),
            _ => None,
        }
    }

    /// "`$e$` lies in the plane of x and y": no component of the vector is across that.
    fn read_lying_in_plane(
        &mut self,
        subjects: &[Term],
        plane: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let normal = self.normal_of_plane(plane, declaration)?;
        for subject in subjects {
            let vector = self.vector(subject, declaration)?;
            self.hold(vector.dot(&normal), declaration);
        }
        Some(())
    }

    /// Where vectors point; where forces do is read with the loads.
    fn read_pointing(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) {
        if subjects.iter().all(|subject| self.is_force(subject)) {
            // A number is told by the direction; a vector lies along it.
            let vectors = subjects
                .iter()
                .all(|subject| self.vector(subject, declaration).is_some());
            if let ([(Slot::Along, axis)], true) = (slots, vectors) {
                self.read_parallel(subjects, axis, true, declaration);
            }
            return;
        }
        let read = match slots {
            [(Slot::Along, axis)] => self.read_parallel(subjects, axis, true, declaration),
            _ => None,
        };
        read.unwrap_or_else(|| self.say_unused(declaration));
    }

    /// The letters that sentences say to be the magnitude of a vector.
    fn magnitudes_of(&self, vector: &Term) -> Vec<Term> {
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "magnitude" => {
                let own = what.slot(Slot::Of) == Some(vector);
                own.then_some(subjects)
            }
            _ => None,
        });
        said.flatten().cloned().collect()
    }
}

/// Whether all that a sentence is about is moments by their nouns.
pub(super) fn are_moments(subjects: &[Term]) -> bool {
    let moment = |subject: &Term| matches!(subject, Term::Phrase(load) if load.head == MOMENT);
    subjects.iter().all(moment)
}

/// "the first two axes of N" as the first and the second one.
fn one_by_one(axes: &Term) -> Vec<Term> {
    let Term::Phrase(phrase) = axes else {
        return vec![axes.clone()];
    };
    let first = Term::Numbers(vec![1]);
    if !phrase.is("two") || phrase.slot(Slot::Which) != Some(&first) {
        return vec![axes.clone()];
    }
    let numbered = |number: usize| {
        let mut one = (**phrase).clone();
        one.adjectives.retain(|said| *said != "two");
        one.slots.retain(|(slot, _)| *slot != Slot::Which);
        one.slots.push((Slot::Which, Term::Numbers(vec![number])));
        Term::Phrase(Box::new(one))
    };
    vec![numbered(1), numbered(2)]
}
