//! Strings over pulleys and drums that turn about level axes at rest: what hangs from the ends goes down and up as the pulley
//! turns, and pulls at its rim.

use super::heads::{CONSTANT, FORCE, MASS_CENTRE, MOMENT, MOMENT_OF_INERTIA, VERTICAL, WEIGHT};
use super::is_load;
use super::kinds::name;
use super::planar_axes::vertical;
use super::reader::formula;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::told_sizes::told_size;
use super::wound::{at_rest, is_at_rest, third_axis, winds};
use crate::notation::Macros;

/// Letters of the axes of the frame at rest: the pulley turns about the second one, and the third one points up.
const AXES: [&str; 3] = [
    "\\boldsymbol{i}_{\\mathrm{string}}",
    "\\boldsymbol{j}_{\\mathrm{string}}",
    "\\boldsymbol{k}_{\\mathrm{string}}",
];
/// The letter of the angle by which the pulley has turned, and those of how far down things hang where it is zero.
const ANGLE: &str = "\\vartheta_{\\mathrm{string}}";
const DEPTHS: [&str; 2] = ["d_{\\mathrm{string}1}", "d_{\\mathrm{string}2}"];

/// The name of the mass centre of the pulley.
const CENTRE: &str = "pulley centre";

/// The noun of the pull of a string.
pub(super) const TENSION: &str = "tension";

/// A string over a pulley, with what hangs from it.
struct Pulley {
    string: Term,
    pulley: Term,
    ground: Term,
    radius: String,
    /// What hangs from the string, with the letter of its pull there: the first one goes down as the pulley turns.
    hanging: Vec<(Term, String)>,
    declaration: Declaration,
}

/// Says how the pulley and what hangs from the string move, and what acts on them.
pub(super) fn hang_on_pulleys(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let Some(pulley) = pulley(declarations) else {
        return;
    };
    let letters: Option<Vec<Term>> = AXES
        .iter()
        .map(|letter| Some(Term::Formula(formula(letter, false, macros)?)))
        .collect();
    let Some([i, j, k]) = letters.and_then(|all| <[Term; 3]>::try_from(all).ok()) else {
        return;
    };
    let Some(told) = statements(&pulley, [&i, &j, &k], macros) else {
        return;
    };
    declarations.retain(|d| !is_of_pulley(&d.statement, &pulley));
    for declaration in declarations.iter_mut() {
        take_axes(&mut declaration.statement, &pulley, &j, &k, macros);
    }
    let inertial = at_rest(&pulley.ground, declarations).into_iter();
    let told = inertial.chain(told).map(|s| pulley.declaration.saying(s));
    let told: Vec<Declaration> = told.collect();
    declarations.extend(told);
}

/// The only string that is wound on something, where that turns about its own axis.
fn pulley(declarations: &[Declaration]) -> Option<Pulley> {
    let mut wound = declarations.iter().filter_map(|d| {
        let (string, pulley) = winds(&d.statement)?;
        Some((string.clone(), pulley.clone(), d))
    });
    let (string, pulley, declaration) = wound.next()?;
    if wound.next().is_some() || declaration.extent != Extent::Document {
        return None;
    }
    let ground = axis_fixed_in(&pulley, declarations)?;
    if third_axis(&ground, declarations)? || names_vertical(declarations) {
        return None;
    }
    let hanging = hanging(&string, declarations)?;
    Some(Pulley {
        radius: told_size("radius", &pulley, declarations)?.source.clone(),
        declaration: declaration.clone(),
        string,
        pulley,
        ground,
        hanging,
    })
}

fn names_vertical(declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            what.head == VERTICAL && subjects.iter().any(|s| name(s).is_some())
        }
        _ => false,
    })
}

/// "the axis of the pulley", horizontal or not said to be.
fn is_own_axis(term: &Term, pulley: &Term) -> bool {
    match term {
        Term::Phrase(axis) if axis.head == "axis" => {
            let level = axis.adjectives.iter().all(|said| *said == "horizontal");
            level && axis.slots.as_slice() == [(Slot::Of, pulley.clone())]
        }
        _ => false,
    }
}

