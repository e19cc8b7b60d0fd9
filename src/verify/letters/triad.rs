//! Two triads in one document: the body turns on x, y, z first, and on 1, 2, 3 further on.

use crate::algebra::Fraction;
use crate::notation::ast::{Node, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, axis, symbols};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use std::collections::BTreeSet;

/// How components are named.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
pub(crate) enum Triad {
    /// By x, y, z.
    Lettered,
    /// By 1, 2, 3.
    Numbered,
}

impl Triad {
    fn of(index: &str) -> Option<Self> {
        axis(index)?;
        let numbered = index.starts_with(|c: char| c.is_ascii_digit());
        Some(if numbered {
            Self::Numbered
        } else {
            Self::Lettered
        })
    }
}

impl Checker<'_> {
    /// Where the angular velocity goes over from ω_x, ω_y to ω_1, ω_2, other axes are meant, and what was assumed of
    /// its components does not hold on them.
    pub(crate) fn note_triad(&mut self, sides: &[Node]) {
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let mut met = BTreeSet::new();
        for symbol in sides.iter().flat_map(symbols) {
            let own = matches!(self.meaning_of(symbol), Meaning::Component(e, _) if e == omega);
            if own && self.has_two_triads(symbol) {
                met.extend(symbol.subscripts.iter().filter_map(|s| Triad::of(s)));
            }
        }
        let (Some(&now), 1) = (met.first(), met.len()) else {
            return;
        };
        if self.triad.replace(now).is_none_or(|before| before == now) {
            return;
        }
        let atoms = &self.theory.atoms;
        let turns = |residual: &Fraction| {
            let mut variables = residual.variables().into_iter();
            variables.any(|v| atoms.entity_of(v) == Some(omega))
        };
        let premises = self.theory.premises().iter();
        let ended: BTreeSet<_> = premises
            .filter(|premise| premise.residuals.iter().any(turns))
            .map(|premise| premise.name.clone())
            .collect();
        self.end_premises(&ended);
    }

    /// Whether a letter has components of both names, two of each at the least.
    fn has_two_triads(&self, symbol: &Symbol) -> bool {
        let met = self.reading.usage.subscripts.get(&Letter::of(symbol));
        let several = |triad| {
            let named = |all: &BTreeSet<String>| {
                all.iter().filter(|s| Triad::of(s) == Some(triad)).count() > 1
            };
            met.is_some_and(named)
        };
        several(Triad::Lettered) && several(Triad::Numbered)
    }
}
