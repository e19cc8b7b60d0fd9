//! What a sentence says of several things in turn: "P and Q lie at the distances `$a$` and `$b$` from O".

use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};

/// The word for it.
const RESPECTIVELY: &str = "respectively";

/// "`$p$` and `$q$` are the rates of `$a$` and `$b$`", "the angular momenta of the body about O and about G", "the moments of
/// inertia about the axes through O along `$x$` and `$z$`": what hangs on a noun, or on the axes that it is about, as often
/// as there are subjects is said of each in turn.
pub(crate) fn each_of_its_own(subjects: Vec<Term>, what: NounPhrase) -> Vec<Statement> {
    let letters = subjects.iter().all(|t| matches!(t, Term::Formula(_)));
    let count = subjects.len();
    let what = with_axes_named(what);
    let parted = match letters {
        true => is_parted(&what, count),
        false => hangs_in_turn(&what, Slot::Of, count) || has_sizes_in_turn(&what, count),
    };
    if count < 2 || !parted {
        return vec![Statement::Is { subjects, what }];
    }
    let one = |(number, subject): (usize, Term)| Statement::Is {
        subjects: vec![subject],
        what: single(in_turn(&what, number, count)),
    };
    subjects.into_iter().enumerate().map(one).collect()
}

/// "the mass and the radius of the disc", "the x axis and the z axis of N": what hangs on the last of several nouns hangs on
/// those that have nothing, and on axes that have only their names.
pub(super) fn share_slots(what: &mut NounPhrase, last: &[(Slot, Term)]) {
    let named = |(slot, _): &(Slot, Term)| *slot == Slot::Which;
    if what.slots.is_empty() {
        what.slots = last.to_vec();
    } else if what.head == "axis" && what.slots.iter().all(named) {
        what.slots
            .extend(last.iter().filter(|s| !named(s)).cloned());
    }
}

/// "the axes x and z of N", of which each letter is one: the axis x of N.
fn single(what: NounPhrase) -> NounPhrase {
    match (what.head, what.slot(Slot::Which)) {
        ("axes", Some(_)) => NounPhrase {
            head: "axis",
            ..what
        },
        _ => what,
    }
}

/// "along the x, y, z axes of B": along each of these axes.
fn with_axes_named(what: NounPhrase) -> NounPhrase {
    let Some((at @ (Slot::About | Slot::Along), axes)) = axes_of(&what) else {
        return what;
    };
    let axes = axes.clone();
    if axes.head != "axes" || axes.all(Slot::Which).count() != 1 {
        return what;
    }
    let named = |(slot, term): (Slot, Term)| match term {
        Term::Name(_) | Term::Formula(_) if slot == at => {
            let others = axes.slots.iter().filter(|(s, _)| *s != Slot::Which);
            let own = std::iter::once((Slot::Which, term)).chain(others.cloned());
            let axis = NounPhrase::new("axis", own.collect());
            (slot, Term::Phrase(Box::new(axis)))
        }
        Term::Phrase(last) if *last == axes => {
            let axis = NounPhrase {
                head: "axis",
                ..*last
            };
            (slot, Term::Phrase(Box::new(axis)))
        }
        term => (slot, term),
    };
    NounPhrase {
        slots: what.slots.into_iter().map(named).collect(),
        ..what
    }
}

/// Whether something hangs on a noun, or on its axes, so many times.
fn is_parted(what: &NounPhrase, count: usize) -> bool {
    parted_of(what).any(|slot| hangs_in_turn(what, slot, count))
        || axes_of(what).is_some_and(|(_, axes)| is_parted(axes, count))
}

/// Whether a slot has so many terms, one for each subject.
fn hangs_in_turn(what: &NounPhrase, slot: Slot, count: usize) -> bool {
    let terms: Vec<&Term> = what.all(slot).collect();
    let letters = terms.iter().all(|t| matches!(t, Term::Formula(_)));
    let things = terms.iter().all(|t| !matches!(t, Term::Phrase(_)));
    terms.len() == count && (slot != Slot::Of || letters || things)
}

/// The axes that something is about or along, and how they hang on it.
fn axes_of(what: &NounPhrase) -> Option<(Slot, &NounPhrase)> {
    what.slots.iter().find_map(|(slot, term)| match term {
        Term::Phrase(axes) if matches!(axes.head, "axes" | "axis") => {
            let by_direction = matches!(slot, Slot::About | Slot::Along | Slot::Of);
            by_direction.then_some((*slot, &**axes))
        }
        _ => None,
    })
}

/// What is said of one of the subjects.
fn in_turn(what: &NounPhrase, number: usize, count: usize) -> NounPhrase {
    let parted = parted_of(what).filter(|&s| hangs_in_turn(what, s, count));
    let parted: Vec<Slot> = parted.collect();
    let mut own = NounPhrase {
        slots: own_slots(&what.slots, &parted, number, count),
        ..what.clone()
    };
    if let Some((at, axes)) = axes_of(what).filter(|(_, axes)| is_parted(axes, count)) {
        let axis = NounPhrase {
            head: "axis",
            ..in_turn(axes, number, count)
        };
        let own_axis = own.slots.iter_mut().find(|(slot, _)| *slot == at);
        own_axis
            .into_iter()
            .for_each(|(_, term)| *term = Term::Phrase(Box::new(axis.clone())));
    }
    own
}

