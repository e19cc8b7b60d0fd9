//! Letters of oscillations and of matrices that are told by an equation: periods, frequencies and eigenvalues.

use crate::algebra::Fraction;
use crate::mechanics;
use crate::verify::language::statement::{Declaration, Formula, NounPhrase, Slot, Term};
use crate::verify::model::atoms::whole;
use crate::verify::model::system::{FrameId, Matrix};
use crate::verify::reading::builder::Builder;
use crate::verify::reading::letters_read::formulas;
use crate::verify::reading::small_oscillations::small_oscillation;
use crate::verify::term::letters::Meaning;
use crate::verify::term::quantity::Quantity;
use crate::verify::term::value::Value;
use num_traits::Zero;

/// The noun of how long an oscillation takes.
pub(super) const PERIOD: &str = "period";
/// The noun of how often it comes in a unit of time.
pub(super) const FREQUENCY: &str = "frequency";
/// The noun of its frequency times 2π.
pub(super) const ANGULAR_FREQUENCY: &str = "angular frequency";
/// The noun of a root of det(A − λ 1) = 0.
pub(super) const EIGENVALUE: &str = "eigenvalue";

impl Builder<'_> {
    /// "`$T$` is the period of `$x$`": ẍ + (2π/T)² x = 0, as of every harmonic oscillation.
    pub(super) fn read_oscillation(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        // The equations of motion tell it, once they are known.
        if small_oscillation(what).is_some() {
            return Some(());
        }
        if self.frame_of_period(what).is_some() {
            return Some(());
        }
        let ([(Slot::Of, of)], []) = (what.slots.as_slice(), what.adjectives.as_slice()) else {
            return None;
        };
        let of = self.operand(of, declaration)?;
        let x = self.system().value_of(&of).ok()?.to_scalar().ok()?;
        let own = self.constant_of(letter, declaration)?;
        let atoms = &mut self.system().atoms;
        atoms.set_positive(&own);
        own.as_variable()
            .into_iter()
            .for_each(|v| atoms.set_length(v));
        let rate = atoms.derivative(&x);
        let acceleration = atoms.derivative(&rate);
        let turn = atoms.pi() * whole(2);
        let (own, turn) = (own.clone() * own, turn.clone() * turn);
        self.hold(
            match what.head {
                PERIOD => acceleration * own + x * turn,
                FREQUENCY => acceleration + x * turn * own,
                _ => acceleration + x * own,
            },
            declaration,
        );
        Some(())
    }

    /// What turns, and against what, in "the period of A relative to N".
    pub(super) fn frame_of_period(&self, what: &NounPhrase) -> Option<(FrameId, FrameId)> {
        let (of, relative) = match what.slots.as_slice() {
            [(Slot::Of, of)] => (of, self.reading.system.ground),
            [(Slot::Of, of), (Slot::RelativeTo, relative)] => (of, self.frame(relative)?),
            _ => return None,
        };
        let plain = what.head == PERIOD && what.adjectives.is_empty();
        Some((self.frame(of).filter(|_| plain)?, relative))
    }

    /// "`$T$` is the period of A relative to N": T |ω| = 2π, where ω is constant by all that is told.
    pub(super) fn hold_period_of_turn(
        &mut self,
        subjects: &[Term],
        (of, relative): (FrameId, FrameId),
        declaration: &Declaration,
    ) -> Option<()> {
        let [Term::Formula(letter)] = subjects else {
            return None;
        };
        let omega = self.system().angular_velocity(of, relative);
        let mut facts = self.facts_so_far();
        let atoms = &mut self.reading.system.atoms;
        let squared = facts.normal(atoms, &omega.dot(&omega)).ok()?;
        let change = atoms.derivative(&squared);
        if squared.is_zero() || !facts.normal(atoms, &change).ok()?.is_zero() {
            return None;
        }
        let atoms = &mut self.system().atoms;
        let (root, turn) = (atoms.root(&squared)?, atoms.pi() * whole(2));
        let known = Quantity::ByRule(Value::scalar(turn / root));
        self.denote(letter, Meaning::Quantity(known), declaration);
        Some(())
    }

    /// "`$\lambda$` is an eigenvalue of `$A$`": det(A − λ 1) = 0.
    pub(super) fn read_eigenvalue(
        &mut self,
        subjects: &[Term],
        what: &NounPhrase,
        declaration: &Declaration,
    ) -> Option<()> {
        let of = self.operand(what.slot(Slot::Of)?, declaration)?;
        let matrix = self.system().value_of(&of).ok()?.to_matrix().ok()?;
        for letter in formulas(subjects) {
            let own = self.constant_of(letter, declaration)?;
            let less = matrix.clone() - Matrix::from_diagonal_element(own);
            self.hold(mechanics::determinant(&less), declaration);
        }
        Some(())
    }

    /// The variable of a letter that is a constant number.
    fn constant_of(&mut self, letter: &Formula, declaration: &Declaration) -> Option<Fraction> {
        let number = self.denote_number(letter, declaration);
        self.system().value_of(&number).ok()?.to_scalar().ok()
    }
}
