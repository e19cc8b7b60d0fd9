//! Axes of rotation that meet in a point: "the three axes meet at O". It is fixed in all that turns about them.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// Fixes the point in which all axes of rotation meet.
pub(crate) fn fix_meeting_points(declarations: &mut Vec<Declaration>) {
    let turning: Vec<Term> = declarations.iter().flat_map(turning).collect();
    if turning.is_empty() {
        return;
    }
    let fixed: Vec<Declaration> = declarations
        .iter()
        .filter_map(|d| {
            let point = meeting_point(&d.statement)?;
            let fixed_in = turning.iter().map(|thing| (Slot::FixedIn, thing.clone()));
            let what = NounPhrase::new("point", fixed_in.collect());
            Some(d.saying(Statement::one_is(point.clone(), what)))
        })
        .collect();
    if !fixed.is_empty() {
        declarations.retain(|d| meeting_point(&d.statement).is_none());
        declarations.extend(fixed);
    }
}

/// What turns about an axis, and relative to what.
fn turning(declaration: &Declaration) -> Vec<Term> {
    match declaration.statement.does("turn") {
        Some((subjects, slots)) if slot(slots, Slot::About).is_some() => {
            let ground = slot(slots, Slot::RelativeTo).into_iter();
            subjects.iter().chain(ground).cloned().collect()
        }
        _ => vec![],
    }
}

fn meeting_point(statement: &Statement) -> Option<&Term> {
    let (subjects, slots) = statement.does("touch")?;
    let all = |term: &Term| match term {
        Term::Phrase(phrase) => matches!(phrase.head, "axis" | "axes") && phrase.slots.is_empty(),
        _ => false,
    };
    (!subjects.is_empty() && subjects.iter().all(all)).then_some(())?;
    slot(slots, Slot::At)
}
