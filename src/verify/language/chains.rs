//! Chains of numbered things: "frame `$i$` is fixed in link `$i$`, joint `$i$` is fixed in link `$i-1$` and in link `$i$`". Where
//! sentences speak of neighbours, each thing is one of its own, called by its number.

use super::chain_letters::{is_told_for_each, letters_of_others};
use super::heads::UNIT_VECTOR;
use super::messages::{number_of_frame, numbered_frame};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use crate::notation::Macros;
use std::collections::BTreeSet;

/// The neighbours in a chain, by what their numbers have behind the letter.
pub(super) const NEIGHBOURS: [&str; 3] = ["-1", "", "+1"];

/// Gives the things of a chain their names. What a sentence says of the frames and joints with any number it says of the
/// neighbours that others speak of.
pub(crate) fn name_chains(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let terms = || declarations.iter().flat_map(|d| d.statement.terms());
    let among_frames = || {
        let mut letters = terms().filter_map(beside_letter);
        letters.find(|letter| declarations.iter().any(|d| is_frame(&d.statement, letter)))
    };
    let Some(letter) = terms().find_map(neighbour).or_else(among_frames) else {
        return;
    };
    if declarations
        .iter()
        .any(|d| means_other(&d.statement, &letter))
    {
        return;
    }
    let things: BTreeSet<String> = terms().filter_map(|term| thing(term, &letter)).collect();
    let mut told = letters_of_others(declarations, &letter, &things, macros);
    for mut declaration in declarations.drain(..) {
        let counting = declaration.statement.does("number");
        let counts = counting.is_some_and(|(subjects, _)| counts_by(subjects, &letter));
        if counts || is_told_for_each(&declaration, &told) {
            continue;
        }
        without_any(&mut declaration.statement, &letter);
        if places_in_chain(&declaration.statement) {
            for by in ["-1", "+1"] {
                let shifted = shifted(&declaration.statement, &letter, by);
                let known = shifted.filter(|s| are_known(s, &letter, &things));
                told.extend(known.map(|s| declaration.saying(s)));
            }
        }
        told.push(declaration);
    }
    for declaration in &mut told {
        name_all(&mut declaration.statement, &letter);
        if let Some(fixed) = fixed_axis(&declaration.statement) {
            declaration.statement = fixed;
        }
        carry_frames(&mut declaration.statement);
    }
    told.extend(unit_vectors(&told));
    *declarations = told;
}

/// The name of a numbered thing: "link i-1". A number alone is that of a frame.
pub(super) fn thing(term: &Term, letter: &str) -> Option<String> {
    let (family, index) = match term {
        Term::Member { family, index } => (family.as_str(), index),
        Term::Formula(index) => ("frame", of_chain(index, letter)?),
        Term::Phrase(phrase) => match phrase.slots.as_slice() {
            [(Slot::Which, Term::Numbers(numbers))] if phrase.head == "frame" => {
                return numbers
                    .first()
                    .map(|number| numbered_frame(&number.to_string()));
            }
            _ => ("frame", of_chain(index_of_frame(phrase)?, letter)?),
        },
        _ => return None,
    };
    Some(format!("{family} {}", number(index)))
}

/// "frame `$i-1$`"
fn index_of_frame(phrase: &NounPhrase) -> Option<&Formula> {
    match (phrase.head, phrase.slots.as_slice()) {
        ("frame", [(Slot::Which, Term::Formula(index))]) => Some(index),
        _ => None,
    }
}

fn of_chain<'f>(index: &'f Formula, letter: &str) -> Option<&'f Formula> {
    let number = number(index);
    let behind = number.strip_prefix(letter)?;
    NEIGHBOURS.contains(&behind).then_some(index)
}

fn number(index: &Formula) -> String {
    let sign = |c: &char| !c.is_whitespace() && !"{}".contains(*c);
    index.source.chars().filter(sign).collect()
}

/// The letter that counts, where a thing is the one before another or behind it.
fn neighbour(term: &Term) -> Option<String> {
    let index = match term {
        Term::Member { index, .. } => index,
        Term::Phrase(phrase) => index_of_frame(phrase)?,
        _ => return None,
    };
    beside(index)
}

/// The letter of "`$i+1$`", where nothing says of what that is the number.
fn beside_letter(term: &Term) -> Option<String> {
    match term {
        Term::Formula(index) => beside(index),
        _ => None,
    }
}

