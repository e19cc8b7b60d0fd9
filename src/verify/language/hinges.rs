//! Hinges: the point of a hinge is fixed in each of the bodies that it joins, and an end by which a body is hinged is there.

use super::heads::{ACCELERATION, FORCE, VELOCITY};
use super::kinds::{name, rename};
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};

/// Verbs of bodies that are joined at a point.
const JOINS: [&str; 3] = ["hinge", "pin", "pivot"];

/// The noun of a point of what is long.
const END: &str = "end";

/// What only points have that move.
const MOTIONS: [&str; 3] = [VELOCITY, ACCELERATION, "speed"];

/// What is called so is the only hinge of the document.
const CALLED: [&str; 2] = ["joint", "pivot"];

/// What stands still where no sentence says that it moves.
const SUPPORTS: [&str; 7] = [
    "floor", "wall", "support", "bearing", "table", "ceiling", "ground",
];

/// "the speed of the free end E of the rod": the speed of E, which is an end of the rod.
pub(crate) fn name_ends(declarations: &mut Vec<Declaration>) {
    let mut named = vec![];
    for declaration in declarations.iter_mut() {
        let mut ends = vec![];
        for term in declaration.statement.terms_mut() {
            name_end(term, &mut ends);
        }
        named.extend(ends.into_iter().map(|end| declaration.saying(end)));
    }
    for end in named {
        if !declarations.iter().any(|d| d.statement == end.statement) {
            declarations.push(end);
        }
    }
}

/// Puts the name of an end in its place, and tells what that is.
fn name_end(term: &mut Term, ends: &mut Vec<Statement>) {
    let Term::Phrase(phrase) = term else { return };
    if let (END, Some(point), Some(body)) = (
        phrase.head,
        phrase.slot(Slot::Which).cloned(),
        phrase.slot(Slot::Of).cloned(),
    ) {
        let mut what = NounPhrase::new(END, vec![(Slot::Of, body)]);
        what.adjectives.clone_from(&phrase.adjectives);
        ends.push(Statement::Is {
            subjects: vec![point.clone()],
            what,
        });
        *term = point;
        return;
    }
    for (_, inner) in &mut phrase.slots {
        name_end(inner, ends);
    }
}

/// A hinge, as a sentence tells it.
struct Hinge {
    body: Term,
    point: Term,
    /// What the body is joined to; nothing is said of what stands still.
    to: Option<Term>,
    /// What is said of the end by which it is joined, if it is by one.
    end: Option<Vec<&'static str>>,
    about: Option<Term>,
}

/// "The rod is hinged to the shaft at its end O": O is a point fixed in both, and an end of the rod.
pub(crate) fn tell_hinges(declarations: &mut Vec<Declaration>) {
    let mut points: Vec<Term> = vec![];
    let mut told = vec![];
    for declaration in declarations.iter() {
        match hinge(&declaration.statement, declarations) {
            Some(hinge) => {
                if !points.contains(&hinge.point) {
                    points.push(hinge.point.clone());
                }
                let statements = statements(hinge, declarations).into_iter();
                told.extend(statements.map(|statement| declaration.saying(statement)));
            }
            None => told.push(declaration.clone()),
        }
    }
    if let [point] = points.as_slice() {
        name_joint(&mut told, point);
    }
    tell_other_ends(&mut told);
    *declarations = told;
}

/// "A is the free end of the link", of a link that is hinged at one other point as well: that is its other end.
fn tell_other_ends(told: &mut Vec<Declaration>) {
    let mut others = vec![];
    for declaration in told.iter() {
        let Statement::Is { subjects, what } = &declaration.statement else {
            continue;
        };
        let ([end], Some(body), true) = (
            subjects.as_slice(),
            what.slot(Slot::Of),
            what.head == END && what.is("free"),
        ) else {
            continue;
        };
        let joined = |d: &&Declaration| match &d.statement {
            Statement::Is { subjects, what } => {
                let fixed = what.head == "point" && what.all(Slot::FixedIn).any(|own| own == body);
                fixed && !subjects.contains(end) && is_of_hinge(&d.text)
            }
            _ => false,
        };
        let hinges: Vec<&Declaration> = told.iter().filter(joined).collect();
        if let [hinge] = hinges.as_slice()
            && let [point] = hinge.statement.subjects()
        {
            let is = NounPhrase::new(END, vec![(Slot::Of, body.clone())]);
            others.push(declaration.saying(Statement::one_is(point.clone(), is)));
        }
    }
    others.retain(|d| !told.iter().any(|said| said.statement == d.statement));
    told.extend(others);
}

/// Whether a sentence speaks of a hinge.
fn is_of_hinge(text: &str) -> bool {
    HINGED.iter().any(|word| text.contains(word))
}

/// Words of sentences from which the points of hinges come.
const HINGED: [&str; 3] = ["hinge", "pinned", "pivot"];

/// Puts the point of the only joint in the place of that: forces of the joint act there.
pub(super) fn name_joint(declarations: &mut [Declaration], point: &Term) {
    let Some(called) = name(point) else { return };
    for declaration in declarations {
        if let Statement::Is { what, .. } = &mut declaration.statement {
            act_at(what, point);
        }
        for term in declaration.statement.terms_mut() {
            if let Term::Phrase(phrase) = term {
                act_at(phrase, point);
            }
            CALLED.iter().for_each(|noun| rename(term, noun, &called));
        }
    }
}

