//! Columns and rows of entries, and those of the identity matrix.

use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;
use crate::notation::{Macros, read_formula};
use crate::verify::language::heads::IDENTITY_MATRIX;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Term};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::names::{node_of, written};
use crate::verify::reading::relations_read::{labelled_entry, told_entries};
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;

impl Builder<'_> {
    /// "`\theta` is the column of `\phi`, `\theta` and `\psi`."
    pub(super) fn read_column(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) {
        let mut of_matrix = || self.read_columns_of_matrix(subjects, what, declaration);
        if what.head == "column" && column_of_identity(what).is_none() && of_matrix().is_some() {
            return;
        }
        // "the column `$a$`", and not "the column `$i$` of `$Q$`"
        if let (Some(Term::Formula(column)), [Term::Formula(letter)], None) =
            (what.slot(Slot::Which), subjects, what.slot(Slot::Of))
            && let Some(node) = node_of(column)
        {
            let same = Meaning::Same(Box::new(node.clone()));
            return self.denote(letter, same, declaration);
        }
        let entries = what.all(Slot::Of).map(|term| match term {
            Term::Formula(formula) => node_of(formula).cloned(),
            Term::Numbers(numbers) => match numbers[..] {
                [number] => number_node(number),
                _ => None,
            },
            _ => None,
        });
        let entries = entries.collect::<Option<Vec<_>>>();
        let entries = column_of_identity(what).or(entries);
        // The rows of a matrix are no row of matrices.
        let Some(entries) = entries.filter(|entries| entries.len() > 1) else {
            return self.say_unused(declaration);
        };
        for formula in formulas(subjects) {
            let column = Node {
                kind: match what.head {
                    "row" => Kind::Matrix(vec![entries.clone()]),
                    _ => Kind::Tuple(entries.clone()),
                },
                span: crate::source::Span::default(),
            };
            self.denote(formula, Meaning::Same(Box::new(column)), declaration);
        }
    }
}

impl Builder<'_> {
    /// "`$v$` has the entries `$a$`, `$b$`, `$c$`", where sentences tell what these are, and of the column only this.
    fn is_column_by_entries(
        &mut self,
        entries: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> bool {
        let Some(Term::Formula(column)) = what.slot(Slot::Of) else {
            return false;
        };
        let mut told = |letter: &Formula| {
            self.quantity_of(letter, declaration).is_some() || self.is_told(letter, declaration)
        };
        let alone = what.slots.len() == 1 && entries.len() > 1 && !told(column);
        let all = formulas(entries).count() == entries.len() && formulas(entries).all(&mut told);
        alone && all && !self.is_subject(column)
    }

    /// Entries by their letters, or what a column is by its entries.
    pub(super) fn read_entries_or_column(
        &mut self,
        entries: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        match self.read_column_by_entries(entries, what, declaration) {
            true => Some(()),
            false => self.read_entries(entries, what, declaration),
        }
    }

    /// The letters with labels are what they were, and no components of the column.
    fn read_column_by_entries(
        &mut self,
        entries: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> bool {
        let Some(column) = what.slot(Slot::Of).cloned() else {
            return false;
        };
        if !self.is_column_by_entries(entries, what, declaration) {
            return false;
        }
        for entry in formulas(entries) {
            if self.quantity_of(entry, declaration).is_none()
                && let Some(value) = self.mentioned_value(entry, declaration)
            {
                let known = Meaning::Quantity(Quantity::Known(value));
                self.denote(entry, known, declaration);
            }
        }
        let of = entries.iter().map(|entry| (Slot::Of, entry.clone()));
        let what = NounPhrase::new("column", of.collect());
        self.read_column(&[column], &what, declaration);
        true
    }
}

impl Builder<'_> {
    /// "`A_{ij}` is entry (i, j) of `A`", where no sentence says what `A` is: the letters are the entries of what the
    /// document's lines make of it.
    pub(super) fn read_entries_of_untold_matrix(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> bool {
        let Some(Term::Formula(matrix)) = what.slot(Slot::Of) else {
            return false;
        };
        let by_number = what.slot(Slot::Which).is_some();
        if !by_number || self.is_told(matrix, declaration) {
            return false;
        }
        let numbered = told_entries(what);
        let of_one = |(place, formula): (usize, &Formula)| {
            let all = self.letters_of_entries(formula);
            let told = numbered.get(place).copied();
            let entry = told.or_else(|| labelled_entry(formula));
            let single = entry.map(|entry| (formula.clone(), entry));
            if all.is_empty() {
                single.into_iter().collect()
            } else {
                all
            }
        };
        let letters: Vec<Vec<_>> = formulas(subjects).enumerate().map(of_one).collect();
        if letters.iter().any(Vec::is_empty) {
            return false;
        }
        for (letter, [row, column]) in letters.concat() {
            let source = format!("({})_{{{}{}}}", matrix.source, row + 1, column + 1);
            if let Some(entry) = written(&source).as_ref().and_then(node_of) {
                self.denote(&letter, Meaning::Same(Box::new(entry.clone())), declaration);
            }
        }
        true
    }
}

/// "the third column of the identity matrix": its entries.
fn column_of_identity(what: &NounPhrase) -> Option<Vec<Node>> {
    let (Some(Term::Phrase(of)), Some(Term::Numbers(which))) =
        (what.slot(Slot::Of), what.slot(Slot::Which))
    else {
        return None;
    };
    let [which @ 1..=3] = which.as_slice() else {
        return None;
    };
    let entries = (1..=3).map(|own| number_node(usize::from(own == *which)));
    entries
        .collect::<Option<_>>()
        .filter(|_| of.head == IDENTITY_MATRIX)
}

/// A whole number as it stands in a formula.
fn number_node(number: usize) -> Option<Node> {
    match read_formula(&number.to_string(), 0, &Macros::default()).pop()? {
        Row::Expression(node) => Some(node),
        _ => None,
    }
}
