//! Places and sides of a body that the sentence about its shape tells: its middle, its ends, what its sides are along.

use super::kinds::name;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use super::terms::say_besides;

/// Places that a thing has.
const PLACES: [&str; 5] = ["middle", "centre", "mass centre", "end", "origin"];

/// "The rod is a uniform rod with its middle at G and the ends A and B": what G, A and B are.
pub(crate) fn tell_places(declarations: &mut Vec<Declaration>) {
    say_besides(declarations, |statement| match statement {
        Statement::Is { subjects, what } => {
            let [thing] = subjects.as_slice() else {
                return vec![];
            };
            let mut told: Vec<Statement> = take_origin(what, thing).into_iter().collect();
            told.extend(take_places(&mut what.slots, thing));
            told
        }
        // "The rod lies along x with its middle at G."
        Statement::Does {
            subjects,
            verb: "lie",
            slots,
        } => match subjects.as_slice() {
            [thing] => take_places(slots, thing),
            _ => vec![],
        },
        _ => vec![],
    });
}

fn take_places(slots: &mut Vec<(Slot, Term)>, thing: &Term) -> Vec<Statement> {
    let mut told = vec![];
    slots.retain(|(slot, term)| match place_of(*slot, term, thing) {
        Some(places) => {
            told.extend(places);
            false
        }
        None => true,
    });
    told
}

/// "B is a frame fixed in the body with the origin at O": what O is.
fn take_origin(what: &mut NounPhrase, frame: &Term) -> Option<Statement> {
    let origin = |term: &Term| match term {
        Term::Phrase(p) => p.head == "origin" && p.slots.iter().all(|(_, of)| of == frame),
        _ => false,
    };
    let at = what.slot(Slot::At).cloned();
    let with = what.all(Slot::With).any(origin);
    let (Some(at), true, "frame") = (at, with, what.head) else {
        return None;
    };
    what.slots
        .retain(|(slot, term)| !(*slot == Slot::At || *slot == Slot::With && origin(term)));
    let of = vec![(Slot::Of, frame.clone())];
    name(&at)?;
    Some(Statement::one_is(at, NounPhrase::new("origin", of)))
}

/// "with its middle at G", "with the ends A and B"
fn place_of(slot: Slot, term: &Term, thing: &Term) -> Option<Vec<Statement>> {
    let Term::Phrase(place) = term else {
        return None;
    };
    let others = place.slots.iter().all(|(slot, own)| match slot {
        Slot::At | Slot::Which => name(own).is_some(),
        Slot::Of => own == thing,
        _ => false,
    });
    if slot != Slot::With || !PLACES.contains(&place.head) || !others {
        return None;
    }
    let points = place.all(Slot::At).chain(place.all(Slot::Which));
    let points: Vec<Statement> = points
        .map(|point| {
            let of = vec![(Slot::Of, thing.clone())];
            Statement::one_is(point.clone(), NounPhrase::new(place.head, of))
        })
        .collect();
    (!points.is_empty()).then_some(points)
}

/// "The rod goes from O to P": these are its ends.
pub(crate) fn tell_reach(declarations: &mut [Declaration]) {
    for declaration in declarations {
        if let Some(([body], [(Slot::From, from), (Slot::To, to)])) =
            declaration.statement.does("extend")
        {
            declaration.statement = Statement::Is {
                subjects: vec![from.clone(), to.clone()],
                what: NounPhrase::new("end", vec![(Slot::Of, body.clone())]),
            };
        }
    }
}

/// "The block is a uniform box with the edges `$a$`, `$b$`, `$c$` along x, y, z": each is a side along its axis.
pub(crate) fn tell_sides(declarations: &mut Vec<Declaration>) {
    let lying = sides_that_lie(declarations);
    let before = declarations.len();
    say_besides(declarations, |statement| {
        let Statement::Is { subjects, what } = statement else {
            return vec![];
        };
        match subjects.as_slice() {
            [thing] => sides_of_shape(what, thing),
            letters => lengths_of_sides(letters, what, &lying),
        }
    });
    // Along what sides lie is said with their lengths.
    if declarations.len() > before {
        declarations.retain(|d| side_that_lies(d).is_none());
    }
}

/// "`$a$` is the side of the block along x."
fn side(letter: &Term, of: &Term, along: &Term) -> Statement {
    let slots = vec![(Slot::Of, of.clone()), (Slot::Along, along.clone())];
    Statement::one_is(letter.clone(), NounPhrase::new("side", slots))
}

