//! Loads between a body of the system and something of which no sentence tells more: the air, a motor, the base. What the body
//! does to it is the opposite of what it does to the body.

use crate::notation::ast::{Kind, Node};
use crate::verify::language::heads::{CONTACT_FORCE, FORCE, MOMENT};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::whole;
use crate::verify::model::loads::Lasting;
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::load_quantities_read::is_load;
use crate::verify::reading::loads_read::{Acting, is_force_at};
use crate::verify::reading::named_loads_read::noun_of;
use crate::verify::reading::names::is_marked_vector;
use crate::verify::term::letters::{Meaning, Reach};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

impl Builder<'_> {
    /// "`$-X$` is the velocity of P": X is the opposite of it, if the writing is one of that kind.
    pub(super) fn denotes_opposite(
        &mut self,
        node: &Node,
        meaning: &Meaning,
        reach: &Reach,
        declaration: &Declaration,
    ) -> bool {
        let (Kind::Negate(inner), Meaning::Quantity(quantity)) = (&node.kind, meaning) else {
            return false;
        };
        let turned = Meaning::Quantity(opposite(quantity.clone()));
        self.denote_within(&Formula::of(inner), turned, reach.clone(), declaration);
        true
    }

    /// What acts on a body from outside: "the force of the air on the aircraft", where no sentence tells what the air is, or
    /// "the force of the rod on the particle".
    pub(super) fn agent_outside(&self, phrase: &NounPhrase, on: Option<BodyId>) -> Option<String> {
        let agent = phrase.slot(Slot::Of)?;
        let upon = phrase.slot(Slot::Upon).and_then(|upon| self.body(upon));
        let load = matches!(phrase.head, FORCE | CONTACT_FORCE | MOMENT);
        let load = load && phrase.slot(Slot::At).is_none();
        self.outside(agent, upon.or(on)).filter(|_| load)
    }

    /// "The moment of the base is the only load on the arm": the part of the arm on which another sentence says that it acts; all of
    /// the arm where none does, and nothing where several do.
    pub(super) fn part_acted_on(&self, load: &NounPhrase, whole: BodyId) -> Option<BodyId> {
        let parts = self.reading.system.wholes(whole);
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { what, .. } if what.head == load.head => Some(what),
            _ => None,
        });
        let same = said.filter(|what| what.slot(Slot::Of) == load.slot(Slot::Of));
        let upon = same.filter_map(|what| self.body(what.slot(Slot::Upon)?));
        let mut upon: Vec<BodyId> = upon.filter(|body| parts.contains(body)).collect();
        upon.sort_unstable();
        upon.dedup();
        match upon.as_slice() {
            [] => Some(whole),
            [part] => Some(*part),
            _ => None,
        }
    }

    /// What is no body of the system beside a rigid one, by its name.
    pub(super) fn outside(&self, other: &Term, body: Option<BodyId>) -> Option<String> {
        let name = match other {
            Term::Name(name) if name.starts_with(char::is_lowercase) => name.as_str(),
            // A place that may be a body as well: "the base"; a load exerts none.
            Term::Phrase(place) if place.slots.is_empty() && !is_load(place) => place.head,
            _ => return None,
        };
        let known = self.whole(other).is_some()
            || self.point(other).is_some()
            || self.plane(Some(other)).is_some()
            || self.frames.contains_key(name);
        let particle = body.is_some_and(|body| self.reading.system.bodies[body].is_particle());
        (!known || particle).then(|| name.to_owned())
    }

    /// "the force of the wheel on the base", where the base is outside: that of the base on the wheel.
    pub(super) fn reversed(&self, phrase: &NounPhrase) -> Option<NounPhrase> {
        let body = self.body(phrase.slot(Slot::Of)?)?;
        self.outside(phrase.slot(Slot::Upon)?, Some(body))?;
        let mut reversed = phrase.clone();
        for (slot, _) in &mut reversed.slots {
            *slot = match *slot {
                Slot::Of => Slot::Upon,
                Slot::Upon => Slot::Of,
                other => other,
            };
        }
        Some(reversed)
    }

    /// Whether a load is one on something outside.
    pub(super) fn acts_outside(&self, load: &NounPhrase) -> bool {
        let upon = load.slot(Slot::Upon);
        upon.is_some_and(|upon| self.outside(upon, None).is_some())
    }

    /// "`F` is the force of the wheel on the base at P": at P the opposite acts on the wheel, under another letter or none.
    pub(super) fn read_opposites(&mut self) {
        for declaration in self.declarations {
            if let Statement::Is { subjects, what } = &declaration.statement
                && is_force_at(what)
                && let Some(reversed) = self.reversed(what)
            {
                let read = self.read_opposite(subjects, &reversed, declaration);
                read.unwrap_or_else(|| self.say_unused(declaration));
            }
        }
    }

    fn read_opposite(
        &mut self,
        subjects: &[Term],
        reversed: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let body = self.body(reversed.slot(Slot::Upon)?)?;
        let at = self.point(reversed.slot(Slot::At)?)?;
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        if !is_marked_vector(letter) || reversed.slot(Slot::Along).is_some() {
            return None;
        }
        if let Some(told) = self.told_at(reversed, body, at) {
            let known = Quantity::Known(Value::vector(&-told, Basis::Itself));
            self.denote(letter, Meaning::Quantity(known), declaration);
            return Some(());
        }
        let agent = self.outside(reversed.slot(Slot::Of)?, Some(body))?;
        let acting = Acting {
            head: FORCE,
            letter,
            at: Some(at),
            along: None,
            on: Some(body),
        };
        let value = -self.value_of_load(&acting, declaration)?;
        let noun = noun_of(reversed, Some(&agent));
        self.push_named_load((&noun, body), value, Some(at));
        Some(())
    }

    /// The force at a point that a letter names as that of something outside.
    fn told_at(&self, load: &NounPhrase, body: BodyId, at: PointId) -> Option<Vector> {
        let letters = self.forces_of_agent(load, body).into_iter();
        let mut loads = letters.filter_map(|letter| self.load(letter, Lasting::Always));
        Some(loads.find(|load| load.at == Some(at))?.value)
    }

    /// "`M` is the moment of the motor on the rotor along z": what no body of the system exerts has no other component.
    pub(super) fn axis_of_moment(&mut self, phrase: &NounPhrase, on: BodyId) -> Option<Vector> {
        let agent = phrase.slot(Slot::Of).filter(|_| phrase.head == MOMENT)?;
        let declarations = self.declarations;
        declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == MOMENT => {
                let size = matches!(subjects.as_slice(), [Term::Formula(letter)] if !is_marked_vector(letter));
                let same = size
                    && what.slot(Slot::Of) == Some(agent)
                    && self.body(what.slot(Slot::Upon)?) == Some(on);
                let along = what.slot(Slot::Along).filter(|_| same)?;
                self.direction(&along.clone(), d, None)
            }
            _ => None,
        })
    }
}

/// What is as large and points the other way.
pub(super) fn opposite(load: Quantity) -> Quantity {
    Quantity::Scaled(load.boxed(), whole(-1))
}
