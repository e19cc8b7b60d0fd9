//! Loads that a noun names without a letter: "the thrust", "the drag on the aircraft".

use crate::verify::language::heads::{FORCE, FORCES_OF_A_KIND, MOMENT, MOMENTS_OF_A_KIND};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::loads::{Called, Lasting, Load};
use crate::verify::model::system::{BodyId, PointId, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::loads_read::is_force_at;
use crate::verify::reading::names::is_marked_vector;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};

/// Whether a phrase names a load by its noun, and not by the point where it acts.
pub(super) fn names_load(phrase: &NounPhrase) -> bool {
    let mut kinds = FORCES_OF_A_KIND.iter().chain(&MOMENTS_OF_A_KIND);
    kinds.any(|kind| *kind == phrase.head) && phrase.slot(Slot::At).is_none()
}

/// Whether what is said to be a load may be its size alone: a letter that is not written as a vector, of which no components
/// are told.
pub(super) fn may_be_size(subject: &Term, what: &NounPhrase) -> bool {
    let Term::Formula(formula) = subject else {
        return false;
    };
    !is_marked_vector(formula) && what.slot(Slot::On).is_none() && what.slot(Slot::Along).is_none()
}

impl Builder<'_> {
    /// The force of a load and its couple: what a noun names first is unknown, and the same wherever the noun stands again.
    pub(super) fn named_load(
        &mut self,
        phrase: &NounPhrase,
        on: Option<BodyId>,
    ) -> Option<Vec<Load>> {
        if let Some(load) = self.load_between(phrase, on) {
            return Some(vec![load]);
        }
        let agent = self.agent_outside(phrase, on);
        if !names_load(phrase) && agent.is_none() {
            return None;
        }
        let body = match (&agent, phrase.slot(Slot::Of)) {
            (Some(_), _) => match phrase.slot(Slot::Upon) {
                Some(upon) => self.body(upon)?,
                None => on?,
            },
            (None, Some(_)) => self.body_of(phrase)?,
            (None, None) => on.or_else(|| self.body_of(phrase))?,
        };
        let told = self.forces_of_agent(phrase, body);
        if agent.is_some() && !is_force_at(phrase) && !told.is_empty() {
            let loads = told.into_iter();
            return loads
                .map(|letter| self.load(letter, Lasting::Always))
                .collect();
        }
        let noun = [phrase.adjectives.as_slice(), &[phrase.head]].concat();
        let noun = noun.join(" ") + &agent.map_or_else(String::new, |agent| format!(" of {agent}"));
        let called = Called::Noun(noun, body);
        if self.loads_called(&called).is_empty() {
            if phrase.head == FORCE || FORCES_OF_A_KIND.contains(&phrase.head) {
                let force = self.free_load(&format!("F_{{{}}}", phrase.head), None)?;
                self.push_named_load(&called, force, Some(self.centre_of(body)));
            }
            let particle = self.reading.system.bodies[body].frame.is_none();
            if !particle || phrase.head != FORCE {
                let text = format!("M_{{{}}}", phrase.head);
                let axis = self.axis_of_moment(phrase, body);
                let moment = self.free_load(&text, axis)?;
                self.push_named_load(&called, moment, None);
            }
        }
        Some(self.loads_called(&called))
    }

    /// What acts on a body from outside: "the force of the air on the aircraft", where no sentence tells what the air is, or
    /// "the force of the rod on the particle".
    pub(super) fn agent_outside(&self, phrase: &NounPhrase, on: Option<BodyId>) -> Option<String> {
        let agent = phrase.slot(Slot::Of)?;
        let name = match agent {
            Term::Name(name) if name.starts_with(char::is_lowercase) => name.as_str(),
            // A place that may be a body as well: "the base".
            Term::Phrase(place) if place.slots.is_empty() => place.head,
            _ => return None,
        };
        let known = self.whole(agent).is_some()
            || self.point(agent).is_some()
            || self.plane(Some(agent)).is_some()
            || self.frames.contains_key(name);
        let upon = phrase.slot(Slot::Upon).and_then(|upon| self.body(upon));
        let upon = upon.or(on).map(|body| &self.reading.system.bodies[body]);
        let particle = upon.is_some_and(|body| body.frame.is_none() && body.parts.is_empty());
        let load = matches!(phrase.head, FORCE | MOMENT) && phrase.slot(Slot::At).is_none();
        (load && (!known || particle)).then(|| name.to_owned())
    }

    pub(super) fn loads_called(&self, called: &Called) -> Vec<Load> {
        let loads = self.reading.system.loads.iter();
        loads
            .filter(|load| load.called == *called)
            .cloned()
            .collect()
    }

    /// A force or a moment of which nothing is told, or only along which axis it is.
    pub(super) fn free_load(&mut self, text: &str, along: Option<Vector>) -> Option<Vector> {
        let text = text.to_owned();
        let system = self.system();
        match along {
            Some(axis) => {
                let constant = false;
                let size = system.value_of(&Quantity::Scalar { text, constant });
                Some(axis * size.ok()?.to_scalar().ok()?)
            }
            None => {
                let carried = None;
                let free = system.value_of(&Quantity::Vector { text, carried });
                free.ok()?.to_vector().ok()
            }
        }
    }

    fn push_named_load(&mut self, called: &Called, value: Vector, at: Option<PointId>) {
        self.system().loads.push(Load {
            called: called.clone(),
            at,
            value,
            lasting: Lasting::Always,
            part: false,
        });
    }

    /// The letters of forces that something else exerts on a body at points.
    fn forces_of_agent(&self, phrase: &NounPhrase, body: BodyId) -> Vec<&Formula> {
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let same = what.head == phrase.head && what.slot(Slot::Of) == phrase.slot(Slot::Of);
                let on = what.slot(Slot::Upon).and_then(|upon| self.body(upon));
                (same && is_force_at(what) && on == Some(body)).then_some(subjects)
            }
            _ => None,
        });
        said.flat_map(|subjects| formulas(subjects)).collect()
    }

    /// "`M` is the moment of the motor on the rotor along z": what no body of the system exerts has no other component.
    fn axis_of_moment(&mut self, phrase: &NounPhrase, on: BodyId) -> Option<Vector> {
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

    /// The force of a load that a noun names, or its moment where the noun is of one.
    pub(super) fn named_force(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let loads = self.named_load(phrase, None)?;
        let value = Value::vector(&loads.first()?.value, Basis::Itself);
        Some(Quantity::Known(value))
    }

    /// The moment about a point of a load that a noun names.
    pub(super) fn named_moment(&mut self, phrase: &NounPhrase, about: PointId) -> Option<Quantity> {
        let loads = self.named_load(phrase, None)?;
        let moment = self.reading.system.moment_of_loads(&loads, about);
        Some(Quantity::Known(Value::vector(&moment, Basis::Itself)))
    }

    /// The loads that a letter stands for, where a sentence says which load it is.
    pub(super) fn loads_of_letter(
        &mut self,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        let quantity = self.quantity_of(letter, declaration)?;
        let value = self.system().value_of(&quantity).ok()?.to_vector().ok()?;
        let loads = &self.reading.system.loads;
        let own = loads
            .iter()
            .find(|load| matches!(load.called, Called::Noun(..)) && load.value == value)?;
        Some(self.loads_called(&own.called.clone()))
    }
}
