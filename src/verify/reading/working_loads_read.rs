//! "The weights and the motor moment are the only loads that do work on the arm": the loads of several bodies that are joined,
//! without the forces of their joints.

use crate::algebra::Variable;
use crate::verify::language::heads::{MOMENT, MOTOR_MOMENT, WEIGHT};
use crate::verify::language::statement::{
    Declaration, Formula, NounPhrase, Slot, Statement, Term, Touched,
};
use crate::verify::language::traits::is_force;
use crate::verify::model::loads::{Lasting, Load};
use crate::verify::model::system::{BodyId, Vector};
use crate::verify::model::virtual_power::Effort;
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::loads_read::letters_of;
use crate::verify::reading::names::name_of;
use crate::verify::reading::reactions_read::same_letter;
use crate::verify::reading::unused_read::MOVING;
use crate::verify::term::letters::Reach;

/// What drives a body, and no body itself.
pub(super) const MOTOR: &str = "motor";

/// What joins bodies without work.
const JOINTS: [&str; 6] = ["joint", "hinge", "pin", "bearing", "axle", "pivot"];

/// "`$s$` is a given function of the time"
const FUNCTION: &str = "function";

/// Of the loads that alone do work.
pub(super) const WORKING: &str = "working";

impl Builder<'_> {
    /// Whether a list of loads is of several joined bodies: of those that do work, or of what bodies do to each other as well.
    pub(super) fn is_list_of_joined(&self, premise: &NounPhrase) -> bool {
        let several = match premise.all(Slot::Of).count() {
            0 => self.whole_of_all().is_some(),
            named => named > 1,
        };
        let bodies = || self.joined_bodies(premise).is_some_and(|b| b.len() > 1);
        premise.is(WORKING) || several && bodies()
    }

    /// The body of which all others are parts.
    fn whole_of_all(&self) -> Option<BodyId> {
        let system = &self.reading.system;
        // What others roll on is no part of them.
        let plain = |body: &BodyId| {
            let body = &system.bodies[*body];
            body.parts.is_empty() && system.plane(&body.name).is_none()
        };
        let all = (0..system.bodies.len()).filter(plain).count();
        (0..system.bodies.len()).find(|&whole| all > 1 && system.wholes(whole).len() == all)
    }

    /// Whether a sentence of which nothing is made may tie the motion, or drive it.
    fn may_be_tied(&mut self) -> bool {
        self.declarations.iter().any(|d| {
            let all = &self.reading.unused;
            let unused = || all.iter().any(|u| u.sentence == d.sentence());
            match &d.statement {
                Statement::Unread { touched, .. } => !matches!(touched, Touched::Signs(_)),
                Statement::Does { verb, .. } => {
                    unused() || MOVING.contains(verb) && !self.moves_as_modelled(d)
                }
                Statement::Is { what, .. } if what.head == FUNCTION => unused(),
                _ => false,
            }
        })
    }

    /// The bodies of which a list tells the loads, each without parts; all where it names none.
    fn joined_bodies(&self, premise: &NounPhrase) -> Option<Vec<BodyId>> {
        let system = &self.reading.system;
        let named: Option<Vec<BodyId>> = premise.all(Slot::Of).map(|of| self.body(of)).collect();
        let named = match (named?, self.whole_of_all()) {
            (named, Some(whole)) if named.is_empty() => vec![whole],
            (named, None) if named.is_empty() => (0..system.bodies.len()).collect(),
            (named, _) => named,
        };
        let mut bodies: Vec<BodyId> = named.into_iter().flat_map(|b| system.wholes(b)).collect();
        bodies.sort_unstable();
        bodies.dedup();
        let plain = |body: &BodyId| {
            let body = &system.bodies[*body];
            body.rotors.is_none() && body.members.is_none()
        };
        bodies.iter().all(plain).then_some(bodies)
    }

    /// Holds the equations of motion that such lists tell, by what holds besides.
    pub(super) fn hold_working_loads(&mut self) {
        for declaration in self.declarations {
            if let Statement::Premise(premise) = &declaration.statement
                && premise.is("only")
                && matches!(premise.head, "load" | "force")
                && self.is_list_of_joined(premise)
            {
                let held = self.hold_joined(premise, declaration);
                held.unwrap_or_else(|| self.say_unused(declaration));
            }
        }
    }

    fn hold_joined(&mut self, premise: &NounPhrase, declaration: &Declaration) -> Option<()> {
        let known = |slot: &Slot| matches!(slot, Slot::Of | Slot::With);
        if self.may_be_tied() || !premise.slots.iter().all(|(slot, _)| known(slot)) {
            return None;
        }
        let bodies = self.joined_bodies(premise)?;
        let mut loads: Vec<Load> = vec![];
        for load in premise.all(Slot::With) {
            loads.extend(self.loads_on_joined(load, &bodies, declaration)?);
        }
        let opposites = loads.iter().filter_map(Load::opposite);
        let new = opposites.filter(|load| {
            let named = loads.iter().any(|l| l.called == load.called);
            load.on.is_some_and(|on| bodies.contains(&on)) && !named
        });
        let new: Vec<Load> = new.collect();
        loads.extend(new);
        let efforts = self.system().efforts(&bodies, &loads)?;
        let (efforts, steady) = self.with_constraints(efforts)?;
        let equations = self
            .system()
            .equations_by_virtual_power(&efforts, &steady)?;
        for equation in equations {
            self.hold(equation, declaration);
        }
        Some(())
    }

    /// The velocities with all constraints put in that sentences tell for the whole document, and the speeds that are kept.
    fn with_constraints(&mut self, efforts: Vec<Effort>) -> Option<(Vec<Effort>, Vec<Variable>)> {
        let mut facts = self.facts_of(|system, premise| system.is_constraint(&premise.equation));
        let always = self.reading.premises.iter();
        let always = always.filter(|premise| premise.reach == Reach::All);
        let system = &self.reading.system;
        let steady = always.filter_map(|premise| system.kept_speed(&premise.equation));
        let steady: Vec<Variable> = steady.collect();
        facts.missing().is_none().then_some(())?;
        let mut constrained = vec![];
        for (velocity, effort) in efforts {
            let mut told = Vector::zeros();
            for (told, part) in told.iter_mut().zip(velocity.iter()) {
                *told = facts.normal(&mut self.reading.system.atoms, part).ok()?;
            }
            constrained.push((told, effort));
        }
        Some((constrained, steady))
    }

    /// The loads that a term of a list names.
    fn loads_on_joined(
        &mut self,
        load: &Term,
        bodies: &[BodyId],
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        match load {
            Term::Formula(letter) => self.joined_by_letter(letter, declaration),
            Term::Phrase(load) if load.head == WEIGHT => self.weights_of(load, bodies),
            Term::Phrase(load) => {
                let letters: Vec<&Formula> = letters_of(load);
                if !letters.is_empty() {
                    let each = letters.into_iter();
                    let each = each.map(|letter| self.joined_by_letter(letter, declaration));
                    return Some(each.collect::<Option<Vec<_>>>()?.concat());
                }
                self.named_on_joined(load, bodies, declaration)
            }
            Term::Name(name) if name == MOTOR => self.loads_of_motors(declaration),
            _ => None,
        }
    }

    fn weights_of(&mut self, load: &NounPhrase, bodies: &[BodyId]) -> Option<Vec<Load>> {
        let own: Option<Vec<BodyId>> = load.all(Slot::Of).map(|of| self.body(of)).collect();
        let own = own.filter(|own| !own.is_empty() || load.slots.is_empty())?;
        let own: Vec<BodyId> = match own.is_empty() {
            true => bodies.to_vec(),
            false => own
                .into_iter()
                .flat_map(|b| self.reading.system.wholes(b))
                .collect(),
        };
        // Where the mass centre is at rest the weight does no work.
        let moves = |body: &BodyId| {
            let system = &self.reading.system;
            let centre = &system.points[self.centre_of(*body)];
            !centre.fixed_in.contains(&system.ground)
        };
        let moved: Vec<BodyId> = own.into_iter().filter(moves).collect();
        moved.into_iter().map(|body| self.weight_on(body)).collect()
    }

    /// A load by its letter: one that acts somewhere, or one of a body on another.
    fn joined_by_letter(
        &mut self,
        letter: &Formula,
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        let declarations = self.declarations;
        let between = declarations.iter().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let own = formulas(subjects).any(|own| same_letter(own, letter));
                (own && self.is_between(what, None)).then_some(what)
            }
            _ => None,
        });
        let loads = match between {
            Some(what) => vec![self.load_between(what, None)?],
            None => match self.load(letter, Lasting::Always) {
                Some(load) => vec![load],
                None => self.loads_of_letter(letter, declaration)?,
            },
        };
        loads.into_iter().map(|load| self.placed_on(load)).collect()
    }

    /// A load that a noun names, or a force by the point where it acts.
    fn named_on_joined(
        &mut self,
        load: &NounPhrase,
        bodies: &[BodyId],
        declaration: &Declaration,
    ) -> Option<Vec<Load>> {
        if self.is_between(load, None) {
            return Some(vec![self.load_between(load, None)?]);
        }
        // At a joint what one body does to the other has the opposite power.
        if load.slot(Slot::Of).is_some_and(is_joint) {
            return Some(vec![]);
        }
        let Some(at) = load.slot(Slot::At) else {
            let pair = bodies
                .iter()
                .find_map(|&body| self.kind_between(load, body));
            if let Some(pair) = pair {
                return Some(vec![pair]);
            }
            let by_motors = load.head == MOMENT && is_of_motors(load);
            let motors = by_motors || load.head == MOTOR_MOMENT && load.slots.is_empty();
            let told = motors.then(|| self.loads_of_motors(declaration)).flatten();
            return told.or_else(|| self.named_load(load, None));
        };
        let at = self.point(at).filter(|_| is_force(load.head))?;
        let named = self.loads_at(at, Lasting::Always);
        let carried = |body: &&BodyId| self.reading.system.carries(**body, at);
        if named.is_empty() && bodies.iter().filter(carried).count() > 1 {
            return Some(vec![]);
        }
        let loads = match named.is_empty() {
            true => vec![self.open_load(load.head, at, None, declaration)?],
            false => named,
        };
        loads.into_iter().map(|load| self.placed_on(load)).collect()
    }

    /// "the motor moment", where sentences tell letters for the moments of motors on bodies.
    fn loads_of_motors(&mut self, declaration: &Declaration) -> Option<Vec<Load>> {
        let declarations = self.declarations;
        let said = declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == MOMENT => {
                let motor = what.slot(Slot::Of).and_then(name_of);
                let on = what.slot(Slot::Upon).and_then(|upon| self.body(upon))?;
                (motor.as_deref() == Some(MOTOR)).then_some((subjects, on))
            }
            _ => None,
        });
        let said: Vec<(&Vec<Term>, BodyId)> = said.collect();
        let mut loads = vec![];
        // Between two bodies: "the motor acts on the one with the moment M and on the other with the opposite one".
        let between = declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == MOMENT => {
                (d.text.contains(MOTOR) && self.is_between(what, None)).then_some(subjects)
            }
            _ => None,
        });
        let between: Vec<&Vec<Term>> = between.collect();
        for letter in between.into_iter().flat_map(|letters| formulas(letters)) {
            loads.extend(self.joined_by_letter(letter, declaration)?);
        }
        for (letters, on) in said {
            for letter in formulas(letters) {
                let own = self.loads_of_letter(letter, declaration)?.into_iter();
                loads.extend(own.map(|load| Load {
                    on: Some(on),
                    ..load
                }));
            }
        }
        (!loads.is_empty()).then_some(loads)
    }

    /// A load with the body on which it acts: at a place of contact that of what touches, else that in which the point is fixed.
    fn placed_on(&self, load: Load) -> Option<Load> {
        let system = &self.reading.system;
        if load.on.is_some() {
            return Some(load);
        }
        let at = load.at?;
        let touching = system.contacts.iter().find(|c| c.point == at);
        let carries =
            |body: &BodyId| system.bodies[*body].centre == at || system.carries(*body, at);
        let carrying = (0..system.bodies.len()).find(carries);
        let on = touching.map(|c| c.body).or(carrying)?;
        Some(Load {
            on: Some(on),
            ..load
        })
    }
}

/// "the moments of the motors"
fn is_of_motors(load: &NounPhrase) -> bool {
    let motor = |agent: &Term| match agent {
        Term::Name(name) => name.trim_end_matches('s') == MOTOR,
        Term::Phrase(thing) => thing.head == MOTOR && thing.slots.is_empty(),
        _ => false,
    };
    matches!(load.slots.as_slice(), [(Slot::Of, agent)] if motor(agent))
}

/// "the force of the joint at H"
pub(super) fn is_joint(agent: &Term) -> bool {
    let one = |name: &str| JOINTS.contains(&name) || JOINTS.contains(&name.trim_end_matches('s'));
    match agent {
        Term::Name(name) => one(name),
        Term::Phrase(joint) => JOINTS.contains(&joint.head),
        _ => false,
    }
}
