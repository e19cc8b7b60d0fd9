//! Shapes: the tensor of a uniform body, and the round part by which it touches planes.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::heads::{MASS, POSITION};
use crate::verify::language::is_body;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::language::traits::{Trait, has, is_conical, is_round_and_flat};
use crate::verify::model::contact::Round;
use crate::verify::model::system::{BodyId, Matrix, Turn};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::name_of;
use crate::verify::reading::sizes_read::is_size;
use num_traits::{One, Zero};
use std::collections::BTreeSet;

/// What may be said of a uniform shape without making it another one.
const PLAIN: [&str; 8] = [
    "uniform", "thin", "rigid", "circular", "straight", "solid", "heavy", "right",
];
/// A body without extent.
const PARTICLE: &str = "particle";

/// The size of what is round.
pub(super) const RADIUS: &str = "radius";

impl<'a> Builder<'a> {
    /// A rigid body has a frame, which no sentence need name: it turns freely.
    pub(super) fn add_frames_of_bodies(&mut self) {
        let particles = self.particles();
        for body in 0..self.reading.system.bodies.len() {
            let (system, ground) = (&self.reading.system, self.reading.system.ground);
            let known = &system.bodies[body];
            let whole = known.parts.is_empty() && known.members.is_none();
            if known.frame.is_some() || !whole || particles.contains(&known.name) {
                continue;
            }
            let name = known.name.clone();
            let frame = self.system().add_frame(&name, Some(ground), Turn::Free);
            self.reading.system.bodies[body].frame = Some(frame);
        }
    }