fn beside(index: &Formula) -> Option<String> {
    let index = number(index);
    let letter = index.strip_suffix("+1").or(index.strip_suffix("-1"))?;
    (letter.len() == 1).then(|| letter.to_owned())
}

/// "Frame `$i$` is a frame": the letter alone stands for it.
pub(super) fn is_frame(statement: &Statement, letter: &str) -> bool {
    match statement {
        Statement::Is { subjects, what } => what.head == "frame" && counts_by(subjects, letter),
        _ => false,
    }
}

/// Whether a sentence says that the letter is something else: a unit vector.
fn means_other(statement: &Statement, letter: &str) -> bool {
    match statement {
        Statement::Is { subjects, what } => {
            let own = |term: &Term| matches!(term, Term::Formula(own) if own.source == letter);
            what.head != "frame" && subjects.iter().any(own)
        }
        _ => false,
    }
}

/// "`$i$` numbers the links": each is called by its number anyway.
fn counts_by(subjects: &[Term], letter: &str) -> bool {
    matches!(subjects, [Term::Formula(counting)] if counting.source == letter)
}

/// Leaves out "for any `$i$`".
fn without_any(statement: &mut Statement, letter: &str) {
    let any = |(slot, term): &(Slot, Term)| {
        *slot == Slot::ForAny && matches!(term, Term::Formula(any) if any.source == letter)
    };
    match statement {
        Statement::Is { what, .. } => what.slots.retain(|said| !any(said)),
        Statement::Does { slots, .. } => slots.retain(|said| !any(said)),
        _ => {}
    }
}

/// Whether a sentence says in what a frame or a joint is fixed.
fn places_in_chain(statement: &Statement) -> bool {
    match statement {
        Statement::Is { what, .. } => {
            matches!(what.head, "frame" | "point") && what.slot(Slot::FixedIn).is_some()
        }
        _ => false,
    }
}

/// Whether other sentences speak of what a statement is about.
fn are_known(statement: &Statement, letter: &str, things: &BTreeSet<String>) -> bool {
    let mut subjects = statement.subjects().iter();
    subjects.all(|term| thing(term, letter).is_some_and(|thing| things.contains(&thing)))
}

/// A statement about the next things of the chain, or about those before.
fn shifted(statement: &Statement, letter: &str, by: &str) -> Option<Statement> {
    let mut shifted = statement.clone();
    let mut terms = shifted.terms_mut().into_iter();
    terms.all(|term| shift(term, letter, by)).then_some(shifted)
}

/// Shifts the numbers of a term, if the chain has what it would be about then.
fn shift(term: &mut Term, letter: &str, by: &str) -> bool {
    let index = match term {
        Term::Member { index, .. } => index,
        Term::Formula(index) if of_chain(index, letter).is_some() => index,
        Term::Phrase(phrase) => {
            let mut terms = phrase.slots.iter_mut().map(|(_, term)| term);
            return terms.all(|term| shift(term, letter, by));
        }
        _ => return true,
    };
    let number = number(index);
    let behind = number.strip_prefix(letter);
    let place = behind.and_then(|behind| NEIGHBOURS.iter().position(|n| *n == behind));
    let next = place.and_then(|at| match by {
        "+1" => at.checked_add(1),
        _ => at.checked_sub(1),
    });
    match next.and_then(|at| NEIGHBOURS.get(at)) {
        Some(behind) => {
            index.source = format!("{letter}{behind}");
            true
        }
        None => !number.contains(letter),
    }
}

/// Calls things by their numbers, and the axes of joints by the joints.
fn name(term: &mut Term, letter: &str) {
    if let Some(thing) = thing(term, letter) {
        *term = Term::Name(thing);
        return;
    }
    let Term::Phrase(phrase) = term else {
        return;
    };
    let things = phrase
        .slots
        .iter_mut()
        .filter(|(slot, _)| *slot != Slot::Which);
    things.for_each(|(_, term)| name(term, letter));
    if let ("axis", [(Slot::Of, Term::Name(joint))]) = (phrase.head, phrase.slots.as_slice())
        && let Some(axis) = joint_axis(joint)
    {
        *term = Term::Formula(axis);
    }
}

