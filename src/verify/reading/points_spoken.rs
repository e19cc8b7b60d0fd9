//! What sentences say of points, gathered by their names.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use crate::verify::model::system::FrameId;
use crate::verify::reading::body_ends::{APEX, END};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::corners_read::CORNER;
use crate::verify::reading::names::{MASS_CENTRE, name_of, reach_of};
use crate::verify::reading::points_read::name_of_particle;
use crate::verify::term::letters::Reach;

/// What is said of a point, gathered from all sentences.
#[derive(Clone, Debug, Default)]
pub(super) struct Spoken {
    pub(super) name: String,
    pub(super) fixed_in: Vec<FrameId>,
    pub(super) centre_of: Option<usize>,
    /// The other bodies whose mass centre it is as well.
    pub(super) also_centre_of: Vec<usize>,
    /// Where it lies, by the sentence that says so.
    pub(super) lies: Option<usize>,
    /// The whole whose mass centre, with those of the other parts, tells where it is.
    pub(super) rest_of: Option<usize>,
}

impl Spoken {
    pub(super) fn is_centre_of(&self, body: usize) -> bool {
        self.centre_of == Some(body) || self.also_centre_of.contains(&body)
    }
}

/// The sentences with their places. Wherever they stand, those of a part of the document come behind the others, and those
/// that only say in what a point is fixed behind the ones that name it.
fn naming_first(declarations: &[Declaration]) -> Vec<(usize, &Declaration)> {
    let mut sorted: Vec<_> = declarations.iter().enumerate().collect();
    sorted.sort_by_key(|(_, declaration)| {
        let attribute =
            matches!(&declaration.statement, Statement::Is { what, .. } if what.head == "fixed");
        (reach_of(&declaration.extent) != Reach::All, attribute)
    });
    sorted
}

