//! The perpendicular axis theorem: of a flat body the moment across its plane is the sum of the two in it.

use crate::algebra::Fraction;
use crate::notation::ast::Node;
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::theory::decide::passes_filter;
use crate::verify::values::quantity::Quantity;
use crate::verify::values::value::Value;
use crate::verify::verdict::{Finding, Role, Verdict};
use crate::verify::words::book::{has_any, lowered};
use num_traits::Zero;

/// Words of a body that is flat, and of its law.
const FLAT: &[&str] = &[
    "perpendicular axis theorem",
    "perpendicular-axis theorem",
    "perpendicular axes theorem",
    "theorem of perpendicular axes",
    "lamina",
    "flat body",
    "flat plate",
    "thin plate",
    "thin disc",
    "thin disk",
    "flat disc",
    "flat disk",
    "thin uniform disc",
    "thin uniform disk",
];

/// Words of a body that is alike about two axes.
const SYMMETRY: &[&str] = &[
    "by symmetry",
    "because of symmetry",
    "due to symmetry",
    "from symmetry",
];

impl Checker<'_> {
    /// Takes in `I_1 + I_2 = I_3` where words say that the body is flat and some of the three are free.
    pub(crate) fn is_law_of_flat_body(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        if sides.len() != 2 || !self.text.says(FLAT) {
            return false;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let [equation] = read.equations.as_slice() else {
            return false;
        };
        let Some(said) = equation.residual.as_scalar().cloned() else {
            return false;
        };
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let moments = [0, 1, 2].map(|c| self.theory.atoms.value(inertia, c, 0));
        let [x, y, z] = moments.clone();
        let sums = [
            x.clone() + y.clone() - z.clone(),
            y.clone() + z.clone() - x.clone(),
            z + x - y,
        ];
        let is_sum = |sum: &Fraction| {
            (said.clone() - sum.clone()).is_zero() || (said.clone() + sum.clone()).is_zero()
        };
        let free = |moment: &Fraction| self.theory.normal(moment).as_variable().is_some();
        if !sums.iter().any(is_sum) || !moments.iter().any(free) {
            return false;
        }
        // It is flat in one plane only.
        let sums = sums.map(Value::scalar);
        if sums
            .iter()
            .any(|sum| passes_filter(&mut self.theory, sum) == Some(true))
        {
            return false;
        }
        self.takes_as_given(sides, "the body is flat", finding)
    }

    /// Takes in `I_1 = I_2 = …` where the sentence says that it is so by symmetry; what else the chain says is a claim.
    pub(crate) fn are_equal_by_symmetry(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [one, other, rest @ ..] = sides else {
            return false;
        };
        if !has_any(&lowered(&self.sentence), SYMMETRY) {
            return false;
        }
        let inertia = self.theory.atoms.quantity(Quantity::Inertia);
        let moments = [one, other].map(|side| {
            let value = self.lowering(Frame::Moving).scalar(side)?;
            let moment = value.as_variable()?;
            let own = self.theory.atoms.entity_of(moment) == Some(inertia);
            own.then(|| self.theory.normal(&value))
        });
        let [Some(one), Some(other)] = moments else {
            return false;
        };
        let free = one.as_variable().is_some() || other.as_variable().is_some();
        let all = [0, 1, 2].map(|c| self.theory.atoms.value(inertia, c, 0));
        let [x, y, z] = all.map(|moment| self.theory.normal(&moment));
        // A body that is alike about two axes is not so about others too.
        if x == y || y == z || z == x || !free {
            return false;
        }
        let taken = self.takes_as_given(&sides[..2], "by symmetry", finding);
        if taken && !rest.is_empty() {
            finding.role = Role::Claim;
            finding.verdict = Verdict::Undecided;
            self.claim(&sides[1..], finding);
        }
        taken
    }

    fn takes_as_given(&mut self, sides: &[Node], remark: &str, finding: &mut Finding) -> bool {
        let mut taken = finding.clone();
        taken.role = Role::Given;
        self.accept(sides, Role::Given, &mut taken);
        let accepted = taken.verdict == Verdict::Accepted;
        if accepted {
            taken.remarks.push(remark.to_owned());
            *finding = taken;
        }
        accepted
    }
}