fn name_in(slots: &mut Vec<(Slot, Term)>, letter: &str) {
    let behind: Vec<_> = slots
        .iter_mut()
        .flat_map(|(_, term)| behind_number(term))
        .collect();
    slots.extend(behind);
    let things = slots.iter_mut().filter(|(slot, _)| *slot != Slot::Which);
    things.for_each(|(_, term)| name(term, letter));
}

/// Gives all things of a statement their names.
fn name_all(statement: &mut Statement, letter: &str) {
    match statement {
        Statement::Is { subjects, what } => {
            subjects.iter_mut().for_each(|term| name(term, letter));
            name_in(&mut what.slots, letter);
        }
        Statement::Does {
            subjects, slots, ..
        } => {
            subjects.iter_mut().for_each(|term| name(term, letter));
            name_in(slots, letter);
        }
        Statement::Same { subjects, others } => {
            let terms = subjects.iter_mut().chain(others);
            terms.for_each(|term| name(term, letter));
        }
        Statement::Premise(premise) => name_in(&mut premise.slots, letter),
        _ => {}
    }
}

/// "of frame `$i$` relative to frame 0": what stands behind the number hangs on the noun before.
fn behind_number(term: &mut Term) -> Vec<(Slot, Term)> {
    match term {
        // "the velocity of the origin of frame `$i$` relative to frame 0"
        Term::Phrase(of) if of.head == "origin" => {
            let slots = of.slots.iter_mut();
            slots.flat_map(|(_, term)| behind_number(term)).collect()
        }
        Term::Phrase(frame) if frame.head == "frame" && frame.slot(Slot::Which).is_some() => {
            let number = frame
                .slots
                .iter()
                .position(|(slot, _)| *slot == Slot::Which);
            let mut behind = std::mem::take(&mut frame.slots);
            frame.slots.extend(number.map(|at| behind.remove(at)));
            behind
        }
        _ => vec![],
    }
}

/// The letter of the axis of a joint begins so.
const AXIS: &str = "a_{\\text{joint ";

/// The letter of the axis of a joint.
fn joint_axis(joint: &str) -> Option<Formula> {
    let number = joint.strip_prefix("joint ")?;
    formula(&format!("{AXIS}{number}}}}}"), false, &Macros::default())
}

/// "The axis of joint `$i$` is fixed in frame `$i-1$` and in frame `$i$`": a unit vector is.
fn fixed_axis(statement: &Statement) -> Option<Statement> {
    let Statement::Premise(premise) = statement else {
        return None;
    };
    let Some(Term::Name(joint)) = premise.slot(Slot::Of) else {
        return None;
    };
    let axis = joint_axis(joint).filter(|_| premise.head == "axis" && premise.is("fixed"))?;
    let fixed = premise.all(Slot::FixedIn);
    let fixed = fixed.map(|frame| (Slot::FixedIn, frame.clone()));
    let what = NounPhrase::new(UNIT_VECTOR, fixed.collect());
    Some(Statement::one_is(Term::Formula(axis), what))
}

/// "Frame 3 is fixed in link 2": it is a frame that is.
fn carry_frames(statement: &mut Statement) {
    if let Statement::Is { subjects, what } = statement
        && what.head == "fixed"
        && what.slot(Slot::FixedIn).is_some()
        && subjects
            .iter()
            .all(|s| matches!(s, Term::Name(n) if number_of_frame(n).is_some()))
    {
        what.head = "frame";
    }
}

fn is_joint_axis(term: &Term) -> bool {
    matches!(term, Term::Formula(letter) if letter.source.starts_with(AXIS))
}

/// The axes of joints are unit vectors, where no sentence says in what they are fixed.
fn unit_vectors(told: &[Declaration]) -> Vec<Declaration> {
    let subjects = told.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, .. } => subjects.as_slice(),
        _ => &[],
    });
    let letters = subjects.filter_map(|term| match term {
        Term::Formula(letter) => Some(letter.source.as_str()),
        _ => None,
    });
    let mut axes: BTreeSet<&str> = letters.collect();
    let mut declarations = vec![];
    for declaration in told {
        for term in declaration.statement.terms() {
            if let Term::Formula(axis) = term
                && is_joint_axis(term)
                && axes.insert(axis.source.as_str())
            {
                let what = NounPhrase::new(UNIT_VECTOR, vec![]);
                let said = Statement::one_is(term.clone(), what);
                declarations.push(declaration.saying(said));
            }
        }
    }
    declarations
}
