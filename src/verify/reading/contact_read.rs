//! Planes, points of contact, and rolling.

use crate::verify::language::centres::speaks_of_centre;
pub(super) use crate::verify::language::heads::CONTACT_POINT;
use crate::verify::language::heads::{HEIGHT, VERTICALLY_ABOVE};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::contact::{Contact, Plane};
use crate::verify::model::system::{BodyId, FrameId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::{letter_of, name_of, node_of, nodes_of, told};
use crate::verify::reading::surface_read::surface_and_side;
use crate::verify::reading::unused_read::MOVING;
use crate::verify::term::letters::{letter_names, spelled};
use crate::verify::term::quantity::Spot;

/// Quantities that only what moves has.
const RATES_OF_PLACE: [&str; 4] = ["velocity", "speed", "acceleration", "displacement"];

/// A plane that things touch from below.
const CEILING: &str = "ceiling";

impl Builder<'_> {
    /// Planes, the points where bodies touch them, and what rolls there.
    pub(super) fn place_contacts(&mut self) {
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && what.head == "plane"
                && self.read_plane(subjects, what, declaration).is_none()
            {
                self.say_unused(declaration);
            }
        }
        for declaration in self.declarations {
            let placed = match &declaration.statement {
                Statement::Is { subjects, what } if what.head == CONTACT_POINT => {
                    self.read_contact_point(subjects, what, declaration)
                }
                _ => continue,
            };
            placed.unwrap_or_else(|| self.say_unused(declaration));
        }
        for declaration in self.declarations {
            let rolls = match &declaration.statement {
                Statement::Does {
                    subjects,
                    verb: "roll",
                    slots,
                } => self.read_rolling(subjects, slots, declaration),
                _ => continue,
            };
            rolls.unwrap_or_else(|| self.say_unused(declaration));
        }
    }

    /// "The floor is a horizontal plane fixed in N", "the table is a plane normal to e".
    fn read_plane(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let frame = self.frame_of_plane(subjects, what)?;
        let normal = match what.slot(Slot::With).cloned() {
            Some(normal) => self.direction(&normal, declaration, Some(frame))?,
            None if what.is("horizontal") => self.upward(),
            None => self.normal_of_incline()?,
        };
        let level = what.slot(Slot::With).is_none() && what.is("horizontal");
        for name in subjects.iter().filter_map(name_of) {
            // What touches a ceiling is below it.
            let normal = match level && name == CEILING {
                true => -normal.clone(),
                false => normal.clone(),
            };
            self.system().planes.push(Plane {
                name,
                frame,
                normal,
            });
        }
        Some(())
    }

    /// The frame that carries a plane: that in which it is fixed, or its own one where it turns. How one moves without
    /// turning is not worked with.
    fn frame_of_plane(&self, subjects: &[Term], what: &NounPhrase) -> Option<FrameId> {
        let ground = self.reading.system.ground;
        let own = subjects.iter().find_map(|subject| self.frame(subject));
        let frame = told(what.slot(Slot::FixedIn), own.unwrap_or(ground), |t| {
            self.frame(t)
        })?;
        let moves = |d: &Declaration| match &d.statement {
            Statement::Does {
                subjects: things,
                verb,
                ..
            } => {
                let moves = MOVING.contains(verb) || *verb == "turn" && own.is_none();
                moves && things.iter().any(|thing| subjects.contains(thing))
            }
            Statement::Is { what, .. } if RATES_OF_PLACE.contains(&what.head) => {
                what.all(Slot::Of).any(|thing| subjects.contains(thing))
            }
            _ => false,
        };
        (!self.declarations.iter().any(moves)).then_some(frame)
    }

    /// The plane that a term names; the only one where none is said.
    pub(super) fn plane(&self, term: Option<&Term>) -> Option<Plane> {
        let system = &self.reading.system;
        match (term.and_then(name_of), system.planes.as_slice()) {
            (Some(name), _) => system.plane(&name).cloned(),
            (None, [only]) if term.is_none() => Some(only.clone()),
            _ => None,
        }
    }

    /// The plane on which a body is: the one of the name, or that which touches the round surface of the name.
    fn plane_under(
        &mut self,
        body: BodyId,
        on: Option<&Term>,
        declaration: &Declaration,
    ) -> Option<Plane> {
        match on.filter(|on| self.surface_said(surface_and_side(on).0).is_some()) {
            Some(surface) => self.tangent_plane(body, surface, declaration),
            None => self.plane(on),
        }
    }

    fn read_contact_point(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body(what.slot(Slot::Of)?)?;
        let [subject] = subjects else { return None };
        let name = name_of(subject)?;
        if let Some(on) = what.slot(Slot::On).filter(|on| self.is_body_under(on)) {
            return self.read_meeting_point(name, body, on, declaration);
        }
        let plane = self.plane_under(body, what.slot(Slot::On), declaration)?;
        match self.points.get(&name).copied() {
            Some(point) => {
                let contact = Contact { body, plane, point };
                self.system().contacts.push(contact);
                Some(())
            }
            None => self
                .add_contact(name, body, &plane, declaration)
                .map(|_| ()),
        }
    }

    /// The point where a body touches a plane; what else lies in the plane is as high.
    fn add_contact(
        &mut self,
        name: String,
        body: BodyId,
        plane: &Plane,
        declaration: &Declaration,
    ) -> Option<PointId> {
        self.round_wheel(body, declaration);
        let below = self.system().way_to_contact(body, &plane.normal);
        let centre = self.centre_of(body);
        let placed = below.map(|way| (centre, way));
        let placed = placed.or_else(|| self.placed_from_contact(&name));
        let placed = placed.or_else(|| self.height_above_contact(&name, &plane.normal));
        // Of a body of any form nothing tells how its point of contact moves.
        let point = self.system().add_point(&name, Some(placed?), Vec::new());
        self.points.insert(name, point);
        self.system().contacts.push(Contact {
            body,
            plane: plane.clone(),
            point,
        });
        let flat = self.plane_called(&plane.name).is_some();
        for other in self.points_in(&plane.name).into_iter().filter(|_| flat) {
            let way = self.system().position(point, other);
            self.hold(plane.normal.dot(&way), declaration);
        }
        Some(point)
    }

    /// Where a body that is not round touches a plane, if a sentence says how another point lies from there: "O lies at the
    /// distance `$R$` from C along y".
    fn placed_from_contact(&mut self, name: &str) -> Option<(PointId, Vector)> {
        let declarations = self.declarations;
        let (other, slots, declaration) = declarations.iter().find_map(|d| match &d.statement {
            Statement::Does {
                subjects,
                verb: "lie" | "place",
                slots,
            } if slot(slots, Slot::From).and_then(name_of).as_deref() == Some(name) => {
                Some((self.point(subjects.first()?)?, slots, d))
            }
            _ => None,
        })?;
        Some((other, -self.way_said(slots, declaration, true)?))
    }

    /// The same by the height of another point above it: "G lies at the height `$R$` above C", "`$R$` is the height of G above C".
    fn height_above_contact(&mut self, name: &str, normal: &Vector) -> Option<(PointId, Vector)> {
        let declarations = self.declarations;
        let (other, height, declaration) = declarations.iter().find_map(|d| {
            let (other, height, above) = height_told(&d.statement)?;
            let here = name_of(above).as_deref() == Some(name);
            Some((self.point(other).filter(|_| here)?, height, d))
        })?;
        let letter = letter_of(height)?;
        let changes = declarations
            .iter()
            .any(|d| d.line != declaration.line && speaks_of(d, letter));
        let height = self.scalar_term(height, declaration)?;
        if !changes {
            self.make_constant(&height);
        }
        Some((other, normal.clone() * -height))
    }

    /// Whether a sentence tells how high something is above where a body touches a plane.
    pub(super) fn tells_height_above_contact(&self, statement: &Statement) -> bool {
        let above = height_told(statement).and_then(|(.., above)| self.point(above));
        let contacts = &self.reading.system.contacts;
        above.is_some_and(|above| contacts.iter().any(|contact| contact.point == above))
    }

    /// The points that sentences place in a plane.
    fn points_in(&self, plane: &str) -> Vec<PointId> {
        let of_plane = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } if what.head == "point" => {
                let of = what.slot(Slot::Of).and_then(name_of)?;
                (of == plane).then(|| subjects.clone())
            }
            _ => None,
        };
        let named = self.declarations.iter().filter_map(of_plane).flatten();
        named.filter_map(|term| self.point(&term)).collect()
    }

    /// The point of the body that touches the plane has the velocity of the plane.
    fn read_rolling(
        &mut self,
        subjects: &[Term],
        slots: &[(Slot, Term)],
        declaration: &Declaration,
    ) -> Option<()> {
        let on = slot(slots, Slot::On).or_else(|| slot(slots, Slot::In));
        for subject in subjects {
            let body = self.body(subject).filter(|body| self.is_centred(*body))?;
            if let Some(on) = on.filter(|on| self.is_body_under(on)) {
                self.roll_on_body(body, on, slot(slots, Slot::At), declaration)?;
                continue;
            }
            let plane = self.plane_under(body, on, declaration)?;
            let at = match slot(slots, Slot::At) {
                Some(term) => match self.point(term) {
                    Some(point) => point,
                    None => self.add_contact(name_of(term)?, body, &plane, declaration)?,
                },
                None => self.touching(body, &plane, declaration)?,
            };
            let there = self.reading.system.body_point(body, at)?;
            // A point fixed in the body leaves the place where the body touches, and is at rest at one instant alone.
            if self.reading.system.points[at]
                .fixed_in
                .contains(&there.frame)
            {
                return None;
            }
            let velocity = self.system().carried_velocity(there, plane.frame);
            self.hold_zero(&velocity, declaration);
        }
        Some(())
    }

    /// Whether no sentence says what a body is made up of, and none that is not worked with speaks of it, of its mass centre or
    /// of where that is: then the mass centre is where the body is round about.
    fn is_centred(&self, body: BodyId) -> bool {
        let (rolling, centre) = (body, self.centre_of(body));
        let body = self.reading.system.bodies[body].name.as_str();
        let named = self.points.iter().filter(|(_, point)| **point == centre);
        let names = named.map(|(name, _)| name.as_str());
        let names: Vec<&str> = names.chain([body]).collect();
        let otherwise = |d: &Declaration| {
            let placed = d.statement.does("place").or(d.statement.does("lie"));
            let from = placed.and_then(|(_, slots)| slot(slots, Slot::From));
            let own = |term: &Term| self.point(term) == Some(centre);
            let lost = from.is_some_and(|from| self.point(from).is_none());
            let made_up = d.statement.does("consist");
            lost && d.statement.subjects().iter().any(own)
                || made_up.is_some_and(|(of, _)| of.iter().any(|of| self.body(of) == Some(rolling)))
                || d.is_unread() && speaks_of_centre(d, &names)
        };
        !self.declarations.iter().any(otherwise)
    }

    /// The point by which a body touches a plane, where no sentence names it.
    fn touching(
        &mut self,
        body: BodyId,
        plane: &Plane,
        declaration: &Declaration,
    ) -> Option<PointId> {
        let named = self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == CONTACT_POINT => {
                let of = what.slot(Slot::Of).and_then(|term| self.body(term));
                let on = what.slot(Slot::On).map(|on| surface_and_side(on).0);
                let here = on.and_then(name_of).is_none_or(|on| on == plane.name);
                subjects.first().filter(|_| here && of == Some(body))
            }
            _ => None,
        });
        match named.and_then(|term| self.point(term)) {
            Some(point) => Some(point),
            None => {
                let name = format!("{} {}", plane.name, self.reading.system.bodies[body].name);
                self.add_contact(name, body, plane, declaration)
            }
        }
    }

    /// Whose velocity or acceleration a phrase names: a place, or the point of a body that is there.
    pub(super) fn moving_spot(&self, phrase: &NounPhrase) -> Option<Spot> {
        match phrase.slot(Slot::Of)? {
            _ if phrase.slot(Slot::At).is_some() => self.material_point(phrase),
            Term::Phrase(point) if point.head == "point" => self.material_point(point),
            term => self.spot_at_contact(term).or_else(|| self.spot(term)),
        }
    }

    /// The point of a body that a sentence says to be where the body touches a plane: it moves as the body does there, and
    /// not as the place of contact does.
    pub(super) fn spot_at_contact(&self, term: &Term) -> Option<Spot> {
        let name = name_of(term)?;
        let own = self.points.get(&name)?;
        self.declarations.iter().find_map(|d| {
            let Statement::Does {
                subjects,
                verb: "lie",
                slots,
            } = &d.statement
            else {
                return None;
            };
            let [(Slot::At, at)] = slots.as_slice() else {
                return None;
            };
            let here = subjects.iter().any(|s| name_of(s).as_ref() == Some(&name));
            let at = self.point(at).filter(|_| here)?;
            let contact = self
                .reading
                .system
                .contacts
                .iter()
                .find(|c| c.point == at)?;
            let carried = self.reading.system.body_point(contact.body, at)?;
            let fixed = &self.reading.system.points[*own].fixed_in;
            fixed
                .contains(&carried.frame)
                .then_some(Spot::Carried(carried))
        })
    }

    /// The point of a rigid body that is at a place: "the velocity of the disc at C", "of the point of the disc at C".
    pub(super) fn material_point(&self, phrase: &NounPhrase) -> Option<Spot> {
        let at = phrase.slot(Slot::At)?;
        let body = phrase.slot(Slot::Of).and_then(|term| self.body(term))?;
        let point = self.point(at)?;
        let there = self.reading.system.body_point(body, point)?;
        Some(Spot::Carried(there))
    }
}

