//! A moment that acts about one axis alone: "gravity has a moment about x only, ⟨M_x = m g ℓ sin θ⟩".

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::theory::Premise;
use crate::verify::values::atoms::variable_fraction;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Verdict};
use crate::verify::words::book::{has_any, lowered};

/// What holds then.
const ABOUT_ONE_AXIS: &str = "the moment acts about one axis alone";

impl Checker<'_> {
    /// Notes that the components of the moment on the other axes vanish, where words say so of the one that a line gives.
    pub(crate) fn note_lone_moment(&mut self, sides: &[Node], finding: &Finding) {
        let nothing = sides.last().is_none_or(is_zero);
        if nothing || finding.verdict != Verdict::Accepted || !self.speaks_of_one_moment() {
            return;
        }
        let Some(Kind::Symbol(symbol)) = sides.first().map(|side| &inner(side).kind) else {
            return;
        };
        let moment = self.theory.atoms.quantity(Quantity::Moment);
        let axis = match self.meaning_of(symbol) {
            Meaning::Component(entity, axis) if entity == moment => axis,
            _ => return,
        };
        let others = (0..3).filter(|&other| other != axis);
        let parts: Vec<_> = others
            .map(|c| self.theory.atoms.part(moment, c, 0))
            .collect();
        self.theory.assume(Premise {
            name: ABOUT_ONE_AXIS.to_owned(),
            residuals: parts.iter().map(|&part| variable_fraction(part)).collect(),
            preferred: parts,
            definition: false,
        });
        self.keep(ABOUT_ONE_AXIS, false);
    }

    fn speaks_of_one_moment(&self) -> bool {
        let words = lowered(&self.sentence);
        let clause = words.rsplit(['.', ';']).next().unwrap_or_default();
        let acts = ["moment", "torque", "couple", "gravity", "weight"];
        let alone = [" only", " alone", "single "];
        let denied = ["not only", " of inertia", "depend"];
        has_any(clause, &acts) && has_any(clause, &alone) && !has_any(clause, &denied)
    }
}
