//! Formulas of sentences that say what a new letter is: "`$v = a i + b j$`".

use crate::notation::ast::{Kind, Line, Node, Relation};
use crate::notation::document::Row;
use crate::verify::language::statement::{
    Declaration, DeclaredRole, Extent, Formula, Statement, Term,
};
use crate::verify::reading::builder::{Builder, place_in};
use crate::verify::reading::names::{is_marked_vector, node_of, reach_of};
use crate::verify::reading::reactions_read::same_letter;
use crate::verify::term::letters::{Letter, Meaning, spelled};
use crate::verify::term::quantity::Quantity;

/// The letter that a formula may define, and what it may be.
pub(crate) fn definition_in(formula: &Formula) -> Option<(&Node, &Node)> {
    let (left, right) = equal_sides(formula)?;
    let new = matches!(left.kind, Kind::Symbol(_)) && !stands_in(right, &spelled(left));
    new.then_some((left, right))
}

/// The sides of an equation.
fn equal_sides(formula: &Formula) -> Option<(&Node, &Node)> {
    let Row::Line(Line {
        sides, relations, ..
    }) = &formula.row
    else {
        return None;
    };
    match (sides.as_slice(), relations.as_slice()) {
        ([left, right], [(Relation::Equal | Relation::Defined, _)]) => Some((left, right)),
        _ => None,
    }
}

/// What a statement sets a letter to by a formula.
pub(super) fn defined_as(letter: &Formula, statement: &Statement) -> Option<Formula> {
    match statement {
        Statement::Holds(formula) => {
            let (left, right) = definition_in(formula)?;
            same_letter(&Formula::of(left), letter).then(|| Formula::of(right))
        }
        // "`$n$` is `$a+b$`"
        Statement::Same { subjects, others } => {
            let mut pairs = subjects.iter().zip(others);
            let (_, other) = pairs.find(|(own, _)| is_written_as(own, letter))?;
            match other {
                Term::Formula(formula) => Some(formula.clone()),
                _ => None,
            }
        }
        _ => None,
    }
}

/// Whether a term is a letter, by its writing.
pub(super) fn is_written_as(term: &Term, letter: &Formula) -> bool {
    matches!(term, Term::Formula(own) if same_letter(own, letter))
}

/// Whether a sentence says in words what a letter is.
pub(crate) fn is_subject(declarations: &[Declaration], letter: &Formula) -> bool {
    let own = |term: &Term| is_written_as(term, letter);
    let mut all = declarations.iter();
    all.any(|d| d.statement.subjects().iter().any(own))
}

fn letter_stands_in(letter: &Formula, node: &Node) -> bool {
    node_of(letter).is_some_and(|letter| stands_in(node, &spelled(letter)))
}

fn stands_in(node: &Node, writing: &str) -> bool {
    spelled(node) == writing || node.children().any(|child| stands_in(child, writing))
}

impl Builder<'_> {
    /// A letter that no other sentence tells is the number, the vector or the matrix to which a formula sets it. Where it
    /// does so in a part of the document only, a number is another one elsewhere, and that they are equal is a premise.
    pub(super) fn read_definition(&mut self, formula: &Formula, declaration: &Declaration) {
        let Some((left, right)) = definition_in(formula) else {
            self.read_vector_besides(formula, declaration);
            return;
        };
        let letter = Formula::of(left);
        // A letter by which a frame turns or a point is placed stands in the model already.
        let told =
            self.quantity_of(&letter, declaration).is_some() || self.is_told(&letter, declaration);
        if told || self.is_subject(&letter) {
            return;
        }
        // With the label of an instant a letter is a value of another one.
        let at = place_in(&reach_of(&declaration.extent));
        if self.reading.letters.speaks_of_instant(left, &at) {
            return;
        }
        let everywhere = declaration.extent == Extent::Document && !is_marked_vector(&letter);
        let value = self.mentioned_value(&Formula::of(right), declaration);
        let Some(value) = value.filter(|value| everywhere || !value.is_scalar()) else {
            return;
        };
        self.reading.system.trust(&value);
        let known = Meaning::Quantity(Quantity::Known(value));
        self.denote(&letter, known, declaration);
    }

    /// "`$\\omega = \\omega z$`": the letter of a number is that of a vector as well, where only this fits.
    fn read_vector_besides(&mut self, formula: &Formula, declaration: &Declaration) -> Option<()> {
        let (left, right) = equal_sides(formula)?;
        let letter = Formula::of(left);
        let own = matches!(left.kind, Kind::Symbol(_)) && stands_in(right, &spelled(left));
        let number = own.then(|| self.mentioned_value(&letter, declaration))??;
        let vector = self.mentioned_value(&Formula::of(right), declaration)?;
        if !number.is_scalar() || !vector.is_vector() {
            return None;
        }
        let meaning = Meaning::Quantity(Quantity::Known(vector));
        let letter = self.letter(&letter, meaning, declaration)?;
        self.reading.letters.letters.push(Letter {
            besides: true,
            ..letter
        });
        Some(())
    }

    /// What a formula of a sentence sets a letter to, of which no sentence says in words what it is.
    pub(super) fn definition_of(&self, letter: &Formula) -> Option<Formula> {
        let mut all = self
            .declarations
            .iter()
            .filter(|_| !self.is_subject(letter));
        all.find_map(|d| defined_as(letter, &d.statement))
    }

    /// Whether a formula has a letter that a line is said to define.
    pub(super) fn has_defined_by_line(&self, node: &Node) -> bool {
        self.defined_by_lines()
            .any(|letter| letter_stands_in(letter, node))
    }

    /// The same of a letter of which no sentence tells even that it is a number.
    pub(super) fn waits_for_line(&mut self, node: &Node, declaration: &Declaration) -> bool {
        let letters = self.defined_by_lines();
        let standing = letters.filter(|letter| letter_stands_in(letter, node));
        let letters: Vec<Formula> = standing.cloned().collect();
        letters
            .iter()
            .any(|letter| self.quantity_of(letter, declaration).is_none())
    }

    fn defined_by_lines(&self) -> impl Iterator<Item = &Formula> {
        self.declarations.iter().filter_map(|d| match &d.statement {
            Statement::Role {
                role: DeclaredRole::Define(Some(letter)),
                ..
            } => Some(letter),
            _ => None,
        })
    }

    /// Whether a sentence says in words what a letter is.
    pub(super) fn is_subject(&self, letter: &Formula) -> bool {
        is_subject(self.declarations, letter)
    }
}
