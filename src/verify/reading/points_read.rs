//! Points: where each is placed, and in which frames it is fixed.

use crate::algebra::{Fraction, Place};
use crate::verify::language::statement::{Declaration, Extent, Slot, Statement, Term, slot};
use crate::verify::model::system::{FrameId, Point, PointId, Vector};
use crate::verify::reading::bodies_read::EACH;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{
    MASS_CENTRE, UNIT_VECTOR, is_letter, is_marked_vector, letter_of, name_of,
};
use crate::verify::reading::points_spoken::Spoken;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::{Quantity, Spot};
use std::collections::BTreeSet;

impl Builder<'_> {
    /// Places every point: pivots first, then mass centres, then what is fixed in bodies, then what moves freely.
    pub(super) fn place_points(&mut self) {
        self.tell_lengths_of_rods();
        let mut spoken = self.spoken_points();
        self.share_centres(&mut spoken);
        self.add_centres(&mut spoken);
        self.add_origins(&mut spoken);
        self.leave_rest_of_wholes(&mut spoken);
        let ground = self.reading.system.ground;
        let each = |s: &Spoken| {
            let body = s.centre_of.map(|body| &self.reading.system.bodies[body]);
            body.is_some_and(|body| body.members.is_some())
        };
        let centres = spoken.iter().filter(|s| s.centre_of.is_some());
        let centres: BTreeSet<String> = centres.map(|s| s.name.clone()).collect();
        let from_centre = |s: &Spoken| {
            self.lies_from(s)
                .is_some_and(|from| centres.contains(&from))
        };
        let outside = self.placed_from_outside(&spoken);
        let rank = |s: &Spoken| match s {
            s if each(s) => 5,
            s if s.rest_of.is_some() => 6,
            s if s.fixed_in.contains(&ground) && s.fixed_in.len() > 1 => 0,
            s if s.fixed_in.contains(&ground) => 1,
            // From a joint the mass centres of both bodies are placed.
            s if s.fixed_in.len() > 1 && !from_centre(s) => 1,
            // What is placed from outside carries all that is fixed where it is.
            s if outside.contains(&s.name) => 1,
            s if s
                .centre_of
                .is_some_and(|b| !self.reading.system.bodies[b].parts.is_empty()) =>
            {
                6
            }
            s if s.centre_of.is_some() && s.lies.is_none() => 2,
            s if s.lies.is_some() => 3,
            s if !s.fixed_in.is_empty() => 4,
            _ => 5,
        };
        spoken.sort_by_key(rank);
        while !spoken.is_empty() {
            let ready = |s: &Spoken| self.may_be_placed(s) && !self.lies_from_one_of(&spoken, s);
            let next = spoken.iter().position(ready);
            let point = spoken.remove(next.unwrap_or(0));
            self.place_point(&point);
        }
        for (own, of) in self.points_of.clone() {
            self.reading.system.bodies[own].centre = self.centre_of(of);
        }
        self.let_places_change();
        self.hold_other_places();
        self.hold_inertial_frames();
        self.name_ways();
    }

    /// The points that are fixed in frames, and placed from one that is fixed in others.
    fn placed_from_outside(&self, spoken: &[Spoken]) -> BTreeSet<String> {
        let outside = |s: &&Spoken| {
            let from = self.lies_from(s);
            let from = spoken
                .iter()
                .find(|other| Some(&other.name) == from.as_ref());
            let apart = |frame: &FrameId| !s.fixed_in.contains(frame);
            let others = from.map_or(&[][..], |from| from.fixed_in.as_slice());
            !s.fixed_in.is_empty() && !others.is_empty() && others.iter().all(apart)
        };
        let placed = spoken.iter().filter(outside);
        placed.map(|s| s.name.clone()).collect()
    }

    /// "G is placed from O by `$\\vec a$`": what the letter is, where no other sentence tells it.
    fn name_ways(&mut self) {
        for declaration in self.declarations {
            let Statement::Does {
                subjects,
                verb: "place",
                slots,
            } = &declaration.statement
            else {
                continue;
            };
            let [subject] = subjects.as_slice() else {
                continue;
            };
            let (Some(Term::Formula(by)), Some(from), Some(of)) = (
                slot(slots, Slot::By),
                slot(slots, Slot::From).and_then(|from| self.point(from)),
                self.point(subject),
            ) else {
                continue;
            };
            if is_letter(by) && !self.is_subject(by) && slot(slots, Slot::On).is_none() {
                let of = Spot::Point(of);
                let way = Quantity::Position { of, from };
                self.denote(by, Meaning::Quantity(way), declaration);
            }
        }
    }

    /// The mass centre of a body of parts, from those of the parts: Σ m r over Σ m.
    fn centre_of_parts(&mut self, body: usize) -> Option<(PointId, Vector)> {
        let parts = self.reading.system.wholes(body);
        if parts == [body] {
            return None;
        }
        let first = self.centre_of(*parts.first()?);
        let mut sum = Vector::zeros();
        for &part in &parts {
            let mass = self.reading.system.bodies[part].mass.clone();
            let centre = self.centre_of(part);
            let own = self.reading.system.position(centre, first) * mass;
            sum += self.reading.system.each_over_members(part, own);
        }
        Some((first, sum / self.reading.system.mass(body)))
    }

    fn place_point(&mut self, spoken: &Spoken) {
        let ground = self.reading.system.ground;
        let in_ground = spoken.fixed_in.contains(&ground);
        let first = self.points.is_empty() && in_ground;
        let mut fixed_in = spoken.fixed_in.clone();
        let bodies: Vec<usize> = spoken.centre_of.into_iter().collect();
        let bodies = [bodies, spoken.also_centre_of.clone()].concat();
        for &body in &bodies {
            if let Some(frame) = self.reading.system.bodies[body].frame
                && !fixed_in.contains(&frame)
            {
                fixed_in.push(frame);
            }
        }
        let point = if first {
            let origin = self.system().origin();
            self.reading.system.points[origin]
                .name
                .clone_from(&spoken.name);
            self.reading.system.points[origin].fixed_in = fixed_in;
            origin
        } else {
            let of_parts = |body| self.centre_of_parts(body);
            let told = spoken.centre_of.and_then(of_parts);
            let told = self.centre_of_rest(spoken).or(told);
            let placed = told.unwrap_or_else(|| self.way_to(spoken, &fixed_in));
            self.system()
                .add_point(&spoken.name, Some(placed), fixed_in)
        };
        self.points.insert(spoken.name.clone(), point);
        for body in bodies {
            self.reading.system.bodies[body].centre = point;
        }
    }

    /// Whether what a point is placed from stands already: an end of the rod whose mass centre it is, or the other way round.
    fn may_be_placed(&self, spoken: &Spoken) -> bool {
        let bodies = &self.reading.system.bodies;
        let stands = |end: &String| self.points.contains_key(end);
        let lies = spoken.lies.map(|index| &self.declarations[index].statement);
        let lies = lies.and_then(|said| said.does("lie").or_else(|| said.does("place")));
        let lies = lies.map(|(_, slots)| slots);
        if let Some((body, _)) = lies.and_then(|slots| self.end_said(slots)) {
            return bodies[body].centre != 0;
        }
        match spoken.centre_of.filter(|_| spoken.lies.is_none()) {
            Some(body) if self.has_placed_ends(body) => bodies[body].ends.iter().all(stands),
            Some(body) => bodies[body].ends.iter().any(stands) || !self.has_ends(body),
            None if lies.is_some_and(|slots| self.lies_from_what_stands(slots)) => true,
            None => {
                let mut ends = self.bodies_that_end_at(&spoken.name).peekable();
                ends.peek().is_none() || ends.any(|(body, _)| bodies[body].centre != 0)
            }
        }
    }

    /// The point that another is placed from, and the way there.
    fn way_to(&mut self, spoken: &Spoken, fixed_in: &[FrameId]) -> (PointId, Vector) {
        let bodies = &self.reading.system.bodies;
        let each = spoken
            .centre_of
            .is_some_and(|body| bodies[body].members.is_some());
        let carried = |index| self.carried_way(index, fixed_in);
        if let Some(placed) = spoken.lies.and_then(carried) {
            return placed;
        }
        if let Some(placed) = spoken.lies.and_then(|index| self.told_way(index, each)) {
            return placed;
        }
        let by_end = spoken.centre_of.and_then(|body| self.centre_from_end(body));
        if let Some(placed) = by_end.or_else(|| self.end_from_centre(&spoken.name)) {
            return placed;
        }
        if let Some(placed) = self.way_along_axis(&spoken.name, fixed_in) {
            return placed;
        }
        let text = format!("r_{{{}}}", spoken.name);
        let system = &mut self.reading.system;
        let of_each = spoken
            .centre_of
            .and_then(|body| system.bodies[body].members.clone());
        let indexed = |name: &str| Some(system.index_in(name.split_once('_')?.1)?.1);
        let member = of_each.or_else(|| indexed(&spoken.name));
        let member = member.as_deref();
        let near = fixed_in.iter().find_map(|&frame| {
            let near = |p: &Point| p.fixed_in.contains(&frame) && indexed(&p.name).is_none();
            Some((system.points.iter().position(near)?, frame))
        });
        let (from, way) = match near {
            Some((near, frame)) => (near, system.carried_vector(&text, frame, member)),
            None => (0, system.free_vector(&text, Place::Coordinate, member)),
        };
        let coordinates = way.iter().filter_map(Fraction::as_variable);
        system.atoms.set_unplaced(coordinates);
        (from, way)
    }

    /// "`$e_1$` is the unit vector from O to P", where `$e_1$` is an axis: P lies somewhere along it.
    fn way_along_axis(&mut self, name: &str, fixed_in: &[FrameId]) -> Option<(PointId, Vector)> {
        let told = self.declarations.iter().find_map(|d| {
            let Statement::Is { subjects, what } = &d.statement else {
                return None;
            };
            let ends = (what.slot(Slot::From)?, what.slot(Slot::To)?);
            let here = what.head == UNIT_VECTOR && name_of(ends.1).as_deref() == Some(name);
            let axis = subjects.iter().find_map(|s| self.axes.get(&name_of(s)?));
            axis.filter(|_| here && d.extent == Extent::Document)
                .and_then(|axis| Some((self.point(ends.0)?, *axis)))
        });
        let (from, (frame, axis)) = told?;
        let distance = self.distance_of(name)?;
        let own = &self.reading.system.points[from].fixed_in;
        let shared: Vec<&FrameId> = fixed_in.iter().filter(|f| own.contains(f)).collect();
        match (shared.is_empty(), shared.contains(&&frame)) {
            (true, _) => {}
            // Both ends are fixed in the frame of the axis.
            (false, true) => self.make_constant(&distance),
            (false, false) => return None,
        }
        self.system().atoms.set_positive(&distance);
        Some((from, self.system().axis(frame, axis) * distance))
    }

    /// The distance, which no sentence tells, of a point that lies along an axis.
    fn distance_of(&mut self, name: &str) -> Option<Fraction> {
        let distance = Quantity::Scalar {
            text: format!("d_{{{name}}}"),
            constant: false,
        };
        self.system().value_of(&distance).ok()?.to_scalar().ok()
    }

    /// Whether the point to which a unit vector leads was placed along it.
    pub(super) fn is_placed_along(
        &mut self,
        axis: &Vector,
        way: &Vector,
        declaration: &Declaration,
    ) -> bool {
        let Statement::Is { what, .. } = &declaration.statement else {
            return false;
        };
        let name = what.slot(Slot::To).and_then(name_of);
        let distance = name.and_then(|name| self.distance_of(&name));
        distance.is_some_and(|distance| *way == axis * distance)
    }

    /// "G lies at the distance a from O along z", "G lies on the third axis of B at the distance a from O", "P is placed from O by r".
    pub(super) fn told_way(
        &mut self,
        index: usize,
        moves_on_its_own: bool,
    ) -> Option<(PointId, Vector)> {
        let declaration = &self.declarations[index];
        let Statement::Does { slots, .. } = &declaration.statement else {
            return None;
        };
        if let Some((body, first)) = self.end_said(slots) {
            return Some((self.centre_of(body), self.way_to_end(body, first)?));
        }
        let from = slot(slots, Slot::From).or_else(|| slot(slots, Slot::RelativeTo))?;
        let from = self.point(from)?;
        Some((from, self.way_said(slots, declaration, moves_on_its_own)?))
    }

    /// "P is placed from O by `$r$`", where both are fixed in one frame and no other sentence tells r: so is r.
    fn carried_way(&mut self, index: usize, fixed_in: &[FrameId]) -> Option<(PointId, Vector)> {
        let (_, slots) = self.declarations[index].statement.does("place")?;
        let Some(Term::Formula(by)) = slot(slots, Slot::By) else {
            return None;
        };
        let from = self.point(slot(slots, Slot::From)?)?;
        let system = &mut self.reading.system;
        let in_both = |frame: &&FrameId| system.points[from].fixed_in.contains(frame);
        let frame = *fixed_in.iter().find(in_both)?;
        if !is_marked_vector(by) || !is_letter(by) || self.is_subject(by) {
            return None;
        }
        let way = self.system().carried_vector(&by.source, frame, None);
        Some((from, way))
    }

    /// "by r", "at the distance a along z", "on the third axis of B at the distance a". A distance of which no rate is written
    /// is constant, unless it is that of what moves on its own; in one that a formula tells, each letter is by itself.
    pub(super) fn way_said(
        &mut self,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
        moves_on_its_own: bool,
    ) -> Option<Vector> {
        if let Some(Term::Formula(by)) = slot(slots, Slot::By) {
            let defined = self.definition_of(by);
            let by = defined.as_ref().unwrap_or(by);
            let way = self.place_value(by, declaration)?.to_vector().ok()?;
            return match slot(slots, Slot::On) {
                Some(on) => self.by_components(&way, on),
                None => Some(way),
            };
        }
        let along = slot(slots, Slot::Along).or(slot(slots, Slot::On))?;
        let along = match self.axis_of_frame(along) {
            Some((frame, axis)) => self.system().axis(frame, axis),
            None => self.direction(along, declaration, None)?,
        };
        let distance = slot(slots, Slot::At)?;
        let changes = moves_on_its_own || self.has_rate(distance);
        let compound = letter_of(distance).filter(|formula| !is_letter(formula));
        if let Some(formula) = compound.filter(|_| !changes) {
            self.tell_letters_of_place(formula, declaration)?;
        }
        let distance = self.scalar_term(distance, declaration)?;
        if !changes && compound.is_none() {
            self.make_constant(&distance);
        }
        Some(along * distance)
    }

    /// "by `$(a, b, c)$` on B": so much along each of its axes.
    fn by_components(&mut self, components: &Vector, on: &Term) -> Option<Vector> {
        let frame = self.frame(on)?;
        let along = |k: usize| self.system().axis(frame, k) * components[k].clone();
        Some(
            (0..3)
                .map(along)
                .fold(Vector::zeros(), |sum, way| sum + way),
        )
    }

    /// A second sentence about a point that stands already: both places are the same there.
    fn hold_other_places(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            let fixed = what.all(Slot::FixedIn).count();
            for subject in subjects {
                if fixed > 1 || fixed == 1 && self.lies_from_beside(subject) {
                    self.hold_fixed(subject, declaration);
                }
            }
            if what.head != MASS_CENTRE {
                continue;
            }
            let Some(body) = what.slot(Slot::Of).and_then(|term| self.body(term)) else {
                continue;
            };
            for name in subjects.iter().filter_map(name_of) {
                if let Some(&point) = self.points.get(&name) {
                    self.hold_centre_at(point, body, declaration);
                }
            }
        }
    }

    /// A point is where the mass centre of a body is, or where the parts of a whole say that it is.
    pub(super) fn hold_centre_at(
        &mut self,
        point: PointId,
        body: usize,
        declaration: &Declaration,
    ) {
        let own = (self.centre_of(body), Vector::zeros());
        let (from, centre) = self.centre_of_parts(body).unwrap_or(own);
        let way = self.system().position(point, from) - centre;
        self.hold_zero(&way, declaration);
    }

    pub(super) fn hold_zero(&mut self, vector: &Vector, declaration: &Declaration) {
        for k in 0..3 {
            if !num_traits::Zero::is_zero(&vector[k]) {
                self.hold(vector[k].clone(), declaration);
            }
        }
    }
}

/// The name of a point or a body, or of the particle that stands for each.
pub(super) fn name_of_particle(term: &Term) -> Option<String> {
    match term {
        Term::Member { family, .. } if family == "particle" => Some(EACH.to_owned()),
        _ => name_of(term),
    }
}
