//! Sentences about motion in a vertical plane, and the angles with the vertical that they tell.

use super::heads::{VERTICAL, WITHOUT_FRICTION};
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};

/// Verbs of what moves in a plane.
const MOVES: [&str; 4] = ["turn", "swing", "move", "fall"];

/// What only says how something moves, and not in which plane.
const MANNERS: [&str; 2] = [WITHOUT_FRICTION, "freely"];

/// An angle with the vertical.
pub(super) struct Inclination {
    /// Where the sentence stands.
    pub(super) at: usize,
    pub(super) letter: Formula,
    pub(super) line: Term,
    pub(super) downward: bool,
    /// The sentence that tells how something hangs where the angle is zero.
    pub(super) zero: Option<usize>,
}

/// A sentence about motion in a vertical plane.
pub(super) struct Motion {
    pub(super) at: usize,
    /// What moves, if the sentence names it.
    pub(super) mover: Option<Term>,
    /// The frame in which the plane is fixed; else it is fixed in space.
    pub(super) base: Option<Term>,
    /// The point through which the axis goes, if one is named.
    pub(super) through: Option<Term>,
    angle: Option<Term>,
}

/// "The vertical plane through the rod turns about the vertical by the angle `$\phi$`": the plane is a frame.
pub(super) fn name_planes(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    for declaration in declarations.iter_mut() {
        let Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } = &mut declaration.statement
        else {
            continue;
        };
        let mut about = slots.iter().filter(|(slot, _)| *slot == Slot::About);
        let upright = about.any(|(_, about)| is_upright_axis(about));
        let plane = matches!(subjects.as_slice(), [Term::Phrase(plane)] if is_upright_plane(plane));
        if plane && upright {
            let frame = Term::Name("vertical plane".to_owned());
            *subjects = vec![frame.clone()];
            let is = Statement::one_is(frame.clone(), NounPhrase::new("frame", vec![]));
            let mut moves = NounPhrase::new("plane", vec![(Slot::FixedIn, frame)]);
            moves.adjectives.push("vertical");
            let moves = Statement::Does {
                subjects: vec![],
                verb: "move",
                slots: vec![(Slot::In, Term::Phrase(Box::new(moves)))],
            };
            told.extend([is, moves].map(|said| declaration.saying(said)));
        }
    }
    declarations.extend(told);
}

/// "`$\theta$` and `$\phi$` are the angles from the downward vertical to the links 1 and 2": each has its own.
pub(super) fn incline_in_turn(declarations: &mut Vec<Declaration>) {
    let mut told = vec![];
    declarations.retain(|declaration| {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return true;
        };
        let ends = what.slots.iter();
        let (vertical, lines): (Vec<_>, Vec<_>) =
            ends.partition(|(_, term)| term.is_noun(VERTICAL));
        let ([vertical], "angle") = (vertical.as_slice(), what.head) else {
            return true;
        };
        if subjects.len() < 2 || subjects.len() != lines.len() {
            return true;
        }
        for (subject, line) in subjects.iter().zip(lines) {
            let slots = vec![(*vertical).clone(), line.clone()];
            let angle = NounPhrase::new("angle", slots);
            told.push(declaration.saying(Statement::one_is(subject.clone(), angle)));
        }
        false
    });
    declarations.extend(told);
}

/// The sentences that say that something moves in a vertical plane.
pub(super) fn motions(declarations: &[Declaration]) -> impl Iterator<Item = Motion> {
    let said = declarations.iter().enumerate();
    said.filter_map(|(at, declaration)| {
        let Statement::Does {
            subjects,
            verb,
            slots,
        } = &declaration.statement
        else {
            return None;
        };
        if subjects.len() > 1 || !MOVES.contains(verb) {
            return None;
        }
        let (mut plane, mut base, mut through, mut angle) = (false, None, None, None);
        for (slot, term) in slots {
            match (slot, term) {
                (_, Term::Phrase(place)) if is_upright_plane(place) || is_level_axis(place) => {
                    plane = true;
                    through = through.or_else(|| place.slot(Slot::Through).cloned());
                    base = base.or_else(|| place.slot(Slot::FixedIn).cloned());
                }
                (Slot::About, Term::Name(_)) => through = Some(term.clone()),
                (Slot::RelativeTo, Term::Name(_)) => base = Some(term.clone()),
                (Slot::By, Term::Phrase(by)) if by.head == "angle" => angle = Some(term.clone()),
                (Slot::With, Term::Phrase(how)) if MANNERS.contains(&how.head) => {}
                _ => return None,
            }
        }
        plane.then(|| Motion {
            at,
            mover: subjects.first().cloned(),
            base,
            through,
            angle,
        })
    })
}

