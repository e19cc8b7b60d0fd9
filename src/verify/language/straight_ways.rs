//! Things that are straight lines: what slides on a wall that is a line moves along that line.

use super::heads::FORCE;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// What a point does on a line.
const ON_LINES: [&str; 3] = ["move", "slide", "lie"];

/// "The wall is the line through O along y. A slides on the wall": A moves along the line, and the force of the wall on the rod of
/// which A is an end acts there.
pub(super) fn move_on_lines(declarations: &mut Vec<Declaration>) {
    let lines: Vec<(Term, NounPhrase)> = declarations
        .iter()
        .filter_map(|d| line(&d.statement))
        .collect();
    let mut touched: Vec<(Term, Term)> = vec![];
    for declaration in declarations.iter_mut() {
        let Statement::Does {
            subjects,
            verb,
            slots,
        } = &mut declaration.statement
        else {
            continue;
        };
        if !ON_LINES.contains(verb) {
            continue;
        }
        let moves = subjects.iter().all(|s| matches!(s, Term::Name(_)));
        for (slot, on) in slots.iter_mut().filter(|_| moves) {
            if !matches!(slot, Slot::On | Slot::Along) {
                continue;
            }
            if let Some((wall, line)) = lines.iter().find(|(wall, _)| wall == on) {
                touched.extend(subjects.iter().map(|s| (s.clone(), wall.clone())));
                *on = Term::Phrase(Box::new(line.clone()));
            }
            if is_line(on) {
                *slot = Slot::Along;
            }
        }
    }
    let walked = |wall: &Term| touched.iter().any(|(_, own)| own == wall);
    declarations.retain(|d| !line(&d.statement).is_some_and(|(wall, _)| walked(&wall)));
    for declaration in declarations.iter_mut() {
        match &mut declaration.statement {
            Statement::Is { what, .. } | Statement::Premise(what) => place_forces(what, &touched),
            _ => {}
        }
    }
}

/// "The wall is the line through O along y."
fn line(statement: &Statement) -> Option<(Term, NounPhrase)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([wall @ Term::Name(_)], true) = (subjects.as_slice(), is_line_phrase(what)) else {
        return None;
    };
    Some((wall.clone(), what.clone()))
}

fn is_line(term: &Term) -> bool {
    matches!(term, Term::Phrase(line) if is_line_phrase(line))
}

/// "the axis through O along y", and no more.
fn is_line_phrase(line: &NounPhrase) -> bool {
    let told = line.slot(Slot::Through).is_some() && line.slot(Slot::Along).is_some();
    line.head == "axis" && told && line.slots.len() == 2
}

/// The force of a line on which one point alone moves acts at that point.
fn place_forces(what: &mut NounPhrase, touched: &[(Term, Term)]) {
    let one = what.head == FORCE && what.all(Slot::Of).count() == 1;
    if one && what.slot(Slot::At).is_none() {
        let wall = what.slot(Slot::Of);
        let mut points = touched.iter().filter(|(_, own)| Some(own) == wall);
        if let (Some((point, _)), None) = (points.next(), points.next()) {
            what.slots.push((Slot::At, point.clone()));
        }
    }
    for (_, inner) in &mut what.slots {
        if let Term::Phrase(inner) = inner {
            place_forces(inner, touched);
        }
    }
}
