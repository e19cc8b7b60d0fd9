//! Letters with the labels of instants: "`$T_1$` and `$T_2$` are the kinetic energy of the body at `$t_1$` and `$t_2$`" says what `$T$`
//! is, where the labels 1 and 2 mean at these instants.

use super::heads::INSTANT;
use super::statement::{
    Declaration, Formula, NotationMeaning, NounPhrase, Sign, Slot, Statement, Term,
};
use crate::notation::ast::Kind;
use crate::notation::document::Row;

/// What sentences say of letters with such labels they say of the letters without them, where no sentence tells these.
pub(crate) fn tell_letters_at_instants(declarations: &mut Vec<Declaration>) {
    let labels = labels_of_instants(declarations);
    if labels.is_empty() {
        return;
    }
    let mut told: Vec<Statement> = vec![];
    let mut at = 0;
    while at < declarations.len() {
        let plain = without_labels(&declarations[at].statement, &labels);
        let plain = plain.filter(|(letter, _)| {
            let same = |d: &Declaration| d.statement.subjects().contains(letter);
            let mut others = declarations.iter().filter(|d| same(d));
            others.all(|d| told.contains(&d.statement))
        });
        match plain {
            Some((_, statement)) if told.contains(&statement) => {
                declarations.remove(at);
            }
            Some((_, statement)) => {
                told.push(statement.clone());
                declarations[at].statement = statement;
                at += 1;
            }
            None => at += 1,
        }
    }
}

/// The labels that mean at an instant, with the letter of that.
fn labels_of_instants(declarations: &[Declaration]) -> Vec<(String, String)> {
    let rules = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Notation {
            sign: Sign::Label { labels, .. },
            meaning: NotationMeaning::Noun(noun),
        } if noun.head == INSTANT => {
            let instants = noun.all(Slot::Which).map(|which| match which {
                Term::Formula(instant) => Some(instant.source.clone()),
                _ => None,
            });
            let instants: Vec<String> = instants.collect::<Option<_>>()?;
            let told = instants.len() == labels.len();
            told.then(|| labels.iter().cloned().zip(instants))
        }
        _ => None,
    });
    rules.flatten().collect()
}

/// The letter without its label, and what is said of it at any time.
fn without_labels(statement: &Statement, labels: &[(String, String)]) -> Option<(Term, Statement)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let instants: Vec<&Term> = what.all(Slot::At).collect();
    let own = instants.iter().map(|instant| match instant {
        Term::Formula(instant) => {
            let rule = labels.iter().find(|(_, known)| *known == instant.source);
            rule.map(|(label, _)| label.as_str())
        }
        _ => None,
    });
    let own: Vec<&str> = own.collect::<Option<_>>()?;
    if own.is_empty() || own.len() != subjects.len() {
        return None;
    }
    let letters = subjects
        .iter()
        .zip(own)
        .map(|(subject, label)| match subject {
            Term::Formula(letter) => without_label(letter, label),
            _ => None,
        });
    let letters: Vec<Formula> = letters.collect::<Option<_>>()?;
    let (first, rest) = letters.split_first()?;
    if rest.iter().any(|other| other.source != first.source) {
        return None;
    }
    let letter = Term::Formula(first.clone());
    let slots = what.slots.iter().filter(|(slot, _)| *slot != Slot::At);
    let plain = NounPhrase {
        slots: slots.cloned().collect(),
        ..what.clone()
    };
    let statement = Statement::one_is(letter.clone(), plain);
    Some((letter, statement))
}

/// A symbol without its only label.
fn without_label(letter: &Formula, label: &str) -> Option<Formula> {
    let Row::Expression(node) = &letter.row else {
        return None;
    };
    let mut node = node.clone();
    let Kind::Symbol(symbol) = &mut node.kind else {
        return None;
    };
    if symbol.subscripts.as_slice() != [label.to_owned()] {
        return None;
    }
    symbol.subscripts.clear();
    Some(Formula::of(&node))
}
