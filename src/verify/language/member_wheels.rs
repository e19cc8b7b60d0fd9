//! How each of many wheels turns, told by a frame that is fixed in it or by how fast it turns about its axis of symmetry.

use super::heads::ANGULAR_VELOCITY;
use super::mounted::symmetries;
use super::statement::{Declaration, Slot, Statement, Term};

/// Says of each wheel how it turns: "`$W_i$` turns relative to B about `$g_i$`", where `$W_i$` is fixed in wheel `$i$`;
/// "`$\Omega_i$` is the angular velocity of wheel `$i$` relative to B along `$g_i$`", about which it is symmetric.
pub(crate) fn turn_members(declarations: &mut Vec<Declaration>) {
    let frames: Vec<(Term, Term)> = declarations
        .iter()
        .flat_map(|d| frames_of_member(&d.statement))
        .collect();
    let member = |frame: &Term| frames.iter().find(|(own, _)| own == frame);
    let mut told = vec![];
    for declaration in declarations.iter() {
        let Some((subjects, slots)) = declaration.statement.does("turn") else {
            continue;
        };
        for (_, member) in subjects.iter().filter_map(member) {
            let turn = Statement::Does {
                subjects: vec![member.clone()],
                verb: "turn",
                slots: slots.to_vec(),
            };
            told.push(declaration.saying(turn));
        }
    }
    declarations.extend(told);
    let symmetric: Vec<(Term, Term)> = declarations
        .iter()
        .flat_map(symmetries)
        .map(|(body, axis)| (body.clone(), axis.clone()))
        .collect();
    let turning: Vec<Term> = declarations
        .iter()
        .filter_map(|d| d.statement.does("turn"))
        .flat_map(|(subjects, _)| subjects.to_vec())
        .collect();
    for declaration in declarations.iter_mut() {
        if let Some(turn) = turn_by_rate(&declaration.statement, &symmetric, &turning) {
            declaration.statement = turn;
        }
    }
}

/// The frames that are fixed in one of many, each with that.
fn frames_of_member(statement: &Statement) -> Vec<(Term, Term)> {
    let Statement::Is { subjects, what } = statement else {
        return vec![];
    };
    match what.slot(Slot::FixedIn) {
        Some(member @ Term::Member { .. }) if what.head == "frame" => {
            let own = subjects.iter().cloned();
            own.map(|frame| (frame, member.clone())).collect()
        }
        _ => vec![],
    }
}

/// How one of many turns about its axis of symmetry, where no sentence says it otherwise.
fn turn_by_rate(
    statement: &Statement,
    symmetric: &[(Term, Term)],
    turning: &[Term],
) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([rate @ Term::Formula(_)], ANGULAR_VELOCITY, [_, _, _]) =
        (subjects.as_slice(), what.head, what.slots.as_slice())
    else {
        return None;
    };
    let member @ Term::Member { .. } = what.slot(Slot::Of)? else {
        return None;
    };
    let (relative, axis) = (what.slot(Slot::RelativeTo)?, what.slot(Slot::Along)?);
    let own = symmetric.contains(&(member.clone(), axis.clone()));
    (own && !turning.contains(member)).then(|| Statement::Does {
        subjects: vec![member.clone()],
        verb: "turn",
        slots: vec![
            (Slot::RelativeTo, relative.clone()),
            (Slot::About, axis.clone()),
            (Slot::At, rate.clone()),
        ],
    })
}
