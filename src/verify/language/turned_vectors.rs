//! Unit vectors that are told by their angle with an axis, towards another one.

use super::heads::UNIT_VECTOR;
use super::planar_axes::axis;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::turned_lines::{Direction, direction};
use crate::notation::Macros;

/// A unit vector, and from where it is turned to where by what angle.
struct Turned {
    vector: Formula,
    from: Term,
    towards: Term,
    /// Whether it is turned away from that.
    against: bool,
    angle: Formula,
}

/// "The unit vector `$n$` is turned from x towards y by the angle `$\alpha$`", or from x about z: it is `$\cos\alpha\,x+\sin\alpha\,y$`.
pub(super) fn turn_vectors(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let mut at = 0;
    while at < declarations.len() {
        let turned = turned(&declarations[at].statement, declarations);
        let told = turned.and_then(|turned| {
            let told = statements(&turned, declarations, macros)?;
            Some((Term::Formula(turned.vector), told))
        });
        let Some((vector, told)) = told else {
            at += 1;
            continue;
        };
        let said = declarations.remove(at);
        declarations.retain(|d| !is_only_a_unit_vector(&vector, d));
        declarations.extend(told.into_iter().map(|statement| said.saying(statement)));
    }
}

fn turned(statement: &Statement, declarations: &[Declaration]) -> Option<Turned> {
    let ([Term::Formula(vector)], slots) = statement.does("turn")? else {
        return None;
    };
    let mut rest = slots.to_vec();
    let mut take = |wanted| {
        let at = rest.iter().position(|(slot, _)| *slot == wanted)?;
        Some(rest.remove(at).1)
    };
    let (from, by) = (take(Slot::RelativeTo)?, take(Slot::By)?);
    let (sense, about) = (take(Slot::With), take(Slot::About));
    let (Term::Phrase(by), true) = (by, rest.is_empty()) else {
        return None;
    };
    let first = direction(&from, declarations)?;
    let (towards, against) = match (sense, about) {
        (Some(Term::Phrase(sense)), None) => {
            let towards = sense.slot(Slot::Of)?;
            let second = direction(towards, declarations)?;
            let across = first.frame == second.frame && first.number != second.number;
            (across && !second.reversed).then(|| (towards.clone(), false))?
        }
        (None, Some(about)) => quarter_turned(&first, &direction(&about, declarations)?)?,
        _ => return None,
    };
    let own = Term::Formula(vector.clone());
    let unit = declarations.iter().any(|d| is_only_a_unit_vector(&own, d));
    match by.slot(Slot::Which)? {
        Term::Formula(angle) if unit && !first.reversed => Some(Turned {
            vector: vector.clone(),
            from,
            towards,
            against,
            angle: angle.clone(),
        }),
        _ => None,
    }
}

/// The axis to which a quarter of a turn about another one brings an axis, and whether it comes to be against that.
fn quarter_turned(from: &Direction, about: &Direction) -> Option<(Term, bool)> {
    let apart = (from.number + 3).checked_sub(about.number)? % 3;
    let same = from.frame == about.frame && apart != 0;
    let to = 6_usize.checked_sub(from.number + about.number)?;
    // About the third axis the first one comes to the second.
    let against = (apart == 2) != about.reversed;
    same.then(|| (axis(to, Some(&from.frame)), against))
}

/// The axes by letters of their own, and what the vector is by these.
fn statements(
    turned: &Turned,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<Vec<Statement>> {
    let (vector, angle) = (&turned.vector.source, &turned.angle);
    let letter_of = |place: &str, along: &Term| {
        // An axis that has a letter of its own needs no other one.
        if let Some(Term::Formula(own)) = named_axis(along, declarations) {
            return Some((own.source.clone(), None));
        }
        let letter = formula(&format!("e_{{{place},{vector}}}"), false, macros)?;
        let along = vec![(Slot::Along, along.clone())];
        let what = NounPhrase::new(UNIT_VECTOR, along);
        let source = letter.source.clone();
        let told = Statement::one_is(Term::Formula(letter), what);
        Some((source, Some(told)))
    };
    let ((one, first), (other, second)) = (
        letter_of("from", &turned.from)?,
        letter_of("to", &turned.towards)?,
    );
    let source = &angle.source;
    let sign = if turned.against { '-' } else { '+' };
    let sum = format!("{vector}=\\cos({source}){one}{sign}\\sin({source}){other}");
    let holds = Statement::Holds(formula(&sum, false, macros)?);
    let mut told: Vec<Statement> = [first, second].into_iter().flatten().collect();
    told.push(holds);
    let angle = Term::Formula(angle.clone());
    // The sentence tells that the letter is an angle, where no other one needs the vector.
    let own = Term::Formula(turned.vector.clone());
    let needed = |d: &Declaration| {
        let unit = is_only_a_unit_vector(&own, d) || d.statement.does("turn").is_some();
        !unit && d.statement.terms().contains(&&own)
    };
    let told_elsewhere = |d: &Declaration| d.statement.subjects().contains(&angle);
    if !declarations.iter().any(|d| needed(d) || told_elsewhere(d)) {
        told.push(Statement::one_is(angle, NounPhrase::new("scalar", vec![])));
    }
    Some(told)
}

/// An axis by the name that sentences give it.
fn named_axis<'d>(axis: &'d Term, declarations: &'d [Declaration]) -> Option<&'d Term> {
    let along = direction(axis, declarations).filter(|along| !along.reversed);
    let (number, frame) = match (along, axis) {
        (Some(along), _) => (along.number, along.frame),
        (None, Term::Phrase(numbered)) => match numbered.slot(Slot::Which)? {
            Term::Numbers(numbers) => (*numbers.first()?, numbered.slot(Slot::Of)?.clone()),
            _ => return None,
        },
        _ => return None,
    };
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "axes" && subjects.len() == 3 => {
            let own = what.slot(Slot::Of) == Some(&frame);
            subjects.get(number.checked_sub(1)?).filter(|_| own)
        }
        _ => None,
    })
}

/// Whether a sentence says that a letter is a unit vector, and no more.
pub(super) fn is_only_a_unit_vector(letter: &Term, declaration: &Declaration) -> bool {
    match &declaration.statement {
        Statement::Is { subjects, what } => {
            subjects.as_slice() == std::slice::from_ref(letter)
                && what.head == UNIT_VECTOR
                && what.slots.is_empty()
        }
        _ => false,
    }
}
