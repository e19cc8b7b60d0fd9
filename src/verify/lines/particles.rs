//! The particles of a rigid body, over which a document sums, and a point that it carries round: their places are fixed
//! in the body, so that dr_i/dt = ω × r_i.

use crate::notation::ast::{Kind, Node, Operator, Symbol};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::two_points::every_symbol;
use crate::verify::letters::usage::{Letter, inner};
use crate::verify::lines::points::Law;
use crate::verify::values::quantity::Quantity;
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

    /// Why `d\mathbf L/dt = \boldsymbol\Omega\times\mathbf L` of a rotor's L on axes that turn at Ω may hold: where L
    /// keeps its components there, as of a steady spin.
    pub(crate) fn turns_with_the_axes(&self, sides: &[Node]) -> Option<String> {
        let [left, right] = sides else { return None };
        let lone = |node: &Node| match &inner(node).kind {
            Kind::Symbol(symbol) => Some(symbol.clone()),
            _ => None,
        };
        let (Kind::TimeDerivative { operand, .. }, Kind::Product(factors)) =
            (&inner(left).kind, &inner(right).kind)
        else {
            return None;
        };
        let [turn, arm] = factors.as_slice() else {
            return None;
        };
        let is = |node: &Node, quantity: Quantity| {
            let own = |s: Symbol| self.reading.quantities.get(&Letter::of(&s)) == Some(&quantity);
            lone(node).is_some_and(own)
        };
        let of_rotor = is(operand, Quantity::RelativeMomentum) && lone(operand) == lone(&arm.node);
        let turns = arm.operator == Operator::Cross && is(&turn.node, Quantity::FrameRate);
        (of_rotor && turns)
            .then(|| "nothing before says whether it keeps its components on the axes".to_owned())
    }
}
