//! The moment that the gradient of gravity exerts on a body in orbit, 3μ/R⁵ R×(I R) with R from the centre of the planet
//! (Hughes, Spacecraft Attitude Dynamics, section 8.1): 3n² u×(I u) with a unit vector u and the orbital rate n.

use crate::algebra::Fraction;
use crate::verify::check::Checker;
use crate::verify::letters::usage::Letter;
use crate::verify::lines::line::Read;
use crate::verify::theory::law::inertia;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Shape;
use nalgebra::Vector3;
use num_traits::Zero;

impl Checker<'_> {
    /// Whether the right side of an equation is this moment for a vector of the document.
    pub(crate) fn is_gravity_gradient(&mut self, read: &Read) -> bool {
        let text = self.text.lower();
        if !text.contains("gravity") && !text.contains("gravitational") {
            return false;
        }
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let written = equation.right.entries.clone();
        let vectors: Vec<Entity> = written
            .iter()
            .flat_map(Fraction::variables)
            .filter_map(|v| self.theory.atoms.entity_of(v))
            .filter(|&e| {
                let info = self.theory.atoms.info(e);
                matches!(info.owner, Owner::Symbol(_)) && info.shape == Shape::Vector
            })
            .collect();
        vectors
            .first()
            .is_some_and(|&u| self.is_moment_along(&written, u))
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
        let used = self
            .reading
            .usage
            .get(&Letter::plain(name.trim_start_matches('\\')));
        let unit = used.hatted + used.hats > 0;
        apart.all(|rest| rest.is_zero()) && self.is_strength(&factor, unit)
    }

    /// Whether a factor is 3μ/R³ or 3n², over R² for a vector of length R.
    fn is_strength(&self, factor: &Fraction, unit: bool) -> bool {
        let (above, below) = (factor.numerator(), factor.denominator());
        let three = above.len() == 1 && above.leading_coefficient() == 3.into() && below.len() == 1;
        let number = |v: &u32| matches!(*self.theory.atoms.atom(*v), Atom::Part { entity, order: 0, .. } if self.theory.atoms.info(entity).shape == Shape::Scalar);
        let numbers = factor.variables().iter().all(number);
        let powers = |p: &crate::algebra::Polynomial| -> u32 {
            p.variables().into_iter().map(|v| p.degree_in(v)).sum()
        };
        let length = if unit { 0 } else { 2 };
        let fits = match (powers(above), powers(below)) {
            (1, k) => k == 3 + length,
            (2, k) => k == length,
            _ => false,
        };
        three && numbers && fits
    }
}