/// "the force of the hinge on the rod": the force at it.
fn act_at(phrase: &mut NounPhrase, point: &Term) {
    let of_joint = |(slot, of): &(Slot, Term)| {
        let called = match of {
            Term::Phrase(joint) if joint.slots.is_empty() => Some(joint.head.to_owned()),
            _ => name(of),
        };
        *slot == Slot::Of && called.is_some_and(|called| CALLED.contains(&called.as_str()))
    };
    if phrase.head == FORCE && phrase.slots.iter().any(of_joint) {
        phrase.slots.retain(|said| !of_joint(said));
        if phrase.slot(Slot::At).is_none() {
            phrase.slots.push((Slot::At, point.clone()));
        }
    }
    for (_, inner) in &mut phrase.slots {
        if let Term::Phrase(inner) = inner {
            act_at(inner, point);
        }
    }
}

fn hinge(statement: &Statement, declarations: &[Declaration]) -> Option<Hinge> {
    let Statement::Does {
        subjects,
        verb,
        slots,
    } = statement
    else {
        return None;
    };
    let ([subject], true) = (subjects.as_slice(), JOINS.contains(verb)) else {
        return None;
    };
    let said = |wanted| {
        let mut terms = slots.iter().filter(|(slot, _)| *slot == wanted);
        let first = terms.next().map(|(_, term)| term);
        first.filter(|_| terms.next().is_none())
    };
    let known = [Slot::At, Slot::To, Slot::On, Slot::About];
    if slots.iter().any(|(slot, _)| !known.contains(slot)) {
        return None;
    }
    let (body, by_end) = match subject {
        Term::Phrase(end) if end.head == END => {
            (end.slot(Slot::Of)?.clone(), Some(end.adjectives.clone()))
        }
        _ => (subject.clone(), None),
    };
    let to = said(Slot::To).or_else(|| said(Slot::On));
    let (place, to) = match said(Slot::At) {
        Some(place) => (place, to),
        None => (to.filter(|to| !is_said_to_be(to, declarations))?, None),
    };
    let (point, at_end) = match place {
        Term::Phrase(end) if end.head == END && end.all(Slot::Which).count() == 1 => {
            (end.slot(Slot::Which)?.clone(), Some(end.adjectives.clone()))
        }
        Term::Phrase(point) if point.head == "point" => (point.slot(Slot::Which)?.clone(), None),
        _ => (place.clone(), None),
    };
    let spoken_of = name(&point).is_some_and(|name| is_spoken_of(&name, declarations));
    let named = |t: &Term| name(t).is_some_and(|name| !name.starts_with(char::is_lowercase));
    (named(&point) && !spoken_of).then(|| Hinge {
        body,
        point,
        to: to.cloned(),
        end: by_end.or(at_end),
        about: said(Slot::About).cloned(),
    })
}

/// Whether a sentence that is not understood speaks of a point: it may say that it moves.
fn is_spoken_of(point: &str, declarations: &[Declaration]) -> bool {
    let mut unread = declarations.iter().filter(|d| d.is_unread());
    unread.any(|d| {
        let mut words = d.text.split(|c: char| !c.is_alphanumeric());
        words.any(|word| word == point)
    })
}

/// Whether a sentence says that something is a thing that is no point.
fn is_said_to_be(thing: &Term, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => what.head != "point" && subjects.contains(thing),
        _ => false,
    })
}

fn statements(hinge: Hinge, declarations: &[Declaration]) -> Vec<Statement> {
    let is = |head, slots| Statement::Is {
        subjects: vec![hinge.point.clone()],
        what: NounPhrase::new(head, slots),
    };
    let still = |to: &Term| {
        let moves = |d: &Declaration| d.statement.subjects().contains(to);
        let called = match to {
            Term::Phrase(thing) if thing.adjectives.iter().all(|said| *said == "fixed") => {
                Some(thing.head.to_owned())
            }
            _ => name(to),
        };
        let support = called.is_some_and(|name| SUPPORTS.contains(&name.as_str()));
        support && !declarations.iter().any(moves)
    };
    let mut point = match hinge.to.clone().filter(|to| !still(to)) {
        Some(to) => is(
            "point",
            vec![(Slot::FixedIn, hinge.body.clone()), (Slot::FixedIn, to)],
        ),
        None if is_fixed_elsewhere(&hinge, declarations) => {
            is("point", vec![(Slot::FixedIn, hinge.body.clone())])
        }
        None => is("point", vec![(Slot::Of, hinge.body.clone())]),
    };
    if let Statement::Is { what, .. } = &mut point
        && what.slot(Slot::FixedIn).is_none()
    {
        what.adjectives.push("fixed");
    }
    let end = |adjectives: Vec<&'static str>| {
        let mut end = is(END, vec![(Slot::Of, hinge.body.clone())]);
        if let Statement::Is { what, .. } = &mut end {
            what.adjectives = adjectives;
        }
        end
    };
    let turn = |about| Statement::Does {
        subjects: vec![hinge.body.clone()],
        verb: "turn",
        slots: vec![(Slot::About, about)],
    };
    let end = hinge.end.clone().map(end);
    let turn = hinge.about.clone().map(turn);
    [point].into_iter().chain(end).chain(turn).collect()
}

/// Whether another sentence says what the point of a hinge is fixed in, or that it moves.
fn is_fixed_elsewhere(hinge: &Hinge, declarations: &[Declaration]) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { what, .. } if MOTIONS.contains(&what.head) => {
            what.all(Slot::Of).any(|of| *of == hinge.point)
        }
        Statement::Is { subjects, what } => {
            let mut fixed = what.all(Slot::FixedIn);
            subjects.contains(&hinge.point) && fixed.any(|other| *other != hinge.body)
        }
        Statement::Does { subjects, .. } if subjects.contains(&hinge.point) => true,
        Statement::Does { verb, slots, .. } if JOINS.contains(verb) => {
            let at = slots.contains(&(Slot::At, hinge.point.clone()));
            let other = slot(slots, Slot::To).is_some_and(|to| Some(to) != hinge.to.as_ref());
            at && other
        }
        _ => false,
    })
}
