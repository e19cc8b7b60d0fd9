//! Impacts on bodies that hang: nothing changes its place in an impact. How a body hangs just before it is how it hangs at an
//! angle that is zero then, and what strikes it comes by a way from the point there which is zero then.

use super::heads::{SUDDEN, VERTICAL, WITHOUT_FRICTION};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};
use crate::notation::Macros;

/// The angle by which a body turns that hangs at the impact, and the way of what strikes it from where it does so.
const ANGLE: &str = "\\varphi_{\\text{from the impact}}";
const WAY: &str = "\\vec d_{\\text{from the impact}}";

/// How things turn that only hinges hold.
const MANNERS: [&str; 2] = [WITHOUT_FRICTION, "freely"];

/// "Just before the impact the rod hangs from O", of a rod that turns about an axis: it turns by an angle and hangs where that
/// is zero, as it is then. Gives the bodies that hang downward.
pub(super) fn hang_at_impact(declarations: &mut Vec<Declaration>, macros: &Macros) -> Vec<Term> {
    let mut downward = vec![];
    let said = declarations.iter().enumerate();
    let mut said = said.filter_map(|(at, d)| Some((at, hung(&d.statement)?)));
    let (Some((at, hung)), None) = (said.next(), said.next()) else {
        return downward;
    };
    let (Some(letter), Some(zero)) = (
        formula(ANGLE, false, macros),
        formula(&format!("{ANGLE}=0"), false, macros),
    ) else {
        return downward;
    };
    let turns = |d: &Declaration| turns_somehow(&d.statement, &hung.body);
    let Some(turn) = declarations.iter().position(turns) else {
        return downward;
    };
    turn_by(&mut declarations[turn].statement, &letter);
    let said = declarations[at].clone();
    declarations[at].statement = with_condition(hung.place, &zero);
    let none = NounPhrase::new("zero", vec![hung.when.clone()]);
    declarations.push(said.saying(Statement::one_is(Term::Formula(letter), none)));
    if hung.rests {
        let rest = NounPhrase::new("at rest", vec![hung.when]);
        declarations.push(said.saying(Statement::one_is(hung.body.clone(), rest)));
    }
    downward.extend(hung.downward.then_some(hung.body));
    downward
}

/// How a body is placed at an impact.
struct Hung {
    body: Term,
    place: Statement,
    when: (Slot, Term),
    rests: bool,
    downward: bool,
}

/// What a statement says of how a body is placed at an impact.
fn hung(statement: &Statement) -> Option<Hung> {
    match statement {
        Statement::Does {
            subjects,
            verb: verb @ ("hang" | "lie" | "point"),
            slots,
        } => {
            let ([body], when) = (subjects.as_slice(), time_of_impact(slots)?) else {
                return None;
            };
            let rests = |said: &(Slot, Term)| said.0 == Slot::At && said.1.is_noun("rest");
            let others = slots.iter().filter(|said| **said != when && !rests(said));
            let place = others.cloned().map(|said| match (*verb, end_above(&said)) {
                ("hang", Some(end)) => (Slot::From, end),
                _ => said,
            });
            Some(Hung {
                body: body.clone(),
                rests: slots.iter().any(rests),
                downward: *verb == "hang",
                place: Statement::Does {
                    subjects: subjects.clone(),
                    verb,
                    slots: place.collect(),
                },
                when,
            })
        }
        Statement::Is { subjects, what } if what.head == VERTICAL && what.is("downward") => {
            let ([body], when) = (subjects.as_slice(), time_of_impact(&what.slots)?) else {
                return None;
            };
            let mut place = what.clone();
            place.slots.retain(|said| *said != when);
            Some(Hung {
                body: body.clone(),
                rests: false,
                downward: true,
                place: Statement::one_is(body.clone(), place),
                when,
            })
        }
        _ => None,
    }
}

/// "below O"
fn end_above((_, place): &(Slot, Term)) -> Option<Term> {
    match place {
        Term::Phrase(place) if place.head == "below" => place.slot(Slot::Of).cloned(),
        _ => None,
    }
}

/// "just before the impact"
fn time_of_impact(slots: &[(Slot, Term)]) -> Option<(Slot, Term)> {
    let at_impact = |term: &Term| match term {
        Term::Phrase(when) if matches!(when.head, "before" | "after") => {
            let mut events = when.all(Slot::Of);
            events.any(|event| SUDDEN.iter().any(|sudden| event.is_noun(sudden)))
        }
        _ => false,
    };
    slots.iter().find(|(_, term)| at_impact(term)).cloned()
}

