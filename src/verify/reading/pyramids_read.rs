//! Right pyramids on rectangles, with the sides of their base along two axes of their frames.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::heads::HEIGHT;
use crate::verify::language::statement::{Declaration, NounPhrase};
use crate::verify::model::system::{BodyId, Matrix};
use crate::verify::reading::boxes_read::{SIDE, by_axis};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::shapes_read::is_plain_shape;

/// The sizes of a pyramid, and the axis of its frame along which its height is.
struct Pyramid {
    /// In the order of the shape: the sides along the two axes that follow the axis, and the height.
    sizes: [Fraction; 3],
    axis: usize,
}

impl Builder<'_> {
    /// The tensor of a pyramid about its mass centre, which is the same whichever way its tip points.
    pub(super) fn pyramid_body(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let frame = self.reading.system.bodies[body].frame?;
        let pyramid = self.pyramid(body, what, declaration)?;
        let mass = self.reading.system.bodies[body].mass.clone();
        let pi = self.system().atoms.pi();
        let moments = mechanics::Shape::by_name(what.head)?.moments(&mass, &pyramid.sizes, &pi)?;
        let central = moments.central_inertia();
        // The third axis of the shape is that of the frame along which the height is, and the others follow it.
        let own = |axis: usize| (axis + 2 - pyramid.axis) % 3;
        let on_frame = Matrix::from_fn(|r, c| central[(own(r), own(c))].clone());
        let work = self.reading.system.work;
        let turn = self.system().rotation(work, frame);
        let tensor = mechanics::inertia_in_axes(&turn, &on_frame);
        self.reading.system.bodies[body].inertia = Some(tensor);
        Some(())
    }

    /// The volume of a pyramid.
    pub(super) fn content_of_pyramid(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Fraction> {
        let pyramid = self.pyramid(body, what, declaration)?;
        let pi = self.system().atoms.pi();
        mechanics::Shape::by_name(what.head)?.content(&pyramid.sizes, &pi)
    }

    /// The sides of the base by the axes along which they are told to be: the height is along the axis that is left.
    fn pyramid(
        &mut self,
        body: BodyId,
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Pyramid> {
        let frame = self.reading.system.bodies[body].frame?;
        let shape = mechanics::Shape::by_name(what.head)?;
        if !is_plain_shape(what, shape.sizes()) {
            return None;
        }
        let mut sides = by_axis(self.told_sides(SIDE, body, frame, declaration)?)?;
        let axis = sides.iter().position(Option::is_none)?;
        if self
            .told_axis_of_shape(body)
            .is_some_and(|told| told != axis)
        {
            return None;
        }
        let base = [sides[(axis + 1) % 3].take()?, sides[(axis + 2) % 3].take()?];
        let height = self.size_of_shape(body, what, HEIGHT, declaration)?;
        let [first, second] = base;
        Some(Pyramid {
            sizes: [first, second, height],
            axis,
        })
    }
}
