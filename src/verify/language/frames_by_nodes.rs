//! Frames that are told by the angle of one axis with that of another frame, by the azimuth of it, and by the line of nodes.

use super::flat_bodies::is_inertial;
use super::heads::UNIT_VECTOR;
use super::kinds::name;
use super::planar_axes::{axis, turns_by};
use super::reader::formula;
use super::statement::{Declaration, Formula, NounPhrase, Slot, Statement, Term, slot};
use super::terms::leave_out;
use super::turned_lines::{Direction, direction};
use crate::notation::Macros;

/// An axis of one frame that leans from that of another one with the same number.
struct Leaning {
    upright: Direction,
    tilted: Direction,
    /// Both as they are written.
    written: [String; 2],
    by: Formula,
    said: usize,
}

/// By which angle about the upright axis a plane stands, from an axis of the other frame.
struct Azimuth {
    from: Direction,
    by: Formula,
    said: usize,
}

/// The axis of the tilted frame along the line of nodes, and whether it points along upright × tilted.
struct Node {
    axis: Direction,
    forwards: bool,
    said: usize,
}

/// "The angle between k and w is `$\theta$`. The plane of k and w turns about k by the angle `$\phi$` from the plane of k and
/// i. u points along `$k\times w$`", where i, j, k are the axes of N, and u, v, w those of A: a level frame turns about k, so
/// that u lies a right angle before the plane, and A is turned against it about u by θ.
pub(super) fn turn_by_nodes(declarations: &mut Vec<Declaration>, macros: &Macros) {
    let all = (0..declarations.len()).find_map(|at| leaning(at, declarations));
    let Some(leaning) = all else { return };
    let mut said = declarations.iter().enumerate();
    let told = said.find_map(|(at, d)| azimuth(at, &d.statement, &leaning, declarations));
    let Some(azimuth) = told else { return };
    let Some(node) = node(&leaning, declarations) else {
        return;
    };
    let Some(told) = statements(&leaning, &azimuth, &node, macros) else {
        return;
    };
    let own = declarations[azimuth.said].clone();
    declarations
        .iter_mut()
        .for_each(|d| leave_free_turn(&mut d.statement, &leaning.tilted.frame));
    let used = [leaning.said, azimuth.said, node.said];
    leave_out(declarations, &used);
    declarations.extend(told.into_iter().map(|said| own.saying(said)));
}

/// The angle between an axis of one frame and the axis with the same number of another one, which no sentence turns by an
/// angle.
fn leaning(said: usize, declarations: &[Declaration]) -> Option<Leaning> {
    let Statement::Is { subjects, what } = &declarations[said].statement else {
        return None;
    };
    let ([Term::Formula(by)], "angle", 2) = (subjects.as_slice(), what.head, what.slots.len())
    else {
        return None;
    };
    let ends: Vec<&Term> = what.all(Slot::Between).collect();
    let &[one, other] = ends.as_slice() else {
        return None;
    };
    let turned = |frame: &Term| {
        declarations.iter().any(|d| {
            let said = d.statement.does("turn");
            said.is_some_and(|(subjects, slots)| {
                subjects.contains(frame) && slot(slots, Slot::About).is_some()
            })
        })
    };
    [(one, other), (other, one)]
        .into_iter()
        .find_map(|(one, other)| {
            let (upright, tilted) = (
                direction(one, declarations)?,
                direction(other, declarations)?,
            );
            let fits = upright.number == tilted.number
                && upright.frame != tilted.frame
                && !upright.reversed
                && !tilted.reversed
                && is_inertial(&upright.frame, declarations)
                && !turned(&tilted.frame);
            fits.then_some(Leaning {
                written: [name(one)?, name(other)?],
                by: by.clone(),
                upright,
                tilted,
                said,
            })
        })
}

/// "A is a frame that turns relative to N": how it turns is told by then.
fn leave_free_turn(statement: &mut Statement, frame: &Term) {
    if let Statement::Is { subjects, what } = statement
        && what.head == "frame"
        && subjects.contains(frame)
        && what.slots.iter().all(|(slot, _)| *slot == Slot::RelativeTo)
    {
        *what = NounPhrase::new("frame", vec![]);
    }
}

