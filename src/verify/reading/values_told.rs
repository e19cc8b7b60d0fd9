//! "`$V = 0$` at `$s = h$`" says of a letter that it is zero then.

use crate::notation::ast::{Kind, Node, Relation};
use crate::notation::document::Row;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::verify::reading::zeros_read::ZERO;
use num_traits::Zero;

/// The sentence, as one that says of a letter that it is zero at some values where it says so by an equation.
pub(super) fn with_zero_said(declaration: Declaration) -> Declaration {
    match zero_said(&declaration.statement) {
        Some(statement) => Declaration {
            statement,
            ..declaration
        },
        None => declaration,
    }
}

fn zero_said(statement: &Statement) -> Option<Statement> {
    let (subjects, slots) = statement.does("hold")?;
    let ([Term::Formula(Formula { row, .. })], [(Slot::At, at)]) = (subjects, slots) else {
        return None;
    };
    let Row::Line(line) = row else { return None };
    let ([letter, value], [(Relation::Equal, _)]) =
        (line.sides.as_slice(), line.relations.as_slice())
    else {
        return None;
    };
    let is_letter = matches!(letter.kind, Kind::Symbol(_));
    (is_letter && is_zero(value)).then(|| Statement::Is {
        subjects: vec![Term::Formula(Formula::of(letter))],
        what: NounPhrase::new(ZERO, vec![(Slot::At, at.clone())]),
    })
}

fn is_zero(node: &Node) -> bool {
    matches!(&node.kind, Kind::Number(number) if number.value.is_zero())
}
