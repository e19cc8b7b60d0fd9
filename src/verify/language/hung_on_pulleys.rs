//! What the string over a pulley says of the things that hang from it: where they are as the pulley turns, and what acts.

use super::heads::{CONSTANT, FORCE, MOMENT, POSITION, TRAVEL, VERTICAL, WEIGHT};
use super::kinds::name;
use super::pulleys::{is, only, phrase};
use super::pulleys_on_axes::{Hanging, Pulley};
use super::reader::formula;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;

/// "`$s$` is the distance by which the block has moved down": its position from where it is when the pulley has not turned.
pub(super) fn from_the_start(statement: &mut Statement, told: &Pulley, macros: &Macros) {
    let Statement::Is { what, .. } = statement else {
        return;
    };
    if !matches!(what.head, TRAVEL | "displacement") {
        return;
    }
    let hung = told.hanging.iter();
    let mut hung = hung.filter(|own| what.slot(Slot::Of) == Some(&own.thing));
    let (Some(hung), Some(along)) = (hung.next(), what.slot(Slot::Along)) else {
        return;
    };
    let up = formula(&told.up, false, macros).map(Term::Formula);
    let down = formula(&against(&told.up), false, macros).map(Term::Formula);
    let along = match along {
        Term::Phrase(vertical) if vertical.head == VERTICAL => match vertical.is("downward") {
            true => down,
            false => up,
        },
        along => Some(along.clone()),
    };
    let slots = vec![
        (Slot::Of, hung.thing.clone()),
        (Slot::RelativeTo, start_of(&hung.thing)),
    ];
    if let Some(along) = along {
        let position = phrase(POSITION, slots);
        *what = NounPhrase::new(
            "component",
            vec![(Slot::Along, along), (Slot::Of, position)],
        );
    }
}

/// A pulley that turns by no letter turns by one of its own.
pub(super) fn turn_by_angle(statement: &mut Statement, told: &Pulley, macros: &Macros) {
    if let Statement::Does {
        subjects,
        verb: "turn",
        slots,
    } = statement
        && subjects.contains(&told.pulley)
        && slot(slots, Slot::By).is_none()
        && let Some(angle) = formula(&told.angle, false, macros)
    {
        let which = vec![(Slot::Which, Term::Formula(angle))];
        slots.push((Slot::By, phrase("angle", which)));
    }
}

/// What hangs moves as a particle does.
pub(super) fn as_particle(statement: &mut Statement, told: &Pulley) {
    if let Statement::Is { subjects, what } = statement
        && matches!(what.head, "body" | "block")
        && subjects
            .iter()
            .all(|s| told.hanging.iter().any(|own| own.thing == *s))
    {
        what.head = "particle";
        what.adjectives.clear();
    }
}

fn start_of(thing: &Term) -> Term {
    Term::Name(format!("start of {}", name(thing).unwrap_or_default()))
}

pub(super) fn statements(
    told: &Pulley,
    declarations: &[Declaration],
    macros: &Macros,
) -> Option<Vec<Statement>> {
    let written = |source: &str| Some(Term::Formula(formula(source, false, macros)?));
    let mut all = vec![];
    for (at, hung) in told.hanging.iter().enumerate() {
        all.extend(hung_statements(told, at, hung, macros)?);
        let known = declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                matches!(what.head, "particle" | "body" | "block") && subjects.contains(&hung.thing)
            }
            _ => false,
        });
        all.extend((!known).then(|| is(&hung.thing, "particle", vec![])));
    }
    let pulls = told.hanging.iter().map(|hung| {
        let sign = if hung.falls { "+" } else { "-" };
        format!("{sign}\\left({}\\right)", hung.tension)
    });
    let moment = format!(
        "\\left({}\\right){}",
        pulls.collect::<String>(),
        told.radius
    );
    let moments = vec![
        (Slot::Of, told.pulley.clone()),
        (Slot::Along, written(&told.about)?),
        (
            Slot::With,
            phrase(MOMENT, vec![(Slot::Which, written(&moment)?)]),
        ),
    ];
    let about = vec![(Slot::About, written(&told.about)?)];
    all.push(is(&told.pulley, "symmetric", about));
    all.push(only(MOMENT, moments));
    Some(all)
}

/// Where something hangs, and that its weight and the string are all that acts on it.
fn hung_statements(
    told: &Pulley,
    at: usize,
    hung: &Hanging,
    macros: &Macros,
) -> Option<Vec<Statement>> {
    let written = |source: &str| Some(Term::Formula(formula(source, false, macros)?));
    let depth = format!("d_{{\\mathrm{{pulley}}{}}}", at + 1);
    let Pulley {
        radius, angle, up, ..
    } = told;
    let back = against(up);
    let way = if hung.falls { &back } else { up };
    let start = format!(
        "{}{}",
        times(radius, &hung.side),
        signed(&times(&depth, &back))
    );
    let way = times(&format!("{radius}{angle}"), way);
    let force = written(&times(&hung.tension, up))?;
    let place = |subject: Term, from: Term, by: Term| Statement::Does {
        subjects: vec![subject],
        verb: "place",
        slots: vec![(Slot::From, from), (Slot::By, by)],
    };
    let begin = start_of(&hung.thing);
    let loads = vec![
        (Slot::Of, hung.thing.clone()),
        (Slot::With, phrase(WEIGHT, vec![])),
        (Slot::With, phrase(FORCE, vec![(Slot::Which, force)])),
    ];
    Some(vec![
        place(begin.clone(), told.centre.clone(), written(&start)?),
        place(hung.thing.clone(), begin, written(&way)?),
        is(&written(&depth)?, CONSTANT, vec![]),
        only("load", loads),
    ])
}

/// The direction against another one, as both are written.
fn against(direction: &str) -> String {
    match direction.strip_prefix('-') {
        Some(other) => other.to_owned(),
        None => format!("-{direction}"),
    }
}

/// A number times a direction: its sign stands before both.
fn times(number: &str, direction: &str) -> String {
    match direction.strip_prefix('-') {
        Some(other) => format!("-{number}\\,{other}"),
        None => format!("{number}\\,{direction}"),
    }
}

/// A term of a sum.
fn signed(term: &str) -> String {
    if term.starts_with('-') {
        term.to_owned()
    } else {
        format!("+{term}")
    }
}