    /// The names of the bodies that are said to be particles.
    pub(super) fn particles(&self) -> BTreeSet<String> {
        let said = self.declarations.iter().flat_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "particle" => subjects.as_slice(),
            // What lies somewhere is a point.
            Statement::Does {
                subjects,
                verb: "place" | "lie",
                slots,
            } if slots.iter().any(|(slot, _)| *slot == Slot::From) => subjects.as_slice(),
            _ => &[],
        });
        // "the particles P and Q", and what is only called the particle
        let terms = self.declarations.iter().flat_map(|d| d.statement.terms());
        let called = terms.flat_map(|term| match term {
            Term::Phrase(phrase) if phrase.head == PARTICLE => phrase.all(Slot::Which).collect(),
            // "particle 1"
            Term::Name(name) if name.split(' ').next() == Some(PARTICLE) => vec![term],
            _ => vec![],
        });
        let said = said.chain(called).chain(self.listed_particles());
        let said = said.chain(self.placed_as_points());
        let said = said.filter_map(name_of);
        let stand_for = self.points_of.iter();
        let stand_for = stand_for.map(|&(own, _)| self.reading.system.bodies[own].name.clone());
        said.chain(stand_for).collect()
    }

    /// "`$r$` is the position of the bead", of which no sentence says that it is a body with an extent.
    fn placed_as_points(&self) -> impl Iterator<Item = &Term> {
        let bodies: BTreeSet<String> = self
            .declarations
            .iter()
            .filter_map(|d| match &d.statement {
                Statement::Is { subjects, what } if is_body(what.head) => Some(subjects),
                _ => None,
            })
            .flatten()
            .filter_map(name_of)
            .collect();
        let positions = self.declarations.iter().flat_map(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == POSITION => what.all(Slot::Of).collect(),
            _ => vec![],
        });
        positions.filter(move |term| name_of(term).is_some_and(|name| !bodies.contains(&name)))
    }

    /// "consists of the particles P and Q": the names behind the first one.
    fn listed_particles(&self) -> impl Iterator<Item = &Term> {
        let lists = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Does {
                verb: "consist",
                slots,
                ..
            } => Some(slots),
            _ => None,
        });
        let particle = |term: &Term| matches!(term, Term::Phrase(p) if p.head == PARTICLE);
        let letter = |term: &&Term| matches!(term, Term::Name(name) if name.chars().count() == 1);
        lists.flat_map(move |slots| {
            let parts = slots.iter().map(|(_, term)| term);
            let rest = parts.skip_while(move |term| !particle(term));
            rest.skip(1).take_while(letter)
        })
    }

    /// The inertia tensor of a uniform body, by exact integrals, on the axes of its frame.
    pub(super) fn shape_body(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        if self.is_rolled_on(body) {
            return Some(());
        }
        if self.is_made_otherwise(body) {
            return None;
        }
        match way_told(what.head) {
            Told::Sides => return self.sided_body(body, what, declaration),
            Told::SemiAxes => return self.ellipsoid_body(body, what, declaration),
            Told::Base => return self.pyramid_body(body, what, declaration),
            Told::InOne => {}
        }
        self.lay_by_points(body)?;
        let shape = mechanics::Shape::by_name(what.head)?;
        let lies_along = what.slot(Slot::Along).is_some();
        let untold = lies_along && self.told_axis_of_shape(body).is_none();
        if untold || !is_plain_shape(what, shape.sizes()) {
            return None;
        }
        let sizes = self.sizes_of_shape(body, shape, what, declaration)?;
        let mass = self.reading.system.bodies[body].mass.clone();
        let pi = self.system().atoms.pi();
        let tensor = shape.moments(&mass, &sizes, &pi)?.central_inertia();
        let round_all_over =
            is_round(&tensor) && tensor[(0, 0)] == tensor[(2, 2)] && !has(shape.name(), Trait::Rim);
        let line = self.reading.system.bodies[body].line.map(|line| line.axis);
        let told = line.or_else(|| self.told_axis_of_shape(body));
        if let (None, Some(along)) = (told, self.said_direction_of_shape(body)) {
            return self.shape_along(body, &tensor, along);
        }
        let axis = match told {
            Some(axis) => axis,
            // What rolls turns about its own axis; another shape that turns about an axis may lie across it.
            None if !round_all_over => match self.axis_of_turn(body) {
                Some(axis) => Some(axis).filter(|_| self.rolls(body))?,
                None if self.has_named_axes(body) => return None,
                None => 2,
            },
            None => 2,
        };
        self.reading.system.bodies[body].round = roundness(shape, &sizes, axis);
        let tensor = self.tensor_on_work_frame(body, &tensor, axis)?;
        self.reading.system.bodies[body].inertia = Some(tensor);
        Some(())
    }

    fn sizes_of_shape(
        &mut self,
        body: BodyId,
        shape: mechanics::Shape,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Vec<Fraction>> {
        let single = |wanted: &mechanics::Size| (wanted.count == 1).then_some(wanted.name);
        let sizes = shape.sizes().iter();
        sizes
            .map(|wanted| self.size_of_shape(body, what, single(wanted)?, declaration))
            .collect()
    }

    /// The length, the area or the volume of a body by its shape, and which of them it is: 1, 2 or 3.
    pub(super) fn content_of_shape(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<(Fraction, u8)> {
        let told = way_told(what.head);
        if told == Told::Sides {
            let sides = self.sides_in_order(body, what, declaration)?;
            let long = sides.into_iter().filter(|side| !side.is_zero());
            let (mut content, mut dimension) = (Fraction::one(), 0);
            for side in long {
                content *= side;
                dimension += 1;
            }
            return Some((content, dimension));
        }
        let shape = mechanics::Shape::by_name(what.head)?;
        if told == Told::Base {
            let content = self.content_of_pyramid(body, what, declaration)?;
            return Some((content, shape.dimension()));
        }
        if !is_plain_shape(what, shape.sizes()) {
            return None;
        }
        let sizes = self.sizes_of_shape(body, shape, what, declaration)?;
        let pi = self.system().atoms.pi();
        Some((shape.content(&sizes, &pi)?, shape.dimension()))
    }

    /// The number of the axis about which a body's frame is said to turn.
    pub(super) fn axis_of_turn(&self, body: BodyId) -> Option<usize> {
        let system = &self.reading.system;
        system.frames[system.bodies[body].frame?].turn.axis()
    }

    fn rolls(&self, body: BodyId) -> bool {
        self.rolling().any(|rolling| rolling == body)
    }

    /// The bodies that are said to roll.
    pub(super) fn rolling(&self) -> impl Iterator<Item = BodyId> {
        let said = self
            .declarations
            .iter()
            .filter_map(|d| d.statement.does("roll"));
        let subjects = said.flat_map(|(subjects, _)| subjects);
        subjects.filter_map(|term| self.body(term))
    }

    /// Whether a sentence says that a body is a rod, or else slender.
    pub(super) fn is_rod(&self, body: BodyId) -> bool {
        self.is_shaped(body, is_rod)
    }

    pub(super) fn is_cone(&self, body: BodyId) -> bool {
        self.is_shaped(body, is_conical)
    }

    /// Whether a sentence says that a body is a disc or a ring, which lies in a plane.
    pub(super) fn is_flat(&self, body: BodyId) -> bool {
        self.is_shaped(body, is_round_and_flat)
    }

    /// Whether a sentence says that a body has such a shape.
    pub(super) fn is_shaped(&self, body: BodyId, is: impl Fn(&str) -> bool) -> bool {
        self.said_to_be(body, is).is_some()
    }

    /// The sentence that says that a body has such a shape.
    pub(super) fn said_to_be(
        &self,
        body: BodyId,
        is: impl Fn(&str) -> bool,
    ) -> Option<(&'a NounPhrase, &'a Declaration)> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if is(what.head) => {
                let own = subjects.iter().any(|s| self.body(s) == Some(body));
                own.then_some((what, d))
            }
            _ => None,
        })
    }

    /// Whether sentences name axes of a body's frame, so that its third one need not be that of its shape.
    pub(super) fn has_named_axes(&self, body: BodyId) -> bool {
        let frame = self.reading.system.bodies[body].frame;
        self.axes.iter().any(|(_, (of, _))| Some(*of) == frame)
    }

    /// What is symmetric about an axis and has a radius touches planes as a wheel does.
    pub(super) fn round_body(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let sized = what.all(Slot::Of).any(|term| match term {
            Term::Phrase(size) => size.head == RADIUS,
            _ => false,
        });
        let axis = self.told_axis_of_shape(body);
        let Some(axis) = axis.or(self.axle_of(body)).filter(|_| sized) else {
            return;
        };
        if let Some(radius) = self.size_of_shape(body, what, RADIUS, declaration) {
            self.reading.system.bodies[body].round = Some(Round::Rim { radius, axis });
        }
    }

    /// The axis of its frame about which a body turns, where it turns in no other way.
    pub(super) fn axle_of(&self, body: BodyId) -> Option<usize> {
        let frame = self.reading.system.bodies[body].frame?;
        self.reading.system.frames[frame].turn.axis()
    }

    /// A round shape about a direction that is no axis of its frame: of where it touches planes nothing is told.
    fn shape_along(
        &mut self,
        body: BodyId,
        tensor: &Matrix,
        (along, declaration): (&Term, &Declaration),
    ) -> Option<()> {
        let along = self.direction_in_body(body, along, declaration)?;
        let (across, spin) = (&tensor[(0, 0)], &tensor[(2, 2)]);
        if self.rolls(body) || !is_round(tensor) {
            return None;
        }
        let tensor = mechanics::symmetric_inertia(across, spin, &along);
        self.reading.system.bodies[body].inertia = Some(tensor);
        Some(())
    }

    /// A tensor on the axes of a shape, which has its own axis along one of those of a body's frame. One that is the
    /// same about all axes across is told without the spin: I_t 1 + (I_s − I_t) d dᵀ.
    fn tensor_on_work_frame(
        &mut self,
        body: BodyId,
        tensor: &Matrix,
        axis: usize,
    ) -> Option<Matrix> {
        let frame = self.reading.system.bodies[body].frame?;
        let work = self.reading.system.work;
        let (across, along) = (tensor[(0, 0)].clone(), tensor[(2, 2)].clone());
        if is_round(tensor) {
            let axis = self.system().axis(frame, axis);
            return Some(mechanics::symmetric_inertia(&across, &along, &axis));
        }
        let turn = self.system().rotation(work, frame);
        (axis == 2).then(|| mechanics::inertia_in_axes(&turn, tensor))
    }
}