impl Builder<'_> {
    pub(super) fn spoken_points(&self) -> Vec<Spoken> {
        let mut all: Vec<Spoken> = vec![];
        for (index, declaration) in naming_first(self.declarations) {
            let whole = reach_of(&declaration.extent) == Reach::All;
            match &declaration.statement {
                Statement::Is { subjects, what }
                    if matches!(
                        what.head,
                        "point" | MASS_CENTRE | "fixed" | "origin" | END | APEX | CORNER
                    ) =>
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
                // "O is the centre of the bowl", of one that a frame carries.
                Statement::Is { subjects, what } if what.head == "centre" && whole => {
                    self.speak_of_surface(&mut all, subjects, what);
                }
                Statement::Is { subjects, what } if what.head == "frame" && whole => {
                    self.speak_of_origin(&mut all, subjects, what);
                }
                Statement::Is { subjects, what } if what.slot(Slot::FixedIn).is_some() => {
                    self.speak_of_particles(&mut all, subjects, what);
                }
                // "The mass centres of the gimbal and of the wheel are fixed in B."
                Statement::Premise(p) if p.head == MASS_CENTRE && p.is("fixed") => {
                    for body in p.all(Slot::Of).filter_map(|term| self.body(term)) {
                        let name = self.name_of_centre(body);
                        self.speak_of_centre(&mut all, &name, body, p);
                    }
                }
                Statement::Does {
                    subjects,
                    verb: "lie" | "place",
                    slots,
                } => {
                    let end_of = self.end_said(slots).map(|(body, _)| body);
                    let end_of = end_of.and_then(|body| self.reading.system.bodies[body].frame);
                    for name in subjects.iter().filter_map(|s| self.name_of_place(s)) {
                        let particle = self.particle(&name);
                        let spoken = entry(&mut all, &name);
                        spoken.fixed_in.extend(end_of);
                        spoken.lies = Some(index).filter(|_| whole).or(spoken.lies);
                        let centre = subjects.iter().find_map(|s| self.is_centre_said(s));
                        spoken.centre_of = spoken.centre_of.or(particle).or(centre);
                    }
                }
                _ => {}
            }
        }
        all
    }

    /// "P is a particle fixed in B": its mass centre is.
    fn speak_of_particles(&self, all: &mut Vec<Spoken>, subjects: &[Term], what: &NounPhrase) {
        for body in subjects.iter().filter_map(|subject| self.body(subject)) {
            let name = self.reading.system.bodies[body].name.clone();
            self.speak_of_centre(all, &name, body, what);
        }
    }

    /// "A is a frame fixed at G": there it has its origin.
    fn speak_of_origin(&self, all: &mut Vec<Spoken>, subjects: &[Term], what: &NounPhrase) {
        let frames: Vec<FrameId> = subjects.iter().filter_map(|f| self.frame(f)).collect();
        for name in what.all(Slot::At).filter_map(name_of) {
            entry(all, &name).fixed_in.extend(&frames);
        }
    }

    fn speak_of_surface(&self, all: &mut Vec<Spoken>, subjects: &[Term], what: &NounPhrase) {
        let surface = what.slot(Slot::Of).and_then(|of| self.surface_said(of));
        let Some(surface) = surface else { return };
        for name in subjects.iter().filter_map(name_of) {
            let fixed_in = &mut entry(all, &name).fixed_in;
            fixed_in.retain(|frame| *frame != surface.frame);
            fixed_in.push(surface.frame);
        }
    }

    /// The name of what is said to lie somewhere; a mass centre without one is that of its body.
    fn name_of_place(&self, term: &Term) -> Option<String> {
        let Some(body) = self.is_centre_said(term) else {
            return name_of_particle(term);
        };
        let named = self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == MASS_CENTRE => {
                let of = what.slot(Slot::Of).and_then(|of| self.body(of));
                subjects
                    .first()
                    .and_then(name_of)
                    .filter(|_| of == Some(body))
            }
            _ => None,
        });
        named.or_else(|| {
            Some(format!(
                "centre of {}",
                self.reading.system.bodies[body].name
            ))
        })
    }

    /// The name of a mass centre that has none of its own.
    fn name_of_centre(&self, body: usize) -> String {
        format!("centre of {}", self.reading.system.bodies[body].name)
    }

    /// The body whose mass centre is spoken of: "the mass centre of link 1".
    fn is_centre_said(&self, term: &Term) -> Option<usize> {
        match term {
            Term::Phrase(phrase) if phrase.head == MASS_CENTRE => match phrase.slots.as_slice() {
                [(Slot::Of, body)] => self.body(body),
                _ => None,
            },
            _ => None,
        }
    }

    /// The particle of a name: where it lies its mass does.
    fn particle(&self, name: &str) -> Option<usize> {
        let body = *self.bodies.get(name)?;
        self.reading.system.bodies[body]
            .is_particle()
            .then_some(body)
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

    pub(super) fn frames_fixed(&self, what: &NounPhrase) -> Vec<FrameId> {
        let fixed = what.all(Slot::FixedIn);
        // "the fixed point of the top" is fixed in both.
        if what.head == "point" && what.is("fixed") {
            let body = |term| self.reading.system.bodies[self.body(term)?].frame;
            let own = what.all(Slot::Of).filter_map(body);
            return own.chain([self.reading.system.ground]).collect();
        }
        // The origin of a frame is fixed in it, and the end of a rod in the rod.
        let own = matches!(what.head, "origin" | END | APEX);
        let origin = what.all(Slot::Of).filter(|_| own);
        let mut all: Vec<FrameId> = vec![];
        let told = fixed.chain(origin).filter_map(|term| self.frame(term));
        for frame in told.flat_map(|frame| self.at_rest_with(frame)) {
            if !all.contains(&frame) {
                all.push(frame);
            }
        }
        all
    }

    /// Where the mass centres of a whole and of all its parts but one are the same point, that of the last part is too.
    pub(super) fn share_centres(&self, all: &mut [Spoken]) {
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
    pub(super) fn add_centres(&self, spoken: &mut Vec<Spoken>) {
        for (body, whole) in self.reading.system.bodies.iter().enumerate() {
            let known = spoken.iter().any(|s| s.is_centre_of(body));
            let stands_for = self.points_of.iter().any(|(own, _)| *own == body);
            let hub = self.hubs.iter().any(|(_, hub)| *hub == body);
            if !known && !stands_for && !hub {
                let name = if whole.is_particle() {
                    whole.name.clone()
                } else {
                    self.name_of_centre(body)
                };
                spoken.push(Spoken {
                    name,
                    centre_of: Some(body),
                    ..Spoken::default()
                });
            }
        }
    }

    /// Whether a point is placed from another of some of which sentences tell where they are.
    pub(super) fn lies_from_one_of(&self, others: &[Spoken], spoken: &Spoken) -> bool {
        let from = self.lies_from(spoken);
        let told = |s: &&Spoken| s.lies.is_some() || !s.fixed_in.is_empty();
        let mut others = others.iter().filter(told);
        from.is_some_and(|from| others.any(|s| s.name == from && s.name != spoken.name))
    }

    /// Whether the point from which something is placed stands already.
    pub(super) fn lies_from_what_stands(&self, slots: &[(Slot, Term)]) -> bool {
        slot(slots, Slot::From).is_some_and(|from| self.point(from).is_some())
    }

    /// The name of the point from which a sentence places another.
    pub(super) fn lies_from(&self, spoken: &Spoken) -> Option<String> {
        let lies = &self.declarations[spoken.lies?].statement;
        let (_, slots) = lies.does("lie").or_else(|| lies.does("place"))?;
        name_of(slot(slots, Slot::From)?)
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
