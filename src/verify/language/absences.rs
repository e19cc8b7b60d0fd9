//! What is absent: loads along several axes, and the mass of a thing.

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// The nouns of what a thing is without that weighs nothing.
const MASS: &str = "mass";

/// "The axle has no mass", "the mass of the axle is neglected": the axle is massless.
pub(super) fn tell_massless(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let things = match &declaration.statement {
            Statement::Does {
                subjects,
                verb: "have",
                slots,
            } => match slots.as_slice() {
                [(_, Term::Phrase(mass))] if mass.head == MASS && mass.is("no") => subjects.clone(),
                _ => continue,
            },
            Statement::Is { subjects, what } if what.head == "zero" && what.slots.is_empty() => {
                match subjects.as_slice() {
                    [Term::Phrase(mass)] if mass.head == MASS => {
                        mass.all(Slot::Of).cloned().collect()
                    }
                    _ => continue,
                }
            }
            _ => continue,
        };
        let massless = NounPhrase::new("massless", vec![]);
        declaration.statement = Statement::Is {
            subjects: things,
            what: massless,
        };
    }
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