/// Whether a tensor is the same about all axes across the third one.
fn is_round(tensor: &Matrix) -> bool {
    let zero = |r: usize, c: usize| tensor[(r, c)].is_zero();
    tensor[(0, 0)] == tensor[(1, 1)] && zero(0, 1) && zero(0, 2) && zero(1, 2)
}

/// Whether a noun is that of a shape whose tensor is known.
pub(super) fn is_shape(noun: &str) -> bool {
    has(noun, Trait::Shape) && mechanics::Shape::by_name(noun).is_some()
}

/// Whether a noun is that of a shape of which no more than the name is known.
pub(super) fn is_known_by_name(noun: &str) -> bool {
    // What is round about a point is a surface, and sentences tell its radius.
    has(noun, Trait::Shape) && !is_shape(noun) && !has(noun, Trait::Ball)
}

/// Whether a noun is that of what is long and has two ends.
pub(super) fn is_rod(noun: &str) -> bool {
    has(noun, Trait::Slender)
}

/// How sentences tell the sizes of a shape.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
enum Told {
    /// Each is one number behind the noun: "a cone of mass `$m$`, radius `$r$` and height `$h$`".
    InOne,
    /// Sides along the axes of its frame.
    Sides,
    /// Semi-axes along them.
    SemiAxes,
    /// The sides of the base along two of them, and a height.
    Base,
}

fn way_told(noun: &str) -> Told {
    match noun {
        "box" | "plate" => Told::Sides,
        "ellipsoid" => Told::SemiAxes,
        "pyramid" => Told::Base,
        _ => Told::InOne,
    }
}

/// Whether all that is said of a shape is known to it: a hollow one is another, and so is one with a size more.
pub(super) fn is_plain_shape(what: &NounPhrase, sizes: &[mechanics::Size]) -> bool {
    let known = |size: &str| size == MASS || sizes.iter().any(|wanted| is_size(size, wanted.name));
    what.adjectives.iter().all(|said| PLAIN.contains(said))
        && what.slots.iter().all(|(slot, term)| match (slot, term) {
            (Slot::Of, Term::Phrase(size)) => known(size.head),
            (Slot::With | Slot::From | Slot::To, _) => false,
            _ => true,
        })
}

/// The surface on which a shape rolls, if it is round.
fn roundness(shape: mechanics::Shape, sizes: &[Fraction], axis: usize) -> Option<Round> {
    // Of two radii the last one is the outer one.
    let is_radius = |size: &mechanics::Size| size.name.ends_with(RADIUS);
    let radius = sizes
        .get(shape.sizes().iter().rposition(is_radius)?)?
        .clone();
    match shape.name() {
        name if has(name, Trait::Ball) => Some(Round::Sphere { radius }),
        name if has(name, Trait::Rim) => Some(Round::Rim { radius, axis }),
        _ => None,
    }
}
