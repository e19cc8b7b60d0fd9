//! Whether wheels in the body turn at one speed: "a motor can change this speed", "assume a constant wheel speed".

use crate::algebra::Variable;
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::values::atoms::Owner;
use crate::verify::values::quantity::Quantity;
use crate::verify::words::book::has_any;
use crate::verify::words::phrases::speaks_of_wheels;

/// What changes the speed of a wheel, or whose speed it is.
const OF_SPEED: &[&str] = &["motor", "speed", "spin"];
/// Words by which it changes.
const CHANGES: &[&str] = &[
    "can change",
    "may change",
    "can vary",
    "may vary",
    "varies",
    "changes",
    "is changed",
    "is varied",
    "variable",
    "accelerates",
    "speeds up",
    "spins up",
];
/// Words by which it does not.
const STAYS: &[&str] = &[" not ", "constant", "never", " no "];
/// A wheel that keeps its speed.
const STEADY: &[&str] = &[
    "constant wheel speed",
    "constant rotor speed",
    "constant speed of the wheel",
    "constant speed of the rotor",
    "wheel speed constant",
    "wheel speed is constant",
    "rotor speed is constant",
    "wheel speed is held constant",
    "wheel speed is kept constant",
    "wheel at constant speed",
    "wheel at a constant speed",
    "rotor at constant speed",
];

impl Checker<'_> {
    /// Lets symbols of the document in the momentum of wheels move where words say that their speed changes.
    pub(crate) fn let_wheels_change(&mut self, within: &[Variable]) {
        let mut said = self.text.named_sentences().iter();
        let changes = said.any(|sentence| {
            let text = sentence.text.as_str();
            has_any(text, OF_SPEED) && has_any(text, CHANGES) && !has_any(text, STAYS)
        });
        if !changes {
            return;
        }
        for &variable in within {
            let Some(entity) = self.theory.atoms.entity_of(variable) else {
                continue;
            };
            let moves = match &self.theory.atoms.info(entity).owner {
                Owner::Symbol(key) => !self.is_moment_of_inertia(key),
                Owner::Quantity(quantity, _) => *quantity == Quantity::AngularVelocity,
            };
            if moves {
                self.theory.atoms.info_mut(entity).constant = false;
            }
        }
    }

    /// Takes in that the wheels keep the speed that they have in the body, where a sentence in small letters says so.
    pub(crate) fn wheels_turn_steadily(&mut self, text: &str, span: Span) {
        if !self.theory.setting.gyrostat || !speaks_of_wheels(text) || !has_any(text, STEADY) {
            return;
        }
        let wheels = Quantity::RelativeMomentum;
        self.stay_in_words("constant wheel speed", wheels, &[0, 1, 2], span);
    }
}
