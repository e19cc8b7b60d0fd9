//! Motion in a vertical plane: what turns about a horizontal axis, told by its angle with the vertical.
//!
//! No sentence names the axes of such a plane. The third axis of the frame that carries the plane points up, and what moves
//! turns about the second one: at the angle zero its own third axis points up as well.

use super::heads::{TOWARDS_GROWING, UNIT_VECTOR, VERTICAL};
use super::hinges::name_joint;
use super::inclinations::{
    Inclination, Motion, inclinations, incline_in_turn, is_level_axis, motions, name_planes,
};
use super::kinds::{is_said_to_be_body, name};
use super::planar_axes::{ACROSS, TOWARDS, UPRIGHT, axis};
use super::planar_lines::{Line, place_along, resolve};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term};
use super::terms::leave_out;
use crate::notation::Macros;

/// How the first two axes of a frame are called by custom.
pub(super) const LEVEL: [&str; 6] = ["x", "y", "X", "Y", "1", "2"];

/// Gives what moves in a vertical plane the turn by its angle.
pub(crate) fn turn_in_planes(declarations: &mut Vec<Declaration>, macros: &Macros) {
    name_planes(declarations);
    incline_in_turn(declarations);
    let motions: Vec<Motion> = motions(declarations).collect();
    let Some(base) = only_base(&motions) else {
        return;
    };
    if names_level_axes(declarations, base.as_ref()) {
        return;
    }
    let (mut told, mut used) = (vec![], vec![]);
    let mut shown = None;
    for inclination in inclinations(declarations, &motions) {
        let Some(line) = resolve(&inclination, declarations) else {
            continue;
        };
        let declaration = declarations[inclination.at].clone();
        let moves = |motion: &Motion| {
            let there = declarations[motion.at].extent == declaration.extent;
            there && concerns(motion, &line, declarations)
        };
        if !motions.iter().any(moves) {
            continue;
        }
        let turn = turn(&line, &inclination, base.as_ref(), macros);
        told.extend(turn.map(|turn| declaration.saying(turn)));
        let besides = line.besides(UPRIGHT).into_iter();
        told.extend(besides.map(|besides| declaration.saying(besides)));
        place_along(&line, UPRIGHT, declarations);
        name_directions(&line, &inclination, declarations);
        shown.get_or_insert(line.turning().clone());
        used.extend([inclination.at].into_iter().chain(inclination.zero));
    }
    let Some(shown) = shown else { return };
    used.extend(motions.iter().map(|motion| motion.at));
    told.extend(
        motions
            .iter()
            .filter_map(|motion| fixed_point(motion, declarations)),
    );
    used.extend(joints_described(declarations));
    name_the_axis(declarations, &motions, &shown);
    if let [
        Motion {
            through: Some(point),
            ..
        },
    ] = motions.as_slice()
    {
        name_joint(declarations, point);
    }
    leave_out(declarations, &used);
    declarations.extend(told);
}

/// Whether what moves in a plane is what turns there, or a whole of which nobody says what kind of body it is.
fn concerns(motion: &Motion, line: &Line, declarations: &[Declaration]) -> bool {
    let Some(mover) = &motion.mover else {
        return true;
    };
    let is_one = |thing: &Term| is_said_to_be_body(thing, declarations);
    // "the rod" may be another name of the pendulum that moves.
    let other_name = line.is_of_body() && !is_one(line.turning());
    !is_one(mover) || line.is_of(mover) || other_name
}

/// "about a horizontal axis through O": O is fixed in what turns, and where the plane is.
fn fixed_point(motion: &Motion, declarations: &[Declaration]) -> Option<Declaration> {
    let point = motion.through.as_ref()?;
    let told = declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } => {
            let fixed = what.is("fixed") || what.slot(Slot::FixedIn).is_some();
            fixed && subjects.contains(point)
        }
        _ => false,
    });
    let mover = (Slot::FixedIn, motion.mover.clone()?);
    let base = motion.base.iter().map(|base| (Slot::FixedIn, base.clone()));
    let slots = std::iter::once(mover).chain(base).collect();
    let mut what = NounPhrase::new("point", slots);
    if motion.base.is_none() {
        what.adjectives.push("fixed");
    }
    let is = Statement::one_is(point.clone(), what);
    (!told).then(|| declarations[motion.at].saying(is))
}

/// The frame in which all planes are fixed, if it is one.
fn only_base(motions: &[Motion]) -> Option<Option<Term>> {
    let (first, rest) = motions.split_first()?;
    let same = rest.iter().all(|motion| motion.base == first.base);
    same.then(|| first.base.clone())
}

/// Whether the frame of the plane has axes with names: in which of their planes it is is not said then.
pub(super) fn names_axes(declarations: &[Declaration], base: Option<&Term>) -> bool {
    names_axes_besides(declarations, base, |_| false)
}

/// The same, where the name of the upward vertical counts for none: it says nothing of the plane, where it is not that of
/// another axis than the third by custom.
fn names_level_axes(declarations: &[Declaration], base: Option<&Term>) -> bool {
    names_axes_besides(declarations, base, |subject| {
        let named = name(subject).is_some_and(|name| !LEVEL.contains(&name.as_str()));
        let upright = |d: &Declaration| match &d.statement {
            Statement::Is { subjects, what } => {
                let plain = what.head == VERTICAL && what.is("upward") && what.slots.is_empty();
                plain && subjects.contains(subject)
            }
            _ => false,
        };
        named && declarations.iter().any(upright)
    })
}

