//! Potential energies that are said to be those of loads: "`$V$` is the potential energy of the weight and of the spring".

use crate::algebra::{Fraction, Variable};
use crate::verify::language::heads::{CONSTANT, FORCE, MOMENT, WEIGHT};
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::model::atoms::{fraction, whole};
use crate::verify::model::system::{BodyId, Turn, Vector};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::POTENTIAL;
use crate::verify::reading::springs_read::is_spring;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

/// Whether a potential energy is said to be that of a weight and of other loads.
pub(super) fn is_potential_of_weight(what: &NounPhrase) -> bool {
    let several = what.all(Slot::Of).count() > 1;
    what.head == POTENTIAL && several && what.all(Slot::Of).any(is_weight)
}

fn is_weight(of: &Term) -> bool {
    matches!(of, Term::Phrase(load) if load.head == WEIGHT)
}

impl<'a> Builder<'a> {
    /// The potential energy of the weight of a body and of springs that turn it back: of no other one do sentences speak.
    pub(super) fn potential_of_loads(&mut self, phrase: &NounPhrase) -> Option<Quantity> {
        let others = self.declarations.iter().filter(|d| match &d.statement {
            Statement::Is { what, .. } => what.head == POTENTIAL,
            _ => false,
        });
        if others.count() != 1 {
            return None;
        }
        let (weights, springs): (Vec<&Term>, Vec<&Term>) =
            phrase.all(Slot::Of).partition(|of| is_weight(of));
        let [Term::Phrase(weight)] = weights.as_slice() else {
            return None;
        };
        let body = match weight.slot(Slot::Of) {
            Some(of) => self.body(of)?,
            None => self.only_weighed()?,
        };
        let parts = self.parts_that_move(body);
        let Quantity::Known(value) = self.potential_of(body, &parts)? else {
            return None;
        };
        let mut energy = value.to_scalar().ok()?;
        let zeros = self.zeros_of_potential(body);
        for spring in springs {
            let own = self.energy_of_torsion(spring, body)?;
            let shift = match zeros.iter().any(|(place, _)| place.is_condition()) {
                true => self.under(&own, &zeros)?,
                false => Fraction::zero(),
            };
            energy += own - shift;
        }
        Some(Quantity::Known(Value::scalar(energy)))
    }

    /// The body of which a sentence lists the loads, its weight among them.
    fn only_weighed(&self) -> Option<BodyId> {
        let mut listed = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Premise(premise) if premise.all(Slot::With).any(is_weight) => {
                let mut of = premise.all(Slot::Of);
                of.next().filter(|_| of.next().is_none())
            }
            _ => None,
        });
        match (listed.next(), listed.next()) {
            (Some(of), None) => self.body(of),
            (None, _) => self.only_body(),
            _ => None,
        }
    }

    /// −M²/2M′ of a spring that turns a body back by a moment M along the axis about which the body turns by an angle against
    /// what is at rest, where M grows in proportion to this angle.
    fn energy_of_torsion(&mut self, spring: &Term, body: BodyId) -> Option<Fraction> {
        if !is_spring(spring) {
            return None;
        }
        let (moment, along, declaration) = self.moment_told(spring, body)?;
        let name = Term::Name(self.reading.system.bodies[body].name.clone());
        let frame = self.reading.system.bodies[body].frame;
        let frame = frame.or_else(|| self.frame(&name))?;
        let turned = self.reading.system.frames[frame].clone();
        if turned.parent != Some(self.reading.system.ground) {
            return None;
        }
        let (axis, angle) = match turned.turn {
            Turn::Angle(number, angle) => (self.system().axis(frame, number), angle),
            Turn::About(axis, angle) => (*axis, angle),
            _ => return None,
        };
        let angle = angle.as_variable()?;
        let value = self.formula_value(moment, declaration)?;
        let moment: Vector = match along {
            Some(along) => {
                let size = value.to_scalar().ok()?;
                self.direction(along, declaration, Some(frame))? * size
            }
            None => value.to_vector().ok()?,
        };
        let size = moment.dot(&axis);
        if !self.vanishes(&(moment - axis * size.clone())) {
            return None;
        }
        let slope = self.system().partial(&size, angle);
        let linear = !slope.is_zero() && !slope.variables().contains(&angle);
        let others = size.variables().into_iter().filter(|v| *v != angle);
        let others: Vec<Variable> = others.collect();
        let still = others.into_iter().all(|v| self.is_told_constant(v));
        (linear && still).then(|| -(size.clone() * size) / (whole(2) * slope))
    }

    /// Whether a letter does not change, by its law or by a sentence.
    fn is_told_constant(&mut self, letter: Variable) -> bool {
        if self.system().atoms.derivative(&fraction(letter)).is_zero() {
            return true;
        }
        let declarations = self.declarations;
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } if what.head == CONSTANT => {
                subjects.iter().any(|subject| match subject {
                    Term::Formula(own) => {
                        let own = self.scalar(own, d);
                        own.is_some_and(|own| own.as_variable() == Some(letter))
                    }
                    _ => false,
                })
            }
            _ => false,
        })
    }

    /// "`$M$` is the moment of the spring on the body along z": the only one that is told of it.
    fn moment_told(
        &self,
        spring: &Term,
        body: BodyId,
    ) -> Option<(&'a Formula, Option<&'a Term>, &'a Declaration)> {
        let mut told = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } if matches!(what.head, MOMENT | FORCE) => {
                let own = what.slot(Slot::Of) == Some(spring);
                own.then_some((subjects.as_slice(), what, d))
            }
            _ => None,
        });
        let (subjects, what, declaration) = told.next().filter(|_| told.next().is_none())?;
        let upon = what.slot(Slot::Upon).and_then(|upon| self.body(upon));
        match subjects {
            [Term::Formula(moment)] if what.head == MOMENT && upon == Some(body) => {
                Some((moment, what.slot(Slot::Along), declaration))
            }
            _ => None,
        }
    }
}
