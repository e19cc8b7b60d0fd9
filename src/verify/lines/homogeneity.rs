//! Sums of one kind: in `\ell = d + k/d` with two lengths, a length and a number are added.
//!
//! Masses, inertias, rates and times have the dimensions that they have; those of the document's own symbols follow from
//! the premises, one symbol from one term at a time. What stays unknown fits anything.

use crate::algebra::{Fraction, Polynomial, Rational, Variable};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::given::is_zero;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Diagnosis, Finding, Verdict};
use std::collections::BTreeMap;

/// Powers of mass, length and time.
pub(crate) type Powers = [Rational; 3];
/// What is known of symbols.
type Known = BTreeMap<Entity, Powers>;

/// Words by which a mass may be missing.
const OF_UNIT: &[&str] = &[
    "unit mass",
    "per mass",
    "divided by the mass",
    "unit length",
    "unit radius",
];

/// Rounds in which dimensions are handed from premise to premise.
const ROUNDS: usize = 4;

impl Checker<'_> {
    /// Leaves open what was taken in and has terms of different dimensions: an ω that is given where ω̇ was meant. What
    /// it says is forgotten.
    pub(crate) fn withhold_inhomogeneous(&mut self, sides: &[Node], finding: &mut Finding) {
        // Of a chain of zeros each is zero.
        let zeros = sides.len() > 2 && sides.last().is_some_and(is_zero);
        if finding.verdict != Verdict::Accepted || sides.len() < 2 || zeros {
            return;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return;
        };
        // A constant may have any unit, and so may a coefficient where some quantity is a bare number.
        let number = |entry: &Fraction| {
            let mut terms = entry.numerator().terms().iter();
            terms.any(|(monomial, _)| monomial.degree() == 0)
        };
        let name = self.line_name(finding);
        let others = self.theory.premises().iter().filter(|p| p.name != name);
        if read.residuals().any(number) || others.flat_map(|p| &p.residuals).any(number) {
            return;
        }
        if read.residuals().any(|entry| self.is_inhomogeneous(entry)) {
            self.theory.retain(|premise| premise.name != name);
            finding.verdict = Verdict::Undecided;
            finding.remarks.clear();
            finding.reason = Some("its terms are measured in different units".to_owned());
            self.misses_the_mass(sides, finding);
            self.adds_unlike(sides, finding);
        }
    }

    /// Refutes `I_{rod} = \ell^2/12` beside a mass m: a moment of inertia by nothing but lengths.
    fn misses_the_mass(&mut self, sides: &[Node], finding: &mut Finding) {
        let [left, right] = sides else { return };
        let [whole, made_of] = [left, right].map(|side| self.entities([side]));
        let inertia = |owner: &Owner| match owner {
            Owner::Quantity(quantity, _) => *quantity == Quantity::Inertia,
            Owner::Symbol(key) => self.is_moment_of_inertia(key),
        };
        let length = |owner: &Owner| matches!(owner, Owner::Symbol(key) if self.is_length(key));
        let owner = |entity: &Entity| self.theory.atoms.info(*entity).owner.clone();
        let alone = matches!(inner(left).kind, Kind::Symbol(_));
        let missing = alone
            && self.reading.speaks_of(Quantity::Mass)
            && !made_of.is_empty()
            && whole.iter().map(owner).all(|owner| inertia(&owner))
            && made_of.iter().map(owner).all(|owner| length(&owner));
        if missing && !self.text.says(OF_UNIT) {
            finding.verdict = Verdict::Refuted;
            finding.diagnosis = Some(Diagnosis {
                kind: "dimension",
                message: "a moment of inertia is a mass times the square of a length: the mass is missing"
                    .to_owned(),
                suggestion: None,
                place: Some(right.span),
            });
        }
    }

    /// What a line gives no value but one of another dimension.
    pub(crate) fn has_no_value(&mut self, sides: &[Node], finding: &Finding) -> Vec<Entity> {
        let kind = finding.diagnosis.as_ref().map(|diagnosis| diagnosis.kind);
        match (&finding.verdict, kind) {
            (Verdict::Refuted, Some("dimension")) => self.entities(sides.iter().rev().skip(1)),
            _ => vec![],
        }
    }

    /// Refutes `I = m r^2 + R^2` beside two lengths by the words: what is added there are a moment of inertia and the
    /// square of a length.
    fn adds_unlike(&mut self, sides: &[Node], finding: &mut Finding) {
        let Some(last) = sides.last() else { return };
        let value = self.lowering(Frame::Moving).value(last);
        let Some(sum) = value.ok().and_then(|value| value.as_scalar().cloned()) else {
            return;
        };
        let terms = sum.numerator().terms().iter();
        let said = Known::new();
        let powers = terms.map(|(term, _)| self.powers_of(term.factors(), &said));
        let Some(powers) = powers.collect::<Option<Vec<_>>>() else {
            return;
        };
        let unlike = powers.windows(2).any(|pair| pair[0] != pair[1]);
        let alone = matches!(inner(&sides[0]).kind, Kind::Symbol(_));
        if unlike && alone && sum.is_polynomial() && !self.text.says(OF_UNIT) {
            finding.verdict = Verdict::Refuted;
            finding.diagnosis = Some(Diagnosis {
                kind: "dimension",
                message: "terms that are measured in different units are added".to_owned(),
                suggestion: None,
                place: Some(last.span),
            });
        }
    }

    /// Whether terms of different dimensions are added in a value.
    pub(crate) fn is_inhomogeneous(&self, value: &Fraction) -> bool {
        let several = |p: &Polynomial| p.len() > 1;
        if !several(value.numerator()) && !several(value.denominator()) {
            return false;
        }
        let known = self.dimensions_of_symbols(value);
        let mixes = |p: &Polynomial| {
            let terms = p.terms().iter();
            let mut all = terms.filter_map(|(m, _)| self.powers_of(m.factors(), &known));
            let first = all.next();
            first.is_some_and(|first| all.any(|other| other != first))
        };
        mixes(value.numerator()) || mixes(value.denominator())
    }

    /// The dimensions of symbols in a value, as far as the premises give them.
    fn dimensions_of_symbols(&self, value: &Fraction) -> Known {
        let mut known = Known::new();
        for pair in self.theory.setting.parallel_axes.iter().flatten() {
            let lengths = pair.distances(&self.theory.atoms).into_iter();
            known.extend(lengths.map(|length| (length, powers(0, 1, 0))));
            known.extend(pair.inertias().map(|inertia| (inertia, powers(1, 2, 0))));
        }
        let atoms = &self.theory.atoms;
        let inside = value.variables().into_iter();
        let inside = inside.filter_map(|v| atoms.entity_of(v)).collect();
        let premises = self
            .theory
            .premises_about(inside, |entity| self.powers_of_quantity(entity).is_none());
        for _ in 0..ROUNDS {
            let before = known.len();
            for residual in premises.iter().flat_map(|premise| &premise.residuals) {
                self.learn_from(residual.numerator(), &mut known);
            }
            if known.len() == before {
                break;
            }
        }
        known
    }

    /// Learns of the one unknown symbol of a term from another term of the same sum.
    fn learn_from(&self, sum: &Polynomial, known: &mut Known) {
        // A number in a sum says nothing of its unit.
        if sum.terms().iter().any(|(m, _)| m.degree() == 0) {
            return;
        }
        let mut terms = sum.terms().iter();
        let Some(whole) = terms.find_map(|(m, _)| self.powers_of(m.factors(), known)) else {
            return;
        };
        for (monomial, _) in sum.terms() {
            let (mut rest, mut unknown) = (whole.clone(), vec![]);
            for (variable, power) in monomial.factors() {
                match self.powers_of_variable(variable, known) {
                    Some(own) => rest = divided(rest, &own, power),
                    None => unknown.push((variable, power)),
                }
            }
            if let [(variable, power)] = unknown.as_slice()
                && let Atom::Part { entity, order, .. } = self.theory.atoms.atom(*variable)
            {
                let share = Rational::from((1, i64::from(*power)));
                let own = rest.map(|part| part * share.clone());
                known.insert(*entity, divided(own, &powers(0, 0, -1), u32::from(*order)));
            }
        }
    }

    fn powers_of(
        &self,
        factors: impl Iterator<Item = (Variable, u32)>,
        known: &Known,
    ) -> Option<Powers> {
        let mut below = powers(0, 0, 0);
        let mut any = false;
        for (variable, power) in factors {
            below = divided(below, &self.powers_of_variable(variable, known)?, power);
            any = true;
        }
        any.then(|| below.map(|part| -part))
    }

    fn powers_of_variable(&self, variable: Variable, known: &Known) -> Option<Powers> {
        match self.theory.atoms.atom(variable) {
            Atom::Part { entity, order, .. } => {
                let own = self.powers_of_quantity(*entity);
                let own = own.or_else(|| known.get(entity).cloned());
                own.map(|own| divided(own, &powers(0, 0, 1), u32::from(*order)))
            }
            Atom::Kernel {
                function: Function::Sin | Function::Cos,
                ..
            } => Some(powers(0, 0, 0)),
            _ => None,
        }
    }

    /// Whether words call a number of the document a length: the a of "edges ⟨a⟩ and ⟨b⟩".
    fn is_length(&self, key: &str) -> bool {
        let name = key.strip_suffix(" Scalar");
        name.is_some_and(|name| self.reading.lengths.contains(&Letter::plain(name)))
    }

    /// Whether a number of the document has the letter of the inertia and a label of its own: I_{box}.
    pub(crate) fn is_moment_of_inertia(&self, key: &str) -> bool {
        let name = key
            .strip_suffix(" Scalar")
            .and_then(|key| key.split_once(' '));
        name.is_some_and(|(letter, label)| {
            let quantity = self.reading.quantities.get(&Letter::plain(letter));
            quantity == Some(&Quantity::Inertia) && label.chars().all(char::is_alphabetic)
        })
    }

    pub(crate) fn powers_of_quantity(&self, entity: Entity) -> Option<Powers> {
        let info = self.theory.atoms.info(entity);
        let quantity = match &info.owner {
            Owner::Quantity(quantity, _) => quantity,
            Owner::Symbol(key) if self.is_length(key) => return Some(powers(0, 1, 0)),
            Owner::Symbol(key) if self.is_moment_of_inertia(key) => &Quantity::Inertia,
            Owner::Symbol(_) => return None,
        };
        Some(match quantity {
            Quantity::Mass => powers(1, 0, 0),
            Quantity::Time => powers(0, 0, 1),
            Quantity::Inertia => powers(1, 2, 0),
            Quantity::AngularVelocity | Quantity::FrameRate => powers(0, 0, -1),
            Quantity::Momentum => powers(1, 2, -1),
            Quantity::Moment | Quantity::Energy => powers(1, 2, -2),
            Quantity::Position => powers(0, 1, 0),
            _ => return None,
        })
    }
}

fn powers(mass: i64, length: i64, time: i64) -> Powers {
    [mass, length, time].map(Rational::from)
}

/// What is left of a dimension that is divided by a power of another.
fn divided(whole: Powers, own: &Powers, power: u32) -> Powers {
    let [mass, length, time] = whole;
    let times = Rational::from(i64::from(power));
    let [a, b, c] = own.clone().map(|part| part * times.clone());
    [mass - a, length - b, time - c]
}
