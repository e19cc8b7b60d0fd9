//! Symbols that words have named and that a failing line is the first to say something of: `(N - m g) b = M` says how
//! large N is, and with another value of it the sides would be equal.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::Line;
use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::lines::oscillation::is_rate_of_rate;
use crate::verify::names;
use crate::verify::reason::names_unsaid;
use crate::verify::values::atoms::{Atom, Entity, Owner};
use crate::verify::values::quantity::Shape;
use crate::verify::verdict::Finding;
use num_traits::Zero;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// The one symbol of the document in a difference that no line before has, where it stands on one side alone and
    /// other symbols are known: the line may be what gives it its value.
    pub(crate) fn first_said(&mut self, read: &Read) -> Option<String> {
        // A vector that may be any gets no value by a line.
        if self.any_vector {
            return None;
        }
        let failing = read.equations.iter().find(|equation| {
            let mut entries = equation.residual.entries.iter();
            entries.any(|entry| !self.theory.normal(entry).is_zero())
        })?;
        let failing = failing.clone();
        let on = |entries: &[Fraction]| -> BTreeSet<Variable> {
            entries.iter().flat_map(Fraction::variables).collect()
        };
        let [left, right] = [&failing.left, &failing.right].map(|side| on(&side.entries));
        failing.residual.entries.iter().find_map(|entry| {
            let rest = self.theory.normal(entry);
            let (new, met): (Vec<Variable>, Vec<Variable>) = rest
                .variables()
                .into_iter()
                .partition(|&v| self.is_unmentioned(v));
            let [variable] = new.as_slice() else {
                return None;
            };
            let one_sided = left.contains(variable) != right.contains(variable);
            let rest = rest.numerator();
            let solved =
                rest.degree_in(*variable) > 0 && !rest.coefficient_of(*variable, 0).is_zero();
            (one_sided && solved && !met.is_empty())
                .then(|| names::latex(&self.theory.atoms, *variable))
        })
    }

    /// Whether a line was left open as nothing says what one number in it is, and relates that to others, which it leaves
    /// as they are: the `\omega_c` of `C^2\omega_c^2 = 4 A m g l`.
    pub(crate) fn only_says_of_new(&mut self, line: &Line, finding: &Finding) -> bool {
        let [left, right] = line.sides.as_slice() else {
            return false;
        };
        // An equation of motion says as much of how the rest moves.
        let moves = line.sides.iter().any(is_rate_of_rate);
        if moves || !finding.reason.as_deref().is_some_and(names_unsaid) {
            return false;
        }
        let [left, right] = [left, right].map(|side| self.entities([side]));
        let new = |entities: &[Entity]| -> BTreeSet<Entity> {
            let mut new: BTreeSet<Entity> = entities.iter().copied().collect();
            new.retain(|&entity| !self.theory.mentions_entity(entity));
            new
        };
        let (new_left, new_right) = (new(&left), new(&right));
        let mut new = new_left.iter().chain(&new_right);
        let (Some(&one), None) = (new.next(), new.next()) else {
            return false;
        };
        let letter = |entity: Entity| {
            let latex = &self.theory.atoms.info(entity).latex;
            latex
                .split(['_', '^'])
                .next()
                .unwrap_or_default()
                .to_owned()
        };
        let mut all = left.iter().chain(&right);
        all.all(|&entity| {
            let scalar = self.theory.atoms.info(entity).shape != Shape::Vector;
            scalar && (entity == one || letter(entity) != letter(one))
        })
    }

    /// Whether a variable is a number of the document that no accepted line has.
    fn is_unmentioned(&self, variable: Variable) -> bool {
        let Atom::Part {
            entity, order: 0, ..
        } = *self.theory.atoms.atom(variable)
        else {
            return false;
        };
        matches!(self.theory.atoms.info(entity).owner, Owner::Symbol(_))
            && !self.theory.mentions_entity(entity)
    }
}
