//! Points that lie on an axis.

use crate::mechanics::cross;
use crate::verify::language::heads::{AXES, VERTICAL};
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use crate::verify::model::system::PointId;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::MASS_CENTRE;

/// The axis on which something is said to lie; one that lies there at a distance is placed by it.
pub(super) fn axis_of(slots: &[(Slot, Term)]) -> Option<&NounPhrase> {
    match slot(slots, Slot::On)? {
        Term::Phrase(axis)
            if (axis.head == "line" || AXES.contains(&axis.head) && axis.head != VERTICAL)
                && slot(slots, Slot::At).is_none() =>
        {
            Some(axis)
        }
        _ => None,
    }
}

impl Builder<'_> {
    /// "The mass centres of the hub and of the wheel lie on the axis through C along z": the way from C has no part across
    /// the axis.
    pub(super) fn read_lying(
        &mut self,
        subjects: &[Term],
        axis: &NounPhrase,
        declaration: &Declaration,
    ) {
        let through = axis.slot(Slot::Through).and_then(|point| self.point(point));
        let along = axis.slot(Slot::Along).cloned();
        let along = along.or_else(|| self.axis_of_symmetry(axis));
        let along = along.and_then(|along| self.direction(&along, declaration, None));
        let points: Option<Vec<_>> = subjects
            .iter()
            .map(|term| self.points_named_by(term))
            .collect();
        let points: Option<Vec<PointId>> = points.map(|all| all.into_iter().flatten().collect());
        // Where no point of the axis is told it passes through the first of several.
        let first = points.as_ref().filter(|points| points.len() > 1);
        let first = first.and_then(|points| points.first().copied());
        let said = axis.slot(Slot::Through).is_some();
        let through = through.or(first.filter(|_| !said));
        let (Some(through), Some(along), Some(points)) = (through, along, points) else {
            return self.say_unused(declaration);
        };
        for point in points {
            let way = self.system().position(point, through);
            self.hold_zero(&cross(&along, &way), declaration);
        }
    }

    /// Whether it is said where a thing lies, or along what line of its shape.
    pub(super) fn is_lying_heard(&self, subjects: &[Term], slots: &[(Slot, Term)]) -> bool {
        let told = |subject: &Term| {
            let body = self.body(subject);
            body.is_some_and(|body| self.told_axis_of_shape(body).is_some())
        };
        let placed = [Slot::At, Slot::On, Slot::From];
        // A vector or a point that lies in a plane.
        let letters = subjects.iter().all(|s| matches!(s, Term::Formula(_)));
        if (letters || self.are_points(subjects)) && matches!(slots, [(Slot::In, _)]) {
            return true;
        }
        // On a thing, a rim or a surface a point may be anywhere; a line tells more.
        let anywhere = slot(slots, Slot::On).is_some_and(|on| {
            let side = matches!(on, Term::Phrase(side) if side.head == "side");
            slots.len() == 1 && !side && axis_of(slots).is_none()
        });
        let beside = slots.iter().any(|(slot, _)| *slot == Slot::With);
        let placed = slots.iter().any(|(slot, _)| placed.contains(slot));
        !anywhere && !beside && placed || subjects.iter().all(told)
    }

    /// "O, P and G lie in the plane of x and y": the ways between them have no part across it. One alone lies in the plane
    /// through the point from which all places are counted.
    pub(super) fn read_points_in_plane(
        &mut self,
        subjects: &[Term],
        plane: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let normal = self.normal_of_plane(plane, declaration)?;
        let points: Option<Vec<PointId>> = subjects.iter().map(|s| self.point(s)).collect();
        let points = points?;
        let first = match points.as_slice() {
            [_] => 0,
            all => *all.first()?,
        };
        for point in points {
            let way = self.system().position(point, first);
            self.hold(way.dot(&normal), declaration);
        }
        Some(())
    }

    /// The axis about which all bodies are symmetric that a sentence says to be so, where "the symmetry axis" is of none.
    fn axis_of_symmetry(&self, axis: &NounPhrase) -> Option<Term> {
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == "symmetric" => what.slot(Slot::About),
            _ => None,
        });
        // "their mass centres lie on the axis of symmetry" is said of the axis of these.
        let centre = |of: &Term| matches!(of, Term::Phrase(p) if p.head == MASS_CENTRE);
        let alone = axis.head != "axis" && axis.all(Slot::Of).all(centre);
        let mut said = said.filter(|_| alone);
        let first = said.next()?;
        said.all(|other| other == first).then(|| first.clone())
    }

    /// "P is at Q": there is no way between them. Of a point of a body that is where the body touches a plane this holds for
    /// an instant alone.
    pub(super) fn read_lying_at(
        &mut self,
        subjects: &[Term],
        at: &Term,
        declaration: &Declaration,
    ) -> Option<()> {
        let place = self.point(at)?;
        for subject in subjects {
            if self.spot_at_contact(subject).is_some() {
                continue;
            }
            let point = self.point(subject)?;
            let way = self.system().position(point, place);
            self.hold_zero(&way, declaration);
        }
        Some(())
    }

    /// "The mass centre of the system is fixed in N": where it is the parts tell.
    pub(super) fn hold_centre(
        &mut self,
        premise: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        // The mass centres of rotors are at rest in what carries them, and in nothing else.
        for rotors in premise
            .all(Slot::Of)
            .filter_map(|term| self.carried_rotors(term))
        {
            let carrier = self.reading.system.bodies[rotors.1].frame;
            let frames = premise.all(Slot::FixedIn).map(|frame| self.frame(frame));
            frames
                .map(|frame| (frame == carrier).then_some(()))
                .collect::<Option<()>>()?;
        }
        let bodies = premise.all(Slot::Of).filter_map(|term| self.body(term));
        for body in bodies.collect::<Vec<_>>() {
            let centre = self.centre_of(body);
            self.hold_centre_at(centre, body, declaration);
        }
        Some(())
    }

    /// The points that a term names: a point, or the mass centres of bodies.
    fn points_named_by(&self, term: &Term) -> Option<Vec<PointId>> {
        match term {
            Term::Phrase(centres) if centres.head == MASS_CENTRE => {
                let bodies = centres.all(Slot::Of).map(|body| self.body(body));
                bodies.map(|body| Some(self.centre_of(body?))).collect()
            }
            _ => Some(vec![self.point(term)?]),
        }
    }
}
