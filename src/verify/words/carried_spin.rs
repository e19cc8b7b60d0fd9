//! What is known of a rotor that keeps its spin while its axle is carried round.

use crate::algebra::{Fraction, Variable};
use crate::notation::ast::{Kind, Node};
use crate::verify::check::Checker;
use crate::verify::letters::carried_spin::vector_of_spin;
use crate::verify::letters::frame::Frame;
use crate::verify::letters::usage::inner;
use crate::verify::lines::line::Read;
use crate::verify::theory::{Premise, Taken};
use crate::verify::values::atoms::Entity;
use crate::verify::values::quantity::Quantity;
use crate::verify::verdict::{Finding, Role, Verdict};

/// The name of a premise.
const NAME: &str =
    "the spin keeps its size and lies across the velocity that it is carried round at";
/// The name of another.
const OF_SPIN: &str = "the momentum of the rotor is that of its spin";

impl Checker<'_> {
    /// Takes in where the spin, its momentum and the velocity of the axle lie on the axes used, and that the spin lasts.
    pub(crate) fn carries_a_spin(&mut self) {
        let Some(carried) = self.reading.carried_spin.clone() else {
            return;
        };
        let momentum = self.theory.atoms.quantity(Quantity::RelativeMomentum);
        let turn = self.theory.atoms.quantity(Quantity::FrameRate);
        let spin = vector_of_spin(&mut self.theory.atoms);
        self.known.extend([momentum, turn, spin]);
        let across = |entity: Entity, along: u8| {
            (0..3)
                .filter(move |&c| c != along)
                .map(move |c| (entity, c, 0))
        };
        let nothing = across(momentum, 0)
            .chain(across(spin, 0))
            .chain(across(turn, 2));
        let nothing = nothing.chain([(momentum, 0, 1)]);
        for (entity, component, order) in nothing.collect::<Vec<_>>() {
            let value: Fraction = self.theory.atoms.value(entity, component, order);
            let preferred: Vec<Variable> = value.as_variable().into_iter().collect();
            self.theory.assume(Premise {
                name: NAME.to_owned(),
                residuals: vec![value],
                preferred,
                definition: true,
            });
        }
        let law = self.read(&carried.law, Frame::Moving);
        let residuals = law.iter().flat_map(Read::residuals).cloned();
        let residuals: Vec<Fraction> = residuals.collect();
        let first = self.theory.atoms.part(momentum, 0, 0);
        self.theory.assume(Premise {
            name: OF_SPIN.to_owned(),
            residuals,
            preferred: vec![first],
            definition: true,
        });
    }

    /// Takes in what turns the axle, `\tau = mgd`, as long as nothing says how fast it is carried round.
    pub(crate) fn loads_the_axle(&mut self, sides: &[Node], finding: &mut Finding) -> bool {
        let [left, right, rest @ ..] = sides else {
            return false;
        };
        let alone = matches!(inner(left).kind, Kind::Symbol(_));
        if self.reading.carried_spin.is_none() || !alone {
            return false;
        }
        let [moment, turn, momentum] = [
            Quantity::Moment,
            Quantity::FrameRate,
            Quantity::RelativeMomentum,
        ]
        .map(|quantity| self.theory.atoms.quantity(quantity));
        let spin = vector_of_spin(&mut self.theory.atoms);
        let speed = self.theory.atoms.part(turn, 2, 0);
        let met = self.entities([right]);
        let of_spin = [moment, turn, momentum, spin];
        if self.entities([left]) != [moment]
            || self.theory.rule(speed).is_some()
            || met.is_empty()
            || met.iter().any(|entity| of_spin.contains(entity))
        {
            return false;
        }
        let Ok(read) = self.read(&sides[..2], Frame::Moving) else {
            return false;
        };
        let name = self.line_name(finding);
        // It tells how fast the axle is carried round.
        let taken = self.theory.assume(Premise {
            name: name.clone(),
            residuals: read.residuals().cloned().collect(),
            preferred: vec![speed],
            definition: true,
        });
        if taken != Taken::Solved {
            self.theory.retain(|premise| premise.name != name);
            return false;
        }
        self.keep(&name, true);
        self.now_known(&sides[..2]);
        finding.verdict = Verdict::Accepted;
        finding.role = Role::Given;
        if !rest.is_empty() {
            finding.verdict = Verdict::Undecided;
            finding.role = Role::Claim;
            self.claim(&sides[1..], finding);
        }
        true
    }
}
