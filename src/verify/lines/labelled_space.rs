//! Lines whose symbols a label puts on axes of fixed orientation, all of them: `\tau_w = I_w\dot\omega_w + \dot I_w\omega_w`.
//!
//! With every component turned there they grow beyond what is computed. On axes that do not turn they are short, and hold
//! there whatever the attitude is.

use crate::notation::ast::{Kind, Node, Symbol};
use crate::source::Span;
use crate::verify::check::Checker;
use crate::verify::letters::usage::{Letter, inner, symbols};
use crate::verify::theory::decide::{Decision, decide};
use crate::verify::theory::law::Axes;
use crate::verify::values::quantity::{Quantity, Shape};
use crate::verify::values::spatial::{all_in_space, without_label};
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::Finding;
use crate::verify::words::book::{has_any, lowered};

impl Checker<'_> {
    /// Proves a line on axes that do not turn, from what holds on all axes.
    pub(crate) fn proved_on_space_axes(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        if self.reading.space_axes.is_some() || !all_in_space(sides, &self.reading) {
            return false;
        }
        let stands = |checker: &mut Self, symbol: &Symbol| {
            let labelled = without_label(symbol, &checker.reading).is_some();
            labelled
                || matches!(checker.meaning_of(symbol), Meaning::Whole(entity)
                    if checker.theory.atoms.info(entity).shape == Shape::Scalar)
        };
        if !sides.iter().flat_map(symbols).all(|s| stands(self, s)) {
            return false;
        }
        let mut bare = sides.to_vec();
        for side in &mut bare {
            side.change_symbols(&mut |symbol| {
                if let Some(plain) = without_label(symbol, &self.reading) {
                    *symbol = plain;
                }
            });
        }
        self.decided_in_space(&bare, finding)
    }

    /// Proves the law `N_i = dL_i/dt` of a running index, where nothing before it puts the axes into the body: there it
    /// holds on axes that do not turn.
    pub(crate) fn is_law_in_space(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let (Kind::Symbol(moment), Kind::TimeDerivative { operand, .. }) =
            (&inner(left).kind, &inner(right).kind)
        else {
            return false;
        };
        let Kind::Symbol(momentum) = &inner(operand).kind else {
            return false;
        };
        let of =
            |s: &Symbol, quantity| self.reading.quantities.get(&Letter::of(s)) == Some(&quantity);
        let law = of(moment, Quantity::Moment)
            && of(momentum, Quantity::Momentum)
            && moment.subscripts == momentum.subscripts;
        let summed = self.reading.summed.as_ref();
        let running = summed.is_some_and(|indices| indices.wrote(finding.span));
        let before = Span::new(0, finding.span.start as usize);
        let before = lowered(self.document.source.slice(before));
        let in_body = has_any(&before, &["in the body", "body axes", "body frame"]);
        law && running && !in_body && self.decided_in_space(sides, finding)
    }

    fn decided_in_space(&mut self, bare: &[Node], finding: &mut Finding) -> bool {
        let before = self.theory.clone();
        let parted: Vec<String> = before
            .premises()
            .iter()
            .filter(|premise| !self.holds_on_all_axes(premise))
            .map(|premise| premise.name.clone())
            .collect();
        self.theory
            .retain(|premise| !parted.contains(&premise.name));
        self.theory.set(|setting| {
            setting.axes = Axes::Space;
            setting.attitude.rate_in_space = true;
        });
        let mut proved = false;
        for read in self.readings(bare).unwrap_or_default() {
            if let Decision::True(proof) = decide(&mut self.theory, &read.equations) {
                self.proved(&read, proof, finding);
                proved = true;
                break;
            }
        }
        let atoms = std::mem::take(&mut self.theory.atoms);
        self.theory = before;
        self.theory.atoms = atoms;
        proved
    }
}
