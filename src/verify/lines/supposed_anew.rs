//! A vector that is supposed to vanish, where the case at hand had supposed something else of it.

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::Premise;

impl Checker<'_> {
    /// Whether a vector that the case at hand supposes to be something is now supposed to vanish: "with ⟨u = −Dω⟩", and then
    /// "now let the motors rest, ⟨u = 0⟩".
    pub(crate) fn supposes_anew(&mut self, sides: &[Node]) -> bool {
        let [first, last] = sides else { return false };
        if !is_zero(last) || !matches!(inner(first).kind, Kind::Symbol(_)) {
            return false;
        }
        let Ok(value) = self.lowering(Frame::Moving).value(first) else {
            return false;
        };
        let own: Option<Vec<u32>> = value.entries.iter().map(Fraction::as_variable).collect();
        let Some(own) = own.filter(|own| own.len() == 3) else {
            return false;
        };
        let supposed = |p: &Premise| self.cases.is_supposed_now(&p.name) && p.residuals.len() == 3;
        let by_others = |p: &Premise| {
            let mut entries = p.residuals.iter().zip(&own);
            entries.all(|(r, v)| r.variables().contains(v) && r.as_variable().is_none())
        };
        let mut premises = self.theory.premises().iter();
        premises.any(|p| supposed(p) && by_others(p))
    }
}
