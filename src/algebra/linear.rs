//! Equations that are linear in their unknowns, solved without fractions.

use crate::algebra::{Polynomial, Variable};
use num_traits::{One, Zero};
use std::fmt;

/// The unknowns as fractions with one common denominator: unknownᵢ = numeratorᵢ / determinant.
#[derive(Clone, Debug, PartialEq, Eq)]
pub struct LinearSolution {
    /// One numerator for each unknown, in their order.
    pub numerators: Vec<Polynomial>,
    /// The determinant of the system, up to sign; not zero as a polynomial.
    pub determinant: Polynomial,
}

/// Why a system has no solution of that form.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum LinearError {
    /// There are not as many equations as unknowns.
    NotSquare,
    /// An unknown stands in a power or in a product with another.
    NotLinear,
    /// The determinant is zero: the equations fix no single solution.
    Singular,
    /// A product would have had more terms than allowed.
    OutOfBudget,
}

impl fmt::Display for LinearError {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str(match self {
            Self::NotSquare => "there are not as many equations as unknowns",
            Self::NotLinear => "the equations are not linear in the unknowns",
            Self::Singular => "the equations do not fix the unknowns",
            Self::OutOfBudget => "the solution has too many terms",
        })
    }
}

impl std::error::Error for LinearError {}

/// Solves `equations`, each of which is zero, for `unknowns`, with no product of more than `terms` terms.
///
/// Fraction-free elimination after Bareiss (1968): each division is by the pivot before and leaves nothing.
///
/// # Errors
/// As [`LinearError`] says.
///
/// ```
/// use polhode::algebra::{Polynomial, solve_linear};
/// let [a, b, x, y] = [0, 1, 2, 3].map(Polynomial::variable);
/// // a x = y and x + y = b give x = b / (a + 1).
/// let equations = [a.clone() * x.clone() - y.clone(), x + y - b];
/// let solution = solve_linear(&equations, &[2, 3], 100)?;
/// let [x, y] = solution.numerators.as_slice() else { panic!("two unknowns") };
/// assert_eq!(y.clone(), a * x.clone());
/// # Ok::<(), polhode::algebra::LinearError>(())
/// ```
pub fn solve_linear(
    equations: &[Polynomial],
    unknowns: &[Variable],
    terms: usize,
) -> Result<LinearSolution, LinearError> {
    if equations.len() != unknowns.len() || unknowns.is_empty() {
        return Err(LinearError::NotSquare);
    }
    let mut rows: Vec<Vec<Polynomial>> = equations
        .iter()
        .map(|e| row(e, unknowns))
        .collect::<Result<_, _>>()?;
    let mut before = Polynomial::one();
    for column in 0..unknowns.len() {
        // The shortest pivot keeps the products short.
        let candidates = (column..rows.len()).filter(|&i| !rows[i][column].is_zero());
        let pivot = candidates
            .min_by_key(|&i| rows[i][column].len())
            .ok_or(LinearError::Singular)?;
        rows.swap(column, pivot);
        eliminate(&mut rows, column, &before, terms)?;
        before = rows[column][column].clone();
    }
    let numerators = rows.iter_mut().filter_map(Vec::pop).collect();
    Ok(LinearSolution {
        numerators,
        determinant: before,
    })
}

/// The coefficients of the unknowns, and behind them the right side.
fn row(equation: &Polynomial, unknowns: &[Variable]) -> Result<Vec<Polynomial>, LinearError> {
    let free = |p: &Polynomial| unknowns.iter().all(|&u| p.degree_in(u) == 0);
    let mut row = Vec::with_capacity(unknowns.len() + 1);
    let mut rest = equation.clone();
    for &unknown in unknowns {
        let coefficient = equation.coefficient_of(unknown, 1);
        if equation.degree_in(unknown) > 1 || !free(&coefficient) {
            return Err(LinearError::NotLinear);
        }
        rest = rest.coefficient_of(unknown, 0);
        row.push(coefficient);
    }
    row.push(-rest);
    Ok(row)
}

/// Clears a column in every row but its own; the rows done before get the new pivot on their diagonal.
fn eliminate(
    rows: &mut [Vec<Polynomial>],
    column: usize,
    before: &Polynomial,
    terms: usize,
) -> Result<(), LinearError> {
    let pivot_row = rows[column].clone();
    let pivot = &pivot_row[column];
    let product =
        |a: &Polynomial, b: &Polynomial| a.product_within(b, terms).ok_or(LinearError::OutOfBudget);
    for (index, row) in rows.iter_mut().enumerate() {
        if index == column {
            continue;
        }
        let factor = row[column].clone();
        for (entry, above) in row.iter_mut().zip(&pivot_row) {
            let difference = product(pivot, entry)? - product(&factor, above)?;
            *entry = difference
                .exact_quotient(before)
                .ok_or(LinearError::Singular)?;
        }
    }
    Ok(())
}
