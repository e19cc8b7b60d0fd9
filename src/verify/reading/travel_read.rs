//! How far a point has moved since the start.

use crate::algebra::{Fraction, Variable};
use crate::verify::facts::START;
use crate::verify::language::statement::{Declaration, NounPhrase, Slot};
use crate::verify::model::system::Vector;
use crate::verify::reading::builder::Builder;
use crate::verify::term::quantity::{Quantity, Spot};

impl Builder<'_> {
    /// "the travel of G down the incline": of a point that no sentence places it is the position, from where the point is at
    /// the start.
    pub(super) fn travel(
        &mut self,
        phrase: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<Quantity> {
        let Spot::Point(point) = self.spot(phrase.slot(Slot::Of)?)? else {
            return None;
        };
        let travel = Quantity::Position {
            of: Spot::Point(point),
            from: 0,
        };
        let system = self.system();
        let way = system.value_of(&travel).ok()?.to_vector().ok()?;
        let parts: Vec<Variable> = way.iter().flat_map(Fraction::variables).collect();
        let start = self.reading.instants.named(START);
        let told = |part: &Fraction| start.values.iter().any(|(value, _)| value == part);
        if way.iter().all(told) {
            return Some(travel);
        }
        let atoms = &mut self.reading.system.atoms;
        let hidden = |part: &Fraction| part.as_variable().is_some_and(|v| atoms.is_unplaced(v));
        if !way.iter().all(hidden) {
            return None;
        }
        atoms.set_placed(parts);
        let source = Self::source_of(declaration);
        let then = way.iter().map(|part| (part.clone(), source.clone()));
        start.values.extend(then);
        // The mass centre of what is round stays as far from the plane on which it moves.
        let contacts = self.reading.system.contacts.iter();
        let centred = contacts.filter(|contact| self.centre_of(contact.body) == point);
        let normals: Vec<Vector> = centred.map(|c| c.plane.normal.clone()).collect();
        for normal in normals {
            self.hold(normal.dot(&way), declaration);
        }
        Some(travel)
    }
}
