//! The moment about an axis that a rotor is turned about, `J\ddot\varphi + h\dot\alpha\cos\alpha = M`, in a document in
//! which nothing but the rotor has a momentum: J is the inertia of what does not spin, and the rotor adds the component of
//! dh/dt along the axis.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::line::Read;
use crate::verify::lines::points::Law;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::lower::constant;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::value::Value;
use crate::verify::verdict::Role;
use num_traits::Zero;

impl Checker<'_> {
    /// The new moment of an equation in the second rate of one angle, where the spin momentum stands in it.
    pub(crate) fn moment_about_gimbal(&mut self, sides: &[Node]) -> Option<Law> {
        if sides.len() != 2 || !self.reading.rotor_alone {
            return None;
        }
        let read = self.read(sides, Frame::Moving).ok()?;
        let entry = read.residuals().next().cloned();
        let entry = entry.filter(|_| read.residuals().count() == 1)?;
        let whole = self.theory.normal(&entry);
        let mut sum = whole.is_polynomial().then(|| whole.numerator().clone())?;
        let (angle, second) = self.only_second_rate(&sum)?;
        let inertia = sum.coefficient_of(second, 1);
        let [(_, number)] = inertia.terms() else {
            return None;
        };
        if *number < Rational::zero() {
            sum = -sum;
        }
        let spin = self.spin();
        let of_spin = |term: &Polynomial| term.variables().iter().any(|v| spin.contains(v));
        let moment = self.new_moment(&sum)?;
        if inertia.variables().is_empty() || !of_spin(&sum) {
            return None;
        }
        let axis = self.axis_of_turn(angle)?;
        let momentum = self.spin_momentum();
        let rate = self.lowering(Frame::Space).space_rate(&momentum);
        let along = rate.dot(&axis).ok()?.as_scalar()?.clone();
        let terms = sum.split().into_iter();
        let others = terms.map(|(number, term)| (number, Fraction::from(term)));
        let others = others
            .filter(|(_, term)| !of_spin(term.numerator()) && term.as_variable() != Some(moment));
        let value = others.fold(along, |all, (number, term)| all + term * constant(number));
        let entity = self.theory.atoms.entity_of(moment)?;
        Some(Law::new(
            "moment about the axis of the turn",
            entity,
            Value::scalar(value),
        ))
    }

    /// "Let ⟨T = …⟩ be the energy of the two motions": what does not spin has no inertia by which the laws know its energy.
    pub(crate) fn note_other_energy(&mut self, sides: &[Node], role: Role) {
        let energy = self.theory.atoms.quantity(Quantity::Energy);
        let Some(Kind::Symbol(symbol)) = sides.first().map(|side| &inner(side).kind) else {
            return;
        };
        let defined = role != Role::Claim && self.reading.rotor_alone && sides.len() == 2;
        let letter = Letter::of(symbol);
        let known = self.reading.quantities.get(&letter) == Some(&Quantity::Energy);
        if defined && known && !self.theory.mentions_entity(energy) {
            self.reading.quantities.remove(&letter);
            self.theory.atoms.forget_meanings();
        }
    }

    /// Whether the rate of a spin momentum stands in a difference with nothing but symbols of the document: where it
    /// lies, words may say.
    pub(crate) fn turns_a_lone_wheel(&mut self, read: &Read) -> bool {
        let of_body = [Quantity::Moment, Quantity::Momentum];
        if of_body.into_iter().any(|q| self.reading.speaks_of(q)) {
            return false;
        }
        let mut rate = false;
        for entry in read.residuals() {
            for variable in self.theory.normal(entry).variables() {
                match self.theory.atoms.owner(variable) {
                    Some(Owner::Symbol(_)) => {}
                    Some(Owner::Quantity(Quantity::RelativeMomentum, _)) => {
                        let atom = self.theory.atoms.atom(variable);
                        rate |= !matches!(atom, Atom::Part { order: 0, .. });
                    }
                    _ => return false,
                }
            }
        }
        rate
    }

    fn spin_momentum(&mut self) -> Value {
        let momentum = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        Value::column(self.theory.atoms.vector(momentum, 0))
    }

    /// What the spin momentum is made of, other than functions of angles.
    fn spin(&mut self) -> Vec<Variable> {
        let momentum = self.spin_momentum();
        let parts = momentum
            .entries
            .iter()
            .map(|entry| self.theory.normal(entry));
        let parts: Vec<Fraction> = parts.collect();
        let number = |v: &Variable| matches!(self.theory.atoms.atom(*v), Atom::Part { .. });
        let all = parts.iter().flat_map(Fraction::variables);
        all.filter(number).collect()
    }

    /// The only number of the document whose second rate stands in a sum, and that rate.
    fn only_second_rate(&self, sum: &Polynomial) -> Option<(Entity, Variable)> {
        let second = |v: Variable| match *self.theory.atoms.atom(v) {
            Atom::Part {
                entity, order: 2, ..
            } => Some((entity, v)),
            _ => None,
        };
        let mut met = sum.variables().into_iter().filter_map(second);
        let (entity, variable) = met.next().filter(|_| met.next().is_none())?;
        let info = self.theory.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Scalar;
        (own && sum.degree_in(variable) == 1).then_some((entity, variable))
    }

    /// The only term with a minus that is a lone symbol of which nothing is said.
    fn new_moment(&self, sum: &Polynomial) -> Option<Variable> {
        let new = |(number, term)| {
            let variable = Fraction::from(term).as_variable()?;
            let scalar = match self.theory.atoms.atom(variable) {
                Atom::Part {
                    entity, order: 0, ..
                } => self.theory.atoms.info(*entity).shape == Shape::Scalar,
                _ => false,
            };
            let new = scalar && number == Rational::from(-1) && !self.theory.mentions(variable);
            new.then_some(variable)
        };
        let mut met = sum.split().into_iter().filter_map(new);
        met.next().filter(|_| met.next().is_none())
    }

    /// The axis that an angle turns about: that of its rate in the angular velocity, or the one that turns the spin.
    fn axis_of_turn(&mut self, angle: Entity) -> Option<Value> {
        let rate = self.theory.atoms.part(angle, 0, 1);
        let angle = self.theory.atoms.part(angle, 0, 0);
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let omega = Value::column(self.theory.atoms.vector(omega, 0));
        let mut axis = omega.map(|part| self.theory.normal(part).partial(rate));
        if axis.is_zero() {
            let momentum = self.spin_momentum();
            let momentum = momentum.map(|part| self.theory.normal(part));
            let turned = momentum.map(|part| self.lowering(Frame::Moving).partial(part, angle));
            let square = momentum.dot(&momentum).ok()?.as_scalar()?.clone();
            let across = momentum.cross(&turned).ok()?;
            axis = across.map(|part| self.theory.normal(&(part.clone() / square.clone())));
        }
        let fixed = axis.entries.iter().all(|part| part.to_rational().is_some());
        (fixed && !axis.is_zero()).then_some(axis)
    }
}
