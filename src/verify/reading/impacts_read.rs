//! What strikes a body: where things are in the impact, and what momentum the impact leaves as it is.
//!
//! An impact is over at once: weights bring no momentum by it, what two bodies do to each other is none of both together, and
//! a hinge without friction brings no angular momentum about its axis.

use crate::algebra::Fraction;
use crate::notation::ast::Kind;
use crate::verify::language::heads::{BALL_JOINT, WEIGHT};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, slot,
};
use crate::verify::model::blows::Side;
use crate::verify::model::bodies::Velocities::Absolute;
use crate::verify::model::system::{BodyId, FrameId, PointId, Turn, Vector};
use crate::verify::reading::blows_read::{is_at_blow, side};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::compounds_read::symbols_in;
use crate::verify::reading::names::{name_of, node_of};
use crate::verify::term::value::Value;

/// A particle that strikes a body.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Strike {
    striker: BodyId,
    struck: BodyId,
    at: PointId,
    sticks: bool,
}

const IMPULSE: &str = "impulse";

/// What holds a body where it is hinged, beside the point itself.
const HINGES: [&str; 2] = ["joint", BALL_JOINT];

impl Builder<'_> {
    /// "`$\\theta$` is zero just before the impact", of a letter of where something is: then it is so all through the impact.
    pub(super) fn read_places_at_blow(&mut self, declarations: &[Declaration]) {
        for declaration in declarations.iter().filter(|d| tells_place_at_blow(d)) {
            let read = self.read_place_at_blow(declaration);
            read.unwrap_or_else(|| self.say_unused(declaration));
        }
    }

    fn read_place_at_blow(&mut self, declaration: &Declaration) -> Option<()> {
        for letter in declaration.statement.subjects() {
            let Term::Formula(letter) = letter else {
                return None;
            };
            let value = self.mentioned_value(letter, declaration)?;
            let none: Option<Vec<_>> = value.entries.iter().map(Fraction::as_variable).collect();
            for place in none? {
                let system = &mut self.reading.system;
                system
                    .stays(place)
                    .then(|| system.atoms.set_none_at_blow(place))?;
            }
        }
        Some(())
    }

    /// "The bullet strikes the rod at A and sticks in it."
    pub(super) fn read_strikes(&mut self) {
        let strikes = |d: &&Declaration| d.statement.does("strike").is_some();
        let mut strikes = self.declarations.iter().filter(strikes);
        if let (Some(one), None) = (strikes.next(), strikes.next()) {
            self.reading.instants.strike = self.strike(one);
        }
    }

    fn strike(&self, declaration: &Declaration) -> Option<Strike> {
        let (subjects, slots) = declaration.statement.does("strike")?;
        let [striker] = subjects else { return None };
        let on = slot(slots, Slot::On)?;
        let strike = Strike {
            striker: self.body(striker)?,
            struck: self.body(on)?,
            at: self.point(slot(slots, Slot::At)?)?,
            sticks: self.declarations.iter().any(|d| sticks(d, striker, on)),
        };
        let system = &self.reading.system;
        let frame = system.bodies[strike.struck].frame?;
        let known = |body: BodyId| {
            let own = &system.bodies[body];
            body == strike.striker || own.frame == Some(frame) || !own.parts.is_empty()
        };
        let alone = system.contacts.is_empty() && (0..system.bodies.len()).all(known);
        let fits = system.bodies[strike.striker].is_particle()
            && system.carries(strike.struck, strike.at)
            && system.frames[frame].parent == Some(system.ground);
        let others = self.declarations.iter().any(tells_other_impulse);
        (alone && fits && !others).then_some(strike)
    }

    /// Whether something is made of it that one thing strikes another one, or sticks in it.
    pub(super) fn is_strike_read(&self) -> bool {
        self.reading.instants.strike.is_some()
    }

    /// What the impact leaves as it is.
    pub(super) fn hold_strike(&mut self) {
        let Some(strike) = self.reading.instants.strike else {
            return;
        };
        let said = self.declarations.iter();
        let said = said.filter(|d| d.statement.does("strike").is_some());
        for declaration in said {
            if self.hold_struck(strike, declaration).is_none() {
                self.reading.instants.strike = None;
                self.say_unused(declaration);
            }
        }
    }

    fn hold_struck(&mut self, strike: Strike, declaration: &Declaration) -> Option<()> {
        let (frame, ground) = (self.struck_frame(strike)?, self.reading.system.ground);
        if strike.sticks {
            let centre = self.centre_of(strike.striker);
            let own = self.system().velocity(centre, ground);
            let left = own - self.system().velocity(strike.at, ground);
            let left = self.reading.system.vector_at_blow(&left, Side::After)?;
            self.hold_zero(&left, declaration);
        }
        let Some(pivot) = self.hinge_point(frame) else {
            let linear = self.momentum_brought(&self.all_of(strike, frame))?;
            self.is_free(strike)?;
            self.hold_zero(&linear, declaration);
            let origin = self.system().origin();
            return self.hold_turning(strike, frame, origin, declaration);
        };
        self.hold_turning(strike, frame, pivot, declaration)
    }

    /// The angular momentum of all about a point, or the part of it along the axis about which alone the body turns, stays.
    fn hold_turning(
        &mut self,
        strike: Strike,
        frame: FrameId,
        about: PointId,
        declaration: &Declaration,
    ) -> Option<()> {
        let ground = self.reading.system.ground;
        let mut whole = Vector::zeros();
        for body in self.all_of(strike, frame) {
            whole += self
                .system()
                .angular_momentum(body, about, ground, Absolute);
        }
        let brought = self.brought(&whole)?;
        match self.reading.system.frames[frame].turn.clone() {
            Turn::Free => self.hold_zero(&brought, declaration),
            turn => {
                let axis = turn.axis()?;
                let along = self.system().axis(frame, axis);
                let along = self.reading.system.vector_at_blow(&along, Side::After)?;
                self.hold(along.dot(&brought), declaration);
            }
        }
        Some(())
    }

    fn struck_frame(&self, strike: Strike) -> Option<FrameId> {
        self.reading.system.bodies[strike.struck].frame
    }

    /// All that is fixed in a frame, and what strikes it.
    fn all_of(&self, strike: Strike, frame: FrameId) -> Vec<BodyId> {
        let mut all = self.bodies_in(frame);
        all.push(strike.striker);
        all
    }

    fn bodies_in(&self, frame: FrameId) -> Vec<BodyId> {
        let bodies = self.reading.system.bodies.iter().enumerate();
        let own = bodies.filter(|(_, body)| body.frame == Some(frame) && body.parts.is_empty());
        own.map(|(at, _)| at).collect()
    }

    /// The point that is fixed in a frame and in space.
    fn hinge_point(&self, frame: FrameId) -> Option<PointId> {
        let system = &self.reading.system;
        let fixed = |frames: &[FrameId]| frames.contains(&frame) && frames.contains(&system.ground);
        let mut points = system.points.iter();
        points.position(|point| fixed(&point.fixed_in))
    }

    /// Whether nothing holds the struck body: its mass centre may be anywhere.
    fn is_free(&self, strike: Strike) -> Option<()> {
        let system = &self.reading.system;
        let (from, way) = system.points[system.bodies[strike.struck].centre]
            .placed
            .as_ref()?;
        let anywhere = way.iter().all(|part| {
            let letter = part.as_variable();
            letter.is_some_and(|letter| system.atoms.is_unplaced(letter))
        });
        (anywhere && system.points[*from].fixed_in.contains(&system.ground)).then_some(())
    }

    fn momentum_brought(&mut self, bodies: &[BodyId]) -> Option<Vector> {
        let ground = self.reading.system.ground;
        let mut whole = Vector::zeros();
        for body in bodies {
            whole += self.system().momentum(*body, ground);
        }
        self.brought(&whole)
    }

    /// By how much something is more after the blow than before it.
    fn brought(&mut self, of: &Vector) -> Option<Vector> {
        let after = self.reading.system.vector_at_blow(of, Side::After)?;
        Some(after - self.reading.system.vector_at_blow(of, Side::Before)?)
    }

    /// "`$J$` is the impulse of the bullet on the rod", "the impulse of the hinge at O on the rod": what momentum it brings.
    pub(super) fn impulse_of_strike(&mut self, what: &NounPhrase) -> Option<Vector> {
        let strike = self
            .reading
            .instants
            .strike
            .filter(|_| what.head == IMPULSE)?;
        let frame = self.struck_frame(strike)?;
        let known = |(slot, _): &(Slot, Term)| {
            matches!(
                slot,
                Slot::Of | Slot::Upon | Slot::At | Slot::Along | Slot::With
            )
        };
        let (of, on) = (what.slot(Slot::Of)?, self.body(what.slot(Slot::Upon)?)?);
        if !what.slots.iter().all(known) {
            return None;
        }
        if self.is_hinge_of(of, what, frame) && on == strike.struck {
            let all = self.all_of(strike, frame);
            return self.momentum_brought(&all);
        }
        let own = self.momentum_brought(&[strike.striker])?;
        let at = what.slot(Slot::At).map(|at| self.point(at));
        match (self.body(of)?, on) {
            _ if at.is_some_and(|at| at != Some(strike.at)) => None,
            (of, on) if (of, on) == (strike.striker, strike.struck) => Some(-own),
            (of, on) if (of, on) == (strike.struck, strike.striker) => Some(own),
            _ => None,
        }
    }

    /// Whether a term is what holds the body at the point that does not move.
    fn is_hinge_of(&self, of: &Term, what: &NounPhrase, frame: FrameId) -> bool {
        let Some(pivot) = self.hinge_point(frame) else {
            return false;
        };
        let Term::Phrase(hinge) = of else {
            return name_of(of).is_some_and(|name| HINGES.contains(&name.as_str()));
        };
        let mut places = what
            .all(Slot::At)
            .chain(hinge.slots.iter().map(|(_, at)| at));
        HINGES.contains(&hinge.head) && places.all(|at| self.point(at) == Some(pivot))
    }

    /// "`$L\\,e$` is …", where a letter of which nothing is told stands beside a direction: what it is worth makes both the
    /// same in the blow.
    pub(super) fn hold_formula_at_blow(
        &mut self,
        formula: &Formula,
        value: &Value,
        declaration: &Declaration,
    ) -> Option<()> {
        let node = node_of(formula)?.clone();
        if !matches!(node.kind, Kind::Product(..)) {
            return None;
        }
        let open = symbols_in(&node);
        let open = open
            .into_iter()
            .filter(|letter| self.is_open(letter, declaration));
        let [letter] = open.collect::<Vec<_>>().try_into().ok()?;
        self.denote_number(&letter, declaration);
        let written = self.formula_value(formula, declaration)?;
        let custom = self.reading.letters.component_frame;
        let (left, right) = self.reading.system.compared(&written, value, custom).ok()?;
        for (left, right) in left.entries.iter().zip(&right.entries) {
            let left = self.reading.system.at_blow(left, Side::After)?;
            self.hold(left - right.clone(), declaration);
        }
        Some(())
    }

    /// Whether nothing tells what a letter is.
    fn is_open(&self, letter: &Formula, declaration: &Declaration) -> bool {
        let axis = node_of(letter).and_then(|_| name_of(&Term::Formula(letter.clone())));
        let axis = axis.is_some_and(|name| self.axes.get(&name).is_some());
        !axis && self.quantity_of(letter, declaration).is_none()
    }
}

