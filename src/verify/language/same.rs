//! What a sentence takes from the one before: "the same vector in components on N", "the Coriolis force and … on P in A".

use super::corresponding::tell_corresponding;
use super::heads::{ACCELERATION, ANGULAR_VELOCITY, POSITION, UNIT_VECTOR, VELOCITY};
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;

/// Nouns of quantities of which a list may say once whose they are.
const SHARING: [&str; 8] = [
    "Coriolis force",
    "centrifugal force",
    "Euler force",
    POSITION,
    VELOCITY,
    ACCELERATION,
    ANGULAR_VELOCITY,
    "angular acceleration",
];

/// "`$u$` is the same vector in components on N": what the sentence before says of its letter, on other axes.
pub(crate) fn tell_the_same(declarations: &mut Vec<Declaration>) {
    tell_corresponding(declarations);
    for at in 1..declarations.len() {
        let (before, rest) = declarations.split_at_mut(at);
        let Statement::Is { what, .. } = &mut rest[0].statement else {
            continue;
        };
        let (own, on) = inner(what);
        let (Some(on), true) = (on, own.is("same")) else {
            continue;
        };
        let told = before.iter().rev().find_map(|d| match &d.statement {
            Statement::Is { subjects, what } => match subjects.as_slice() {
                [letter @ Term::Formula(_)] => Some((letter, inner(what).0)),
                _ => None,
            },
            _ => None,
        });
        let like = |(_, told): &(&Term, &NounPhrase)| {
            let kind = own.head == told.head || own.head == "vector";
            kind && told.slot(Slot::ForAny).is_none()
        };
        let Some((letter, told)) = told.filter(like) else {
            continue;
        };
        // A vector that may be any is known by its letter alone.
        let mut same = match told.head {
            "vector" | UNIT_VECTOR => {
                NounPhrase::new("vector", vec![(Slot::Which, letter.clone())])
            }
            _ => told.clone(),
        };
        same.slots.retain(|(slot, _)| *slot != Slot::On);
        same.slots.push((Slot::On, on));
        *what = same;
    }
}

/// "`$u$` is the column of the components on N of the velocity of P": the velocity in components on N; and "the entry in row
/// `$j$` and column `$k$` of `$C$`" by its numbers.
pub(crate) fn tell_columns(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let Statement::Is { what, .. } = &mut declaration.statement else {
            continue;
        };
        match (what.head, inner(what)) {
            ("column", (quantity, Some(on))) if quantity.head != "column" => {
                let mut quantity = quantity.clone();
                quantity.slots.retain(|(slot, _)| *slot != Slot::On);
                quantity.slots.push((Slot::On, on));
                *what = quantity;
            }
            ("entry", _) => {
                if let Some(entry) = entry_by_numbers(what) {
                    *what = entry;
                }
            }
            _ => {}
        }
    }
}

fn entry_by_numbers(what: &NounPhrase) -> Option<NounPhrase> {
    let place = |noun: &str| {
        what.slots.iter().find_map(|(_, term)| match term {
            Term::Phrase(place) if place.head == noun => Some(place),
            _ => None,
        })
    };
    let (row, column) = (place("row")?, place("column")?);
    let of = column.slot(Slot::Of).or(what.slot(Slot::Of))?;
    let number = |place: &NounPhrase| match place.slot(Slot::Which)? {
        Term::Formula(letter) => Some(Term::Name(letter.source.clone())),
        other => Some(other.clone()),
    };
    let slots = vec![
        (Slot::Which, number(row)?),
        (Slot::Which, number(column)?),
        (Slot::Of, of.clone()),
    ];
    Some(NounPhrase::new("entry", slots))
}

/// "`$h$` means `$J\Omega$`": a letter of which nothing else is told is that.
pub(crate) fn name_by_formulas(declarations: &mut [Declaration]) {
    let told: Vec<Term> = declarations
        .iter()
        .filter(|d| matches!(d.statement, Statement::Is { .. }))
        .flat_map(|d| d.statement.subjects().to_vec())
        .collect();
    for declaration in declarations {
        let Statement::Means { written, meaning } = &declaration.statement else {
            continue;
        };
        let letter = Term::Formula(written.clone());
        if is_letter(written) && !told.contains(&letter) {
            declaration.statement = Statement::Same {
                subjects: vec![letter],
                others: vec![Term::Formula(meaning.clone())],
            };
        }
    }
}

/// "`$td1$` is the same as `$\\dot\\theta_1$`" names a letter of several signs, which formulas read as a product: nothing can be
/// made of it.
pub(crate) fn leave_long_names(declarations: &mut [Declaration]) {
    for declaration in declarations {
        let subjects = declaration.statement.subjects();
        let long = |subject: &Term| match subject {
            Term::Formula(formula) => !is_letter(formula) && is_long_name(&formula.source),
            _ => false,
        };
        if subjects.iter().any(long) {
            *declaration = declaration.clone().not_understood();
        }
    }
}

/// Letters and then digits, with nothing between them.
fn is_long_name(source: &str) -> bool {
    let name = source.trim();
    let digits = name.trim_start_matches(|c: char| c.is_ascii_alphabetic());
    let own = digits.len() < name.len() && !digits.is_empty();
    own && digits.chars().all(|c| c.is_ascii_digit())
}

/// "`$M = c$` is the moment on the body": M is it, and the relation holds.
pub(crate) fn tell_relations(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, .. } = statement else {
            return vec![];
        };
        let [Term::Formula(relation)] = subjects.as_slice() else {
            return vec![];
        };
        let Row::Line(line) = &relation.row else {
            return vec![];
        };
        let letter = match line.sides.as_slice() {
            [letter, value] if !has_list(value) => Formula::of(letter),
            _ => return vec![],
        };
        if !is_letter(&letter) {
            return vec![];
        }
        let holds = Statement::Holds(relation.clone());
        *subjects = vec![Term::Formula(letter)];
        vec![holds]
    });
}

/// Whether numbers stand in a list: what they are may be said of each.
fn has_list(node: &Node) -> bool {
    let own = matches!(node.kind, Kind::Tuple(_) | Kind::Matrix(_));
    own || node.children().any(has_list)
}

fn is_letter(formula: &Formula) -> bool {
    match &formula.row {
        Row::Expression(node) => matches!(node.kind, Kind::Symbol(_)),
        _ => false,
    }
}

/// A quantity inside "the column of the components on B of …", and on which frame it has components.
fn inner(what: &NounPhrase) -> (&NounPhrase, Option<Term>) {
    let on = what.slot(Slot::On).cloned();
    match (what.head, what.slot(Slot::Of)) {
        ("column" | "component", Some(Term::Phrase(of))) => {
            let (what, own) = inner(of);
            (what, own.or(on))
        }
        _ => (what, on),
    }
}

/// "`$a$` is the velocity, `$b$` the acceleration of P relative to N": the last one says of all what they are of.
pub(crate) fn share_owners(declarations: &mut [Declaration]) {
    for at in (1..declarations.len()).rev() {
        let (before, rest) = declarations.split_at_mut(at);
        let (one, next) = (&mut before[at - 1], &rest[0]);
        let joined = one.line == next.line && one.text == next.text && one.extent == next.extent;
        if let (Statement::Is { what, .. }, Statement::Is { what: last, .. }, true) =
            (&mut one.statement, &next.statement, joined)
            && SHARING.contains(&what.head)
            && SHARING.contains(&last.head)
            && what.slots.is_empty()
            && last.slot(Slot::Of).is_some()
        {
            what.slots.clone_from(&last.slots);
        }
    }
}