/// "The plane of k and w turns about k by the angle `$\phi$` from the plane of k and i", "`$\phi$` is the angle about k from the
/// plane of k and i to the plane of k and w", "… from i to the part of w on the plane of i and j".
fn azimuth(
    said: usize,
    statement: &Statement,
    leaning: &Leaning,
    declarations: &[Declaration],
) -> Option<Azimuth> {
    let (by, slots, to) = match statement {
        Statement::Does {
            subjects,
            verb: "turn",
            slots,
        } => match (subjects.as_slice(), slot(slots, Slot::By)?) {
            ([plane], Term::Phrase(angle)) => (angle.slot(Slot::Which)?, slots, plane),
            _ => return None,
        },
        Statement::Is { subjects, what } if what.head == "angle" => match subjects.as_slice() {
            [letter] => (letter, &what.slots, what.slot(Slot::To)?),
            _ => return None,
        },
        _ => return None,
    };
    let (Term::Formula(by), 3) = (by, slots.len()) else {
        return None;
    };
    let upright = Term::Name(leaning.written[0].clone());
    let own = |term: &Term| name(term) == name(&upright);
    let about = slot(slots, Slot::About).is_some_and(own);
    if !about || !leads_to(to, leaning, declarations) {
        return None;
    }
    let from = slot(slots, Slot::RelativeTo)?;
    let from = match in_plane(from, &leaning.written[0]) {
        Some(other) => direction(&other, declarations)?,
        None => direction(from, declarations)?,
    };
    let across = from.frame == leaning.upright.frame && from.number != leaning.upright.number;
    (across && !from.reversed).then(|| Azimuth {
        from,
        by: by.clone(),
        said,
    })
}

/// Whether an angle leads to the plane of both axes, or to the part of the tilted one in the plane across the upright one.
fn leads_to(to: &Term, leaning: &Leaning, declarations: &[Declaration]) -> bool {
    let [upright, tilted] = &leaning.written;
    let Term::Phrase(phrase) = to else {
        return false;
    };
    if phrase.head != "part" {
        return in_plane(to, upright)
            .and_then(|other| name(&other))
            .as_ref()
            == Some(tilted);
    }
    let own = phrase.slot(Slot::Of).and_then(name).as_ref() == Some(tilted);
    let across = |plane: &Term| {
        let Term::Phrase(plane) = plane else {
            return false;
        };
        let axes = plane
            .all(Slot::Of)
            .filter_map(|axis| direction(axis, declarations));
        let numbers = axes.map(|axis| (axis.frame, axis.number));
        let spanned: Vec<(Term, usize)> = numbers.collect();
        let beside = |(frame, number): &(Term, usize)| {
            *frame == leaning.upright.frame && *number != leaning.upright.number
        };
        plane.head == "plane" && spanned.len() == 2 && spanned.iter().all(beside)
    };
    let planes: Vec<&Term> = [Slot::On, Slot::In]
        .iter()
        .flat_map(|s| phrase.all(*s))
        .collect();
    own && matches!(planes.as_slice(), [plane] if across(plane))
}

/// The other direction of a plane in which one lies.
fn in_plane(term: &Term, one: &str) -> Option<Term> {
    let Term::Phrase(plane) = term else {
        return None;
    };
    let spanned: Vec<&Term> = plane.all(Slot::Of).collect();
    let own = |term: &Term| name(term).as_deref() == Some(one);
    match spanned.as_slice() {
        [first, second] if plane.head == "plane" && plane.slots.len() == 2 => {
            match (own(first), own(second)) {
                (true, false) => Some((*second).clone()),
                (false, true) => Some((*first).clone()),
                _ => None,
            }
        }
        _ => None,
    }
}

