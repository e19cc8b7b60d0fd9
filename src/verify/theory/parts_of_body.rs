//! A body of several parts that share an axis: the line that writes its momentum by the moments of the parts, each times
//! the rate with its label, `H = I_t(\omega_x i + \omega_y j) + (I_P\omega_P + I_R\omega_R) k` (Hughes, Spacecraft Attitude
//! Dynamics, chapter 6). What is beside Iω is in the wheels, and the kinetic energy is that of the parts.

use crate::algebra::{Fraction, Monomial, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Atom, Owner, variable_fraction};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::Finding;
use num_traits::{One, Zero};

/// The name of the premise on the energy.
const ENERGY: &str = "the kinetic energy of the parts";

/// A moment of inertia times a rate.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
struct Part {
    moment: Variable,
    rate: Variable,
    /// Whether the rate is a component of the angular velocity of the axes.
    of_axes: bool,
}

impl Checker<'_> {
    /// Takes in the momentum of a body of several parts as such a line has it.
    pub(crate) fn brings_parts(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, _] = sides else { return false };
        if self.theory.setting.gyrostat || !self.reading.speaks_of_wheels {
            return false;
        }
        let momentum = self.theory.atoms.quantity(Quantity::Momentum);
        let whole = match &inner(left).kind {
            Kind::Symbol(symbol) => self.meaning_of(symbol) == Meaning::Whole(momentum),
            _ => false,
        };
        if !whole || self.theory.mentions_entity(momentum) {
            return false;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let written = equation.right.entries.clone();
        let parts = written.iter().map(|entry| self.parts_of(entry));
        let Some(parts) = parts.collect::<Option<Vec<_>>>() else {
            return false;
        };
        let several = parts.iter().filter(|along| along.len() > 1).count() == 1;
        let mut across = parts.iter().filter(|along| along.len() == 1);
        let alike = match (across.next(), across.next()) {
            (Some(one), Some(other)) => one[0].moment == other[0].moment,
            _ => false,
        };
        if !several || !alike {
            return false;
        }
        let rests: Vec<Fraction> = read.residuals().cloned().collect();
        let rests = rests.iter().map(|rest| self.theory.normal(rest)).collect();
        if !self.take_wheels(rests, sides, finding) {
            return false;
        }
        self.take_energy_of_parts(&parts.concat());
        true
    }

    /// The parts that a component of the momentum is made of: each moment with a rate of its label or, for all of the
    /// body, with a component of the angular velocity of the axes.
    fn parts_of(&self, entry: &Fraction) -> Option<Vec<Part>> {
        let terms = entry.numerator().terms().iter();
        let parts = terms.map(|(term, factor)| {
            let part = self.part_of(term)?;
            let fits = part.of_axes || self.label(part.moment) == self.label(part.rate);
            (fits && *factor == One::one()).then_some(part)
        });
        let parts = parts.collect::<Option<Vec<_>>>()?;
        let polynomial = entry.is_polynomial() && !entry.is_zero();
        (polynomial && parts.iter().filter(|part| part.of_axes).count() < 2).then_some(parts)
    }

    fn part_of(&self, term: &Monomial) -> Option<Part> {
        let mut factors = term.factors();
        let (one, other, none) = (factors.next()?, factors.next()?, factors.next());
        if none.is_some() || one.1 != 1 || other.1 != 1 {
            return None;
        }
        let pairs = [(one.0, other.0), (other.0, one.0)];
        pairs.into_iter().find_map(|(moment, rate)| {
            let of_axes = match (self.theory.atoms.owner(rate), self.theory.atoms.atom(rate)) {
                (Some(Owner::Quantity(Quantity::AngularVelocity, variant)), _) => {
                    variant.is_empty()
                }
                _ => false,
            };
            let turns = of_axes || self.is_number_of(rate, Quantity::AngularVelocity);
            let fits = turns && self.is_number_of(moment, Quantity::Inertia);
            fits.then_some(Part {
                moment,
                rate,
                of_axes,
            })
        })
    }

    /// Whether a variable is a number with a label and the letter of a quantity.
    fn is_number_of(&self, variable: Variable, quantity: Quantity) -> bool {
        let letter = match self.theory.atoms.owner(variable) {
            Some(Owner::Symbol(key)) => key.split(' ').next().unwrap_or_default(),
            _ => return false,
        };
        let order = match *self.theory.atoms.atom(variable) {
            Atom::Part { order, .. } => order,
            _ => return false,
        };
        order == 0 && self.reading.quantities.get(&Letter::plain(letter)) == Some(&quantity)
    }

    fn label(&self, variable: Variable) -> Option<String> {
        let entity = self.theory.atoms.entity_of(variable)?;
        let latex = &self.theory.atoms.info(entity).latex;
        latex.split_once('_').map(|(_, label)| label.to_owned())
    }

    /// ½ Σ I_k ω_k².
    fn take_energy_of_parts(&mut self, parts: &[Part]) {
        let owner = Owner::Symbol(ENERGY.to_owned());
        let energy = self.theory.atoms.entity(&owner, Shape::Scalar, false, "T");
        let variable = self.theory.atoms.part(energy, 0, 0);
        let twice = parts.iter().fold(Fraction::zero(), |sum, part| {
            let rate = variable_fraction(part.rate);
            sum + variable_fraction(part.moment) * rate.clone() * rate
        });
        self.theory.assume(Premise {
            name: ENERGY.to_owned(),
            residuals: vec![variable_fraction(variable) - twice * Fraction::from_ratio(1, 2)],
            preferred: vec![variable],
            definition: true,
        });
        self.keep(ENERGY, true);
        self.theory
            .set(|setting| setting.energy_of_parts = Some(energy));
    }
}
