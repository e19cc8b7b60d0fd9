//! Small oscillations of which a sentence does not say what oscillates: "the period of small oscillations about `$\theta=0$`".

use super::at_zero::angle_of_turn;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;

const OSCILLATION: &str = "oscillation";

/// Names the letter: that of the place about which it is, or the only angle by which anything turns.
pub(super) fn name_oscillations(declarations: &mut [Declaration], macros: &Macros) {
    let only = only_angle(declarations);
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        for (slot, term) in &mut what.slots {
            if let (Slot::Of, Term::Phrase(oscillation)) = (slot, term)
                && oscillation.head == OSCILLATION
            {
                name_one(oscillation, only.as_ref(), macros);
            }
        }
    }
}

fn name_one(oscillation: &mut NounPhrase, only: Option<&Formula>, macros: &Macros) {
    let place = oscillation
        .slots
        .iter()
        .find_map(|(slot, term)| match term {
            Term::Formula(place) if *slot == Slot::About => place.source.strip_suffix("=0"),
            _ => None,
        });
    let about = place.and_then(|letter| formula(letter.trim(), false, macros));
    let known = match (oscillation.slots.as_slice(), about) {
        ([], _) => only.cloned(),
        ([_], Some(about)) => Some(about),
        ([(Slot::Of, Term::Formula(of)), _] | [_, (Slot::Of, Term::Formula(of))], Some(about)) => {
            (of.source.trim() == about.source.trim()).then_some(about)
        }
        _ => None,
    };
    if let Some(letter) = known {
        oscillation.slots = vec![(Slot::Of, Term::Formula(letter))];
    }
}

/// The one angle by which sentences say that something turns.
fn only_angle(declarations: &[Declaration]) -> Option<Formula> {
    let mut angles = declarations.iter().filter_map(|d| {
        let (_, slots) = d.statement.does("turn")?;
        angle_of_turn(slot(slots, Slot::By)?)
    });
    let first = angles.next()?;
    angles
        .all(|other| other.source == first.source)
        .then(|| first.clone())
}
