//! "`$p i+q j+r k$` is the angular velocity of B relative to N": the letters are its components on the frame of these axes.

use super::heads::{ACCELERATION, ANGULAR_VELOCITY, VELOCITY};
use super::statement::{Declaration, Extent, Formula, NounPhrase, Slot, Statement, Term};
use super::told_vectors::alike;
use crate::notation::ast::{Kind, Node};

/// Vectors that are told so.
const VECTORS: [&str; 3] = [ANGULAR_VELOCITY, VELOCITY, ACCELERATION];

/// Says of the letters in such a sum that they are components.
pub(super) fn tell_vectors_by_sums(declarations: &mut [Declaration]) {
    let frames: Vec<(Vec<Formula>, Term)> = declarations.iter().filter_map(frame_of).collect();
    let told = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, .. } => subjects.clone(),
        _ => vec![],
    };
    let told: Vec<Term> = declarations.iter().flat_map(told).collect();
    for declaration in declarations {
        let whole = declaration.extent == Extent::Document;
        if let Some(plain) = by_components(&declaration.statement, &frames, &told).filter(|_| whole)
        {
            declaration.statement = plain;
        }
    }
}

/// The letters of the three axes of a frame, with it.
fn frame_of(declaration: &Declaration) -> Option<(Vec<Formula>, Term)> {
    let Statement::Is { subjects, what } = &declaration.statement else {
        return None;
    };
    let frame = what.slot(Slot::Of).filter(|_| what.head == "axes")?;
    let letter = |subject: &Term| match subject {
        Term::Formula(letter) => Some(alike(letter)),
        _ => None,
    };
    let axes: Vec<Formula> = subjects.iter().map(letter).collect::<Option<_>>()?;
    (axes.len() == 3).then(|| (axes, frame.clone()))
}

/// The sentence by the letters, where none of them is told of elsewhere.
fn by_components(
    statement: &Statement,
    frames: &[(Vec<Formula>, Term)],
    told: &[Term],
) -> Option<Statement> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let [Term::Formula(sum)] = subjects.as_slice() else {
        return None;
    };
    let node = sum.node().filter(|_| VECTORS.contains(&what.head))?;
    let (letters, frame) = frames
        .iter()
        .find_map(|(axes, frame)| Some((letters_before(node, axes)?, frame)))?;
    let letters: Vec<Term> = letters.into_iter().map(Term::Formula).collect();
    let anew = letters.iter().all(|letter| !told.contains(letter));
    let of = Term::Phrase(Box::new(what.clone()));
    let slots = vec![(Slot::Of, of), (Slot::On, frame.clone())];
    anew.then(|| Statement::Is {
        subjects: letters,
        what: NounPhrase::new("component", slots),
    })
}

/// `p`, `q` and `r` of `p i+q j+r k`, where i, j and k are the axes in their order.
fn letters_before(sum: &Node, axes: &[Formula]) -> Option<Vec<Formula>> {
    let Kind::Sum(terms) = &sum.kind else {
        return None;
    };
    if terms.len() != axes.len() || terms.iter().any(|term| term.negative) {
        return None;
    }
    let letter = |(term, axis): (&Node, &Formula)| {
        let factors: Vec<&Node> = term.children().collect();
        match (&term.kind, factors.as_slice()) {
            (Kind::Product(_), [letter, last]) if matches!(letter.kind, Kind::Symbol(_)) => {
                (Formula::of(last).source == axis.source).then(|| Formula::of(letter))
            }
            _ => None,
        }
    };
    let nodes = terms.iter().map(|term| &term.node);
    nodes.zip(axes).map(letter).collect()
}
