//! Loads that are absent along several axes.

use super::statement::{Declaration, NounPhrase, Slot, Statement};
use super::terms::say_besides;

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
