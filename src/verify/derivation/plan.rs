//! Of which frames and bodies there is something to tell, and by which names.

use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, FrameId, PointId, System};
use crate::verify::reading::Reading;
use crate::verify::reading::builder::build;
use crate::verify::reading::names::{MASS_CENTRE, name_of};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use std::sync::Arc;

/// What there is to tell of a system.
pub(super) struct Plan {
    /// The frame on whose axes components are taken.
    pub(super) axes: FrameId,
    /// The labels of its axes.
    pub(super) labels: [&'static str; 3],
    /// Frames that turn and carry a body or the axes.
    pub(super) frames: Vec<(FrameId, Term)>,
    pub(super) ground: Term,
    /// Wholes before what they are parts of.
    pub(super) bodies: Vec<Subject>,
    /// The axis of the inertial frame that points up.
    pub(super) vertical: Option<Term>,
}

/// A body.
#[derive(Clone)]
pub(super) struct Subject {
    pub(super) body: BodyId,
    pub(super) term: Term,
    /// The point about which moments are taken: one that is fixed in the body and in space, else the mass centre.
    pub(super) about: PointId,
    pub(super) about_term: Term,
    pub(super) centre_term: Term,
    /// Whether it turns about a fixed point.
    pub(super) pivoted: bool,
    /// All loads on it, where a sentence says which these are.
    pub(super) loads: Option<Vec<Load>>,
}

/// A load.
#[derive(Clone)]
pub(super) struct Load {
    pub(super) noun: NounPhrase,
    /// The point at which it acts, where the sentence says so.
    pub(super) at: Option<PointId>,
}

/// The labels that axes may have.
const LABELS: [[&str; 3]; 3] = [["x", "y", "z"], ["1", "2", "3"], ["X", "Y", "Z"]];

impl Plan {
    /// What declarations give to tell.
    pub(super) fn of(declarations: &[Declaration]) -> Self {
        let reading = build(declarations, Arc::default(), 0);
        let namer = Namer { declarations };
        let system = &reading.system;
        let axes = reading.letters.component_frame;
        let mut carrying: Vec<FrameId> = system.bodies.iter().filter_map(|b| b.frame).collect();
        carrying.push(axes);
        let told = (0..system.frames.len()).filter(|f| *f != system.ground && carrying.contains(f));
        let frames = told.filter_map(|frame| {
            let term = namer.term(&system.frames[frame].name)?;
            Some((frame, term))
        });
        let ground = &system.frames[system.ground].name;
        let mut bodies: Vec<Subject> = (0..system.bodies.len())
            .filter_map(|body| namer.subject(system, body))
            .collect();
        bodies.sort_by_key(|subject| !system.bodies[subject.body].parts.is_empty());
        Self {
            axes,
            labels: namer.labels(&reading),
            frames: frames.collect(),
            ground: namer
                .term(ground)
                .unwrap_or_else(|| Term::Name(ground.clone())),
            bodies,
            vertical: namer.vertical(),
        }
    }
}

impl Plan {
    /// How the frame is called on whose axes components are taken.
    pub(super) fn name_of_axes(&self) -> String {
        let named = self.frames.iter().find(|(frame, _)| *frame == self.axes);
        called(named.map_or(&self.ground, |(_, term)| term))
    }
}

/// How a thing is called in a heading.
pub(super) fn called(term: &Term) -> String {
    match term {
        Term::Formula(formula) => format!("${}$", formula.source),
        term => name_of(term).unwrap_or_default(),
    }
}

/// Finds the names by which an author calls things.
struct Namer<'a> {
    declarations: &'a [Declaration],
}

