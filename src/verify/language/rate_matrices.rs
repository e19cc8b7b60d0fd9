//! "`$T$` takes the column of the rates of `$\phi$`, `$\theta$`, `$\psi$` to the components of `$\omega$` on B": it is the Jacobian of
//! these components in the rates; and what takes them back is its inverse.

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

/// What takes the rates in one slot to what stands in the other, or back.
fn jacobian(slots: &[(Slot, Term)]) -> Option<NounPhrase> {
    let in_slot = |wanted: Slot| -> Vec<&Term> {
        let own = slots.iter().filter(|(slot, _)| *slot == wanted);
        own.map(|(_, term)| term).collect()
    };
    let (taken, given) = (in_slot(Slot::Of), in_slot(Slot::To));
    if taken.len() + given.len() != slots.len() {
        return None;
    }
    let of_rates = |of: &[&Term], rates: &Term| {
        let of = of.iter().map(|&term| (Slot::Of, term.clone()));
        let slots = of.chain([(Slot::In, rates.clone())]).collect();
        NounPhrase::new(JACOBIAN, slots)
    };
    match (taken.as_slice(), given.as_slice()) {
        ([from], [_, ..]) if rates(from).is_some() => Some(of_rates(&given, rates(from)?)),
        ([_, ..], [to]) => {
            let back = Term::Phrase(Box::new(of_rates(&taken, rates(to)?)));
            Some(NounPhrase::new("inverse", vec![(Slot::Of, back)]))
        }
        _ => None,
    }
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
