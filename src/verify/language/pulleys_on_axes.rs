//! Strings over pulleys that turn about an axis of an inertial frame whose axes have names: what hangs goes down and up as the
//! pulley turns, by the side on which it hangs.

use super::heads::{MASS_CENTRE, TOWARDS, VERTICAL, WEIGHT};
use super::hung_on_pulleys::{as_particle, from_the_start, statements, turn_by_angle};
use super::is_load;
use super::kinds::name;
use super::pulleys::{TENSION, is_moved_or_loaded};
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use super::told_sizes::told_size;
use super::turned_lines::{Direction, direction};
use super::wound::{is_at_rest, winds};
use crate::notation::Macros;

/// The letter of the angle by which a pulley has turned where no sentence tells one.
const ANGLE: &str = "\\vartheta_{\\mathrm{pulley}}";

/// A pulley with what hangs from its string.
pub(super) struct Pulley {
    pub(super) string: Term,
    pub(super) pulley: Term,
    pub(super) centre: Term,
    pub(super) radius: String,
    pub(super) angle: String,
    /// The directions up and along the axis of the turn, as they are written.
    pub(super) up: String,
    pub(super) about: String,
    pub(super) hanging: Vec<Hanging>,
    pub(super) declaration: Declaration,
}

/// What hangs from the string.
pub(super) struct Hanging {
    pub(super) thing: Term,
    pub(super) tension: String,
    /// From the centre of the pulley to the side where it hangs.
    pub(super) side: String,
    /// Whether it goes down as the pulley turns forward.
    pub(super) falls: bool,
}

/// Says how the things that hang from the string of such a pulley move, and what acts on them and on the pulley.
pub(super) fn hang_beside_axes(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let Some(told) = pulley(declarations) else {
        return;
    };
    let Some(statements) = statements(&told, declarations, macros) else {
        return;
    };
    declarations.retain(|d| !is_of_string(&d.statement, &told));
    for declaration in declarations.iter_mut() {
        from_the_start(&mut declaration.statement, &told, macros);
        as_particle(&mut declaration.statement, &told);
        turn_by_angle(&mut declaration.statement, &told, macros);
    }
    declarations.extend(statements.into_iter().map(|s| told.declaration.saying(s)));
}

fn pulley(declarations: &[Declaration]) -> Option<Pulley> {
    let mut wound = declarations.iter().filter_map(|d| {
        let (string, pulley) = winds(&d.statement)?;
        Some((string.clone(), pulley.clone(), d))
    });
    let (string, pulley, declaration) = wound.next()?;
    if wound.next().is_some() || declaration.extent != Extent::Document {
        return None;
    }
    let up = upward(declarations)?;
    let turn = declarations.iter().find_map(|d| {
        let (subjects, slots) = d.statement.does("turn")?;
        subjects.contains(&pulley).then_some(slots)
    })?;
    let about = direction(slot(turn, Slot::About)?, declarations)?;
    let level = about.frame == up.frame && about.number != up.number;
    if !level || !is_at_rest(&about.frame, declarations) || !is_free(&pulley, declarations) {
        return None;
    }
    let angle = match slot(turn, Slot::By) {
        Some(by) => by.letter()?.source.clone(),
        // Of a rate without an angle the model makes its own one.
        None if slot(turn, Slot::At).is_some() => return None,
        None => ANGLE.to_owned(),
    };
    let axes = [&up, &about].map(|way| written(way, declarations));
    let [Some(up_written), Some(about_written)] = axes else {
        return None;
    };
    Some(Pulley {
        centre: centre(&pulley, declarations)?,
        radius: told_size("radius", &pulley, declarations)?.source.clone(),
        hanging: hanging(&string, (&up, &about), declarations)?,
        declaration: declaration.clone(),
        string,
        pulley,
        angle,
        up: up_written,
        about: about_written,
    })
}

/// The axis that is the vertical, as it points up.
fn upward(declarations: &[Declaration]) -> Option<Direction> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == VERTICAL && what.slots.is_empty() => {
            let own = direction(subjects.first()?, declarations)?;
            let reversed = own.reversed != what.is("downward");
            Some(Direction { reversed, ..own })
        }
        _ => None,
    })
}

/// A direction by the name of its axis.
fn written(way: &Direction, declarations: &[Declaration]) -> Option<String> {
    let name = way.axis_name(declarations)?;
    Some(if way.reversed {
        format!("-{name}")
    } else {
        name
    })
}

/// Whether the bearing of the pulley is smooth, and no sentence tells of loads on the pulley.
fn is_free(pulley: &Term, declarations: &[Declaration]) -> bool {
    let smooth = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let joint = |s: &Term| name(s).is_some_and(|n| !n.contains("string"));
            what.head == "smooth" && subjects.iter().all(joint)
        }
        Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } => {
            let freely = slots.iter().any(|(slot, _)| *slot == Slot::With);
            freely && subjects.contains(pulley)
        }
        _ => false,
    });
    let loaded = declarations.iter().any(|d| match &d.statement {
        Statement::Is { what, .. } => is_load(what.head) && what.slot(Slot::Upon) == Some(pulley),
        Statement::Premise(list) => list.is("only") && list.slot(Slot::Of) == Some(pulley),
        _ => false,
    });
    smooth && !loaded
}

