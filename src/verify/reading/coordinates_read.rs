//! Generalised coordinates, and the mass matrix that belongs to them.

use crate::algebra::{Fraction, Variable};
use crate::verify::language::heads::COORDINATES;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;

/// A mass matrix has no more rows.
const MOST_COORDINATES: usize = 6;

impl Builder<'_> {
    /// "the mass matrix of the arm for the coordinates `$q_1$`, `$q_2$`": M_jk = ∂²T/∂q̇_j ∂q̇_k.
    pub(super) fn mass_matrix(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let kinetic = Quantity::KineticEnergy {
            of: self.whole_of(phrase)?,
            relative: self.reading.system.ground,
            rotation: false,
        };
        let rates = self.rates_of_coordinates(phrase, declaration)?;
        let kinetic = self.system().value_of(&kinetic).ok()?.to_scalar().ok()?;
        let kinetic = self.system().expanded(&kinetic, &rates);
        let mut entries: Vec<Fraction> = vec![];
        for &row in &rates {
            let momentum = self.system().partial(&kinetic, row);
            for &column in &rates {
                entries.push(self.system().partial(&momentum, column));
            }
        }
        let size = rates.len();
        Some(Quantity::Known(Value::written(size, size, entries)))
    }

    /// The rates of the coordinates that a phrase names, or that a sentence says to be those of the system.
    fn rates_of_coordinates(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Vec<Variable>> {
        let named: Vec<_> = phrase.all(Slot::In).cloned().collect();
        let named: Vec<Formula> = formulas(&named).cloned().collect();
        let letters = match named.is_empty() {
            true => self.coordinates_said(),
            false => named,
        };
        let fits = (1..=MOST_COORDINATES).contains(&letters.len());
        let mut rates = vec![];
        for letter in letters.iter().filter(|_| fits) {
            let coordinate = self.scalar(letter, declaration)?.as_variable()?;
            rates.push(self.system().atoms.rate(coordinate).as_variable()?);
        }
        (!rates.is_empty()).then_some(rates)
    }

    fn coordinates_said(&self) -> Vec<Formula> {
        let said = self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Is { subjects, what } => (what.head == COORDINATES).then_some(subjects),
            _ => None,
        });
        said.flat_map(|subjects| formulas(subjects))
            .cloned()
            .collect()
    }
}
