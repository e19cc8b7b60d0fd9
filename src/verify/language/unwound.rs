//! Strings that unwind from round bodies. One that hangs from where it is held, and stays vertical, is as a plane at rest on
//! which the body rolls: what leaves the body is at rest, and the string pulls at the point where it leaves.

use super::heads::{CONTACT_POINT, FORCE, MASS, MOMENT_OF_INERTIA, VERTICAL};
use super::kinds::name;
use super::planar_axes::{axis, vertical};
use super::reader::formula;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::wound::{at_rest, is_at_rest, third_axis, winds};
use crate::notation::Macros;

/// Parts of a body about which a string is wound.
const PARTS: [&str; 5] = ["axle", "drum", "core", "hub", "spindle"];

/// What is at rest by its noun.
const HELD: [&str; 2] = ["ceiling", "support"];

/// The name of the point where a string leaves a body.
const POINT: &str = "string point";

/// By its number the axis along which the string is from the body, and the one about which this turns.
const BESIDE: usize = 1;
const ABOUT: usize = 2;

/// A string that unwinds, and from what.
pub(super) struct Unwinding {
    pub(super) at: usize,
    pub(super) string: Term,
    pub(super) part: Term,
    pub(super) body: Term,
    pub(super) ground: Term,
    /// Whether the third axis points down.
    pub(super) down: bool,
}

/// Says that the body rolls along the string, and that this pulls where the body touches it.
pub(super) fn unwind_strings(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let Some(told) = unwinding(declarations) else {
        return;
    };
    let Some(turn) = turn(&told, declarations, macros) else {
        return;
    };
    let said = declarations[told.at].clone();
    let point = Term::Name(POINT.to_owned());
    declarations.retain(|d| !is_of_winding(&d.statement, &told));
    take_radius(declarations, &told);
    for declaration in declarations.iter_mut() {
        pull_there(&mut declaration.statement, &told, &point);
        turn_about_level(&mut declaration.statement, &told);
    }
    let inertial = at_rest(&told.ground, declarations).into_iter();
    let all = inertial.chain(rolling(&told, &point)).chain([turn]);
    declarations.extend(all.map(|statement| said.saying(statement)));
}

/// The only string that unwinds, where nothing else is said of how the body moves.
fn unwinding(declarations: &[Declaration]) -> Option<Unwinding> {
    let mut wound = declarations.iter().enumerate().filter_map(|(at, d)| {
        let (string, part) = winds(&d.statement)?;
        Some((
            at,
            string.clone(),
            part.clone(),
            d.extent == Extent::Document,
        ))
    });
    let (at, string, part, whole) = wound.next()?;
    if wound.next().is_some() || !whole || !is_vertical(&string, declarations) {
        return None;
    }
    let ground = held_in(&string, declarations)?;
    let body = body_with(&part, declarations)?;
    let down = third_axis(&ground, declarations)?;
    let free = !declarations
        .iter()
        .any(|d| moves_otherwise(&d.statement, &body));
    let other_radius = body != part && declarations.iter().any(|d| is_radius(&d.statement, &body));
    (free && !other_radius).then_some(Unwinding {
        at,
        string,
        part,
        body,
        ground,
        down,
    })
}

fn is_vertical(string: &Term, declarations: &[Declaration]) -> bool {
    declarations
        .iter()
        .any(|d| says_vertical(&d.statement, string))
}

/// "The string is vertical."
pub(super) fn says_vertical(statement: &Statement, string: &Term) -> bool {
    match statement {
        Statement::Is { subjects, what } => {
            what.head == VERTICAL && what.slots.is_empty() && subjects.contains(string)
        }
        _ => false,
    }
}

/// The frame in which the upper end of the string is fixed.
pub(super) fn held_in(string: &Term, declarations: &[Declaration]) -> Option<Term> {
    let place = declarations.iter().find_map(|d| {
        let (subjects, slots) = d.statement.does("hang")?;
        subjects.contains(string).then(|| slot(slots, Slot::From))?
    })?;
    let inertial = |frame: &Term| is_at_rest(frame, declarations);
    let mut frames = declarations.iter().flat_map(|d| match &d.statement {
        Statement::Is { subjects, what } if subjects.contains(place) => {
            what.all(Slot::FixedIn).cloned().collect()
        }
        Statement::Is { subjects, what }
            if name(place).is_some_and(|n| HELD.contains(&n.as_str())) =>
        {
            match what.head == "frame" && what.is("inertial") {
                true => subjects.clone(),
                false => vec![],
            }
        }
        _ => vec![],
    });
    let frame = frames.next()?;
    (frames.all(|other| other == frame) && inertial(&frame)).then_some(frame)
}

