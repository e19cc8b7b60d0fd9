//! What is said once more of something, or of what it is of: "G is the mass centre of the aircraft, a rigid body".

use super::heads::MASS_CENTRE;
use super::reader::{Read, Reader};
use super::statement::{Formula, Slot, Statement, Term};
use super::words::Kind;
use super::{is_body, is_quantity, is_thing};

impl Reader<'_> {
    /// ", a point fixed in N" behind what something is said to be.
    pub(super) fn appositions(
        &mut self,
        subjects: &[Term],
        formulas: Option<&[Formula]>,
        statements: &mut Vec<Statement>,
    ) -> Read<()> {
        while matches!(statements.last(), Some(Statement::Is { .. })) {
            let start = self.at;
            let comma = self.take_sign(Kind::Comma);
            let article = ["a", "an", "the"].contains(&self.word());
            if !comma || !article || self.at_clause() {
                self.at = start;
                break;
            }
            let article_at = self.at;
            let owner = statements.last().and_then(owner_of_place);
            let said = self.predicate(subjects, formulas.map(<[Formula]>::to_vec))?;
            let mut nouns = said.iter().filter_map(Statement::noun_phrase);
            let owner = owner.filter(|_| nouns.any(|what| is_body(what.head)));
            let (last, first) = (statements.last(), said.first());
            // "`$r$` is the position of P, a point fixed in B": P is that point, and no letter is both.
            let of_another = formulas.is_some()
                && last.is_some_and(says_quantity)
                && first.is_some_and(says_thing);
            statements.extend(match owner {
                Some(owner) => {
                    self.at = article_at;
                    self.predicate(&[owner], None)?
                }
                None if of_another => {
                    self.at = start;
                    break;
                }
                None => said,
            });
        }
        Ok(())
    }
}

/// "G is the mass centre of the aircraft, a rigid body": a point and a quantity are no body, what they are of is one.
fn owner_of_place(statement: &Statement) -> Option<Term> {
    match statement {
        Statement::Is { what, .. } if what.head == MASS_CENTRE || is_quantity(what.head) => {
            let of = what.slot(Slot::Of)?;
            (!matches!(of, Term::Formula(_))).then(|| of.clone())
        }
        _ => None,
    }
}

/// Whether letters are said to be a quantity.
fn says_quantity(statement: &Statement) -> bool {
    matches!(statement, Statement::Is { what, .. } if is_quantity(what.head))
}

/// Whether something is said to be a body or a place.
fn says_thing(statement: &Statement) -> bool {
    matches!(statement, Statement::Is { what, .. } if is_thing(what.head))
}
