//! Round surfaces: a body that rolls inside or outside of one touches it as it would touch the tangent plane there.

use crate::algebra::Fraction;
use crate::mechanics::cross;
use crate::verify::facts::premises::Facts;
use crate::verify::language::heads::MASS;
use crate::verify::language::statement::{
    Declaration, Extent, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::language::traits::{Trait, has, is_cylindrical};
use crate::verify::model::contact::{Plane, Round};
use crate::verify::model::system::{BodyId, FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::contact_read::CONTACT_POINT;
use crate::verify::reading::names::name_of;
use crate::verify::reading::shapes_read::RADIUS;
use crate::verify::term::letters::Reach;
use num_traits::Zero;

/// What a sentence says of a surface that a frame carries.
pub(super) struct SurfaceSaid<'a> {
    what: &'a NounPhrase,
    declaration: &'a Declaration,
    pub(super) frame: FrameId,
    straight: bool,
}

/// A sphere, or a cylinder about an axis.
struct Surface {
    frame: FrameId,
    centre: PointId,
    axis: Option<Vector>,
    radius: Fraction,
}

/// The side of a surface on which a body is.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) enum Side {
    Inner,
    Outer,
}

impl<'a> Builder<'a> {
    /// "The bowl is a sphere of radius `$R$` fixed in N": a body without mass that a frame carries.
    pub(super) fn surface_said(&self, term: &Term) -> Option<SurfaceSaid<'a>> {
        let name = name_of(term)?;
        let mut said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if d.extent == Extent::Document => {
                let own = subjects.iter().any(|s| name_of(s).as_ref() == Some(&name));
                own.then_some((what, d))
            }
            _ => None,
        });
        said.find_map(|(what, declaration)| {
            let kind = match what.head {
                "fixed" => name.as_str(),
                head => head,
            };
            let straight = is_cylindrical(kind);
            let frame = match what.slot(Slot::FixedIn) {
                Some(frame) => self.frame(frame)?,
                None if what.is("fixed") => self.reading.system.ground,
                None => return None,
            };
            let round = straight || has(kind, Trait::Ball);
            let massless = what.size(MASS).is_none() && !self.tells_mass(&name);
            (round && massless).then_some(SurfaceSaid {
                what,
                declaration,
                frame,
                straight,
            })
        })
    }

    fn tells_mass(&self, name: &str) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == MASS => {
                what.all(Slot::Of).filter_map(name_of).any(|of| of == name)
            }
            _ => false,
        })
    }

    /// Whether a body is a surface on which another one rolls.
    pub(super) fn is_rolled_on(&self, body: BodyId) -> bool {
        let own = |term: &Term| self.body(term) == Some(body) && self.surface_said(term).is_some();
        self.declarations.iter().any(|d| {
            let slots = d.statement.does("roll").map(|(_, slots)| slots);
            let on = slots.and_then(|slots| slot(slots, Slot::On).or(slot(slots, Slot::In)));
            on.is_some_and(|on| own(surface_and_side(on).0))
        })
    }

    /// Whether a sentence tells where a surface is on which a body rolls.
    pub(super) fn is_place_of_surface(&self, of: Option<&Term>) -> bool {
        let body = of.and_then(|of| self.body(of));
        body.is_some_and(|body| self.is_rolled_on(body))
    }

    /// The plane that touches a round surface where a body does. How far the centre of the body is from that of the surface
    /// is a premise.
    pub(super) fn tangent_plane(
        &mut self,
        body: BodyId,
        on: &Term,
        declaration: &Declaration,
    ) -> Option<Plane> {
        let (term, _) = surface_and_side(on);
        let surface = self.surface(term)?;
        let radius = self.radius_within(body, &surface)?;
        let centre = self.centre_of(body);
        let mut way = self.system().position(centre, surface.centre);
        if let Some(axis) = &surface.axis {
            way -= axis * axis.dot(&way);
        }
        let distance = self.distance_told(centre, &surface);
        let inner = surface.radius.clone() - radius.clone();
        let outer = surface.radius.clone() + radius;
        let side = match self.side(body, term) {
            Some(side) => side,
            None if distance.as_ref() == Some(&inner) => Side::Inner,
            None if distance.as_ref() == Some(&outer) => Side::Outer,
            None => return None,
        };
        let gap = match side {
            Side::Inner => inner,
            Side::Outer => outer,
        };
        let lengths = [
            distance.map(|distance| distance - gap.clone()),
            Some(way.dot(&way) - gap.clone() * gap.clone()),
        ];
        for length in lengths.into_iter().flatten() {
            let atoms = &mut self.reading.system.atoms;
            let plain = Facts::default().normal(atoms, &length).ok()?;
            if !plain.is_zero() {
                self.hold(length, declaration);
            }
        }
        self.reading.sizes.orders.push((Reach::All, gap.clone()));
        let outward = way / gap;
        let plane = Plane {
            name: name_of(term)?,
            frame: surface.frame,
            normal: match side {
                Side::Inner => -outward,
                Side::Outer => outward,
            },
        };
        // A name is that of one plane.
        match self.reading.system.plane(&plane.name) {
            Some(known) => (known.normal == plane.normal).then_some(plane),
            None => {
                self.system().planes.push(plane.clone());
                Some(plane)
            }
        }
    }

    fn surface(&mut self, term: &Term) -> Option<Surface> {
        let said = self.surface_said(term)?;
        let body = self.body(term)?;
        let told = said.what.size(RADIUS).is_some() || self.said_size(body, RADIUS).is_some();
        let size = |b: &mut Self| b.size_of_shape(body, said.what, RADIUS, said.declaration);
        let radius = told.then(|| size(self)).flatten()?;
        let (centre, axis) = match said.straight {
            true => {
                let (through, along) = self.axis_of_surface(term, said.what)?;
                let direction = self.direction(along, said.declaration, Some(said.frame))?;
                (through, Some(direction))
            }
            false => (self.centre_of_surface(term)?, None),
        };
        let carried = &self.reading.system.points[centre].fixed_in;
        carried.contains(&said.frame).then_some(Surface {
            frame: said.frame,
            centre,
            axis,
            radius,
        })
    }

    /// "O is the centre of the bowl."
    fn centre_of_surface(&self, surface: &Term) -> Option<PointId> {
        self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == "centre" => {
                let own = what.slot(Slot::Of).and_then(name_of) == name_of(surface);
                self.point(subjects.first().filter(|_| own)?)
            }
            _ => None,
        })
    }

    /// "The axis of the cylinder passes through O along z", "with its axis through O along z."
    fn axis_of_surface(&self, surface: &Term, what: &'a NounPhrase) -> Option<(PointId, &'a Term)> {
        let beside = what.all(Slot::With).find_map(|with| match with {
            Term::Phrase(axis) if axis.head == "axis" => Some(axis.slots.as_slice()),
            _ => None,
        });
        let passing = || {
            self.declarations.iter().find_map(|d| {
                let (subjects, slots) = d.statement.does("pass")?;
                let own = subjects.iter().any(|s| is_axis_of(s, surface));
                own.then_some(slots)
            })
        };
        let slots = beside.or_else(passing)?;
        let through = self.point(slot(slots, Slot::Through)?)?;
        Some((through, slot(slots, Slot::Along)?))
    }

    /// The radius of a body that rolls on a surface: any way round of a ball, about the axis of a cylinder of a disc.
    fn radius_within(&mut self, body: BodyId, surface: &Surface) -> Option<Fraction> {
        match self.reading.system.bodies[body].round.clone()? {
            Round::Sphere { radius } => Some(radius),
            Round::Rim { radius, axis } => {
                let frame = self.reading.system.bodies[body].frame?;
                let own = self.system().axis(frame, axis);
                let apart = cross(&own, surface.axis.as_ref()?);
                apart.iter().all(Zero::is_zero).then_some(radius)
            }
        }
    }

    /// Whether sentences tell where a surface is by its centre or its axis.
    pub(super) fn is_laid(&self, term: &Term, said: &SurfaceSaid<'a>) -> bool {
        match said.straight {
            true => self.axis_of_surface(term, said.what).is_some(),
            false => self.centre_of_surface(term).is_some(),
        }
    }

    /// "The ball rolls in the bowl", "on the outer surface of the cylinder".
    pub(super) fn side(&self, body: BodyId, surface: &Term) -> Option<Side> {
        let mut sides = self.declarations.iter().filter_map(|d| {
            let (own, on, within) = match &d.statement {
                Statement::Does {
                    subjects,
                    verb: "roll",
                    slots,
                } => {
                    let own = subjects.iter().any(|s| self.body(s) == Some(body));
                    (own, slot(slots, Slot::On), slot(slots, Slot::In))
                }
                Statement::Is { what, .. } if what.head == CONTACT_POINT => {
                    let own = what.slot(Slot::Of).and_then(|of| self.body(of)) == Some(body);
                    (own, what.slot(Slot::On), None)
                }
                _ => return None,
            };
            let named = |term: &Term| name_of(term) == name_of(surface);
            let (on, side) = match (on, within) {
                (Some(on), _) => surface_and_side(on),
                (None, Some(within)) => (within, Some(Side::Inner)),
                (None, None) => return None,
            };
            side.filter(|_| own && named(on))
        });
        let first = sides.next()?;
        sides.all(|side| side == first).then_some(first)
    }

    /// "G lies at the distance `$b$` from O": how far the centre of a body is from that of a sphere.
    fn distance_told(&mut self, of: PointId, surface: &Surface) -> Option<Fraction> {
        let (distance, declaration) = self.declarations.iter().find_map(|d| {
            let (subjects, slots) = d.statement.does("lie")?;
            let own = subjects.iter().any(|s| self.point(s) == Some(of));
            let from = slot(slots, Slot::From).and_then(|from| self.point(from));
            let here = own && from == Some(surface.centre) && d.extent == Extent::Document;
            Some((slot(slots, Slot::At).filter(|_| here)?, d))
        })?;
        let way = self.reading.system.position(of, surface.centre);
        let axis = surface.axis.as_ref();
        let across = axis.is_none_or(|axis| axis.dot(&way).is_zero());
        self.scalar_term(distance, declaration).filter(|_| across)
    }
}

/// "the inner surface of the bowl": the bowl, and which side of it.
pub(super) fn surface_and_side(term: &Term) -> (&Term, Option<Side>) {
    if let Term::Phrase(surface) = term
        && surface.head == "surface"
        && let Some(of) = surface.slot(Slot::Of)
    {
        let side = match (surface.is("internal"), surface.is("external")) {
            (true, false) => Some(Side::Inner),
            (false, true) => Some(Side::Outer),
            _ => None,
        };
        return (of, side);
    }
    (term, None)
}

/// "the axis of the cylinder"
pub(super) fn is_axis_of(term: &Term, surface: &Term) -> bool {
    matches!(term, Term::Phrase(axis)
        if axis.head == "axis" && axis.slot(Slot::Of).and_then(name_of) == name_of(surface))
}
