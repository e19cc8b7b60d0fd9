//! Points: where each is placed, and in which frames it is fixed.

use crate::algebra::Place;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{FrameId, Point, PointId, Vector};
use crate::verify::reading::bodies_read::EACH;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::frames_read::slot;
use crate::verify::reading::names::{MASS_CENTRE, name_of, node_of, reach_of};
use crate::verify::term::labels::rate_of;
use crate::verify::term::letters::{Reach, spelled};

/// What is said of a point, gathered from all sentences.
#[derive(Clone, Debug, Default)]
struct Spoken {
    name: String,
    fixed_in: Vec<FrameId>,
    centre_of: Option<usize>,
    /// The other bodies whose mass centre it is as well.
    also_centre_of: Vec<usize>,
    /// Where it lies, by the sentence that says so.
    lies: Option<usize>,
}

impl Spoken {
    fn is_centre_of(&self, body: usize) -> bool {
        self.centre_of == Some(body) || self.also_centre_of.contains(&body)
    }
}

impl Builder<'_> {
    /// Places every point: pivots first, then mass centres, then what is fixed in bodies, then what moves freely.
    pub(super) fn place_points(&mut self) {
        let mut spoken = self.spoken_points();
        self.share_centres(&mut spoken);
        self.add_centres(&mut spoken);
        let ground = self.reading.system.ground;
        let each = |s: &Spoken| {
            let body = s.centre_of.map(|body| &self.reading.system.bodies[body]);
            body.is_some_and(|body| body.members.is_some())
        };
        let rank = |s: &Spoken| match s {
            s if each(s) => 5,
            s if s.fixed_in.contains(&ground) && s.fixed_in.len() > 1 => 0,
            s if s.fixed_in.contains(&ground) => 1,
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
        for point in spoken {
            self.place_point(&point);
        }
        for (own, of) in self.points_of.clone() {
            self.reading.system.bodies[own].centre = self.centre_of(of);
        }
        self.hold_other_places();
    }

    fn spoken_points(&self) -> Vec<Spoken> {
        let mut all: Vec<Spoken> = vec![];
        for (index, declaration) in self.declarations.iter().enumerate() {
            let whole = reach_of(&declaration.extent) == Reach::All;
            match &declaration.statement {
                Statement::Is { subjects, what }
                    if matches!(what.head, "point" | MASS_CENTRE | "fixed" | "origin") =>
                {
                    for name in subjects.iter().filter_map(name_of) {
                        match self
                            .particle(&name)
                            .filter(|_| what.head == "fixed" && whole)
                        {
                            Some(body) => self.speak_of_centre(&mut all, &name, body, what),
                            None => self.speak_of_point(&mut all, &name, what, whole),
                        }
                    }
                }
                // "P is a particle fixed in B": its mass centre is.
                Statement::Is { subjects, what } if what.slot(Slot::FixedIn).is_some() => {
                    for body in subjects.iter().filter_map(|subject| self.body(subject)) {
                        let name = self.reading.system.bodies[body].name.clone();
                        self.speak_of_centre(&mut all, &name, body, what);
                    }
                }
                // "The mass centres of the gimbal and of the wheel are fixed in B."
                Statement::Premise(p) if p.head == MASS_CENTRE && p.is("fixed") => {
                    for body in p.all(Slot::Of).filter_map(|term| self.body(term)) {
                        let name = format!("centre of {}", self.reading.system.bodies[body].name);
                        self.speak_of_centre(&mut all, &name, body, p);
                    }
                }
                Statement::Does {
                    subjects,
                    verb: "lie" | "place",
                    ..
                } => {
                    for name in subjects.iter().filter_map(name_of_particle) {
                        let particle = self.particle(&name);
                        let spoken = entry(&mut all, &name);
                        spoken.lies = Some(index).filter(|_| whole).or(spoken.lies);
                        spoken.centre_of = spoken.centre_of.or(particle);
                    }
                }
                _ => {}
            }
        }
        all
    }

    /// The particle of a name: where it lies its mass does.
    fn particle(&self, name: &str) -> Option<usize> {
        let body = *self.bodies.get(name)?;
        let whole = &self.reading.system.bodies[body];
        (whole.frame.is_none() && whole.parts.is_empty()).then_some(body)
    }

    /// A point by its name; what is said of a part of the document alone comes later.
    fn speak_of_point(&self, all: &mut Vec<Spoken>, name: &str, what: &NounPhrase, whole: bool) {
        let known = all.iter().any(|s| s.name == name);
        let attribute = what.head == "fixed";
        if attribute && self.frames.contains_key(name) || known && !whole || !known && attribute {
            return;
        }
        let spoken = entry(all, name);
        spoken.fixed_in.extend(self.frames_fixed(what));
        if what.head == MASS_CENTRE {
            let said = what.all(Slot::Of).filter_map(|term| self.body(term));
            let only = what.slot(Slot::Of).is_none().then(|| self.only_body());
            for body in said.chain(only.flatten()) {
                match spoken.centre_of {
                    None => spoken.centre_of = Some(body),
                    Some(known) if known == body => {}
                    Some(_) => spoken.also_centre_of.push(body),
                }
            }
        }
    }

    /// The mass centre of a body, by what the body or the centre is fixed in.
    fn speak_of_centre(&self, all: &mut Vec<Spoken>, name: &str, body: usize, what: &NounPhrase) {
        let spoken = entry(all, name);
        spoken.centre_of = Some(body);
        spoken.fixed_in.extend(self.frames_fixed(what));
    }

    fn frames_fixed(&self, what: &NounPhrase) -> Vec<FrameId> {
        let fixed = what.all(Slot::FixedIn);
        // "the fixed point of the top" is fixed in both.
        if what.head == "point" && what.is("fixed") {
            let body = |term| self.reading.system.bodies[self.body(term)?].frame;
            let own = what.all(Slot::Of).filter_map(body);
            return own.chain([self.reading.system.ground]).collect();
        }
        // The origin of a frame is fixed in it.
        let origin = what.all(Slot::Of).filter(|_| what.head == "origin");
        fixed
            .chain(origin)
            .filter_map(|term| self.frame(term))
            .collect()
    }

    /// Where the mass centres of a whole and of all its parts but one are the same point, that of the last part is too.
    fn share_centres(&self, all: &mut [Spoken]) {
        let system = &self.reading.system;
        for whole in 0..system.bodies.len() {
            let parts = system.wholes(whole);
            let told = |body: usize| all.iter().position(|s| s.is_centre_of(body));
            let each = |part: &usize| system.bodies[*part].members.is_some();
            let Some(place) = told(whole).filter(|_| parts != [whole] && !parts.iter().any(each))
            else {
                continue;
            };
            let apart = parts.iter().filter(|part| told(**part) != Some(place));
            let apart: Vec<usize> = apart.copied().collect();
            let last = match apart.as_slice() {
                [last] if parts.len() > 1 => Some(*last).filter(|last| told(*last).is_none()),
                _ => None,
            };
            let spoken = &mut all[place];
            spoken.also_centre_of.extend(last);
            // Where a part has its mass centre there, this says where the point is.
            if spoken.centre_of == Some(whole) && !spoken.also_centre_of.is_empty() {
                spoken.centre_of = Some(spoken.also_centre_of.remove(0));
                spoken.also_centre_of.push(whole);
            }
        }
    }

    /// A mass centre without a name is a point as well.
    fn add_centres(&self, spoken: &mut Vec<Spoken>) {
        for (body, whole) in self.reading.system.bodies.iter().enumerate() {
            let known = spoken.iter().any(|s| s.is_centre_of(body));
            let stands_for = self.points_of.iter().any(|(own, _)| *own == body);
            let hub = self.hubs.iter().any(|(_, hub)| *hub == body);
            if !known && !stands_for && !hub {
                let particle = whole.frame.is_none() && whole.parts.is_empty();
                let name = if particle {
                    whole.name.clone()
                } else {
                    format!("centre of {}", whole.name)
                };
                spoken.push(Spoken {
                    name,
                    centre_of: Some(body),
                    ..Spoken::default()
                });
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
            let told = spoken.centre_of.and_then(|body| self.centre_of_parts(body));
            let placed = told.unwrap_or_else(|| self.way_to(spoken, &fixed_in));
            self.system()
                .add_point(&spoken.name, Some(placed), fixed_in)
        };
        self.points.insert(spoken.name.clone(), point);
        for body in bodies {
            self.reading.system.bodies[body].centre = point;
        }
    }

    /// The point that another is placed from, and the way there.
    fn way_to(&mut self, spoken: &Spoken, fixed_in: &[FrameId]) -> (PointId, Vector) {
        let bodies = &self.reading.system.bodies;
        let each = spoken
            .centre_of
            .is_some_and(|body| bodies[body].members.is_some());
        if let Some(placed) = spoken.lies.and_then(|index| self.told_way(index, each)) {
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
        for &frame in fixed_in {
            let near = |p: &Point| p.fixed_in.contains(&frame) && indexed(&p.name).is_none();
            if let Some(near) = system.points.iter().position(near) {
                return (near, system.carried_vector(&text, frame, member));
            }
        }
        (0, system.free_vector(&text, Place::Coordinate, member))
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
        let from = slot(slots, Slot::From).or_else(|| slot(slots, Slot::RelativeTo))?;
        let from = self.point(from)?;
        Some((from, self.way_said(slots, declaration, moves_on_its_own)?))
    }

    /// "by r", "at the distance a along z", "on the third axis of B at the distance a". A distance of which no rate is written
    /// is constant, unless it is that of what moves on its own.
    pub(super) fn way_said(
        &mut self,
        slots: &[(Slot, Term)],
        declaration: &Declaration,
        moves_on_its_own: bool,
    ) -> Option<Vector> {
        if let Some(Term::Formula(by)) = slot(slots, Slot::By) {
            return self.place_value(by, declaration)?.to_vector().ok();
        }
        let along = slot(slots, Slot::Along).or(slot(slots, Slot::On))?;
        let along = match self.axis_of_frame(along) {
            Some((frame, axis)) => self.system().axis(frame, axis),
            None => self.direction(along, declaration, None)?,
        };
        let distance = slot(slots, Slot::At)?;
        let changes = moves_on_its_own || self.has_rate(distance);
        let distance = self.scalar_term(distance, declaration)?;
        if !changes {
            self.make_constant(&distance);
        }
        Some(along * distance)
    }

    /// Whether the document writes the rate of a letter: then it changes.
    pub(super) fn has_rate(&self, distance: &Term) -> bool {
        let formula = match distance {
            Term::Formula(formula) => formula,
            Term::Phrase(phrase) => match phrase.slot(Slot::Which) {
                Some(Term::Formula(formula)) => formula,
                _ => return false,
            },
            _ => return false,
        };
        let letter = node_of(formula).map(spelled);
        letter.is_some_and(|letter| self.reading.letters.written.has(&rate_of(&letter)))
    }

    /// A distance of which no rate is written is constant.
    pub(super) fn make_constant(&mut self, value: &crate::algebra::Fraction) {
        use crate::verify::model::atoms::Motion;
        for variable in value.variables() {
            let atom = self.reading.system.atoms.atom_mut(variable);
            atom.motion = Motion::Constant;
            atom.place = Place::Parameter;
        }
    }

    /// A second sentence about a point that stands already: both places are the same there.
    fn hold_other_places(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
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

fn entry<'s>(all: &'s mut Vec<Spoken>, name: &str) -> &'s mut Spoken {
    let at = all.iter().position(|s| s.name == name).unwrap_or_else(|| {
        all.push(Spoken {
            name: name.to_owned(),
            ..Spoken::default()
        });
        all.len() - 1
    });
    &mut all[at]
}