/// The inertial frame in which the axis is fixed about which a pulley turns, by no angle and at no rate that is told.
fn axis_fixed_in(pulley: &Term, declarations: &[Declaration]) -> Option<Term> {
    let turns: Vec<&[(Slot, Term)]> = declarations
        .iter()
        .filter_map(|d| d.statement.does("turn"))
        .filter(|(subjects, _)| subjects.contains(pulley))
        .map(|(_, slots)| slots)
        .collect();
    let [slots] = turns.as_slice() else {
        return None;
    };
    let plain = slots
        .iter()
        .all(|(slot, _)| matches!(slot, Slot::About | Slot::With));
    let own = slot(slots, Slot::About).is_some_and(|about| is_own_axis(about, pulley));
    // "without friction", "freely": else the bearing may hold it back.
    let free = slots.iter().any(|(slot, _)| *slot == Slot::With);
    let loaded = declarations.iter().any(|d| match &d.statement {
        Statement::Is { what, .. } => is_load(what.head) && what.slot(Slot::Upon) == Some(pulley),
        Statement::Premise(list) => list.is("only") && list.slot(Slot::Of) == Some(pulley),
        _ => false,
    });
    if !plain || !own || !free || loaded {
        return None;
    }
    let inertial = |frame: &Term| is_at_rest(frame, declarations);
    let fixed = declarations
        .iter()
        .find_map(|d| axis_fixed(&d.statement, pulley));
    fixed.filter(|frame| inertial(frame)).cloned()
}

/// "The axis of the pulley is fixed in N": the frame.
fn axis_fixed<'s>(statement: &'s Statement, pulley: &Term) -> Option<&'s Term> {
    match statement {
        Statement::Premise(axis) if axis.head == "axis" && axis.is("fixed") => {
            let plain = axis
                .adjectives
                .iter()
                .all(|said| matches!(*said, "fixed" | "horizontal"));
            let own = axis.slot(Slot::Of) == Some(pulley) && axis.slots.len() == 2;
            axis.slot(Slot::FixedIn).filter(|_| plain && own)
        }
        Statement::Is { subjects, what } if subjects.iter().any(|s| is_own_axis(s, pulley)) => {
            what.slot(Slot::FixedIn)
        }
        _ => None,
    }
}

/// What hangs from a string: one or two things, each with a letter of the tension there.
fn hanging(string: &Term, declarations: &[Declaration]) -> Option<Vec<(Term, String)>> {
    let mut hang = declarations.iter().filter_map(|d| {
        let (subjects, slots) = d.statement.does("hang")?;
        (slots == [(Slot::From, string.clone())]).then_some(subjects)
    });
    let things = hang.next()?;
    if hang.next().is_some() || !(1..=2).contains(&things.len()) {
        return None;
    }
    let particle = |thing: &Term| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => what.head == "particle" && subjects.contains(thing),
            _ => false,
        })
    };
    let only_hangs = |thing: &Term| {
        !declarations
            .iter()
            .any(|d| is_held_otherwise(d, thing, string))
    };
    let all = things
        .iter()
        .filter(|thing| only_hangs(thing))
        .map(|thing| {
            let letter = tension_at(thing, string, things.len() == 1, declarations)?;
            particle(thing).then(|| (thing.clone(), letter))
        });
    let all: Vec<(Term, String)> = all.collect::<Option<_>>()?;
    (all.len() == things.len()).then_some(all)
}

/// Whether something else than its weight and the string may act on a thing, or it is said how it moves.
fn is_held_otherwise(declaration: &Declaration, thing: &Term, string: &Term) -> bool {
    match &declaration.statement {
        Statement::Premise(list) => list.slot(Slot::Of) == Some(thing),
        statement => is_moved_or_loaded(statement, thing, string, &[Slot::Upon, Slot::At]),
    }
}

