//! Coordinates of points of which no sentence tells where they lie.

use crate::algebra::{Fraction, Place, Polynomial, Variable};
use crate::verify::model::atoms::Atoms;
use std::collections::BTreeSet;

/// Coordinates of which more is known than what they are of.
#[derive(Clone, Debug, Default)]
pub(super) struct Coordinates {
    /// Those of unplaced points that an equation ties to other variables.
    pub(super) tied: BTreeSet<Variable>,
    /// Those of all unplaced points, even where a letter tells the point.
    pub(super) loose: BTreeSet<Variable>,
    /// Those that are zero in a blow.
    pub(super) none_at_blow: BTreeSet<Variable>,
}

impl Atoms {
    /// Says that these are coordinates of a point of which no sentence tells where it lies.
    pub(crate) fn set_unplaced(&mut self, coordinates: impl IntoIterator<Item = Variable>) {
        self.changes.note_all();
        for coordinate in coordinates {
            self.unplaced.insert(coordinate);
            self.coordinates.loose.insert(coordinate);
        }
    }

    /// An equation ties the coordinates that stand in it to its other variables; one of motion does not.
    pub(crate) fn tie(&mut self, equation: &Fraction) {
        let variables = equation.variables();
        let driven = |v: &Variable| self.atom(*v).place == Place::Acceleration;
        let tied = variables
            .iter()
            .filter(|v| self.coordinates.loose.contains(v));
        let tied: Vec<Variable> = tied.copied().collect();
        if tied.is_empty() || tied.len() == variables.len() || variables.iter().any(driven) {
            return;
        }
        self.changes.note_all();
        self.coordinates.tied.extend(tied);
    }

    /// Whether a variable is a coordinate that is tied so, or one of a point that no sentence places, or a rate of one.
    pub(crate) fn is_hidden(&self, variable: Variable) -> bool {
        let mut all = std::iter::once(variable).chain(self.antiderivatives(variable));
        all.any(|v| self.unplaced.contains(&v) || self.coordinates.tied.contains(&v))
    }

    /// A letter tells where the point lies.
    pub(crate) fn set_placed(&mut self, coordinates: impl IntoIterator<Item = Variable>) {
        self.changes.note_all();
        for coordinate in coordinates {
            self.unplaced.remove(&coordinate);
        }
    }

    /// Whether of some point no sentence tells where it lies.
    pub(crate) fn has_unplaced(&self) -> bool {
        !self.unplaced.is_empty()
    }

    /// Whether a variable is such a coordinate.
    pub(crate) fn is_unplaced(&self, variable: Variable) -> bool {
        self.unplaced.contains(&variable)
    }

    /// Whether something may vanish where points happen to lie of which no sentence tells it: a sum of squares does not.
    pub(crate) fn hangs_on_places(&self, of: &Polynomial) -> bool {
        if self.unplaced.is_empty() {
            return false;
        }
        let hidden = of
            .variables()
            .into_iter()
            .any(|v| self.unplaced.contains(&v));
        hidden && !self.is_sum_of_squares(of)
    }

    /// Whether all terms have one sign, and odd powers have only what is positive.
    fn is_sum_of_squares(&self, of: &Polynomial) -> bool {
        let mut signs = of.terms().iter().map(|(_, c)| c.is_negative());
        let first = signs.next();
        let mut powers = of
            .terms()
            .iter()
            .flat_map(|(monomial, _)| monomial.factors());
        signs.all(|sign| Some(sign) == first)
            && powers.all(|(v, power)| power % 2 == 0 || self.atom(v).positive)
    }
}