/// The body with a mass from which the string unwinds, or of which it unwinds from a part.
pub(super) fn body_with(part: &Term, declarations: &[Declaration]) -> Option<Term> {
    let mut bodies: Vec<Term> = vec![];
    for declaration in declarations {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let masses = |(_, term): &&(Slot, Term)| term.is_noun(MASS);
        let own = match what.head {
            MASS => what.all(Slot::Of).cloned().collect(),
            _ if what.slots.iter().any(|said| masses(&said)) => subjects.clone(),
            _ => vec![],
        };
        for body in own {
            if !bodies.contains(&body) {
                bodies.push(body);
            }
        }
    }
    if bodies.contains(part) {
        return Some(part.clone());
    }
    let is_part = name(part).is_some_and(|part| PARTS.contains(&part.as_str()));
    match bodies.as_slice() {
        [body] if is_part => Some(body.clone()),
        _ => None,
    }
}

/// Whether a sentence tells that a body rolls, is hinged or turns about an axis that it names.
fn moves_otherwise(statement: &Statement, body: &Term) -> bool {
    let Statement::Does {
        subjects,
        verb,
        slots,
    } = statement
    else {
        return false;
    };
    let held = matches!(
        *verb,
        "roll" | "touch" | "hinge" | "pin" | "pivot" | "slide" | "slip"
    );
    let turned = *verb == "turn" && slots.iter().any(|(slot, _)| *slot != Slot::By);
    subjects.contains(body) && (held || turned)
}

/// Whether a sentence tells a radius of a thing.
fn is_radius(statement: &Statement, thing: &Term) -> bool {
    let radius = |what: &NounPhrase| what.head == "radius";
    match statement {
        Statement::Is { subjects, what } => {
            let own = radius(what) && what.slot(Slot::Of) == Some(thing);
            let mut sizes = what.slots.iter().filter_map(|(_, term)| match term {
                Term::Phrase(size) => Some(size),
                _ => None,
            });
            own || subjects.contains(thing) && sizes.any(|size| radius(size))
        }
        _ => false,
    }
}

/// How the body turns: forward as it unwinds and goes down.
fn turn(told: &Unwinding, declarations: &[Declaration], macros: &Macros) -> Option<Statement> {
    let angle = declarations.iter().find_map(|d| {
        let (subjects, slots) = d.statement.does("turn")?;
        subjects
            .contains(&told.body)
            .then(|| slot(slots, Slot::By))?
    });
    let mut slots = vec![
        (Slot::RelativeTo, told.ground.clone()),
        (Slot::About, axis(ABOUT, Some(&told.ground))),
    ];
    if let Some(angle) = angle {
        let letter = angle.letter()?;
        let by = match told.down {
            true => formula(&format!("-{}", letter.source), false, macros)?,
            false => letter.clone(),
        };
        let by = NounPhrase::new("angle", vec![(Slot::Which, Term::Formula(by))]);
        slots.push((Slot::By, Term::Phrase(Box::new(by))));
    }
    Some(Statement::Does {
        subjects: vec![told.body.clone()],
        verb: "turn",
        slots,
    })
}

/// What only says how the string is wound, and what is said anew of the body.
fn is_of_winding(statement: &Statement, told: &Unwinding) -> bool {
    let own = |subjects: &[Term]| subjects.contains(&told.string);
    match statement {
        Statement::Does { subjects, verb, .. } => {
            let turns = *verb == "turn" && subjects.contains(&told.body);
            turns || own(subjects) && matches!(*verb, "unwind" | "wind" | "hang")
        }
        Statement::Is { subjects, what } => {
            let symmetric = what.head == "symmetric" && subjects.contains(&told.body);
            let massless = what.head == "massless" && own(subjects);
            symmetric || massless || says_vertical(statement, &told.string)
        }
        _ => false,
    }
}

