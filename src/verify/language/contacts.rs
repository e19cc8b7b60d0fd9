//! Where what rolls touches its plane, and that the force of the plane acts there.

use super::heads::{CONTACT_POINT, FORCE};
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// "C is the point of contact", "the wheel touches the floor at C", where the wheel rolls on the floor: C is its contact point.
pub(crate) fn tell_contacts(declarations: &mut [Declaration]) {
    let rolling = declarations.iter().filter_map(|d| rolling(&d.statement));
    let rolling: Vec<(Term, Term)> = rolling.map(|(touching, _)| touching).collect();
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Is { subjects: _, what } if what.head == CONTACT_POINT => {
                if let ([], [(body, on)]) = (what.slots.as_slice(), rolling.as_slice()) {
                    what.slots = vec![(Slot::Of, body.clone()), (Slot::On, on.clone())];
                }
            }
            statement => {
                let contact = touching_at(statement, &rolling);
                if let Some(contact) = contact {
                    declaration.statement = contact;
                }
            }
        }
    }
}

/// What rolls, on what, and at which point.
fn rolling(statement: &Statement) -> Option<((Term, Term), Option<Term>)> {
    let (subjects, slots) = statement.does("roll")?;
    let touching = (subjects.first()?.clone(), slot(slots, Slot::On)?.clone());
    Some((touching, slot(slots, Slot::At).cloned()))
}

/// The contact point of what touches, at a point, the thing on which it rolls.
fn touching_at(statement: &Statement, rolling: &[(Term, Term)]) -> Option<Statement> {
    let (subjects, slots) = statement.does("touch")?;
    let ([body], [_, _]) = (subjects, slots) else {
        return None;
    };
    let (on, at) = (slot(slots, Slot::On)?, slot(slots, Slot::At)?);
    let known = rolling
        .iter()
        .any(|(own, plane)| own == body && plane == on);
    let slots = vec![(Slot::Of, body.clone()), (Slot::On, on.clone())];
    known.then(|| Statement::one_is(at.clone(), NounPhrase::new(CONTACT_POINT, slots)))
}

/// "The force of the floor" in a list of the loads on what touches the floor at C acts there.
pub(crate) fn place_contact_forces(declarations: &mut [Declaration]) {
    let told = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == CONTACT_POINT => {
            let touching = (what.slot(Slot::Of)?.clone(), what.slot(Slot::On)?.clone());
            Some((subjects.first()?.clone(), touching))
        }
        statement => {
            let (touching, at) = rolling(statement)?;
            Some((at?, touching))
        }
    });
    let told: Vec<(Term, (Term, Term))> = told.collect();
    for declaration in declarations {
        let Statement::Premise(premise) = &mut declaration.statement else {
            continue;
        };
        let Some(body) = premise
            .slot(Slot::Of)
            .filter(|_| premise.is("only"))
            .cloned()
        else {
            continue;
        };
        let mut letters = vec![];
        let loads = premise.slots.iter_mut();
        for (_, load) in loads.filter(|(slot, _)| *slot == Slot::With) {
            let Term::Phrase(force) = load else { continue };
            letters.extend(loads_listed_behind(force));
            let one = force.all(Slot::Of).count() == 1;
            let plain = force
                .slots
                .iter()
                .all(|(slot, _)| matches!(slot, Slot::Of | Slot::Upon));
            let Some(plane) = force
                .slot(Slot::Of)
                .filter(|_| force.head == FORCE && plain && one)
            else {
                continue;
            };
            let mut points = told
                .iter()
                .filter(|(_, (own, on))| *own == body && on == plane);
            let at = points.next().map(|(at, _)| at.clone());
            force.slots.extend(at.map(|at| (Slot::At, at)));
        }
        premise.slots.extend(letters);
    }
}

/// "The force of the floor and `$P$`": the letter is another load, since nothing that a formula tells exerts one.
fn loads_listed_behind(force: &mut NounPhrase) -> Vec<(Slot, Term)> {
    if force.head != FORCE || force.all(Slot::Of).count() < 2 {
        return vec![];
    }
    let slots = std::mem::take(&mut force.slots);
    let behind =
        |(slot, term): &(Slot, Term)| *slot == Slot::Of && matches!(term, Term::Formula(_));
    let (letters, own): (Vec<_>, Vec<_>) = slots.into_iter().partition(behind);
    force.slots = own;
    letters
        .into_iter()
        .map(|(_, letter)| (Slot::With, letter))
        .collect()
}
