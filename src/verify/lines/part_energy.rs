//! Kinetic energies of parts with a label of their own: a rotor of the moment J_m that turns at θ̇_m has ½ J_m θ̇_m².

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, axes, axis, inner};
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::{ANY_POINT, Meaning};
use crate::verify::verdict::{Diagnosis, Finding, Verdict};
use crate::verify::words::book::lowered;

/// Letters of moments of inertia, of angles and of rates.
const MOMENTS: &[&str] = &["I", "J", "C", "Theta"];
const ANGLES: &[&str] = &["theta", "varphi", "phi", "psi", "alpha", "beta", "q"];
const RATES: &[&str] = &["omega", "Omega"];

impl Checker<'_> {
    /// A kinetic energy that is set against a mass, the velocity of a point and the turning of the body has both parts.
    pub(crate) fn note_translation(&mut self, sides: &[Node]) {
        let [left, right @ ..] = sides else { return };
        // About a point at rest, the turning is all there is.
        let points = self.reading.points.as_ref();
        let about_another = points.is_some_and(|points| points.main != points.centre);
        if self.theory.setting.translation.is_some() || about_another {
            return;
        }
        let whole = |quantity| Owner::Quantity(quantity, String::new());
        let energy = self.entities([left]);
        let met = self.entities(right);
        let owner = |entity: &Entity| &self.theory.atoms.info(*entity).owner;
        let has = |quantity| met.iter().any(|entity| *owner(entity) == whole(quantity));
        let of_a_point = |owner: &Owner| match owner {
            Owner::Quantity(Quantity::Velocity, point) => !matches!(point.as_str(), "" | ANY_POINT),
            Owner::Quantity(quantity, _) => *quantity == Quantity::CentreVelocity,
            // Of a body that rolls in a plane, v is the speed of its centre.
            Owner::Symbol(key) => self.reading.plane && key.starts_with(['v', 'V']),
        };
        let Some(&centre) = met.iter().find(|entity| of_a_point(owner(entity))) else {
            return;
        };
        let turns = [
            Quantity::AngularVelocity,
            Quantity::Momentum,
            Quantity::Inertia,
        ];
        let lone = matches!(energy.as_slice(), [one] if *owner(one) == whole(Quantity::Energy));
        if lone && has(Quantity::Mass) && turns.into_iter().any(has) {
            self.theory
                .set(|setting| setting.translation = Some(centre));
        }
    }

    /// Refutes what words call the kinetic energy of a part where the moment and the rate with its label give another.
    pub(crate) fn energy_of_part(
        &mut self,
        left: &Node,
        right: &Node,
        finding: &mut Finding,
    ) -> bool {
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let [label] = symbol.subscripts.as_slice() else {
            return false;
        };
        let words = lowered(&self.sentence);
        let energy =
            matches!(symbol.name.as_str(), "K" | "T" | "E") && words.contains("kinetic energy");
        if !energy || axis(label).is_some() || axes(label).is_some() {
            return false;
        }
        let Some(law) = self.half_of_moment_and_square(label) else {
            return false;
        };
        let Ok(value) = self.lowering(Frame::Moving).value(right) else {
            return false;
        };
        let [made] = value.entries.as_slice() else {
            return false;
        };
        // What else turns the part has a share in its energy.
        let within = |fraction: &Fraction, whole: &Fraction| {
            let known = whole.variables();
            fraction.variables().iter().all(|v| known.contains(v))
        };
        let (made, law) = (self.theory.normal(made), self.theory.normal(&law));
        if !within(&made, &law) {
            return false;
        }
        let equation = Equation::of_scalars(law, made);
        let Decision::False(witness) = decide(&mut self.theory, &[equation]) else {
            return false;
        };
        finding.verdict = Verdict::Refuted;
        finding.reason = Some("its moment of inertia and its rate give another energy".to_owned());
        finding.counterexample = Some(*witness);
        finding.diagnosis = Some(Diagnosis {
            kind: "part-energy",
            message: format!(
                "half the moment of inertia times the square of the rate, both with the label {}, is something else",
                label.trim_matches(['(', ')'])
            ),
            suggestion: None,
            place: Some(finding.place),
        });
        true
    }

    /// ½ J θ̇², where the document has one moment and one rate with a label.
    fn half_of_moment_and_square(&mut self, label: &str) -> Option<Fraction> {
        let labelled = |name: &str| Symbol {
            name: name.to_owned(),
            subscripts: vec![label.to_owned()],
            ..Symbol::default()
        };
        let met = |checker: &Self, names: &[&'static str]| -> Vec<&'static str> {
            let usage = &checker.reading.usage;
            let has = |name: &&'static str| usage.has_index(&Letter::plain(name), label);
            names.iter().copied().filter(has).collect()
        };
        let of_inertia = |checker: &Self, name: &str| {
            let letter = Letter::plain(name);
            let part = checker.reading.components.get(&letter).map(|(q, _)| *q);
            checker.reading.quantities.get(&letter).copied().or(part) == Some(Quantity::Inertia)
        };
        let moments = met(self, MOMENTS);
        let [moment] = moments.as_slice() else {
            return None;
        };
        let moving = |checker: &Self, name: &str| checker.reading.usage.moves(&labelled(name));
        let angles: Vec<_> = met(self, ANGLES)
            .into_iter()
            .filter(|a| moving(self, a))
            .collect();
        let (rate, order) = match (angles.as_slice(), met(self, RATES).as_slice()) {
            ([angle], []) => (*angle, 1),
            ([], [rate]) => (*rate, 0),
            _ => return None,
        };
        if !of_inertia(self, moment) {
            return None;
        }
        let mut value = |name: &str, order: u8| match self.meaning_of(&labelled(name)) {
            Meaning::Whole(entity) => Some(self.theory.atoms.value(entity, 0, order)),
            Meaning::Component(entity, component) => {
                Some(self.theory.atoms.value(entity, component, order))
            }
            _ => None,
        };
        let (moment, rate) = (value(moment, 0)?, value(rate, order)?);
        Some(Fraction::from_ratio(1, 2) * moment * rate.clone() * rate)
    }
}
