//! Moments of motors between two bodies: "the motor acts on the forearm with the moment `$M$`, and on the upper arm with the
//! opposite moment" tells that the upper arm does so.

use super::heads::MOMENT;
use super::statement::{Declaration, Formula, Slot, Statement, Term};
use crate::notation::ast::Kind;

/// What drives bodies and is none itself.
const MOTORS: [&str; 4] = ["motor", "actuator", "brake", "clutch"];

/// Says it so, and leaves out where a motor is: its moment acts at no point.
pub(super) fn tell_reactions_of_motors(declarations: &mut Vec<Declaration>) {
    for declaration in declarations.iter_mut() {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head == MOMENT
            && what.all(Slot::Of).any(is_motor)
            && what.slot(Slot::Upon).is_some()
        {
            what.slots.retain(|(slot, _)| *slot != Slot::At);
        }
    }
    let mut at = 0;
    while at < declarations.len() {
        let reaction = by_motor(&declarations[at].statement).and_then(|(moment, body)| {
            let other = declarations.iter().position(|d| {
                by_motor(&d.statement).is_some_and(|(own, _)| is_opposite(own, moment))
            })?;
            let same = declarations[other].text == declarations[at].text;
            (same || declarations[at].extent == declarations[other].extent)
                .then(|| (other, body.clone()))
        });
        let Some((other, body)) = reaction else {
            at += 1;
            continue;
        };
        if let Statement::Is { what, .. } = &mut declarations[other].statement {
            let agents = what.slots.iter_mut();
            for (_, agent) in agents.filter(|(slot, _)| *slot == Slot::Of) {
                agent.clone_from(&body);
            }
        }
        declarations.remove(at);
    }
}

fn is_motor(agent: &Term) -> bool {
    match agent {
        Term::Name(name) => MOTORS.contains(&name.as_str()),
        Term::Phrase(thing) => MOTORS.contains(&thing.head),
        _ => false,
    }
}

/// "`$M$` is the moment of the motor on the arm": its formula, and the body.
fn by_motor(statement: &Statement) -> Option<(&Formula, &Term)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let [Term::Formula(moment)] = subjects.as_slice() else {
        return None;
    };
    let motor = what.head == MOMENT && what.all(Slot::Of).all(is_motor);
    let known = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::Upon);
    let plain = motor && what.slots.iter().all(known) && what.slot(Slot::Of).is_some();
    plain.then_some((moment, what.slot(Slot::Upon)?))
}

/// Whether the second formula is the first with the other sign.
fn is_opposite(moment: &Formula, other: &Formula) -> bool {
    let own = moment.node().map(Formula::of);
    match other.node().map(|node| &node.kind) {
        Some(Kind::Negate(inner)) => own.is_some_and(|own| own.source == Formula::of(inner).source),
        _ => false,
    }
}