fn names_axes_besides(
    declarations: &[Declaration],
    base: Option<&Term>,
    besides: impl Fn(&Term) -> bool,
) -> bool {
    declarations.iter().any(|d| match &d.statement {
        Statement::Is { subjects, what } if matches!(what.head, "axes" | "axis") => {
            let of_base = |of: &Term| base.is_none_or(|base| base == of);
            what.all(Slot::Of).any(of_base) && !subjects.iter().all(&besides)
        }
        Statement::Is { subjects, what } if what.head == VERTICAL => {
            let named = |subject: &Term| name(subject).is_some() && !besides(subject);
            subjects.iter().any(named)
        }
        _ => false,
    })
}

/// "It turns about the second axis by the angle": from the downward vertical half a turn more.
fn turn(
    line: &Line,
    inclination: &Inclination,
    base: Option<&Term>,
    macros: &Macros,
) -> Option<Statement> {
    let own = &inclination.letter;
    let angle = match inclination.downward {
        true => formula(&format!("{}+\\pi", own.source), false, macros)?,
        false => own.clone(),
    };
    let by = NounPhrase::new("angle", vec![(Slot::Which, Term::Formula(angle))]);
    let about = axis(ACROSS, base);
    let relative = base.map(|base| (Slot::RelativeTo, base.clone()));
    let slots = [(Slot::About, about), (Slot::By, Term::Phrase(Box::new(by)))];
    Some(Statement::Does {
        subjects: vec![line.turning().clone()],
        verb: "turn",
        slots: relative.into_iter().chain(slots).collect(),
    })
}

/// Unit vectors along the line, and across it towards growing angles, are axes of what turns.
fn name_directions(line: &Line, inclination: &Inclination, declarations: &mut [Declaration]) {
    let mut along: Vec<Term> = vec![inclination.line.clone()];
    for declaration in declarations.iter_mut() {
        if let Statement::Is { subjects, what } = &mut declaration.statement
            && what.head == UNIT_VECTOR
            && line.is_along(what)
        {
            along.extend(subjects.iter().cloned());
            *what = own_axis(UPRIGHT, line);
        }
    }
    for term in declarations
        .iter_mut()
        .flat_map(|d| d.statement.terms_mut())
    {
        if let Term::Phrase(what) = term
            && what.head == UNIT_VECTOR
            && line.is_along(what)
        {
            **what = own_axis(UPRIGHT, line);
        }
    }
    for declaration in declarations.iter_mut() {
        if let Statement::Is { what, .. } = &mut declaration.statement
            && what.head == UNIT_VECTOR
            && grows_with(what, &inclination.letter)
            && what.all(Slot::With).any(|of| along.contains(of))
        {
            *what = own_axis(TOWARDS, line);
        }
    }
}

fn own_axis(number: usize, line: &Line) -> NounPhrase {
    let slots = vec![
        (Slot::Which, Term::Numbers(vec![number])),
        (Slot::Of, line.turning().clone()),
    ];
    NounPhrase::new("axis", slots)
}

/// "perpendicular to n, towards growing `$\theta$`"
fn grows_with(what: &NounPhrase, letter: &Formula) -> bool {
    what.all(Slot::With).any(|with| match with {
        Term::Phrase(towards) if towards.head == TOWARDS_GROWING => {
            let mut of = towards.all(Slot::Of);
            of.any(|of| matches!(of, Term::Formula(f) if f.source == letter.source))
        }
        _ => false,
    })
}

/// "the horizontal axis through O", "the axis of the hinge": the axis of the turn.
fn name_the_axis(declarations: &mut [Declaration], motions: &[Motion], turning: &Term) {
    let point = motions.iter().find_map(|motion| motion.through.clone());
    for declaration in declarations.iter_mut() {
        for term in declaration.statement.terms_mut() {
            name_axis(term, point.as_ref(), turning);
        }
    }
}

fn name_axis(term: &mut Term, point: Option<&Term>, turning: &Term) {
    let Term::Phrase(phrase) = term else { return };
    let of_joint = |of: &Term| {
        matches!(of, Term::Phrase(p) if p.head == "joint") || name(of).is_some_and(|n| n == "joint")
    };
    let across_plane = |with: &Term| matches!(with, Term::Phrase(p) if p.head == "plane" && p.all(Slot::Of).any(is_motion));
    match phrase.head {
        "axis" if is_level_axis(phrase) || phrase.all(Slot::With).any(across_plane) => {
            let through = phrase.slot(Slot::Through).or(point).cloned();
            let along = (Slot::Along, axis(ACROSS, Some(turning)));
            let through = through.map(|through| (Slot::Through, through));
            let slots = through.into_iter().chain([along]).collect();
            **phrase = NounPhrase::new("axis", slots);
        }
        "axis" if phrase.all(Slot::Of).any(of_joint) => *term = axis(ACROSS, Some(turning)),
        _ => {
            for (_, inner) in &mut phrase.slots {
                name_axis(inner, point, turning);
            }
        }
    }
}

/// "The hinge is fixed in A and perpendicular to the rod": as that of a turn in a plane is.
fn joints_described(declarations: &[Declaration]) -> Vec<usize> {
    let said = declarations.iter().enumerate();
    let joints = said.filter(|(_, d)| match &d.statement {
        Statement::Is { subjects, what } => {
            let joint = |subject: &Term| name(subject).is_some_and(|n| n == "joint");
            let usual = ["orthogonal", "horizontal", "fixed"].contains(&what.head);
            usual && subjects.iter().all(joint)
        }
        _ => false,
    });
    joints.map(|(at, _)| at).collect()
}

fn is_motion(term: &Term) -> bool {
    matches!(term, Term::Phrase(motion) if motion.head == "motion")
}
