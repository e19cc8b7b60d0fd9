//! Equations whose roots are looked for: "the moments are the roots of `(5 - λ)(2 - λ) - 4 = λ² - 7λ + 6 = 0`".

use crate::algebra::Fraction;
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::given::is_zero;
use crate::verify::lines::line::Read;
use crate::verify::theory::decide::{Decision, Equation, decide};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;

/// Words of a sentence that speaks of them.
const WORDS: &[&str] = &["roots", "root of", "characteristic", "eigenvalue"];

/// Words of a sentence that gives the moments about the principal axes.
const MOMENTS: &[&str] = &["principal moments", "eigenvalues", "principal values"];

impl Checker<'_> {
    /// Settles an equation for a new symbol that its sentence calls a root: what the chain says before its zero is a
    /// claim, that it vanishes picks the symbol out.
    pub(crate) fn seeks_roots(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [before @ .., last] = sides else {
            return false;
        };
        let sentence = lowered(&self.sentence);
        let speaks = has_any(&sentence, WORDS);
        if !speaks || !is_zero(last) || self.unknown(sides).is_none() {
            return false;
        }
        if before.len() > 1 {
            let Ok(read) = self.read(before, Frame::Moving) else {
                return false;
            };
            if !matches!(decide(&mut self.theory, &read.equations), Decision::True(_)) {
                return false;
            }
        }
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Assume;
        finding.remarks.push("its roots are looked for".to_owned());
        true
    }

    /// Decides what a sentence gives as a principal moment of a tensor that is written out with products of inertia:
    /// det(I − λ1) vanishes there.
    pub(crate) fn is_principal_moment(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right] = sides else { return false };
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        if !has_any(&lowered(&self.sentence), MOMENTS) {
            return false;
        }
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let numbered =
            matches!(symbol.subscripts.as_slice(), [n] if matches!(n.as_str(), "1" | "2" | "3"));
        let moment = numbered
            && matches!(self.meaning_of(symbol), Meaning::Component(entity, 0..3) if entity == inertia);
        let root = symbol.name == "lambda" && self.new_symbol(left).is_some();
        let Some(tensor) = self.written_tensor().filter(|_| moment || root) else {
            return false;
        };
        let Some(value) = self.lowering(Frame::Moving).scalar(right) else {
            return false;
        };
        let less = Value::identity(3).scaled(&-value);
        let determinant = tensor
            .plus(&less, false)
            .and_then(|less| less.determinant());
        let Ok(determinant) = determinant else {
            return false;
        };
        let equations = vec![Equation::of_scalars(determinant, Fraction::zero())];
        let read = Read::of(equations);
        match decide(&mut self.theory, &read.equations) {
            Decision::True(_) if root => self.accept(sides, Role::Define, finding),
            Decision::True(proof) => self.proved(&read, proof, finding),
            Decision::False(witness) => {
                finding.verdict = Verdict::Refuted;
                finding.reason = Some("the tensor has no such principal moment".to_owned());
                finding.counterexample = Some(*witness);
            }
            _ => return false,
        }
        true
    }

    /// The tensor of inertia, where lines say what its entries are and it has products.
    fn written_tensor(&mut self) -> Option<Value> {
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let whole = Meaning::Whole(inertia);
        let tensor = self.lowering(Frame::Moving).meaning_value(whole, 0);
        let tensor = tensor.map(|entry| self.theory.normal(entry));
        let own = |entry: &Fraction| {
            let variables = entry.variables();
            let mut entities = variables
                .into_iter()
                .map(|v| self.theory.atoms.entity_of(v));
            entities.any(|entity| entity == Some(inertia))
        };
        let products = [1, 2, 5]
            .into_iter()
            .filter_map(|at| tensor.entries.get(at));
        let products = products.filter(|entry| !entry.is_zero()).count() > 0;
        (tensor.entries.len() == 9 && products && !tensor.entries.iter().any(own)).then_some(tensor)
    }
}
