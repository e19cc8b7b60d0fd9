//! The moment that the gradient of gravity exerts on a body in orbit, 3μ/R⁵ R×(I R) with R from the centre of the planet
//! (Hughes, Spacecraft Attitude Dynamics, section 8.1): 3n² u×(I u) with a unit vector u and the orbital rate n.

use crate::algebra::{Fraction, Polynomial};
use crate::notation::ast::Node;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::Letter;
use crate::verify::lines::line::Read;
use crate::verify::theory::law::inertia;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::words::points_in_words::called_unit;
use nalgebra::Vector3;
use num_traits::Zero;

impl Checker<'_> {
    /// Whether the right side of an equation is this moment for a vector of the document.
    pub(crate) fn is_gravity_gradient(&mut self, read: &Read) -> bool {
        if !self.text.says(&["gravity", "gravitational"]) {
            return false;
        }
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let written = equation.right.entries.clone();
        self.is_moment_of_gradient(&written)
    }

    /// Whether a premise is that this moment acts, and no words from a heading on take it away: gravity does not end with
    /// a section.
    pub(crate) fn goes_on_in_orbit(&mut self, name: &str, heading: Span) -> bool {
        let mut premises = self.theory.premises().iter();
        let Some(premise) = premises.find(|p| p.name == name && p.residuals.len() == 3) else {
            return false;
        };
        let residuals = premise.residuals.clone();
        if !self.text.says(&["gravity", "gravitational"]) || self.is_freed_from(heading) {
            return false;
        }
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let written: Vec<Fraction> = (0..)
            .zip(residuals)
            .map(|(c, residual)| self.theory.atoms.value(moment, c, 0) - residual)
            .collect();
        self.is_moment_of_gradient(&written)
    }

    fn is_moment_of_gradient(&mut self, written: &[Fraction]) -> bool {
        let vectors: Vec<Entity> = written
            .iter()
            .flat_map(Fraction::variables)
            .filter_map(|v| self.theory.atoms.entity_of(v))
            .filter(|&e| {
                let info = self.theory.atoms.info(e);
                let from_planet = match &info.owner {
                    Owner::Symbol(_) => true,
                    Owner::Quantity(quantity, _) => *quantity == Quantity::Position,
                };
                from_planet && info.shape == Shape::Vector
            })
            .collect();
        vectors
            .first()
            .is_some_and(|&u| self.is_moment_along(written, u))
    }

    /// Whether sides say what the rate of a circular orbit is: Kepler's `n^2 = \mu/R^3`, or `GM/R^3`.
    pub(crate) fn is_law_of_orbit(&mut self, right: &Node) -> bool {
        if !self.text.says(&["orbit"]) {
            return false;
        }
        let Some(value) = self.lowering(Frame::Moving).scalar(right) else {
            return false;
        };
        let one = |p: &Polynomial| p.len() == 1 && p.leading_coefficient() == 1.into();
        let (above, below) = (value.numerator(), value.denominator());
        let degrees = |p: &Polynomial| -> Vec<u32> {
            p.variables().into_iter().map(|v| p.degree_in(v)).collect()
        };
        one(above)
            && one(below)
            && matches!(degrees(above).as_slice(), [1] | [1, 1])
            && degrees(below) == [3]
    }

    fn is_moment_along(&mut self, written: &[Fraction], along: Entity) -> bool {
        let u = Vector3::from(self.theory.atoms.vector(along, 0));
        let tensor = inertia(&mut self.theory.atoms, self.theory.setting.products);
        let whole = u.cross(&(tensor * u.clone()));
        let ([first, ..], true) = (written, written.len() == 3) else {
            return false;
        };
        let above = first.numerator().exact_quotient(whole[0].numerator());
        let below = first.denominator().clone();
        let Some(factor) = above.and_then(|above| Fraction::new(above, below)) else {
            return false;
        };
        let entries = written.iter().zip(whole.iter());
        let mut apart = entries.map(|(entry, of)| entry.clone() - factor.clone() * of.clone());
        let name = &self.theory.atoms.info(along).latex;
        let letter = Letter::plain(name.trim_start_matches('\\'));
        let used = self.reading.usage.get(&letter);
        let unit = used.hatted + used.hats > 0 || called_unit(self.document, &letter);
        apart.all(|rest| rest.is_zero()) && self.is_strength(&factor, unit)
    }

    /// Whether a factor is 3μ/R³ or 3n², over R² for a vector of length R.
    fn is_strength(&self, factor: &Fraction, unit: bool) -> bool {
        let (above, below) = (factor.numerator(), factor.denominator());
        let three = above.len() == 1 && above.leading_coefficient() == 3.into() && below.len() == 1;
        let number = |v: &u32| matches!(*self.theory.atoms.atom(*v), Atom::Part { entity, order: 0, .. } if self.theory.atoms.info(entity).shape == Shape::Scalar);
        let numbers = factor.variables().iter().all(number);
        let powers =
            |p: &Polynomial| -> u32 { p.variables().into_iter().map(|v| p.degree_in(v)).sum() };
        let length = if unit { 0 } else { 2 };
        let fits = match (powers(above), powers(below)) {
            (1, k) => k == 3 + length,
            (2, k) => k == length,
            _ => false,
        };
        three && numbers && fits
    }
}
