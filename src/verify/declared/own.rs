//! Variables of the model in the letters by which the author declares them.

use crate::algebra::{Fraction, Letter, Polynomial, Printer, Style, Variable};
use crate::notation::document::{Document, Row};
use crate::notation::reread;
use crate::verify::model::atoms::{Atoms, dotted};
use crate::verify::reading::Reading;
use crate::verify::reading::builder::place_in;
use crate::verify::term::letters::{At, Meaning, Reach};
use crate::verify::term::lower::Lowering;
use crate::verify::term::value::Value;
use std::collections::{BTreeMap, BTreeSet, HashMap};

/// The letters that stand for a variable each, and where.
#[derive(Debug, Default)]
pub(super) struct OwnLetters {
    of: BTreeMap<Variable, Vec<(String, Reach)>>,
    /// Entries of tensors that are written as products of inertia, with the other sign.
    opposite: BTreeSet<Variable>,
}

impl OwnLetters {
    /// Those of a document, by what is declared of it.
    pub(super) fn of(document: &Document, reading: &mut Reading) -> Self {
        let mut own = Self::default();
        let (letters, shapes) = (reading.letters.clone(), HashMap::new());
        for letter in &letters.letters {
            if !matches!(letter.meaning, Meaning::Quantity(_)) {
                continue;
            }
            let rows = reread(document, &letter.latex);
            let [Row::Expression(node)] = rows.as_slice() else {
                continue;
            };
            let at = place_in(&letter.reach);
            let system = &mut reading.system;
            let mut lowering = Lowering::new(system, &letters, &document.source, &at, &shapes);
            let value = lowering.value(node);
            if let Ok(value) = &value
                && letters.customs.integrals
            {
                own.opposite.extend(products_of_inertia(value));
            }
            let entry = value.ok().filter(|value| value.entries.len() == 1);
            if let Some(variable) = entry.and_then(|value| value.entries[0].as_variable()) {
                let known = own.of.entry(variable).or_default();
                known.push((letter.latex.clone(), letter.reach.clone()));
            }
        }
        own
    }

    /// A variable in the letters of a line: in one that stands in it, else in one that is declared there.
    pub(super) fn on_line(
        &self,
        atoms: &Atoms,
        variable: Variable,
        at: &At,
        source: &str,
    ) -> String {
        self.name(atoms, variable, |known| {
            let here = |(_, reach): &&(String, Reach)| reach.covers(at, 1);
            let written = known.iter().filter(here);
            let mut written = written.filter(|(letter, _)| source.contains(letter.as_str()));
            written.next().or_else(|| known.iter().find(here))
        })
    }

    /// A variable in the letter that stands for it in all of the document.
    pub(super) fn anywhere(&self, atoms: &Atoms, variable: Variable) -> String {
        self.name(atoms, variable, |known| {
            known.iter().find(|(_, reach)| *reach == Reach::All)
        })
    }

    fn name<'s>(
        &'s self,
        atoms: &Atoms,
        variable: Variable,
        choose: impl Fn(&'s [(String, Reach)]) -> Option<&'s (String, Reach)>,
    ) -> String {
        let (mut base, mut dots) = (variable, 0usize);
        loop {
            let known = self.of.get(&base).and_then(|known| choose(known));
            match (known, atoms.atom(base).rate_of) {
                (Some((letter, _)), _) if dots == 0 => return letter.clone(),
                (Some((letter, _)), _) => {
                    return dotted(dots, letter).unwrap_or_else(|| atoms.latex(variable));
                }
                (None, Some(of)) => (base, dots) = (of, dots + 1),
                _ => return atoms.latex(variable),
            }
        }
    }

    /// Whether the letter of a variable stands for its opposite: a product of inertia that is an integral.
    pub(super) fn is_opposite(&self, atoms: &Atoms, variable: Variable) -> bool {
        let mut base = variable;
        while let Some(of) = atoms.atom(base).rate_of {
            base = of;
        }
        self.opposite.contains(&base)
    }

    /// A fraction with letters in the place of variables.
    fn in_letters(&self, of: &Fraction, atoms: &Atoms) -> Fraction {
        let written = |polynomial: &Polynomial| {
            let terms = polynomial.terms().iter().map(|(monomial, number)| {
                let powers = monomial.powers().into_iter();
                let turned = powers.filter(|(v, _)| self.is_opposite(atoms, *v));
                match turned.map(|(_, power)| power).sum::<u32>() % 2 {
                    0 => (monomial.clone(), number.clone()),
                    _ => (monomial.clone(), -number.clone()),
                }
            });
            Polynomial::from_terms(terms.collect())
        };
        let turned = Fraction::new(written(of.numerator()), written(of.denominator()));
        turned.unwrap_or_else(|| of.clone())
    }

    /// A fraction in the letters of a line.
    pub(super) fn printed(&self, of: &Fraction, atoms: &Atoms, at: &At, source: &str) -> String {
        let of = &self.in_letters(of, atoms);
        let letters = |variable: Variable| Letter {
            text: self.on_line(atoms, variable, at, source),
            place: atoms.atom(variable).place,
        };
        Printer::new(Style::Latex, &letters).fraction(of)
    }
}

/// The variables off the diagonal of a symmetric tensor.
fn products_of_inertia(value: &Value) -> Vec<Variable> {
    let symmetric = value.is_matrix()
        && value.basis[0] == value.basis[1]
        && value.transposed().entries == value.entries;
    let off_diagonal = value
        .entries
        .iter()
        .enumerate()
        .filter(|(at, _)| at % 4 != 0);
    match symmetric {
        true => off_diagonal
            .filter_map(|(_, entry)| entry.as_variable())
            .collect(),
        false => vec![],
    }
}
