//! Lines that hold on principal axes, where no sentence says that the axes are.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::Source;
use crate::verify::language::heads::PRINCIPAL_AXES;
use crate::verify::model::atoms::{Space, fraction};
use crate::verify::model::system::BodyId;
use crate::verify::standing::hold::Held;
use crate::verify::standing::judge::Judge;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use num_traits::Zero;
use std::collections::{BTreeMap, BTreeSet};

impl Judge<'_> {
    /// The name of a body of whose products of inertia differences speak, where no letter tells of these and the sides are
    /// the same where they vanish.
    pub(super) fn holds_on_principal_axes(
        &mut self,
        held: &Held,
        residuals: &[Fraction],
    ) -> Option<String> {
        let atoms = &self.reading.system.atoms;
        let variables = residuals.iter().flat_map(Fraction::variables);
        let products = variables.filter_map(|v| match atoms.atom(v).key.space {
            Space::UntoldProduct(body) => Some((v, body)),
            _ => None,
        });
        let mut untold: BTreeMap<Variable, BodyId> = products.collect();
        let body = *untold.values().next()?;
        let told = self.told_of_inertia();
        untold.retain(|v, _| !told.contains(v));
        if untold.is_empty() {
            return None;
        }
        let all = self.facts.clone();
        let zeros = untold
            .keys()
            .map(|&v| (fraction(v), Source::Law(PRINCIPAL_AXES)));
        let atoms = &mut self.reading.system.atoms;
        self.facts.extend_all(atoms, zeros.collect());
        let left = self.residuals(&held.sides);
        self.facts = all;
        let same = left.is_ok_and(|left| left.iter().all(Zero::is_zero));
        same.then(|| self.reading.system.bodies[body].name.clone())
    }

    /// What stands in the moments, the products and the tensors of inertia for which there are letters.
    fn told_of_inertia(&mut self) -> BTreeSet<Variable> {
        let letters = self.reading.letters.letters.iter();
        let quantities = letters.filter_map(|letter| match &letter.meaning {
            Meaning::Quantity(quantity) if is_of_inertia(quantity) => Some(quantity.clone()),
            _ => None,
        });
        let quantities: Vec<Quantity> = quantities.collect();
        let system = &mut self.reading.system;
        let values = quantities.iter().filter_map(|q| system.value_of(q).ok());
        let entries = values.flat_map(|value| value.entries);
        entries.flat_map(|entry| entry.variables()).collect()
    }
}

/// Whether a quantity is an inertia tensor or a part of one.
fn is_of_inertia(quantity: &Quantity) -> bool {
    match quantity {
        Quantity::Inertia { .. } => true,
        Quantity::Along { of, .. }
        | Quantity::Part { of, .. }
        | Quantity::Component { of, .. }
        | Quantity::Entry { of, .. }
        | Quantity::On(of, _) => is_of_inertia(of),
        _ => false,
    }
}