/// Whether a sentence moves a thing in another way than that it hangs, or has a load in one of some slots of it that is none of
/// the string.
pub(super) fn is_moved_or_loaded(
    statement: &Statement,
    thing: &Term,
    string: &Term,
    loaded: &[Slot],
) -> bool {
    match statement {
        Statement::Does {
            subjects,
            verb,
            slots,
        } => {
            let moves = subjects.contains(thing) && *verb != "hang";
            moves || *verb == "act" && slots.iter().any(|(_, term)| term == thing)
        }
        Statement::Is { what, .. } => {
            let other = is_load(what.head) && what.slot(Slot::Of) != Some(string);
            other && loaded.iter().any(|slot| what.slot(*slot) == Some(thing))
        }
        _ => false,
    }
}

/// The letter of the tension at what hangs there; where only one thing does, the point need not be said.
fn tension_at(
    thing: &Term,
    string: &Term,
    alone: bool,
    declarations: &[Declaration],
) -> Option<String> {
    declarations.iter().find_map(|d| {
        let Statement::Is { subjects, what } = &d.statement else {
            return None;
        };
        if what.head != TENSION || what.slot(Slot::Of) != Some(string) {
            return None;
        }
        let places: Vec<&Term> = what.all(Slot::At).collect();
        let at = match (places.as_slice(), subjects.len()) {
            ([], 1) if alone => 0,
            (places, count) if places.len() == count => {
                places.iter().position(|at| *at == thing)?
            }
            _ => return None,
        };
        match &subjects[at] {
            Term::Formula(letter) => Some(letter.source.clone()),
            _ => None,
        }
    })
}

/// What only says how things hang and turn, and the tensions.
fn is_of_pulley(statement: &Statement, told: &Pulley) -> bool {
    match statement {
        Statement::Does { subjects, verb, .. } => match *verb {
            "turn" => subjects.contains(&told.pulley),
            "wind" | "unwind" => subjects.contains(&told.string),
            "hang" => subjects
                .iter()
                .any(|s| told.hanging.iter().any(|(own, _)| own == s)),
            _ => false,
        },
        Statement::Is { subjects, what } => {
            let axis = subjects.iter().any(|s| is_own_axis(s, &told.pulley));
            let massless = what.head == "massless" && subjects.contains(&told.string);
            let tension = what.head == TENSION && what.slot(Slot::Of) == Some(&told.string);
            axis || massless || tension
        }
        Statement::Premise(_) => axis_fixed(statement, &told.pulley).is_some(),
        _ => false,
    }
}

pub(super) fn is(subject: &Term, head: &'static str, slots: Vec<(Slot, Term)>) -> Statement {
    Statement::one_is(subject.clone(), NounPhrase::new(head, slots))
}

/// "… are the only loads on …"
pub(super) fn only(head: &'static str, slots: Vec<(Slot, Term)>) -> Statement {
    let mut premise = NounPhrase::new(head, slots);
    premise.adjectives.push("only");
    Statement::Premise(premise)
}

pub(super) fn phrase(head: &'static str, slots: Vec<(Slot, Term)>) -> Term {
    Term::Phrase(Box::new(NounPhrase::new(head, slots)))
}

/// How all of it moves, and what acts.
fn statements(told: &Pulley, axes: [&Term; 3], macros: &Macros) -> Option<Vec<Statement>> {
    let mut all = turning(told, axes, macros)?;
    for at in 0..told.hanging.len() {
        all.extend(hung(told, at, macros)?);
    }
    let pulls = told.hanging.iter().enumerate().map(|(at, (_, tension))| {
        let sign = if at == 0 { "" } else { "-" };
        format!("{sign}\\left({tension}\\right)")
    });
    let pulls: String = pulls.collect();
    let moment = format!("\\left({pulls}\\right){}", told.radius);
    let moment = Term::Formula(formula(&moment, false, macros)?);
    let moments = vec![
        (Slot::Of, told.pulley.clone()),
        (Slot::Along, axes[1].clone()),
        (Slot::With, phrase(MOMENT, vec![(Slot::Which, moment)])),
    ];
    all.push(only(MOMENT, moments));
    Some(all)
}

