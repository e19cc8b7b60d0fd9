//! Names that no sentence introduces, by what is said of them: what turns or has Euler angles is a frame, and what has a
//! velocity is a point.

use super::frames_shown::frames_shown;
use super::heads::{ACCELERATION, MASS, POSITION, UNIT_VECTOR, VELOCITY};
use super::kinds::name;
use super::statement::{Declaration, Extent, NounPhrase, Slot, Statement, Term, slot};
use std::collections::BTreeSet;

/// Adds "B is a frame" and "P is a point" for the names that sentences use so, where none says what they are.
pub(crate) fn introduce(declarations: &mut Vec<Declaration>) {
    let mut told: BTreeSet<String> = declarations.iter().flat_map(told_in).collect();
    let shown = frames_shown(declarations);
    let fixed: BTreeSet<String> = declarations.iter().filter_map(fixed_thing).collect();
    let massive: BTreeSet<String> = declarations.iter().flat_map(massive_things).collect();
    let moves_as_a_point = |name: &String| {
        let mut all = declarations.iter();
        all.all(|d| may_be_of_a_particle(&d.statement, name))
    };
    let massive: BTreeSet<String> = massive.into_iter().filter(moves_as_a_point).collect();
    let told_particle = declarations.iter().any(|d| tells_a_particle(&d.statement));
    let mut added = vec![];
    let own = declarations
        .iter()
        .find(|d| d.extent == Extent::Document && speaks_of_particle(&d.statement));
    if let Some(own) = own.filter(|_| !told_particle && told.insert(PARTICLE.to_owned())) {
        let what = NounPhrase::new(PARTICLE, vec![]);
        added.push(own.saying(Statement::one_is(Term::Name(PARTICLE.to_owned()), what)));
    }
    for declaration in declarations.iter() {
        let mentioned = declaration.statement.terms().into_iter().filter_map(name);
        let frames = mentioned.filter(|name| shown.contains(name));
        let kinds = turning(&declaration.statement)
            .into_iter()
            .chain(frames)
            .map(|name| (name, "frame"));
        let from = places_from(&declaration.statement).into_iter();
        let from = from.filter(|name| fixed.contains(name));
        let points = moving_points(&declaration.statement).into_iter();
        let points = points.chain(from);
        let points = points.map(|name| match massive.contains(&name) {
            true => (name, PARTICLE),
            false => (name, "point"),
        });
        let kinds = kinds.chain(points);
        if let Some((point, what)) = point_of_axis(&declaration.statement)
            && name(point).is_some_and(|name| may_be_introduced(&name) && told.insert(name))
        {
            added.push(declaration.saying(Statement::one_is(point.clone(), what)));
        }
        for (name, kind) in kinds {
            if may_be_introduced(&name) && told.insert(name.clone()) {
                let what = NounPhrase::new(kind, vec![]);
                added.push(declaration.saying(Statement::one_is(Term::Name(name), what)));
            }
        }
    }
    // "O and P are fixed in B": points that are.
    let points: BTreeSet<String> = added.iter().filter_map(introduced_point).collect();
    for declaration in declarations.iter_mut() {
        let own = |subject: &Term| name(subject).is_some_and(|name| points.contains(&name));
        if declaration.statement.subjects().iter().all(own) {
            declaration.statement.is_of(Some("point"));
        }
    }
    declarations.extend(added);
}

/// The name of what is introduced as a point.
fn introduced_point(declaration: &Declaration) -> Option<String> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == "point" => name(subjects.first()?),
        _ => None,
    }
}

/// The names of which a sentence says what they are, or that stand for others.
fn told_in(declaration: &Declaration) -> Vec<String> {
    let statement = &declaration.statement;
    let own = match statement {
        Statement::Does { verb: "turn", .. } => &[],
        Statement::Same { others, .. } => others.as_slice(),
        _ => &[],
    };
    let subjects = match statement {
        Statement::Does { verb: "turn", .. } => &[],
        Statement::Is { subjects, what } if what.head == "fixed" => match subjects.as_slice() {
            [_] => &[],
            several => several,
        },
        statement => statement.subjects(),
    };
    let which = statement.slots().flatten();
    let which = which.filter(|(slot, _)| matches!(slot, Slot::Which | Slot::ForAny));
    let which = which.map(|(_, term)| term);
    own.iter()
        .chain(subjects)
        .chain(which)
        .filter_map(name)
        .collect()
}

/// What a particle has and is.
const OF_PARTICLES: [&str; 12] = [
    MASS,
    POSITION,
    VELOCITY,
    ACCELERATION,
    "momentum",
    "angular momentum",
    "kinetic energy",
    "force",
    "weight",
    "moment",
    "distance",
    "component",
];