/// The axis of the tilted frame of which a sentence says that it is along the product of both axes.
fn node(leaning: &Leaning, declarations: &[Declaration]) -> Option<Node> {
    declarations.iter().enumerate().find_map(|(said, d)| {
        let (axis, along) = match &d.statement {
            Statement::Holds(equation) => {
                let (axis, along) = equation.source.split_once('=')?;
                (Term::Name(axis.trim().to_owned()), along.to_owned())
            }
            Statement::Is { subjects, what } if what.head == UNIT_VECTOR => {
                match (subjects.as_slice(), what.slots.as_slice()) {
                    ([axis], [(Slot::Along, Term::Formula(along))]) => {
                        (axis.clone(), along.source.clone())
                    }
                    _ => return None,
                }
            }
            said => match said.does("point")? {
                ([axis], [(Slot::Along, Term::Formula(along))]) => {
                    (axis.clone(), along.source.clone())
                }
                _ => return None,
            },
        };
        let equation = matches!(d.statement, Statement::Holds(_));
        let forwards = crossed(&along, leaning, equation)?;
        let axis = direction(&axis, declarations)?;
        let own = axis.frame == leaning.tilted.frame && axis.number != leaning.tilted.number;
        (own && !axis.reversed).then_some(Node {
            axis,
            forwards,
            said,
        })
    })
}

/// Whether a formula is upright × tilted, over its magnitude where it has to be a unit vector, or the opposite of that.
fn crossed(written: &str, leaning: &Leaning, of_length_one: bool) -> Option<bool> {
    let bare = |text: &str| -> String {
        let text = text.replace("\\left", "").replace("\\right", "");
        text.replace("\\,", "").split_whitespace().collect()
    };
    let written = bare(written);
    let [upright, tilted] = &leaning.written;
    let angle = bare(&leaning.by.source);
    [(upright, tilted, true), (tilted, upright, false)]
        .into_iter()
        .find_map(|(one, other, forwards)| {
            let product = bare(&format!("{one}\\times{other}"));
            let sines = [
                format!("\\sin{angle}"),
                format!("\\sin({angle})"),
                format!("\\sin{{{angle}}}"),
                format!("|{product}|"),
                format!("\\lvert{product}\\rvert"),
                format!("\\|{product}\\|"),
                format!("\\lVert{product}\\rVert"),
            ];
            let over = sines.iter().any(|sine| {
                let ways = [
                    format!("\\frac{{{product}}}{{{sine}}}"),
                    format!("\\dfrac{{{product}}}{{{sine}}}"),
                    format!("({product})/{sine}"),
                ];
                ways.contains(&written)
            });
            (over || !of_length_one && written == product).then_some(forwards)
        })
}

/// How the level frame and the tilted one turn.
fn statements(
    leaning: &Leaning,
    azimuth: &Azimuth,
    node: &Node,
    macros: &Macros,
) -> Option<Vec<Statement>> {
    let Node {
        axis: node,
        forwards,
        ..
    } = node;
    let (upright, by) = (leaning.upright.number, &azimuth.by.source);
    // Where the axis with the number of the node stands, in quarter turns about the upright one.
    let from = azimuth.from.number;
    let start = match (node.number == from, from == upright % 3 + 1) {
        (true, _) => 0,
        (false, true) => 1,
        (false, false) => -1,
    };
    let quarters = if *forwards { 1 - start } else { -1 - start };
    let turned = match quarters {
        0 => by.clone(),
        1 => format!("{by}+\\frac{{\\pi}}{{2}}"),
        -1 => format!("{by}-\\frac{{\\pi}}{{2}}"),
        2 => format!("{by}+\\pi"),
        _ => format!("{by}-\\pi"),
    };
    let leant = match forwards {
        true => leaning.by.source.clone(),
        false => format!("-{}", leaning.by.source),
    };
    let frame = &leaning.tilted.frame;
    let level = Term::Name(format!("level {}", name(frame)?));
    let turn = |frame: &Term, from: &Term, about: usize, by: &str| {
        let by = Term::Formula(formula(by, false, macros)?);
        Some(turns_by(frame, from, axis(about, Some(from)), by))
    };
    Some(vec![
        Statement::one_is(level.clone(), NounPhrase::new("frame", vec![])),
        turn(&level, &leaning.upright.frame, upright, &turned)?,
        turn(frame, &level, node.number, &leant)?,
    ])
}