/// The axes, and how the pulley turns about its own one, which is at rest.
fn turning(told: &Pulley, [i, j, k]: [&Term; 3], macros: &Macros) -> Option<Vec<Statement>> {
    let Pulley { pulley, ground, .. } = told;
    let centre = centre();
    let angle = Term::Formula(formula(ANGLE, false, macros)?);
    let angle = phrase("angle", vec![(Slot::Which, angle)]);
    Some(vec![
        Statement::Is {
            subjects: vec![i.clone(), j.clone(), k.clone()],
            what: NounPhrase::new("axes", vec![(Slot::Of, ground.clone())]),
        },
        Statement::one_is(k.clone(), vertical("upward")),
        Statement::Does {
            subjects: vec![pulley.clone()],
            verb: "turn",
            slots: vec![
                (Slot::RelativeTo, ground.clone()),
                (Slot::About, j.clone()),
                (Slot::By, angle),
            ],
        },
        is(pulley, "symmetric", vec![(Slot::About, j.clone())]),
        is(&centre, MASS_CENTRE, vec![(Slot::Of, pulley.clone())]),
        is(&centre, "fixed", vec![(Slot::FixedIn, ground.clone())]),
    ])
}

/// Where something hangs, and that its weight and the string are all that acts on it.
fn hung(told: &Pulley, at: usize, macros: &Macros) -> Option<Vec<Statement>> {
    let written = |source: &str| Some(Term::Formula(formula(source, false, macros)?));
    let (thing, tension) = told.hanging.get(at)?;
    let (depth, up, radius) = (DEPTHS.get(at)?, AXES[2], &told.radius);
    let turned = if at == 0 { "+" } else { "-" };
    let way = format!("-\\left({depth}{turned}{radius}{ANGLE}\\right){up}");
    let force = written(&format!("\\left({tension}\\right){up}"))?;
    let placed = Statement::Does {
        subjects: vec![thing.clone()],
        verb: "place",
        slots: vec![(Slot::From, centre()), (Slot::By, written(&way)?)],
    };
    let loads = vec![
        (Slot::Of, thing.clone()),
        (Slot::With, phrase(WEIGHT, vec![])),
        (Slot::With, phrase(FORCE, vec![(Slot::Which, force)])),
    ];
    let constant = is(&written(depth)?, CONSTANT, vec![]);
    Some(vec![placed, constant, only("load", loads)])
}

fn centre() -> Term {
    Term::Name(CENTRE.to_owned())
}

/// Moments of inertia about the axis of the pulley, and components along the vertical.
fn take_axes(statement: &mut Statement, told: &Pulley, j: &Term, k: &Term, macros: &Macros) {
    let Statement::Is { what, .. } = statement else {
        return;
    };
    let inertia = what.head == MOMENT_OF_INERTIA && what.slot(Slot::Of) == Some(&told.pulley);
    let component = what.head == "component";
    for (slot, axis) in &mut what.slots {
        match (&*slot, &*axis) {
            (Slot::About, own) if inertia && is_own_axis(own, &told.pulley) => {
                let slots = vec![(Slot::Through, centre()), (Slot::Along, j.clone())];
                *axis = Term::Phrase(Box::new(NounPhrase::new("axis", slots)));
            }
            (Slot::Along, Term::Phrase(upright))
                if component && upright.head == VERTICAL && upright.slots.is_empty() =>
            {
                let down = upright.is("downward");
                let against = || {
                    Some(Term::Formula(formula(
                        &format!("-{}", AXES[2]),
                        false,
                        macros,
                    )?))
                };
                *axis = if down {
                    against().unwrap_or(k.clone())
                } else {
                    k.clone()
                };
            }
            _ => {}
        }
    }
}
