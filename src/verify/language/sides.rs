//! Sides of boxes and plates, and semi-axes of ellipsoids: along which axes each of them lies.

use super::counted::axes_listed;
use super::heads::SEMI_AXIS;
use super::statement::{Declaration, NounPhrase, Slot, Statement, Term, slot};
use super::terms::say_besides;

/// What has a length along an axis.
const SIDES: [&str; 2] = ["side", SEMI_AXIS];

/// "The block is a uniform box with the edges `$a$`, `$b$`, `$c$` along x, y, z": each is a side along its axis.
pub(crate) fn tell_sides(declarations: &mut Vec<Declaration>) {
    join_sides(declarations);
    let laid = |d: &Declaration| laid_by_letters(&d.statement, declarations);
    let laid: Vec<Option<Laid>> = declarations.iter().map(laid).collect();
    let all: Vec<Laid> = laid.iter().flatten().cloned().collect();
    let mut own = laid.into_iter();
    say_besides(declarations, |statement| {
        lay_sides(statement, own.next().flatten(), &all)
    });
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

/// "The side `$a$` lies along x from O; the side `$b$` lies along y from O": both lie so from there, as one sentence says it.
fn join_sides(declarations: &mut Vec<Declaration>) {
    let mut at = 0;
    while at < declarations.len() {
        let Some((corner, ..)) = side_from_corner(&declarations[at].statement) else {
            at += 1;
            continue;
        };
        let (mut letters, mut axes) = (vec![], vec![]);
        let mut place = 0;
        declarations.retain(|d| {
            place += 1;
            match side_from_corner(&d.statement) {
                Some((own, letter, axis)) if own == corner => {
                    letters.push((Slot::Which, letter));
                    axes.push((Slot::Along, axis));
                    place == at + 1
                }
                _ => true,
            }
        });
        if let Statement::Does {
            subjects, slots, ..
        } = &mut declarations[at].statement
            && let [Term::Phrase(sides)] = subjects.as_mut_slice()
        {
            sides.slots.retain(|(slot, _)| *slot != Slot::Which);
            sides.slots.extend(letters);
            slots.retain(|(slot, _)| *slot != Slot::Along);
            slots.extend(axes);
        }
        at += 1;
    }
}

/// "The side `$a$` of the plate lies along x from O": whose corner that is and which, the letter, and the axis.
fn side_from_corner(statement: &Statement) -> Option<((Option<Term>, Term), Term, Term)> {
    let (subjects, slots) = statement.does("lie")?;
    let [Term::Phrase(side)] = subjects else {
        return None;
    };
    let letters: Vec<&Term> = side.all(Slot::Which).collect();
    let ([letter], [_, _]) = (letters.as_slice(), slots) else {
        return None;
    };
    let (from, along) = (slot(slots, Slot::From)?, slot(slots, Slot::Along)?);
    let whose = (side.slot(Slot::Of).cloned(), from.clone());
    (side.head == SIDES[0]).then(|| (whose, (*letter).clone(), along.clone()))
}

/// Sides by their letters, and along which axes they lie.
#[derive(Clone, PartialEq)]
struct Laid {
    noun: &'static str,
    of: Term,
    letters: Vec<Term>,
    along: Vec<Term>,
    /// The corner at which they meet.
    from: Option<Term>,
}

/// "The sides `$a$` and `$b$` of the plate lie along x and y from O."
fn laid_by_letters(statement: &Statement, all: &[Declaration]) -> Option<Laid> {
    let (subjects, slots) = statement.does("lie")?;
    let [Term::Phrase(sides)] = subjects else {
        return None;
    };
    let letters: Vec<Term> = sides.all(Slot::Which).cloned().collect();
    let along = match axes_listed(slots) {
        Some(axes) if !axes.is_empty() => axes,
        _ => all_of(slots, Slot::Along),
    };
    let from = all_of(slots, Slot::From);
    let known = |slot: &Slot| matches!(slot, Slot::Along | Slot::From);
    let whole = slots.iter().all(|(slot, _)| known(slot)) && from.len() < 2;
    let laid = SIDES.contains(&sides.head) && letters.len() == along.len() && !letters.is_empty();
    let of = sides.slot(Slot::Of).cloned();
    let of = of.or_else(|| owner_of_sides(&letters, all));
    let of = of.filter(|_| whole && laid)?;
    Some(Laid {
        noun: sides.head,
        of,
        letters,
        along,
        from: from.into_iter().next(),
    })
}

/// The only thing of which a sentence says that it has these sides.
fn owner_of_sides(letters: &[Term], all: &[Declaration]) -> Option<Term> {
    let has = |declaration: &&Declaration| match &declaration.statement {
        Statement::Is { what, .. } => {
            let own = what.slots.iter().filter_map(|(_, term)| match term {
                Term::Phrase(sides) if SIDES.contains(&sides.head) => Some(sides),
                _ => None,
            });
            let own: Vec<&Term> = own.flat_map(|sides| sides.all(Slot::Which)).collect();
            letters.iter().all(|letter| own.contains(&letter))
        }
        _ => false,
    };
    let mut owners = all.iter().filter(has);
    match (owners.next().map(|d| d.statement.subjects()), owners.next()) {
        (Some([owner]), None) => Some(owner.clone()),
        _ => None,
    }
}

fn all_of(slots: &[(Slot, Term)], wanted: Slot) -> Vec<Term> {
    let own = slots.iter().filter(|(slot, _)| *slot == wanted);
    own.map(|(_, term)| term.clone()).collect()
}

/// Says of each letter along what it lies, where a sentence does so for all, and leaves the letters out where the shape is
/// told.
fn lay_sides(statement: &mut Statement, own: Option<Laid>, laid: &[Laid]) -> Vec<Statement> {
    if let Statement::Is { subjects, what } = statement {
        let [thing] = subjects.as_slice() else {
            return vec![];
        };
        let own: Vec<&Laid> = laid.iter().filter(|laid| laid.of == *thing).collect();
        what.slots.retain(|(slot, term)| match term {
            Term::Phrase(sides) if matches!(slot, Slot::Of | Slot::With) => {
                let letters: Vec<Term> = sides.all(Slot::Which).cloned().collect();
                let bare = sides.slots.len() == letters.len();
                let same = |l: &&Laid| l.noun == sides.head && l.letters == letters;
                !(bare && own.iter().any(same))
            }
            _ => true,
        });
        return vec![];
    }
    let Some(laid) = own else {
        return vec![];
    };
    let each = laid.letters.iter().zip(&laid.along);
    let mut told: Vec<Statement> = each
        .map(|(letter, along)| size_along(laid.noun, letter, &laid.of, along))
        .collect();
    // The sides meet at a corner.
    told.extend(laid.from.clone().map(|corner| {
        let of = std::iter::once((Slot::Of, laid.of.clone()));
        let along = laid.along.iter().map(|axis| (Slot::Along, axis.clone()));
        Statement::one_is(corner, NounPhrase::new("corner", of.chain(along).collect()))
    }));
    *statement = told.remove(0);
    told
}

/// "`$a$` is the side of the block along x."
fn side(letter: &Term, of: &Term, along: &Term) -> Statement {
    size_along(SIDES[0], letter, of, along)
}

fn size_along(noun: &'static str, letter: &Term, of: &Term, along: &Term) -> Statement {
    let slots = vec![(Slot::Of, of.clone()), (Slot::Along, along.clone())];
    Statement::one_is(letter.clone(), NounPhrase::new(noun, slots))
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
    if let Some((noun, pairs)) = sides_in_turn(what) {
        what.slots
            .retain(|(slot, term)| *slot != Slot::Along && !is_side(term));
        let each = pairs.iter();
        return each
            .map(|(letter, along)| size_along(noun, letter, thing, along))
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
fn sides_in_turn(what: &NounPhrase) -> Option<(&'static str, Vec<(Term, Term)>)> {
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
    let noun = match sides.head {
        SEMI_AXIS => SEMI_AXIS,
        _ => SIDES[0],
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
            whole.then(|| (noun, pairs.collect()))
        }
        [_, _, ..] if letters.len() == along.len() => {
            Some((noun, letters.into_iter().zip(along).collect()))
        }
        _ => None,
    }
}

fn is_side(term: &Term) -> bool {
    matches!(term, Term::Phrase(side) if matches!(side.head, "side" | "length" | SEMI_AXIS))
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