/// The string as a plane on which the body rolls, round about a level axis.
fn rolling(told: &Unwinding, point: &Term) -> Vec<Statement> {
    let (body, string) = (told.body.clone(), told.string.clone());
    let plane = vec![
        (Slot::FixedIn, told.ground.clone()),
        (Slot::With, axis(BESIDE, Some(&told.ground))),
    ];
    let contact = vec![(Slot::Of, body.clone()), (Slot::On, string.clone())];
    let about = vec![(Slot::About, axis(ABOUT, Some(&told.ground)))];
    vec![
        Statement::one_is(string.clone(), NounPhrase::new("plane", plane)),
        Statement::one_is(point.clone(), NounPhrase::new(CONTACT_POINT, contact)),
        Statement::one_is(body.clone(), NounPhrase::new("symmetric", about)),
        Statement::Does {
            subjects: vec![body],
            verb: "roll",
            slots: vec![(Slot::On, string), (Slot::At, point.clone())],
        },
    ]
}

/// The radius of the part is that with which the body rolls: said where it is said what the body is, or by itself.
fn take_radius(declarations: &mut [Declaration], told: &Unwinding) {
    let own = |d: &Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let radius = what.head == "radius" && what.slot(Slot::Of) == Some(&told.part);
            radius.then(|| subjects.first().cloned()).flatten()
        }
        _ => None,
    };
    let Some(letter) = declarations.iter().find_map(own) else {
        return;
    };
    if told.part == told.body {
        return;
    }
    let radius = NounPhrase::new("radius", vec![(Slot::Which, letter)]);
    let described = |d: &&mut Declaration| match &d.statement {
        Statement::Is { subjects, what } => {
            let masses = what.slots.iter().any(|(_, size)| size.is_noun(MASS));
            masses && subjects.as_slice() == std::slice::from_ref(&told.body)
        }
        _ => false,
    };
    if let Some(declaration) = declarations.iter_mut().find(described)
        && let Statement::Is { what, .. } = &mut declaration.statement
    {
        what.slots.push((Slot::Of, Term::Phrase(Box::new(radius))));
    }
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head == "radius"
        {
            for (slot, of) in &mut what.slots {
                if *slot == Slot::Of && *of == told.part {
                    *of = told.body.clone();
                }
            }
        }
    }
}

/// The tension is the force where the string leaves the body, and pulls up.
pub(super) fn pull_there(statement: &mut Statement, told: &Unwinding, point: &Term) {
    let pull = |load: &NounPhrase| {
        let of_string = load.slot(Slot::Of) == Some(&told.string);
        of_string && matches!(load.head, "tension" | FORCE)
    };
    match statement {
        Statement::Is { what, .. } if what.head == "tension" && pull(what) => {
            let at = vec![(Slot::Upon, told.body.clone()), (Slot::At, point.clone())];
            let force = NounPhrase::new(FORCE, at);
            let up = Term::Phrase(Box::new(vertical("upward")));
            let slots = vec![(Slot::Along, up), (Slot::Of, Term::Phrase(Box::new(force)))];
            *what = NounPhrase::new("component", slots);
        }
        Statement::Premise(list) if list.slot(Slot::Of) == Some(&told.body) => {
            for (_, load) in &mut list.slots {
                if let Term::Phrase(load) = load
                    && pull(load)
                {
                    **load = NounPhrase::new(FORCE, vec![(Slot::At, point.clone())]);
                }
            }
        }
        _ => {}
    }
}

/// "the moment of inertia of the yo-yo about its axis through G": about the axis of the turn.
fn turn_about_level(statement: &mut Statement, told: &Unwinding) {
    let Statement::Is { what, .. } = statement else {
        return;
    };
    if what.head != MOMENT_OF_INERTIA || what.slot(Slot::Of) != Some(&told.body) {
        return;
    }
    for (slot, about) in &mut what.slots {
        if let (Slot::About, Term::Phrase(own)) = (slot, about)
            && own.head == "axis"
            && own.all(Slot::Of).all(|of| *of == told.body)
            && own.slot(Slot::Along).is_none()
        {
            own.slots.retain(|(slot, _)| *slot != Slot::Of);
            own.slots
                .push((Slot::Along, axis(ABOUT, Some(&told.ground))));
        }
    }
}
