//! Potential energies of weights, and where they are zero: at a point, or for values of angles.

use crate::algebra::{Fraction, Variable, compose};
use crate::notation::document::Row;
use crate::verify::language::heads::{
    ENERGY_OF_ROTATION, FORCE, HEIGHT, OF_LOADS, OF_POTENTIALS, WEIGHT,
};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::language::traits::{Trait, has};
use crate::verify::model::atoms::{Nature, whole};
use crate::verify::model::system::{BodyId, FrameId, PointId, Vector};
use crate::verify::reading::builder::{Builder, MOST_TERMS};
use crate::verify::reading::names::POTENTIAL;
use crate::verify::reading::potentials_of_loads::is_potential_of_weight;
use crate::verify::reading::springs_read::{is_of_spring, speaks_of_spring};
use crate::verify::reading::working_loads_read::{MOTOR, is_joint};
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;
use std::collections::HashMap;

/// Forces that may do work.
const FORCES_AT_WORK: [&str; 2] = [FORCE, "load"];

/// What has a stiffness or a damping and is no spring between two points.
const ELASTIC: [&str; 2] = ["stiffness", "damping"];

/// Whether a sentence says for which values of letters a potential energy is zero: "`$V$` is zero at `$\\theta = 0$`".
pub(super) fn tells_zero_of_potential(declaration: &Declaration, all: &[Declaration]) -> bool {
    match &declaration.statement {
        Statement::Premise(premise) => premise.head == POTENTIAL,
        Statement::Is { subjects, what } if what.head == "zero" && what.adjectives.is_empty() => {
            !subjects.is_empty() && subjects.iter().all(|subject| is_potential(subject, all))
        }
        _ => false,
    }
}

/// Whether a sentence says that a letter is a potential energy.
fn is_potential(letter: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head == POTENTIAL && subjects.contains(letter),
        _ => false,
    })
}

impl<'a> Builder<'a> {
    /// T + V or T − V; where weights act, not without their potential energy.
    pub(super) fn with_potential(
        &mut self,
        body: usize,
        kinetic: Quantity,
        sign: i64,
    ) -> Option<Quantity> {
        let spoken = self.speaks_of_potential(body);
        // A Lagrangian is told but for a constant.
        let parts = match sign < 0 && !spoken {
            true => self.parts_at_known_heights(body),
            false => vec![body],
        };
        let springs = self.energies_of_springs(body)?;
        let potential = self.potential_of(body, &parts);
        let unknown = potential.is_none() && self.gravity.is_some();
        let works = |d: &Declaration| self.may_do_work(d);
        // Where sentences speak of the potential energy of the body, or of all its parts that have one, no other load has one.
        let of_parts = || parts.iter().all(|&part| self.speaks_of_potential(part));
        let told = potential.is_some() && (spoken || of_parts());
        if unknown || !told && self.declarations.iter().any(works) {
            return None;
        }
        let signed = |v: Quantity| Quantity::Scaled(v.boxed(), whole(sign));
        let springs = springs
            .into_iter()
            .map(|energy| Quantity::Known(Value::scalar(energy)));
        let energies = potential.into_iter().chain(springs).map(signed);
        let terms = std::iter::once(kinetic).chain(energies);
        Some(Quantity::Sum(terms.collect()))
    }

    /// Whether a kinetic energy is that of rotation: with velocities relative to the mass centre it is, and with those relative
    /// to the frame itself it is what it is without these words. With others none is known.
    pub(super) fn is_of_rotation(
        &self,
        energy: &NounPhrase,
        relative: FrameId,
        body: Option<BodyId>,
    ) -> Option<bool> {
        match energy.slot(Slot::VelocitiesRelativeTo) {
            Some(term) if self.frame(term) != Some(relative) => {
                let centre = self.point(term) == Some(self.centre_of(body?));
                centre.then_some(true)
            }
            _ => Some(energy.head == ENERGY_OF_ROTATION),
        }
    }

