//! Round bodies that roll on each other: gears that mesh, a planet wheel on its sun and in its ring, a disc on a drum that turns.

use crate::algebra::Fraction;
use crate::verify::language::statement::{Declaration, NounPhrase, Statement, Term};
use crate::verify::model::contact::{Carried, Round};
use crate::verify::model::system::{BodyId, PointId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::name_of;
use crate::verify::reading::shapes_read::RADIUS;
use crate::verify::reading::surface_read::{Side, surface_and_side};
use crate::verify::term::letters::Reach;
use num_traits::Zero;

impl Builder<'_> {
    /// "Gear 1 rolls on gear 2 at P": the points of both that are at P move alike.
    pub(super) fn roll_on_body(
        &mut self,
        body: BodyId,
        on: &Term,
        at: Option<&Term>,
        declaration: &Declaration,
    ) -> Option<()> {
        let (term, side) = surface_and_side(on);
        let other = self.body(term)?;
        let known = at.and_then(|at| self.point(at));
        let place = match known {
            Some(point) => point,
            None => {
                let name = match at {
                    Some(at) => name_of(at)?,
                    None => self.meeting_point(body, other),
                };
                self.place_mesh(name, (body, other), side, declaration)?
            }
        };
        let one = self.reading.system.body_point(body, place)?;
        let two = self.reading.system.body_point(other, place)?;
        let fixed = &self.reading.system.points[place].fixed_in;
        // A point of one of them is there at one instant alone.
        if body == other || [one, two].iter().any(|on| fixed.contains(&on.frame)) {
            return None;
        }
        let ground = self.reading.system.ground;
        let velocities = [one, two].map(|on: Carried| self.system().carried_velocity(on, ground));
        let [one, two] = velocities;
        self.hold_zero(&(one - two), declaration);
        Some(())
    }

    /// Whether what something rolls on is a body, and no plane and no surface that a frame carries.
    pub(super) fn is_body_under(&self, on: &Term) -> bool {
        let on = surface_and_side(on).0;
        let flat = name_of(on).is_some_and(|name| self.reading.system.plane(&name).is_some());
        let surface = self.surface_said(on);
        let laid = surface.is_some_and(|surface| self.is_laid(on, &surface));
        !flat && !laid && self.body(on).is_some()
    }

    /// "C is the point where the planet touches the sun."
    pub(super) fn read_meeting_point(
        &mut self,
        name: String,
        body: BodyId,
        on: &Term,
        declaration: &Declaration,
    ) -> Option<()> {
        let on = surface_and_side(on).0;
        let (other, side) = (self.body(on)?, self.side(body, on));
        let placed = self.place_mesh(name, (body, other), side, declaration);
        placed.map(|_| ())
    }

    /// The name of the point where two bodies touch: the one of a sentence, or one of its own.
    fn meeting_point(&self, body: BodyId, other: BodyId) -> String {
        let bodies = &self.reading.system.bodies;
        format!("{} on {}", bodies[body].name, bodies[other].name)
    }

    /// Where two round bodies touch: on the line of their centres, outside of both or inside of the one.
    fn place_mesh(
        &mut self,
        name: String,
        (body, other): (BodyId, BodyId),
        side: Option<Side>,
        declaration: &Declaration,
    ) -> Option<PointId> {
        if let Some(point) = self.points.get(&name) {
            return Some(*point);
        }
        let (own, its) = (self.radius_of(body)?, self.radius_of(other)?);
        let (centre, middle) = (self.centre_of(body), self.centre_of(other));
        let way = self.system().position(middle, centre);
        let gap = match side {
            Some(Side::Inner) => its - own.clone(),
            _ => its + own.clone(),
        };
        let length = way.dot(&way) - gap.clone() * gap.clone();
        if !length.is_zero() {
            self.hold(length, declaration);
        }
        self.reading.sizes.orders.push((Reach::All, gap.clone()));
        let share = match side {
            // Inside of the other one the point is beyond its own centre.
            Some(Side::Inner) => -(own / gap),
            _ => own / gap,
        };
        let way = way * share;
        let point = self.system().add_point(&name, Some((centre, way)), vec![]);
        self.points.insert(name, point);
        Some(point)
    }

    /// The radius of a body that sentences tell.
    fn radius_of(&mut self, body: BodyId) -> Option<Fraction> {
        if let Some(Round::Rim { radius, .. } | Round::Sphere { radius }) =
            self.reading.system.bodies[body].round.clone()
        {
            return Some(radius);
        }
        let declarations = self.declarations;
        let told = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = subjects.iter().any(|s| self.body(s) == Some(body));
                (own && what.size(RADIUS).is_some()).then_some((what.clone(), d))
            }
            _ => None,
        });
        let plain = NounPhrase::new("body", vec![]);
        let said = self.said_size(body, RADIUS).is_some();
        let (what, declaration) = match told {
            Some(told) => told,
            None if said => (plain, declarations.first()?),
            None => return None,
        };
        self.size_of_shape(body, &what, RADIUS, declaration)
    }
}
