//! Turns about vectors that formulas tell: "`$n=\cos\beta\,i+\sin\beta\,k$`" and "B turns relative to N about `$n$` at the rate
//! `$w$`", or "`$w n$` is the angular velocity of B relative to N". A product that is said to be something names it by its signs
//! alone; where another sentence tells one of its factors, it is what it comes to as well.

use super::heads::{ACCELERATION, ANGULAR_VELOCITY, UNIT_VECTOR, VELOCITY};
use super::one_thing::is_letter;
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;
use crate::notation::ast::{Kind, Node};
use crate::notation::document::Row;

/// Vectors of which a product may be said to be one.
const VECTORS: [&str; 5] = [
    ANGULAR_VELOCITY,
    VELOCITY,
    ACCELERATION,
    "momentum",
    "angular momentum",
];

/// More turns are not told so.
const LETTERS: [&str; 6] = ["a", "b", "c", "d", "e", "f"];

/// A quantity with the formula of its value.
struct Valued {
    what: NounPhrase,
    value: String,
    /// What is constant besides.
    constant: Option<Term>,
}

/// Gives each such quantity a letter of its own, of which the formula tells the value.
pub(crate) fn turn_about_told_vectors(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let told: Vec<Formula> = declarations
        .iter()
        .filter_map(|d| letter_told(&d.statement))
        .map(|letter| alike(&letter))
        .collect();
    tell_by_letters(declarations, &told, "turn", macros);
}

/// The same of turns about vectors that lead from one point to another: "`$u$` is the unit vector from O to D", where another
/// sentence places D from O by a formula.
pub(super) fn turn_about_ways(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let mut ways: Vec<Formula> = declarations
        .iter()
        .filter_map(|d| letter_of_way(&d.statement, declarations))
        .collect();
    if ways.is_empty() {
        return;
    }
    // Of a body without a frame nothing else would tell how it turns.
    let carrying = bodies_with_frames(declarations);
    ways.retain(|way| {
        let mut all = declarations.iter();
        all.all(|d| !turns_without_frame(&d.statement, way, &carrying))
    });
    let mut pivots = vec![];
    for declaration in declarations.iter_mut() {
        let pivot = about_letter(&mut declaration.statement, &ways);
        pivots.extend(pivot.map(|pivot| declaration.saying(pivot)));
    }
    declarations.extend(pivots);
    let told: Vec<Formula> = ways.iter().map(alike).collect();
    tell_by_letters(declarations, &told, "way", macros);
}

/// The letter of a unit vector from one point to another that is placed from the first by a formula.
fn letter_of_way(statement: &Statement, all: &[Declaration]) -> Option<Formula> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(letter)], UNIT_VECTOR, [_, _]) =
        (subjects.as_slice(), what.head, what.slots.as_slice())
    else {
        return None;
    };
    let (from, to) = (what.slot(Slot::From)?, what.slot(Slot::To)?);
    let own = alike(letter);
    let placed = all.iter().any(|d| match d.statement.does("place") {
        Some(([point], slots)) if point == to && slot(slots, Slot::From) == Some(from) => {
            match slot(slots, Slot::By) {
                Some(Term::Formula(way)) => {
                    !is_letter(way) && way.node().is_some_and(|node| !has_letter(node, &own))
                }
                _ => false,
            }
        }
        _ => false,
    });
    placed.then(|| letter.clone())
}

/// Whether something that carries no frame turns about a letter.
fn turns_without_frame(statement: &Statement, letter: &Formula, carrying: &[Term]) -> bool {
    let Some((subjects, slots)) = statement.does("turn") else {
        return false;
    };
    let along = match slot(slots, Slot::About) {
        Some(Term::Phrase(axis)) => axis.slot(Slot::Along),
        about => about,
    };
    let own = matches!(along, Some(Term::Formula(along)) if along.source == letter.source);
    own && !subjects.iter().all(|subject| carrying.contains(subject))
}

/// The bodies in which frames are said to be fixed, and these frames.
fn bodies_with_frames(declarations: &[Declaration]) -> Vec<Term> {
    let told = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" => Some(subjects),
        _ => None,
    });
    let frames: Vec<&Term> = told.flatten().collect();
    let inside = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let frame = subjects.iter().any(|subject| frames.contains(&subject));
            frame.then(|| what.all(Slot::FixedIn))
        }
        _ => None,
    });
    let bodies: Vec<Term> = inside.flatten().cloned().collect();
    frames.into_iter().cloned().chain(bodies).collect()
}

