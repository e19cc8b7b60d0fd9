//! "The coin is a body of mass `$m$` and radius `$r$`" and "the coin is a thin disc": one of these sizes.

use super::body_axes::is_thing_with_sizes;
use super::is_body;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::leave_out;

/// The noun of what has no shape.
const BODY: &str = "body";

/// Gives the sizes of what is said to be a body to the sentence that says its shape and no sizes of that kind.
pub(super) fn gather_sizes(declarations: &mut Vec<Declaration>) {
    let mut left = vec![];
    for at in 0..declarations.len() {
        let Some((body, sizes)) = sizes_of_body(&declarations[at]) else {
            continue;
        };
        let extent = declarations[at].extent.clone();
        let shape = declarations.iter_mut().find(|d| {
            d.extent == extent
                && shape_of(&d.statement, &body).is_some_and(|own| lacks(own, &sizes))
        });
        if let Some(Statement::Is { what, .. }) = shape.map(|d| &mut d.statement) {
            what.slots.extend(sizes);
            left.push(at);
        }
    }
    leave_out(declarations, &left);
}

/// What is said to be a body of some sizes, and no more.
fn sizes_of_body(declaration: &Declaration) -> Option<(Term, Vec<(Slot, Term)>)> {
    match &declaration.statement {
        Statement::Is { subjects, what } => match subjects.as_slice() {
            [body] if what.head == BODY && what.adjectives.is_empty() => {
                is_thing_with_sizes(what).then(|| (body.clone(), what.slots.clone()))
            }
            _ => None,
        },
        _ => None,
    }
}

/// What shape a sentence says a body to be of.
fn shape_of<'s>(statement: &'s Statement, body: &Term) -> Option<&'s NounPhrase> {
    match statement {
        Statement::Is { subjects, what } => {
            let own = matches!(subjects.as_slice(), [own] if own == body);
            (own && is_body(what.head) && what.head != BODY).then_some(what)
        }
        _ => None,
    }
}

/// Whether a shape is told without sizes of these kinds.
fn lacks(shape: &NounPhrase, sizes: &[(Slot, Term)]) -> bool {
    sizes.iter().all(|(_, size)| match size {
        Term::Phrase(size) => shape.size(size.head).is_none(),
        _ => false,
    })
}
