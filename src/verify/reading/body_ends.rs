//! The ends of bodies on their lines: of a rod both, of a cone its apex.

use crate::algebra::Fraction;
use crate::verify::language::phrase::ORDINALS;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use crate::verify::language::traits::is_conical;
use crate::verify::model::atoms::whole;
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::body_lines::ALONG;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{name_of, reach_of};
use crate::verify::reading::shapes_read::is_rod;
use crate::verify::term::letters::Reach;

/// The noun of the points at which a rod ends.
pub(super) const END: &str = "end";
/// The noun of the point of a cone.
pub(super) const APEX: &str = "apex";

/// By what an end of a body is held, the firmest first.
#[derive(Clone, Copy, PartialEq, Eq, PartialOrd, Ord)]
enum Hold {
    Space,
    Body,
    Nothing,
}

impl Builder<'_> {
    /// Gives each body the names of its ends: those that are fixed in space first.
    pub(super) fn name_ends(&mut self) {
        let mut said: Vec<(BodyId, String)> = vec![];
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && [END, APEX].contains(&what.head)
                && let Some(body) = what.slot(Slot::Of).and_then(|of| self.body(of))
            {
                let names = subjects.iter().filter_map(name_of);
                said.extend(names.map(|name| (body, name)));
            }
        }
        said.sort_by_cached_key(|(body, name)| self.hold_on(*body, name));
        for (body, name) in said {
            let ends = &mut self.reading.system.bodies[body].ends;
            if !ends.contains(&name) {
                ends.push(name);
            }
        }
    }

    /// By what an end is held: in space, by another body, or by nothing.
    fn hold_on(&self, body: BodyId, name: &str) -> Hold {
        let ground = self.reading.system.ground;
        let own = self.reading.system.bodies[body].frame;
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let named = subjects.iter().any(|s| name_of(s).as_deref() == Some(name));
                named.then(|| self.frames_fixed(what))
            }
            _ => None,
        });
        let frames: Vec<_> = said.flatten().collect();
        match frames.contains(&ground) {
            true => Hold::Space,
            false if frames.iter().any(|frame| Some(*frame) != own) => Hold::Body,
            false => Hold::Nothing,
        }
    }

    /// The bodies that have an end of this name, and whether it is the one at which the line of each begins.
    pub(super) fn bodies_that_end_at(&self, name: &str) -> impl Iterator<Item = (BodyId, bool)> {
        let bodies = self.reading.system.bodies.iter().enumerate();
        bodies.filter_map(move |(body, known)| {
            let place = known.ends.iter().position(|end| end == name)?;
            Some((body, place == 0))
        })
    }

    /// Whether the model knows where the ends of a body are: at which one its line begins is a choice only where no sentence
    /// says along which axis it lies. A rod that is told to point somewhere does so from the end by which it is held.
    pub(super) fn has_ends(&self, body: BodyId) -> bool {
        let known = &self.reading.system.bodies[body];
        let chosen = self.axis_of_line(body) == Some((ALONG, false));
        let points = known.line.is_some_and(|line| !line.by_points) && self.is_rod(body);
        let held = |end: &String| self.hold_on(body, end) != Hold::Nothing;
        // The axis of a cone goes from its apex to its base, unless a sentence places one of its ends.
        let told = self.told_axis_of_shape(body).is_some();
        let from_apex = told && self.is_cone(body) && !self.places_from_end(body);
        (1..=2).contains(&known.ends.len())
            && (self.is_rod(body) || self.is_cone(body))
            && (!told || from_apex)
            && (chosen || from_apex || points && known.ends.first().is_some_and(held))
    }

    /// Whether a sentence says where something lies from an end of a body, or where an end lies.
    fn places_from_end(&self, body: BodyId) -> bool {
        let ends = &self.reading.system.bodies[body].ends;
        let mut placings = self
            .declarations
            .iter()
            .filter_map(|d| d.statement.places());
        placings.any(|(subjects, slots)| {
            let both = subjects.iter().chain(slot(slots, Slot::From));
            both.filter_map(name_of).any(|name| ends.contains(&name))
        })
    }

    /// Whether a noun is that of ends that the model knows.
    pub(super) fn is_end_placed(&self, what: &NounPhrase) -> bool {
        let body = what.slot(Slot::Of).and_then(|of| self.body(of));
        let by_points = |body: BodyId| {
            let known = &self.reading.system.bodies[body];
            known.line.is_some_and(|line| line.by_points) && known.ends.len() <= 2
        };
        let Some(body) = body.filter(|&body| self.has_ends(body) || by_points(body)) else {
            return false;
        };
        match what.head {
            END => self.is_rod(body),
            APEX => self.is_cone(body),
            _ => false,
        }
    }

    /// "at the first end of rod 1": of which rod, and whether it is the one at which its line begins.
    pub(super) fn end_said(&self, slots: &[(Slot, Term)]) -> Option<(BodyId, bool)> {
        let Term::Phrase(end) = slot(slots, Slot::At)? else {
            return None;
        };
        let body = end.slot(Slot::Of).and_then(|of| self.body(of))?;
        let mut ends = ORDINALS.into_iter().take(2);
        let which = ends.position(|which| end.is(which))?;
        (end.head == END && self.is_rod(body)).then_some((body, which == 0))
    }

    /// The way from the mass centre of a uniform rod to one of its ends, or of a cone to its apex, at which its line begins.
    pub(super) fn way_to_end(&mut self, body: BodyId, first: bool) -> Option<Vector> {
        let (what, declaration) = self.said_to_be(body, |noun| is_rod(noun) || is_conical(noun))?;
        let told = self.told_axis_of_shape(body);
        if told.is_none() && !self.has_ends(body) {
            self.tell_line_by_points(body)?;
        }
        let (size, part) = match (is_rod(what.head), first) {
            (true, true) => ("length", Fraction::from_ratio(-1, 2)),
            (true, false) => ("length", Fraction::from_ratio(1, 2)),
            (false, true) => ("height", Fraction::from_ratio(-3, 4)),
            (false, false) => return None,
        };
        let size = self.size_of_shape(body, what, size, declaration)?;
        let frame = self.reading.system.bodies[body].frame;
        let line = match told.zip(frame) {
            Some((axis, frame)) => self.system().axis(frame, axis),
            None => self.line_of(body)?,
        };
        Some(line * (size * part))
    }

    /// Whether sentences place both ends of a uniform rod, between which its mass centre is.
    pub(super) fn has_placed_ends(&self, body: BodyId) -> bool {
        let placed = |end: &String| {
            self.declarations.iter().any(|d| {
                let whole = reach_of(&d.extent) == Reach::All;
                d.statement.places().is_some_and(|(subjects, slots)| {
                    let own = subjects.iter().any(|s| name_of(s).as_ref() == Some(end));
                    own && whole && slot(slots, Slot::From).is_some()
                })
            })
        };
        let ends = &self.reading.system.bodies[body].ends;
        let rod = self.said_to_be(body, is_rod);
        rod.is_some_and(|(what, _)| what.is("uniform"))
            && ends.len() == 2
            && ends.iter().all(placed)
    }

    /// The mass centre of a uniform rod is in the middle between its ends.
    fn centre_between_ends(&self, body: BodyId) -> Option<(PointId, Vector)> {
        let ends = &self.reading.system.bodies[body].ends;
        let ends = ends.iter().map(|name| self.points.get(name).copied());
        let ends: Vec<PointId> = ends.collect::<Option<_>>()?;
        let &[first, last] = ends.as_slice() else {
            return None;
        };
        let way = self.reading.system.position(last, first);
        Some((first, way * Fraction::from_ratio(1, 2)))
    }

    /// Where a sentence says along which axis a rod lies, which of its ends is which is no choice: one that says both says that
    /// the rod goes from there along the axis, and with others none is told.
    fn knows_which_end(&self, body: BodyId) -> bool {
        let own = |term: &Term| self.body(term) == Some(body);
        let tells_end = |lies: &Declaration, d: &Declaration| match &d.statement {
            Statement::Is { what, .. } => {
                let at_once = d.line == lies.line && d.text == lies.text;
                at_once && what.head == END && what.slot(Slot::Of).is_some_and(own)
            }
            _ => false,
        };
        let from_end = |lies: &Declaration| {
            let said = lies.statement.does("lie");
            let along = said.is_some_and(|(subjects, slots)| {
                subjects.iter().any(own) && slot(slots, Slot::Along).is_some()
            });
            along && self.declarations.iter().any(|d| tells_end(lies, d))
        };
        !self.is_rod(body)
            || self.told_axis_of_shape(body).is_none()
            || self.declarations.iter().any(from_end)
    }

    /// Where the mass centre of a rod is from an end of it that stands already.
    pub(super) fn centre_from_end(&mut self, body: BodyId) -> Option<(PointId, Vector)> {
        if self.has_placed_ends(body) {
            return self.centre_between_ends(body);
        }
        let mut ends = self.reading.system.bodies[body].ends.iter().enumerate();
        let known = ends.find_map(|(at, name)| Some((at, *self.points.get(name)?)));
        let (at, end) = known.filter(|_| self.knows_which_end(body))?;
        Some((end, self.way_to_end(body, at == 0)? * whole(-1)))
    }

    /// Where an end of a rod is from its mass centre, if that stands already.
    pub(super) fn end_from_centre(&mut self, name: &str) -> Option<(PointId, Vector)> {
        let stands = |(body, _): &(BodyId, bool)| self.reading.system.bodies[*body].centre != 0;
        let placed = self.bodies_that_end_at(name).find(stands);
        let (body, first) = placed.filter(|(body, _)| self.knows_which_end(*body))?;
        Some((self.centre_of(body), self.way_to_end(body, first)?))
    }
}
