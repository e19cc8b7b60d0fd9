//! Turns of one thing that one sentence tells one after the other: "by `$a$` about z and then by `$b$` about x".

use super::clause::as_formula;
use super::heads::{ANGULAR_VELOCITY, EULER_ANGLES};
use super::is_body;
use super::other_components::number_other_components;
use super::rate_matrices::tell_rate_matrices;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};
use super::terms::say_besides;
use crate::notation::ast::Kind;
use crate::notation::document::Row;

/// Puts the turns of a sentence together: by angles they are Euler angles; several rates of one thing are not understood.
pub(crate) fn turn_in_order(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut all: Vec<Declaration> = vec![];
    let mut rest = declarations.into_iter().peekable();
    while let Some(first) = rest.next() {
        let mut row = vec![first];
        while let Some(next) = rest.next_if(|next| is_next_turn(&row[0], next)) {
            row.push(next);
        }
        match (row.len(), in_order(&row)) {
            (1, _) => all.append(&mut row),
            (_, Some(angles)) => all.push(angles),
            (_, None) => all.extend(row.into_iter().map(Declaration::not_understood)),
        }
    }
    all
}

/// "B is turned relative to A by `$R$`": no angle is told by a letter in capitals, but the matrix of the turn, which takes
/// components on B to components on A.
pub(crate) fn tell_matrices(declarations: &mut Vec<Declaration>) {
    tell_rate_matrices(declarations);
    say_besides(declarations, |statement| {
        let Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } = statement
        else {
            return vec![];
        };
        let told = slot(slots, Slot::About).or(slot(slots, Slot::At));
        let capital = |f: &Formula| f.source.starts_with(char::is_uppercase);
        let (Some(Term::Formula(matrix)), Some(relative), [turned], None) = (
            slot(slots, Slot::By),
            slot(slots, Slot::RelativeTo),
            subjects.as_slice(),
            told,
        ) else {
            return vec![];
        };
        if !capital(matrix) {
            return vec![];
        }
        let (from, to) = (turned.clone(), relative.clone());
        let matrix = Term::Formula(matrix.clone());
        slots.retain(|(slot, _)| *slot != Slot::By);
        vec![Statement::Does {
            subjects: vec![matrix],
            verb: "take",
            slots: vec![(Slot::From, from), (Slot::To, to)],
        }]
    });
}

/// The angles of an aircraft, in the order of their axes x, y, z.
const AIRCRAFT_ANGLES: [&str; 3] = ["roll angle", "pitch angle", "yaw angle"];

/// "`$\\phi$`, `$\\theta$`, `$\\psi$` are the roll, pitch and yaw angles of B": Euler angles about z, y and x.
pub(crate) fn turn_by_aircraft_angles(declarations: &mut Vec<Declaration>) {
    let said = |d: &Declaration, noun: &str| match &d.statement {
        Statement::Is { subjects, what } if what.head == noun => match subjects.as_slice() {
            [angle] => Some((angle.clone(), what.slots.clone())),
            _ => None,
        },
        _ => None,
    };
    let yaws: Vec<Declaration> = declarations
        .iter()
        .filter(|d| said(d, AIRCRAFT_ANGLES[2]).is_some())
        .cloned()
        .collect();
    for yaw in yaws {
        let Some((psi, slots)) = said(&yaw, AIRCRAFT_ANGLES[2]) else {
            continue;
        };
        let other = |noun| {
            let mut all = declarations.iter().filter(|d| d.extent == yaw.extent);
            all.find_map(|d| said(d, noun).filter(|(_, own)| *own == slots))
        };
        let (Some((theta, _)), Some((phi, _))) =
            (other(AIRCRAFT_ANGLES[1]), other(AIRCRAFT_ANGLES[0]))
        else {
            continue;
        };
        declarations.retain(|d| {
            let angle = AIRCRAFT_ANGLES.iter().find_map(|noun| said(d, noun));
            d.extent != yaw.extent || angle.is_none_or(|(_, own)| own != slots)
        });
        let order = ["z", "y", "x"].map(|axis| (Slot::InOrder, Term::Name(axis.to_owned())));
        let slots = slots.into_iter().chain(order).collect();
        declarations.push(Declaration {
            statement: Statement::Is {
                subjects: vec![psi, theta, phi],
                what: NounPhrase::new(EULER_ANGLES, slots),
            },
            ..yaw
        });
    }
}

/// Slots that say how something turns.
const OF_TURNS: [Slot; 5] = [
    Slot::About,
    Slot::RelativeTo,
    Slot::By,
    Slot::At,
    Slot::FixedIn,
];

/// Slots that say where something moves.
const OF_MOVES: [Slot; 4] = [Slot::On, Slot::RelativeTo, Slot::In, Slot::Along];

