//! Energies of a body that a potential acts on: the sum of kinetic and potential energy, and Lagrange's equations.
//!
//! For L = T − V the motion obeys d/dt(∂L/∂q̇) = ∂L/∂q in each coordinate q whose rate stands in L (Goldstein, Poole and
//! Safko, Classical Mechanics, section 1.4).

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::points::Law;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};
use crate::verify::words::legend::names_the_lagrangian;
use num_traits::Zero;

/// Terms of a Lagrangian whose equations are set up.
const MOST_TERMS: usize = 60;
/// Words of forces that no potential has.
const OTHER_FORCES: &[&str] = &[
    "generalized force",
    "generalised force",
    "dissipat",
    "friction",
    "damp",
];

impl Checker<'_> {
    /// Notes a line that says what the potential energy is, and takes Lagrange's equations from one that says what L is.
    pub(crate) fn note_energies(&mut self, sides: &[Node], finding: &Finding) {
        if !matches!(finding.verdict, Verdict::Accepted | Verdict::Proved(_)) {
            return;
        }
        let Some(Kind::Symbol(symbol)) = sides.first().map(|side| &inner(side).kind) else {
            return;
        };
        let Some(entity) = self.own_number(symbol) else {
            return;
        };
        let words = self
            .sentence
            .rsplit('⟩')
            .next()
            .unwrap_or_default()
            .to_lowercase();
        if words.contains("potential energy") {
            self.potential = Some(entity);
        } else if matches!(symbol.name.as_str(), "L" | "ell") {
            self.take_lagrange_equations(entity);
        }
    }

    /// A symbol of the document that is one number.
    fn own_number(&mut self, symbol: &Symbol) -> Option<Entity> {
        let Meaning::Whole(entity) = self.meaning_of(symbol) else {
            return None;
        };
        let info = self.theory.atoms.info(entity);
        let own = matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Scalar;
        own.then_some(entity)
    }

    /// T + V for an E that the words call the energy, where the document has said what both are.
    pub(crate) fn total_energy(&mut self, symbol: &Symbol) -> Option<Law> {
        let words = lowered(&self.sentence);
        let part = has_any(&words, &["kinetic", "potential", "rotational"]);
        let named = matches!(symbol.name.as_str(), "E" | "H" | "h" | "W");
        if part || !named || !words.contains("energy") || !self.reading.speaks_of(Quantity::Energy)
        {
            return None;
        }
        let potential = self.potential?;
        let entity = self.own_number(symbol).filter(|&e| e != potential)?;
        let kinetic = self.theory.atoms.quantity(Quantity::Energy);
        let [kinetic, potential] = [kinetic, potential].map(|e| self.theory.atoms.value(e, 0, 0));
        Some(Law::new(
            "energy",
            entity,
            Value::scalar(kinetic + potential),
        ))
    }

    fn take_lagrange_equations(&mut self, lagrangian: Entity) {
        let text = self.text.lower();
        let conservative = !has_any(text, OTHER_FORCES);
        let named = text.contains("lagrang");
        // Without letters for the energies what is called the Lagrangian is their difference.
        let called = names_the_lagrangian(&lowered(&self.sentence))
            && !self.reading.speaks_of(Quantity::Energy)
            && self.potential.is_none();
        let kinetic = self.theory.atoms.quantity(Quantity::Energy);
        let mut known = |entity| self.theory.atoms.value(entity, 0, 0);
        let (whole, kinetic) = (known(lagrangian), known(kinetic));
        let potential = self.potential.map_or_else(Fraction::zero, known);
        let apart = self.theory.normal(&(whole.clone() - kinetic + potential));
        let value = self.theory.normal(&whole);
        if !named
            || !conservative
            || !(called || apart.is_zero())
            || value.numerator().len() > MOST_TERMS
        {
            return;
        }
        for (coordinate, rate) in self.coordinates_of_motion(&value) {
            self.take_lagrange_equation(&value, coordinate, rate);
        }
    }

    /// The symbols of the document whose rates stand in a value, each with its rate.
    fn coordinates_of_motion(&mut self, value: &Fraction) -> Vec<(Variable, Variable)> {
        let atoms = &mut self.theory.atoms;
        let mut found = vec![];
        for rate in value.variables() {
            let Atom::Part {
                entity,
                component: 0,
                order: 1,
            } = *atoms.atom(rate)
            else {
                continue;
            };
            if matches!(atoms.info(entity).owner, Owner::Symbol(_)) {
                found.push((atoms.part(entity, 0, 0), rate));
            }
        }
        found
    }

    fn take_lagrange_equation(&mut self, value: &Fraction, coordinate: Variable, rate: Variable) {
        let mut lowering = self.lowering(Frame::Moving);
        let momentum = lowering.partial(value, rate);
        let force = lowering.partial(value, coordinate);
        let residual = self.theory.atoms.derivative(&momentum) - force;
        let latex = crate::verify::names::latex(&self.theory.atoms, coordinate);
        let name = format!("Lagrange: {latex}");
        let Some(entity) = self.theory.atoms.entity_of(coordinate) else {
            return;
        };
        let preferred = vec![self.theory.atoms.part(entity, 0, 2)];
        self.theory.assume(Premise {
            name: name.clone(),
            residuals: vec![residual],
            preferred,
            // Solved behind what is said of rates: of a steady motion, what is left of it is a condition.
            definition: false,
        });
        self.keep(&name, true);
    }
}
