//! Rigid bodies that consist of particles or of other bodies: these are fixed in them.

use super::heads::ANGULAR_VELOCITY;
use super::is_body;
use super::kinds::name;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term};

/// The noun of two particles on a rod.
const RIGID: &str = "dumb-bell";

/// "The dumb-bell consists of two particles": they are points of a frame that is fixed in it.
pub(crate) fn fix_particles(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for declaration in declarations.iter() {
        let Some(([whole @ Term::Name(called)], parts)) = declaration.statement.does("consist")
        else {
            continue;
        };
        let parts: Vec<Term> = parts.iter().map(|(_, part)| part.clone()).collect();
        let particles = parts
            .iter()
            .all(|part| is_said(part, declarations, is_particle));
        let rigid = called == RIGID || is_said(whole, declarations, |what| what.is("rigid"));
        let keeps = rigid || has_frame(whole, declarations) || turns_as_one(whole, declarations);
        if keeps && !particles && called != RIGID {
            let still = parts.iter().filter(|part| stands_still(part, declarations));
            let fixed = |part: &Term| {
                let inside = vec![(Slot::FixedIn, whole.clone())];
                Statement::one_is(part.clone(), NounPhrase::new("fixed", inside))
            };
            told.extend(still.map(|part| declaration.saying(fixed(part))));
        }
        if let Some(base) = base_of(&parts, declarations) {
            let fixed = |frame: &Term| {
                let inside = vec![(Slot::FixedIn, whole.clone())];
                Statement::one_is(frame.clone(), NounPhrase::new("fixed", inside))
            };
            let frames = frames_fixed_in(base, declarations);
            told.extend(frames.map(|frame| declaration.saying(fixed(frame))));
        }
        if !particles || !rigid {
            continue;
        }
        let inside = |noun| NounPhrase::new(noun, vec![(Slot::FixedIn, whole.clone())]);
        let are = Statement::Is {
            subjects: parts,
            what: inside("point"),
        };
        told.push(declaration.saying(are));
        if !has_frame(whole, declarations) {
            let frame = Term::Name(format!("frame of {called}"));
            told.push(declaration.saying(Statement::one_is(frame, inside("frame"))));
        }
    }
    declarations.extend(told);
}

/// "The body consists of the plate and two particles", which are fixed in the plate: the part in which all others are fixed.
fn base_of<'t>(parts: &'t [Term], declarations: &[Declaration]) -> Option<&'t Term> {
    let fixed_in = |part: &Term, base: &Term| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let inside: Vec<&Term> = what.all(Slot::FixedIn).collect();
                subjects.contains(part) && inside == [base] && d.extent == Extent::Document
            }
            _ => false,
        })
    };
    let mut bases = parts.iter().filter(|base| {
        let mut others = parts.iter().filter(|part| part != base);
        parts.len() > 1 && others.all(|part| fixed_in(part, base))
    });
    bases.next().filter(|_| bases.next().is_none())
}

fn frames_fixed_in<'d>(
    body: &Term,
    declarations: &'d [Declaration],
) -> impl Iterator<Item = &'d Term> {
    let frames = declarations.iter().filter_map(move |d| match &d.statement {
        Statement::Is { subjects, what } if what.head == "frame" => {
            let inside: Vec<&Term> = what.all(Slot::FixedIn).collect();
            (inside == [body]).then_some(subjects)
        }
        _ => None,
    });
    frames.flatten()
}

/// "The pendulum turns relative to N about z by the angle `$q$`": what turns so is one rigid body.
fn turns_as_one(whole: &Term, declarations: &[Declaration]) -> bool {
    let turns = |d: &Declaration| {
        let turn = d.statement.does("turn").or(d.statement.does("swing"));
        turn.is_some_and(|(subjects, _)| subjects.contains(whole))
    };
    declarations.iter().any(turns)
}

/// Whether a thing is a body, and no sentence says how it moves, what it is fixed in or what is fixed in it.
fn stands_still(part: &Term, declarations: &[Declaration]) -> bool {
    let moves = |d: &Declaration| match &d.statement {
        Statement::Does { subjects, verb, .. } => {
            !PLACING.contains(verb) && subjects.contains(part)
        }
        Statement::Is { subjects, what } => {
            let fixed = what.head == "fixed" || what.slot(Slot::FixedIn).is_some();
            let carries = what.all(Slot::FixedIn).any(|of| of == part);
            let of_part = what.slots.iter().any(|(_, of)| of == part);
            let turned = MOTIONS.contains(&what.head) && of_part;
            fixed && subjects.contains(part) || carries || turned
        }
        _ => false,
    };
    let body = |what: &NounPhrase| is_body(what.head) && !is_particle(what);
    // What has no noun is a point, and a plural names several.
    let named = match part {
        Term::Name(name) => name.starts_with(char::is_lowercase) && !name.ends_with('s'),
        _ => false,
    };
    let one = named && !is_said(part, declarations, is_particle);
    (one || is_said(part, declarations, body)) && !declarations.iter().any(moves)
}

/// What tells that a body moves in another one.
const MOTIONS: [&str; 5] = [ANGULAR_VELOCITY, "spin", "rate", "angle", "rotation matrix"];

/// Verbs that tell where a body is, and not that it moves.
const PLACING: [&str; 7] = [
    "lie",
    "extend",
    "place",
    "point",
    "pass",
    "have",
    "have components",
];

fn is_particle(what: &NounPhrase) -> bool {
    what.head == "particle"
}

/// Whether sentences say something of a thing by a noun.
fn is_said(thing: &Term, all: &[Declaration], of: impl Fn(&NounPhrase) -> bool) -> bool {
    let own = |subject: &Term| name(subject).is_some() && name(subject) == name(thing);
    all.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => of(what) && subjects.iter().any(own),
        _ => false,
    })
}

/// Whether a frame is said to be fixed in a body.
pub(super) fn has_frame(body: &Term, all: &[Declaration]) -> bool {
    all.iter().any(|d| match &d.statement {
        Statement::Is { what, .. } => {
            what.head == "frame" && what.all(Slot::FixedIn).any(|fixed| fixed == body)
        }
        _ => false,
    })
}
