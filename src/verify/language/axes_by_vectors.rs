//! The axis of a body by the letter of the unit vector along it.

use super::heads::UNIT_VECTOR;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// "`$n$` is the unit vector along the axis of the disc": n is a unit vector and the axis of the disc, and what other sentences
/// say of that axis is said of n.
pub(crate) fn name_axes_by_vectors(declarations: &mut Vec<Declaration>) {
    let told: Vec<(NounPhrase, Term)> = declarations.iter().filter_map(named_axis).collect();
    for (axis, letter) in told {
        let own = Term::Phrase(Box::new(axis.clone()));
        // Where two letters are the unit vector they may be against each other.
        let several = declarations.iter().filter_map(named_axis);
        if several.filter(|(other, _)| *other == axis).count() != 1 {
            continue;
        }
        say_besides(declarations, |statement| {
            let Statement::Is { subjects, what } = statement else {
                return vec![];
            };
            if what.head != UNIT_VECTOR || what.slot(Slot::Along) != Some(&own) {
                return vec![];
            }
            *what = NounPhrase::new(UNIT_VECTOR, vec![]);
            vec![Statement::Is {
                subjects: subjects.clone(),
                what: axis.clone(),
            }]
        });
        for declaration in declarations.iter_mut() {
            let is_axis =
                matches!(&declaration.statement, Statement::Is { what, .. } if *what == axis);
            if !is_axis {
                let terms = declaration.statement.terms_mut();
                terms
                    .into_iter()
                    .filter(|term| **term == own)
                    .for_each(|term| *term = letter.clone());
            }
        }
    }
}

/// The axis of a body along which a sentence says a letter to be the unit vector, and the letter.
fn named_axis(declaration: &Declaration) -> Option<(NounPhrase, Term)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let ([letter @ Term::Formula(_)], [(Slot::Along, Term::Phrase(axis))]) =
        (subjects.as_slice(), what.slots.as_slice())
    else {
        return None;
    };
    let of_body = matches!(axis.slots.as_slice(), [(Slot::Of, Term::Name(_))]);
    let named = what.head == UNIT_VECTOR && axis.head == "axis" && of_body;
    named.then(|| ((**axis).clone(), letter.clone()))
}
