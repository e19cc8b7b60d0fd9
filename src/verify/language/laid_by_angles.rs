//! Rods that lie along a unit vector whose angle with an axis is the one by which they turn.

use super::heads::{MASS_CENTRE, UNIT_VECTOR};
use super::kinds::name;
use super::planar_axes::axes_of;
use super::reader::formula;
use super::statement::{Declaration, Slot, Statement, Term};
use super::turned_lines::{Direction, direction};
use crate::notation::Macros;

/// "O is an end of the rod. G is its mass centre. n is the unit vector from O to G": n is along the rod, which begins at O.
/// "The rod turns relative to N about z by the angle `$\theta$`. The angle between n and the downward vertical is `$\theta$`":
/// whatever angle n has with the vertical at first, it stays beside θ, and so it is zero: at θ = 0 the rod points downward.
pub(crate) fn lay_by_angles(declarations: &mut [Declaration], macros: &Macros) {
    for (at, laid) in laid_rods(declarations, macros) {
        let Some(zero) = formula(&format!("{}=0", laid.angle), false, macros) else {
            continue;
        };
        let slots = vec![(Slot::Along, laid.along), (Slot::At, Term::Formula(zero))];
        declarations[at].statement = Statement::Does {
            subjects: vec![laid.rod.clone()],
            verb: "point",
            slots,
        };
        if let Statement::Is { what, .. } = &mut declarations[laid.vector].statement {
            what.slots = vec![(Slot::Along, laid.rod)];
        }
    }
}

/// A rod, the sentence of the unit vector along it, where that points at first, and the letter of the angle.
struct Laid {
    rod: Term,
    vector: usize,
    along: Term,
    angle: String,
}

/// The sentences that tell angles of such unit vectors, and what they tell.
fn laid_rods(declarations: &[Declaration], macros: &Macros) -> Vec<(usize, Laid)> {
    let angles = declarations.iter().enumerate();
    let laid = angles.filter_map(|(at, declaration)| {
        let Statement::Is { subjects, what } = &declaration.statement else {
            return None;
        };
        let ([Term::Formula(angle)], "angle", 2) =
            (subjects.as_slice(), what.head, what.slots.len())
        else {
            return None;
        };
        let ends: Vec<&Term> = what.all(Slot::Between).collect();
        let &[one, other] = ends.as_slice() else {
            return None;
        };
        let told = |vector: &Term, from: &Term| {
            let (number, rod) = along_rod(vector, declarations)?;
            let start = direction(from, declarations)?;
            turns_across(&rod, &start, &angle.source, declarations).then_some((number, rod, start))
        };
        let (vector, rod, start) = told(one, other).or_else(|| told(other, one))?;
        let along = Term::Formula(formula(&start.name(declarations)?, false, macros)?);
        let laid = Laid {
            rod,
            vector,
            along,
            angle: angle.source.clone(),
        };
        Some((at, laid))
    });
    laid.collect()
}

/// The sentence by which a vector is along a rod, from the only end that is told to its mass centre, and the rod.
fn along_rod(vector: &Term, declarations: &[Declaration]) -> Option<(usize, Term)> {
    let vector = name(vector)?;
    let own = |subjects: &[Term]| matches!(subjects, [one] if name(one).as_ref() == Some(&vector));
    let mut said = declarations.iter().enumerate();
    said.find_map(|(at, d)| match &d.statement {
        Statement::Is { subjects, what } if what.head == UNIT_VECTOR && own(subjects) => {
            let (from, to) = (what.slot(Slot::From)?, what.slot(Slot::To)?);
            let rod = said_of(to, MASS_CENTRE, declarations)?;
            let mut ends = declarations.iter().filter_map(|d| match &d.statement {
                Statement::Is { subjects, what } if what.head == "end" => {
                    (what.slot(Slot::Of) == Some(&rod)).then_some(subjects)
                }
                _ => None,
            });
            let only = ends
                .next()
                .is_some_and(|ends| ends.as_slice() == [from.clone()]);
            (what.slots.len() == 2 && only && ends.next().is_none()).then_some((at, rod))
        }
        _ => None,
    })
}

/// Of what a point is said to be what a noun names.
fn said_of(point: &Term, head: &str, declarations: &[Declaration]) -> Option<Term> {
    declarations.iter().find_map(|d| match &d.statement {
        Statement::Is { subjects, what } if what.head == head && subjects.contains(point) => {
            what.slot(Slot::Of).cloned()
        }
        _ => None,
    })
}

/// Whether a rod, or a frame fixed in it, turns by an angle about an axis that stands across a direction, against the frame
/// of that, and nothing else is said of its turning.
fn turns_across(rod: &Term, start: &Direction, angle: &str, declarations: &[Declaration]) -> bool {
    let carried = |frame: &Term| {
        declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                what.head == "frame"
                    && subjects.contains(frame)
                    && what.slot(Slot::FixedIn) == Some(rod)
            }
            _ => false,
        })
    };
    let turning = declarations.iter().filter_map(|d| d.statement.does("turn"));
    let mut own =
        turning.filter(|(subjects, _)| subjects.iter().any(|turns| turns == rod || carried(turns)));
    let (Some((_, slots)), None) = (own.next(), own.next()) else {
        return false;
    };
    slots.iter().all(|(slot, term)| match (slot, term) {
        (Slot::RelativeTo, frame) => *frame == start.frame,
        (Slot::About, axis) => {
            let along = match axis {
                Term::Phrase(axis) => axis.slot(Slot::Along),
                axis => Some(axis),
            };
            let about = along.and_then(|along| direction(along, declarations));
            about.is_some_and(|about| about.frame == start.frame && about.number != start.number)
        }
        (Slot::By, Term::Phrase(by)) => {
            let which = by.slot(Slot::Which);
            matches!(which, Some(Term::Formula(own)) if own.source == angle)
        }
        _ => false,
    })
}

impl Direction {
    /// The name of the axis, or of its opposite.
    fn name(&self, declarations: &[Declaration]) -> Option<String> {
        let axes = axes_of(&self.frame, declarations)?;
        let axis = name(axes.get(self.number - 1)?)?;
        Some(match self.reversed {
            true => format!("-{axis}"),
            false => axis,
        })
    }
}
