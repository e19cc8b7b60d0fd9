//! What vectors without labels hold, where a sentence says it.

use crate::notation::ast::Symbol;
use crate::verify::term::letters::{Effect, Mark};
use crate::verify::term::lower::Lowering;
use crate::verify::term::symbols::on;
use crate::verify::term::value::{Basis, Value};

impl Lowering<'_> {
    /// A vector or tensor without a label, and above all the unit vector of an axis, where a sentence says what that means.
    pub(super) fn without_label(&mut self, value: Value, symbol: &Symbol, axis: bool) -> Value {
        let rule = self.letters.mark(Mark::AxisWithoutLabel, self.at);
        if let Some(Effect::ComponentsOn(frame)) = rule
            && axis
            && symbol.superscripts.is_empty()
        {
            return on(value, *frame);
        }
        let labelled = !symbol.superscripts.is_empty() || symbol.style.tilde || symbol.style.hat;
        let itself = !value.is_scalar() && value.basis.contains(&Basis::Itself);
        if labelled || !itself {
            return value;
        }
        match self.letters.mark(Mark::NoLabel, self.at) {
            Some(Effect::ComponentsOn(frame)) => on(value, *frame),
            _ => value,
        }
    }
}
