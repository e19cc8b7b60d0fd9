//! Powers of variables of which the square is told.

use crate::algebra::{Polynomial, Variable};
use num_traits::Zero;

/// The polynomial with the last of its squares that are known put in; `None` where it has none.
pub(crate) fn with_one_square<'s>(
    of: &Polynomial,
    square_of: impl Fn(Variable) -> Option<&'s Polynomial>,
) -> Option<Polynomial> {
    let told = of.variables().into_iter().rev();
    let mut told = told.filter_map(|v| Some((v, square_of(v)?)));
    let (variable, square) = told.find(|(v, _)| of.degree_in(*v) > 1)?;
    Some(lowered(of, variable, square))
}

/// The polynomial with the square of a variable put in wherever it stands.
pub(crate) fn lowered(of: &Polynomial, variable: Variable, square: &Polynomial) -> Polynomial {
    let mut sum = Polynomial::zero();
    for power in 0..=of.degree_in(variable) {
        let mut term = of.coefficient_of(variable, power);
        if term.is_zero() {
            continue;
        }
        if power % 2 == 1 {
            term *= Polynomial::variable(variable);
        }
        sum += term * square.pow(power / 2);
    }
    sum
}
