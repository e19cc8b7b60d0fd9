//! "`$0$` and `$n$` are the reference values of `$p$` and `$r$`, and `$u$` and `$w$` their small disturbances": of which letters.

use super::heads::{DISTURBANCE, REFERENCE};
use super::statement::{Declaration, Slot, Statement, Term};

/// A disturbance is that of the letter whose reference value its sentence names, each of its own: numbers may be alike.
pub(crate) fn tell_disturbed(declarations: &mut [Declaration]) {
    tell_orders(declarations);
    let mut line = None;
    let mut waiting: Vec<(Term, Term)> = vec![];
    for declaration in declarations {
        if line != Some(declaration.line) {
            line = Some(declaration.line);
            waiting.clear();
        }
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        if let (REFERENCE, [value], Some(of)) =
            (what.head, subjects.as_slice(), what.slot(Slot::Of))
        {
            waiting.push((value.clone(), of.clone()));
            continue;
        }
        if what.head != DISTURBANCE {
            continue;
        }
        let own = what.slots.iter_mut().find(|(slot, _)| *slot == Slot::Of);
        let Some((_, of)) = own else { continue };
        if let Some(at) = waiting.iter().position(|(value, _)| value == of) {
            *of = waiting.remove(at).1;
        }
    }
}

/// "Lines 5 to 9 hold to first order in the disturbances": in each letter that is said to be one.
fn tell_orders(declarations: &mut [Declaration]) {
    let small = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == DISTURBANCE => Some(subjects.clone()),
        _ => None,
    });
    let small: Vec<Term> = small.flatten().collect();
    if small.is_empty() {
        return;
    }
    for declaration in declarations {
        let (Statement::LineHolds { slots, .. } | Statement::Does { slots, .. }) =
            &mut declaration.statement
        else {
            continue;
        };
        let all = |(slot, term): &(Slot, Term)| {
            let order = matches!(slot, Slot::In | Slot::InSecondOrder);
            let alone =
                matches!(term, Term::Phrase(p) if p.head == DISTURBANCE && p.slots.is_empty());
            order && alone
        };
        let Some(at) = slots.iter().position(all) else {
            continue;
        };
        let (order, _) = slots.remove(at);
        slots.extend(small.iter().map(|letter| (order, letter.clone())));
    }
}
