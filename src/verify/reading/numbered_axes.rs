//! Axes with numbers, and the letter that numbers them.

use crate::notation::ast::{Kind, Symbol};
use crate::verify::language::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::verify::reading::names::{index_letter, node_of};
use crate::verify::term::indices::with_number;

/// The numbers of the axes of a frame.
const NUMBERS: [&str; 3] = ["1", "2", "3"];

/// The sentences, and that `$b_i$` are the axes of a frame where `$b_1, b_2, b_3$` are and `$i$` numbers them.
pub(super) fn with_numbered_axes(mut declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut told: Vec<Declaration> = vec![];
    for declaration in &declarations {
        let Some(([Term::Formula(index)], [(Slot::Of, Term::Phrase(axes))])) =
            declaration.statement.does("number")
        else {
            continue;
        };
        let frame = axes.slot(Slot::Of).filter(|_| axes.head == "axes");
        let named = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what }
                if what.head == "axes" && what.slot(Slot::Of) == frame =>
            {
                let axis = numbered(subjects, &index_letter(index))?;
                Some(d.saying(Statement::Is {
                    subjects: vec![axis],
                    what: what.clone(),
                }))
            }
            _ => None,
        };
        if frame.is_some() {
            told.extend(declarations.iter().filter_map(named));
        }
    }
    told.retain(|one| !declarations.iter().any(|d| d.statement == one.statement));
    declarations.extend(told);
    declarations
}

/// The letter of three axes with an index in the place of their numbers.
fn numbered(axes: &[Term], index: &str) -> Option<Term> {
    let symbols: Option<Vec<&Symbol>> = axes.iter().map(symbol).collect();
    let symbols = symbols.filter(|symbols| symbols.len() == NUMBERS.len())?;
    let first = with_number(symbols.first()?, index);
    let mut each = symbols.iter().zip(NUMBERS);
    let in_order = each.all(|(own, number)| {
        own.subscripts.last().is_some_and(|last| last == number) && with_number(own, index) == first
    });
    let Term::Formula(axis) = axes.first()? else {
        return None;
    };
    let mut node = node_of(axis)?.clone();
    node.change_symbols(&mut |symbol| *symbol = first.clone());
    in_order.then(|| Term::Formula(Formula::of(&node)))
}

fn symbol(axis: &Term) -> Option<&Symbol> {
    let Term::Formula(formula) = axis else {
        return None;
    };
    match &node_of(formula)?.kind {
        Kind::Symbol(symbol) => Some(symbol),
        _ => None,
    }
}
