//! Lines that hold on principal axes, where no sentence says that the axes are.

use crate::algebra::{Fraction, Variable};
use crate::verify::model::atoms::Space;
use crate::verify::model::system::BodyId;
use crate::verify::standing::judge::Judge;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use std::collections::{BTreeMap, BTreeSet};

impl Judge<'_> {
    /// The name of a body by whose products of inertia alone differences do not vanish, where no letter tells of these.
    pub(super) fn vanish_on_principal_axes(&mut self, residuals: &[Fraction]) -> Option<String> {
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
        let vanish = residuals.iter().all(|residual| {
            let mut terms = residual.numerator().terms().iter();
            terms.all(|(term, _)| term.factors().any(|(v, _)| untold.contains_key(&v)))
        });
        vanish.then(|| self.reading.system.bodies[body].name.clone())
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
