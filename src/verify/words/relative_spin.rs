//! The spin of a body on axes that follow its axle and do not spin with it, where no letter stands for its own angular
//! velocity: "the wheel adds ⟨\dot\psi⟩ about the axle".

use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::theory::Premise;
use crate::verify::theory::law::Axes;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::lowered;

/// Words of axes that do not spin with the body.
pub(crate) const WITHOUT_SPIN: &[&str] = &[
    "does not spin",
    "do not spin",
    "not spinning",
    "non-spinning",
    "nonspinning",
    "part in the spin",
    "part in its spin",
    "share the spin",
    "share its spin",
    "but not its spin",
    "not in its spin",
];
/// Words right before the rate.
const BEFORE: &[&str] = &[
    "adds",
    "adds the spin",
    "spins at",
    "spins with",
    "spins at the rate",
    "spins with the rate",
    "with the spin",
    "has the spin",
    "with the relative spin",
    "relative spin is",
    "spin rate is",
    "has the spin rate",
];

impl Checker<'_> {
    /// Takes in that the body turns as its axes do and by the spin besides, about the third of them.
    pub(crate) fn spins_on_axes(&mut self, node: &Node) {
        let said = lowered(self.sentence.trim_end());
        let spins = BEFORE.iter().any(|words| said.ends_with(words));
        let axes = self.reading.axes_without_spin && self.theory.setting.axes == Axes::Turning;
        if !spins || !axes || self.reading.speaks_of(Quantity::AngularVelocity) {
            return;
        }
        let Some(spin) = self.lowering(Frame::Moving).scalar(node) else {
            return;
        };
        let [body, turn] = [Quantity::AngularVelocity, Quantity::FrameRate].map(|quantity| {
            let entity = self.theory.atoms.quantity(quantity);
            self.theory.atoms.vector(entity, 0)
        });
        let omega = self.theory.atoms.quantity(Quantity::AngularVelocity);
        let preferred = [0, 1, 2].map(|c| self.theory.atoms.part(omega, c, 0));
        let mut residuals: Vec<_> = body.into_iter().zip(turn).map(|(b, t)| b - t).collect();
        if let Some(axial) = residuals.last_mut() {
            *axial = axial.clone() - spin;
        }
        let premise = Premise {
            name: "the body spins about the third of the axes used".to_owned(),
            residuals,
            preferred: preferred.to_vec(),
            definition: true,
        };
        if self.take_from_words(premise, node.span) {
            self.now_known([node]);
        }
    }
}
