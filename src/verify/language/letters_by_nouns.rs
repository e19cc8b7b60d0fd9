//! Letters that stand behind their nouns where they are said to be something else: "the rolling moment `$L$`, the pitching
//! moment `$M$` and the yawing moment `$N$` are the components of …", "the total moment `$L$` acts on the body about G".

use super::heads::{FORCE, MOMENT};
use super::is_body;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// A noun that says of a body nothing but how fast it moves: the components by which its letters are told say more.
const RATE: &str = "rate";

/// Says of the letters what is said of their nouns.
pub(crate) fn say_of_letters(declarations: &mut Vec<Declaration>) {
    let told = declarations.drain(..).flat_map(|declaration| {
        let said = components(&declaration.statement).or_else(|| total(&declaration.statement));
        match said {
            Some(said) => said.into_iter().map(|s| declaration.saying(s)).collect(),
            None => vec![declaration],
        }
    });
    let told: Vec<Declaration> = told.collect();
    *declarations = told;
}

/// "The rates `$p$`, `$q$`, `$r$` are the components of `$w$` on B": the letters are. What else hangs on their nouns is said
/// besides.
fn components(statement: &Statement) -> Option<Vec<Statement>> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let by_noun = subjects.iter().any(|s| matches!(s, Term::Phrase(_)));
    if what.head != "component" || !by_noun {
        return None;
    }
    let (mut letters, mut besides) = (vec![], vec![]);
    for subject in subjects {
        match subject {
            Term::Formula(_) => letters.push(subject.clone()),
            Term::Phrase(noun) => {
                let (own, rest) = letters_of(noun)?;
                if !says_nothing(&rest) {
                    besides.push(Statement::Is {
                        subjects: own.clone(),
                        what: rest,
                    });
                }
                letters.extend(own);
            }
            _ => return None,
        }
    }
    let what = what.clone();
    besides.push(Statement::Is {
        subjects: letters,
        what,
    });
    Some(besides)
}

/// The letters behind a noun, and the noun without them.
fn letters_of(noun: &NounPhrase) -> Option<(Vec<Term>, NounPhrase)> {
    let letters: Vec<Term> = noun.all(Slot::Which).cloned().collect();
    let formulas = letters.iter().all(|t| matches!(t, Term::Formula(_)));
    let mut rest = noun.clone();
    rest.slots.retain(|(slot, _)| *slot != Slot::Which);
    (formulas && !letters.is_empty()).then_some((letters, rest))
}

fn says_nothing(noun: &NounPhrase) -> bool {
    let body = |(slot, term): &(Slot, Term)| {
        let thing = match term {
            Term::Name(_) => true,
            Term::Phrase(thing) => is_body(thing.head),
            _ => false,
        };
        *slot == Slot::Of && thing
    };
    noun.slots.is_empty() || noun.head == RATE && noun.slots.iter().all(body)
}

/// "The total moment `$L$` acts on the body about G": no load acts besides, the letter is that of them all.
fn total(statement: &Statement) -> Option<Vec<Statement>> {
    let (subjects, slots) = statement.does("act")?;
    let [Term::Phrase(load)] = subjects else {
        return None;
    };
    let summed = matches!(load.head, FORCE | MOMENT) && load.is("total");
    let told = |(slot, _): &(Slot, Term)| matches!(slot, Slot::Of | Slot::Upon | Slot::About);
    let (letters, mut what) = letters_of(load)?;
    if !summed || letters.len() != 1 || !slots.iter().all(told) {
        return None;
    }
    for (slot, term) in slots {
        let slot = match slot {
            Slot::Upon => Slot::Of,
            other => *other,
        };
        what.slots.push((slot, term.clone()));
    }
    Some(vec![Statement::Is {
        subjects: letters,
        what,
    }])
}
