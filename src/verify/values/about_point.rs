//! Symbols of the inertia about one of two points.

use crate::notation::ast::Symbol;
use crate::verify::letters::point_labels::Place;
use crate::verify::letters::reading::Reading;
use crate::verify::letters::two_points::TwoPoints;
use crate::verify::values::atoms::{Atoms, Entity};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::{Meaning, quantity_entity};

/// The inertia about one of two points, or a component of it.
pub(crate) fn about_a_point(
    symbol: &Symbol,
    reading: &Reading,
    atoms: &mut Atoms,
) -> Option<Meaning> {
    let points = reading.points.as_ref()?;
    let (label, place) = points.place(symbol)?;
    let component = match place {
        Place::Entry(component) => Some(component),
        Place::Whole(true) => None,
        // In a plane each moment is the one about z.
        Place::Whole(false) if reading.plane => Some(2),
        Place::Whole(false) => return None,
    };
    let entity = tensor_about(label, points, atoms);
    Some(match component {
        Some(component) => Meaning::Component(entity, component),
        None => Meaning::Whole(entity),
    })
}

/// The inertia tensor about the point of a label.
pub(crate) fn tensor_about(label: &str, points: &TwoPoints, atoms: &mut Atoms) -> Entity {
    let variant = if label == points.main { "" } else { label };
    quantity_entity(Quantity::Inertia, variant, "I", atoms)
}
