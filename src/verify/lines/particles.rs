//! The particles of a rigid body, over which a document sums, and a point that it carries round: their places are fixed
//! in the body, so that dr_i/dt = ω × r_i.

use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::lines::points::Law;
use crate::verify::values::value::Value;

impl Checker<'_> {
    /// Holds the places of particles still on the axes of the body, where the document calls it rigid.
    pub(crate) fn tie_particles(&mut self) {
        let Some(place) = self.reading.particle.clone() else {
            return;
        };
        let Some(entity) = self.entity_named(&place) else {
            return;
        };
        self.theory.atoms.info_mut(entity).constant = true;
        self.known.insert(entity);
        let velocity = every_symbol(self.document)
            .into_iter()
            .find(|s| s.name == "v" && s.style.vector && s.subscripts == place.subscripts)
            .cloned();
        if let Some(velocity) = velocity.filter(|v| self.is_new(v))
            && let Some(own) = self.entity_named(&velocity)
        {
            let place = Value::column(self.theory.atoms.vector(entity, 0));
            let rate = self.lowering(Frame::Space).space_rate(&place);
            self.take_law(Law::new("kinematics", own, rate));
        }
    }
}
