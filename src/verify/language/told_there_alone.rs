//! Frames of which one part of the document alone speaks: there they are as they are told to be, and elsewhere they are nothing.

use super::statement::{Declaration, Extent, Slot, Statement, Term};

/// "From line 40 on frame 1 turns relative to frame 0 by the angle `$\theta$`", where no other sentence speaks of frame 1: that
/// it turns so is no premise of a part, but what the frame is.
pub(crate) fn tell_frames_of_parts(declarations: &mut [Declaration]) {
    let parts = declarations.iter().filter(|d| d.extent != Extent::Document);
    let told = parts.filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            (what.head == "frame" && !what.slots.is_empty()).then_some(subjects)
        }
        Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } => slots
            .iter()
            .any(|(slot, _)| *slot == Slot::By)
            .then_some(subjects),
        _ => None,
    });
    let mut own: Vec<Term> = told.flatten().cloned().collect();
    own.retain(|frame| only_part(frame, declarations).is_some());
    for declaration in declarations.iter_mut() {
        let terms = declaration.statement.terms();
        let speaks = terms.iter().any(|term| own.contains(term));
        if speaks && tells_things(&declaration.statement) {
            declaration.extent = Extent::Document;
        }
    }
}

/// The only part of the document for which sentences speak of a frame, but that it has an origin.
fn only_part<'d>(frame: &Term, declarations: &'d [Declaration]) -> Option<&'d Extent> {
    let names_origin = |statement: &Statement| match statement {
        Statement::Is { what, .. } => what.head == "origin",
        _ => false,
    };
    let speaks =
        |d: &&Declaration| d.statement.terms().contains(&frame) && !names_origin(&d.statement);
    let mut parts = declarations.iter().filter(speaks).map(|d| &d.extent);
    let first = parts.next()?;
    parts.all(|part| part == first).then_some(first)
}

/// Whether a sentence tells of things by their names, and not what letters are.
fn tells_things(statement: &Statement) -> bool {
    let named = |term: &Term| matches!(term, Term::Name(_));
    match statement {
        Statement::Is { subjects, .. } | Statement::Does { subjects, .. } => {
            subjects.iter().all(named)
        }
        Statement::Premise(_) => true,
        _ => false,
    }
}