/// "the vertical", "the axis through O along the vertical", "the vertical axis through O"
fn is_upright_axis(about: &Term) -> bool {
    about.is_noun(VERTICAL)
        || matches!(about, Term::Phrase(axis) if axis.head == "axis"
            && (axis.is("vertical") || axis.slot(Slot::Along).is_some_and(|a| a.is_noun(VERTICAL))))
}

/// "a vertical plane", maybe fixed in space.
fn is_upright_plane(place: &NounPhrase) -> bool {
    place.head == "plane" && place.is("vertical") && only_through(place)
}

/// "a horizontal axis through O"
pub(super) fn is_level_axis(place: &NounPhrase) -> bool {
    matches!(place.head, "axis" | "joint") && place.is("horizontal") && only_through(place)
}

fn only_through(place: &NounPhrase) -> bool {
    let mut slots = place.slots.iter();
    slots.all(|(slot, _)| matches!(slot, Slot::Through | Slot::FixedIn))
}

/// The angles that sentences tell of lines with the vertical.
pub(super) fn inclinations(declarations: &[Declaration], motions: &[Motion]) -> Vec<Inclination> {
    let told = declarations.iter().enumerate();
    let told = told.filter_map(|(at, d)| match &d.statement {
        Statement::Is { subjects, what } => match subjects.as_slice() {
            [Term::Formula(letter)] if what.head == "angle" => {
                let (line, downward) = line_and_vertical(what)?;
                Some(Inclination {
                    at,
                    letter: letter.clone(),
                    line: line.clone(),
                    downward,
                    zero: None,
                })
            }
            _ => None,
        },
        _ => None,
    });
    let turned = motions.iter().filter_map(|motion| {
        let Term::Phrase(angle) = motion.angle.as_ref()? else {
            return None;
        };
        let Term::Formula(letter) = angle.slot(Slot::Which)? else {
            return None;
        };
        let upright = angle.slot(Slot::RelativeTo).and_then(points_down);
        let upright = upright.map(|downward| (downward, None));
        let mover = motion.mover.as_ref()?;
        let zero = || hangs_at_zero(mover, letter, declarations);
        let (downward, zero) = upright.or_else(zero)?;
        Some(Inclination {
            at: motion.at,
            letter: letter.clone(),
            line: mover.clone(),
            downward,
            zero,
        })
    });
    told.chain(turned).collect()
}

/// The line of "the angle from the downward vertical to the rod", and whether that vertical points down.
fn line_and_vertical(angle: &NounPhrase) -> Option<(&Term, bool)> {
    let slots = [Slot::Between, Slot::RelativeTo, Slot::To, Slot::Of];
    let ends: Vec<&Term> = slots.iter().flat_map(|slot| angle.all(*slot)).collect();
    match ends.as_slice() {
        [one, other] if angle.slots.len() == 2 => {
            let downward = points_down(one).or_else(|| points_down(other))?;
            let line = if points_down(one).is_some() {
                other
            } else {
                one
            };
            Some((line, downward))
        }
        _ => None,
    }
}

/// Whether a vertical points down; of one that is only called so nobody says it.
fn points_down(term: &Term) -> Option<bool> {
    match term {
        Term::Phrase(vertical) if vertical.head == VERTICAL && vertical.slots.is_empty() => {
            let downward = vertical.is("downward");
            (downward || vertical.is("upward")).then_some(downward)
        }
        _ => None,
    }
}

/// "The rod hangs from O at `$\theta=0$`"
fn hangs_at_zero(
    mover: &Term,
    letter: &Formula,
    declarations: &[Declaration],
) -> Option<(bool, Option<usize>)> {
    let mut told = declarations.iter().enumerate();
    told.find_map(|(number, d)| match &d.statement {
        Statement::Does {
            subjects,
            verb: "hang" | "point",
            slots,
        } if subjects.contains(mover) => {
            let at = |(slot, term): &(Slot, Term)| {
                *slot == Slot::At
                    && matches!(term, Term::Formula(zero) if is_zero_of(zero, &letter.source))
            };
            let along = slots.iter().find(|(slot, _)| *slot == Slot::Along);
            let downward = along.map_or(Some(true), |(_, along)| points_down(along));
            let downward = slots.iter().any(at).then_some(downward).flatten()?;
            Some((downward, Some(number)))
        }
        _ => None,
    })
}

/// Whether a condition says that a letter is zero.
pub(super) fn is_zero_of(condition: &Formula, letter: &str) -> bool {
    let written = condition.source.replace(' ', "");
    written.strip_suffix("=0") == Some(letter)
}
