//! Symbols that a line defines by their square: `\nu^2 = mgd/I`.

use crate::algebra::{Fraction, Monomial, Rational};
use crate::notation::ast::{Function, Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::line::Read;
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role};
use num_traits::{ToPrimitive, Zero};

impl Checker<'_> {
    /// One of several symbols of a letter, the ν₁ beside ν₃, whose square a line is the first to speak of.
    pub(crate) fn defines_a_square(
        &mut self,
        sides: &[Node],
        role: Role,
        finding: &mut Finding,
    ) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Power(base, two) = &inner(left).kind else {
            return false;
        };
        let new = self.new_symbol(base).filter(|_| is_two(two));
        let Some((entity, Some(place))) = new else {
            return false;
        };
        let own = matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_));
        let same = self.theory.mentions_part(entity, Some(place));
        let letter = match &inner(base).kind {
            Kind::Symbol(symbol) => Letter::of(symbol),
            _ => return false,
        };
        let beside = self.theory.mentions_entity(entity) || self.reading.periods.contains(&letter);
        if role != Role::Claim
            || !own
            || same
            || !beside
            || self.entities([right]).contains(&entity)
        {
            return false;
        }
        self.is_frequency(left, right, finding) || self.accept_definition(sides, finding)
    }

    /// `\nu^2 = k/m` with a new symbol says that ν is the root.
    pub(crate) fn roots_of_squares(&mut self, read: &Read, residuals: &mut [Fraction]) {
        let [equation] = read.equations.as_slice() else {
            return;
        };
        let sides = equation.left.as_scalar().zip(equation.right.as_scalar());
        let (Some((left, right)), [residual]) = (sides, residuals) else {
            return;
        };
        let variables = left.variables();
        let [variable] = variables.as_slice() else {
            return;
        };
        let square = variable_fraction(*variable) * variable_fraction(*variable);
        let atoms = &self.theory.atoms;
        let own = matches!(atoms.owner(*variable), Some(Owner::Symbol(_)));
        let entity = atoms.entity_of(*variable);
        let rests = entity.is_some_and(|entity| atoms.info(entity).constant);
        // What moves may change its sign, but for the length of its components.
        let new = own && (rests || is_sum_of_squares(right)) && !self.theory.mentions(*variable);
        if new && (left.clone() - square).is_zero() && !right.variables().is_empty() {
            let atoms = &self.theory.atoms;
            let turns = |v: &u32| {
                matches!(
                    atoms.owner(*v),
                    Some(Owner::Quantity(Quantity::AngularVelocity, _))
                )
            };
            if let Some(entity) = entity.filter(|_| right.variables().iter().any(turns)) {
                self.theory.atoms.info_mut(entity).constant = false;
            }
            let right = self.theory.normal(right);
            let root = self.theory.kernel(Function::Sqrt, right);
            *residual = variable_fraction(*variable) - root;
        }
    }
}

/// Whether several squares are added up.
fn is_sum_of_squares(value: &Fraction) -> bool {
    let terms = value.numerator().terms();
    let square = |(monomial, factor): &(Monomial, Rational)| {
        *factor == 1.into() && monomial.factors().all(|(_, power)| power == 2)
    };
    value.is_polynomial() && terms.len() > 1 && terms.iter().all(square)
}

/// Whether an exponent is a 2.
pub(crate) fn is_two(exponent: &Node) -> bool {
    matches!(&exponent.kind, Kind::Number(n) if n.value.is_integer() && n.value.to_i64() == Some(2))
}