fn has_letter(node: &Node, letter: &Formula) -> bool {
    let inner = || node.children().any(|child| has_letter(child, letter));
    Formula::of(node).source == letter.source || inner()
}

/// "about the axis through O along `$u$`" as "about `$u$`", and that O is a point of both.
fn about_letter(statement: &mut Statement, letters: &[Formula]) -> Option<Statement> {
    let Statement::Does {
        subjects,
        verb: "turn",
        slots,
    } = statement
    else {
        return None;
    };
    let [body] = subjects.as_slice() else {
        return None;
    };
    let at = slots.iter().position(|(slot, _)| *slot == Slot::About)?;
    let Term::Phrase(axis) = &slots[at].1 else {
        return None;
    };
    let (Some(through), Some(Term::Formula(along)), [_, _]) = (
        axis.slot(Slot::Through).cloned(),
        axis.slot(Slot::Along).cloned(),
        axis.slots.as_slice(),
    ) else {
        return None;
    };
    if !letters.iter().any(|letter| letter.source == along.source) {
        return None;
    }
    let against = slot(slots, Slot::RelativeTo).cloned();
    let both = std::iter::once(body.clone()).chain(against);
    let fixed = both.map(|thing| (Slot::FixedIn, thing)).collect();
    slots[at].1 = Term::Formula(along);
    Some(Statement::one_is(through, NounPhrase::new("point", fixed)))
}

/// Gives each quantity that is told by such a letter one of its own.
fn tell_by_letters(
    declarations: &mut Vec<Declaration>,
    told: &[Formula],
    name: &str,
    macros: &Macros,
) {
    let mut besides = vec![];
    let mut letters = LETTERS.iter();
    for declaration in declarations.iter_mut() {
        let statement = &declaration.statement;
        let Some(valued) = turned(statement, told).or_else(|| product(statement, told)) else {
            continue;
        };
        let Some(mark) = letters.next() else { return };
        let letter = format!("\\boldsymbol{{w}}_{{\\mathrm{{{name}}}{mark}}}");
        let holds = formula(&format!("{letter}={}", valued.value), false, macros);
        let (Some(own), Some(holds)) = (formula(&letter, false, macros), holds) else {
            continue;
        };
        besides.push(declaration.saying(Statement::Holds(holds)));
        let constant = NounPhrase::new("constant", vec![]);
        let constant = valued
            .constant
            .map(|letter| Statement::one_is(letter, constant));
        besides.extend(constant.map(|said| declaration.saying(said)));
        declaration.statement = Statement::one_is(Term::Formula(own), valued.what);
    }
    declarations.extend(besides);
}

/// The letter whose value a sentence tells by a formula.
fn letter_told(statement: &Statement) -> Option<Formula> {
    match statement {
        Statement::Holds(relation) => {
            let Row::Line(line) = &relation.row else {
                return None;
            };
            let letter = Formula::of(line.sides.first()?);
            is_letter(&letter).then_some(letter)
        }
        Statement::Same { subjects, others } => match (subjects.as_slice(), others.as_slice()) {
            ([Term::Formula(letter)], [Term::Formula(value)]) => {
                (is_letter(letter) && !is_letter(value)).then(|| letter.clone())
            }
            _ => None,
        },
        Statement::Is { subjects, what } if what.head == UNIT_VECTOR => {
            let along = what.slot(Slot::Along)?;
            match (subjects.as_slice(), along) {
                ([Term::Formula(letter)], Term::Formula(along)) => {
                    (is_letter(letter) && !is_letter(along)).then(|| letter.clone())
                }
                _ => None,
            }
        }
        _ => None,
    }
}