/// "The bullet sticks in the rod."
fn sticks(declaration: &Declaration, striker: &Term, on: &Term) -> bool {
    let Some((subjects, slots)) = declaration.statement.does("stick") else {
        return false;
    };
    let mut others = slots.iter().map(|(_, other)| other);
    subjects == [striker.clone()] && others.all(|other| name_of(other) == name_of(on))
}

/// "After the impact the weights are the only loads on the rod", where sentences tell what strikes what: what is so just after
/// the impact these loads don't change, and of later times no line is denied.
pub(super) fn tells_loads_after_strike(declaration: &Declaration, all: &[Declaration]) -> bool {
    let Statement::Premise(loads) = &declaration.statement else {
        return false;
    };
    let later = loads
        .slots
        .iter()
        .any(|(_, when)| side(when) == Some(Side::After));
    let strikes = |d: &Declaration| d.statement.does("strike").is_some();
    loads.is("only") && later && all.iter().any(strikes)
}

/// Whether a sentence tells of an impulse that is none of one thing on another.
fn tells_other_impulse(declaration: &Declaration) -> bool {
    match &declaration.statement {
        Statement::Is { what, .. } if what.head == IMPULSE => {
            what.slot(Slot::Of).is_none() || what.slot(Slot::Upon).is_none()
        }
        Statement::Does { subjects, .. } => subjects.iter().any(|load| load.is_noun(IMPULSE)),
        Statement::Premise(premise) => {
            let of_weight = premise.slot(Slot::Of).is_some_and(|of| of.is_noun(WEIGHT));
            premise.head == IMPULSE && !of_weight
        }
        _ => false,
    }
}

/// Whether a sentence says that a letter is zero in a blow.
pub(super) fn tells_place_at_blow(declaration: &Declaration) -> bool {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let letters = subjects.iter().all(|s| matches!(s, Term::Formula(_)));
            what.head == "zero" && letters && is_at_blow(what)
        }
        _ => false,
    }
}