/// "The rod turns relative to N about the axis through O along z", by no angle that a sentence tells.
fn turns_somehow(statement: &Statement, body: &Term) -> bool {
    let Some((subjects, slots)) = statement.does("turn") else {
        return false;
    };
    let known = |(slot, how): &(Slot, Term)| match slot {
        Slot::About | Slot::RelativeTo => true,
        _ => MANNERS.iter().any(|manner| how.is_noun(manner)),
    };
    subjects == [body.clone()] && slot(slots, Slot::About).is_some() && slots.iter().all(known)
}

fn turn_by(statement: &mut Statement, letter: &Formula) {
    if let Statement::Does { slots, .. } = statement {
        slots.retain(|(slot, _)| matches!(slot, Slot::About | Slot::RelativeTo));
        let which = (Slot::Which, Term::Formula(letter.clone()));
        let angle = NounPhrase::new("angle", vec![which]);
        slots.push((Slot::By, Term::Phrase(Box::new(angle))));
    }
}

fn with_condition(mut statement: Statement, zero: &Formula) -> Statement {
    let condition = (Slot::At, Term::Formula(zero.clone()));
    match &mut statement {
        Statement::Does { slots, .. } => slots.push(condition),
        Statement::Is { what, .. } => what.slots.push(condition),
        _ => {}
    }
    statement
}

/// "The bullet strikes the rod at A": A is fixed in the rod, and there the bullet is in the impact.
pub(super) fn place_what_strikes(
    declarations: &mut Vec<Declaration>,
    downward: &[Term],
    macros: &Macros,
) {
    let strikes = declarations.iter().enumerate();
    let mut strikes = strikes.filter_map(|(at, d)| {
        let (subjects, slots) = d.statement.does("strike")?;
        let [striker] = subjects else { return None };
        let (struck, there) = (slot(slots, Slot::On)?, slot(slots, Slot::At)?);
        Some((at, striker.clone(), struck.clone(), there.clone()))
    });
    let (Some((at, striker, struck, there)), None) = (strikes.next(), strikes.next()) else {
        return;
    };
    let way = formula(WAY, false, macros).filter(|_| is_particle(&striker, declarations));
    let Some(way) = way.filter(|_| !is_placed(&striker, declarations)) else {
        return;
    };
    place_on_hung(&there, &struck, downward.contains(&struck), declarations);
    let said = declarations[at].clone();
    let fixed = NounPhrase::new("point", vec![(Slot::FixedIn, struck)]);
    declarations.push(said.saying(Statement::one_is(there.clone(), fixed)));
    let way = Term::Formula(way);
    declarations.push(said.saying(Statement::Does {
        subjects: vec![striker],
        verb: "place",
        slots: vec![(Slot::From, there), (Slot::By, way.clone())],
    }));
    let impact = Term::Phrase(Box::new(NounPhrase::new("impact", vec![])));
    let before = Term::Phrase(Box::new(NounPhrase::new(
        "before",
        vec![(Slot::Of, impact)],
    )));
    let none = NounPhrase::new("zero", vec![(Slot::With, before)]);
    declarations.push(said.saying(Statement::one_is(way, none)));
}

fn is_particle(thing: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head == "particle" && subjects.contains(thing),
        _ => false,
    })
}

/// Whether a sentence tells where something is.
fn is_placed(thing: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Does {
            subjects,
            verb: "lie" | "place" | "slide" | "roll",
            ..
        } => subjects.contains(thing),
        Statement::Is { subjects, what } => {
            what.slot(Slot::FixedIn).is_some() && subjects.contains(thing)
        }
        _ => false,
    })
}

/// "A lies at the distance `$b$` below O", of a rod that hangs from O: it lies so far from O along it.
fn place_on_hung(point: &Term, body: &Term, downward: bool, declarations: &mut [Declaration]) {
    let line = declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if subjects.contains(body) => Some((
            what.slot(Slot::From)?.clone(),
            what.slot(Slot::Along)?.clone(),
        )),
        _ => None,
    });
    let Some((end, along)) = line else { return };
    for declaration in declarations {
        let (subjects, slots) = match &declaration.statement {
            Statement::Does {
                subjects,
                verb: "lie",
                slots,
            } => (subjects, slots),
            Statement::Is { subjects, what } if what.head == "point" => (subjects, &what.slots),
            _ => continue,
        };
        let below = slots.iter().find_map(end_above).filter(|_| downward);
        let from = below.or_else(|| {
            let along = slot(slots, Slot::Along).is_some();
            slot(slots, Slot::From).filter(|_| !along).cloned()
        });
        let (Some(distance), Some(from)) = (slot(slots, Slot::At).cloned(), from) else {
            continue;
        };
        if subjects.as_slice() == [point.clone()] && from == end {
            declaration.statement = Statement::Does {
                subjects: vec![point.clone()],
                verb: "lie",
                slots: vec![
                    (Slot::At, distance),
                    (Slot::From, end.clone()),
                    (Slot::Along, along.clone()),
                ],
            };
        }
    }
}