/// Takes the sides out of what is said of a shape.
fn sides_of_shape(what: &mut NounPhrase, thing: &Term) -> Vec<Statement> {
    let letter = |term: &Term| matches!(term, Term::Formula(_));
    let (letters, along): (Vec<Term>, Vec<Term>) = (
        what.all(Slot::With)
            .filter(|t| letter(t))
            .cloned()
            .collect(),
        what.all(Slot::Along).cloned().collect(),
    );
    if let (3, Some(frame)) = (letters.len(), what.slot(Slot::On).cloned()) {
        what.slots
            .retain(|(slot, term)| !(*slot == Slot::On || *slot == Slot::With && letter(term)));
        let slots = vec![(Slot::Of, thing.clone()), (Slot::Along, axes_of(&frame))];
        return vec![Statement::Is {
            subjects: letters,
            what: NounPhrase::new("side", slots),
        }];
    }
    if !letters.is_empty() && letters.len() == along.len() {
        what.slots
            .retain(|(slot, term)| !(*slot == Slot::Along || *slot == Slot::With && letter(term)));
        let each = letters.iter().zip(&along);
        return each
            .map(|(letter, along)| side(letter, thing, along))
            .collect();
    }
    if let Some(pairs) = sides_in_turn(what) {
        what.slots
            .retain(|(slot, term)| *slot != Slot::Along && !is_side(term));
        let each = pairs.iter();
        return each
            .map(|(letter, along)| side(letter, thing, along))
            .collect();
    }
    let mut told = vec![];
    what.slots.retain(|(_, term)| match side_along(term) {
        Some((letter, along)) => {
            told.push(side(letter, thing, along));
            false
        }
        None => true,
    });
    told
}

/// "the sides `$a$` and `$b$` along x and y", "the sides `$a$` along x and `$b$` along y": each with its axis.
fn sides_in_turn(what: &NounPhrase) -> Option<Vec<(Term, Term)>> {
    let sides: Vec<&NounPhrase> = what
        .slots
        .iter()
        .filter_map(|(_, term)| match term {
            Term::Phrase(side) if is_side(term) => Some(&**side),
            _ => None,
        })
        .collect();
    let [sides] = sides.as_slice() else {
        return None;
    };
    let letters: Vec<Term> = sides.all(Slot::Which).cloned().collect();
    // What is along the last axis hangs on the shape.
    let along = sides.all(Slot::Along).chain(what.all(Slot::Along));
    let along: Vec<Term> = along.cloned().collect();
    match letters.as_slice() {
        [_] if along.len() > 1 => {
            let in_turn = [letters, along].concat();
            let pairs = in_turn.chunks_exact(2);
            let whole = pairs.remainder().is_empty();
            let pairs = pairs.map(|pair| (pair[0].clone(), pair[1].clone()));
            whole.then(|| pairs.collect())
        }
        [_, _, ..] if letters.len() == along.len() => {
            Some(letters.into_iter().zip(along).collect())
        }
        _ => None,
    }
}

fn is_side(term: &Term) -> bool {
    matches!(term, Term::Phrase(side) if matches!(side.head, "side" | "length"))
}

/// "the side `$a$` along x"
fn side_along(term: &Term) -> Option<(&Term, &Term)> {
    match term {
        Term::Phrase(side) if side.head == "side" || side.head == "length" => {
            Some((side.slot(Slot::Which)?, side.slot(Slot::Along)?))
        }
        _ => None,
    }
}

/// The things whose sides are said to lie along axes.
fn sides_that_lie(declarations: &[Declaration]) -> Vec<(Term, Vec<Term>)> {
    declarations.iter().filter_map(side_that_lies).collect()
}

fn side_that_lies(declaration: &Declaration) -> Option<(Term, Vec<Term>)> {
    let (subjects, slots) = declaration.statement.does("lie")?;
    let of = match subjects {
        [Term::Phrase(side)] if side.head == "side" => side.slot(Slot::Of)?.clone(),
        _ => return None,
    };
    let along = slots.iter().map(|(slot, term)| match slot {
        Slot::Along => Some(term.clone()),
        Slot::On => Some(axes_of(term)),
        _ => None,
    });
    Some((of, along.collect::<Option<_>>()?))
}

/// "the axes of B"
fn axes_of(frame: &Term) -> Term {
    let of = vec![(Slot::Of, frame.clone())];
    Term::Phrase(Box::new(NounPhrase::new("axes", of)))
}

/// "`$a$`, `$b$`, `$c$` are the lengths of the edges of the block along x, y, z"; along what they lie may be told elsewhere.
fn lengths_of_sides(
    letters: &[Term],
    what: &NounPhrase,
    lying: &[(Term, Vec<Term>)],
) -> Vec<Statement> {
    let Some(Term::Phrase(sides)) = what.slot(Slot::Of).filter(|_| what.head == "length") else {
        return vec![];
    };
    let Some(of) = sides.slot(Slot::Of).filter(|_| sides.head == "side") else {
        return vec![];
    };
    let own: Vec<&Term> = sides.all(Slot::Along).collect();
    let along: Vec<&Term> = match own.is_empty() {
        true => lying
            .iter()
            .filter(|(thing, _)| thing == of)
            .flat_map(|(_, along)| along)
            .collect(),
        false => own,
    };
    if let [axes @ Term::Phrase(_)] = along.as_slice() {
        return vec![Statement::Is {
            subjects: letters.to_vec(),
            what: NounPhrase::new(
                "side",
                vec![(Slot::Of, of.clone()), (Slot::Along, (*axes).clone())],
            ),
        }];
    }
    match along.len() == letters.len() {
        true => letters
            .iter()
            .zip(along)
            .map(|(l, a)| side(l, of, a))
            .collect(),
        false => vec![],
    }
}
