//! "`$J$` is the principal moment of the rotor about `$n$`": the moment of inertia about that axis, which is a principal one.

use super::heads::{AXES, MOMENT_OF_INERTIA, PRINCIPAL_AXES, PRINCIPAL_MOMENTS, UNIT_VECTOR};
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// Says so of each letter that is alone the principal moment about an axis.
pub(super) fn tell_single_moments(declarations: &mut Vec<Declaration>) {
    let told = declarations.iter().flat_map(directions_in);
    let directions: Vec<Term> = told.collect();
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        let ([Term::Formula(_)], PRINCIPAL_MOMENTS) = (subjects.as_slice(), what.head) else {
            return vec![];
        };
        let about = |slot: Slot| matches!(slot, Slot::About | Slot::Along);
        let axis = |(slot, term): &(Slot, Term)| {
            about(*slot) && (term.is_noun("axis") || directions.contains(term))
        };
        let Some(at) = what.slots.iter().position(axis) else {
            return vec![];
        };
        let Some(body) = what.slot(Slot::Of).cloned() else {
            return vec![];
        };
        let (_, axis) = what.slots.remove(at);
        let point = what
            .slots
            .iter()
            .position(|(slot, _)| matches!(slot, Slot::About | Slot::At));
        let point = point.map(|at| what.slots.remove(at).1);
        let (line, direction, through) = line_of(axis, point);
        what.head = MOMENT_OF_INERTIA;
        what.slots.push((Slot::About, line));
        let about = through.map(|point| (Slot::About, point));
        let mut slots = vec![(Slot::Of, body)];
        slots.extend(about);
        slots.push((Slot::With, direction));
        vec![Statement::Premise(NounPhrase::new(PRINCIPAL_AXES, slots))]
    });
}

/// The line about which a moment is taken, its direction, and the point through which it goes.
fn line_of(axis: Term, point: Option<Term>) -> (Term, Term, Option<Term>) {
    if let Term::Phrase(line) = &axis
        && let (Some(through), Some(along)) = (line.slot(Slot::Through), line.slot(Slot::Along))
    {
        let (along, through) = (along.clone(), through.clone());
        return (axis, along, Some(through));
    }
    let line = match &point {
        Some(point) => {
            let slots = vec![(Slot::Through, point.clone()), (Slot::Along, axis.clone())];
            Term::Phrase(Box::new(NounPhrase::new("axis", slots)))
        }
        None => axis.clone(),
    };
    (line, axis, point)
}

/// What a sentence says to be axes or directions.
fn directions_in(declaration: &Declaration) -> Vec<Term> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == "vector" => subjects.clone(),
        _ => axes_in(declaration),
    }
}

/// What a sentence says to be axes, or of length one.
pub(super) fn axes_in(declaration: &Declaration) -> Vec<Term> {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            let axes = matches!(what.head, "axes" | UNIT_VECTOR | PRINCIPAL_AXES);
            let own = subjects
                .iter()
                .filter(|_| axes || AXES.contains(&what.head));
            own.cloned().collect()
        }
        _ => vec![],
    }
}
