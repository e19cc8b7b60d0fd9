//! Rates of angles that words give to the free motion of a symmetric body: "it precesses about ⟨h⟩ at the rate ⟨\dot\varphi⟩
//! and spins about its own axis at ⟨\dot\psi⟩".
//!
//! With the axis of the precession along L, φ̇ = |L|/I_t, and the spin is what the axial rate has beside the part of the
//! precession along the axis, ψ̇ = ω_a − φ̇ cos θ = ω_a − L_a/I_t (Landau and Lifshitz, Mechanics, section 33).

use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::undotted;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::Finding;
use crate::verify::words::book::{has_any, lowered};

const NAME: &str = "rate of the spin beside that of the precession";

/// Words right before a rate.
const AT: &[&str] = &[
    " at",
    " at the rate",
    " at a rate",
    " with the rate",
    " at the angular rate",
    " at the constant rate",
    " with the angular velocity",
];
const SPINS: &[&str] = &[
    "spins about",
    "rotates about",
    "turns about",
    "spins around",
];
const OWN_AXIS: &[&str] = &[
    "its own axis",
    "its axis",
    "its symmetry axis",
    "its axis of symmetry",
    "the axis of symmetry",
    "the symmetry axis",
    "its figure axis",
];

/// Whether words have a body spin about its own axis.
pub(crate) fn spins_about_own_axis(words: &str) -> bool {
    has_any(words, SPINS) && has_any(words, OWN_AXIS)
}

impl Checker<'_> {
    /// Takes a rate that the words before it call one of these.
    pub(crate) fn rate_of_free_motion(&mut self, node: &Node) {
        let Kind::TimeDerivative {
            operand, order: 1, ..
        } = &node.kind
        else {
            return;
        };
        let words = lowered(&self.sentence);
        let clause = words.rsplit('.').next().unwrap_or_default().trim_end();
        if !AT.iter().any(|end| clause.ends_with(end)) || self.new_symbol(operand).is_none() {
            return;
        }
        let behind = clause.rsplit('⟩').next().unwrap_or_default();
        let precesses = clause.rsplit_once("precess").map(|(_, behind)| behind);
        let beside = precesses.is_some_and(|behind| behind.matches('⟩').count() <= 1);
        if spins_about_own_axis(behind) {
            if precesses.is_some() && self.goes_round_momentum_in(clause) {
                self.take_spin(node);
            }
        } else if beside && self.goes_round_momentum_in(clause) {
            self.take_rate_round_momentum(node);
        }
    }

    /// Decides a line that gives such a spin behind words for it, "while it spins about its own axis at ⟨\dot\psi = …⟩".
    pub(crate) fn spins_beside(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let Some(rate) = sides.first() else {
            return false;
        };
        let new = self.new_symbol(undotted(rate)).is_some();
        let before = self.theory.premises().len();
        if new {
            self.take_spin(rate);
        }
        let taken = self.theory.premises().len() > before;
        if taken {
            self.now_known([rate]);
            self.claim(sides, finding);
        }
        taken
    }

    fn take_spin(&mut self, rate: &Node) {
        let Some((_, moment)) = self.momentum_and_moment() else {
            return;
        };
        let (Some([axial, ..]), Some(rate)) = (
            self.theory.symmetry(),
            self.lowering(Frame::Moving).scalar(rate),
        ) else {
            return;
        };
        let [turns, carries] = [Quantity::AngularVelocity, Quantity::Momentum].map(|quantity| {
            let entity = self.theory.atoms.quantity(quantity);
            self.theory.atoms.value(entity, axial as u8, 0)
        });
        let taken = self.theory.assume(Premise {
            name: NAME.to_owned(),
            residuals: vec![rate.clone() - turns + carries / moment],
            preferred: rate.variables(),
            definition: true,
        });
        if taken == Taken::Solved {
            self.keep(NAME, true);
        }
    }
}
