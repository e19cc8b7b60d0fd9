//! Symbols that words have named and that a failing line is the first to say something of: `(N - m g) b = M` says how
//! large N is, and with another value of it the sides would be equal.

use crate::algebra::{Fraction, Variable};
use crate::verify::check::Checker;
use crate::verify::lines::line::Read;
use crate::verify::names;
use crate::verify::values::atoms::{Atom, Owner};
use num_traits::Zero;
use std::collections::BTreeSet;

impl Checker<'_> {
    /// The one symbol of the document in a difference that no line before has, where it stands on one side alone and
    /// other symbols are known: the line may be what gives it its value.
    pub(crate) fn first_said(&mut self, read: &Read) -> Option<String> {
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
