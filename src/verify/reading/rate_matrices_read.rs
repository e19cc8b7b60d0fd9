//! Matrices that take the rates of angles to the components of a vector.

use crate::algebra::Fraction;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::{Basis, Value};
use num_traits::Zero;

impl Builder<'_> {
    /// "the Jacobian of the components of `$\\omega$` on B in the rates of `$\\phi$`, `$\\theta$`, `$\\psi$`", of a vector that
    /// the rates make up alone.
    pub(super) fn rate_matrix(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let of: Vec<&Term> = phrase.all(Slot::Of).collect();
        let (mut rest, rows) = match of.as_slice() {
            [of] => self.components_of(of, declaration)?,
            [one, two, three] => {
                let mut entry = |of: &Term| {
                    let entry = self.operand(of, declaration)?;
                    self.system().value_of(&entry).ok()?.to_scalar().ok()
                };
                let entries = [entry(one)?, entry(two)?, entry(three)?];
                (entries, Basis::Written)
            }
            _ => return None,
        };
        let mut columns = vec![];
        for letter in rates_in(phrase)?.all(Slot::Of) {
            let letter = self.scalar_term(letter, declaration)?;
            let system = self.system();
            let rate = system.atoms.derivative(&letter);
            let variable = rate.as_variable()?;
            let column = rest.clone().map(|entry| system.partial(&entry, variable));
            for (entry, slope) in rest.iter_mut().zip(&column) {
                *entry -= slope.clone() * rate.clone();
            }
            columns.push(column);
        }
        if !rest.iter().all(Fraction::is_zero) {
            return None;
        }
        let entries = (0..rest.len()).flat_map(|row| columns.iter().map(move |c| c[row].clone()));
        Some(Quantity::Known(Value {
            rows: rest.len(),
            columns: columns.len(),
            entries: entries.collect(),
            basis: [rows, Basis::Written],
        }))
    }

    /// "the components of `$\\omega$` on B", or a letter that has its components on axes already.
    fn components_of(
        &mut self,
        term: &Term,
        declaration: &Declaration,
    ) -> Option<([Fraction; 3], Basis)> {
        let (vector, frame) = match term {
            Term::Phrase(phrase) if phrase.head == "component" => {
                let frame = self.frame(phrase.slot(Slot::On)?)?;
                (phrase.slot(Slot::Of)?, Some(frame))
            }
            letter => (letter, None),
        };
        let value = self.operand(vector, declaration)?;
        let value = self.system().value_of(&value).ok()?;
        let on = match value.vector_basis() {
            Basis::On(frame) => Some(frame),
            _ => None,
        };
        let frame = frame.or(on)?;
        let vector = value.to_vector().ok()?;
        let entries = match on == Some(frame) {
            true => [0, 1, 2].map(|axis| value.entries[axis].clone()),
            false if on.is_none() => {
                [0, 1, 2].map(|axis| self.system().axis(frame, axis).dot(&vector))
            }
            false => return None,
        };
        Some((entries, Basis::On(frame)))
    }
}

/// "the rates of `$a$` and `$b$`", in which a Jacobian is.
pub(super) fn rates_in(jacobian: &NounPhrase) -> Option<&NounPhrase> {
    match jacobian.slot(Slot::In) {
        Some(Term::Phrase(rates)) if rates.head == "rate" => Some(rates),
        _ => None,
    }
}
