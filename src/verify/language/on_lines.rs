//! What slides along a body that is long: it is on the line of the body, at its distance from a point of that.

use super::heads::{FORCE, UNIT_VECTOR, WEIGHT, WITHOUT_FRICTION};
use super::planar_axes::{axis, tells_distance};
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::traits::{Trait, has};

/// The axis of a body along which it is long, where nothing else tells it.
const LONG: usize = 1;

/// "The bead slides along the rod; `$r$` is its distance from O": it lies at r from O along the rod, which turns about O.
pub(crate) fn place_on_lines(declarations: &mut Vec<Declaration>) {
    let long = |slot, name: &str| slot == Slot::Along && has(name, Trait::Rail);
    let said = declarations.iter();
    let said: Vec<(Term, Term)> = said.filter_map(|d| sliding(&d.statement, long)).collect();
    for (bead, rail) in said {
        let pivot = declarations.iter().find_map(|d| pivot(&d.statement, &rail));
        let level = declarations
            .iter()
            .position(|d| is_level(&d.statement, &rail));
        let (Some(pivot), Some(level)) = (pivot, level) else {
            continue;
        };
        let along = axis(LONG, Some(&rail));
        let place = declarations.iter_mut().find_map(|declaration| {
            let (one, other, distance) = tells_distance(&declaration.statement)?;
            let own = (one, other) == (&bead, &pivot) || (one, other) == (&pivot, &bead);
            let distance = distance.clone();
            own.then_some((declaration, distance))
        });
        let Some((declaration, distance)) = place else {
            continue;
        };
        declaration.statement = Statement::Does {
            subjects: vec![bead.clone()],
            verb: "lie",
            slots: vec![
                (Slot::At, distance),
                (Slot::From, pivot.clone()),
                (Slot::Along, along.clone()),
            ],
        };
        let declaration = declaration.clone();
        // Of a rod that only turns nobody says what it is.
        let is_said = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, .. } => subjects.contains(&rail),
            _ => false,
        };
        if !declarations.iter().any(is_said) {
            let frame = NounPhrase::new("frame", vec![]);
            declarations.push(declaration.saying(Statement::one_is(rail.clone(), frame)));
        }
        let smooth = slides_smoothly(&bead, declarations) && !has_other_loads(&rail, declarations);
        leave_manner(&bead, declarations);
        if smooth {
            let free = no_force_along(&bead, along.clone());
            declarations.push(declaration.saying(free));
        }
        declarations.push(declaration.saying(Statement::Does {
            subjects: vec![rail.clone()],
            verb: "point",
            slots: vec![(Slot::Along, along)],
        }));
        point_along(declarations, &pivot, &bead, &rail);
        declarations.remove(level);
    }
}

/// What slides or moves, and along what, if that is such a thing.
pub(super) fn sliding(
    statement: &Statement,
    is_rail: impl Fn(Slot, &str) -> bool,
) -> Option<(Term, Term)> {
    let Statement::Does {
        subjects,
        verb: "slide" | "move",
        slots,
    } = statement
    else {
        return None;
    };
    let [bead] = subjects.as_slice() else {
        return None;
    };
    let rail = slots.iter().find_map(|(slot, rail)| match rail {
        Term::Name(name) if is_rail(*slot, name) => Some(rail),
        _ => None,
    })?;
    Some((bead.clone(), rail.clone()))
}

/// "The rod is horizontal": what turns about the vertical then lies across it.
fn is_level(statement: &Statement, rail: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } => what.head == "horizontal" && subjects.contains(rail),
        _ => false,
    }
}

/// The point about which a body turns.
fn pivot(statement: &Statement, rail: &Term) -> Option<Term> {
    let (subjects, slots) = statement.does("turn")?;
    let about = slots.iter().find(|(slot, _)| *slot == Slot::About);
    match about {
        Some((_, Term::Phrase(axis))) if subjects == [rail.clone()] => {
            axis.slot(Slot::Through).cloned()
        }
        _ => None,
    }
}

/// "the unit vector from O to the bead" is along the body.
fn point_along(declarations: &mut [Declaration], from: &Term, to: &Term, rail: &Term) {
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head == UNIT_VECTOR
            && what.slot(Slot::From) == Some(from)
            && what.slot(Slot::To) == Some(to)
            && let Term::Phrase(along) = axis(LONG, Some(rail))
        {
            *what = *along;
        }
    }
}

/// Whether a sentence says that something slides without friction.
pub(super) fn slides_smoothly(bead: &Term, declarations: &[Declaration]) -> bool {
    let smooth = |how: &Term| how.is_noun(WITHOUT_FRICTION);
    declarations.iter().any(|d| match &d.statement {
        Statement::Does {
            subjects, slots, ..
        } => subjects.contains(bead) && slots.iter().any(|(_, how)| smooth(how)),
        Statement::Is { subjects, what } => {
            subjects.contains(bead) && what.all(Slot::With).any(smooth)
        }
        _ => false,
    })
}

/// Whether sentences speak of other loads than weights and what the body does along which something slides.
pub(super) fn has_other_loads(rail: &Term, declarations: &[Declaration]) -> bool {
    let usual = |load: &Term| match load {
        Term::Phrase(load) => load.head == WEIGHT || load.slot(Slot::Of) == Some(rail),
        _ => false,
    };
    declarations.iter().any(|d| match &d.statement {
        Statement::Does { verb: "act", .. } => true,
        Statement::Premise(premise) if premise.is("only") => !premise.all(Slot::With).all(usual),
        _ => false,
    })
}

/// That a thing moves without friction is said of its motion.
pub(super) fn leave_manner(thing: &Term, declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && subjects.contains(thing)
        {
            what.slots.retain(|(_, how)| !how.is_noun(WITHOUT_FRICTION));
        }
    }
}

/// "No force acts on the bead along the rod, except its weight."
pub(super) fn no_force_along(bead: &Term, along: Term) -> Statement {
    let weight = Term::Phrase(Box::new(NounPhrase::new(WEIGHT, vec![])));
    let except = NounPhrase::new("except", vec![(Slot::Of, weight)]);
    let slots = vec![
        (Slot::Of, bead.clone()),
        (Slot::Along, along),
        (Slot::With, Term::Phrase(Box::new(except))),
    ];
    let mut none = NounPhrase::new(FORCE, slots);
    none.adjectives.push("no");
    Statement::Premise(none)
}