/// The centre of the pulley, which is at rest.
fn centre(pulley: &Term, declarations: &[Declaration]) -> Option<Term> {
    let told = declarations.iter().filter_map(|d| match &d.statement {
        Statement::Is { subjects, what } if matches!(what.head, "centre" | MASS_CENTRE) => {
            (what.slot(Slot::Of) == Some(pulley)).then(|| subjects.first())?
        }
        _ => None,
    });
    let fixed = |point: &&Term| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let frames = what.all(Slot::FixedIn).filter(|frame| *frame != pulley);
                subjects.contains(point) && frames.count() > 0
            }
            _ => false,
        })
    };
    let mut told = told.filter(fixed);
    told.next().cloned()
}

/// What hangs from the string: where the sides are not told and the pulley turns by no letter the first one goes down.
fn hanging(
    string: &Term,
    (up, about): (&Direction, &Direction),
    declarations: &[Declaration],
) -> Option<Vec<Hanging>> {
    let mut things = vec![];
    for declaration in declarations {
        let Some((subjects, slots)) = declaration.statement.does("hang") else {
            continue;
        };
        if slot(slots, Slot::From) != Some(string) {
            continue;
        }
        let side = slots.iter().find_map(|(_, term)| match term {
            Term::Phrase(way) if way.head == TOWARDS => way.slot(Slot::Of),
            _ => None,
        })?;
        let side = direction(side, declarations)?;
        let [thing] = subjects else { return None };
        if [up.number, about.number].contains(&side.number) || side.frame != up.frame {
            return None;
        }
        // About the axis the rim on this side moves along the cross product of both.
        let cyclic = side.number == about.number % 3 + 1;
        let rises = (cyclic != (about.reversed != side.reversed)) != up.reversed;
        let at = things.len() + 1;
        let own = tension_at(thing, string, declarations);
        things.push(Hanging {
            thing: thing.clone(),
            tension: own.unwrap_or_else(|| format!("S_{{\\mathrm{{pulley}}{at}}}")),
            side: written(&side, declarations)?,
            falls: !rises,
        });
    }
    let opposed = match things.as_slice() {
        [one, other] => one.falls != other.falls,
        things => things.len() == 1,
    };
    let held = |d: &Declaration| things.iter().any(|hung| is_held(d, &hung.thing, string));
    (opposed && !declarations.iter().any(held)).then_some(things)
}

/// The letter of the tension at a thing.
fn tension_at(thing: &Term, string: &Term, declarations: &[Declaration]) -> Option<String> {
    declarations.iter().find_map(|d| {
        let Statement::Is { subjects, what } = &d.statement else {
            return None;
        };
        let own = what.head == TENSION && what.slot(Slot::Of) == Some(string);
        let places: Vec<&Term> = what.all(Slot::At).filter(|_| own).collect();
        let at = places.iter().position(|at| *at == thing)?;
        let letter = subjects
            .get(at)
            .filter(|_| places.len() == subjects.len())?;
        Some(letter.letter()?.source.clone())
    })
}

/// Whether something else than its weight and the string may act on a thing, or it is said where it is.
fn is_held(declaration: &Declaration, thing: &Term, string: &Term) -> bool {
    match &declaration.statement {
        Statement::Premise(list) => concerns(list, thing) && !lists_weight_and_string(list, string),
        statement => is_moved_or_loaded(statement, thing, string, &[Slot::Upon]),
    }
}

/// Whether a list is that of the loads on a thing, or on each of its kind: "the block" of block 1 and block 2.
fn concerns(list: &NounPhrase, thing: &Term) -> bool {
    let Some(of) = list.slot(Slot::Of) else {
        return false;
    };
    let kind = name(thing).zip(name(of));
    of == thing || kind.is_some_and(|(own, kind)| own.starts_with(&format!("{kind} ")))
}

/// "The weight and the string are the only loads on the block."
fn lists_weight_and_string(list: &NounPhrase, string: &Term) -> bool {
    let known = |load: &Term| match load {
        Term::Phrase(load) => load.head == WEIGHT || load.slot(Slot::Of) == Some(string),
        load => load == string,
    };
    let plain = list.slot(Slot::About).is_none() && list.slot(Slot::Along).is_none();
    list.is("only") && plain && list.all(Slot::With).all(known)
}

/// What only says how things hang, and the tensions.
fn is_of_string(statement: &Statement, told: &Pulley) -> bool {
    let hung = |term: &Term| told.hanging.iter().any(|own| own.thing == *term);
    match statement {
        Statement::Does { subjects, verb, .. } => match *verb {
            "wind" | "unwind" | "grip" => subjects.contains(&told.string),
            "hang" => subjects.iter().any(hung),
            _ => false,
        },
        Statement::Is { subjects, what } => {
            let own = subjects.contains(&told.string);
            let tension = what.head == TENSION && what.slot(Slot::Of) == Some(&told.string);
            own && matches!(what.head, "massless" | "inextensible" | "string") || tension
        }
        Statement::Premise(list) => {
            let mut hanging = told.hanging.iter();
            hanging.any(|own| concerns(list, &own.thing))
        }
        _ => false,
    }
}