/// The noun of a body without extent: "the particle" is one, if no sentence says otherwise.
const PARTICLE: &str = "particle";

fn speaks_of_particle(statement: &Statement) -> bool {
    let mut terms = statement.terms().into_iter();
    terms.any(|term| matches!(term, Term::Name(name) if name == PARTICLE))
}

/// Whether a sentence says that something is a particle, or counts particles.
fn tells_a_particle(statement: &Statement) -> bool {
    let told = matches!(statement, Statement::Is { what, .. } if what.head == PARTICLE);
    let counted = |term: &Term| match term {
        Term::Member { family, .. } => family == PARTICLE,
        Term::Name(name) => name == "particles",
        _ => false,
    };
    told || statement.terms().into_iter().any(counted)
}

/// Whether what a sentence says of a name may be said of a particle: one that turns or has an inertia is none.
fn may_be_of_a_particle(statement: &Statement, of: &str) -> bool {
    let own = |term: &&Term| name(term).is_some_and(|name| name == of);
    if !statement.terms().iter().any(own) {
        return true;
    }
    match statement {
        Statement::Is { what, .. } => OF_PARTICLES.contains(&what.head),
        Statement::Does { verb, .. } => *verb != "turn",
        _ => true,
    }
}

/// The names of what has a mass: a point that has one is a particle.
fn massive_things(declaration: &Declaration) -> Vec<String> {
    match &declaration.statement {
        Statement::Is { what, .. } if what.head == MASS => {
            what.all(Slot::Of).filter_map(name).collect()
        }
        _ => vec![],
    }
}

/// Letters of one sign, and those with a label, as frames and points have them.
fn may_be_introduced(name: &str) -> bool {
    let mut signs = name.chars();
    let capital = signs.next().is_some_and(char::is_uppercase);
    capital && signs.all(|sign| sign.is_ascii_digit() || sign == '\'' || sign == '_')
}

/// What a sentence says to turn, and what it turns against.
fn turning(statement: &Statement) -> Vec<String> {
    let Some((subjects, slots)) = statement.does("turn") else {
        return vec![];
    };
    let against = slots.iter().filter(|(slot, _)| *slot == Slot::RelativeTo);
    let against = against.map(|(_, term)| term);
    subjects.iter().chain(against).filter_map(name).collect()
}

/// "A turns relative to N about the axis through O": O is a point of both.
fn point_of_axis(statement: &Statement) -> Option<(&Term, NounPhrase)> {
    let (subjects, slots) = statement.does("turn")?;
    let Some(Term::Phrase(axis)) = slot(slots, Slot::About) else {
        return None;
    };
    let against = slot(slots, Slot::RelativeTo);
    let both = subjects.iter().chain(against);
    let fixed_in = both.map(|thing| (Slot::FixedIn, thing.clone())).collect();
    let mut point = NounPhrase::new("point", fixed_in);
    if against.is_none() {
        point.adjectives.push("fixed");
    }
    Some((axis.slot(Slot::Through)?, point))
}

/// "O is fixed in N": its name.
fn fixed_thing(declaration: &Declaration) -> Option<String> {
    match &declaration.statement {
        Statement::Is { subjects, what } if what.head == "fixed" && subjects.len() == 1 => {
            name(subjects.first()?)
        }
        _ => None,
    }
}

/// From where a sentence says that something is placed.
fn places_from(statement: &Statement) -> Vec<String> {
    match statement {
        Statement::Is { what, .. } if what.head == POSITION => {
            what.all(Slot::RelativeTo).filter_map(name).collect()
        }
        _ => vec![],
    }
}

/// The points of whose motion a sentence speaks.
fn moving_points(statement: &Statement) -> Vec<String> {
    match statement {
        // "the unit vector from E to G"
        Statement::Is { what, .. } if [UNIT_VECTOR, "vector"].contains(&what.head) => {
            let ends = [Slot::From, Slot::To];
            ends.iter()
                .flat_map(|slot| what.all(*slot))
                .filter_map(name)
                .collect()
        }
        Statement::Is { what, .. } if [POSITION, VELOCITY, ACCELERATION].contains(&what.head) => {
            what.all(Slot::Of).filter_map(name).collect()
        }
        // "G is placed from Q by `$r$`"
        Statement::Does {
            verb: "place",
            slots,
            ..
        } => slot(slots, Slot::From).and_then(name).into_iter().collect(),
        _ => vec![],
    }
}
