//! How a thing turns or what shape it has, where only a part of the document says it: it is so everywhere.

use super::body_axes::is_size;
use super::heads::EULER_ANGLES;
use super::reader::formula;
use super::statement::{Declaration, Extent, Formula, Slot, Statement, Term};
use crate::notation::Macros;

/// What a sentence tells of how a thing is built.
#[derive(Clone, Copy, PartialEq)]
enum Build {
    Turn,
    Shape,
}

/// "On lines 1 to 9 B turns relative to N about z by the angle `$\theta$`": so B turns, and an angle of its own is θ there.
pub(super) fn built_everywhere(
    mut declarations: Vec<Declaration>,
    macros: &Macros,
) -> Vec<Declaration> {
    let told = (0..declarations.len()).filter_map(|at| {
        let declaration = &declarations[at];
        if declaration.extent == Extent::Document {
            return None;
        }
        let built = built(&declaration.statement);
        let (_, thing) = built.filter(|built| is_told_once(&declarations, built))?;
        let letters = letters(&declaration.statement).into_iter();
        let letters = letters.filter_map(|letter| {
            let own = own_letter(&declarations, at, letter, thing, macros)?;
            Some((letter.clone(), own))
        });
        Some((at, letters.collect()))
    });
    let told: Vec<(usize, Vec<(Formula, Formula)>)> = told.collect();
    for (at, letters) in told {
        let extent = std::mem::replace(&mut declarations[at].extent, Extent::Document);
        for (letter, own) in letters {
            for term in declarations[at].statement.terms_mut() {
                put_in(term, &letter, &own);
            }
            declarations.push(Declaration {
                statement: Statement::Same {
                    subjects: vec![Term::Formula(letter)],
                    others: vec![Term::Formula(own)],
                },
                extent: extent.clone(),
                ..declarations[at].clone()
            });
        }
    }
    declarations
}

/// Writes another letter for one, also in what hangs on a noun.
fn put_in(term: &mut Term, letter: &Formula, other: &Formula) {
    match term {
        Term::Formula(formula) if formula.source == letter.source => *formula = other.clone(),
        Term::Phrase(phrase) => {
            let hanging = phrase.slots.iter_mut();
            hanging.for_each(|(_, term)| put_in(term, letter, other));
        }
        _ => {}
    }
}

/// The thing of which a sentence says how it turns, or what shape with sizes it has.
fn built(statement: &Statement) -> Option<(Build, &Term)> {
    if let Some((subjects, _)) = statement.does("turn") {
        let [frame] = subjects else { return None };
        return Some((Build::Turn, frame));
    }
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    if what.head == EULER_ANGLES {
        return Some((Build::Turn, what.slot(Slot::Of)?));
    }
    let [thing] = subjects.as_slice() else {
        return None;
    };
    match what.head {
        "frame" if what.slot(Slot::About).is_some() => Some((Build::Turn, thing)),
        _ if matches!(thing, Term::Name(_)) && what.slots.iter().any(is_size) => {
            Some((Build::Shape, thing))
        }
        _ => None,
    }
}

fn is_told_once(declarations: &[Declaration], built_so: &(Build, &Term)) -> bool {
    let all = declarations.iter().filter_map(|d| built(&d.statement));
    all.filter(|other| other == built_so).count() == 1
}

/// The letters of angles, rates and sizes that hang on a sentence.
fn letters(statement: &Statement) -> Vec<&Formula> {
    let slots = statement.slots().flatten();
    let told = slots.filter(|(slot, _)| matches!(slot, Slot::By | Slot::At | Slot::Of));
    let angles = match statement {
        Statement::Is { subjects, what } if what.head == EULER_ANGLES => subjects.as_slice(),
        _ => &[],
    };
    let terms = told.map(|(_, term)| term).chain(angles);
    terms.flat_map(formulas_in).collect()
}

/// A formula, or those that hang on a noun.
fn formulas_in(term: &Term) -> Vec<&Formula> {
    match term {
        Term::Formula(letter) => vec![letter],
        Term::Phrase(noun) => {
            let hanging = noun.slots.iter().map(|(_, term)| term);
            hanging.flat_map(formulas_in).collect()
        }
        _ => vec![],
    }
}

/// A letter for an angle or a size whose own one is spoken of in other parts as well.
fn own_letter(
    declarations: &[Declaration],
    at: usize,
    letter: &Formula,
    thing: &Term,
    macros: &Macros,
) -> Option<Formula> {
    let elsewhere = |d: &Declaration| {
        let mut spoken = d.statement.formulas().into_iter();
        d.extent != declarations[at].extent && spoken.any(|f| f.source == letter.source)
    };
    let label = match thing {
        Term::Name(name) => name,
        Term::Formula(name) => &name.source,
        _ => return None,
    };
    let source = format!("{}_{{\\text{{{label}}}}}", letter.source);
    let plain = declarations.iter().any(elsewhere) && !letter.source.contains('_');
    plain.then(|| formula(&source, false, macros)).flatten()
}