/// Whether a sentence tells of a letter, in a formula or by itself.
fn speaks_of(declaration: &Declaration, letter: &Formula) -> bool {
    let Some(letter) = node_of(letter).map(spelled) else {
        return true;
    };
    if matches!(&declaration.statement, Statement::Is { what, .. } if what.head == "constant") {
        return false;
    }
    let holds = match &declaration.statement {
        Statement::Holds(formula) => Some(formula),
        _ => None,
    };
    let formulas = declaration.statement.formulas().into_iter().chain(holds);
    let mut nodes = formulas.flat_map(nodes_of);
    nodes.any(|node| letter_names(node).contains(&letter)) || declaration.is_unread()
}

/// What lies at a height above what.
fn height_told(statement: &Statement) -> Option<(&Term, &Term, &Term)> {
    match statement {
        Statement::Is { subjects, what } if what.head == HEIGHT => {
            let above = what.slot(Slot::With)?;
            Some((what.slot(Slot::Of)?, subjects.first()?, above))
        }
        Statement::Does {
            subjects,
            verb: "lie",
            slots,
        } => {
            let height = match slot(slots, Slot::At)? {
                Term::Phrase(height) if height.head == HEIGHT => height.slot(Slot::Which)?,
                _ => return None,
            };
            let above = match slot(slots, Slot::With)? {
                Term::Phrase(place) if place.head == VERTICALLY_ABOVE => place.slot(Slot::Of)?,
                point => point,
            };
            Some((subjects.first()?, height, above))
        }
        _ => None,
    }
}
