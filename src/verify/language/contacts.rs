//! Where what rolls touches its plane, and that the force of the plane acts there.

use super::heads::{CONTACT_POINT, FORCE, MASS_CENTRE};
use super::kinds::name;
use super::places::is_marked_vector;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// "C is the point of contact", "the wheel touches the floor at C", where the wheel rolls on the floor: C is its contact point.
pub(crate) fn tell_contacts(declarations: &mut [Declaration]) {
    let rolling = declarations.iter().filter_map(|d| rolling(&d.statement));
    let rolling: Vec<(Term, Term)> = rolling.map(|(touching, _)| touching).collect();
    let centres: Vec<(Term, Term)> = declarations
        .iter()
        .flat_map(|d| centres(&d.statement))
        .collect();
    for declaration in declarations {
        match &mut declaration.statement {
            Statement::Is { subjects: _, what } if what.head == CONTACT_POINT => {
                touch_by_bodies(what, &centres);
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

/// Mass centres, each with its body.
fn centres(statement: &Statement) -> Vec<(Term, Term)> {
    match statement {
        Statement::Is { subjects, what } if what.head == MASS_CENTRE => match what.slot(Slot::Of) {
            Some(body) => subjects.iter().map(|s| (s.clone(), body.clone())).collect(),
            None => vec![],
        },
        _ => vec![],
    }
}

/// "G is the mass centre of the disc, and C is the point where it touches the floor": the disc does, and no point of it.
fn touch_by_bodies(what: &mut NounPhrase, centres: &[(Term, Term)]) {
    for (slot, of) in &mut what.slots {
        let own = centres
            .iter()
            .find(|(centre, _)| *slot == Slot::Of && centre == of);
        own.into_iter().for_each(|(_, body)| of.clone_from(body));
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

/// What touches what, and where.
struct Touching {
    body: Term,
    on: Term,
    at: Term,
}

/// "The force of the floor" on what touches the floor at C acts there. Where no sentence names the point it gets a name.
pub(crate) fn place_contact_forces(declarations: &mut Vec<Declaration>) {
    let mut told: Vec<Touching> = declarations
        .iter()
        .filter_map(|d| touching(&d.statement))
        .collect();
    name_contacts(declarations, &mut told);
    for declaration in declarations.iter_mut() {
        match &mut declaration.statement {
            Statement::Is { what, .. } => act_at_contact(what, None, &told),
            Statement::Premise(premise) if premise.is("only") => {
                let body = premise.slot(Slot::Of).cloned();
                let mut letters = vec![];
                let loads = premise.slots.iter_mut();
                for (_, load) in loads.filter(|(slot, _)| *slot == Slot::With) {
                    let Term::Phrase(force) = load else { continue };
                    letters.extend(loads_listed_behind(force));
                    act_at_contact(force, body.as_ref(), &told);
                }
                premise.slots.extend(letters);
            }
            _ => {}
        }
    }
    take_components(declarations);
}

/// "`$N$` is the force of the floor on the wheel along y", where a list has the whole force of the floor: `$N$` is the component
/// of that along y.
fn take_components(declarations: &mut [Declaration]) {
    let listed: Vec<Term> = declarations
        .iter()
        .filter_map(|d| match &d.statement {
            Statement::Premise(premise) if premise.is("only") => Some(premise),
            _ => None,
        })
        .flat_map(|premise| premise.all(Slot::With))
        .filter_map(|load| match load {
            Term::Phrase(force) if force.head == FORCE && force.slot(Slot::Which).is_none() => {
                force.slot(Slot::At).cloned()
            }
            _ => None,
        })
        .collect();
    for declaration in declarations {
        let Statement::Is { subjects, what } = &mut declaration.statement else {
            continue;
        };
        let number = |term: &Term| matches!(term, Term::Formula(l) if !is_marked_vector(l));
        let whole = what.head == FORCE && what.slot(Slot::At).is_some_and(|at| listed.contains(at));
        let along = what.slot(Slot::Along).cloned();
        if let (true, Some(along)) = (whole && subjects.iter().all(number), along) {
            let mut force = what.clone();
            force.slots.retain(|(slot, _)| *slot != Slot::Along);
            let of = Term::Phrase(Box::new(force));
            let slots = vec![(Slot::Along, along), (Slot::Of, of)];
            *what = NounPhrase::new("component", slots);
        }
    }
}

/// Where a sentence says that a body touches something.
fn touching(statement: &Statement) -> Option<Touching> {
    match statement {
        Statement::Is { subjects, what } if what.head == CONTACT_POINT => Some(Touching {
            body: what.slot(Slot::Of)?.clone(),
            on: surface_of(what.slot(Slot::On)?).clone(),
            at: subjects.first()?.clone(),
        }),
        statement => {
            let ((body, on), at) = rolling(statement)?;
            let on = surface_of(&on).clone();
            Some(Touching { body, on, at: at? })
        }
    }
}

/// "the inner surface of the bowl": the bowl.
fn surface_of(on: &Term) -> &Term {
    match on {
        Term::Phrase(surface) if surface.head == "surface" => surface.slot(Slot::Of).unwrap_or(on),
        on => on,
    }
}

/// Names the points where things roll of which no sentence does, if one speaks of the force there.
fn name_contacts(declarations: &mut Vec<Declaration>, told: &mut Vec<Touching>) {
    let mut named = vec![];
    for declaration in declarations.iter() {
        let Some(((body, on), None)) = rolling(&declaration.statement) else {
            continue;
        };
        let plane = surface_of(&on).clone();
        let known = told.iter().any(|own| own.body == body && own.on == plane);
        let speaks = declarations.iter().any(|d| match &d.statement {
            Statement::Is { what, .. } | Statement::Premise(what) => pushes(what, &plane),
            _ => false,
        });
        let (Some(name), true) = (name(&body), speaks && !known) else {
            continue;
        };
        let at = Term::Name(format!("contact of {name}"));
        let slots = vec![(Slot::Of, body.clone()), (Slot::On, on)];
        let point = NounPhrase::new(CONTACT_POINT, slots);
        named.push(declaration.saying(Statement::one_is(at.clone(), point)));
        told.push(Touching {
            body,
            on: plane,
            at,
        });
    }
    declarations.extend(named);
}

/// Whether a phrase has the force of a thing, without the point where it acts.
fn pushes(what: &NounPhrase, plane: &Term) -> bool {
    let own = is_unplaced_force(what) && what.slot(Slot::Of) == Some(plane);
    own || what.slots.iter().any(|(_, inner)| match inner {
        Term::Phrase(inner) => pushes(inner, plane),
        _ => false,
    })
}

/// "the force of the floor", also "… at the point of contact"
fn is_unplaced_force(what: &NounPhrase) -> bool {
    let known = |(slot, term): &(Slot, Term)| match slot {
        Slot::Of | Slot::Upon | Slot::Along | Slot::On | Slot::Which => true,
        Slot::At => matches!(term, Term::Phrase(at) if at.head == CONTACT_POINT),
        _ => false,
    };
    let one = what.all(Slot::Of).count() == 1;
    what.head == FORCE && one && what.slots.iter().all(known)
}

/// Gives the forces of what a body touches the point where it does.
fn act_at_contact(what: &mut NounPhrase, body: Option<&Term>, told: &[Touching]) {
    if is_unplaced_force(what) {
        let upon = what.slot(Slot::Upon).or(body);
        let plane = what.slot(Slot::Of);
        let own = |own: &&Touching| Some(&own.body) == upon && Some(&own.on) == plane;
        if let Some(own) = told.iter().find(own) {
            what.slots.retain(|(slot, _)| *slot != Slot::At);
            what.slots.push((Slot::At, own.at.clone()));
        }
    }
    for (_, inner) in &mut what.slots {
        if let Term::Phrase(inner) = inner {
            act_at_contact(inner, None, told);
        }
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