impl Namer<'_> {
    /// A thing as the author writes it first.
    fn term(&self, name: &str) -> Option<Term> {
        let mut all = self.declarations.iter().flat_map(|d| d.statement.terms());
        let named = |term: &&&Term| match term {
            Term::Name(_) | Term::Formula(_) => name_of(term).as_deref() == Some(name),
            _ => false,
        };
        all.find(|term| named(&term)).cloned()
    }

    fn subject(&self, system: &System, body: BodyId) -> Option<Subject> {
        let term = self.term(&system.bodies[body].name)?;
        let wholes = system.wholes(body);
        let frames: Vec<FrameId> = wholes
            .iter()
            .filter_map(|&b| system.bodies[b].frame)
            .collect();
        let has_centre = |b: &BodyId| system.bodies[*b].centre != 0 || self.is_point(system, *b);
        // Members that move on their own are no unknowns that could be solved for here.
        let single = |b: &BodyId| system.bodies[*b].members.is_none();
        if !wholes.iter().all(|b| has_centre(b) && single(b)) {
            return None;
        }
        let fixed = |point: PointId| {
            let fixed_in = &system.points[point].fixed_in;
            fixed_in.contains(&system.ground) && frames.iter().all(|f| fixed_in.contains(f))
        };
        let mut points = 0..system.points.len();
        let pivot = points.find(|&p| fixed(p) && !system.points[p].name.is_empty());
        let pivot = pivot.filter(|_| !frames.is_empty());
        let centre = system.bodies[body].centre;
        let about = pivot.unwrap_or(centre);
        Some(Subject {
            body,
            about,
            about_term: self.point(system, about, &term),
            centre_term: self.point(system, centre, &term),
            pivoted: pivot.is_some(),
            loads: self.loads(system, body),
            term,
        })
    }

    /// Whether the first point of all is the mass centre of a body by its name.
    fn is_point(&self, system: &System, body: BodyId) -> bool {
        !system.points[system.bodies[body].centre].name.is_empty()
    }

    /// A point by its name, or as the mass centre of a body.
    fn point(&self, system: &System, point: PointId, body: &Term) -> Term {
        self.term(&system.points[point].name).unwrap_or_else(|| {
            let slots = vec![(Slot::Of, body.clone())];
            Term::Phrase(Box::new(NounPhrase::new(MASS_CENTRE, slots)))
        })
    }

    /// The loads on a body, where a sentence says that there are no others.
    fn loads(&self, system: &System, body: BodyId) -> Option<Vec<Load>> {
        let name = &system.bodies[body].name;
        let of = |premise: &NounPhrase| match premise.slot(Slot::Of) {
            Some(term) => name_of(term).as_ref() == Some(name),
            None => body == 0,
        };
        self.declarations.iter().find_map(|declaration| {
            let Statement::Premise(premise) = &declaration.statement else {
                return None;
            };
            let none = premise.is("no") && matches!(premise.head, "moment" | "load");
            let only = premise.is("only") && premise.head == "load";
            if !(none || only) || !of(premise) {
                return None;
            }
            let loads = premise.all(Slot::With).map(|load| match load {
                Term::Phrase(noun) => Some(Load {
                    noun: (**noun).clone(),
                    at: noun.slot(Slot::At).and_then(|at| point_named(system, at)),
                }),
                _ => None,
            });
            loads.collect()
        })
    }

    fn labels(&self, reading: &Reading) -> [&'static str; 3] {
        let name = &reading.system.frames[reading.letters.component_frame].name;
        let written = self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "axes" => {
                let own = what.slot(Slot::Of).and_then(name_of).as_ref() == Some(name);
                own.then(|| subjects.iter().filter_map(name_of).collect::<Vec<_>>())
            }
            _ => None,
        });
        let fits = |labels: &&[&str; 3]| {
            let ends = |(axis, label): (&String, &&str)| axis.ends_with(*label);
            written
                .iter()
                .all(|axes| axes.iter().zip(labels.iter()).all(ends))
        };
        *LABELS.iter().find(fits).unwrap_or(&LABELS[0])
    }

    fn vertical(&self) -> Option<Term> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "vertical" => {
                subjects.first().cloned()
            }
            _ => None,
        })
    }
}

fn point_named(system: &System, term: &Term) -> Option<PointId> {
    let name = name_of(term)?;
    system.points.iter().position(|point| point.name == name)
}

impl Reading {
    /// The letter of the author for a quantity, in all of the document.
    pub(super) fn letter_of(&self, quantity: &Quantity) -> Option<&str> {
        use crate::verify::term::letters::Reach;
        let letters = self.letters.letters.iter();
        let mut fitting = letters.filter(|l| l.reach == Reach::All && !l.besides);
        let found = fitting.find(|l| matches!(&l.meaning, Meaning::Quantity(q) if q == quantity));
        found.map(|letter| letter.latex.as_str())
    }
}
