//! Libration: one angle gives the direction of the planet on the axes of a body in orbit, and is all that changes.

use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::{Entity, Owner};
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::value::Value;
use num_traits::Zero;

/// What holds while one angle is all that changes.
const LIBRATION: &str = "the body turns about the axis of the angle";

/// Words for what turns the body.
const GRADIENT: &[&str] = &[
    "gravity gradient",
    "gravity-gradient",
    "gradient of gravity",
];
/// Words for a motion with one angle.
const IN_PLANE: &[&str] = &[
    "pitch",
    "planar",
    "in the plane of the orbit",
    "in the orbit plane",
];

impl Checker<'_> {
    /// A body of which one angle turns the direction of the planet on its axes turns about the axis of this angle, and
    /// about no other but with its orbit.
    pub(crate) fn note_libration(&mut self, sides: &[Node]) {
        let named = self.text.says(GRADIENT) && self.text.says(IN_PLANE);
        if !named || self.theory.premises().iter().any(|p| p.name == LIBRATION) {
            return;
        }
        let met = self.entities(sides);
        let Some((angle, axis)) = met.into_iter().find_map(|e| Some((e, self.turn_by(e)?))) else {
            return;
        };
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let acceleration = self.theory.atoms.value(angle, 0, 2);
        let mut preferred = vec![];
        let mut residuals = vec![];
        for (c, part) in (0..).zip(&axis.entries) {
            let order = u8::from(!part.is_zero());
            let turns = part.clone() * acceleration.clone();
            preferred.push(self.theory.atoms.part(omega, c, order));
            residuals.push(self.theory.atoms.value(omega, c, order) - turns);
        }
        self.theory.assume(Premise {
            name: LIBRATION.to_owned(),
            residuals,
            preferred,
            definition: true,
        });
        self.keep(LIBRATION, true);
        self.known.insert(angle);
    }

    /// The axis e that an angle turns the body about, where a unit vector u of the document obeys du/dθ = −e × u.
    fn turn_by(&mut self, angle: Entity) -> Option<Value> {
        let own = matches!(self.theory.atoms.info(angle).owner, Owner::Symbol(_));
        let scalar = self.theory.atoms.info(angle).shape == Shape::Scalar;
        if !own || !scalar {
            return None;
        }
        let place = self.theory.atoms.part(angle, 0, 0);
        let vectors: Vec<Entity> = self.known.iter().copied().collect();
        vectors.into_iter().find_map(|vector| {
            let info = self.theory.atoms.info(vector);
            if info.shape != Shape::Vector || !matches!(info.owner, Owner::Symbol(_)) {
                return None;
            }
            let u = Value::column(self.theory.atoms.vector(vector, 0));
            let u = u.map(|part| self.theory.normal(part));
            let slope = u.map(|part| self.lowering(Frame::Moving).partial(part, place));
            let axis = slope.cross(&u).ok()?;
            let axis = axis.map(|part| self.theory.normal(part));
            let mut parts = axis.entries.iter().map(|part| part.to_rational());
            let unit = parts.clone().all(|part| part.is_some())
                && parts.any(|part| part.is_some_and(|p| p == 1.into() || p == (-1).into()));
            unit.then_some(axis)
        })
    }
}
