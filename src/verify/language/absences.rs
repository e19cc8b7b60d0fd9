//! What is absent: loads along several axes, and the mass of a thing.

use super::heads::FRICTION;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// The nouns of what a thing is without that weighs nothing.
const MASS: &str = "mass";

/// "The axle has no mass", "the mass of the axle is neglected": the axle is massless. "The track has no friction": it is
/// smooth.
pub(super) fn tell_absences(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Some((things, without)) = without(&declaration.statement) {
            declaration.statement = Statement::Is {
                subjects: things,
                what: NounPhrase::new(without, vec![]),
            };
        } else if let Some(zero) = no_component(&declaration.statement) {
            declaration.statement = zero;
        }
    }
}

/// The things that have something not, and the adjective for that.
fn without(statement: &Statement) -> Option<(Vec<Term>, &'static str)> {
    match statement {
        Statement::Does {
            subjects,
            verb: "have",
            slots,
        } => match slots.as_slice() {
            [(_, Term::Phrase(absent))] if absent.is("no") && absent.slots.is_empty() => {
                let adjective = match absent.head {
                    MASS => "massless",
                    FRICTION => "smooth",
                    _ => return None,
                };
                Some((subjects.clone(), adjective))
            }
            _ => None,
        },
        Statement::Is { subjects, what } if what.head == "zero" && what.slots.is_empty() => {
            let [Term::Phrase(mass)] = subjects.as_slice() else {
                return None;
            };
            let things = mass.all(Slot::Of).cloned().collect();
            (mass.head == MASS).then_some((things, "massless"))
        }
        _ => None,
    }
}

/// "The force at P has no component along y": that component of it is zero.
fn no_component(statement: &Statement) -> Option<Statement> {
    let (subjects, slots) = statement.does("have")?;
    let [(_, Term::Phrase(absent))] = slots else {
        return None;
    };
    let along = |said: &(Slot, Term)| matches!(said.0, Slot::Along | Slot::On | Slot::Which);
    let plain = absent.head == "component" && absent.adjectives == ["no"];
    if !plain || absent.slots.is_empty() || !absent.slots.iter().all(along) {
        return None;
    }
    let component = |of: &Term| {
        let of = std::iter::once((Slot::Of, of.clone()));
        let slots = of.chain(absent.slots.iter().cloned()).collect();
        Term::Phrase(Box::new(NounPhrase::new("component", slots)))
    };
    Some(Statement::Is {
        subjects: subjects.iter().map(component).collect(),
        what: NounPhrase::new("zero", vec![]),
    })
}

/// "No moment acts on the rotor along p and along q": none along p, and none along q.
pub(super) fn part_absences(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Premise(absent) = statement else {
            return vec![];
        };
        if !absent.is("no") {
            return vec![];
        }
        let several = absent.all(Slot::Along).count();
        let along = |number: usize| only_along(absent, number);
        let others: Vec<NounPhrase> = (1..several).map(along).collect();
        *absent = along(0);
        others.into_iter().map(Statement::Premise).collect()
    });
}

/// The same along only one of its axes.
fn only_along(absent: &NounPhrase, number: usize) -> NounPhrase {
    let mut seen = 0;
    let mut single = absent.clone();
    single.slots.retain(|(slot, _)| {
        seen += usize::from(*slot == Slot::Along);
        *slot != Slot::Along || seen == number + 1
    });
    single
}
