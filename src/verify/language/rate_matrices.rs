//! "`$T$` takes the column of the rates of `$\phi$`, `$\theta$`, `$\psi$` to the components of `$\omega$` on B": it is the Jacobian of
//! these components in the rates.

use super::heads::JACOBIAN;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// Says of matrices that take rates to components what they are.
pub(crate) fn tell_rate_matrices(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let said = declaration.statement.does("take");
        if let Some((subjects, slots)) = said
            && let Some(what) = jacobian(slots)
        {
            let subjects = subjects.to_vec();
            declaration.statement = Statement::Is { subjects, what };
        }
    }
}

/// What takes the rates in one slot to what stands in the other.
fn jacobian(slots: &[(Slot, Term)]) -> Option<NounPhrase> {
    let [(Slot::Of, taken), (Slot::To, given)] = slots else {
        return None;
    };
    let rates = rates(taken)?;
    let slots = vec![(Slot::Of, given.clone()), (Slot::In, rates.clone())];
    Some(NounPhrase::new(JACOBIAN, slots))
}

/// "the rates of `$a$` and `$b$`", "the column of the rates of …"
fn rates(taken: &Term) -> Option<&Term> {
    let Term::Phrase(phrase) = taken else {
        return None;
    };
    match (phrase.head, phrase.slots.as_slice()) {
        ("rate", _) => Some(taken),
        ("column" | "vector", [(Slot::Of, inner)]) => rates(inner),
        _ => None,
    }
}
