//! Unit vectors that are told by their components on a frame.

use super::reader::formula;
use super::statement::{Declaration, Extent, Slot, Statement, Term};
use super::turned_lines::direction;
use super::turned_vectors::is_only_a_unit_vector;
use crate::notation::Macros;

/// "`$\sin a$`, `$0$` and `$\cos a$` are the components of the unit vector `$n$` on A": it is `$\sin a\,i+\cos a\,k$`.
pub(super) fn tell_by_components(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let units: Vec<Term> = declarations
        .iter()
        .filter_map(|d| match d.statement.subjects() {
            [unit] if is_only_a_unit_vector(unit, d) => Some(unit.clone()),
            _ => None,
        })
        .collect();
    for unit in units {
        let own = |d: &Declaration| !components(&unit, d, declarations).is_empty();
        let (told, rest): (Vec<_>, Vec<_>) = declarations.iter().cloned().partition(own);
        let parts = told.iter().flat_map(|d| components(&unit, d, declarations));
        let parts: Vec<(String, Term)> = parts.collect();
        let sum = sum_of(&unit, &parts, declarations, macros);
        if let (Some(sum), Some(first)) = (sum, told.first()) {
            let said = first.saying(sum);
            *declarations = rest;
            declarations.retain(|d| !is_only_a_unit_vector(&unit, d));
            declarations.push(said);
        }
    }
}

/// The components of a vector that a sentence tells, each with its axis.
fn components(unit: &Term, said: &Declaration, all: &[Declaration]) -> Vec<(String, Term)> {
    let Statement::Is { subjects, what } = &said.statement else {
        return vec![];
    };
    let own = what.head == "component" && what.slots.len() == 2 && said.extent == Extent::Document;
    if !own || what.slot(Slot::Of) != Some(unit) {
        return vec![];
    }
    let axes: Vec<Term> = match (what.slot(Slot::Along), what.slot(Slot::On)) {
        (Some(axis), None) => vec![axis.clone()],
        (None, Some(frame)) => axes_of(frame, all),
        _ => vec![],
    };
    let sources = subjects.iter().map(|subject| match subject {
        Term::Formula(formula) => Some(formula.source.trim().to_owned()),
        Term::Numbers(numbers) => match numbers.as_slice() {
            [number] => Some(number.to_string()),
            _ => None,
        },
        _ => None,
    });
    match sources.collect::<Option<Vec<String>>>() {
        Some(sources) if sources.len() == axes.len() => sources.into_iter().zip(axes).collect(),
        _ => vec![],
    }
}

fn axes_of(frame: &Term, all: &[Declaration]) -> Vec<Term> {
    let axes = all.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" => {
            (what.slot(Slot::Of) == Some(frame)).then(|| subjects.clone())
        }
        _ => None,
    });
    axes.unwrap_or_default()
}

/// The vector by its components on three axes of a frame, which make one of length one: a sine, a cosine and nothing.
fn sum_of(
    unit: &Term,
    parts: &[(String, Term)],
    all: &[Declaration],
    macros: &Macros,
) -> Option<Statement> {
    let Term::Formula(letter) = unit else {
        return None;
    };
    let mut known: Vec<(usize, Term)> = vec![];
    for (_, axis) in parts {
        let at = direction(axis, all).filter(|axis| !axis.reversed)?;
        known.push((at.number, at.frame));
    }
    let (_, frame) = known.first()?;
    let mut numbers: Vec<usize> = known.iter().map(|(number, _)| *number).collect();
    numbers.sort_unstable();
    let one_frame = known.iter().all(|(_, other)| other == frame);
    if numbers != [1, 2, 3] || !one_frame {
        return None;
    }
    let bare = |source: &String| source.trim_start_matches('-').replace(' ', "");
    let mut sizes: Vec<String> = parts.iter().map(|(source, _)| bare(source)).collect();
    sizes.sort();
    let [zero, cosine, sine] = sizes.as_slice() else {
        return None;
    };
    let (cosine, sine) = (cosine.strip_prefix("\\cos")?, sine.strip_prefix("\\sin")?);
    if zero != "0" || cosine != sine {
        return None;
    }
    let mut terms = vec![];
    for (source, axis) in parts {
        let Term::Formula(axis) = axis else {
            return None;
        };
        if bare(source) != "0" {
            terms.push(format!("({source})\\,{}", axis.source));
        }
    }
    let sum = format!("{}={}", letter.source, terms.join("+"));
    formula(&sum, false, macros).map(Statement::Holds)
}