    /// "`$V$` is the potential energy of P."
    fn speaks_of_potential(&self, body: usize) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == POTENTIAL => {
                let letters = subjects.iter().all(|s| matches!(s, Term::Formula(_)));
                letters && self.body_of(what) == Some(body)
            }
            _ => false,
        })
    }

    /// Whether a sentence tells of a load that may have a potential energy besides a weight of which all is known: no force at a
    /// point, which holds a body there, and none of a plane on which it moves.
    fn may_do_work(&self, declaration: &Declaration) -> bool {
        let weightless = self.gravity.is_none();
        let weighs = |phrase: &NounPhrase| phrase.head == WEIGHT || phrase.head == POTENTIAL;
        let holds = |load: &NounPhrase| {
            load.slot(Slot::At).is_some()
                || load.slot(Slot::Of).is_some_and(is_joint)
                || has(load.head, Trait::Touch)
        };
        // What springs do is in their potential energies.
        let works = |load: &NounPhrase| match weighs(load) {
            _ if is_of_spring(load) => false,
            true => weightless,
            // Where a sentence lists all loads their sum is no other one.
            false if load.is("total") && self.lists_loads() => false,
            false => FORCES_AT_WORK.contains(&load.head) && !holds(load),
        };
        match &declaration.statement {
            Statement::Is { subjects, what } => {
                let letters = subjects.iter().any(|s| matches!(s, Term::Formula(_)));
                letters && works(what) || ELASTIC.contains(&what.head) && !is_of_spring(what)
            }
            Statement::Premise(premise) if premise.is("only") => {
                premise.all(Slot::With).any(|load| match load {
                    Term::Phrase(load) => works(load),
                    Term::Name(name) => name != MOTOR,
                    // What a load is that the list has by its letter, another sentence tells.
                    Term::Formula(letter) => {
                        let kinds = self.kinds_of_load(letter);
                        kinds.is_empty() || kinds.into_iter().any(works)
                    }
                    _ => true,
                })
            }
            Statement::Does {
                subjects,
                verb: "act",
                slots,
            } => {
                let at = slots.iter().any(|(slot, _)| *slot == Slot::At);
                let works = |load: &Term| match load {
                    Term::Formula(_) => true,
                    Term::Phrase(load) => works(load),
                    _ => false,
                };
                !at && subjects.iter().any(works)
            }
            Statement::Unread { .. } => declaration.may_speak_of(&OF_LOADS),
            _ => false,
        }
    }

    /// What sentences say a load to be that is known by its letter.
    fn kinds_of_load(&self, letter: &Formula) -> Vec<&NounPhrase> {
        let own = |s: &Term| matches!(s, Term::Formula(own) if own.source == letter.source);
        let told = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if subjects.iter().any(own) => Some(what),
            _ => None,
        });
        told.collect()
    }

    /// −m g · r, from the origin or from where it is said to be zero.
    pub(super) fn potential_energy(&mut self, body: usize) -> Option<Quantity> {
        // Whether the energy of a spring is one of the body as well is open.
        match self.declarations.iter().any(speaks_of_spring) {
            true => None,
            false => self.potential_of(body, &self.parts_that_move(body)),
        }
    }

    /// The parts of a body that are fixed in several frames: where its mass centre is they tell; else the body itself.
    pub(super) fn parts_that_move(&self, body: usize) -> Vec<usize> {
        let system = &self.reading.system;
        let parts = system.wholes(body);
        let frames = parts.windows(2);
        let frame = |part: usize| system.bodies[part].frame;
        let apart = frames.map(|pair| frame(pair[0]).zip(frame(pair[1])));
        let mut apart = apart.flatten().filter(|(one, next)| one != next);
        let counted = |&part: &usize| system.bodies[part].members.is_some();
        match apart.next().is_some() && !parts.iter().any(counted) {
            true => parts,
            false => vec![body],
        }
    }

    /// The same of parts of a body, which are all that changes it.
    pub(super) fn potential_of(&mut self, body: usize, parts: &[usize]) -> Option<Quantity> {
        let gravity = self.gravity.clone()?;
        let mut declarations = self.declarations.iter();
        if declarations.any(|d| d.may_speak_of(&OF_POTENTIALS)) {
            return None;
        }
        let zeros = self.zeros_of_potential(body);
        let value = self.system().value_of(&gravity).ok()?.to_vector().ok()?;
        let from = match zeros.as_slice() {
            [(place, _)] if !place.is_condition() => self.point(level_of(place))?,
            _ => 0,
        };
        let energies = parts
            .iter()
            .map(|&part| self.energy_above(part, &value, from));
        let mut energy = energies.fold(Fraction::zero(), |sum, energy| sum + energy);
        if zeros.iter().any(|(place, _)| place.is_condition()) {
            energy = energy.clone() - self.under(&energy, &zeros)?;
        }
        Some(Quantity::Known(Value::scalar(energy)))
    }

    /// The parts of a body but for those that stay at a height of which nothing is told; the body itself where there are none.
    fn parts_at_known_heights(&mut self, body: usize) -> Vec<usize> {
        let parts = self.reading.system.wholes(body);
        let Some(gravity) = self.gravity.clone().filter(|_| parts.len() > 1) else {
            return vec![body];
        };
        let gravity = self.system().value_of(&gravity).ok();
        let Some(gravity) = gravity.and_then(|gravity| gravity.to_vector().ok()) else {
            return vec![body];
        };
        let count = parts.len();
        let known: Vec<usize> = parts
            .into_iter()
            .filter(|&part| {
                let energy = self.energy_above(part, &gravity, 0);
                let rate = self.system().atoms.derivative(&energy);
                let moves = !self.system().expanded(&rate, &[]).is_zero();
                let atoms = &self.reading.system.atoms;
                moves || !energy.variables().iter().any(|v| atoms.is_unplaced(*v))
            })
            .collect();
        match known.len() == count {
            true => vec![body],
            false => known,
        }
    }

    fn energy_above(&mut self, body: usize, gravity: &Vector, from: PointId) -> Fraction {
        let mass = self.reading.system.mass(body);
        let centre = self.centre_of(body);
        let way = self.reading.system.position(centre, from);
        -(gravity.dot(&way) * mass)
    }

    /// Where a sentence says that the potential energy of a body is zero.
    pub(super) fn zeros_of_potential(&self, body: usize) -> Vec<(&'a Term, &'a Declaration)> {
        let of_body = |of: Option<&Term>| of.is_none_or(|of| self.body(of) == Some(body));
        let said = self.declarations.iter().find_map(|d| match &d.statement {
            Statement::Premise(premise) if premise.head == POTENTIAL => {
                of_body(premise.slot(Slot::Of)).then_some((premise, d))
            }
            Statement::Is { subjects, what } if what.head == "zero" => {
                let own = |letter: &Term| self.is_potential_of(letter, body);
                let told = tells_zero_of_potential(d, self.declarations);
                (told && subjects.iter().any(own)).then_some((what, d))
            }
            _ => None,
        });
        let at = said.map(|(what, d)| what.all(Slot::At).map(move |term| (term, d)));
        at.into_iter().flatten().collect()
    }

    fn is_potential_of(&self, letter: &Term, body: usize) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == POTENTIAL => {
                let of = what
                    .slot(Slot::Of)
                    .map_or(self.only_body(), |of| self.body(of));
                let own = of == Some(body) || is_potential_of_weight(what);
                subjects.contains(letter) && own
            }
            _ => false,
        })
    }

    /// A value where letters have other values: `\\theta = 0`, `\\alpha = \\beta = \\pi/2`.
    pub(super) fn under(
        &mut self,
        value: &Fraction,
        conditions: &[(&Term, &Declaration)],
    ) -> Option<Fraction> {
        let mut images: HashMap<Variable, Fraction> = HashMap::new();
        for (condition, declaration) in conditions {
            let Term::Formula(Formula {
                row: Row::Line(line),
                ..
            }) = condition
            else {
                return None;
            };
            let (told, letters) = line.sides.split_last()?;
            let told = self.formula_value(&Formula::of(told), declaration)?;
            let told = told.to_scalar().ok()?;
            for letter in letters {
                let letter = self.scalar(&Formula::of(letter), declaration)?;
                images.insert(letter.as_variable()?, told.clone());
            }
        }
        let value = self.system().expanded(value, &[]);
        for kernel in value.variables() {
            let atoms = &self.reading.system.atoms;
            let sine = matches!(atoms.atom(kernel).nature, Nature::Sine(_));
            let Some(angle) = atoms.angle_of(kernel).cloned() else {
                continue;
            };
            if angle.variables().iter().any(|v| images.contains_key(v)) {
                let there = composed(&angle, &images)?;
                let (c, s) = self.system().atoms.cosine_sine(&there)?;
                images.insert(kernel, if sine { s } else { c });
            }
        }
        composed(&value, &images)
    }
}

/// "at the height of O": at O.
fn level_of(place: &Term) -> &Term {
    match place {
        Term::Phrase(height) if height.head == HEIGHT && height.slots.len() == 1 => {
            height.slot(Slot::Of).unwrap_or(place)
        }
        place => place,
    }
}

fn composed(of: &Fraction, images: &HashMap<Variable, Fraction>) -> Option<Fraction> {
    let put = |polynomial| compose(polynomial, images, MOST_TERMS).ok();
    Some(put(of.numerator())? / put(of.denominator())?)
}
