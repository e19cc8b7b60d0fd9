//! Corners of boxes, cubes and plates, from which edges run along axes.

use crate::algebra::Fraction;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot, Statement, Term};
use crate::verify::model::system::{BodyId, Vector};
use crate::verify::reading::boxes_read::SIDE;
use crate::verify::reading::builder::Builder;

/// The noun of the points where edges meet.
pub(super) const CORNER: &str = "corner";

/// The body whose edges are all alike.
const ALIKE: &str = "cube";

impl Builder<'_> {
    /// "O is the corner of the cube along x, y, z": the mass centre lies half an edge away along each of them.
    pub(super) fn hold_corners(&mut self) {
        for declaration in self.declarations {
            let Statement::Is { subjects, what } = &declaration.statement else {
                continue;
            };
            if what.head != CORNER || what.slot(Slot::Along).is_none() {
                continue;
            }
            let held = self.hold_corner(subjects, what, declaration);
            held.unwrap_or_else(|| self.say_unused(declaration));
        }
    }

    fn hold_corner(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [corner] = subjects else { return None };
        let corner = self.point(corner)?;
        let body = what.slot(Slot::Of).and_then(|of| self.body(of))?;
        let frame = self.reading.system.bodies[body].frame;
        let sides = frame.and_then(|frame| self.told_sides(SIDE, body, frame, declaration));
        let sides = sides.map_or(0, |sides| sides.len());
        // A corner is told by all the sides of a body.
        if sides > 0 && sides != what.all(Slot::Along).count() {
            return None;
        }
        let mut way = Vector::zeros();
        for axis in what.all(Slot::Along) {
            let edge = self.edge_along(body, axis, declaration)?;
            way += self.axis_vector(axis, declaration)? * edge;
        }
        let centre = self.centre_of(body);
        let half = Fraction::from_ratio(1, 2);
        let centre = self.system().position(centre, corner);
        self.hold_zero(&(centre - way * half), declaration);
        Some(())
    }

    /// How long a body is along an axis.
    fn edge_along(
        &mut self,
        body: BodyId,
        axis: &Term,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        if let Some((what, said)) = self.said_to_be(body, |noun| noun == ALIKE) {
            return self.size_of_shape(body, what, "edge", said);
        }
        let (frame, number) = self.axis_of_frame(axis)?;
        let sides = self.told_sides(SIDE, body, frame, declaration)?;
        let own = sides.into_iter().find(|(axis, _)| *axis == number);
        own.map(|(_, side)| side)
    }

    /// Whether a sentence tells along which axes the edges run at a corner.
    pub(super) fn is_corner_placed(&self, corner: &Term) -> bool {
        self.declarations.iter().any(|d| match &d.statement {
            Statement::Is { subjects, what } => {
                let along = what.head == CORNER && what.slot(Slot::Along).is_some();
                along && subjects.contains(corner)
            }
            _ => false,
        })
    }
}
