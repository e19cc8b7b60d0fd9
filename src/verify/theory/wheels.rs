//! Wheels that a line brings in: the momentum of body and wheels, `H = Iω + J_w Ω`, in symbols of the document.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::{Owner, variable_fraction};
use crate::verify::values::quantity::Quantity;
use crate::verify::values::symbol::Meaning;
use crate::verify::verdict::{Finding, Role, Verdict};
use num_traits::Zero;

impl Checker<'_> {
    /// In a document about wheels, a momentum that is Iω and more by symbols of the document has that more in the wheels.
    pub(crate) fn brings_wheels(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, _] = sides else { return false };
        if self.theory.setting.gyrostat || !self.reading.speaks_of_wheels {
            return false;
        }
        let Kind::Symbol(symbol) = &inner(left).kind else {
            return false;
        };
        let momentum = self.theory.atoms.quantity(Quantity::Momentum);
        if self.meaning_of(symbol) != Meaning::Whole(momentum) {
            return false;
        }
        let Ok(read) = self.read(sides, Frame::Moving) else {
            return false;
        };
        let rests: Vec<_> = read.residuals().cloned().collect();
        let rests: Vec<_> = rests.iter().map(|rest| self.theory.normal(rest)).collect();
        let own = |v: u32| matches!(self.theory.atoms.owner(v), Some(Owner::Symbol(_)));
        let foreign = rests.iter().filter(|rest| !rest.is_zero()).all(|rest| {
            let variables = rest.variables();
            !variables.is_empty() && variables.into_iter().all(own)
        });
        let brings = foreign && rests.len() == 3 && rests.iter().any(|rest| !rest.is_zero());
        brings && self.take_wheels(rests, sides, finding)
    }

    /// Gives the wheels the momentum that is missing beside Iω: what Iω less the right side has, but for the sign.
    fn take_wheels(&mut self, rests: Vec<Fraction>, sides: &[Node], finding: &mut Finding) -> bool {
        self.theory.set(|setting| setting.gyrostat = true);
        let wheels = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let parts: Vec<Variable> = (0..3)
            .map(|component| self.theory.atoms.part(wheels, component, 0))
            .collect();
        let stored = parts.iter().zip(rests);
        let name = self.line_name(finding);
        let taken = self.theory.assume(Premise {
            name: name.clone(),
            residuals: stored
                .map(|(&v, rest)| variable_fraction(v) + rest)
                .collect(),
            preferred: parts,
            definition: true,
        });
        if taken != Taken::Solved {
            return false;
        }
        self.keep(&name, true);
        self.now_known(sides);
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Given;
        let said = "taken as given: what is beside Iω is in the wheels";
        finding.remarks.push(said.to_owned());
        true
    }
}
