//! "the constant rate `$\Omega$`" says of the letter that it is constant.

use super::heads::CONSTANT;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// Adjectives of what does not change.
const UNCHANGING: [&str; 2] = [CONSTANT, "steady"];

/// Says of letters that they are constant, in a sentence of its own, where an adjective does.
pub(crate) fn tell_constants(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let mut letters = vec![];
        match statement {
            Statement::Is { subjects, what } if what.head != CONSTANT => {
                if subjects.iter().all(is_formula) && take_adjective(what) {
                    letters.extend(subjects.iter().cloned());
                }
                constant_in(&mut what.slots, &mut letters);
            }
            Statement::Does { slots, .. } => constant_in(slots, &mut letters),
            _ => {}
        }
        let said = (!letters.is_empty()).then(|| Statement::Is {
            subjects: letters,
            what: NounPhrase::new(CONSTANT, vec![]),
        });
        said.into_iter().collect()
    });
}

fn take_adjective(phrase: &mut NounPhrase) -> bool {
    let said = phrase.adjectives.len();
    phrase.adjectives.retain(|a| !UNCHANGING.contains(a));
    phrase.adjectives.len() < said
}

fn constant_in(slots: &mut [(Slot, Term)], letters: &mut Vec<Term>) {
    for (_, term) in slots {
        if let Term::Phrase(phrase) = term {
            let own: Vec<Term> = phrase.all(Slot::Which).cloned().collect();
            let named = !own.is_empty() && own.iter().all(is_formula);
            if named && take_adjective(phrase) {
                letters.extend(own);
            }
            constant_in(&mut phrase.slots, letters);
        }
    }
}

fn is_formula(term: &Term) -> bool {
    matches!(term, Term::Formula(_))
}
