//! Premises that are not in force: products of which nothing says which factor vanishes, and those that grew too large.

use crate::algebra::{Fraction, Polynomial};
use crate::verify::facts::Source;
use crate::verify::facts::premises::{Extended, Facts};
use crate::verify::model::atoms::Atoms;
use num_traits::Zero;

/// More cases are not looked at.
const MOST_CASES: usize = 16;

/// More products are not taken apart.
const MOST_PRODUCTS: usize = 4;

/// What is not in force though it should be.
#[derive(Clone, Debug, Default)]
pub(super) struct Missing {
    /// Who said it first.
    first: Option<Source>,
    /// Equations that could not be solved for one variable.
    unsolved: Vec<(Fraction, Source)>,
    /// Whether something else is not in force.
    more: bool,
}

impl Facts {
    /// The premise that is not in force though it should be.
    pub(crate) fn missing(&self) -> Option<&Source> {
        self.missing.first.as_ref()
    }

    pub(crate) fn miss(&mut self, source: &Source) {
        self.missing.more = true;
        self.missing.first.get_or_insert_with(|| source.clone());
    }

    /// Keeps out an equation that could not be solved for one variable.
    pub(crate) fn leave(&mut self, equation: &Fraction, source: &Source) {
        let waiting = (equation.clone(), source.clone());
        self.missing.unsolved.push(waiting);
        self.missing.first.get_or_insert_with(|| source.clone());
    }

    /// What holds in each case that the products leave which are not in force; `None` where these cases are not all.
    pub(crate) fn cases(&self, atoms: &mut Atoms) -> Option<Vec<Self>> {
        let Missing { unsolved, more, .. } = &self.missing;
        if *more || unsolved.len() > MOST_PRODUCTS {
            return None;
        }
        let mut whole = self.clone();
        whole.missing = Missing::default();
        let mut cases = vec![whole];
        for (equation, source) in unsolved {
            let mut next = vec![];
            for case in cases {
                next.extend(case.apart(atoms, equation, source)?);
            }
            cases = next;
            if cases.len() > MOST_CASES {
                return None;
            }
        }
        Some(cases)
    }

    /// The cases of one product: each of its factors may vanish that is not positive by what it is.
    fn apart(
        mut self,
        atoms: &mut Atoms,
        equation: &Fraction,
        source: &Source,
    ) -> Option<Vec<Self>> {
        let normal = self.normal(atoms, equation).ok()?;
        let product = normal.numerator();
        if product.is_zero() {
            return Some(vec![self]);
        }
        let common = product.common_monomial();
        let rest = product.divided_by(&common);
        let variables = common.factors().map(|(v, _)| Polynomial::variable(v));
        let factors = variables.chain(std::iter::once(rest));
        let may_vanish = |factor: &Polynomial| !atoms.has_sign(factor);
        let factors: Vec<_> = factors.filter(may_vanish).collect();
        let mut cases = vec![];
        for factor in factors {
            let mut case = self.clone();
            match case.extend(atoms, &Fraction::from(factor), source) {
                Ok(Extended::Contradicts) => {}
                // What could not be solved for one variable either is in force in no case.
                Ok(Extended::Unsolved) => return None,
                Ok(_) if case.missing().is_none() => cases.push(case),
                Ok(_) | Err(_) => return None,
            }
        }
        Some(cases)
    }
}
