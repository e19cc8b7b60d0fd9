//! Boxes and rectangular plates, whose sides lie along the axes of their frames.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::heads::MASS;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, FrameId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use num_traits::Zero;

/// The sizes of a box.
pub(super) const SIDE: &str = "side";
/// A box without thickness.
const PLATE: &str = "plate";
/// What may be said of a box or a plate without making it another one.
const PLAIN: [&str; 7] = [
    "uniform",
    "thin",
    "rigid",
    "solid",
    "heavy",
    "rectangular",
    "right",
];

impl Builder<'_> {
    /// The tensor of a box by its three sides, of a plate by the two along it.
    pub(super) fn sided_body(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let frame = self.reading.system.bodies[body].frame?;
        let sides = self.sides_in_order(body, what, declaration)?;
        let mass = self.reading.system.bodies[body].mass.clone();
        let pi = self.system().atoms.pi();
        let moments = mechanics::Shape::by_name("box")?.moments(&mass, &sides, &pi)?;
        let work = self.reading.system.work;
        let turn = self.system().rotation(work, frame);
        let tensor = mechanics::inertia_in_axes(&turn, &moments.central_inertia());
        self.reading.system.bodies[body].inertia = Some(tensor);
        Some(())
    }

    /// The sides of a box along the axes of its frame; of a plate the one along its normal is zero.
    pub(super) fn sides_in_order(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Vec<Fraction>> {
        let frame = self.reading.system.bodies[body].frame?;
        let mass_alone = what.slots.iter().all(|(slot, term)| match (slot, term) {
            (Slot::Of, Term::Phrase(size)) => size.head == MASS,
            // "with the edges `$a$`, `$b$` and `$c$`", where others tell along which axes they are.
            (Slot::With, side @ Term::Formula(_)) => {
                self.are_laid_elsewhere(std::slice::from_ref(side), SIDE, body)
            }
            _ => false,
        });
        if !mass_alone || what.adjectives.iter().any(|said| !PLAIN.contains(said)) {
            return None;
        }
        let mut sides = by_axis(self.told_sides(SIDE, body, frame, declaration)?)?;
        // A plate has no thickness.
        if what.head == PLATE && sides.iter().flatten().count() == 2 {
            let normal = sides.iter().position(Option::is_none)?;
            sides[normal] = Some(Fraction::zero());
        }
        sides.into_iter().collect()
    }

    /// The sides or semi-axes of a body by the axes of its frame: "`$a$`, `$b$` and `$c$` are the sides of the block along
    /// x, y and z".
    pub(super) fn told_sides(
        &mut self,
        noun: &str,
        body: BodyId,
        frame: FrameId,
        declaration: &Declaration,
    ) -> Option<Vec<(usize, Fraction)>> {
        let mut sides = vec![];
        for other in self.declarations {
            let Statement::Is { subjects, what } = &other.statement else {
                continue;
            };
            let of = what.slot(Slot::Of).and_then(|of| self.body(of));
            if what.head != noun || of != Some(body) {
                continue;
            }
            let along: Vec<&Term> = what.all(Slot::Along).collect();
            if along.is_empty() && self.are_laid_elsewhere(subjects, noun, body) {
                continue;
            }
            let axes: Vec<usize> = match along.as_slice() {
                [Term::Phrase(axes)] if axes.head == "axes" => {
                    let of = axes.slot(Slot::Of).and_then(|of| self.frame(of));
                    (of == Some(frame)).then(|| (0..3).collect())?
                }
                along => along
                    .iter()
                    .map(|axis| {
                        let (of, axis) = self.axis_of_frame(axis)?;
                        (of == frame).then_some(axis)
                    })
                    .collect::<Option<_>>()?,
            };
            if axes.len() != subjects.len() {
                return None;
            }
            for (axis, letter) in axes.into_iter().zip(formulas(subjects)) {
                let side = self.size_by_letter(letter, declaration)?;
                sides.push((axis, side));
            }
        }
        Some(sides)
    }
}

impl Builder<'_> {
    /// Whether other sentences tell along which axes the same sides of a body are.
    fn are_laid_elsewhere(&self, sides: &[Term], noun: &str, body: BodyId) -> bool {
        let laid = |side: &Term| {
            self.declarations.iter().any(|d| match &d.statement {
                Statement::Is { subjects, what } => {
                    let of = what.slot(Slot::Of).and_then(|of| self.body(of));
                    let own = what.head == noun && of == Some(body);
                    own && what.slot(Slot::Along).is_some() && subjects.contains(side)
                }
                _ => false,
            })
        };
        sides.iter().all(laid)
    }
}

/// Sizes in the order of the axes, no more than one along each.
pub(super) fn by_axis(told: Vec<(usize, Fraction)>) -> Option<[Option<Fraction>; 3]> {
    let mut sizes: [Option<Fraction>; 3] = [None, None, None];
    for (axis, size) in told {
        if sizes[axis].replace(size).is_some() {
            return None;
        }
    }
    Some(sizes)
}