/// What may be of each subject in turn.
const PARTED: [Slot; 9] = [
    Slot::Which,
    Slot::Of,
    Slot::About,
    Slot::At,
    Slot::RelativeTo,
    Slot::On,
    Slot::Along,
    Slot::Through,
    Slot::From,
];

/// A vector is fixed in one frame, where a point may be fixed in several; an entry has a row and a column.
fn parted_of(what: &NounPhrase) -> impl Iterator<Item = Slot> {
    let vector = matches!(what.head, "vector" | "unit vector");
    let entry = what.head == "entry" && what.all(Slot::Of).count() > 1;
    let parted = PARTED.into_iter().chain(vector.then_some(Slot::FixedIn));
    parted.filter(move |slot| !(entry && *slot == Slot::Which))
}

/// "of mass `$M$` and `$m$`": as many letters as there are things.
fn has_sizes_in_turn(what: &NounPhrase, count: usize) -> bool {
    what.slots.iter().any(|(_, term)| own_letters(term, count))
}

fn own_letters(term: &Term, count: usize) -> bool {
    match term {
        Term::Phrase(phrase) => {
            let letters: Vec<&Term> = phrase.all(Slot::Which).collect();
            letters.len() == count && letters.iter().all(|l| matches!(l, Term::Formula(_)))
        }
        _ => false,
    }
}

fn keep_one(slots: &mut Vec<(Slot, Term)>, slot: Slot, number: usize) {
    let mut place = 0..;
    slots.retain(|(s, _)| *s != slot || place.next() == Some(number));
}

/// What hangs on one of several: of some slots the term of its own, and in what hangs beside these the letter of its own.
fn own_slots(
    slots: &[(Slot, Term)],
    parted: &[Slot],
    number: usize,
    count: usize,
) -> Vec<(Slot, Term)> {
    let mut own = slots.to_vec();
    for slot in parted {
        keep_one(&mut own, *slot, number);
    }
    if parted.contains(&Slot::Of) {
        keep_own_places(&mut own, slots, number);
    }
    for (_, term) in &mut own {
        if own_letters(term, count)
            && let Term::Phrase(phrase) = term
        {
            keep_one(&mut phrase.slots, Slot::Which, number);
        }
    }
    own
}

/// "the angular momenta of the hub and the wheel about their mass centres": each about its own.
fn keep_own_places(own: &mut [(Slot, Term)], slots: &[(Slot, Term)], number: usize) {
    let owners = |slots: &[(Slot, Term)]| -> Vec<Term> {
        let of = slots.iter().filter(|(slot, _)| *slot == Slot::Of);
        of.map(|(_, term)| term.clone()).collect()
    };
    let all = owners(slots);
    for (_, term) in own {
        if let Term::Phrase(place) = term
            && owners(&place.slots) == all
        {
            keep_one(&mut place.slots, Slot::Of, number);
        }
    }
}

/// What a verb says of each of its subjects, where as many things hang on it: "A and B turn about `$x$` and `$y$`".
pub(crate) fn does_in_turn(
    subjects: &[Term],
    verb: &'static str,
    slots: &[(Slot, Term)],
) -> Vec<Statement> {
    let count = subjects.len();
    let listed = |slot: Slot| slots.iter().filter(|(s, _)| *s == slot).count() == count;
    let shared: Vec<Slot> = SHARED_BY_VERBS.into_iter().filter(|s| listed(*s)).collect();
    let letters = slots.iter().any(|(_, term)| own_letters(term, count));
    if count < 2 || shared.is_empty() && !letters {
        return vec![Statement::Does {
            subjects: subjects.to_vec(),
            verb,
            slots: slots.to_vec(),
        }];
    }
    let one = |(number, subject): (usize, &Term)| Statement::Does {
        subjects: vec![subject.clone()],
        verb,
        slots: own_slots(slots, &shared, number, count),
    };
    subjects.iter().enumerate().map(one).collect()
}

/// What may hang on a verb for each of its subjects.
const SHARED_BY_VERBS: [Slot; 7] = [
    Slot::About,
    Slot::Along,
    Slot::At,
    Slot::By,
    Slot::From,
    Slot::On,
    Slot::RelativeTo,
];

/// What is said of letters by as many nouns, also where the sentence begins with these: "the masses of P and Q are `$m$` and
/// `$M$`".
pub(crate) fn part_letters(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut parted = vec![];
    for declaration in declarations {
        match &declaration.statement {
            Statement::Is { subjects, what }
                if subjects.iter().all(|t| matches!(t, Term::Formula(_))) =>
            {
                let each = each_of_its_own(subjects.clone(), what.clone()).into_iter();
                parted.extend(each.map(|statement| declaration.saying(statement)));
            }
            _ => parted.push(declaration),
        }
    }
    parted
}

/// "O and P are points fixed in N and B, respectively": as the word says, each of its own.
pub(crate) fn part_respectively(declarations: Vec<Declaration>) -> Vec<Declaration> {
    let mut parted = vec![];
    for declaration in declarations {
        match &declaration.statement {
            Statement::Is { subjects, what }
                if declaration.text.contains(RESPECTIVELY)
                    && subjects.len() > 1
                    && hangs_in_turn(what, Slot::FixedIn, subjects.len()) =>
            {
                for (number, subject) in subjects.iter().enumerate() {
                    let mut own = what.clone();
                    keep_one(&mut own.slots, Slot::FixedIn, number);
                    parted.push(declaration.saying(Statement::one_is(subject.clone(), own)));
                }
            }
            _ => parted.push(declaration),
        }
    }
    parted
}
