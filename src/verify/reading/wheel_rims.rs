//! Where wheels touch planes of which no shape is told.

use crate::verify::language::statement::{Declaration, Slot, slot};
use crate::verify::language::traits::{Trait, has};
use crate::verify::model::contact::Round;
use crate::verify::model::system::{BodyId, FrameId};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::names::name_of;
use crate::verify::reading::shapes_read::RADIUS;

impl Builder<'_> {
    /// A wheel with a radius touches planes with its rim, about the axis about which it turns.
    pub(super) fn round_wheel(&mut self, body: BodyId, declaration: &Declaration) -> Option<()> {
        let whole = &self.reading.system.bodies[body];
        let wheel = whole.name.split(' ').any(|word| has(word, Trait::Wheel));
        if !wheel || whole.round.is_some() || self.is_centre_aside(body) {
            return None;
        }
        let axis = self.axle_of(body)?;
        let radius = self.said_size(body, RADIUS)?;
        let radius = self.size_by_letter(&radius, declaration)?;
        self.reading.system.bodies[body].round = Some(Round::Rim { radius, axis });
        Some(())
    }

    /// Whether the mass centre is told by its place from another point of the body, which may be the middle.
    fn is_centre_aside(&self, body: BodyId) -> bool {
        let frame = self.reading.system.bodies[body].frame;
        let spoken = self.spoken_points();
        let centre = |name: &String| {
            let mut all = spoken.iter();
            all.any(|point| point.name == *name && point.centre_of == Some(body))
        };
        let other = |name: &String| {
            let mut all = spoken.iter();
            let fixed = |f: &FrameId| Some(*f) == frame;
            !centre(name) && all.any(|p| p.name == *name && p.fixed_in.iter().any(fixed))
        };
        let mut placings = self
            .declarations
            .iter()
            .filter_map(|d| d.statement.places());
        placings.any(|(subjects, slots)| {
            let ends = subjects.iter().chain(slot(slots, Slot::From));
            let ends: Vec<String> = ends.filter_map(name_of).collect();
            ends.iter().any(centre) && ends.iter().any(other)
        })
    }
}