/// "B turns relative to N about `$n$` at the constant rate `$w$`"
fn turned(statement: &Statement, told: &[Formula]) -> Option<Valued> {
    let (subjects, slots) = statement.does("turn")?;
    let ([body], 2 | 3) = (subjects, slots.len()) else {
        return None;
    };
    let (Term::Formula(about), Term::Phrase(rate)) =
        (slot(slots, Slot::About)?, slot(slots, Slot::At)?)
    else {
        return None;
    };
    let Term::Formula(letter) = rate.slot(Slot::Which).filter(|_| rate.head == "rate")? else {
        return None;
    };
    let about = alike(about);
    if !told.iter().any(|told| told.source == about.source) {
        return None;
    }
    let base = slot(slots, Slot::RelativeTo);
    if slots.len() == 3 && base.is_none() {
        return None;
    }
    let base = base.map(|base| (Slot::RelativeTo, base.clone()));
    let of = std::iter::once((Slot::Of, body.clone())).chain(base);
    Some(Valued {
        what: NounPhrase::new(ANGULAR_VELOCITY, of.collect()),
        value: format!("({})\\,{}", letter.source, about.source),
        constant: rate.is("constant").then(|| Term::Formula(letter.clone())),
    })
}

/// "`$w n$` is the angular velocity of B relative to N"
fn product(statement: &Statement, told: &[Formula]) -> Option<Valued> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let [Term::Formula(product)] = subjects.as_slice() else {
        return None;
    };
    let node = product.node()?;
    let made = matches!(node.kind, Kind::Product(_)) && VECTORS.contains(&what.head);
    let known = made && told.iter().any(|told| is_factor(node, told));
    known.then(|| Valued {
        what: what.clone(),
        value: product.source.clone(),
        constant: None,
    })
}

/// A formula as formulas inside others are written.
pub(super) fn alike(formula: &Formula) -> Formula {
    formula.node().map_or_else(|| formula.clone(), Formula::of)
}

/// Whether a letter is one of the factors of a product.
fn is_factor(product: &Node, letter: &Formula) -> bool {
    product
        .children()
        .any(|factor| Formula::of(factor).source == letter.source)
}

/// "`$w k$` is the angular velocity of B relative to N", where k is an axis of one of the two: B turns about k at the rate w.
pub(super) fn turn_at_told_rates(declarations: &mut [Declaration]) {
    let axes: Vec<(Formula, Term)> = declarations
        .iter()
        .flat_map(|d| axes_of(&d.statement))
        .collect();
    let turned: Vec<Term> = declarations
        .iter()
        .filter_map(|d| d.statement.does("turn"))
        .flat_map(|(subjects, _)| subjects.to_vec())
        .collect();
    for declaration in declarations {
        let turn = told_turn(&declaration.statement, &axes);
        if let Some((body, turn)) = turn.filter(|(body, _)| !turned.contains(body)) {
            declaration.statement = Statement::Does {
                subjects: vec![body],
                verb: "turn",
                slots: turn,
            };
        }
    }
}

/// The letters of the axes of a frame, each with it.
fn axes_of(statement: &Statement) -> Vec<(Formula, Term)> {
    let Statement::Is { subjects, what } = statement else {
        return vec![];
    };
    let frame = what.slot(Slot::Of).filter(|_| what.head == "axes");
    let letter = |subject: &Term| match subject {
        Term::Formula(letter) => Some((letter.clone(), frame?.clone())),
        _ => None,
    };
    subjects.iter().filter_map(letter).collect()
}

/// What turns by such a sentence, and how.
fn told_turn(statement: &Statement, axes: &[(Formula, Term)]) -> Option<(Term, Vec<(Slot, Term)>)> {
    let Statement::Is { subjects, what } = statement else {
        return None;
    };
    let ([Term::Formula(product)], ANGULAR_VELOCITY, 2, []) = (
        subjects.as_slice(),
        what.head,
        what.slots.len(),
        what.adjectives.as_slice(),
    ) else {
        return None;
    };
    let (body, base) = (what.slot(Slot::Of)?, what.slot(Slot::RelativeTo)?);
    let node = product
        .node()
        .filter(|node| matches!(node.kind, Kind::Product(_)))?;
    let factors: Vec<Formula> = node.children().map(Formula::of).collect();
    let axis = |factor: &Formula| {
        axes.iter().find(|(letter, frame)| {
            alike(letter).source == factor.source && (frame == body || frame == base)
        })
    };
    let (rate, (letter, _)) = match factors.as_slice() {
        [rate, vector] => (rate, axis(vector)?),
        _ => return None,
    };
    let rate = NounPhrase::new("rate", vec![(Slot::Which, Term::Formula(rate.clone()))]);
    let slots = vec![
        (Slot::RelativeTo, base.clone()),
        (Slot::About, Term::Formula(letter.clone())),
        (Slot::At, Term::Phrase(Box::new(rate))),
    ];
    Some((body.clone(), slots))
}