/// Adjectives of what moves, with their verbs and what says how.
const MOTIONS: [(&str, &str, &[Slot]); 2] = [
    ("turning", "turn", &OF_TURNS),
    ("moving", "move", &OF_MOVES),
];

/// What moves besides bodies.
const MOVED: [&str; 2] = ["frame", "plane"];

/// "The disc is a body that turns about z": the disc turns.
pub(crate) fn tell_turning(declarations: &mut Vec<Declaration>) {
    tell_vector_rates(declarations);
    number_other_components(declarations);
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        as_described_body(what);
        let motion = MOTIONS.into_iter().find(|(said, ..)| what.is(said));
        // How a frame turns that only turns another sentence may tell.
        let told = what.slots.iter().any(|(slot, _)| *slot != Slot::RelativeTo);
        let moves = is_body(what.head) || MOVED.contains(&what.head) && told;
        let Some((adjective, verb, slots)) = motion.filter(|_| moves) else {
            return vec![];
        };
        what.adjectives.retain(|a| *a != adjective);
        let (moves, own) = std::mem::take(&mut what.slots)
            .into_iter()
            .partition(|(slot, _)| slots.contains(slot));
        what.slots = own;
        vec![Statement::Does {
            subjects: subjects.clone(),
            verb,
            slots: moves,
        }]
    });
}

/// "The top turns about O with the angular velocity `$\\vec\\omega$`": a vector is no rate about an axis.
fn tell_vector_rates(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| {
        let Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } = statement
        else {
            return vec![];
        };
        let ([body], Some(rate)) = (subjects.as_slice(), slots.iter().find_map(vector_rate)) else {
            return vec![];
        };
        slots.retain(|slot| vector_rate(slot).is_none());
        let relative = slots.iter().filter(|(slot, _)| *slot == Slot::RelativeTo);
        let of = std::iter::once((Slot::Of, body.clone()));
        let what = NounPhrase::new(ANGULAR_VELOCITY, of.chain(relative.cloned()).collect());
        vec![Statement::one_is(rate, what)]
    });
}

/// The letter of a vector behind "at the rate".
fn vector_rate((slot, term): &(Slot, Term)) -> Option<Term> {
    let letter = match term {
        Term::Phrase(rate) => rate.slot(Slot::Which)?,
        letter => letter,
    };
    let Term::Formula(Formula {
        row: Row::Expression(node),
        ..
    }) = letter
    else {
        return None;
    };
    let vector = matches!(&node.kind, Kind::Symbol(symbol) if symbol.style.vector);
    (*slot == Slot::At && vector).then(|| letter.clone())
}

/// "a rigid body that turns about z" is a body, with what says how it moves.
fn as_described_body(what: &mut NounPhrase) {
    if MOTIONS.iter().any(|(said, ..)| *said == what.head) && what.is("body-fixed") {
        what.adjectives.retain(|a| *a != "body-fixed");
        what.adjectives.push(what.head);
        what.head = "body";
    }
}

/// Whether a sentence goes on with another turn of the same thing against the same frame.
fn is_next_turn(one: &Declaration, next: &Declaration) -> bool {
    fn turn(d: &Declaration) -> Option<(&[Term], Option<&Term>)> {
        let (subjects, slots) = d.statement.does("turn")?;
        Some((subjects, slot(slots, Slot::RelativeTo)))
    }
    one.line == next.line
        && one.extent == next.extent
        && turn(one).is_some_and(|t| turn(next) == Some(t))
}

/// The Euler angles that some turns are; none if one of them is not by an angle.
fn in_order(row: &[Declaration]) -> Option<Declaration> {
    let turns = row.iter().map(angle_and_axis);
    let turns = turns.collect::<Option<Vec<(Term, Term)>>>()?;
    let first = row.first()?;
    let Statement::Does {
        subjects, slots, ..
    } = &first.statement
    else {
        return None;
    };
    let of = subjects.iter().map(|s| (Slot::Of, s.clone()));
    let relative = slot(slots, Slot::RelativeTo).map(|term| (Slot::RelativeTo, term.clone()));
    let axes = turns.iter().map(|(_, axis)| (Slot::InOrder, axis.clone()));
    let what = NounPhrase::new(EULER_ANGLES, of.chain(relative).chain(axes).collect());
    let subjects = turns.iter().map(|(angle, _)| angle.clone()).collect();
    Some(Declaration {
        statement: Statement::Is { subjects, what },
        ..first.clone()
    })
}

/// The angle of a turn and the axis that it is about.
fn angle_and_axis(turn: &Declaration) -> Option<(Term, Term)> {
    let Statement::Does { slots, .. } = &turn.statement else {
        return None;
    };
    let angle = match slot(slots, Slot::By)? {
        Term::Phrase(angle) => angle.slot(Slot::Which)?,
        angle => angle,
    };
    as_formula(angle)?;
    Some((angle.clone(), slot(slots, Slot::About)?.clone()))
}
